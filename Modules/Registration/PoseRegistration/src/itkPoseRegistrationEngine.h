/*=========================================================================
 *
 *  Copyright The DentalSCR authors
 *
 *  Licensed under the Apache License, Version 2.0 (the "License");
 *  you may not use this file except in compliance with the License.
 *  You may obtain a copy of the License at
 *
 *         https://www.apache.org/licenses/LICENSE-2.0
 *
 *  Unless required by applicable law or agreed to in writing, software
 *  distributed under the License is distributed on an "AS IS" BASIS,
 *  WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
 *  See the License for the specific language governing permissions and
 *  limitations under the License.
 *
 *=========================================================================*/
#ifndef itkPoseRegistrationEngine_h
#define itkPoseRegistrationEngine_h

#include "itkLandmarkPoseMetricv4.h"
#include "itkPoseGroupRegistration.h"
#include "itkPoseHypothesis.h"
#include "itkPoseProblem.h"

#include "itkSilhouettePoseMetricv4.h"
#include "itkToothOutlinePoseMetricv4.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace itk
{
/** Answers a PoseProblem: makes the metric of each group of jaws, registers it, tries the hypotheses. What
 * PoseRegistrationMethod runs. */
class PoseRegistrationEngine
{
public:
  using MetricType = LeastSquaresSumMetricv4;
  /** Told the metric of a group before it is registered. */
  using GroupObserverType = std::function<void(unsigned int group, unsigned int numberOfGroups, MetricType * metric)>;
  using StageObserverType = std::function<void(unsigned int group, PoseStageEnum stage)>;
  /** Told before each hypothesis, and after the last, which share of a group's hypotheses is done. */
  using HypothesisObserverType = std::function<void(unsigned int group, double share)>;

  PoseGroupRegistration::PartsType              parts;
  PoseGroupRegistration::OptimizerType::Pointer optimizer;
  PoseStart::ConstPointer                       start;
  std::vector<PoseHypothesis::ConstPointer>     hypotheses;
  PoseIterationMonitor *                        monitor{ nullptr };
  GroupObserverType                             groupObserver;
  StageObserverType                             stageObserver;
  HypothesisObserverType                        hypothesisObserver;

  /** A group that was registered: what a hypothesis is tried beside. */
  struct GroupType
  {
    /** Of this group alone, with the geometry that it was registered with; surfaces are the caller's. */
    PoseProblem problem;
    /** At the solution. */
    MetricType::Pointer      metric;
    MetricType::PositionType solution;
    unsigned int             index{ 0 };
  };

  /** Throws PoseGeometryError for a geometry that cannot be.
   * \param groups where not null, takes what TryHypothesis() needs of each group that was registered. */
  PoseRegistrationResult
  Run(const PoseProblem & problem, std::vector<GroupType> * groups = nullptr) const;

  /** Runs one hypothesis beside a group, whatever it is worth; to be asked only where nothing stands against it
   * (PoseHypothesis::GetObstacle()). Nothing on abort. */
  std::optional<PoseHypothesisOutcome>
  TryHypothesis(const GroupType & group, const PoseHypothesis & hypothesis) const;

  /** Why no hypothesis is tried beside the problem of a group, as a sentence; empty where they are. */
  static std::string
  GetObstacle(const PoseProblem & problem);

private:
  /** A jaw with its terms: of its tracing, of its outlines of whole teeth, of its landmarks; null where there is
   * nothing to match. */
  struct JawType
  {
    /** Its terms of a further view. */
    struct ViewType
    {
      SilhouettePoseMetricv4::Pointer   silhouette;
      ToothOutlinePoseMetricv4::Pointer outlines;
      LandmarkPoseMetricv4::Pointer     landmarks;
      /** Outlines of it that are not used, with the reason. */
      std::vector<std::string> unusedOutlines;
      /** Why its tracing on that view cannot be used. */
      std::string failure;

      bool
      HasEvidence() const
      {
        return silhouette.IsNotNull() || outlines.IsNotNull() || landmarks.IsNotNull();
      }
    };

    std::shared_ptr<const TriangleSurface> surface;
    /** In the dental frame, as the surface is. */
    ToothCrownSet::Pointer            crowns;
    SilhouettePoseMetricv4::Pointer   metric;
    ToothOutlinePoseMetricv4::Pointer outlines;
    LandmarkPoseMetricv4::Pointer     landmarks;
    /** One a view of the problem. */
    std::vector<ViewType> views;

    /** On the first view: what a start is searched with. */
    bool
    HasEvidence() const
    {
      return metric.IsNotNull() || outlines.IsNotNull() || landmarks.IsNotNull();
    }
    bool
    HasEvidenceOfAView() const
    {
      return std::any_of(views.begin(), views.end(), [](const ViewType & view) { return view.HasEvidence(); });
    }
  };

  std::vector<JawType>
  PrepareJaws(const PoseProblem & problem, const PoseGeometry & geometry, PoseRegistrationResult & result) const;
  void
  PrepareViews(const PoseProblem & problem, std::size_t jaw, JawType & prepared) const;
  /** The terms of the views, and what is known of where the head was. */
  static void
  AddViews(const PoseProblem &              problem,
           const std::vector<JawType> &     jaws,
           const std::vector<std::size_t> & members,
           MetricType &                     sum);
  /** PoseHypothesisOutcome::headMove of a question's solution: of the views whose head may be moved in the question and
   * stood still in the problem. */
  static double
  ComputeHeadMove(const PoseProblem & problem, const PoseProblem & question, const PoseGroupResult & group);
  void
  DescribeViews(const PoseProblem & problem, const std::vector<JawType> & jaws, PoseRegistrationResult & result) const;
  MetricType::Pointer
  MakeMetric(const PoseProblem &              problem,
             const PoseGeometry &             geometry,
             const std::vector<JawType> &     jaws,
             const std::vector<std::size_t> & members) const;
  void
  TryHypotheses(const GroupType & group, PoseGroupResult & result) const;
};
} // namespace itk

#endif

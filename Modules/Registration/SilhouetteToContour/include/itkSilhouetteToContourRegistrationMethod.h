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
#ifndef itkSilhouetteToContourRegistrationMethod_h
#define itkSilhouetteToContourRegistrationMethod_h

#include "SilhouetteToContourExport.h"
#include "itkContourRegistrationMethodBase.h"
#include "itkContourToContourMetricv4.h"
#include "itkSilhouetteToContourLevel.h"

#include "itkObjectToObjectOptimizerBase.h"

#include <vector>

namespace itk
{
/** \class SilhouetteToContourRegistrationMethod
 * \brief Aligns a projected silhouette with a traced contour by a 2-D similarity, coarse to fine.
 *
 * The paper's section "Silhouette-to-Contour Registration". Inputs: the fixed contour (tracing, pixels of the
 * radiograph) and the moving contour (silhouette, q = (f m x / sp_u, -m z / sp_v), pixels). Output: the similarity that
 * maps moving to fixed, p = s R(theta) q + t, as a decorated Similarity2DTransform with centre 0.
 *
 * Start: theta = 0, s the ratio of the diagonals of the two bounding boxes, t such that the centroids (weighted means
 * of the points) agree; or the initial transform. Then the levels: each explores a grid of candidates within its bounds
 * around the current estimate (where it has one), runs the optimizer from the best of them, and hands on the best
 * position that was evaluated. The first level of the paper's schedule explores, the others refine.
 *
 * Metric: ContourChamferMetricv4 (symmetric, point to point) unless set. Optimizer: LBFGSBOptimizerv4 unless set; any
 * v4 optimizer serves. The method sets on it: the metric; on LBFGSB the bounds and the initial position; on Amoeba with
 * automatic simplex a simplex of a quarter of the bounds; on OnePlusOneEvolutionary a generator seeded with RandomSeed;
 * on Exhaustive without scales those that make its grid of +-NumberOfSteps * StepLength = +-1 reach the bounds; the
 * number of iterations where the level gives one. Other optimizers are kept within the bounds by the metric. What ITK's
 * own optimizers do is deterministic, hence so is this, for any number of threads; methods may run at the same time in
 * several threads (those with LBFGSB, which is not reentrant, take turns within a level).
 *
 * Events: StartEvent, MultiResolutionIterationEvent at the start of each level, IterationEvent at each iteration of the
 * optimizer (each evaluation of Amoeba, which has no other event), ProgressEvent, EndEvent. The getters of
 * RegistrationIterationInformation are valid inside them. AbortGenerateDataOn() in an observer ends the run at the next
 * evaluation that the optimizer reports, with AbortEvent and the exception ProcessAborted.
 *
 * Errors (ExceptionObject): a contour missing, or with fewer than two distinct points of positive weight.
 *
 * \ingroup SilhouetteToContour
 */
class SilhouetteToContour_EXPORT SilhouetteToContourRegistrationMethod : public ContourRegistrationMethodBase
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(SilhouetteToContourRegistrationMethod);

  using Self = SilhouetteToContourRegistrationMethod;
  using Superclass = ContourRegistrationMethodBase;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(SilhouetteToContourRegistrationMethod, ContourRegistrationMethodBase);

  using MetricType = ContourToContourMetricv4;
  using OptimizerType = ObjectToObjectOptimizerBaseTemplate<double>;
  using LevelType = SilhouetteToContourLevel;
  using LevelResultType = SilhouetteToContourLevelResult;

  /** The figure of merit; nullptr: the paper's. Its contours, transform, pivot and bounds are set by this method. */
  virtual void
  SetMetric(MetricType * metric);
  itkGetModifiableObjectMacro(Metric, MetricType);

  /** Any v4 optimizer; nullptr: LBFGSB. */
  virtual void
  SetOptimizer(OptimizerType * optimizer);
  itkGetModifiableObjectMacro(Optimizer, OptimizerType);

  /** Number of levels, 3 by default; 0 gives the start itself. Existing levels are kept; a level that is added has half
   * the bounds of the one before and neither explores nor has several starts. */
  void
  SetNumberOfLevels(unsigned int numberOfLevels);
  unsigned int
  GetNumberOfLevels() const
  {
    return static_cast<unsigned int>(m_Levels.size());
  }

  /** Bounds and effort of a level. Throws where there is no such level or a value makes no sense. */
  void
  SetLevel(unsigned int index, const LevelType & level);
  const LevelType &
  GetLevel(unsigned int index) const;

  /** mm per pixel of the fixed contour (mean of u and v), 0.25 by default: turns the bounds on the shift into pixels.
   */
  virtual void
  SetPixelSpacing(double spacing);
  itkGetConstMacro(PixelSpacing, double);

  /** Hold a part of the start's similarity. A held translation is t itself, so that rotation and scale then act about
   * q = 0. */
  itkSetMacro(FixScale, bool);
  itkGetConstMacro(FixScale, bool);
  itkBooleanMacro(FixScale);
  itkSetMacro(FixRotation, bool);
  itkGetConstMacro(FixRotation, bool);
  itkBooleanMacro(FixRotation);
  itkSetMacro(FixTranslation, bool);
  itkGetConstMacro(FixTranslation, bool);
  itkBooleanMacro(FixTranslation);

  /** Seed of the generator that OnePlusOneEvolutionary is given at each run; the other optimizers draw nothing. */
  itkSetMacro(RandomSeed, uint64_t);
  itkGetConstMacro(RandomSeed, uint64_t);

  /** The paper's three stages (default): scale 35/10/3 %, rotation 20/6/2 degrees, shift 15/3.75/1 mm (60/15/4 px of
   * 0.25 mm); the coarse level explores. */
  void
  SetPresetToPaper();
  /** No level: bounding box and centroid start only. */
  void
  SetPresetToBoundingBox();
  /** One level with the broad bounds and 80 iterations, no exploration: the paper's "w/o coarse-to-fine". */
  void
  SetPresetToSingleStage();
  /** For a start that is far off: scale 50 %, rotation 45 degrees, shift 15 mm; the first level ranks candidates all
   * over these bounds on the field of distances and refines the best, a second finishes the winner. */
  void
  SetPresetToGlobal();

  /** Level by level, after Update(); the levels that were completed after an abort. */
  const std::vector<LevelResultType> &
  GetLevelResults() const
  {
    return m_LevelResults;
  }

  // RegistrationIterationInformation
  /** Which start of the level. */
  unsigned int
  GetCurrentCandidate() const override
  {
    return m_CurrentCandidate;
  }
  /** From the position that was reported before, pixels (root mean square over the moving points). */
  double
  GetStepLength() const override
  {
    return m_StepLength;
  }

  /** Counts the metric's and the optimizer's settings, but not what a run does to them. */
  ModifiedTimeType
  GetMTime() const override;

protected:
  SilhouetteToContourRegistrationMethod();
  ~SilhouetteToContourRegistrationMethod() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;
  void
  GenerateData() override;

private:
  class RunType;

  MetricType::Pointer          m_Metric;
  OptimizerType::Pointer       m_Optimizer;
  std::vector<LevelType>       m_Levels;
  double                       m_PixelSpacing{ 0.25 };
  uint64_t                     m_RandomSeed{ 0 };
  bool                         m_FixScale{ false };
  bool                         m_FixRotation{ false };
  bool                         m_FixTranslation{ false };
  std::vector<LevelResultType> m_LevelResults;
  unsigned int                 m_CurrentCandidate{ 0 };
  double                       m_StepLength{ 0.0 };
  ModifiedTimeType             m_MetricMTimeAfterRun{ 0 };
  ModifiedTimeType             m_OptimizerMTimeAfterRun{ 0 };
};
} // namespace itk

#endif

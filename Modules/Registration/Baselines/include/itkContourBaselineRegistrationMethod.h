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
#ifndef itkContourBaselineRegistrationMethod_h
#define itkContourBaselineRegistrationMethod_h

#include "BaselinesExport.h"
#include "itkContourRegistrationMethodBase.h"

#include <vector>

namespace itk
{
/** \class ContourBaselineEnums
 * \brief What the baselines may estimate.
 * \ingroup Baselines
 */
class ContourBaselineEnums
{
public:
  /** Rigid keeps the start's scale. */
  enum class Motion : std::uint8_t
  {
    Rigid,
    Similarity
  };
};

/** \class ContourBaselineRegistrationMethod
 * \brief Base of the methods that the silhouette-to-contour registration is compared with.
 *
 * Inputs, output, events and abort are those of SilhouetteToContourRegistrationMethod, with which it shares the base,
 * so that one replaces the other. Points of weight 0 are ignored.
 *
 * Start without an initial transform: Similarity takes the bounding boxes and centroids, as our method does; Rigid
 * takes the scale 1, which is what the calibrated geometry predicts, and the centroids.
 *
 * Events: StartEvent, MultiResolutionIterationEvent where a level starts, IterationEvent, ProgressEvent, EndEvent.
 * AbortGenerateDataOn() in an observer ends the run with ProcessAborted. Everything is deterministic.
 *
 * Errors (ExceptionObject): a contour missing, or with fewer than two distinct points of positive weight.
 *
 * \ingroup Baselines
 */
class Baselines_EXPORT ContourBaselineRegistrationMethod : public ContourRegistrationMethodBase
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ContourBaselineRegistrationMethod);

  using Self = ContourBaselineRegistrationMethod;
  using Superclass = ContourRegistrationMethodBase;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkTypeMacro(ContourBaselineRegistrationMethod, ContourRegistrationMethodBase);

  using MotionEnum = ContourBaselineEnums::Motion;

  /** Default Similarity. */
  itkSetEnumMacro(Motion, MotionEnum);
  itkGetEnumMacro(Motion, MotionEnum);

protected:
  /** The points that count, x0 y0 x1 y1 ..., and their weights. */
  struct PointsType
  {
    std::vector<double> points;              /**< Pixels. */
    std::vector<double> weights;             /**< One a point, more than 0. */
    double              sumOfWeights{ 0.0 }; /**< What means are divided by. */
    /** Number of points. */
    std::size_t
    size() const
    {
      return weights.size();
    }
  };

  ContourBaselineRegistrationMethod() = default;
  ~ContourBaselineRegistrationMethod() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;
  /** The base's, but for a rigid motion. */
  ContourSimilarity
  FindStart() const override;
  void
  GenerateData() override;
  /** Points of a weight above 0. */
  static PointsType
  MakePoints(const ContourType & contour);

  /** From the start to the result. */
  virtual ContourSimilarity
  RegisterContours(const PointsType & fixed, const PointsType & moving, const ContourSimilarity & start) = 0;

  /** For what observers see; throws ProcessAborted where one of them asked for it. */
  void
  StartLevel(unsigned int level, const ContourSimilarity & similarity);
  void
  ReportIteration(std::size_t iteration, double value, const ContourSimilarity & similarity, float progress);

  /** Reports a step of a method that ends where no point moves by more than the tolerance, or with the maximum of
   * iterations. \return whether it ends, for which the stop condition is set. */
  bool
  EndStep(unsigned int              iteration,
          unsigned int              maximum,
          double                    tolerance,
          double                    value,
          double                    moved,
          const ContourSimilarity & similarity);

  /** The weighted least-squares similarity from one list of points to the other (Umeyama 1991; in the plane a division
   * of complex numbers). Rigid keeps the scale that is passed. */
  static ContourSimilarity
  FitSimilarity(const std::vector<double> & from,
                const std::vector<double> & to,
                const std::vector<double> & weights,
                MotionEnum                  motion,
                double                      scale);

  /** Largest distance between where two similarities take the corners of the points' bounding box. */
  static double
  LargestShift(const PointsType & points, const ContourSimilarity & a, const ContourSimilarity & b);

private:
  MotionEnum m_Motion{ MotionEnum::Similarity };
};

Baselines_EXPORT std::ostream &
                 operator<<(std::ostream & os, ContourBaselineEnums::Motion motion);
} // namespace itk

#endif

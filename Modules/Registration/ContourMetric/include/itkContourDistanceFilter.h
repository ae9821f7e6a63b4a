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
#ifndef itkContourDistanceFilter_h
#define itkContourDistanceFilter_h

#include "ContourMetricExport.h"
#include "itkContourMetricEnums.h"
#include "itkDentalContour.h"

#include "itkDataObjectDecorator.h"
#include "itkProcessObject.h"
#include "itkSimilarity2DTransform.h"
#include "itkSimpleDataObjectDecorator.h"

#include <vector>

namespace itk
{
/** \class ContourDistanceFilter
 * \brief The paper's contour figures for two contours: directed means, averaged Chamfer, Hausdorff; pixels.
 *
 * Inputs: the fixed contour (tracing, C_CR), the moving contour (silhouette, C_3D), and optionally the transform that
 * maps the moving contour into the fixed one's frame, as SilhouetteToContourRegistrationMethod puts it out; without it
 * the contours share a frame already. Definitions as in the paper's section "Evaluation metrics":
 *
 *  - MovingToFixedMean, FixedToMovingMean: mean over one contour's points of the distance to the other;
 *  - Chamfer: the average of the two means (the metric's value is their sum);
 *  - MovingToFixedHausdorff, FixedToMovingHausdorff: the largest such distance; Hausdorff: the larger of the two.
 *
 * Distances are to points as in the paper, or to segments. Means are weighted by the points' weights; points of weight
 * 0 are ignored throughout. Results are decorated outputs (usable as inputs of other filters), the per-point distances
 * plain vectors in the order of the points, NaN for ignored ones, and summed up by the fixed contour's teeth.
 *
 * \ingroup ContourMetric
 */
class ContourMetric_EXPORT ContourDistanceFilter : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ContourDistanceFilter);

  using Self = ContourDistanceFilter;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(ContourDistanceFilter, ProcessObject);

  using ContourType = DentalContour;
  using TransformType = Similarity2DTransform<double>;
  using DistanceEnum = ContourMetricEnums::Distance;
  using RealObjectType = SimpleDataObjectDecorator<double>;
  /** The tracing and the silhouette, continuous pixel indices. Both must be set. */
  itkSetInputMacro(FixedContour, ContourType);
  itkGetInputMacro(FixedContour, ContourType);
  itkSetInputMacro(MovingContour, ContourType);
  itkGetInputMacro(MovingContour, ContourType);

  /** Optional: maps the moving contour into the fixed one's frame. SetTransformInput() takes the decorated output of a
   * registration. */
  itkSetGetDecoratedObjectInputMacro(Transform, TransformType);

  /** PointToPoint (default, the paper) or PointToSegment. */
  itkSetEnumMacro(Distance, DistanceEnum);
  itkGetEnumMacro(Distance, DistanceEnum);
  /** The figures, pixels: directed means, their mean, directed largest distances, the larger of the two. */
  itkGetDecoratedOutputMacro(MovingToFixedMean, double);
  itkGetDecoratedOutputMacro(FixedToMovingMean, double);
  itkGetDecoratedOutputMacro(Chamfer, double);
  itkGetDecoratedOutputMacro(MovingToFixedHausdorff, double);
  itkGetDecoratedOutputMacro(FixedToMovingHausdorff, double);
  itkGetDecoratedOutputMacro(Hausdorff, double);

  /** Distance of every point after Update(), pixels of the fixed frame. */
  const std::vector<double> &
  GetMovingToFixedDistances() const
  {
    return m_MovingToFixedDistances;
  }
  const std::vector<double> &
  GetFixedToMovingDistances() const
  {
    return m_FixedToMovingDistances;
  }

  /** How far the fixed contour's drawing of one tooth lies from the moving contour, pixels: over its points that count,
   * each once whatever its weight. */
  struct ToothDistanceType
  {
    /** Unknown of the points without a code. */
    ToothCode     tooth;
    SizeValueType numberOfPoints{ 0 };
    double        mean{ 0.0 };
    double        rms{ 0.0 };
    double        maximum{ 0.0 };
  };
  /** Of each tooth of the fixed contour, in the order of their first points, after Update(). */
  const std::vector<ToothDistanceType> &
  GetFixedToMovingDistancesByTooth() const
  {
    return m_FixedToMovingDistancesByTooth;
  }

  using DataObjectPointerArraySizeType = Superclass::DataObjectPointerArraySizeType;
  using Superclass::MakeOutput;
  DataObjectPointer
  MakeOutput(const DataObjectIdentifierType & name) override;

protected:
  ContourDistanceFilter();
  ~ContourDistanceFilter() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;
  void
  VerifyPreconditions() ITKv5_CONST override;
  void
  GenerateData() override;
  /** What GenerateData() found. */
  itkSetDecoratedOutputMacro(MovingToFixedMean, double);
  itkSetDecoratedOutputMacro(FixedToMovingMean, double);
  itkSetDecoratedOutputMacro(Chamfer, double);
  itkSetDecoratedOutputMacro(MovingToFixedHausdorff, double);
  itkSetDecoratedOutputMacro(FixedToMovingHausdorff, double);
  itkSetDecoratedOutputMacro(Hausdorff, double);

private:
  DistanceEnum        m_Distance{ DistanceEnum::PointToPoint };
  std::vector<double> m_MovingToFixedDistances;
  std::vector<double> m_FixedToMovingDistances;

  std::vector<ToothDistanceType> m_FixedToMovingDistancesByTooth;
};
} // namespace itk

#endif

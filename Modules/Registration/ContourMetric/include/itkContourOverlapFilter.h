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
#ifndef itkContourOverlapFilter_h
#define itkContourOverlapFilter_h

#include "ContourMetricExport.h"
#include "itkDentalContour.h"

#include "itkDataObjectDecorator.h"
#include "itkProcessObject.h"
#include "itkSimilarity2DTransform.h"
#include "itkSimpleDataObjectDecorator.h"

#include <vector>

namespace itk
{
/** \class ContourOverlapFilter
 * \brief How much of an open tracing and of a contour lies together, and how closely.
 *
 * Inputs: the fixed contour (tracing), the moving contour (outline), and optionally the transform that maps the moving
 * contour into the fixed one's frame, as SilhouetteToContourRegistrationMethod puts it out. Outputs, decorated:
 *
 *  - FixedShare: share of the tracing, by weight, with the outline (not its end) within MaximumDistance;
 *  - MovingShare: share of the outline, by length, with the tracing (no end, no gap) within MaximumDistance;
 *  - RootMeanSquare, LargestDistance: of the tracing's share, px.
 *
 * Distances are to segments. Per-point distances are plain vectors in the order of the points; NaN for points of weight
 * 0, and for points of the outline that lie nearest to an end of the tracing: beyond it nothing was drawn that they
 * could be compared with.
 *
 * Errors (ExceptionObject): a contour missing or without a point of positive weight, a scale or distance that is not
 * positive.
 *
 * \ingroup ContourMetric
 */
class ContourMetric_EXPORT ContourOverlapFilter : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ContourOverlapFilter);

  using Self = ContourOverlapFilter;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(ContourOverlapFilter, ProcessObject);

  using ContourType = DentalContour;
  using TransformType = Similarity2DTransform<double>;
  using RealObjectType = SimpleDataObjectDecorator<double>;
  /** The open tracing and the contour, continuous pixel indices. Both must be set. */
  itkSetInputMacro(FixedContour, ContourType);
  itkGetInputMacro(FixedContour, ContourType);
  itkSetInputMacro(MovingContour, ContourType);
  itkGetInputMacro(MovingContour, ContourType);

  /** Optional. SetTransformInput() takes the decorated output of a registration. */
  itkSetGetDecoratedObjectInputMacro(Transform, TransformType);

  /** What lies farther apart does not lie together, px; 5 by default. */
  itkSetMacro(MaximumDistance, double);
  itkGetConstMacro(MaximumDistance, double);

  /** Ends of two polylines of the tracing that are closer than this are no ends, px; 8 by default. */
  itkSetMacro(GapLength, double);
  itkGetConstMacro(GapLength, double);
  /** Shares of the length that lie together, 0 to 1; of these the distances, pixels. */
  itkGetDecoratedOutputMacro(FixedShare, double);
  itkGetDecoratedOutputMacro(MovingShare, double);
  itkGetDecoratedOutputMacro(RootMeanSquare, double);
  itkGetDecoratedOutputMacro(LargestDistance, double);
  /** One a point of the fixed contour, and one a point of the moving one, pixels. */
  const std::vector<double> &
  GetFixedDistances() const
  {
    return m_FixedDistances;
  }
  const std::vector<double> &
  GetMovingDistances() const
  {
    return m_MovingDistances;
  }

  using DataObjectPointerArraySizeType = Superclass::DataObjectPointerArraySizeType;
  using Superclass::MakeOutput;
  DataObjectPointer
  MakeOutput(const DataObjectIdentifierType & name) override;

protected:
  ContourOverlapFilter();
  ~ContourOverlapFilter() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;
  void
  VerifyPreconditions() ITKv5_CONST override;
  void
  GenerateData() override;
  /** What GenerateData() found. */
  itkSetDecoratedOutputMacro(FixedShare, double);
  itkSetDecoratedOutputMacro(MovingShare, double);
  itkSetDecoratedOutputMacro(RootMeanSquare, double);
  itkSetDecoratedOutputMacro(LargestDistance, double);

private:
  double              m_MaximumDistance{ 5.0 };
  double              m_GapLength{ 8.0 };
  std::vector<double> m_FixedDistances;
  std::vector<double> m_MovingDistances;
};
} // namespace itk

#endif

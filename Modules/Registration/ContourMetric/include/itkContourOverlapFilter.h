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
 * \brief How much of an open tracing and of a contour lies together, how closely, and how noisy the tracing is.
 *
 * The figures of PartialContourMetricv4 in a pipeline. Inputs: the fixed contour (tracing), the moving contour
 * (outline), and optionally the transform that maps the moving contour into the fixed one's frame, as
 * SilhouetteToContourRegistrationMethod puts it out. Outputs, decorated:
 *
 *  - FixedShare: share of the tracing, by weight, with the outline (not its end) within MaximumDistance;
 *  - MovingShare: share of the outline, by length, with the tracing (no end, no gap) within MaximumDistance;
 *  - RootMeanSquare, LargestDistance: of the tracing's share, px;
 *  - SmoothNoise, WhiteNoise: standard deviations of the drift of the tracer's hand and of the points' own errors, px,
 *    by restricted maximum likelihood from the points within MaximumDistance (ContourNoiseModel).
 *
 * Distances are to segments. Points that carry tooth codes are matched with the same tooth or its neighbours unless
 * GateByTooth is off. Per-point distances are plain vectors in the order of the points; NaN for points that are
 * ignored, have no tooth to match, or, of the outline, are censored.
 *
 * Errors (ExceptionObject): a contour missing or without a point of positive weight, a scale that is not positive, a
 * distance or correlation length that is not positive.
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

  /** On by default. */
  itkSetMacro(GateByTooth, bool);
  itkGetConstMacro(GateByTooth, bool);
  itkBooleanMacro(GateByTooth);

  /** Length over which the drift is correlated, px; 12 by default. */
  itkSetMacro(CorrelationLength, double);
  itkGetConstMacro(CorrelationLength, double);

  itkGetDecoratedOutputMacro(FixedShare, double);
  itkGetDecoratedOutputMacro(MovingShare, double);
  itkGetDecoratedOutputMacro(RootMeanSquare, double);
  itkGetDecoratedOutputMacro(LargestDistance, double);
  itkGetDecoratedOutputMacro(SmoothNoise, double);
  itkGetDecoratedOutputMacro(WhiteNoise, double);

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

  itkSetDecoratedOutputMacro(FixedShare, double);
  itkSetDecoratedOutputMacro(MovingShare, double);
  itkSetDecoratedOutputMacro(RootMeanSquare, double);
  itkSetDecoratedOutputMacro(LargestDistance, double);
  itkSetDecoratedOutputMacro(SmoothNoise, double);
  itkSetDecoratedOutputMacro(WhiteNoise, double);

private:
  double              m_MaximumDistance{ 5.0 };
  double              m_GapLength{ 8.0 };
  bool                m_GateByTooth{ true };
  double              m_CorrelationLength{ 12.0 };
  std::vector<double> m_FixedDistances;
  std::vector<double> m_MovingDistances;
};
} // namespace itk

#endif

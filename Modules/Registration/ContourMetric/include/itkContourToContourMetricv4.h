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
#ifndef itkContourToContourMetricv4_h
#define itkContourToContourMetricv4_h

#include "ContourMetricExport.h"
#include "itkContourChamferKernel.h"
#include "itkDentalContour.h"

#include "itkObjectToObjectMetricBase.h"
#include "itkSimilarity2DTransform.h"

#include <array>

namespace itk
{
/** \class ContourToContourMetricv4
 * \brief Base of the metrics between two contours under a 2-D similarity, for stock v4 optimizers.
 *
 * The transform maps the moving contour into the fixed one's frame: p = s R(theta) q + t (pixels). ITK's scales
 * estimators need an image domain that contours have not, and LBFGSB knows no scales at all; therefore the optimizer is
 * given parameters that are balanced here:
 *
 *   x = (L ln(s/s0), L (theta - theta0), u - u0, v - v0),   (u, v) = s R(theta) c + t
 *
 * with the pivot c (default: centroid of the moving points), L the root mean square distance of the moving points from
 * the pivot times s0, and (s0, theta0, u0, v0) the reference: the transform as it stood at Initialize() or
 * SetReference(). One unit moves the contour's points by about one pixel in every parameter, rotation and scale are
 * decorrelated from the shift, and the reference is the origin. GetTransformParameters() and GetOptimizerParameters()
 * convert.
 *
 * Bounds in x, when set, make any optimizer a bounded one: a position beyond them has the value at the nearest position
 * within plus ten times the excess, and an optimizer that adds updates (gradient descent) is held at them. The position
 * of the smallest value since the last ResetBest() is kept, for optimizers that end elsewhere (Exhaustive,
 * OnePlusOneEvolutionary).
 *
 * As all v4 metrics do, GetDerivative() returns MINUS the gradient. A metric is evaluated by one thread at a time.
 *
 * A derived class implements InitializeContours() and ComputeValue().
 *
 * \ingroup ContourMetric
 */
class ContourMetric_EXPORT ContourToContourMetricv4 : public ObjectToObjectMetricBaseTemplate<double>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ContourToContourMetricv4);

  using Self = ContourToContourMetricv4;
  using Superclass = ObjectToObjectMetricBaseTemplate<double>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkTypeMacro(ContourToContourMetricv4, ObjectToObjectMetricBaseTemplate);

  using ContourType = DentalContour;
  using TransformType = Similarity2DTransform<double>;
  using PointType = Point<double, 2>;

  static constexpr unsigned int NumberOfParameters = 4; /**< Scale, angle and two shifts. */

  /** The contour in the radiograph (tracing), pixels. Same as SetFixedObject(). */
  void
  SetFixedContour(const ContourType * contour)
  {
    this->SetFixedObject(contour);
  }
  const ContourType *
  GetFixedContour() const
  {
    return dynamic_cast<const ContourType *>(this->GetFixedObject());
  }

  /** The contour that is moved (silhouette). Same as SetMovingObject(). */
  void
  SetMovingContour(const ContourType * contour)
  {
    this->SetMovingObject(contour);
  }
  const ContourType *
  GetMovingContour() const
  {
    return dynamic_cast<const ContourType *>(this->GetMovingObject());
  }

  /** The transform that the optimizer moves; any centre. Made by Initialize() when none was given. */
  itkSetObjectMacro(MovingTransform, TransformType);
  itkGetModifiableObjectMacro(MovingTransform, TransformType);

  /** Pivot c of scale and rotation in the moving frame; the centroid of the moving points unless set. */
  void
  SetPivot(const PointType & pivot);
  void
  UseCentroidAsPivot();
  itkGetConstReferenceMacro(Pivot, PointType);

  /** L, pixels of the fixed frame. */
  itkGetConstMacro(ReferenceLength, double);

  /** Checks the contours and prepares the search. Throws where one is missing or empty. */
  void
  Initialize() override;

  /** Takes this similarity (scale, angle, tx, ty of a transform with centre 0) as the origin of x, and goes there. */
  void
  SetReference(const ContourSimilarity & similarity);

  /** Bounds on x; lower = upper fixes a parameter. */
  void
  SetBounds(const ParametersType & lower, const ParametersType & upper);
  void
  RemoveBounds();
  itkGetConstMacro(HasBounds, bool);
  itkGetConstReferenceMacro(LowerBound, ParametersType);
  itkGetConstReferenceMacro(UpperBound, ParametersType);

  /** Position x of the optimizer to similarity and back. Positions are not clipped to the bounds here. */
  ContourSimilarity
  GetSimilarity(const ParametersType & parameters) const;
  ParametersType
  GetOptimizerParameters(const ContourSimilarity & similarity) const;

  /** The similarity at the current position, within the bounds. */
  ContourSimilarity
  GetCurrentSimilarity() const;

  /** Value at a position, the metric left where it stands. */
  MeasureType
  EvaluateAt(const ParametersType & parameters) const;

  /** About the value at a position within the bounds, much faster: for ranking many candidates. numberOfPoints thins
   * the contours. */
  MeasureType
  EvaluateApproximatelyAt(const ParametersType & parameters, SizeValueType numberOfPoints = 48) const;

  /** Smallest value evaluated by GetValue() or GetValueAndDerivative() within the bounds since ResetBest(), and where.
   */
  void
  ResetBest();
  itkGetConstMacro(BestValue, MeasureType);
  itkGetConstReferenceMacro(BestParameters, ParametersType);

  /** Number of evaluations since ResetBest(). */
  itkGetConstMacro(NumberOfEvaluations, SizeValueType);

  // What optimizers call
  MeasureType
  GetValue() const override;
  void
  GetDerivative(DerivativeType & derivative) const override;
  void
  GetValueAndDerivative(MeasureType & value, DerivativeType & derivative) const override;
  NumberOfParametersType
  GetNumberOfParameters() const override
  {
    return NumberOfParameters;
  }
  NumberOfParametersType
  GetNumberOfLocalParameters() const override
  {
    return NumberOfParameters;
  }
  void
  SetParameters(ParametersType & parameters) override;
  const ParametersType &
  GetParameters() const override
  {
    return m_Parameters;
  }
  bool
  HasLocalSupport() const override
  {
    return false;
  }
  void
  UpdateTransformParameters(const DerivativeType & derivative, ParametersValueType factor = 1.0) override;
  MetricCategoryEnum
  GetMetricCategory() const override
  {
    return MetricCategoryEnum::OBJECT_METRIC;
  }

protected:
  ContourToContourMetricv4();
  ~ContourToContourMetricv4() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

  /** Prepares the search for contours that are set and not empty. */
  virtual void
  InitializeContours(const ContourArrays & fixed, const ContourArrays & moving) = 0;

  /** The value and, where gradient is not null, its derivatives (plus sign) by scale, angle, tx, ty. */
  virtual MeasureType
  ComputeValue(const ContourSimilarity & similarity, ContourChamferKernel::GradientType * gradient) const = 0;

  /** About the value, for ranking; here the value itself. */
  virtual MeasureType
  ComputeApproximateValue(const ContourSimilarity & similarity, SizeValueType numberOfPoints) const;

private:
  using PositionType = std::array<double, NumberOfParameters>;

  /** Derivatives by scale, angle, tx, ty at a similarity, to those by the optimizer's parameters. */
  void
  MapDerivatives(const ContourSimilarity & similarity, const double * bySimilarity, double * byParameters) const;

  /** Counts an evaluation at the current position and keeps it where it is the best. */
  void
  Remember(MeasureType value) const;

  void
  CheckInitialized() const;
  MeasureType
  Compute(const ParametersType & parameters, DerivativeType * derivative) const;
  MeasureType
  ComputeAndRemember(DerivativeType * derivative) const;
  PositionType
  Clip(const ParametersType & parameters) const;
  ContourSimilarity
  MapToSimilarity(const double * parameters) const;
  void
  UpdateTransform();

  TransformType::Pointer m_MovingTransform;
  PointType              m_Pivot;
  bool                   m_PivotIsSet{ false };
  bool                   m_Initialized{ false };
  double                 m_MovingRadius{ 1.0 };
  double                 m_ReferenceLength{ 1.0 };
  ContourSimilarity      m_Reference;
  PointType              m_ReferencePosition;
  ParametersType         m_Parameters;
  ParametersType         m_TransformParameters;
  bool                   m_HasBounds{ false };
  ParametersType         m_LowerBound;
  ParametersType         m_UpperBound;
  mutable MeasureType    m_BestValue;
  mutable ParametersType m_BestParameters;
  mutable SizeValueType  m_NumberOfEvaluations{ 0 };
};
} // namespace itk

#endif

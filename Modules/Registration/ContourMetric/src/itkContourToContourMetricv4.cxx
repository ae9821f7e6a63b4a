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
#include "itkContourToContourMetricv4.h"
#include "itkMakeContourArrays.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
// More than any metric of mean distances can change a unit, so that the exact minimum lies within the bounds.
constexpr double ExcessSlope = 10.0;
} // namespace

ContourToContourMetricv4::ContourToContourMetricv4()
  : m_Parameters(NumberOfParameters)
  , m_TransformParameters(NumberOfParameters)
  , m_LowerBound(NumberOfParameters)
  , m_UpperBound(NumberOfParameters)
  , m_BestValue(NumericTraits<MeasureType>::max())
  , m_BestParameters(NumberOfParameters)
{
  m_Pivot.Fill(0.0);
  m_ReferencePosition.Fill(0.0);
  m_Parameters.Fill(0.0);
  m_TransformParameters.Fill(0.0);
  m_LowerBound.Fill(0.0);
  m_UpperBound.Fill(0.0);
  m_BestParameters.Fill(0.0);
}

void
ContourToContourMetricv4::SetPivot(const PointType & pivot)
{
  if (!m_PivotIsSet || pivot != m_Pivot)
  {
    m_PivotIsSet = true;
    m_Pivot = pivot;
    m_Initialized = false;
    this->Modified();
  }
}

void
ContourToContourMetricv4::UseCentroidAsPivot()
{
  if (m_PivotIsSet)
  {
    m_PivotIsSet = false;
    m_Initialized = false;
    this->Modified();
  }
}

void
ContourToContourMetricv4::Initialize()
{
  if (this->GetFixedContour() == nullptr)
  {
    itkExceptionMacro("No fixed contour: call SetFixedContour() with the tracing (a DentalContour).");
  }
  if (this->GetMovingContour() == nullptr)
  {
    itkExceptionMacro("No moving contour: call SetMovingContour() with the silhouette (a DentalContour).");
  }
  const ContourArrays fixed = MakeContourArrays(*this->GetFixedContour());
  const ContourArrays moving = MakeContourArrays(*this->GetMovingContour());
  const auto          sumOfWeights = [](const ContourArrays & contour) {
    double sum = contour.weights.empty() ? static_cast<double>(contour.GetNumberOfPoints()) : 0.0;
    for (const double weight : contour.weights)
    {
      sum += weight;
    }
    return sum;
  };
  if (!(sumOfWeights(fixed) > 0.0))
  {
    itkExceptionMacro(
      "The fixed contour has no point of positive weight; give SetFixedContour() a tracing with points.");
  }
  const double movingWeight = sumOfWeights(moving);
  if (!(movingWeight > 0.0))
  {
    itkExceptionMacro(
      "The moving contour has no point of positive weight; give SetMovingContour() a silhouette with points.");
  }
  const auto weightOf = [&moving](std::size_t i) { return moving.weights.empty() ? 1.0 : moving.weights[i]; };
  if (!m_PivotIsSet)
  {
    m_Pivot.Fill(0.0);
    for (std::size_t i = 0; i < moving.GetNumberOfPoints(); ++i)
    {
      m_Pivot[0] += weightOf(i) * moving.points[2 * i] / movingWeight;
      m_Pivot[1] += weightOf(i) * moving.points[2 * i + 1] / movingWeight;
    }
  }
  double squaredRadius = 0.0;
  for (std::size_t i = 0; i < moving.GetNumberOfPoints(); ++i)
  {
    const double dx = moving.points[2 * i] - m_Pivot[0];
    const double dy = moving.points[2 * i + 1] - m_Pivot[1];
    squaredRadius += weightOf(i) * (dx * dx + dy * dy) / movingWeight;
  }
  // A single point at the pivot feels neither scale nor rotation.
  m_MovingRadius = squaredRadius > 0.0 ? std::sqrt(squaredRadius) : 1.0;
  this->InitializeContours(fixed, moving);
  if (m_MovingTransform.IsNull())
  {
    m_MovingTransform = TransformType::New();
  }
  m_Initialized = true;
  ContourSimilarity similarity;
  similarity.scale = m_MovingTransform->GetScale();
  similarity.angle = m_MovingTransform->GetAngle();
  // p = s R (q - center) + center + translation: the offset is t.
  similarity.tx = m_MovingTransform->GetOffset()[0];
  similarity.ty = m_MovingTransform->GetOffset()[1];
  this->SetReference(similarity);
}

void
ContourToContourMetricv4::SetReference(const ContourSimilarity & similarity)
{
  this->CheckInitialized();
  if (!(similarity.scale > 0.0) || !std::isfinite(similarity.scale) || !std::isfinite(similarity.angle) ||
      !std::isfinite(similarity.tx) || !std::isfinite(similarity.ty))
  {
    itkExceptionMacro("The similarity (scale " << similarity.scale << ", angle " << similarity.angle << ", shift "
                                               << similarity.tx << ", " << similarity.ty
                                               << ") cannot be a reference: its scale must be positive, all finite.");
  }
  m_Reference = similarity;
  const double c = similarity.scale * std::cos(similarity.angle);
  const double s = similarity.scale * std::sin(similarity.angle);
  m_ReferencePosition[0] = c * m_Pivot[0] - s * m_Pivot[1] + similarity.tx;
  m_ReferencePosition[1] = s * m_Pivot[0] + c * m_Pivot[1] + similarity.ty;
  m_ReferenceLength = m_MovingRadius * similarity.scale;
  this->RemoveBounds();
  this->ResetBest();
  m_Parameters.Fill(0.0);
  this->UpdateTransform();
  this->Modified();
}

void
ContourToContourMetricv4::SetBounds(const ParametersType & lower, const ParametersType & upper)
{
  if (lower.GetSize() != NumberOfParameters || upper.GetSize() != NumberOfParameters)
  {
    itkExceptionMacro("Bounds need " << NumberOfParameters << " values, not " << lower.GetSize() << " and "
                                     << upper.GetSize() << ".");
  }
  for (unsigned int i = 0; i < NumberOfParameters; ++i)
  {
    if (!(lower[i] <= upper[i]))
    {
      itkExceptionMacro("The lower bound " << lower[i] << " of parameter " << i << " exceeds the upper, " << upper[i]
                                           << ".");
    }
  }
  m_LowerBound = lower;
  m_UpperBound = upper;
  m_HasBounds = true;
  this->ResetBest();
  this->Modified();
}

void
ContourToContourMetricv4::RemoveBounds()
{
  if (m_HasBounds)
  {
    m_HasBounds = false;
    this->Modified();
  }
}

ContourSimilarity
ContourToContourMetricv4::GetSimilarity(const ParametersType & parameters) const
{
  this->CheckInitialized();
  return this->MapToSimilarity(parameters.data_block());
}

ContourSimilarity
ContourToContourMetricv4::MapToSimilarity(const double * parameters) const
{
  ContourSimilarity similarity;
  similarity.scale = m_Reference.scale * std::exp(parameters[0] / m_ReferenceLength);
  similarity.angle = m_Reference.angle + parameters[1] / m_ReferenceLength;
  const double c = similarity.scale * std::cos(similarity.angle);
  const double s = similarity.scale * std::sin(similarity.angle);
  similarity.tx = m_ReferencePosition[0] + parameters[2] - (c * m_Pivot[0] - s * m_Pivot[1]);
  similarity.ty = m_ReferencePosition[1] + parameters[3] - (s * m_Pivot[0] + c * m_Pivot[1]);
  return similarity;
}

auto
ContourToContourMetricv4::GetOptimizerParameters(const ContourSimilarity & similarity) const -> ParametersType
{
  this->CheckInitialized();
  ParametersType parameters(NumberOfParameters);
  const double   c = similarity.scale * std::cos(similarity.angle);
  const double   s = similarity.scale * std::sin(similarity.angle);
  parameters[0] = m_ReferenceLength * std::log(similarity.scale / m_Reference.scale);
  parameters[1] = m_ReferenceLength * (similarity.angle - m_Reference.angle);
  parameters[2] = c * m_Pivot[0] - s * m_Pivot[1] + similarity.tx - m_ReferencePosition[0];
  parameters[3] = s * m_Pivot[0] + c * m_Pivot[1] + similarity.ty - m_ReferencePosition[1];
  return parameters;
}

ContourSimilarity
ContourToContourMetricv4::GetCurrentSimilarity() const
{
  this->CheckInitialized();
  return this->MapToSimilarity(this->Clip(m_Parameters).data());
}

auto
ContourToContourMetricv4::Clip(const ParametersType & parameters) const -> PositionType
{
  PositionType clipped;
  for (unsigned int i = 0; i < NumberOfParameters; ++i)
  {
    clipped[i] = m_HasBounds ? std::min(std::max(parameters[i], m_LowerBound[i]), m_UpperBound[i]) : parameters[i];
  }
  return clipped;
}

void
ContourToContourMetricv4::UpdateTransform()
{
  const ContourSimilarity similarity = this->GetCurrentSimilarity();
  const auto &            center = m_MovingTransform->GetCenter();
  const double            c = similarity.scale * std::cos(similarity.angle);
  const double            s = similarity.scale * std::sin(similarity.angle);
  m_TransformParameters[0] = similarity.scale;
  m_TransformParameters[1] = similarity.angle;
  m_TransformParameters[2] = similarity.tx - center[0] + (c * center[0] - s * center[1]);
  m_TransformParameters[3] = similarity.ty - center[1] + (s * center[0] + c * center[1]);
  m_MovingTransform->SetParameters(m_TransformParameters);
}

void
ContourToContourMetricv4::SetParameters(ParametersType & parameters)
{
  this->CheckInitialized();
  if (parameters.GetSize() != NumberOfParameters)
  {
    itkExceptionMacro("The metric has " << NumberOfParameters << " parameters, not " << parameters.GetSize() << ".");
  }
  for (unsigned int i = 0; i < NumberOfParameters; ++i)
  {
    if (!std::isfinite(parameters[i]))
    {
      itkExceptionMacro("The optimizer's position " << parameters << " is not finite; check its step length.");
    }
  }
  // Element by element: the optimizer's array may be a view that does not outlive the call.
  std::copy_n(parameters.begin(), NumberOfParameters, m_Parameters.begin());
  this->UpdateTransform();
}

void
ContourToContourMetricv4::UpdateTransformParameters(const DerivativeType & derivative, ParametersValueType factor)
{
  if (derivative.GetSize() != NumberOfParameters)
  {
    itkExceptionMacro("The update has " << derivative.GetSize() << " values instead of " << NumberOfParameters << ".");
  }
  ParametersType parameters(NumberOfParameters);
  for (unsigned int i = 0; i < NumberOfParameters; ++i)
  {
    parameters[i] = m_Parameters[i] + factor * derivative[i];
  }
  const PositionType clipped = this->Clip(parameters);
  std::copy(clipped.begin(), clipped.end(), parameters.begin());
  this->SetParameters(parameters);
}

auto
ContourToContourMetricv4::Compute(const ParametersType & parameters, DerivativeType * derivative) const -> MeasureType
{
  const PositionType                 inside = this->Clip(parameters);
  const ContourSimilarity            similarity = this->MapToSimilarity(inside.data());
  ContourChamferKernel::GradientType gradient;
  if (!(similarity.scale > 1e-12 * m_Reference.scale) || !(similarity.scale < 1e12 * m_Reference.scale))
  {
    itkExceptionMacro("The optimizer asks for a scale of " << similarity.scale
                                                           << "; set bounds or a smaller step length.");
  }
  MeasureType value = this->ComputeValue(similarity, derivative == nullptr ? nullptr : &gradient);
  if (derivative != nullptr)
  {
    derivative->SetSize(NumberOfParameters);
    this->MapDerivatives(similarity, gradient.data(), derivative->data_block());
    for (double & d : *derivative)
    {
      d = -d;
    }
  }
  for (unsigned int i = 0; i < NumberOfParameters; ++i)
  {
    const double excess = parameters[i] - inside[i];
    if (excess != 0.0)
    {
      value += ExcessSlope * std::abs(excess);
      if (derivative != nullptr)
      {
        (*derivative)[i] = excess > 0.0 ? -ExcessSlope : ExcessSlope;
      }
    }
  }
  return value;
}

void
ContourToContourMetricv4::MapDerivatives(const ContourSimilarity & similarity,
                                         const double *            bySimilarity,
                                         double *                  byParameters) const
{
  // t = (u, v) - s R c moves with scale and angle.
  const double c = similarity.scale * std::cos(similarity.angle);
  const double s = similarity.scale * std::sin(similarity.angle);
  const double rx = c * m_Pivot[0] - s * m_Pivot[1];
  const double ry = s * m_Pivot[0] + c * m_Pivot[1];
  byParameters[0] =
    (bySimilarity[0] * similarity.scale - bySimilarity[2] * rx - bySimilarity[3] * ry) / m_ReferenceLength;
  byParameters[1] = (bySimilarity[1] + bySimilarity[2] * ry - bySimilarity[3] * rx) / m_ReferenceLength;
  byParameters[2] = bySimilarity[2];
  byParameters[3] = bySimilarity[3];
}

void
ContourToContourMetricv4::Remember(MeasureType value) const
{
  this->m_Value = value;
  ++m_NumberOfEvaluations;
  if (value < m_BestValue)
  {
    m_BestValue = value;
    std::copy_n(m_Parameters.begin(), NumberOfParameters, m_BestParameters.begin());
  }
}

auto
ContourToContourMetricv4::ComputeAndRemember(DerivativeType * derivative) const -> MeasureType
{
  this->CheckInitialized();
  const MeasureType value = this->Compute(m_Parameters, derivative);
  this->Remember(value);
  return value;
}

auto
ContourToContourMetricv4::EvaluateAt(const ParametersType & parameters) const -> MeasureType
{
  this->CheckInitialized();
  return this->Compute(parameters, nullptr);
}

auto
ContourToContourMetricv4::EvaluateApproximatelyAt(const ParametersType & parameters, SizeValueType numberOfPoints) const
  -> MeasureType
{
  this->CheckInitialized();
  return this->ComputeApproximateValue(this->MapToSimilarity(this->Clip(parameters).data()), numberOfPoints);
}

auto
ContourToContourMetricv4::ComputeApproximateValue(const ContourSimilarity & similarity, SizeValueType) const
  -> MeasureType
{
  return this->ComputeValue(similarity, nullptr);
}

void
ContourToContourMetricv4::ResetBest()
{
  m_BestValue = NumericTraits<MeasureType>::max();
  m_BestParameters = m_Parameters;
  m_NumberOfEvaluations = 0;
}

auto
ContourToContourMetricv4::GetValue() const -> MeasureType
{
  return this->ComputeAndRemember(nullptr);
}

void
ContourToContourMetricv4::GetDerivative(DerivativeType & derivative) const
{
  this->ComputeAndRemember(&derivative);
}

void
ContourToContourMetricv4::GetValueAndDerivative(MeasureType & value, DerivativeType & derivative) const
{
  value = this->ComputeAndRemember(&derivative);
}

void
ContourToContourMetricv4::CheckInitialized() const
{
  if (!m_Initialized)
  {
    itkExceptionMacro("Call Initialize() after setting the contours, the pivot and the distance.");
  }
}

void
ContourToContourMetricv4::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  itkPrintSelfObjectMacro(MovingTransform);
  os << indent << "Pivot: " << m_Pivot << std::endl;
  os << indent << "PivotIsSet: " << (m_PivotIsSet ? "On" : "Off") << std::endl;
  os << indent << "Initialized: " << (m_Initialized ? "On" : "Off") << std::endl;
  os << indent << "MovingRadius: " << m_MovingRadius << std::endl;
  os << indent << "ReferenceLength: " << m_ReferenceLength << std::endl;
  os << indent << "Reference: " << m_Reference.scale << ", " << m_Reference.angle << ", " << m_Reference.tx << ", "
     << m_Reference.ty << std::endl;
  os << indent << "ReferencePosition: " << m_ReferencePosition << std::endl;
  os << indent << "Parameters: " << m_Parameters << std::endl;
  os << indent << "TransformParameters: " << m_TransformParameters << std::endl;
  os << indent << "HasBounds: " << (m_HasBounds ? "On" : "Off") << std::endl;
  os << indent << "LowerBound: " << m_LowerBound << std::endl;
  os << indent << "UpperBound: " << m_UpperBound << std::endl;
  os << indent << "BestValue: " << m_BestValue << std::endl;
  os << indent << "BestParameters: " << m_BestParameters << std::endl;
  os << indent << "NumberOfEvaluations: " << m_NumberOfEvaluations << std::endl;
}
} // namespace itk

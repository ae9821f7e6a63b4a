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
#include "itkContourBaselineRegistrationMethod.h"

#include "itkMakeContourArrays.h"
#include "itkSilhouetteToContourRegistrationMethod.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <ostream>

namespace itk
{
namespace
{
OptimizerParameters<double>
ToParameters(const ContourSimilarity & similarity)
{
  OptimizerParameters<double> parameters(4);
  parameters[0] = similarity.scale;
  parameters[1] = similarity.angle;
  parameters[2] = similarity.tx;
  parameters[3] = similarity.ty;
  return parameters;
}
} // namespace

std::ostream &
operator<<(std::ostream & os, ContourBaselineEnums::Motion motion)
{
  return os << (motion == ContourBaselineEnums::Motion::Rigid ? "Rigid" : "Similarity");
}

ContourBaselineRegistrationMethod::ContourBaselineRegistrationMethod()
  : m_InitialParameters(4)
  , m_OptimizerPosition(4)
{
  m_InitialParameters.Fill(0.0);
  m_OptimizerPosition.Fill(0.0);
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, DecoratedTransformType::New());
}

DataObject::Pointer
ContourBaselineRegistrationMethod::MakeOutput(DataObjectPointerArraySizeType)
{
  return DecoratedTransformType::New().GetPointer();
}

auto
ContourBaselineRegistrationMethod::GetOutput() -> DecoratedTransformType *
{
  return static_cast<DecoratedTransformType *>(this->ProcessObject::GetOutput(0));
}

auto
ContourBaselineRegistrationMethod::GetOutput() const -> const DecoratedTransformType *
{
  return static_cast<const DecoratedTransformType *>(this->ProcessObject::GetOutput(0));
}

auto
ContourBaselineRegistrationMethod::GetTransform() const -> const TransformType *
{
  return this->GetOutput()->Get();
}

void
ContourBaselineRegistrationMethod::VerifyPreconditions() ITKv5_CONST
{
  if (this->GetFixedContour() == nullptr)
  {
    itkExceptionMacro("No fixed contour: call SetFixedContour() with the tracing.");
  }
  if (this->GetMovingContour() == nullptr)
  {
    itkExceptionMacro("No moving contour: call SetMovingContour() with the projected silhouette.");
  }
  Superclass::VerifyPreconditions();
}

void
ContourBaselineRegistrationMethod::GenerateData()
{
  m_CurrentLevel = 0;
  m_OptimizerIteration = 0;
  m_MetricValue = 0.0;
  m_StopConditionDescription.clear();

  // Checks both contours as our own method does.
  const auto box = SilhouetteToContourRegistrationMethod::ComputeBoundingBoxTransform(this->GetFixedContour(),
                                                                                      this->GetMovingContour());
  const auto pointsOf = [](const ContourType & contour) {
    const ContourArrays arrays = MakeContourArrays(contour);
    PointsType          points;
    for (std::size_t i = 0; i < arrays.GetNumberOfPoints(); ++i)
    {
      const double weight = arrays.weights.empty() ? 1.0 : arrays.weights[i];
      if (weight > 0.0)
      {
        points.points.push_back(arrays.points[2 * i]);
        points.points.push_back(arrays.points[2 * i + 1]);
        points.weights.push_back(weight);
        points.sumOfWeights += weight;
      }
    }
    return points;
  };
  const PointsType fixed = pointsOf(*this->GetFixedContour());
  const PointsType moving = pointsOf(*this->GetMovingContour());

  ContourSimilarity start{ box->GetScale(), box->GetAngle(), box->GetOffset()[0], box->GetOffset()[1] };
  if (const TransformType * initial = this->GetInitialTransform())
  {
    start = { initial->GetScale(), initial->GetAngle(), initial->GetOffset()[0], initial->GetOffset()[1] };
    if (!(start.scale > 0.0))
    {
      itkExceptionMacro("The initial transform's scale " << start.scale << " is not positive.");
    }
  }
  else if (m_Motion == MotionEnum::Rigid)
  {
    double centroids[2][2] = { { 0.0, 0.0 }, { 0.0, 0.0 } };
    for (unsigned int side = 0; side < 2; ++side)
    {
      const PointsType & points = side == 0 ? fixed : moving;
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        for (unsigned int d = 0; d < 2; ++d)
        {
          centroids[side][d] += points.weights[i] / points.sumOfWeights * points.points[2 * i + d];
        }
      }
    }
    start = { 1.0, 0.0, centroids[0][0] - centroids[1][0], centroids[0][1] - centroids[1][1] };
  }
  m_InitialParameters = ToParameters(start);
  m_OptimizerPosition = m_InitialParameters;

  const ContourSimilarity result = this->RegisterContours(fixed, moving, start);
  m_OptimizerPosition = ToParameters(result);
  const auto transform = TransformType::New();
  transform->SetParameters(m_OptimizerPosition);
  this->GetOutput()->Set(transform);
  this->UpdateProgress(1.0F);
}

void
ContourBaselineRegistrationMethod::StartLevel(unsigned int level, const ContourSimilarity & similarity)
{
  m_CurrentLevel = level;
  m_OptimizerIteration = 0;
  m_OptimizerPosition = ToParameters(similarity);
  this->InvokeEvent(MultiResolutionIterationEvent());
  if (this->GetAbortGenerateData())
  {
    throw ProcessAborted(__FILE__, __LINE__);
  }
}

void
ContourBaselineRegistrationMethod::ReportIteration(std::size_t               iteration,
                                                   double                    value,
                                                   const ContourSimilarity & similarity,
                                                   float                     progress)
{
  m_OptimizerIteration = iteration;
  m_MetricValue = value;
  m_OptimizerPosition = ToParameters(similarity);
  this->InvokeEvent(IterationEvent());
  this->UpdateProgress(progress);
  if (this->GetAbortGenerateData())
  {
    throw ProcessAborted(__FILE__, __LINE__);
  }
}

ContourSimilarity
ContourBaselineRegistrationMethod::FitSimilarity(const std::vector<double> & from,
                                                 const std::vector<double> & to,
                                                 const std::vector<double> & weights,
                                                 MotionEnum                  motion,
                                                 double                      scale)
{
  using Complex = std::complex<double>;
  Complex fromMean(0.0, 0.0);
  Complex toMean(0.0, 0.0);
  double  sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    fromMean += weights[i] * Complex(from[2 * i], from[2 * i + 1]);
    toMean += weights[i] * Complex(to[2 * i], to[2 * i + 1]);
    sum += weights[i];
  }
  fromMean /= sum;
  toMean /= sum;
  Complex cross(0.0, 0.0);
  double  spread = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    const Complex q = Complex(from[2 * i], from[2 * i + 1]) - fromMean;
    const Complex p = Complex(to[2 * i], to[2 * i + 1]) - toMean;
    cross += weights[i] * std::conj(q) * p;
    spread += weights[i] * std::norm(q);
  }
  ContourSimilarity fit;
  fit.scale = scale;
  // Points that all correspond to one leave rotation and scale undetermined: keep them.
  if (std::abs(cross) > 0.0 && spread > 0.0)
  {
    fit.angle = std::arg(cross);
    if (motion == MotionEnum::Similarity)
    {
      fit.scale = std::abs(cross) / spread;
    }
  }
  const Complex translation = toMean - std::polar(fit.scale, fit.angle) * fromMean;
  fit.tx = translation.real();
  fit.ty = translation.imag();
  return fit;
}

double
ContourBaselineRegistrationMethod::LargestShift(const PointsType &        points,
                                                const ContourSimilarity & a,
                                                const ContourSimilarity & b)
{
  double low[2] = { points.points[0], points.points[1] };
  double high[2] = { points.points[0], points.points[1] };
  for (std::size_t i = 0; i < points.points.size(); ++i)
  {
    low[i % 2] = std::min(low[i % 2], points.points[i]);
    high[i % 2] = std::max(high[i % 2], points.points[i]);
  }
  double largest = 0.0;
  for (unsigned int corner = 0; corner < 4; ++corner)
  {
    const std::complex<double> q((corner & 1u) != 0 ? high[0] : low[0], (corner & 2u) != 0 ? high[1] : low[1]);
    const auto                 difference = (std::polar(a.scale, a.angle) - std::polar(b.scale, b.angle)) * q +
                            std::complex<double>(a.tx - b.tx, a.ty - b.ty);
    largest = std::max(largest, std::abs(difference));
  }
  return largest;
}

void
ContourBaselineRegistrationMethod::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Motion: " << m_Motion << std::endl;
  os << indent << "InitialParameters: " << m_InitialParameters << std::endl;
  os << indent << "CurrentLevel: " << m_CurrentLevel << std::endl;
  os << indent << "OptimizerIteration: " << m_OptimizerIteration << std::endl;
  os << indent << "MetricValue: " << m_MetricValue << std::endl;
  os << indent << "OptimizerPosition: " << m_OptimizerPosition << std::endl;
  os << indent << "StopConditionDescription: " << m_StopConditionDescription << std::endl;
}
} // namespace itk

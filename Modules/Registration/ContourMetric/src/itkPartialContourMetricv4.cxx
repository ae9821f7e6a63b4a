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
#include "itkPartialContourMetricv4.h"

#include "vnl/algo/vnl_symmetric_eigensystem.h"

#include <algorithm>
#include <cmath>

namespace itk
{
void
PartialContourMetricv4::SetKernelWidth(double width)
{
  if (!(width > 0.0) || !std::isfinite(width))
  {
    itkExceptionMacro("A kernel width of " << width << " px makes no sense; it must be positive.");
  }
  if (width != m_KernelWidth)
  {
    m_KernelWidth = width;
    m_Kernel.SetWidth(width);
    this->ResetBest();
    this->Modified();
  }
}

void
PartialContourMetricv4::SetScalePrior(double scale, double relativeSigma)
{
  if (!(scale > 0.0) || !std::isfinite(scale) || !(relativeSigma > 0.0))
  {
    itkExceptionMacro("A scale of " << scale << " with a relative sigma of " << relativeSigma
                                    << " is no prior; both must be positive.");
  }
  m_Prior.logScale = std::log(scale);
  m_Prior.logScaleSigma = relativeSigma;
  this->Modified();
}

void
PartialContourMetricv4::SetRotationPrior(double angle, double sigma)
{
  if (!std::isfinite(angle) || !(sigma > 0.0))
  {
    itkExceptionMacro("An angle of " << angle << " rad with a sigma of " << sigma
                                     << " is no prior; the sigma must be positive.");
  }
  m_Prior.angle = angle;
  m_Prior.angleSigma = sigma;
  this->Modified();
}

void
PartialContourMetricv4::SetTranslationPrior(const PointType & at, const PointType & position, double sigma)
{
  if (!std::isfinite(at[0] + at[1] + position[0] + position[1]) || !(sigma > 0.0))
  {
    itkExceptionMacro("A position " << position << " of " << at << " with a sigma of " << sigma
                                    << " px is no prior; the sigma must be positive, the points finite.");
  }
  for (unsigned int k = 0; k < 2; ++k)
  {
    m_Prior.at[k] = at[k];
    m_Prior.position[k] = position[k];
  }
  m_Prior.positionSigma = sigma;
  this->Modified();
}

double
PartialContourMetricv4::GetScaleSigma(SpacingSourceEnum source)
{
  return ScalePrior::GetSigma(source);
}

void
PartialContourMetricv4::CheckSettings() const
{
  const auto checkPositive = [this](double value, const char * name) {
    if (!(value > 0.0) || !std::isfinite(value))
    {
      itkExceptionMacro(<< name << " is " << value << "; it must be positive.");
    }
  };
  const auto checkNotNegative = [this](double value, const char * name) {
    if (!(value >= 0.0) || !std::isfinite(value))
    {
      itkExceptionMacro(<< name << " is " << value << "; it must be 0 or more.");
    }
  };
  checkPositive(m_KernelWidth, "KernelWidth");
  checkPositive(m_InitialKernelWidth, "InitialKernelWidth");
  checkPositive(m_FinalKernelWidth, "FinalKernelWidth");
  checkPositive(m_WhiteNoise, "WhiteNoise");
  checkNotNegative(m_SmoothNoise, "SmoothNoise");
  checkNotNegative(m_DirectionWeight, "DirectionWeight");
  checkNotNegative(m_DirectionSmoothing, "DirectionSmoothing");
  checkNotNegative(m_ReverseWeight, "ReverseWeight");
  checkNotNegative(m_TaperLength, "TaperLength");
  checkNotNegative(m_GapLength, "GapLength");
  checkNotNegative(m_CorrelationLength, "CorrelationLength");
}

void
PartialContourMetricv4::InitializeContours(const ContourArrays & fixed, const ContourArrays & moving)
{
  this->CheckSettings();
  PartialContourKernel::SettingsType settings;
  settings.robustKernel = m_RobustKernel;
  settings.width = m_KernelWidth;
  settings.directionWeight = m_DirectionWeight;
  settings.directionSmoothing = m_DirectionSmoothing;
  settings.reverseWeight = m_ReverseWeight;
  settings.taperLength = m_TaperLength;
  settings.gapLength = m_GapLength;
  settings.gateByTooth = m_GateByTooth;
  settings.toothRange = m_ToothRange;
  settings.correlationLength = m_CorrelationLength;
  settings.estimateNoise = m_EstimateNoise;
  settings.noise = { m_SmoothNoise, m_WhiteNoise };
  settings.prior = m_Prior;
  m_Kernel.Initialize(fixed, moving, settings);
}

void
PartialContourMetricv4::StartLevel(unsigned int level, unsigned int numberOfLevels, const ContourSimilarity & estimate)
{
  this->CheckInitialized();
  if (m_Annealing)
  {
    const double part = numberOfLevels > 1 ? static_cast<double>(level) / static_cast<double>(numberOfLevels - 1) : 1.0;
    this->SetKernelWidth(m_InitialKernelWidth * std::pow(m_FinalKernelWidth / m_InitialKernelWidth, part));
  }
  if (m_CorrelatedNoise && level + m_NumberOfCorrelatedLevels >= numberOfLevels)
  {
    m_Kernel.UpdateNoise(estimate);
  }
  else
  {
    m_Kernel.ForgetNoise();
  }
  this->ResetBest();
}

bool
PartialContourMetricv4::UpdateNoiseModel()
{
  const bool done = m_Kernel.UpdateNoise(this->GetCurrentSimilarity());
  if (done)
  {
    this->ResetBest();
    this->Modified();
  }
  return done;
}

void
PartialContourMetricv4::ForgetNoiseModel()
{
  m_Kernel.ForgetNoise();
  this->ResetBest();
  this->Modified();
}

PartialContourOverlap
PartialContourMetricv4::ComputeOverlap(double distance) const
{
  return m_Kernel.ComputeOverlap(this->GetCurrentSimilarity(), distance);
}

auto
PartialContourMetricv4::ComputeCovariance() const -> CovarianceType
{
  const ContourSimilarity similarity = this->GetCurrentSimilarity();
  const std::size_t       count = m_Kernel.GetNumberOfResiduals();
  std::vector<double>     residuals(count);
  std::vector<double>     jacobian(NumberOfParameters * count);
  m_Kernel.EvaluateResiduals(similarity, residuals.data(), jacobian.data());
  vnl_matrix<double> information(NumberOfParameters, NumberOfParameters, 0.0);
  const double       unit = 1.0 / m_Kernel.GetValueOfUnitInformation();
  for (std::size_t i = 0; i < count; ++i)
  {
    double row[NumberOfParameters];
    this->MapDerivatives(similarity, &jacobian[NumberOfParameters * i], row);
    for (unsigned int a = 0; a < NumberOfParameters; ++a)
    {
      for (unsigned int b = 0; b < NumberOfParameters; ++b)
      {
        information(a, b) += unit * row[a] * row[b];
      }
    }
  }
  const vnl_symmetric_eigensystem<double> eigen(information);
  // Eigenvalues come in rising order.
  if (!(eigen.get_eigenvalue(0) > 1e-12 * eigen.get_eigenvalue(NumberOfParameters - 1)))
  {
    itkExceptionMacro(
      "The contours leave a part of the similarity undetermined here; set a prior on it or use more of the tracing.");
  }
  return CovarianceType(eigen.pinverse());
}

SizeValueType
PartialContourMetricv4::GetNumberOfResiduals() const
{
  this->CheckInitialized();
  return m_Kernel.GetNumberOfResiduals() + NumberOfParameters;
}

bool
PartialContourMetricv4::IsHeldByBound(unsigned int               parameter,
                                      const vnl_vector<double> & residuals,
                                      const vnl_matrix<double> & jacobian) const
{
  if (!this->GetHasBounds())
  {
    return false;
  }
  // A solver that knows no bounds would go beyond at every step, and have it refused.
  const double x = this->GetParameters()[parameter];
  const bool   atLower = x == this->GetLowerBound()[parameter];
  const bool   atUpper = x == this->GetUpperBound()[parameter];
  if (!atLower && !atUpper)
  {
    return false;
  }
  double gradient = 0.0;
  for (unsigned int i = 0; i < residuals.size(); ++i)
  {
    gradient += residuals[i] * jacobian(i, parameter);
  }
  return (atLower && gradient >= 0.0) || (atUpper && gradient <= 0.0);
}

double
PartialContourMetricv4::ComputePenalty(double excess, double & slope) const
{
  // As the residuals have it.
  slope = 2.0 * excess;
  return excess * excess;
}

void
PartialContourMetricv4::GetResiduals(vnl_vector<double> & residuals, vnl_matrix<double> * jacobian) const
{
  const ContourSimilarity similarity = this->GetCurrentSimilarity();
  const auto              count = static_cast<unsigned int>(m_Kernel.GetNumberOfResiduals());
  residuals.set_size(count + NumberOfParameters);
  if (jacobian != nullptr)
  {
    jacobian->set_size(count + NumberOfParameters, NumberOfParameters);
    jacobian->fill(0.0);
  }
  m_Kernel.EvaluateResiduals(
    similarity, residuals.data_block(), jacobian == nullptr ? nullptr : jacobian->data_block());
  double sum = 0.0;
  for (unsigned int i = 0; i < count; ++i)
  {
    sum += residuals[i] * residuals[i];
    if (jacobian != nullptr)
    {
      double row[NumberOfParameters];
      this->MapDerivatives(similarity, (*jacobian)[i], row);
      std::copy_n(row, NumberOfParameters, (*jacobian)[i]);
    }
  }
  for (unsigned int k = 0; k < NumberOfParameters; ++k)
  {
    const double excess = this->GetExcess(k);
    residuals[count + k] = excess;
    sum += excess * excess;
    if (jacobian != nullptr && (excess != 0.0 || this->IsHeldByBound(k, residuals, *jacobian)))
    {
      for (unsigned int i = 0; i < count; ++i)
      {
        (*jacobian)(i, k) = 0.0;
      }
      (*jacobian)(count + k, k) = 1.0;
    }
  }
  this->Remember(sum);
}

auto
PartialContourMetricv4::ComputeValue(const ContourSimilarity &            similarity,
                                     ContourChamferKernel::GradientType * gradient) const -> MeasureType
{
  return m_Kernel.Evaluate(similarity, gradient);
}

auto
PartialContourMetricv4::ComputeApproximateValue(const ContourSimilarity & similarity,
                                                SizeValueType             numberOfPoints) const -> MeasureType
{
  return m_Kernel.EvaluateApproximately(similarity, numberOfPoints);
}

void
PartialContourMetricv4::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "RobustKernel: " << m_RobustKernel << std::endl;
  os << indent << "KernelWidth: " << m_KernelWidth << std::endl;
  os << indent << "Annealing: " << (m_Annealing ? "On" : "Off") << std::endl;
  os << indent << "InitialKernelWidth: " << m_InitialKernelWidth << std::endl;
  os << indent << "FinalKernelWidth: " << m_FinalKernelWidth << std::endl;
  os << indent << "DirectionWeight: " << m_DirectionWeight << std::endl;
  os << indent << "DirectionSmoothing: " << m_DirectionSmoothing << std::endl;
  os << indent << "ReverseWeight: " << m_ReverseWeight << std::endl;
  os << indent << "TaperLength: " << m_TaperLength << std::endl;
  os << indent << "GapLength: " << m_GapLength << std::endl;
  os << indent << "GateByTooth: " << (m_GateByTooth ? "On" : "Off") << std::endl;
  os << indent << "ToothRange: " << m_ToothRange << std::endl;
  os << indent << "CorrelatedNoise: " << (m_CorrelatedNoise ? "On" : "Off") << std::endl;
  os << indent << "NumberOfCorrelatedLevels: " << m_NumberOfCorrelatedLevels << std::endl;
  os << indent << "CorrelationLength: " << m_CorrelationLength << std::endl;
  os << indent << "SmoothNoise: " << m_SmoothNoise << std::endl;
  os << indent << "WhiteNoise: " << m_WhiteNoise << std::endl;
  os << indent << "EstimateNoise: " << (m_EstimateNoise ? "On" : "Off") << std::endl;
  os << indent << "Prior: scale " << std::exp(m_Prior.logScale) << " +- " << m_Prior.logScaleSigma << ", angle "
     << m_Prior.angle << " +- " << m_Prior.angleSigma << ", (" << m_Prior.at[0] << ", " << m_Prior.at[1] << ") at ("
     << m_Prior.position[0] << ", " << m_Prior.position[1] << ") +- " << m_Prior.positionSigma << std::endl;
  os << indent << "NoiseLevels in use: " << m_Kernel.GetNoise().smooth << ", " << m_Kernel.GetNoise().white
     << (m_Kernel.HasCorrelatedNoise() ? " (correlated)" : "") << std::endl;
}
} // namespace itk

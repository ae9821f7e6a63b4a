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
#include "itkParameterPriorMetricv4.h"

#include <cmath>

namespace itk
{
void
ParameterPriorMetricv4::SetBlock(const BlockType & block)
{
  m_Block = block;
  this->Modified();
}

void
ParameterPriorMetricv4::SetPriors(const std::vector<PriorType> & priors)
{
  m_Priors = priors;
  this->Modified();
}

void
ParameterPriorMetricv4::VerifyPriors(const PositionType & x) const
{
  if (m_Priors.size() != x.size())
  {
    itkExceptionMacro("The block \"" << m_Block.name << "\" has " << x.size() << " parameters and " << m_Priors.size()
                                     << " priors: give SetPriors() one each.");
  }
}

double
ParameterPriorMetricv4::GetPrecision(const PriorType & prior, double value, bool forVariance)
{
  if (std::isinf(prior.sigma))
  {
    return 0.0;
  }
  const double variance = prior.sigma * prior.sigma;
  const double n = prior.degreesOfFreedom;
  if (n <= 2.0)
  {
    return 1.0 / variance;
  }
  const double d = value - prior.mean;
  return (forVariance ? n - 2.0 : n + 1.0) / ((n - 2.0) * variance + d * d);
}

double
ParameterPriorMetricv4::GetDeviance(const PriorType & prior, double value)
{
  if (std::isinf(prior.sigma))
  {
    return 0.0;
  }
  const double ratio = (value - prior.mean) * (value - prior.mean) / (prior.sigma * prior.sigma);
  const double n = prior.degreesOfFreedom;
  return n <= 2.0 ? ratio : (n + 1.0) * std::log1p(ratio / (n - 2.0));
}

ParameterPriorMetricv4::BlocksType
ParameterPriorMetricv4::DeclareBlocks() const
{
  return m_Block.parameters.empty() ? BlocksType() : BlocksType{ m_Block };
}

void
ParameterPriorMetricv4::InitializeTerm()
{
  if (m_Block.parameters.empty())
  {
    itkExceptionMacro("The prior is about nothing: call SetBlock().");
  }
  this->VerifyPriors(this->GetState().GetBlockValues(m_Block.name));
  for (std::size_t k = 0; k < m_Priors.size(); ++k)
  {
    if (!(m_Priors[k].sigma > 0.0))
    {
      itkExceptionMacro("The prior of \""
                        << m_Block.parameters[k].name << "\" has the standard deviation " << m_Priors[k].sigma
                        << ": it must be positive. A parameter that is known is held: SetBlockFree().");
    }
  }
}

SizeValueType
ParameterPriorMetricv4::GetNumberOfResiduals() const
{
  return m_Priors.size();
}

void
ParameterPriorMetricv4::ComputeResiduals(const PositionType & x, VectorType & residuals, MatrixType * jacobian) const
{
  this->VerifyPriors(x);
  const auto count = static_cast<unsigned int>(m_Priors.size());
  residuals.set_size(count);
  if (jacobian != nullptr)
  {
    jacobian->set_size(count, count);
    jacobian->fill(0.0);
  }
  for (unsigned int k = 0; k < count; ++k)
  {
    const double at = m_HeldPosition.empty() ? x[k] : m_HeldPosition[k];
    const double root = std::sqrt(GetPrecision(m_Priors[k], at, m_UseVariancePrecision));
    residuals[k] = root * (x[k] - m_Priors[k].mean);
    if (jacobian != nullptr)
    {
      (*jacobian)(k, k) = root;
    }
  }
}

double
ParameterPriorMetricv4::ComputeValue(const PositionType & x) const
{
  this->VerifyPriors(x);
  double value = 0.0;
  for (std::size_t k = 0; k < m_Priors.size(); ++k)
  {
    value += GetDeviance(m_Priors[k], x[k]);
  }
  return value;
}

void
ParameterPriorMetricv4::Hold(HoldEnum what)
{
  m_HeldPosition = what == HoldEnum::Matches ? this->GetState().GetValues() : PositionType();
}

LightObject::Pointer
ParameterPriorMetricv4::InternalClone() const
{
  auto clone = Self::New();
  clone->m_Block = m_Block;
  clone->m_Priors = m_Priors;
  clone->m_UseVariancePrecision = m_UseVariancePrecision;
  clone->m_HeldPosition = m_HeldPosition;
  clone->CopyState(*this);
  return clone.GetPointer();
}

void
ParameterPriorMetricv4::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Block: " << m_Block.name << std::endl;
  for (std::size_t k = 0; k < m_Priors.size() && k < m_Block.parameters.size(); ++k)
  {
    os << indent << m_Block.parameters[k].name << ": " << m_Priors[k].mean << " +- " << m_Priors[k].sigma
       << ", degrees of freedom " << m_Priors[k].degreesOfFreedom << std::endl;
  }
  os << indent << "UseVariancePrecision: " << (m_UseVariancePrecision ? "On" : "Off") << std::endl;
  os << indent << "HeldPosition: " << (m_HeldPosition.empty() ? "(free)" : "held") << std::endl;
}
} // namespace itk

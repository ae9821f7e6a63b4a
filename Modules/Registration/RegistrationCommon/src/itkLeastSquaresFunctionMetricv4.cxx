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
#include "itkLeastSquaresFunctionMetricv4.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace itk
{
void
LeastSquaresFunctionMetricv4::SetBlocks(const BlocksType & blocks)
{
  m_Blocks = blocks;
  this->Modified();
}

LeastSquaresFunctionMetricv4::BlocksType
LeastSquaresFunctionMetricv4::DeclareBlocks() const
{
  return m_Blocks;
}

void
LeastSquaresFunctionMetricv4::SetFunction(FunctionType function)
{
  m_Function = std::move(function);
  m_NumberOfResiduals = 0;
  this->Modified();
}

std::vector<double>
LeastSquaresFunctionMetricv4::CallFunction(const PositionType & x) const
{
  if (!m_Function)
  {
    itkExceptionMacro("There is no function that gives the residuals: call SetFunction().");
  }
  std::vector<double> residuals = m_Function(x);
  if (residuals.empty())
  {
    itkExceptionMacro("The function of SetFunction() returned no residuals: it must give at least one.");
  }
  if (m_NumberOfResiduals != 0 && residuals.size() != m_NumberOfResiduals)
  {
    itkExceptionMacro("The function of SetFunction() returned "
                      << residuals.size() << " residuals, and " << m_NumberOfResiduals
                      << " before: their number must not depend on the parameters. Let what does not apply be 0.");
  }
  const auto bad = std::find_if_not(residuals.begin(), residuals.end(), [](double r) { return std::isfinite(r); });
  if (bad != residuals.end())
  {
    itkExceptionMacro("Residual " << bad - residuals.begin() << " of the function of SetFunction() is " << *bad
                                  << ": residuals must be finite. Check its standard deviation.");
  }
  return residuals;
}

void
LeastSquaresFunctionMetricv4::InitializeTerm()
{
  if (m_Blocks.empty())
  {
    itkExceptionMacro("The function reads no parameters: call SetBlocks(), with PoseStateBlocks::MakePose() for "
                      "example.");
  }
  m_NumberOfResiduals = 0;
  m_NumberOfResiduals = this->CallFunction(this->GetState().GetValues()).size();
}

SizeValueType
LeastSquaresFunctionMetricv4::GetNumberOfResiduals() const
{
  return m_NumberOfResiduals != 0 ? m_NumberOfResiduals : this->CallFunction(this->GetState().GetValues()).size();
}

void
LeastSquaresFunctionMetricv4::ComputeResiduals(const PositionType & x,
                                               VectorType &         residuals,
                                               MatrixType *         jacobian) const
{
  const std::vector<double> values = this->CallFunction(x);
  residuals.set_size(static_cast<unsigned int>(values.size()));
  std::copy(values.begin(), values.end(), residuals.begin());
  if (jacobian != nullptr)
  {
    this->ComputeJacobianByDifferences(x, *jacobian);
  }
}

LightObject::Pointer
LeastSquaresFunctionMetricv4::InternalClone() const
{
  auto clone = Self::New();
  clone->m_Blocks = m_Blocks;
  clone->m_Function = m_Function;
  clone->m_NumberOfResiduals = m_NumberOfResiduals;
  clone->CopyState(*this);
  return clone.GetPointer();
}

void
LeastSquaresFunctionMetricv4::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Blocks:";
  for (const BlockType & block : m_Blocks)
  {
    os << ' ' << block.name;
  }
  os << std::endl;
  os << indent << "Function: " << (m_Function ? "set" : "(none)") << std::endl;
  os << indent << "NumberOfResiduals: " << m_NumberOfResiduals << std::endl;
}
} // namespace itk

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
#include "itkRegistrationState.h"

#include "itkMacro.h"

#include <algorithm>
#include <ostream>

namespace itk
{
void
RegistrationState::Update()
{
  m_Values.clear();
  m_Scales.clear();
  m_FreeIndices.clear();
  for (const BlockType & block : m_Blocks)
  {
    for (const ParameterType & parameter : block.parameters)
    {
      if (parameter.isFree)
      {
        m_FreeIndices.push_back(m_Values.size());
      }
      m_Values.push_back(parameter.value);
      m_Scales.push_back(parameter.scale);
    }
  }
}

void
RegistrationState::AddBlock(const BlockType & block)
{
  for (const BlockType & other : m_Blocks)
  {
    if (other.name != block.name)
    {
      continue;
    }
    if (other.parameters.size() != block.parameters.size())
    {
      itkGenericExceptionMacro("The block \""
                               << block.name << "\" has " << other.parameters.size() << " parameters in one metric and "
                               << block.parameters.size()
                               << " in another; metrics that read the same block must declare it alike "
                                  "(DeclareBlocks(); blocks() in Python), or give one of the blocks another name.");
    }
    return;
  }
  m_Blocks.push_back(block);
  this->Update();
}

bool
RegistrationState::HasBlock(const std::string & name) const
{
  return std::any_of(m_Blocks.begin(), m_Blocks.end(), [&](const BlockType & block) { return block.name == name; });
}

const RegistrationState::BlockType &
RegistrationState::GetBlock(const std::string & name) const
{
  const auto found =
    std::find_if(m_Blocks.begin(), m_Blocks.end(), [&](const BlockType & block) { return block.name == name; });
  if (found == m_Blocks.end())
  {
    std::string known;
    for (const BlockType & block : m_Blocks)
    {
      known += (known.empty() ? "\"" : ", \"") + block.name + "\"";
    }
    itkGenericExceptionMacro("There is no block \""
                             << name << "\" in the state; there "
                             << (known.empty() ? "is none: call Initialize() of the metric first" : "are " + known)
                             << '.');
  }
  return *found;
}

RegistrationState::BlockType &
RegistrationState::FindBlock(const std::string & name)
{
  return const_cast<BlockType &>(this->GetBlock(name));
}

std::size_t
RegistrationState::GetOffset(const std::string & name) const
{
  const BlockType & wanted = this->GetBlock(name);
  std::size_t       offset = 0;
  for (const BlockType & block : m_Blocks)
  {
    if (&block == &wanted)
    {
      break;
    }
    offset += block.parameters.size();
  }
  return offset;
}

std::vector<double>
RegistrationState::GetBlockValues(const std::string & name) const
{
  const std::size_t offset = this->GetOffset(name);
  const auto        begin = m_Values.begin() + static_cast<std::ptrdiff_t>(offset);
  return { begin, begin + static_cast<std::ptrdiff_t>(this->GetBlock(name).parameters.size()) };
}

void
RegistrationState::SetBlockValues(const std::string & name, const std::vector<double> & values)
{
  BlockType & block = this->FindBlock(name);
  if (values.size() != block.parameters.size())
  {
    itkGenericExceptionMacro("The block \"" << name << "\" has " << block.parameters.size() << " parameters, not "
                                            << values.size() << " as in SetBlockValues().");
  }
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    block.parameters[i].value = values[i];
  }
  this->Update();
}

void
RegistrationState::SetBlockFree(const std::string & name, const std::vector<bool> & isFree)
{
  BlockType & block = this->FindBlock(name);
  if (isFree.size() != block.parameters.size())
  {
    itkGenericExceptionMacro("The block \"" << name << "\" has " << block.parameters.size() << " parameters, not "
                                            << isFree.size() << " as in SetBlockFree().");
  }
  for (std::size_t i = 0; i < isFree.size(); ++i)
  {
    block.parameters[i].isFree = isFree[i];
  }
  this->Update();
}

void
RegistrationState::SetBlockFree(const std::string & name, bool isFree)
{
  this->SetBlockFree(name, std::vector<bool>(this->GetBlock(name).parameters.size(), isFree));
}

void
RegistrationState::SetValues(const std::vector<double> & values)
{
  if (values.size() != m_Values.size())
  {
    itkGenericExceptionMacro("The state has " << m_Values.size() << " parameters, not " << values.size() << '.');
  }
  std::size_t k = 0;
  for (BlockType & block : m_Blocks)
  {
    for (ParameterType & parameter : block.parameters)
    {
      parameter.value = values[k++];
    }
  }
  m_Values = values;
}

RegistrationState::OptimizerParametersType
RegistrationState::GetFreeParameters() const
{
  OptimizerParametersType parameters(m_FreeIndices.size());
  for (std::size_t i = 0; i < m_FreeIndices.size(); ++i)
  {
    parameters[i] = m_Values[m_FreeIndices[i]] * m_Scales[m_FreeIndices[i]];
  }
  return parameters;
}

std::vector<double>
RegistrationState::Expand(const OptimizerParametersType & parameters) const
{
  if (parameters.Size() != m_FreeIndices.size())
  {
    itkGenericExceptionMacro("The state has " << m_FreeIndices.size() << " free parameters, not " << parameters.Size()
                                              << '.');
  }
  std::vector<double> values = m_Values;
  for (std::size_t i = 0; i < m_FreeIndices.size(); ++i)
  {
    values[m_FreeIndices[i]] = parameters[i] / m_Scales[m_FreeIndices[i]];
  }
  return values;
}

void
RegistrationState::SetFreeParameters(const OptimizerParametersType & parameters)
{
  this->SetValues(this->Expand(parameters));
}

double
RegistrationState::GetFreeScale(std::size_t freeIndex) const
{
  return m_Scales[m_FreeIndices[freeIndex]];
}

RegistrationState::OptimizerParametersType
RegistrationState::GetMaximumSteps() const
{
  OptimizerParametersType steps(m_FreeIndices.size());
  std::size_t             i = 0;
  for (const BlockType & block : m_Blocks)
  {
    for (const ParameterType & parameter : block.parameters)
    {
      if (parameter.isFree)
      {
        steps[i++] = parameter.maximumStep * parameter.scale;
      }
    }
  }
  return steps;
}

void
RegistrationState::Print(std::ostream & os, const std::string & indent) const
{
  for (const BlockType & block : m_Blocks)
  {
    os << indent << block.name << ':';
    for (const ParameterType & parameter : block.parameters)
    {
      os << ' ' << parameter.name << '=' << parameter.value << (parameter.isFree ? "" : " (held)");
    }
    os << '\n';
  }
}
} // namespace itk

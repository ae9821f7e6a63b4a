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
#include "itkPoseMetricv4.h"

#include "itkPoseStateBlocks.h"

#include <algorithm>
#include <vector>

namespace itk
{
void
PoseMetricv4::SetTransform(const TransformType * transform)
{
  if (m_Transform != transform)
  {
    m_Transform = transform;
    this->Modified();
  }
  if (transform != nullptr)
  {
    const auto & parameters = transform->GetParameters();
    this->SetBlockValues(m_PoseBlock,
                         { parameters[0], parameters[1], parameters[2], parameters[3], parameters[4], parameters[5] });
    this->SetBlockValues(m_ScaleBlock, { parameters[6] });
  }
}

void
PoseMetricv4::RenameBlock(std::string & block, const std::string & name)
{
  if (block == name)
  {
    return;
  }
  // The unknowns are the same: their values and what is free go along.
  const BlockType     before = this->GetState().GetBlock(block);
  std::vector<double> values;
  std::vector<bool>   isFree;
  for (const auto & parameter : before.parameters)
  {
    values.push_back(parameter.value);
    isFree.push_back(parameter.isFree);
  }
  block = name;
  this->Modified();
  this->SetBlockValues(name, values);
  this->SetBlockFree(name, isFree);
}

void
PoseMetricv4::SetPoseBlock(const std::string & name)
{
  this->RenameBlock(m_PoseBlock, name);
}

void
PoseMetricv4::SetScaleBlock(const std::string & name)
{
  this->RenameBlock(m_ScaleBlock, name);
}

PoseMetricv4::BlocksType
PoseMetricv4::DeclareBlocks() const
{
  return { PoseStateBlocks::MakePose(m_PoseBlock), PoseStateBlocks::MakeScale(m_ScaleBlock) };
}

ModifiedTimeType
PoseMetricv4::GetMTime() const
{
  const ModifiedTimeType time = Superclass::GetMTime();
  return m_Transform.IsNull() ? time : std::max(time, m_Transform->GetMTime());
}

void
PoseMetricv4::InitializeTerm()
{
  if (m_Transform.IsNull())
  {
    itkExceptionMacro("No transform: call SetTransform() with a CephalometricPoseTransform that has the geometry.");
  }
  // Says what to call where the geometry is not set.
  m_Transform->GetPoseGeometry();
}

void
PoseMetricv4::CopyPose(const Self & other)
{
  m_Transform = other.m_Transform;
  m_PoseBlock = other.m_PoseBlock;
  m_ScaleBlock = other.m_ScaleBlock;
  this->CopyState(other);
}

PoseParameters
PoseMetricv4::ToPoseParameters(const PositionType & x)
{
  PoseParameters parameters{ {} };
  std::copy_n(x.begin(), parameters.size(), parameters.begin());
  return parameters;
}

void
PoseMetricv4::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  itkPrintSelfObjectMacro(Transform);
  os << indent << "PoseBlock: " << m_PoseBlock << std::endl;
  os << indent << "ScaleBlock: " << m_ScaleBlock << std::endl;
}
} // namespace itk

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
#include "itkContourOverlapFilter.h"

#include "itkMakeContourArrays.h"
#include "itkPartialContourKernel.h"

#include <cmath>
#include <stdexcept>

namespace itk
{
ContourOverlapFilter::ContourOverlapFilter()
{
  this->SetPrimaryInputName("FixedContour");
  this->AddRequiredInputName("MovingContour", 1);
  this->AddOptionalInputName("Transform", 2);
  this->SetNumberOfRequiredOutputs(0);
  this->SetPrimaryOutputName("FixedShare");
  for (const char * name :
       { "FixedShare", "MovingShare", "RootMeanSquare", "LargestDistance", "SmoothNoise", "WhiteNoise" })
  {
    this->ProcessObject::SetOutput(name, this->MakeOutput(name));
  }
}

DataObject::Pointer
ContourOverlapFilter::MakeOutput(const DataObjectIdentifierType & name)
{
  return Superclass::MakeOutput(name).IsNull() ? nullptr : RealObjectType::New().GetPointer();
}

void
ContourOverlapFilter::VerifyPreconditions() ITKv5_CONST
{
  if (this->GetFixedContour() == nullptr)
  {
    itkExceptionMacro("No fixed contour: call SetFixedContour() with the tracing.");
  }
  if (this->GetMovingContour() == nullptr)
  {
    itkExceptionMacro("No moving contour: call SetMovingContour() with the aligned outline.");
  }
  if (!(m_MaximumDistance > 0.0) || !(m_CorrelationLength > 0.0) || !(m_GapLength >= 0.0))
  {
    itkExceptionMacro("MaximumDistance " << m_MaximumDistance << ", CorrelationLength " << m_CorrelationLength
                                         << " and GapLength " << m_GapLength
                                         << " must be positive (the gap may be 0).");
  }
  Superclass::VerifyPreconditions();
}

void
ContourOverlapFilter::GenerateData()
{
  ContourSimilarity similarity;
  if (this->GetTransform() != nullptr)
  {
    similarity.scale = this->GetTransform()->GetScale();
    similarity.angle = this->GetTransform()->GetAngle();
    similarity.tx = this->GetTransform()->GetOffset()[0];
    similarity.ty = this->GetTransform()->GetOffset()[1];
    if (!(similarity.scale > 0.0))
    {
      itkExceptionMacro("The transform's scale " << similarity.scale << " is not positive.");
    }
  }
  PartialContourKernel::SettingsType settings;
  settings.width = m_MaximumDistance;
  settings.gapLength = m_GapLength;
  settings.gateByTooth = m_GateByTooth;
  settings.correlationLength = m_CorrelationLength;
  PartialContourKernel kernel;
  try
  {
    kernel.Initialize(
      MakeContourArrays(*this->GetFixedContour()), MakeContourArrays(*this->GetMovingContour()), settings);
  }
  catch (const std::invalid_argument & error)
  {
    itkExceptionMacro("There is nothing to measure: " << error.what() << ".");
  }
  m_FixedDistances = kernel.GetFixedDistances(similarity);
  m_MovingDistances = kernel.GetMovingDistances(similarity);
  this->UpdateProgress(0.5f);
  const PartialContourOverlap overlap = kernel.ComputeOverlap(similarity, m_MaximumDistance);
  this->SetFixedShare(overlap.fixedShare);
  this->SetMovingShare(overlap.movingShare);
  this->SetRootMeanSquare(overlap.rms);
  this->SetLargestDistance(overlap.largest);
  // Where no point lies close there is no noise to speak of.
  const bool known = overlap.fixedShare > 0.0 && kernel.UpdateNoise(similarity);
  this->SetSmoothNoise(known ? kernel.GetNoise().smooth : 0.0);
  this->SetWhiteNoise(known ? kernel.GetNoise().white : 0.0);
}

void
ContourOverlapFilter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "MaximumDistance: " << m_MaximumDistance << std::endl;
  os << indent << "GapLength: " << m_GapLength << std::endl;
  os << indent << "GateByTooth: " << (m_GateByTooth ? "On" : "Off") << std::endl;
  os << indent << "CorrelationLength: " << m_CorrelationLength << std::endl;
  os << indent << "FixedShare: " << this->GetFixedShare() << std::endl;
  os << indent << "MovingShare: " << this->GetMovingShare() << std::endl;
  os << indent << "RootMeanSquare: " << this->GetRootMeanSquare() << std::endl;
  os << indent << "LargestDistance: " << this->GetLargestDistance() << std::endl;
  os << indent << "SmoothNoise: " << this->GetSmoothNoise() << std::endl;
  os << indent << "WhiteNoise: " << this->GetWhiteNoise() << std::endl;
  os << indent << "FixedDistances: " << m_FixedDistances.size() << std::endl;
  os << indent << "MovingDistances: " << m_MovingDistances.size() << std::endl;
}
} // namespace itk

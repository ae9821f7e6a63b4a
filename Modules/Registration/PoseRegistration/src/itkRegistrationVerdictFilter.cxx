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
#include "itkRegistrationVerdictFilter.h"

namespace itk
{
RegistrationVerdictFilter::RegistrationVerdictFilter()
{
  this->AddRequiredInputName("Solution", 0);
  this->SetNumberOfRequiredOutputs(2);
  this->SetNthOutput(0, this->MakeOutput(0));
  this->SetNthOutput(1, this->MakeOutput(1));
}

RegistrationVerdictFilter::DataObjectPointer
RegistrationVerdictFilter::MakeOutput(DataObjectPointerArraySizeType)
{
  return DecoratedVerdictType::New().GetPointer();
}

void
RegistrationVerdictFilter::SetThresholds(const ThresholdsType & thresholds)
{
  m_Thresholds = thresholds;
  this->Modified();
}

RegistrationVerdictFilter::DecoratedVerdictType *
RegistrationVerdictFilter::GetVerdictOutput(JawEnum jaw)
{
  return dynamic_cast<DecoratedVerdictType *>(this->ProcessObject::GetOutput(jaw == JawEnum::Upper ? 0 : 1));
}

const RegistrationVerdictFilter::JawVerdictType &
RegistrationVerdictFilter::GetVerdict(JawEnum jaw)
{
  return this->GetVerdictOutput(jaw)->Get();
}

const RegistrationVerdictFilter::JawVerdictType &
RegistrationVerdictFilter::GetViewVerdict(const std::string & view) const
{
  const auto found = m_ViewVerdicts.find(view);
  if (found == m_ViewVerdicts.end())
  {
    itkExceptionMacro("There is no verdict on a view \"" << view << "\"; call Update() after AddView() of it.");
  }
  return found->second;
}

void
RegistrationVerdictFilter::GenerateData()
{
  const PoseSolution * solution = this->GetSolution();
  const auto           verdicts =
    RegistrationVerdict::Evaluate(solution->GetResult(), m_Thresholds, { { m_ImageSize[0], m_ImageSize[1] } });
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    const int index = solution->GetIndex(jaw);
    this->GetVerdictOutput(jaw)->Set(index < 0 ? JawVerdictType() : verdicts[static_cast<std::size_t>(index)]);
  }
  m_ViewVerdicts.clear();
  const auto & views = solution->GetResult().views;
  for (std::size_t v = 0; v < views.size(); ++v)
  {
    JawVerdictType verdict;
    verdict.findings = ViewVerdict::Evaluate(solution->GetResult(), v, m_Thresholds.view);
    verdict.status = ViewVerdict::GetStatus(verdict.findings);
    m_ViewVerdicts[views[v].name] = verdict;
  }
  m_NotCheckable = RegistrationVerdict::GetNotCheckable(solution->GetResult(), solution->GetOptions());
}

void
RegistrationVerdictFilter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Thresholds: suspect cost " << m_Thresholds.suspectCost << ", failed cost " << m_Thresholds.failedCost
     << std::endl;
  os << indent << "ImageSize: " << m_ImageSize << std::endl;
  os << indent << "ViewVerdicts: " << m_ViewVerdicts.size() << std::endl;
  os << indent << "NotCheckable: " << m_NotCheckable.size() << std::endl;
}
} // namespace itk

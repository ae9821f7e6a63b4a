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
#include "itkExperimentRecordPlan.h"

namespace itk
{
std::string
ExperimentRecordPlan::Compute(std::size_t i, const std::string & key, const ExperimentMonitor & monitor) const
{
  ExperimentRecord record;
  record.id = this->GetCohort().GetId(i);
  record.seed = this->GetCohort().IsSimulated() ? this->GetCohort().seed + i : 0;
  const std::string failure = Try([&]() { this->FillRecord(i, record, monitor); });
  if (!failure.empty())
  {
    record.failure = failure;
  }
  if (!record.failure.empty())
  {
    record.methods.clear();
  }
  return record.ToJson(key);
}

void
ExperimentRecordPlan::Accept(std::size_t i, const std::string & text, const std::string & key)
{
  m_Records.resize(this->GetCohort().size());
  m_Records[i] = ExperimentRecord::FromJson(text, key);
}
} // namespace itk

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
#ifndef itkExperimentRecordPlan_h
#define itkExperimentRecordPlan_h

#include "itkExperimentPlan.h"

namespace itk
{
/** \class ExperimentRecordPlan
 * \brief A study that keeps one ExperimentRecord a case. */
class ExperimentRecordPlan : public ExperimentPlan
{
public:
  using ExperimentPlan::ExperimentPlan;

  void
  Accept(std::size_t i, const std::string & text, const std::string & key) override
  {
    m_Records.resize(this->GetCohort().size());
    m_Records[i] = ExperimentRecord::FromJson(text, key);
  }

protected:
  /** In the order of the cohort. */
  const std::vector<ExperimentRecord> &
  GetRecords() const
  {
    return m_Records;
  }

private:
  std::vector<ExperimentRecord> m_Records;
};
} // namespace itk

#endif

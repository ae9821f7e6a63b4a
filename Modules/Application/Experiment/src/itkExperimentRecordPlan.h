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
 * \brief A study that keeps one ExperimentRecord a case: how a record begins, fails and is kept is the same in all. */
class ExperimentRecordPlan : public ExperimentPlan
{
public:
  using ExperimentPlan::ExperimentPlan;

  /** The record of a case that FillRecord() fills. */
  std::string
  Compute(std::size_t i, const std::string & key, const ExperimentMonitor & monitor) const final;

  void
  Accept(std::size_t i, const std::string & text, const std::string & key) override;

protected:
  /** Runs what the study runs on the i-th case; the record has its name and seed. What a case can't be used for is an
   * exception, or a failure in words of the study's own: the record then keeps the failure alone. */
  virtual void
  FillRecord(std::size_t i, ExperimentRecord & record, const ExperimentMonitor & monitor) const = 0;

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

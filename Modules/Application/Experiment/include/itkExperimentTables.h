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
#ifndef itkExperimentTables_h
#define itkExperimentTables_h

#include "ExperimentExport.h"
#include "itkExperimentMethod.h"
#include "itkExperimentRecord.h"

#include <map>
#include <string>
#include <vector>

namespace itk
{
/** What the tables say of themselves. */
struct ExperimentDescription
{
  /** "34 simulated cases, level typical, seeds 1 to 34". */
  std::string   cohort;
  std::uint64_t seed{ 1 };
};

/** Every table of an experiment by file name: tables.md, and CSV files. The same text for the same records: no times.
 *
 * \ingroup Experiment */
Experiment_EXPORT std::map<std::string, std::string>
                  MakeExperimentTables(const std::vector<ExperimentRecord> & records,
                                       const std::vector<ExperimentMethod> & methods,
                                       const ExperimentDescription &         description);
} // namespace itk

#endif

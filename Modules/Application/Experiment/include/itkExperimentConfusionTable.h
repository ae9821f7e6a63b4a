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
#ifndef itkExperimentConfusionTable_h
#define itkExperimentConfusionTable_h

#include "ExperimentExport.h"
#include "itkExperimentRecord.h"

#include <array>
#include <string>
#include <vector>

namespace itk
{
/** \class ExperimentConfusionTable
 * \brief Jaws by verdict (ok, suspect, failed) and by their actual mean error: up to 0.5 mm, up to 2 mm, above, not
 * known.
 *
 * \ingroup Experiment
 */
class Experiment_EXPORT ExperimentConfusionTable
{
public:
  enum ErrorClass : unsigned int
  {
    Good = 0,
    Usable,
    Unusable,
    NotKnown,
    NumberOfClasses
  };
  enum Verdict : unsigned int
  {
    Ok = 0,
    Suspect,
    Failed,
    NumberOfVerdicts
  };
  using CountsType = std::array<std::array<std::size_t, NumberOfClasses>, NumberOfVerdicts>;

  /** The jaws of a case by a method, in the part of the table for a kind of input ("" where there is one only). */
  void
  Add(const std::string & input, const ExperimentRecord & record, const std::string & method);

  /** All zero for an input that was not added. */
  CountsType
  GetCounts(const std::string & input) const;
  /** The table as Markdown and as CSV. */
  std::string
  ToMarkdown() const;
  std::string
  ToCSV() const;

  /** A sentence to stand above it. */
  static const char *
  GetExplanation();

private:
  std::vector<std::pair<std::string, CountsType>> m_Parts;
};
} // namespace itk

#endif

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
#ifndef itkExperimentTable_h
#define itkExperimentTable_h

#include "ExperimentExport.h"

#include <string>
#include <vector>

namespace itk
{
/** \class ExperimentTable
 * \brief Rows of text under a header, as CSV and as Markdown.
 *
 * \ingroup Experiment
 */
class Experiment_EXPORT ExperimentTable
{
public:
  explicit ExperimentTable(std::vector<std::string> header)
    : m_Header(std::move(header))
  {} /**< A cell each column. */

  /** Throws std::logic_error for a row of another length than the header. */
  void
  AddRow(const std::vector<std::string> & row);
  /** The rows as CSV and as Markdown. */
  std::string
  ToCSV() const;
  std::string
  ToMarkdown() const;

  /** Fixed digits; empty for what is not finite. */
  static std::string
  Number(double value, int digits);

private:
  std::vector<std::string>              m_Header;
  std::vector<std::vector<std::string>> m_Rows;
};

} // namespace itk

#endif

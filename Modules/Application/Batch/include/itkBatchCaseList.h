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
#ifndef itkBatchCaseList_h
#define itkBatchCaseList_h

#include "BatchExport.h"
#include "itkBatchCase.h"

#include <set>
#include <string>
#include <vector>

namespace itk
{
/** \class BatchCaseList
 * \brief Finds the cases of a batch.
 *
 * In a folder every `case.json` below it, each named after the folders that it lies in; where there is none, the case
 * files that lie in the folder itself. Hidden folders are not entered, links to folders are; folders that hold no case
 * beside such as do are named in a warning. A table (CSV with a header) has a column `case` with the file, or columns
 * that are named as the options of `dentalscr register` are (`upper`, `contours`, `spacing`: numbers with blanks
 * between them); `id` names a case; names of files are relative to the table. Other columns are handed through, with a
 * warning. Anything else is a pattern as of a shell, for case files or folders.
 *
 * Errors (DentalInputError): nothing found, two cases of one name, a table that is none.
 *
 * \ingroup Batch
 */
class Batch_EXPORT BatchCaseList
{
public:
  /** Names of options that a table's columns may have, without dashes, and of these the ones that name a file. */
  void
  SetOptionNames(const std::set<std::string> & options, const std::set<std::string> & files);

  /** In the order of the inputs, and within one in that of the names. */
  std::vector<BatchCase>
  Find(const std::vector<std::string> & inputs);

  /** What of the inputs was left out, a line each. */
  const std::vector<std::string> &
  GetWarnings() const
  {
    return m_Warnings;
  }

private:
  void
  AddFolder(const std::string & folder, std::vector<BatchCase> & cases);
  void
  AddTable(const std::string & fileName, std::vector<BatchCase> & cases);
  void
  AddPattern(const std::string & pattern, std::vector<BatchCase> & cases) const;

  std::set<std::string>    m_Options;
  std::set<std::string>    m_Files;
  std::vector<std::string> m_Warnings;
};
} // namespace itk

#endif

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
#ifndef itkBatchParts_h
#define itkBatchParts_h

#include "BatchExport.h"
#include "itkBatchRecord.h"

#include <string>
#include <vector>

namespace itk
{
/** \class BatchParts
 * \brief Puts together what several batches have left, each in a folder of its own below one.
 *
 * A cohort that is too large for one machine is run in parts, each by a batch; their tables become one here. What is
 * read is each part's summary.json, no result of a case: 400 files for 100,000 cases. Records come in the order of the
 * cases; a case that no part has a row of is unusable and says why, so that nothing is missing in silence.
 *
 * Errors (DentalInputError): a folder that has no parts, a part that can't be read, a case in two parts.
 *
 * \ingroup Batch
 */
class Batch_EXPORT BatchParts
{
public:
  /** `folder` holds the parts. `output` is where the tables go: the records say where a result lies as seen from it. */
  BatchParts(std::string folder, std::string output)
    : m_Folder(std::move(folder))
    , m_Output(std::move(output))
  {}

  /** The records of all parts, in the order of the cases. */
  std::vector<BatchRecord>
  Collect(const std::vector<BatchCase> & cases);

  /** Valid after Collect(): names of the parts that were not run to their end. */
  const std::vector<std::string> &
  GetUnfinished() const
  {
    return m_Unfinished;
  }
  /** Cases that no part has a row of. */
  std::size_t
  GetNumberOfMissingCases() const
  {
    return m_NumberOfMissingCases;
  }
  /** Cases of the parts that are not asked for: left out. */
  std::size_t
  GetNumberOfOtherCases() const
  {
    return m_NumberOfOtherCases;
  }

private:
  std::string              m_Folder;
  std::string              m_Output;
  std::vector<std::string> m_Unfinished;
  std::size_t              m_NumberOfMissingCases{ 0 };
  std::size_t              m_NumberOfOtherCases{ 0 };
};
} // namespace itk

#endif

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
#ifndef itkBatchSummary_h
#define itkBatchSummary_h

#include "BatchExport.h"
#include "itkBatchRecord.h"

#include <string>
#include <vector>

namespace itk
{
/** \class BatchSummary
 * \brief Many cases on a page and in tables: summary.csv, summary.json and index.html of a batch.
 *
 * One row a case and jaw: case, jaw, status, codes of the findings, distance of the tracing from what it lies on,
 * expected error (both pixels), seconds, and what a table of cases had besides. A case without a result has one row,
 * without a jaw, and says why. Text that a spreadsheet would run (it begins with = + - @ or a tab) has an apostrophe
 * before it in the CSV. Where results lie elsewhere than in folders of the cases' names beside the tables a further
 * column says where.
 *
 * \ingroup Batch
 */
class Batch_EXPORT BatchSummary
{
public:
  /** Not complete: of a batch that is still at work, or was stopped. */
  explicit BatchSummary(std::vector<BatchRecord> records, bool isComplete = true)
    : m_Records(std::move(records))
    , m_IsComplete(isComplete)
  {}

  /** From a summary.json. What the records say is what the tables say: rows, no arguments and no exit code. Throws
   * DentalInputError. */
  static BatchSummary
  ReadFile(const std::string & fileName);

  /** One a case, in the order of the cohort. */
  const std::vector<BatchRecord> &
  GetRecords() const
  {
    return m_Records;
  }
  /** Whether every case of the cohort has been run. */
  bool
  IsComplete() const
  {
    return m_IsComplete;
  }

  /** The text of summary.csv: a row a case and jaw, with names that no spreadsheet runs. */
  std::string
  ToCSV() const;
  /** The text of summary.json. */
  std::string
  ToJson() const;
  /** One self-contained page but for the pictures, which it shows from the cases' folders. It links to the pages of the
   * cases that are in `folder`. */
  std::string
  ToPage(const std::string & folder = std::string()) const;

  /** All three, each whole or not at all. Throws DentalInputError. */
  void
  Write(const std::string & folder, bool page) const;

private:
  std::vector<BatchRecord> m_Records;
  bool                     m_IsComplete;
};
} // namespace itk

#endif

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
#ifndef itkBatchRecord_h
#define itkBatchRecord_h

#include "BatchExport.h"
#include "itkBatchCase.h"

#include <optional>
#include <string>
#include <vector>

namespace itk
{
/** \struct BatchRecord
 * \brief What came of one case of a batch, as tables have it.
 * \ingroup Batch
 */
struct Batch_EXPORT BatchRecord
{
  /** A row of the tables. */
  struct JawType
  {
    /** "upper", "lower". */
    std::string jaw;
    /** "ok", "suspect", "failed", "skipped". */
    std::string              status;
    std::vector<std::string> findings;
    std::optional<double>    matched;
    std::optional<double>    expectedError;
    std::string              message;
  };
  /** The case that this came of. */
  BatchCase one;
  /** Of its result, as seen from the tables; empty: named as the case, beside them. */
  std::string folder;
  /** Of the case: "ok", "suspect", "failed", or "unusable" where there is no result. */
  std::string status{ "unusable" };
  /** Of `dentalscr register`; other than 0, 1 and 2 where it was ended by the system. */
  int exitCode{ 0 };
  /** The last that it said, where it has no result. */
  std::string          message;
  double               seconds{ 0.0 };
  std::vector<JawType> jaws;
  /** Not run now: the result of an earlier run stands. */
  bool isKept{ false };

  /** Takes the status and the jaws from the case's result.json. Throws DentalInputError where there is none that can be
   * read. */
  void
  ReadResult(const std::string & folder);
};
} // namespace itk

#endif

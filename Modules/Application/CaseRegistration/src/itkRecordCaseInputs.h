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
#ifndef itkRecordCaseInputs_h
#define itkRecordCaseInputs_h

#include "itkDentalCaseData.h"

#include <string>
#include <vector>

namespace itk
{
/** Not installed. By what the system tells a file of a case from another one, and from itself when it was changed. */
struct CaseInputState
{
  std::string            field;
  std::string            fileName;
  std::vector<long long> state;
};

/** Not installed. How the files of a case are before any of them is read: of all but its 2-D landmarks. */
std::vector<CaseInputState>
LookAtCaseInputs(const DentalCase & description);

/** Not installed. Notes the files that a case was made of, with their SHA-256. It reads them anew, by their names: an
 * error where one is not what it was before, for the sum of another file would be that of a result that is not its own.
 */
void
RecordCaseInputs(DentalCaseData & data, const std::vector<CaseInputState> & before);
} // namespace itk

#endif

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
#ifndef itkExperimentCaseFiles_h
#define itkExperimentCaseFiles_h

#include "ExperimentExport.h"

#include <string>
#include <utility>
#include <vector>

namespace itk
{
/** Case files below a folder (its own case.json and those of its subfolders), sorted, each with a name that no other
 * has. Throws DentalInputError where there are none. */
std::vector<std::pair<std::string, std::string>>
FindExperimentCaseFiles(const std::string & folder);

/** Digest of a case file and of every file that it names: another where one of them was edited. Never throws: a file
 * that can't be read counts as empty. */
std::string
DigestExperimentCase(const std::string & fileName);
} // namespace itk

#endif

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
#ifndef dentalscrShellCompletion_h
#define dentalscrShellCompletion_h

#include "dentalscrProgramDescription.h"

#include <string>
#include <vector>

namespace dentalscr
{
/** The shells that a script can be written for. */
const std::vector<std::string> &
GetCompletionShells();

/** A script by which the shell completes verbs, options and their values. Throws std::invalid_argument for another
 * shell. */
std::string
WriteShellCompletion(const ProgramDescription & description, const std::string & shell);
} // namespace dentalscr

#endif

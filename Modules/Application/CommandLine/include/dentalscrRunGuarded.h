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
#ifndef dentalscrRunGuarded_h
#define dentalscrRunGuarded_h

#include "CommandLineExport.h"

#include <functional>
#include <string>

namespace dentalscr
{
/** Says on standard error, in one line, why the program ends; more would hide in a log which case it was. Returns
 * UnusableInput. */
CommandLine_EXPORT int
Fail(std::string message);

/** Runs a program, what its main() does, and returns its exit code. Guarded are
 *  - standard streams that were closed, which hold their place: the next file that is opened would take their number;
 *  - broken pipes and limits on the size of files, which are errors where something is written and no signals;
 *  - terminals: control bytes of names are shown and not sent (PrintableBuffer);
 *  - exceptions, of which one line is said;
 *  - standard output that is lost, which is an error. */
CommandLine_EXPORT int
RunGuarded(const std::function<int()> & program);

/** Starts ITK's pool with as many threads as there are to be had, and says so once where they are fewer than wanted:
 * ITK itself would end the process. 0: all. */
CommandLine_EXPORT void
SetNumberOfThreads(unsigned int wanted);
} // namespace dentalscr

#endif

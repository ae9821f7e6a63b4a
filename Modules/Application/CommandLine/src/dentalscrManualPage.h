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
#ifndef dentalscrManualPage_h
#define dentalscrManualPage_h

#include "dentalscrProgramDescription.h"

#include <string>

namespace dentalscr
{
/** The page of the program (an empty verb) or of a verb, for man(1), section 1. Throws std::invalid_argument where
 * there is no such verb. */
std::string
WriteManualPage(const ProgramDescription & description, const std::string & verb);
} // namespace dentalscr

#endif

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
#ifndef itkDentalViewReader_h
#define itkDentalViewReader_h

#include "itkDentalCase.h"
#include "itkJsonDocument.h"

#include <filesystem>
#include <string>
#include <vector>

namespace itk
{
/** Not installed. Reads the "views" of a case file. Adds to the warnings. */
void
ReadDentalViews(const JsonNode &              node,
                const std::filesystem::path & directory,
                DentalCase &                  dentalCase,
                std::vector<std::string> &    warnings);
} // namespace itk

#endif

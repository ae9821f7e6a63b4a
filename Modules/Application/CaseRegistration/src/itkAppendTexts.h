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
#ifndef itkAppendTexts_h
#define itkAppendTexts_h

#include <string>
#include <vector>

namespace itk
{
/** Warnings and the like of a part, after those of the whole. */
inline void
AppendTexts(std::vector<std::string> & to, const std::vector<std::string> & from)
{
  to.insert(to.end(), from.begin(), from.end());
}
} // namespace itk

#endif

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
#ifndef itkAppendWarning_h
#define itkAppendWarning_h

#include <cstddef>
#include <string>
#include <vector>

namespace itk
{
/** Not installed. Appends a warning of a file. What a file has of one kind it may have two million times, each of which
 * somebody would have to read: after the first hundred one line says that there are more. */
inline void
AppendWarning(std::vector<std::string> & warnings, const std::string & fileName, const std::string & text)
{
  constexpr std::size_t most = 100;
  if (warnings.size() < most)
  {
    warnings.push_back(fileName + ": " + text);
  }
  else if (warnings.size() == most)
  {
    warnings.push_back(fileName + ": there is more to say than these " + std::to_string(most) + " warnings");
  }
}
} // namespace itk

#endif

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
#include "itkJoinNames.h"

namespace itk
{
std::string
JoinNames(const std::vector<std::string> & names)
{
  constexpr std::size_t most = 8;
  const bool            isLong = names.size() > most;
  const std::size_t     named = isLong ? most - 1 : names.size();
  std::string           text;
  for (std::size_t i = 0; i < named; ++i)
  {
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  }
  return isLong ? text + " and " + std::to_string(names.size() - named) + " more" : text;
}
} // namespace itk

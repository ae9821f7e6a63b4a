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
#ifndef itkGroupByReason_h
#define itkGroupByReason_h

#include <map>
#include <string>
#include <vector>

namespace itk
{
/** Names of what shares a reason, in their order, by the reason: of many things that are not used for one reason one
 * sentence is said. Each of `all` has a `name` and a `reason`.
 *
 * \ingroup DentalCommon */
template <typename TAll>
std::map<std::string, std::vector<std::string>>
GroupByReason(const TAll & all)
{
  std::map<std::string, std::vector<std::string>> names;
  for (const auto & one : all)
  {
    names[one.reason].push_back(one.name);
  }
  return names;
}
} // namespace itk

#endif

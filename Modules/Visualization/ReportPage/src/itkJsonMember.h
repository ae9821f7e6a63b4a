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
#ifndef itkJsonMember_h
#define itkJsonMember_h

#include <nlohmann/json.hpp>

#include <string>

namespace itk
{
/** A member of an object, or an empty object where it has none: a reference, so that a loop over its items() is over
 * what lives. */
inline const nlohmann::ordered_json &
JsonMember(const nlohmann::ordered_json & json, const std::string & key)
{
  static const nlohmann::ordered_json none = nlohmann::ordered_json::object();
  const auto                          found = json.find(key);
  return found != json.end() ? *found : none;
}
} // namespace itk

#endif

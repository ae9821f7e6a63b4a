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
#ifndef itkDentalPhantomLevelNames_h
#define itkDentalPhantomLevelNames_h

#include <string>
#include <vector>

namespace itk
{
/** Names of the phantom's levels, in the order of DentalPhantomCaseSource::CohortEnum: what
 * DentalPhantomLevel::GetNames() returns, for those who offer them and should not load the phantom for it.
 *
 * \ingroup DentalPhantom */
inline std::vector<std::string>
GetDentalPhantomLevelNames()
{
  return { "ideal", "typical", "hard", "real", "real-hard", "standard", "practice" };
}
} // namespace itk

#endif

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
#include "itkDescribePlainly.h"

namespace itk
{
std::string
DescribePlainly(const ExceptionObject & error)
{
  const std::string text = error.GetDescription();
  const std::string prefix = "ITK ERROR: ";
  if (text.rfind(prefix, 0) != 0)
  {
    return text;
  }
  const auto address = text.find("(0x");
  const auto end = text.find("): ");
  return address != std::string::npos && end != std::string::npos && address < end ? text.substr(end + 3)
                                                                                   : text.substr(prefix.size());
}
} // namespace itk

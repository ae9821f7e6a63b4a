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
#include "itkBase64.h"

#include <nettle/base64.h>

namespace itk
{
std::string
EncodeBase64(const void * bytes, std::size_t count)
{
  std::string text(BASE64_ENCODE_RAW_LENGTH(count), '\0');
  base64_encode_raw(text.data(), count, static_cast<const std::uint8_t *>(bytes));
  return text;
}
} // namespace itk

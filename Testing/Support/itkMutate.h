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
#ifndef itkMutate_h
#define itkMutate_h

#include "itkReproducibleRandom.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace itk
{
/** One to four of the ways in which files break, or are broken: bits, bytes, cut ends, lost and doubled stretches, what
 * stands in another file, and words that a reader may not expect.
 *
 * \param words  of the format, or wild numbers; written between the bytes or over them
 * \param others of the same format, for stretches; the bytes themselves, where there is no other */
inline std::string
Mutate(std::string                      bytes,
       const std::vector<std::string> & words,
       const std::vector<std::string> & others,
       ReproducibleRandom &             random)
{
  for (std::uint32_t step = 1 + random.Integer(4); step > 0 && !bytes.empty(); --step)
  {
    // Half of them in the beginning, where the headers are.
    const auto        size = static_cast<std::uint32_t>(bytes.size());
    const std::size_t at = random.Integer(random.Integer(2) == 0 ? std::min(size, 400u) : size);
    const std::size_t length = random.Integer(static_cast<std::uint32_t>(std::min<std::size_t>(size - at, 60)) + 1);
    const auto &      word = words[random.Integer(static_cast<std::uint32_t>(words.size()))];
    switch (random.Integer(8))
    {
      case 0:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.Integer(8)));
        break;
      case 1:
        bytes[at] = static_cast<char>(random.Integer(256));
        break;
      case 2:
        bytes.resize(at);
        break;
      case 3:
        bytes.erase(at, length);
        break;
      case 4:
        bytes.insert(at, bytes.substr(at, length));
        break;
      case 5:
        bytes.insert(at, word);
        break;
      case 6: {
        const std::string & other = others[random.Integer(static_cast<std::uint32_t>(others.size()))];
        const std::size_t   from = random.Integer(static_cast<std::uint32_t>(other.size()));
        bytes.replace(at, length, other.substr(from, length + 8));
        break;
      }
      default:
        bytes.replace(at, std::min(word.size(), bytes.size() - at), word);
    }
  }
  return bytes;
}
} // namespace itk

#endif

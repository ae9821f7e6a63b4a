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
#include "itkVerifyScanSize.h"

#include <cstdlib>
#include <string>

namespace itk
{
namespace
{
constexpr const char * Variable = "DENTALSCR_LARGEST_SCAN_MIB";

std::size_t
GetLargestScan()
{
  const char * const given = std::getenv(Variable);
  if (given == nullptr)
  {
    return 1024;
  }
  const std::string text = given;
  // A million million bytes: what follows can be multiplied.
  if (text.empty() || text.size() > 6 || text.find_first_not_of("0123456789") != std::string::npos)
  {
    throw InputFileError(std::string("cannot be judged: the environment variable ") + Variable + " is \"" + text +
                           "\", no whole number of MiB",
                         "correct it, e.g. 4096, or unset it");
  }
  return std::stoul(text);
}
} // namespace

void
VerifyScanSize(const InputFile & file)
{
  constexpr std::size_t mebibyte = std::size_t{ 1 } << 20;
  const std::size_t     largest = GetLargestScan();
  if (file.GetSize() > largest * mebibyte)
  {
    throw InputFileError("has " + std::to_string(file.GetSize()) + " bytes, more than the " + std::to_string(largest) +
                           " MiB that a scan may have",
                         std::string("decimate it, or set the environment variable ") + Variable +
                           " to the MiB that may be read; a binary STL takes eight times its size in memory");
  }
}
} // namespace itk

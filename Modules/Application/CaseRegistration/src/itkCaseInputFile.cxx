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
#include "itkCaseInputFile.h"

#include "itkDentalInputError.h"
#include "itkInputFile.h"

#include <nettle/sha2.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <vector>

namespace itk
{
namespace
{
std::string
Digest(sha256_ctx & context)
{
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
  sha256_digest(&context, digest.size(), digest.data());
  constexpr char digits[] = "0123456789abcdef";
  std::string    text;
  for (const std::uint8_t byte : digest)
  {
    text += digits[byte >> 4];
    text += digits[byte & 15];
  }
  return text;
}
} // namespace

std::string
ComputeFileSHA256(const std::string & fileName)
{
  InputFile  file(fileName);
  sha256_ctx context;
  sha256_init(&context);
  std::vector<std::uint8_t> block(1u << 20);
  std::size_t               left = file.GetSize();
  while (left > 0)
  {
    const std::size_t count = file.Read(block.data(), std::min(left, block.size()));
    if (count == 0)
    {
      break;
    }
    sha256_update(&context, count, block.data());
    left -= count;
  }
  const auto error = DescribeProblem(file, "a file of a case");
  // What reads it says whether it may be empty.
  if (error && file.GetProblem() != InputFile::ProblemEnum::Empty)
  {
    itkDentalInputErrorMacro(fileName, "", error->what(), error->GetRemedy());
  }
  if (file.GetSystemError() != 0)
  {
    itkDentalInputErrorMacro(fileName,
                             "",
                             "it cannot be read (system error " + std::to_string(file.GetSystemError()) + ')',
                             "check the medium");
  }
  if (left > 0 || file.HasChanged())
  {
    itkDentalInputErrorMacro(
      fileName, "", "was changed while it was read", "start again when it is written completely");
  }
  return Digest(context);
}

std::string
ComputeSHA256(const std::string & bytes)
{
  sha256_ctx context;
  sha256_init(&context);
  sha256_update(&context, bytes.size(), reinterpret_cast<const std::uint8_t *>(bytes.data()));
  return Digest(context);
}

CaseInputFile
MakeCaseInputFile(const std::string & field, const std::string & fileName, const std::string & folder)
{
  CaseInputFile     input{ field, fileName, ComputeFileSHA256(fileName) };
  const std::string before = folder.empty() ? "" : (std::filesystem::path(folder) / "").string();
  if (fileName.rfind(before, 0) == 0)
  {
    input.path.erase(0, before.size());
  }
  return input;
}
} // namespace itk

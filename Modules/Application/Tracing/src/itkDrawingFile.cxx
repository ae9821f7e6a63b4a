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
#include "itkDrawingFile.h"

#include "itkCaseInputFile.h"
#include "itkDentalInputError.h"
#include "itkTextFile.h"

#include <filesystem>
#include <utility>

namespace itk
{
DrawingFile::DrawingFile(std::string fileName)
  : m_FileName(std::move(fileName))
  , m_Digest(this->ComputeDigest())
  , m_WasThere(m_Digest.has_value())
{}

std::optional<std::string>
DrawingFile::ComputeDigest() const
{
  std::error_code ignored;
  if (m_FileName.empty() || !std::filesystem::is_regular_file(std::filesystem::u8path(m_FileName), ignored))
  {
    return std::nullopt;
  }
  return ComputeFileSHA256(m_FileName);
}

void
DrawingFile::Verify() const
{
  const auto digest = this->ComputeDigest();
  // One that was removed is written anew.
  if (digest && digest != m_Digest)
  {
    itkDentalInputErrorMacro(m_FileName,
                             "",
                             "was changed by another program since it was read here",
                             "download what you drew, or move that file away and save again");
  }
}

void
DrawingFile::Save(const std::string & content)
{
  if (m_FileName.empty())
  {
    return;
  }
  this->Verify();
  WriteFileAtomically(m_FileName, content);
  m_Digest = this->ComputeDigest();
}
} // namespace itk

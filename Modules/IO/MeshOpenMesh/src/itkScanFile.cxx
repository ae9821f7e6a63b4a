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
#include "itkScanFile.h"

#include "itkInputFile.h"
#include "itkSurfaceMeshFile.h"
#include "itkVerifyScanSize.h"

#include <cstdlib>
#include <new>

#include <sys/mman.h>

namespace itk
{
ScanFile::ScanFile(const std::string & fileName)
{
  InputFile file(fileName);
  if (const auto error = DescribeProblem(file, "a scan"))
  {
    throw SurfaceMeshFileError("", error->what(), error->GetRemedy());
  }
  try
  {
    VerifyScanSize(file);
  }
  catch (const InputFileError & error)
  {
    throw SurfaceMeshFileError("", error.what(), error.GetRemedy());
  }
  m_Size = file.GetSize();
  // Not a vector, which would write noughts into all of it first; in large pages, as each page costs a visit to the
  // system.
  constexpr std::size_t page = std::size_t{ 1 } << 21;
  const std::size_t     rounded = (m_Size + page - 1) / page * page;
  m_Data.reset(static_cast<char *>(m_Size < page ? std::malloc(m_Size) : std::aligned_alloc(page, rounded)));
  if (m_Data == nullptr)
  {
    throw std::bad_alloc();
  }
#ifdef MADV_HUGEPAGE
  if (m_Size >= page)
  {
    ::madvise(m_Data.get(), rounded, MADV_HUGEPAGE);
  }
#endif
  try
  {
    ReadWhole(file, m_Data.get());
  }
  catch (const InputFileError & error)
  {
    throw SurfaceMeshFileError("", error.what(), error.GetRemedy());
  }
}
} // namespace itk

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

#include <cstdlib>
#include <new>

#include <sys/mman.h>

namespace itk
{
ScanFile::ScanFile(const std::string & fileName)
{
  using ProblemEnum = InputFile::ProblemEnum;
  InputFile file(fileName);
  switch (file.GetProblem())
  {
    case ProblemEnum::None:
      break;
    case ProblemEnum::Missing:
      throw SurfaceMeshFileError("", "there is no such file", "check the name and the permissions");
    case ProblemEnum::Forbidden:
      throw SurfaceMeshFileError("", "no permission to read it", "check the name and the permissions");
    case ProblemEnum::Folder:
      throw SurfaceMeshFileError("", "this is a directory", "name an STL, PLY, OBJ or OFF file");
    case ProblemEnum::NotRegular:
      throw SurfaceMeshFileError("", "this is not a regular file", "name an STL, PLY, OBJ or OFF file");
    case ProblemEnum::Empty:
      throw SurfaceMeshFileError("", "the file is empty (0 bytes)", "export or copy the scan again");
    default:
      // Not strerror: it speaks the locale's language and is not safe with threads.
      throw SurfaceMeshFileError("",
                                 "it cannot be opened (system error " + std::to_string(file.GetSystemError()) + ')',
                                 "check the name and the permissions");
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
  const std::size_t count = file.Read(m_Data.get(), m_Size);
  if (count != m_Size && file.GetSystemError() != 0)
  {
    throw SurfaceMeshFileError(
      "", "it cannot be read (system error " + std::to_string(file.GetSystemError()) + ')', "check the medium");
  }
  if (count != m_Size || file.HasChanged())
  {
    throw SurfaceMeshFileError(
      "", "it was changed while it was read", "start again when the scan is copied completely");
  }
}
} // namespace itk

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
#include "itkMappedFile.h"

#include "itkSurfaceMeshFile.h"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace itk
{
namespace
{
std::string
SystemMessage(int error)
{
  switch (error)
  {
    case ENOENT:
    case ENOTDIR:
      return "there is no such file";
    case EACCES:
      return "no permission to read it";
    default:
      // Not strerror: it speaks the locale's language and is not safe with threads.
      return "it cannot be opened (system error " + std::to_string(error) + ')';
  }
}
} // namespace

MappedFile::MappedFile(const std::string & fileName)
{
  // Not blocking: opening a named pipe would wait for a writer for ever.
  const int file = ::open(fileName.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0)
  {
    throw SurfaceMeshFileError("", SystemMessage(errno), "check the name and the permissions");
  }
  struct ::stat status;
  const bool    known = ::fstat(file, &status) == 0;
  if (!known || !S_ISREG(status.st_mode))
  {
    ::close(file);
    throw SurfaceMeshFileError("",
                               known && S_ISDIR(status.st_mode) ? "this is a directory" : "this is not a regular file",
                               "name an STL, PLY, OBJ or OFF file");
  }
  m_Size = static_cast<std::size_t>(status.st_size);
  if (m_Size == 0)
  {
    ::close(file);
    throw SurfaceMeshFileError("", "the file is empty (0 bytes)", "export or copy the scan again");
  }
  int flags = MAP_PRIVATE;
#ifdef MAP_POPULATE
  flags |= MAP_POPULATE;
#endif
  void * const address = ::mmap(nullptr, m_Size, PROT_READ, flags, file, 0);
  const int    error = errno;
  ::close(file);
  if (address == MAP_FAILED)
  {
    throw SurfaceMeshFileError("",
                               "its " + std::to_string(m_Size) + " bytes cannot be mapped (system error " +
                                 std::to_string(error) + ')',
                               "copy it to a local disk, or free memory");
  }
  m_Data = static_cast<const char *>(address);
}

MappedFile::~MappedFile()
{
  ::munmap(const_cast<char *>(m_Data), m_Size);
}
} // namespace itk

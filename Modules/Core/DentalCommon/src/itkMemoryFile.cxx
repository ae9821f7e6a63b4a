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
#include "itkMemoryFile.h"

#include "itkMacro.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace itk
{
MemoryFile::MemoryFile(const std::string & extension)
  : m_File(::memfd_create("dentalscr", MFD_CLOEXEC))
{
  if (m_File < 0)
  {
    itkGenericExceptionMacro("There is no memory for a file: " << std::strerror(errno));
  }
  m_Name = "/proc/self/fd/" + std::to_string(m_File);
  if (extension.empty())
  {
    return;
  }
  std::error_code error;
  std::string     folder = (std::filesystem::temp_directory_path(error) / "dentalscr-XXXXXX").string();
  if (error || ::mkdtemp(&folder[0]) == nullptr)
  {
    const std::string why = error ? error.message() : std::strerror(errno);
    ::close(m_File);
    itkGenericExceptionMacro("The folder for temporary files can't be written (" << why << "): set TMPDIR to one that "
                                                                                 << "can.");
  }
  m_Folder = folder;
  const std::string link = m_Folder + "/image" + extension;
  if (::symlink(m_Name.c_str(), link.c_str()) != 0)
  {
    const int reason = errno;
    ::rmdir(m_Folder.c_str());
    ::close(m_File);
    itkGenericExceptionMacro("\"" << link << "\" can't be made: " << std::strerror(reason));
  }
  m_Name = link;
}

MemoryFile::~MemoryFile()
{
  if (!m_Folder.empty())
  {
    ::unlink(m_Name.c_str());
    ::rmdir(m_Folder.c_str());
  }
  ::close(m_File);
}

void
MemoryFile::SetContent(std::string_view content)
{
  bool isWritten = ::ftruncate(m_File, 0) == 0;
  for (std::size_t done = 0; isWritten && done < content.size();)
  {
    const ::ssize_t count = ::pwrite(m_File, content.data() + done, content.size() - done, static_cast<::off_t>(done));
    isWritten = count > 0 || (count < 0 && errno == EINTR);
    done += count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  if (!isWritten)
  {
    itkGenericExceptionMacro("There is no memory for a file of " << content.size()
                                                                 << " bytes: " << std::strerror(errno));
  }
}

std::uintmax_t
MemoryFile::GetLargestSize()
{
  ::rlimit   limit{};
  const bool isLimited = ::getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  return isLimited ? limit.rlim_cur : std::numeric_limits<std::uintmax_t>::max();
}

std::string
MemoryFile::GetContent() const
{
  struct ::stat status;
  std::string   content;
  if (::fstat(m_File, &status) == 0)
  {
    content.resize(static_cast<std::size_t>(status.st_size));
  }
  std::size_t done = 0;
  while (done < content.size())
  {
    const ::ssize_t count = ::pread(m_File, &content[done], content.size() - done, static_cast<::off_t>(done));
    if (count < 0 && errno == EINTR)
    {
      continue;
    }
    if (count <= 0)
    {
      itkGenericExceptionMacro("A file in memory can't be read: " << std::strerror(errno));
    }
    done += static_cast<std::size_t>(count);
  }
  return content;
}
} // namespace itk

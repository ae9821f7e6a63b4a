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
#include "itkOutputFile.h"

#include "itkDentalInputError.h"
#include "itkTemporaryName.h"

#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace itk
{
namespace
{
/** Whether a name is a link in /dev or /proc, as /dev/stdout is: what is behind it is open already, perhaps for others,
 * and is no file to be replaced. */
bool
IsSystemLink(const std::filesystem::path & path)
{
  std::error_code error;
  if (!std::filesystem::is_symlink(path, error))
  {
    return false;
  }
  const std::string folder = std::filesystem::canonical(std::filesystem::absolute(path).parent_path(), error).string();
  return folder == "/dev" || folder.compare(0, 6, "/proc/") == 0;
}
} // namespace

OutputFile::OutputFile(const std::string & fileName)
  : m_FileName(fileName)
{
  if (fileName.empty())
  {
    itkDentalInputErrorMacro("(no file name)", "", "no output file was named", "name one");
  }
  struct ::stat status;
  const bool    exists = ::stat(fileName.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode))
  {
    itkDentalInputErrorMacro(fileName, "", "cannot be written: is a directory", "name a file in it");
  }
  if (exists && (S_ISCHR(status.st_mode) || S_ISFIFO(status.st_mode) || IsSystemLink(fileName)))
  {
    m_File = ::open(fileName.c_str(), O_WRONLY | O_APPEND | O_NOCTTY | O_CLOEXEC);
    if (m_File < 0)
    {
      this->Fail(errno);
    }
    return;
  }
  if (exists && !S_ISREG(status.st_mode))
  {
    itkDentalInputErrorMacro(fileName, "", "cannot be written: it is a device or a socket", "name a file");
  }
  std::string folder = std::filesystem::path(fileName).parent_path().string();
  folder = folder.empty() ? "." : folder;
  SweepTemporariesOnce(folder);
  for (unsigned int attempt = 0; attempt < 100; ++attempt)
  {
    m_Temporary = MakeTemporaryName(folder);
    m_File = ::open(m_Temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (m_File < 0 && errno != EEXIST)
    {
      this->Fail(errno);
    }
    if (m_File >= 0)
    {
      if (LockTemporary(m_File))
      {
        return;
      }
      ::close(m_File);
      m_File = -1;
    }
  }
  this->Fail(EEXIST);
}

OutputFile::~OutputFile()
{
  if (m_File >= 0)
  {
    if (!m_Temporary.empty())
    {
      ::unlink(m_Temporary.c_str());
    }
    ::close(m_File);
  }
}

void
OutputFile::Fail(int error) const
{
  itkDentalInputErrorMacro(m_FileName,
                           "",
                           std::string("cannot be written: ") + std::strerror(error),
                           error == ENOSPC || error == EDQUOT ? "free some space, or name a file on another disk"
                           : error == EFBIG                   ? "raise the limit on the size of files (ulimit -f)"
                                            : "name a file in an existing folder that may be written to");
}

void
OutputFile::Write(const void * data, std::size_t size)
{
  const auto * bytes = static_cast<const char *>(data);
  while (size > 0)
  {
    // Linux takes 2 GiB at most at a time.
    const ::ssize_t count = ::write(m_File, bytes, size);
    if (count < 0 && errno == EINTR)
    {
      continue;
    }
    if (count <= 0)
    {
      this->Fail(count < 0 ? errno : EIO);
    }
    bytes += count;
    size -= static_cast<std::size_t>(count);
  }
}

void
OutputFile::Commit()
{
  // A network file system tells of a full disk here and no earlier; a second descriptor keeps the lock meanwhile.
  const int copy = ::dup(m_File);
  if (copy < 0 || ::close(copy) != 0)
  {
    this->Fail(errno);
  }
  if (!m_Temporary.empty() && ::rename(m_Temporary.c_str(), m_FileName.c_str()) != 0)
  {
    this->Fail(errno);
  }
  ::close(m_File);
  m_File = -1;
}
} // namespace itk

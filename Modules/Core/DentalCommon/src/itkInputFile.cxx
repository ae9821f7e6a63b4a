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
#include "itkInputFile.h"

#include <cerrno>

#include <fcntl.h>
#include <unistd.h>

namespace itk
{
InputFile::InputFile(const std::string & fileName)
{
  // Not blocking: opening a named pipe would wait for a writer for ever. Not the terminal of this process, either.
  m_File = ::open(fileName.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (m_File < 0 || ::fstat(m_File, &m_Status) != 0)
  {
    m_Error = errno;
    m_Problem = m_Error == ENOENT || m_Error == ENOTDIR ? ProblemEnum::Missing
                : m_Error == EACCES || m_Error == EPERM ? ProblemEnum::Forbidden
                : m_Error == ENXIO                      ? ProblemEnum::NotRegular
                                                        : ProblemEnum::Unopenable;
  }
  else if (S_ISDIR(m_Status.st_mode))
  {
    m_Problem = ProblemEnum::Folder;
  }
  else if (!S_ISREG(m_Status.st_mode))
  {
    m_Problem = ProblemEnum::NotRegular;
  }
  else if (m_Status.st_size == 0)
  {
    m_Problem = ProblemEnum::Empty;
  }
}

InputFile::~InputFile()
{
  if (m_File >= 0)
  {
    ::close(m_File);
  }
}

std::size_t
InputFile::Read(void * data, std::size_t size)
{
  std::size_t done = 0;
  while (m_Problem == ProblemEnum::None && done < size)
  {
    const ::ssize_t count = ::read(m_File, static_cast<char *>(data) + done, size - done);
    if (count < 0 && errno == EINTR)
    {
      continue;
    }
    if (count <= 0)
    {
      m_Error = count < 0 ? errno : 0;
      break;
    }
    done += static_cast<std::size_t>(count);
  }
  return done;
}

bool
InputFile::HasChanged() const
{
  struct stat now
  {};
  return m_File < 0 || ::fstat(m_File, &now) != 0 || now.st_size != m_Status.st_size ||
         now.st_mtim.tv_sec != m_Status.st_mtim.tv_sec || now.st_mtim.tv_nsec != m_Status.st_mtim.tv_nsec;
}

std::string
ReadFileHead(const std::string & fileName, std::size_t size)
{
  InputFile   file(fileName);
  std::string head(file.GetSize() < size ? file.GetSize() : size, '\0');
  head.resize(head.empty() ? 0 : file.Read(&head[0], head.size()));
  return head;
}
} // namespace itk

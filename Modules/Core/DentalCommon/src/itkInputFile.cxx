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
InputFileError::InputFileError(const std::string & problem, const std::string & remedy)
  : std::runtime_error(problem)
  , m_Remedy(remedy)
{}

InputFileError::~InputFileError() = default;

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

std::optional<InputFileError>
DescribeProblem(const InputFile & file, const std::string & what)
{
  using ProblemEnum = InputFile::ProblemEnum;
  switch (file.GetProblem())
  {
    case ProblemEnum::None:
      return std::nullopt;
    case ProblemEnum::Missing:
      return InputFileError("there is no such file", "check the path; in a case file it is relative to that file");
    case ProblemEnum::Forbidden:
      return InputFileError("there is no permission to read it", "check its permissions and those of its folder");
    case ProblemEnum::Folder:
      return InputFileError("this is a directory, not " + what, "name the file in it");
    case ProblemEnum::NotRegular:
      return InputFileError("this is not a regular file but a pipe, a socket or a device",
                            "write what it gives to a file first, and name that");
    case ProblemEnum::Empty:
      return InputFileError("the file is empty (0 bytes)", "export or copy it again");
    default:
      if (file.GetSystemError() == ELOOP)
      {
        return InputFileError("it is a link that leads back to itself", "name the file itself");
      }
      // Not strerror: it speaks the locale's language and is not safe with threads.
      return InputFileError("it cannot be opened (system error " + std::to_string(file.GetSystemError()) + ')',
                            "check the path and the permissions");
  }
}

void
ReadWhole(InputFile & file, void * data)
{
  const bool isWhole = file.Read(data, file.GetSize()) == file.GetSize();
  if (!isWhole && file.GetSystemError() != 0)
  {
    throw InputFileError("it cannot be read (system error " + std::to_string(file.GetSystemError()) + ')',
                         "check the medium");
  }
  if (!isWhole || file.HasChanged())
  {
    throw InputFileError("it was changed while it was read", "start again when it is written completely");
  }
}

std::string
ReadWhole(InputFile & file, const std::string & what, std::size_t maximumSize)
{
  if (const auto error = DescribeProblem(file, what))
  {
    throw InputFileError(*error);
  }
  if (file.GetSize() > maximumSize)
  {
    throw InputFileError("it is longer than " + std::to_string(maximumSize) + " bytes, too long for " + what,
                         "check that this is the right file");
  }
  std::string bytes(file.GetSize(), '\0');
  ReadWhole(file, &bytes[0]);
  return bytes;
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

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
#include "itkStagingFolder.h"

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
[[noreturn]] void
Fail(const std::string & folder, int error)
{
  itkDentalInputErrorMacro(folder,
                           "",
                           std::string("can't be written: ") + std::strerror(error),
                           error == ENOSPC || error == EDQUOT ? "free some space, or name a folder on another disk"
                                                              : "name an existing folder that may be written to");
}
} // namespace

StagingFolder::StagingFolder(const std::string & folder)
{
  SweepTemporariesOnce(folder);
  // Again where a sweep has found it before it was locked.
  for (unsigned int attempt = 0;; ++attempt)
  {
    const std::string path = MakeTemporaryName(folder);
    if (::mkdir(path.c_str(), 0777) != 0)
    {
      Fail(folder, errno);
    }
    m_Lock = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const int why = m_Lock < 0 ? errno : ENOENT;
    if (m_Lock >= 0 && LockTemporary(m_Lock))
    {
      m_Path = path;
      return;
    }
    if (m_Lock >= 0)
    {
      ::close(m_Lock);
    }
    // Of one that is there and can't be opened nothing was swept.
    if (why != ENOENT || attempt == 100)
    {
      ::rmdir(path.c_str());
      Fail(folder, why);
    }
  }
}

StagingFolder::~StagingFolder()
{
  std::error_code ignored;
  std::filesystem::remove_all(m_Path, ignored);
  ::close(m_Lock);
}
} // namespace itk

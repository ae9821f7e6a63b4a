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
#include "itkFolderLock.h"

#include "itkDentalInputError.h"
#include "itkJobQueue.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <thread>

namespace itk
{
FolderLock::FolderLock(const std::string &           fileName,
                       const std::string &           folder,
                       const std::string &           owner,
                       const std::function<bool()> & wait)
  : m_File(open(fileName.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666))
{
  if (m_File < 0)
  {
    itkDentalInputErrorMacro(
      folder, "", std::string("can't be written: ") + std::strerror(errno), "choose another output folder");
  }
  bool isOurs = flock(m_File, LOCK_EX | LOCK_NB) == 0;
  try
  {
    while (!isOurs && wait && wait())
    {
      std::this_thread::sleep_for(JobQueue::PollInterval);
      isOurs = flock(m_File, LOCK_EX | LOCK_NB) == 0;
    }
  }
  catch (...)
  {
    close(m_File);
    throw;
  }
  if (!isOurs)
  {
    close(m_File);
    itkDentalInputErrorMacro(
      folder, "--output", "another " + owner + " is at work in it", "wait for it, or choose another output folder");
  }
}

FolderLock::~FolderLock()
{
  close(m_File);
}
} // namespace itk

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
#include "itkOutputFolder.h"

#include "itkDentalInputError.h"
#include "itkTemporaryName.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace itk
{
namespace
{
namespace fs = std::filesystem;

/** How often it is tried to lock a folder that is waited for. */
constexpr std::chrono::milliseconds PollInterval{ 10 };

[[noreturn]] void
Fail(const std::string & name, const std::string & why)
{
  itkDentalInputErrorMacro(name, "", "can't be written: " + why, "choose another output folder");
}

/** Whether a name still stands for what was opened by it. */
bool
IsSameFolder(const std::string & path, int descriptor)
{
  struct ::stat now;
  struct ::stat opened;
  return ::stat(path.c_str(), &now) == 0 && ::fstat(descriptor, &opened) == 0 && now.st_dev == opened.st_dev &&
         now.st_ino == opened.st_ino;
}

/** What a file is moved to may be a file or a link; anything else was not made by a run and isn't replaced. */
void
RefuseToReplace(const std::string & folder, const fs::path & path)
{
  std::error_code error;
  const auto      type = fs::symlink_status(path, error).type();
  if (type != fs::file_type::not_found && type != fs::file_type::regular && type != fs::file_type::symlink)
  {
    Fail(folder, path.filename().string() + " in it is no file");
  }
}
} // namespace

bool
OutputFolder::Lock(int descriptor, const std::function<bool()> & wait)
{
  // Other failures are of a file system without locks.
  while (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
  {
    if (!wait || !wait())
    {
      return false;
    }
    std::this_thread::sleep_for(PollInterval);
  }
  return true;
}

void
OutputFolder::LockFile(const std::string & lockFile, const std::function<bool()> & wait)
{
  const fs::path  file = fs::path(m_Path) / fs::u8path(lockFile);
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error)
  {
    Fail(m_Path, error.message());
  }
  // For writing: on NFS none but such a file can be locked for one alone.
  m_FileLock = ::open(file.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
  if (m_FileLock < 0)
  {
    Fail(m_Path, std::strerror(errno));
  }
  if (!Lock(m_FileLock, wait))
  {
    this->RefuseAsTaken();
  }
}

void
OutputFolder::RefuseAsTaken() const
{
  itkDentalInputErrorMacro(m_Path, "", "another run is at work in it", "wait for it, or choose another output folder");
}

OutputFolder::OutputFolder(const std::string & name, const std::string & lockFile, const std::function<bool()> & wait)
  : m_Name(name)
{
  if (name.empty())
  {
    itkDentalInputErrorMacro("--output", "", "the name of the folder is empty", "name a folder");
  }
  const fs::path folder = fs::absolute(fs::u8path(name)).lexically_normal();
  m_Path = (folder.has_filename() ? folder : folder.parent_path()).string();
  std::error_code error;
  if (fs::exists(m_Path, error) && !fs::is_directory(m_Path, error))
  {
    Fail(m_Path, "it is a file");
  }
  // Again where its last owner has removed it between these steps.
  for (unsigned int attempt = 0; attempt < 100; ++attempt)
  {
    fs::create_directories(fs::path(m_Path).parent_path(), error);
    m_IsMade = !error && fs::create_directory(m_Path, error);
    if (error)
    {
      Fail(m_Path, error.message());
    }
    m_Lock = ::open(m_Path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (m_Lock < 0)
    {
      if (errno == ENOENT)
      {
        continue;
      }
      Fail(m_Path, std::strerror(errno));
    }
    try
    {
      if (!Lock(m_Lock, wait))
      {
        this->RefuseAsTaken();
      }
      if (IsSameFolder(m_Path, m_Lock))
      {
        if (!lockFile.empty())
        {
          this->LockFile(lockFile, wait);
        }
        SweepTemporaries(m_Path);
        return;
      }
    }
    catch (...)
    {
      if (m_FileLock >= 0)
      {
        ::close(m_FileLock);
      }
      if (m_IsMade)
      {
        ::rmdir(m_Path.c_str());
      }
      ::close(m_Lock);
      throw;
    }
    ::close(m_Lock);
  }
  Fail(m_Path, "it is removed again and again");
}

OutputFolder::~OutputFolder()
{
  m_Staging = nullptr;
  if (m_IsMade)
  {
    // Where something is in it this does nothing.
    ::rmdir(m_Path.c_str());
  }
  if (m_FileLock >= 0)
  {
    ::close(m_FileLock);
  }
  ::close(m_Lock);
}

const std::string &
OutputFolder::GetStagingFolder()
{
  if (m_Staging == nullptr)
  {
    m_Staging = std::make_unique<StagingFolder>(m_Path);
  }
  return m_Staging->GetPath();
}

void
OutputFolder::Publish(const std::string & last, const std::vector<std::string> & names)
{
  try
  {
    std::vector<std::string> staged;
    for (const auto & entry : fs::directory_iterator(this->GetStagingFolder()))
    {
      staged.push_back(entry.path().filename().string());
    }
    const fs::path folder(m_Path);
    for (const std::string & name : staged)
    {
      RefuseToReplace(m_Path, folder / name);
    }
    fs::remove(folder / last);
    for (const std::string & name : names)
    {
      if (std::find(staged.begin(), staged.end(), name) == staged.end())
      {
        RefuseToReplace(m_Path, folder / name);
        fs::remove(folder / name);
      }
    }
    for (const std::string & name : staged)
    {
      if (name != last)
      {
        fs::rename(fs::path(this->GetStagingFolder()) / name, folder / name);
      }
    }
    fs::rename(fs::path(this->GetStagingFolder()) / last, folder / last);
  }
  catch (const fs::filesystem_error & failure)
  {
    Fail(m_Path, failure.code().message());
  }
  m_Staging = nullptr;
}
} // namespace itk

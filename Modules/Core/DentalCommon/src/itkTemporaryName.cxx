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
#include "itkTemporaryName.h"

#include <atomic>
#include <cerrno>
#include <filesystem>
#include <mutex>
#include <random>
#include <set>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace itk
{
namespace
{
const std::string Prefix = ".dentalscr-";
const std::string Suffix = ".part";

bool
IsTemporaryName(const std::string & name)
{
  return name.size() > Prefix.size() + Suffix.size() && name.compare(0, Prefix.size(), Prefix) == 0 &&
         name.compare(name.size() - Suffix.size(), Suffix.size(), Suffix) == 0;
}
} // namespace

std::string
MakeTemporaryName(const std::string & folder)
{
  static std::atomic<unsigned int> counter{ 0 };
  std::random_device               device;
  const std::string                name =
    Prefix + std::to_string(::getpid()) + '-' + std::to_string(counter++) + '-' + std::to_string(device()) + Suffix;
  return (std::filesystem::path(folder) / name).string();
}

bool
LockTemporary(int descriptor)
{
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
  {
    return false;
  }
  struct ::stat status;
  return ::fstat(descriptor, &status) == 0 && status.st_nlink > 0;
}

void
SweepTemporaries(const std::string & folder)
{
  std::error_code error;
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
  {
    if (!IsTemporaryName(it->path().filename().string()))
    {
      continue;
    }
    const int file = ::open(it->path().c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0)
    {
      continue;
    }
    if (::flock(file, LOCK_EX | LOCK_NB) == 0)
    {
      std::error_code ignored;
      std::filesystem::remove_all(it->path(), ignored);
    }
    ::close(file);
  }
}

void
SweepTemporariesOnce(const std::string & folder)
{
  static std::mutex            mutex;
  static std::set<std::string> swept;
  {
    const std::lock_guard<std::mutex> lock(mutex);
    if (!swept.insert(std::filesystem::absolute(folder).string()).second)
    {
      return;
    }
  }
  SweepTemporaries(folder);
}
} // namespace itk

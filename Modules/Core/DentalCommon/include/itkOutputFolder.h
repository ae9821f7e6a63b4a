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
#ifndef itkOutputFolder_h
#define itkOutputFolder_h

#include "DentalCommonExport.h"
#include "itkStagingFolder.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace itk
{
/** \class OutputFolder
 * \brief The folder that a run writes to, which has one owner at a time.
 *
 * The folder is made where it isn't there. For as long as this object lives no other one, of this process or another,
 * can own the same folder: its constructor says so with a DentalInputError at once. The system lets go of a lock
 * however its owner ends. (On a file system without locks there is no owner, and all else is as it is said here.) What
 * killed runs have left in the folder is removed first.
 *
 * The lock is the folder's own, which other machines don't see on a network file system: it tells them of locks of
 * files alone (flock(2)). Where several machines may write to the folder a file in it is locked as well; it stays.
 *
 * Files are made in GetStagingFolder() and moved by Publish(). A folder that was made here and is still empty at the
 * end is removed again.
 *
 * \ingroup DentalCommon
 */
class DentalCommon_EXPORT OutputFolder
{
public:
  /** \param name     as the user has given it
   * \param lockFile as seen from the folder: locked, too, so that other machines see it; empty: none
   * \param wait     called from time to time while another run is at work in the folder, until it returns false: then
   *                 the constructor gives up. What it throws leaves. */
  explicit OutputFolder(const std::string &           name,
                        const std::string &           lockFile = {},
                        const std::function<bool()> & wait = {});
  ~OutputFolder();
  OutputFolder(const OutputFolder &) = delete;
  OutputFolder &
  operator=(const OutputFolder &) = delete;

  /** As given. */
  const std::string &
  GetName() const
  {
    return m_Name;
  }

  /** A folder inside this one for what isn't complete yet; made at the first call. */
  const std::string &
  GetStagingFolder();

  /** Moves what is in the staging folder to its place.
   *
   * \param last  the file that tells a reader that all others are there: an earlier one of its name is removed first,
   *              the new one is moved last
   * \param names every file that a run can leave: those that aren't staged are stale and are removed */
  void
  Publish(const std::string & last, const std::vector<std::string> & names = {});

private:
  /** Whether the lock of what is open is this object's now; false where `wait` ended. */
  static bool
  Lock(int descriptor, const std::function<bool()> & wait);
  void
  LockFile(const std::string & lockFile, const std::function<bool()> & wait);
  [[noreturn]] void
  RefuseAsTaken() const;

  std::string                    m_Name;
  std::string                    m_Path;
  std::unique_ptr<StagingFolder> m_Staging;
  int                            m_Lock{ -1 };
  int                            m_FileLock{ -1 };
  bool                           m_IsMade{ false };
};
} // namespace itk

#endif

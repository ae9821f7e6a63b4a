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
#ifndef itkFolderLock_h
#define itkFolderLock_h

#include "BatchExport.h"

#include <functional>
#include <string>

namespace itk
{
/** \class FolderLock
 * \brief One owner of an output folder at a time, for as long as this object lives: the system lets go of it however
 * the owner ends.
 *
 * The lock is a file's; it stays where it is, and says nothing when nobody holds it.
 *
 * \ingroup Batch
 */
class Batch_EXPORT FolderLock
{
public:
  /** `fileName` is made where it is missing. `owner` says in the message who else would have it: "batch". Where
   * somebody has it, `wait` is called from time to time, as long as it says to wait on. Throws DentalInputError that
   * names `folder`. */
  FolderLock(const std::string &           fileName,
             const std::string &           folder,
             const std::string &           owner,
             const std::function<bool()> & wait = {});
  ~FolderLock();
  FolderLock(const FolderLock &) = delete;
  FolderLock &
  operator=(const FolderLock &) = delete;

private:
  int m_File;
};
} // namespace itk

#endif

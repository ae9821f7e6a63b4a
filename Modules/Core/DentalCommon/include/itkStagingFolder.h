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
#ifndef itkStagingFolder_h
#define itkStagingFolder_h

#include "DentalCommonExport.h"

#include <string>

namespace itk
{
/** \class StagingFolder
 * \brief A folder inside another one for what isn't complete yet, for as long as this object lives.
 *
 * It has the name of a temporary and is locked as long as its process lives; what a killed one has left is removed by
 * the next process that writes into the folder around it. The destructor removes it with all that is in it.
 *
 * Errors (DentalInputError, with the folder and the system's reason): it cannot be made.
 *
 * \sa OutputFile
 * \ingroup DentalCommon
 */
class DentalCommon_EXPORT StagingFolder
{
public:
  /** \param folder where it is made; it must be there */
  explicit StagingFolder(const std::string & folder);
  ~StagingFolder();
  StagingFolder(const StagingFolder &) = delete;
  StagingFolder &
  operator=(const StagingFolder &) = delete;
  /** Path of the folder. */
  const std::string &
  GetPath() const
  {
    return m_Path;
  }

private:
  std::string m_Path;
  int         m_Lock{ -1 };
};
} // namespace itk

#endif

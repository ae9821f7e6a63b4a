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
#ifndef itkMemoryFile_h
#define itkMemoryFile_h

#include "DentalCommonExport.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace itk
{
/** \class MemoryFile
 * \brief A file in memory with a name, for libraries that only write to names, and only read from them.
 *
 * Image libraries don't survive a full disk: libpng ends the process, MetaIO says nothing. They write here, where there
 * is room, and OutputFile writes their bytes to the disk. And they open a file again that was looked at: what they read
 * from here is what was looked at, whatever has become of the file meanwhile.
 *
 * \ingroup DentalCommon
 */
class DentalCommon_EXPORT MemoryFile
{
public:
  /** \param extension what the name has to end with, ".mha", for a library that tells formats by it */
  explicit MemoryFile(const std::string & extension = {});
  ~MemoryFile();
  MemoryFile(const MemoryFile &) = delete;
  MemoryFile &
  operator=(const MemoryFile &) = delete;

  /** Can be opened by this process for as long as this object lives. */
  const std::string &
  GetName() const
  {
    return m_Name;
  }

  /** Of the process; to be handed to another one. */
  int
  GetDescriptor() const
  {
    return m_File;
  }

  /** Writes all of it anew. */
  void
  SetContent(std::string_view content);

  /** All that was written. */
  std::string
  GetContent() const;

  /** The longest file in bytes that this process may write (RLIMIT_FSIZE), in memory as on a disk. */
  static std::uintmax_t
  GetLargestSize();

private:
  std::string m_Name;
  /** Of the link that carries the extension; empty without one. */
  std::string m_Folder;
  int         m_File;
};
} // namespace itk

#endif

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
#ifndef itkOutputFile_h
#define itkOutputFile_h

#include "DentalCommonExport.h"

#include <cstddef>
#include <string>

namespace itk
{
/** \class OutputFile
 * \brief A file that appears whole or not at all: the one door through which the toolkit writes files.
 *
 * What is written goes to a temporary of another name in the same folder, which Commit() checks and renames. Without a
 * Commit() the temporary is removed, and what the name stood for before is untouched. A temporary is locked as long as
 * its process lives; what a killed one has left is removed by the next process that writes into the folder.
 *
 * A character device or a named pipe is written to as a stream. A folder, a socket or a block device is refused.
 * Throws DentalInputError with the file and the system's reason.
 *
 * Complete is what a Commit() leaves for every reader, a full disk and a killed process included. It doesn't wait for
 * the disk: a power failure may take what was written in the last seconds.
 *
 * \ingroup DentalCommon
 */
class DentalCommon_EXPORT OutputFile
{
public:
  explicit OutputFile(const std::string & fileName); /**< Under another name until Commit(). */
  ~OutputFile();
  OutputFile(const OutputFile &) = delete;
  OutputFile &
  operator=(const OutputFile &) = delete;
  /** Appends bytes. Throws a DentalInputError that names file and reason where they can't be written. */
  void
  Write(const void * data, std::size_t size);

  /** From here on the file has its name. */
  void
  Commit();

private:
  [[noreturn]] void
  Fail(int error) const;

  std::string m_FileName;
  /** Empty of a stream. */
  std::string m_Temporary;
  int         m_File{ -1 };
};
} // namespace itk

#endif

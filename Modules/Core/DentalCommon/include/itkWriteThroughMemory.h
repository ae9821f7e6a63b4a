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
#ifndef itkWriteThroughMemory_h
#define itkWriteThroughMemory_h

#include "itkMemoryFile.h"
#include "itkOutputFile.h"

#include <string>

namespace itk
{
/** Has a writer of ITK's write its file to memory, and brings that to the disk whole or not at all (OutputFile). Image
 * libraries don't survive a full disk: libpng ends the process, others leave a file that is cut off.
 *
 * \param writer    has its input, and its ImageIO unless that is chosen by the name; the name of its file is set here
 * \param extension what the name in memory ends with, ".mha", where the format is told by it
 *
 * Throws what the writer throws, and DentalInputError where the file can't be written. \ingroup DentalCommon */
template <typename TWriter>
void
WriteThroughMemory(TWriter * writer, const std::string & fileName, const std::string & extension = {})
{
  const MemoryFile memory(extension);
  writer->SetFileName(memory.GetName());
  writer->Update();
  const std::string content = memory.GetContent();
  OutputFile        file(fileName);
  file.Write(content.data(), content.size());
  file.Commit();
}
} // namespace itk

#endif

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

#include "itkDentalInputError.h"
#include "itkMemoryFile.h"
#include "itkOutputFile.h"

#include <string>

namespace itk
{
/** Has a writer of ITK's write its file to memory, and brings that to the disk whole or not at all (OutputFile). Image
 * libraries don't survive a full disk: libpng ends the process, others leave a file that is cut off. In memory alone
 * the process's own limit on the size of files can stop them, and so the largest file that the image can become has to
 * be within it; what is packed and would be shorter isn't tried.
 *
 * \param writer    has its input, and its ImageIO unless that is chosen by the name; the name of its file is set here
 * \param extension what the name in memory ends with, ".mha", where the format is told by it
 *
 * Throws what the writer throws, and DentalInputError where the file can't be written. \ingroup DentalCommon */
template <typename TWriter>
void
WriteThroughMemory(TWriter * writer, const std::string & fileName, const std::string & extension = {})
{
  using ImageType = typename TWriter::InputImageType;
  auto * const image = const_cast<ImageType *>(writer->GetInput());
  image->UpdateOutputInformation();
  const auto           size = image->GetLargestPossibleRegion().GetSize();
  const std::uintmax_t bytes = static_cast<std::uintmax_t>(size[0]) * size[1] * sizeof(typename ImageType::PixelType);
  // Noise gets longer by packing, rows have a word of their own, and there is a header.
  if (bytes + bytes / 4 + 16 * size[1] + 65536 > MemoryFile::GetLargestSize())
  {
    itkDentalInputErrorMacro(fileName,
                             "",
                             "cannot be written: File too large: an image of " + std::to_string(bytes) + " bytes",
                             "raise the limit on the size of files (ulimit -f)");
  }
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

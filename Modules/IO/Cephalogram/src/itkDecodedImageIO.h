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
#ifndef itkDecodedImageIO_h
#define itkDecodedImageIO_h

#include "itkRadiographFileFormat.h"

#include "itkImageIOBase.h"

#include <memory>

namespace itk
{
/** \class DecodedImageIO
 * \brief Not installed. Reads an image by a process of its own, in which the decoder of its format runs.
 *
 * Decoders of BMP, DICOM, MetaImage, NRRD and TIFF run over their buffers, take gigabytes or end the process where a
 * file is damaged or made to do so. Here they may: the program dentalscr-decode has a limit of memory and of time, may
 * write nothing, and ends alone. Documentation/Robustness.md says why it is done like this.
 *
 * From ReadImageInformation() to Read() the process waits. */
class DecodedImageIO : public ImageIOBase
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(DecodedImageIO);

  using Self = DecodedImageIO;
  using Superclass = ImageIOBase;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(DecodedImageIO, ImageIOBase);

  void
  SetFormat(RadiographFileFormatEnum format)
  {
    m_Format = format;
  }

  /** The file that is decoded, open and in memory, which the process can open again by its descriptor; it has to stay
   * open until ReadImageInformation() returns. The name is for messages alone. */
  void
  SetFile(int descriptor)
  {
    m_File = descriptor;
  }

  bool
  CanReadFile(const char *) override
  {
    return true;
  }
  void
  ReadImageInformation() override;
  void
  Read(void * buffer) override;

  bool
  CanWriteFile(const char *) override
  {
    return false;
  }
  void
  WriteImageInformation() override
  {}
  void
  Write(const void *) override;

protected:
  DecodedImageIO();
  ~DecodedImageIO() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  class Process;

  RadiographFileFormatEnum m_Format{ RadiographFileFormatEnum::DICOM };
  int                      m_File{ -1 };
  std::uint64_t            m_Bytes{ 0 };
  std::unique_ptr<Process> m_Process;
};
} // namespace itk

#endif

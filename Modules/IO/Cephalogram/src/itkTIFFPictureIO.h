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
#ifndef itkTIFFPictureIO_h
#define itkTIFFPictureIO_h

#include "itkTIFFLayout.h"

#include "itkImageIOBase.h"

#include <optional>

namespace itk
{
/** \class TIFFPictureIO
 * \brief Not installed. Reads a TIFF in the decoder's process: whole numbers by libtiff as they are stored, all else by
 * ITK. What the file says of its pixels goes along in the dictionary (PutTIFFLayout()), for who asked.
 *
 * Strips and tiles may share their bytes, and a codec may be given megabytes that unpack to nothing: 5 MB with half a
 * million tiles took minutes. Only a limit of time bounds what a TIFF takes, so nothing of it is decoded elsewhere. */
class TIFFPictureIO : public ImageIOBase
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(TIFFPictureIO);

  using Self = TIFFPictureIO;
  using Superclass = ImageIOBase;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(TIFFPictureIO, ImageIOBase);

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
  Write(const void * buffer) override;

protected:
  TIFFPictureIO() = default;
  ~TIFFPictureIO() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  std::optional<TIFFLayout> m_Layout;
  /** Null where ITK has no part in it. */
  ImageIOBase::Pointer m_ImageIO;
};
} // namespace itk

#endif

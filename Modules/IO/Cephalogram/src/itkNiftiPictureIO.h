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
#ifndef itkNiftiPictureIO_h
#define itkNiftiPictureIO_h

#include "itkImageIOBase.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace itk
{
/** \class NiftiPictureIO
 * \brief Not installed. Reads a NIfTI-1 file (.nii, .nii.gz) that holds one picture of one value a pixel, which is what
 * programs of segmentation write of a radiograph.
 *
 * ITK's own reader is not used: it goes by the ending of a name, and what was checked has none; it takes what is cut
 * off a compressed file for noughts; and it leaves to the caller which pixel of a picture is the upper left one. The
 * header is a table of fixed places, and the pixels follow it as they are. Documentation/Dependencies.md.
 *
 * NIfTI was made for volumes, and says where the patient's right, front and top are. ITK, and so ITK-SNAP, 3D Slicer,
 * SimpleITK and nnU-Net, write a picture as if its columns ran to the patient's left and its rows to the back; so it is
 * read, as is a file that says nothing about directions. One that was turned over, so that the axes run to the right
 * or the front, and whose last pixel therefore lies where the first one of a picture does, is turned back. Axes that
 * run to the right and the front from a first pixel at the origin are those of an array that was given numpy.eye(4), or
 * only a spacing: they say nothing, and the pixels are taken as they are stored. Of all others it is not known how they
 * lie on the radiograph, and they are refused. */
class NiftiPictureIO : public ImageIOBase
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(NiftiPictureIO);

  using Self = NiftiPictureIO;
  using Superclass = ImageIOBase;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(NiftiPictureIO, ImageIOBase);

  /** Whether the bytes begin, compressed by gzip or not, as a NIfTI-1 file that has its pixels in it. */
  static bool
  IsNifti(std::string_view bytes);

  /** Whether the axes of a file that IsNifti() are those of an array whose directions nobody knew. */
  static bool
  IsOfPlainArray(std::string_view bytes);

  /** Throws DentalInputError for a file that is not whole or not one picture; unpacks what is compressed, as many bytes
   * as its header asks for. */
  static void
  Verify(const std::string & fileName, std::string & bytes);

  bool
  CanReadFile(const char *) override
  {
    return true;
  }
  /** Of a file whose bytes Verify() returned. */
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
  NiftiPictureIO() = default;
  ~NiftiPictureIO() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  /** Whether columns and rows are stored from the other end. */
  std::array<bool, 2> m_IsTurned{ { false, false } };
};
} // namespace itk

#endif

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
#include "itkWritePicture.h"

#include "itkImageFileWriter.h"
#include "itkPNGImageIO.h"
#include "itkWriteThroughMemory.h"

namespace itk
{
void
WritePicture(const Image<RGBPixel<unsigned char>, 2> * picture, const std::string & fileName)
{
  if (picture == nullptr)
  {
    itkGenericExceptionMacro("There is no picture to write to \"" << fileName << "\".");
  }
  if (fileName.empty())
  {
    itkGenericExceptionMacro("The name of the picture's file is empty.");
  }
  using PictureType = Image<RGBPixel<unsigned char>, 2>;
  auto writer = ImageFileWriter<PictureType>::New();
  writer->SetImageIO(PNGImageIO::New());
  writer->SetInput(picture);
  writer->UseCompressionOn();
  WriteThroughMemory(writer.GetPointer(), fileName);
}
} // namespace itk

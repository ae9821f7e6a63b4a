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
#include "itkPictureSizeCheck.h"

#include "itkCephalogramFileReader.h"
#include "itkDentalInputError.h"

namespace itk
{
void
VerifyPictureSize(const std::string & fileName, const Size<2> & size, SizeValueType frames, SizeValueType bytesAPixel)
{
  if (frames > 1)
  {
    itkDentalInputErrorMacro(
      fileName, "", "has " + std::to_string(frames) + " frames, pages or slices", "export that of the one radiograph");
  }
  const std::string text = std::to_string(size[0]) + " x " + std::to_string(size[1]) + " pixels";
  if (size[0] == 0 || size[1] == 0)
  {
    itkDentalInputErrorMacro(fileName, "", "is an image of " + text, "export it again");
  }
  constexpr auto maximum = CephalogramFileReader::MaximumWidthAndHeight;
  if (size[0] > CephalogramFileReader::MaximumNumberOfPixels / size[1] || size[0] > maximum || size[1] > maximum)
  {
    itkDentalInputErrorMacro(fileName, "", "claims to have " + text + ", which no cephalogram has", "export it again");
  }
  if (size[0] * size[1] > CephalogramFileReader::MaximumNumberOfBytes / (bytesAPixel + sizeof(float)))
  {
    itkDentalInputErrorMacro(fileName,
                             "",
                             "claims to have " + text + " of " + std::to_string(bytesAPixel) +
                               " bytes, too many to be read",
                             "export it in grey of 8 or 16 bits, or shrink it");
  }
}
} // namespace itk

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
#ifndef itkPictureSizeCheck_h
#define itkPictureSizeCheck_h

#include "itkSize.h"

#include <cstddef>
#include <string>

namespace itk
{
/** Not installed. Throws DentalInputError for several frames, and for a picture that is none or larger than
 * CephalogramFileReader's constants allow: before as much memory is asked for as a file claims to need.
 *
 * \param bytesAPixel Of all values of a pixel as they are decoded. */
void
VerifyPictureSize(const std::string & fileName, const Size<2> & size, SizeValueType frames, SizeValueType bytesAPixel);
} // namespace itk

#endif

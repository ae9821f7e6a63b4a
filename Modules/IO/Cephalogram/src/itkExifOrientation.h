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
#ifndef itkExifOrientation_h
#define itkExifOrientation_h

#include <string_view>

namespace itk
{
/** Not installed. How a JPEG or PNG has to be turned to be seen upright, by what a camera or an editor writes into it
 * as Exif: 1, as it is, to 8. 1 where it does not say it. Of a JPEG it stands at the beginning; behind the first 256
 * KiB nobody looks for it. */
unsigned int
ReadExifOrientation(std::string_view picture);
} // namespace itk

#endif

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
#ifndef itkJPEGFileCheck_h
#define itkJPEGFileCheck_h

#include <cstddef>
#include <string>

namespace itk
{
/** Not installed. Decodes a JPEG once and throws the pixels away. Returns what is wrong with it, "" for nothing: ITK's
 * reader crashes where libjpeg meets an error in the pixels, and is silent where the pixels end too early. An image of
 * more pixels than given is left alone. */
std::string
FindDefectOfJPEG(const unsigned char * bytes, std::size_t count, std::size_t maximumNumberOfPixels);
} // namespace itk

#endif

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
#ifndef itkTIFFTag_h
#define itkTIFFTag_h

#include <cstdint>
#include <optional>
#include <string>

namespace itk
{
/** Not installed. The first value of a tag in the first directory of a TIFF, and of what a camera writes into a JPEG as
 * Exif, which is the same structure. None for all other files, for one that is not whole, and where there is no such
 * tag, or none of a whole number. */
std::optional<std::uint32_t>
ReadTIFFTag(const std::string & fileName, std::uint32_t tag);

/** Tags of TIFF 6.0. */
constexpr std::uint32_t TIFFPhotometricTag = 262;
constexpr std::uint32_t TIFFOrientationTag = 274;
} // namespace itk

#endif

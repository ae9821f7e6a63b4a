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
#ifndef itkRadiographFileFormat_h
#define itkRadiographFileFormat_h

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace itk
{
/** Not installed: the reader's look at a file before a decoder sees it. */
enum class RadiographFileFormatEnum : uint8_t
{
  PNG,
  JPEG,
  TIFF,
  BMP,
  NRRD,
  MetaImage,
  NIfTI,
  DICOM
};

const char *
ToString(RadiographFileFormatEnum format);

/** By what stands in the file's beginning; throws DentalInputError for a missing, empty or unreadable file, a
 * directory, or one that is none of the formats. */
RadiographFileFormatEnum
DetectRadiographFileFormat(const std::string & fileName);
/** By its bytes, which have been read. */
RadiographFileFormatEnum
DetectRadiographFileFormat(const std::string & fileName, std::string_view bytes);

/** All bytes of a file, of at most 1 GiB; throws DentalInputError. */
std::string
ReadRadiographBytes(const std::string & fileName);

/** Throws DentalInputError where the file is not whole, before a decoder sees it: some of them fill up what is missing
 * and tell nobody, some print, and one aborts the program. NRRD is left to its decoder, which checks; what has more
 * pixels than given is not decoded.
 *
 * Whoever decodes gives these bytes to the decoder and not the file's name, by which another file may be opened
 * meanwhile. The pixels that a header of NRRD or MetaImage names in a file beside it are moved into the bytes, and
 * those of a NIfTI that is compressed are unpacked. */
void
VerifyRadiographFileIsComplete(const std::string &      fileName,
                               std::string &            bytes,
                               RadiographFileFormatEnum format,
                               std::size_t              maximumNumberOfPixels);

/** Leaves of a whole PNG what its pixels are made of: libpng prints the names of what else there is as they are, and
 * unpacks megabytes of it a chunk. Without its transparency, too, where that is not wanted: ITK's reader makes colours
 * of a palette that has such, though its numbers were asked for. Programs of labels write their background so. */
void
KeepChunksOfPixels(std::string & bytes, bool hasTransparency);

/** The header of a NRRD or MetaImage, a line "key: value" or "key = value" each, in lower case, at most 64 KiB. */
std::string
GetRadiographTextHeader(std::string_view bytes);
} // namespace itk

#endif

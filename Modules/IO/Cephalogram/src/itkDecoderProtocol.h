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
#ifndef itkDecoderProtocol_h
#define itkDecoderProtocol_h

#include <cstdint>

namespace itk
{
/** Not installed. What the program dentalscr-decode says to who has started it, over one socket; both are of one build,
 * on one machine.
 *
 * It begins with a Head. Of an image there follow, for each dimension, its size (uint64), its spacing and origin and
 * its direction (doubles); then a text for each name of the dictionary, name and value; then it waits for a byte, and
 * sends the pixels. Of a failure a text follows. A text is its length (uint64) and its letters. */
namespace DecoderProtocol
{
enum class OutcomeEnum : std::uint32_t
{
  Image = 0x64736331,
  Failure,
  OutOfMemory
};

struct Head
{
  OutcomeEnum   outcome;
  std::uint32_t dimensions;
  std::uint32_t components;
  /** IOComponentEnum and IOPixelEnum. */
  std::uint32_t componentType;
  std::uint32_t pixelType;
  std::uint32_t entries;
  /** Of the pixels. */
  std::uint64_t bytes;
};

/** By which the program has the image: it knows no name of a file, and opens none. */
constexpr int FileDescriptor = 3;

/** What a decoder may use. Every image that is read fits: of the most pixels (CephalogramFileReader) in four values of
 * 16 bits it is half a GiB, and some decoders hold it twice. */
constexpr std::uint64_t MemoryLimit = std::uint64_t{ 3 } << 29;
constexpr unsigned int  SecondsLimit = 10;
} // namespace DecoderProtocol
} // namespace itk

#endif

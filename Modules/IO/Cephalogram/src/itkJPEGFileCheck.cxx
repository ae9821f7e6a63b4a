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
#include "itkJPEGFileCheck.h"

#include <csetjmp>
#include <cstdio>
#include <vector>

#include <jerror.h>
#include <jpeglib.h>

namespace itk
{
namespace
{
struct ErrorManager
{
  jpeg_error_mgr base;
  std::jmp_buf   escape;
  char           message[JMSG_LENGTH_MAX];
  bool           isDamaged;
  bool           needsMemory;
};

/** libjpeg wants this not to return; nothing with a destructor lies between here and the setjmp. */
[[noreturn]] void
OnError(j_common_ptr info)
{
  auto * const manager = reinterpret_cast<ErrorManager *>(info->err);
  info->err->format_message(info, manager->message);
  std::longjmp(manager->escape, 1);
}

void
OnMessage(j_common_ptr info, int level)
{
  auto * const manager = reinterpret_cast<ErrorManager *>(info->err);
  if (level >= 0 || manager->isDamaged)
  {
    return;
  }
  switch (info->err->msg_code)
  {
    // Odd, but every pixel is there.
    case JWRN_EXTRANEOUS_DATA:
    case JWRN_JFIF_MAJOR:
    case JWRN_ADOBE_XFORM:
    case JWRN_TOO_MUCH_DATA:
      return;
    default:
      manager->isDamaged = true;
      info->err->format_message(info, manager->message);
  }
}

void
PrintNothing(j_common_ptr)
{}

/** A picture that comes in steps has some ten scans, three dozen at most. A scan that changes nothing has a few hundred
 * bytes and is gone through pixel by pixel, so that half a megabyte of them takes a minute. */
constexpr int LargestNumberOfScans = 64;

void
CountScans(j_common_ptr info)
{
  if (info->is_decompressor != 0 && reinterpret_cast<j_decompress_ptr>(info)->input_scan_number > LargestNumberOfScans)
  {
    auto * const manager = reinterpret_cast<ErrorManager *>(info->err);
    std::snprintf(manager->message, sizeof(manager->message), "it has more than %d scans", LargestNumberOfScans);
    std::longjmp(manager->escape, 1);
  }
}

/** A picture that comes in steps is put together in memory, two bytes a value of each of its colours before it is one:
 * 10,000 x 10,000 in three colours fit, of which all that is done with them fits into a gigabyte. */
constexpr std::size_t LargestCoefficients = std::size_t{ 600 } << 20;

std::size_t
CountBytesOfCoefficients(jpeg_decompress_struct & info)
{
  std::size_t bytes = 0;
  if (jpeg_has_multiple_scans(&info) != FALSE)
  {
    for (int i = 0; i < info.num_components; ++i)
    {
      const jpeg_component_info & component = info.comp_info[i];
      bytes += std::size_t{ component.width_in_blocks } * component.height_in_blocks * sizeof(JBLOCK);
    }
  }
  return bytes;
}

/** Plain C inside, so that a jump skips no destructor. */
void
Decode(ErrorManager &        manager,
       const unsigned char * bytes,
       std::size_t           count,
       std::size_t           maximumNumberOfPixels,
       unsigned char *       row,
       std::size_t           rowSize)
{
  jpeg_decompress_struct info;
  jpeg_progress_mgr      progress{};
  progress.progress_monitor = CountScans;
  info.err = jpeg_std_error(&manager.base);
  manager.base.error_exit = OnError;
  manager.base.emit_message = OnMessage;
  manager.base.output_message = PrintNothing;
  if (setjmp(manager.escape) != 0)
  {
    jpeg_destroy_decompress(&info);
    manager.isDamaged = true;
    return;
  }
  jpeg_create_decompress(&info);
  info.progress = &progress;
  jpeg_mem_src(&info, bytes, static_cast<unsigned long>(count));
  jpeg_read_header(&info, TRUE);
  const std::size_t coefficients = CountBytesOfCoefficients(info);
  if (coefficients > LargestCoefficients)
  {
    manager.needsMemory = true;
    std::snprintf(manager.message,
                  sizeof(manager.message),
                  "comes in steps, which take %lu MiB to be put together (one that is not progressive takes none)",
                  static_cast<unsigned long>(coefficients >> 20));
  }
  else if (info.image_height == 0 || info.image_width <= maximumNumberOfPixels / info.image_height)
  {
    jpeg_start_decompress(&info);
    if (std::size_t{ info.output_width } * static_cast<std::size_t>(info.output_components) <= rowSize)
    {
      while (info.output_scanline < info.output_height)
      {
        JSAMPROW rows[1] = { row };
        jpeg_read_scanlines(&info, rows, 1);
      }
      jpeg_finish_decompress(&info);
    }
  }
  jpeg_destroy_decompress(&info);
}
} // namespace

std::string
FindDefectOfJPEG(const unsigned char * bytes, std::size_t count, std::size_t maximumNumberOfPixels)
{
  // The format has at most 65535 columns, libjpeg at most 10 components.
  std::vector<unsigned char> row(65535u * 10u);
  ErrorManager               manager{};
  Decode(manager, bytes, count, maximumNumberOfPixels, row.data(), row.size());
  return manager.needsMemory ? std::string(manager.message)
         : manager.isDamaged ? "is damaged: " + std::string(manager.message)
                             : std::string();
}
} // namespace itk

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
#include "itkRadiographForPage.h"

#include "itkBase64.h"

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <jpeglib.h>

namespace itk
{
namespace
{
/** Grain beyond this is noise to an eye: a radiograph of 1600 pixels has 200 to 300 kB. */
constexpr int JpegQuality = 82;

struct ErrorManager
{
  jpeg_error_mgr base;
  std::jmp_buf   escape;
};

/** libjpeg wants this not to return; nothing with a destructor lies between here and the setjmp. */
[[noreturn]] void
OnError(j_common_ptr info)
{
  std::longjmp(reinterpret_cast<ErrorManager *>(info->err)->escape, 1);
}

/** Plain C inside, so that a jump skips no destructor. \return false where it failed; the bytes are then null */
bool
Compress(const unsigned char * grey, int width, int height, unsigned char ** bytes, unsigned long * count)
{
  ErrorManager         manager;
  jpeg_compress_struct info;
  info.err = jpeg_std_error(&manager.base);
  manager.base.error_exit = OnError;
  if (setjmp(manager.escape) != 0)
  {
    jpeg_destroy_compress(&info);
    return false;
  }
  jpeg_create_compress(&info);
  jpeg_mem_dest(&info, bytes, count);
  info.image_width = static_cast<JDIMENSION>(width);
  info.image_height = static_cast<JDIMENSION>(height);
  info.input_components = 1;
  info.in_color_space = JCS_GRAYSCALE;
  jpeg_set_defaults(&info);
  jpeg_set_quality(&info, JpegQuality, TRUE);
  jpeg_start_compress(&info, TRUE);
  while (info.next_scanline < info.image_height)
  {
    JSAMPROW row = const_cast<JSAMPROW>(grey + static_cast<std::size_t>(info.next_scanline) * info.image_width);
    jpeg_write_scanlines(&info, &row, 1);
  }
  jpeg_finish_compress(&info);
  jpeg_destroy_compress(&info);
  return true;
}

/** Means of blocks of a whole number of pixels; a border that fills no block is repeated. */
std::vector<float>
Shrink(const float * pixels, std::size_t width, std::size_t height, std::size_t factor)
{
  const std::size_t  columns = (width + factor - 1) / factor;
  const std::size_t  rows = (height + factor - 1) / factor;
  std::vector<float> small(columns * rows);
  for (std::size_t row = 0; row < rows; ++row)
  {
    for (std::size_t column = 0; column < columns; ++column)
    {
      float sum = 0.0F;
      for (std::size_t v = 0; v < factor; ++v)
      {
        for (std::size_t u = 0; u < factor; ++u)
        {
          const float value =
            pixels[std::min(row * factor + v, height - 1) * width + std::min(column * factor + u, width - 1)];
          sum += std::isfinite(value) ? value : 0.0F;
        }
      }
      small[row * columns + column] = sum / static_cast<float>(factor * factor);
    }
  }
  return small;
}

std::vector<unsigned char>
ToGrey(const std::vector<float> & pixels)
{
  // Every seventh is enough for a quantile, and seven divides no width that radiographs have.
  constexpr std::size_t stride = 7;
  std::vector<float>    sample;
  for (std::size_t i = 0; i < pixels.size(); i += stride)
  {
    sample.push_back(pixels[i]);
  }
  const auto quantile = [&](double q) {
    const auto place = sample.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(sample.size() - 1));
    std::nth_element(sample.begin(), place, sample.end());
    return *place;
  };
  const float                black = quantile(0.002);
  const float                white = quantile(0.998);
  const float                scale = white > black ? 255.0F / (white - black) : 0.0F;
  std::vector<unsigned char> grey(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    grey[i] = static_cast<unsigned char>(std::clamp((pixels[i] - black) * scale + 0.5F, 0.0F, 255.0F));
  }
  return grey;
}
} // namespace

RadiographForPage
MakeRadiographForPage(const Image<float, 2> * radiograph, unsigned int maximumSide)
{
  const auto        size = radiograph->GetLargestPossibleRegion().GetSize();
  const std::size_t longer = std::max(size[0], size[1]);
  const std::size_t limit = std::max(1U, maximumSide);
  const std::size_t factor = std::max<std::size_t>(1, (longer + limit - 1) / limit);
  const std::size_t columns = (size[0] + factor - 1) / factor;
  const std::size_t rows = (size[1] + factor - 1) / factor;
  const auto        grey = ToGrey(Shrink(radiograph->GetBufferPointer(), size[0], size[1], factor));
  unsigned char *   bytes = nullptr;
  unsigned long     count = 0;
  const bool        done = Compress(grey.data(), static_cast<int>(columns), static_cast<int>(rows), &bytes, &count);
  RadiographForPage result;
  if (done)
  {
    result.uri = "data:image/jpeg;base64," + EncodeBase64(bytes, count);
    result.width = columns * factor;
    result.height = rows * factor;
  }
  std::free(bytes);
  if (!done)
  {
    itkGenericExceptionMacro("The radiograph of " << size << " pixels cannot be compressed for the page.");
  }
  return result;
}
} // namespace itk

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
#include "itkGreyWindow.h"
#include "itkShrunkImage.h"

#include <algorithm>
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

} // namespace

RadiographForPage
MakeRadiographForPage(const Image<float, 2> * radiograph, unsigned int maximumSide)
{
  const auto        size = radiograph->GetLargestPossibleRegion().GetSize();
  const ShrunkImage small = ShrunkImage::ToFit(radiograph->GetBufferPointer(), size[0], size[1], maximumSide);
  // Every seventh is enough for a quantile, and seven divides no width that radiographs have.
  const auto                 window = GreyWindow::FromQuantiles(small.pixels.data(), small.pixels.size(), 0.002, 7);
  std::vector<unsigned char> grey(small.pixels.size());
  std::transform(
    small.pixels.begin(), small.pixels.end(), grey.begin(), [&window](float value) { return window.ToByte(value); });
  unsigned char * bytes = nullptr;
  unsigned long   count = 0;
  const bool      done =
    Compress(grey.data(), static_cast<int>(small.width), static_cast<int>(small.height), &bytes, &count);
  RadiographForPage result;
  if (done)
  {
    result.uri = "data:image/jpeg;base64," + EncodeBase64(bytes, count);
    result.width = small.width * small.factor;
    result.height = small.height * small.factor;
  }
  std::free(bytes);
  if (!done)
  {
    itkGenericExceptionMacro("The radiograph of " << size << " pixels cannot be compressed for the page.");
  }
  return result;
}
} // namespace itk

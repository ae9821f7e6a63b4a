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
#ifndef itkRunLengthMask_h
#define itkRunLengthMask_h

#include "itkImage.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace itk
{
class JsonNode;

/** \class RunLengthMask
 * \brief Not installed. A mask as COCO writes it: {"size": [height, width], "counts": ...}, the lengths of runs of
 * pixels down the columns, unmarked and marked in turn, as numbers or as COCO's own text of them. */
class RunLengthMask
{
public:
  using ImageType = Image<std::uint8_t, 2>;

  /** Throws DentalInputError at the field that is wrong: where the runs are not those of a picture of that width and
   * height, or where there is no mark.
   *
   * \param size The picture's width and height as the file says them. */
  RunLengthMask(const JsonNode & node, const std::array<std::size_t, 2> & size);

  /** Of a mask as CVAT writes it: runs along the rows of a box of the picture. Throws std::invalid_argument that says
   * what is wrong, where they are not those of the box, it does not lie in the picture, or there is no mark.
   *
   * \param box Column and row of its first pixel, width and height. */
  RunLengthMask(const std::vector<int64_t> &       runs,
                const std::array<int64_t, 4> &     box,
                const std::array<std::size_t, 2> & size);

  /** The marks, 1, with a margin of a pixel around them where the picture has one: most masks are a small part of it.
   */
  const ImageType *
  GetImage() const
  {
    return m_Image;
  }
  /** Where the first pixel of that image lies in the picture. */
  const std::array<double, 2> &
  GetOffset() const
  {
    return m_Offset;
  }

private:
  ImageType::Pointer    m_Image;
  std::array<double, 2> m_Offset{ { 0.0, 0.0 } };
};
} // namespace itk

#endif

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
#include "itkRunLengthMask.h"

#include "itkCephalogramFileReader.h"
#include "itkJsonDocument.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace itk
{
namespace
{
constexpr auto LargestRun = static_cast<int64_t>(CephalogramFileReader::MaximumNumberOfPixels);

/** The text has five bits a character, the lowest first, from '0' on; the sixth says that there are more. From the
 * fourth run on it is the difference from the run before the last. */
std::vector<int64_t>
ReadText(const JsonNode & node)
{
  constexpr const char * remedy = "export the masks again, or as polygons";
  std::vector<int64_t>   runs;
  const std::string &    text = node.AsString();
  for (std::size_t i = 0; i < text.size();)
  {
    int64_t      value = 0;
    unsigned int shift = 0;
    bool         more = true;
    for (; more; ++i, shift += 5)
    {
      // No run needs more than seven characters.
      if (i == text.size() || text[i] < '0' || text[i] > 'o' || shift > 30)
      {
        node.Fail("is no text of runs at its character " + std::to_string(i + 1), remedy);
      }
      const int64_t bits = text[i] - '0';
      value += (bits & 31) * (int64_t{ 1 } << shift);
      more = (bits & 32) != 0;
      if (!more && (bits & 16) != 0)
      {
        value -= int64_t{ 32 } << shift;
      }
    }
    runs.push_back(runs.size() > 2 ? value + runs[runs.size() - 2] : value);
    if (runs.back() < 0 || runs.back() > LargestRun)
    {
      node.Fail("has a run of " + std::to_string(runs.back()) + " pixels", remedy);
    }
  }
  return runs;
}

std::vector<int64_t>
ReadRuns(const JsonNode & node)
{
  if (node.IsString())
  {
    return ReadText(node);
  }
  std::vector<int64_t> runs;
  for (std::size_t i = 0; i < node.GetSize(); ++i)
  {
    runs.push_back(node.At(i).AsInteger(0, LargestRun));
  }
  return runs;
}

/** Calls the function with column, first row and number of pixels of each piece of a marked run that is in one column.
 */
template <typename TFunction>
void
ForEachPiece(const std::vector<int64_t> & runs, int64_t height, const TFunction & function)
{
  int64_t begin = 0;
  for (std::size_t i = 0; i < runs.size(); ++i)
  {
    const int64_t end = begin + runs[i];
    while (i % 2 != 0 && begin < end)
    {
      const int64_t column = begin / height;
      const int64_t pieceEnd = std::min(end, (column + 1) * height);
      function(column, begin - column * height, pieceEnd - begin);
      begin = pieceEnd;
    }
    begin = end;
  }
}
} // namespace

RunLengthMask::RunLengthMask(const JsonNode & node, const std::array<std::size_t, 2> & size)
{
  const JsonNode            sizeNode = node.Get("size");
  const JsonNode            countsNode = node.Get("counts");
  const std::vector<double> stated = sizeNode.AsNumbers(2, "[height, width]");
  if (stated[0] != static_cast<double>(size[1]) || stated[1] != static_cast<double>(size[0]))
  {
    sizeNode.Fail("is not the picture's, [" + std::to_string(size[1]) + ", " + std::to_string(size[0]) + "]",
                  "export the masks in the radiograph's pixel grid");
  }
  if (size[0] > CephalogramFileReader::MaximumNumberOfPixels / size[1])
  {
    sizeNode.Fail("is of more pixels than any cephalogram has", "export the masks in the radiograph's pixel grid");
  }
  const auto                 width = static_cast<int64_t>(size[0]);
  const auto                 height = static_cast<int64_t>(size[1]);
  const std::vector<int64_t> runs = ReadRuns(countsNode);
  const auto                 total = std::accumulate(runs.begin(), runs.end(), int64_t{ 0 });
  if (total != width * height)
  {
    countsNode.Fail("has runs of " + std::to_string(total) + " pixels, and the picture has " +
                      std::to_string(width * height),
                    "export the masks again");
  }
  int64_t first[2] = { width, height };
  int64_t last[2] = { -1, -1 };
  ForEachPiece(runs, height, [&](int64_t column, int64_t row, int64_t count) {
    first[0] = std::min(first[0], column);
    last[0] = std::max(last[0], column);
    first[1] = std::min(first[1], row);
    last[1] = std::max(last[1], row + count - 1);
  });
  if (last[0] < 0)
  {
    countsNode.Fail("marks no pixel", "delete the empty mask, or draw it");
  }
  ImageType::SizeType box;
  for (unsigned int i = 0; i < 2; ++i)
  {
    // The margin is of the picture as well: where marks reach its edge there is none.
    first[i] = std::max<int64_t>(first[i] - 1, 0);
    last[i] = std::min(last[i] + 1, static_cast<int64_t>(size[i]) - 1);
    box[i] = static_cast<SizeValueType>(last[i] - first[i] + 1);
    m_Offset[i] = static_cast<double>(first[i]);
  }
  m_Image = ImageType::New();
  m_Image->SetRegions(ImageType::RegionType(box));
  m_Image->Allocate(true);
  ForEachPiece(runs, height, [&](int64_t column, int64_t row, int64_t count) {
    const auto     stride = static_cast<std::ptrdiff_t>(box[0]);
    std::uint8_t * pixel = m_Image->GetBufferPointer() + (row - first[1]) * stride + (column - first[0]);
    for (; count > 0; --count, pixel += stride)
    {
      *pixel = 1;
    }
  });
}

RunLengthMask::RunLengthMask(const std::vector<int64_t> &       runs,
                             const std::array<int64_t, 4> &     box,
                             const std::array<std::size_t, 2> & size)
{
  // Each is compared before they are added, so that none overflows.
  for (std::size_t i = 0; i < 2; ++i)
  {
    const auto extent = static_cast<int64_t>(size[i]);
    if (box[i] < 0 || box[i + 2] < 1 || box[i] > extent || box[i + 2] > extent - box[i])
    {
      throw std::invalid_argument("the mask does not lie in the picture");
    }
  }
  if (size[0] > CephalogramFileReader::MaximumNumberOfPixels / size[1])
  {
    throw std::invalid_argument("the picture is of more pixels than any cephalogram has");
  }
  int64_t total = 0;
  int64_t marked = 0;
  for (std::size_t i = 0; i < runs.size(); ++i)
  {
    if (runs[i] < 0 || runs[i] > box[2] * box[3] - total)
    {
      throw std::invalid_argument("the mask has runs of more pixels than its box");
    }
    total += runs[i];
    marked += i % 2 != 0 ? runs[i] : 0;
  }
  if (total != box[2] * box[3])
  {
    throw std::invalid_argument("the mask has runs of " + std::to_string(total) + " pixels, and its box " +
                                std::to_string(box[2] * box[3]));
  }
  if (marked == 0)
  {
    throw std::invalid_argument("the mask marks no pixel");
  }
  ImageType::SizeType imageSize;
  int64_t             first[2];
  for (unsigned int i = 0; i < 2; ++i)
  {
    first[i] = std::max<int64_t>(box[i] - 1, 0);
    const int64_t last = std::min(box[i] + box[i + 2], static_cast<int64_t>(size[i]) - 1);
    imageSize[i] = static_cast<SizeValueType>(last - first[i] + 1);
    m_Offset[i] = static_cast<double>(first[i]);
  }
  m_Image = ImageType::New();
  m_Image->SetRegions(ImageType::RegionType(imageSize));
  m_Image->Allocate(true);
  const auto           stride = static_cast<int64_t>(imageSize[0]);
  std::uint8_t * const origin = m_Image->GetBufferPointer() + (box[1] - first[1]) * stride + (box[0] - first[0]);
  int64_t              at = 0;
  for (std::size_t i = 0; i < runs.size(); ++i)
  {
    for (const int64_t end = at + runs[i]; at < end; ++at)
    {
      origin[(at / box[2]) * stride + at % box[2]] = i % 2 != 0 ? 1 : 0;
    }
  }
}
} // namespace itk

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
#include "itkMidlineSide.h"

#include <gtest/gtest.h>

namespace
{
TEST(SelectMidlineSide, PutsEachTriangleOnItsSideAndTheStripOnBoth)
{
  itk::TriangleSurface surface;
  for (const double y : { -3.0, -0.2, 0.2, 3.0 })
  {
    const auto first = static_cast<std::uint32_t>(surface.points.size());
    surface.points.push_back({ { 0.0, 10.0 + y, 0.0 } });
    surface.points.push_back({ { 1.0, 10.0 + y, 0.0 } });
    surface.points.push_back({ { 0.0, 10.0 + y, 1.0 } });
    surface.triangles.push_back({ { first, first + 1, first + 2 } });
  }
  using Mask = std::vector<std::uint8_t>;
  EXPECT_EQ(itk::SelectMidlineSide(surface, { { 0, 1, 0 } }, { { 0, 10, 0 } }, 1.0, 0.0), (Mask{ 1, 1, 0, 0 }));
  EXPECT_EQ(itk::SelectMidlineSide(surface, { { 0, 1, 0 } }, { { 0, 10, 0 } }, 1.0, 0.5), (Mask{ 1, 1, 1, 0 }));
  EXPECT_EQ(itk::SelectMidlineSide(surface, { { 0, 1, 0 } }, { { 0, 10, 0 } }, -1.0, 0.5), (Mask{ 0, 1, 1, 1 }));
}
} // namespace

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
#include "itkKeepTriangles.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace
{
TEST(KeepTriangles, KeepsTheMarkedOnesWithTheirPoints)
{
  itk::TriangleSurface surface;
  for (double x = 0.0; x < 5.0; x += 1.0)
  {
    surface.points.push_back({ { x, x * x, 0.0 } });
  }
  surface.triangles = { { { 0, 1, 2 } }, { { 1, 2, 3 } }, { { 4, 3, 2 } } };
  const auto kept = itk::KeepTriangles(surface, { 1, 0, 1 });
  ASSERT_EQ(kept.triangles.size(), 2u);
  ASSERT_EQ(kept.points.size(), 5u);
  const unsigned int from[2] = { 0, 2 };
  for (unsigned int t = 0; t < 2; ++t)
  {
    for (unsigned int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(kept.points[kept.triangles[t][k]], surface.points[surface.triangles[from[t]][k]]);
    }
  }
  EXPECT_EQ(itk::KeepTriangles(surface, { 1, 0, 0 }).points.size(), 3u);
  EXPECT_TRUE(itk::KeepTriangles(surface, { 0, 0, 0 }).points.empty());
  EXPECT_THROW(itk::KeepTriangles(surface, { 1 }), std::invalid_argument);
}
} // namespace

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
#include "itkShrunkImage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

TEST(ShrunkImage, IsTheImageWhereItFits)
{
  const std::vector<float> pixels{ 1, 2, 3, 4, 5, 6 };
  const auto               small = itk::ShrunkImage::ToFit(pixels.data(), 3, 2, 3);
  EXPECT_EQ(small.factor, 1u);
  EXPECT_EQ(small.width, 3u);
  EXPECT_EQ(small.height, 2u);
  EXPECT_EQ(small.pixels, pixels);
}

TEST(ShrunkImage, HasMeansOfBlocksAndOfWhatThereIsAtTheEdge)
{
  const float              none = std::numeric_limits<float>::quiet_NaN();
  const std::vector<float> pixels{ 1, 2, 3,    4,    5,    //
                                   6, 7, 8,    9,    none, //
                                   1, 3, none, none, 9 };
  const auto               small = itk::ShrunkImage::ToFit(pixels.data(), 5, 3, 3);
  EXPECT_EQ(small.factor, 2u);
  ASSERT_EQ(small.width, 3u);
  ASSERT_EQ(small.height, 2u);
  EXPECT_EQ(small.pixels[0], 4.0F);
  EXPECT_EQ(small.pixels[1], 6.0F);
  EXPECT_EQ(small.pixels[2], 5.0F);
  EXPECT_EQ(small.pixels[3], 2.0F);
  EXPECT_TRUE(std::isnan(small.pixels[4]));
  EXPECT_EQ(small.pixels[5], 9.0F);
}

TEST(ShrunkImage, KeepsBothSidesWithinTheLimit)
{
  EXPECT_EQ(itk::ShrunkImage::FindFactor(1600, 1200, 1600), 1u);
  EXPECT_EQ(itk::ShrunkImage::FindFactor(1200, 1601, 1600), 2u);
  EXPECT_EQ(itk::ShrunkImage::FindFactor(5000, 10, 1600), 4u);
  EXPECT_EQ(itk::ShrunkImage::FindFactor(5, 3, 0), 5u);
}

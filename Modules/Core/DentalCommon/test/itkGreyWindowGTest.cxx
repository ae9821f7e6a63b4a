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
#include "itkGreyWindow.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

TEST(GreyWindow, IsBetweenQuantilesOfWhatIsFinite)
{
  std::vector<float> pixels(1001);
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    pixels[i] = static_cast<float>((i * 5) % 1001);
  }
  pixels.push_back(std::numeric_limits<float>::infinity());
  pixels.push_back(std::numeric_limits<float>::quiet_NaN());
  const auto window = itk::GreyWindow::FromQuantiles(pixels.data(), pixels.size(), 0.01);
  EXPECT_EQ(window.black, 10.0);
  EXPECT_EQ(window.white, 990.0);
  EXPECT_EQ(window.ToByte(10.0), 0);
  EXPECT_EQ(window.ToByte(-1e9), 0);
  EXPECT_EQ(window.ToByte(990.0), 255);
  EXPECT_EQ(window.ToByte(1e9), 255);
  EXPECT_EQ(window.ToByte(500.0), 128);
  EXPECT_EQ(window.ToByte(std::numeric_limits<double>::quiet_NaN()), 0);
}

TEST(GreyWindow, LooksAtOneOfSoManyPixels)
{
  const std::vector<float> pixels{ 1.0F, 900.0F, 3.0F, 900.0F, 5.0F };
  const auto               window = itk::GreyWindow::FromQuantiles(pixels.data(), pixels.size(), 0.0, 2);
  EXPECT_EQ(window.black, 1.0);
  EXPECT_EQ(window.white, 5.0);
}

TEST(GreyWindow, ShowsWhatLittleThereIs)
{
  // Both quantiles are 0: the one pixel that differs is seen all the same.
  std::vector<float> pixels(1000, 0.0F);
  pixels[3] = 8.0F;
  const auto window = itk::GreyWindow::FromQuantiles(pixels.data(), pixels.size(), 0.01);
  EXPECT_EQ(window.ToByte(0.0), 0);
  EXPECT_EQ(window.ToByte(8.0), 255);
  const std::vector<float> flat(10, 3.0F);
  const auto               none = itk::GreyWindow::FromQuantiles(flat.data(), flat.size(), 0.01);
  EXPECT_EQ(none.ToByte(3.0), 0);
  const auto empty = itk::GreyWindow::FromQuantiles(nullptr, 0, 0.01);
  EXPECT_EQ(empty.black, 0.0);
  EXPECT_EQ(empty.white, 1.0);
}

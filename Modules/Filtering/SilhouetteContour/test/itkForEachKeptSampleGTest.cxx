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
#include "itkForEachKeptSample.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace
{
using WalkType = std::vector<std::pair<std::size_t, bool>>;

WalkType
Walk(const std::vector<char> & keep)
{
  WalkType walk;
  itk::ForEachKeptSample(keep, [&](std::size_t i, bool begins) { walk.emplace_back(i, begins); });
  return walk;
}
} // namespace

TEST(ForEachKeptSample, ARunOverTheFirstPointIsOneRun)
{
  EXPECT_EQ(Walk({ 1, 1, 0, 1, 0, 0, 1 }), (WalkType{ { 3, true }, { 6, true }, { 0, false }, { 1, false } }));
}

TEST(ForEachKeptSample, WithoutAGapItBeginsAtTheFirst)
{
  EXPECT_EQ(Walk({ 1, 1, 1 }), (WalkType{ { 0, true }, { 1, false }, { 2, false } }));
}

TEST(ForEachKeptSample, WhatHasNothingToKeepIsNotWalked)
{
  EXPECT_TRUE(Walk({ 0, 0, 0 }).empty());
  EXPECT_TRUE(Walk({}).empty());
}

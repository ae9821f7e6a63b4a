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
#include "itkLandmarkMatrixProjectionFilter.h"
#include "itkMessageOfCall.h"

#include <gtest/gtest.h>

#include <string>

namespace
{
using FilterType = itk::LandmarkMatrixProjectionFilter;
using LandmarksType = FilterType::LandmarksType;
using JawEnum = FilterType::JawEnum;

LandmarksType::Pointer
MakeLandmarks()
{
  auto                     landmarks = LandmarksType::New();
  LandmarksType::PointType point;
  point[0] = 1.0;
  point[1] = 2.0;
  point[2] = 4.0;
  landmarks->AddLandmark("UR6_MB", point);
  landmarks->AddLandmark("LR6_MB", point);
  point[2] = 8.0;
  landmarks->AddLandmark("UR1_tip", point);
  return landmarks;
}

/** u = (10 x + 5) / (z / 4), v = (100 y - 20) / (z / 4). */
FilterType::ProjectionMatrixType
MakeMatrix()
{
  FilterType::ProjectionMatrixType matrix;
  matrix.Fill(0.0);
  matrix(0, 0) = 10.0;
  matrix(0, 3) = 5.0;
  matrix(1, 1) = 100.0;
  matrix(1, 3) = -20.0;
  matrix(2, 2) = 0.25;
  return matrix;
}
} // namespace

TEST(LandmarkMatrixProjectionFilter, ProjectsThoseOfTheJawInTheirOrder)
{
  auto filter = FilterType::New();
  filter->SetLandmarks(MakeLandmarks());
  filter->SetProjectionMatrix(MakeMatrix());
  filter->SetJaw(JawEnum::Upper);
  filter->Update();
  const auto & upper = filter->GetOutput()->GetLandmarks();
  ASSERT_EQ(upper.size(), 2U);
  EXPECT_EQ(upper[0].name, "UR6_MB");
  EXPECT_EQ(upper[0].point[0], 15.0);
  EXPECT_EQ(upper[0].point[1], 180.0);
  EXPECT_EQ(upper[1].name, "UR1_tip");
  EXPECT_EQ(upper[1].point[0], 7.5);
  EXPECT_EQ(upper[1].point[1], 90.0);
  filter->SetJaw(JawEnum::Unknown);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfLandmarks(), 3U);
}

TEST(LandmarkMatrixProjectionFilter, SaysWhatIsMissing)
{
  const auto message = [](FilterType * filter) { return itk::MessageOfCall([&] { filter->Update(); }); };
  auto       filter = FilterType::New();
  EXPECT_NE(message(filter).find("SetLandmarks()"), std::string::npos);
  filter->SetLandmarks(MakeLandmarks());
  EXPECT_NE(message(filter).find("SetProjectionMatrix()"), std::string::npos);

  // A matrix that puts a landmark beside the source's plane has no place for it.
  auto matrix = MakeMatrix();
  matrix(2, 3) = -1.0;
  filter->SetProjectionMatrix(matrix);
  const std::string beside = message(filter);
  EXPECT_NE(beside.find("UR6_MB"), std::string::npos) << beside;
  EXPECT_NE(beside.find("SetProjectionMatrix()"), std::string::npos) << beside;
}

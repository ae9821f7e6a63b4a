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
#include "itkPoseToothPlaces.h"

#include "itkPoseArch.h"

#include <gtest/gtest.h>

#include <vector>

namespace
{
/** Teeth drawn as short lines, one behind the other, by FDI number. */
itk::PoseToothPlaces
Place(const std::vector<std::uint8_t> & teeth)
{
  itk::DentalContour::PolylinesType lines;
  double                            u = 400.0;
  for (const std::uint8_t tooth : teeth)
  {
    itk::DentalContour::PolylineType line;
    for (int i = 0; i < 9; ++i)
    {
      itk::DentalContour::PointType point;
      point[0] = u - i;
      point[1] = 100.0;
      line.points.push_back(point);
    }
    u -= 30.0;
    line.code = itk::ToothCode(tooth);
    lines.push_back(line);
  }
  const auto jaw = teeth.front() < 30 ? itk::ToothCode::JawEnum::Upper : itk::ToothCode::JawEnum::Lower;
  return itk::PoseToothPlaces(itk::PoseTracing(itk::PoseGeometry(), lines, jaw));
}

double
Textbook(std::uint8_t tooth)
{
  return itk::PoseArch::CurveShare * itk::PoseArch::ExpectedArc(tooth);
}
} // namespace

TEST(PoseToothPlaces, AreTheTextbooksAsFarAsTheFirstPremolar)
{
  const auto places = Place({ 11, 12, 13, 14 });
  for (const std::uint8_t tooth : { 11, 12, 13, 14 })
  {
    EXPECT_EQ(places.GetArc(tooth % 10), Textbook(tooth)) << int(tooth);
    EXPECT_GT(places.GetArc(tooth % 10), 0.0) << int(tooth);
  }
  EXPECT_EQ(places.GetArc(5), 0.0) << "was not drawn";
  EXPECT_EQ(places.GetArc(9), 0.0) << "is none";
}

TEST(PoseToothPlaces, TeethBehindTheFirstPremolarHaveNone)
{
  const auto places = Place({ 41, 42, 43, 44, 45, 46, 47 });
  EXPECT_EQ(places.GetArc(4), Textbook(44));
  for (const unsigned int position : { 5, 6, 7 })
  {
    EXPECT_EQ(places.GetArc(position), 0.0) << position;
  }
}

TEST(PoseToothPlaces, BehindAnExtractedFirstPremolarTeethHaveNone)
{
  // Its gap may be closed.
  const auto places = Place({ 13, 15, 16 });
  EXPECT_EQ(places.GetArc(3), Textbook(13));
  EXPECT_EQ(places.GetArc(5), 0.0);
  EXPECT_EQ(places.GetArc(6), 0.0);
}

TEST(PoseToothPlaces, WithoutCanineAndFirstPremolarTheForemostToothBehindHasTheTextbooks)
{
  const auto places = Place({ 11, 16, 17, 18 });
  EXPECT_EQ(places.GetArc(1), Textbook(11));
  EXPECT_EQ(places.GetArc(6), Textbook(16));
  EXPECT_EQ(places.GetArc(7), 0.0);
  EXPECT_EQ(places.GetArc(8), 0.0) << "a third molar's place is not settled";
}

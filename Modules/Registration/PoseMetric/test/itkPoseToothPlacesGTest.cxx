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

#include <map>

namespace
{
constexpr double PixelsPerMillimetre = 1674.0 / 1524.0 / 0.25;

/** Teeth drawn as horizontal lines of 2 mm, by FDI number the distance of their middle behind the central incisor in
 * the side view, mm. */
itk::PoseToothPlaces
Place(const std::map<std::uint8_t, double> & teeth)
{
  itk::DentalContour::PolylinesType lines;
  for (const auto & tooth : teeth)
  {
    itk::DentalContour::PolylineType line;
    for (int i = -4; i <= 4; ++i)
    {
      itk::DentalContour::PointType point;
      point[0] = 400.0 - PixelsPerMillimetre * (tooth.second + 0.25 * i);
      point[1] = 100.0;
      line.points.push_back(point);
    }
    line.code = itk::ToothCode(tooth.first);
    lines.push_back(line);
  }
  const itk::PoseGeometry geometry;
  const auto jaw = teeth.begin()->first < 30 ? itk::ToothCode::JawEnum::Upper : itk::ToothCode::JawEnum::Lower;
  return { geometry, itk::PoseTracing(geometry, lines, jaw) };
}

double
Textbook(std::uint8_t tooth)
{
  return itk::PoseArch::CurveShare * itk::PoseArch::ExpectedArc(tooth);
}

/** mm: of rounding alone. */
constexpr double Exact = 1e-9;
} // namespace

TEST(PoseToothPlaces, AreTheTextbooksAsFarAsTheFirstPremolar)
{
  const auto places = Place({ { 11, 0.0 }, { 12, 2.0 }, { 13, 5.0 }, { 14, 9.0 } });
  for (const std::uint8_t tooth : { 11, 12, 13, 14 })
  {
    EXPECT_NEAR(places.GetArc(tooth % 10), Textbook(tooth), Exact) << int(tooth);
  }
  EXPECT_EQ(places.GetArc(5), 0.0) << "was not drawn";
  EXPECT_EQ(places.GetArc(9), 0.0) << "is none";
}

TEST(PoseToothPlaces, BehindTheFirstPremolarAreAsFarApartAsTheyWereDrawn)
{
  // A milk molar of 10 mm in the second premolar's place pushes the molars back by 3 mm.
  const auto places = Place({ { 43, 5.0 }, { 44, 10.0 }, { 45, 18.5 }, { 46, 29.0 }, { 47, 40.0 } });
  EXPECT_NEAR(places.GetArc(5), Textbook(44) + 8.5, 1e-6);
  EXPECT_NEAR(places.GetArc(6), Textbook(44) + 19.0, 1e-6);
  EXPECT_NEAR(places.GetArc(7), Textbook(44) + 30.0, 1e-6);
}

TEST(PoseToothPlaces, OfAnExtractedPremolarKnowWhetherItsGapIsClosed)
{
  // The canine's middle is 5 mm back, the second premolar's 6 mm or 12 mm behind it: closed or kept open. The side view
  // shows 0.78 of that way.
  const double closed = Place({ { 13, 5.0 }, { 15, 11.0 }, { 16, 20.0 } }).GetArc(6);
  const double open = Place({ { 13, 5.0 }, { 15, 17.0 }, { 16, 26.0 } }).GetArc(6);
  EXPECT_NEAR(open - closed, 6.0 / 0.78, 1e-6);
  EXPECT_NEAR(closed, Textbook(13) + 6.0 / 0.78 + 9.0, 1e-6);
  EXPECT_LT(closed, Textbook(16) - 4.0) << "the textbook's place would look like a slip";
}

TEST(PoseToothPlaces, WithoutTheCanineAreTheTextbooks)
{
  const auto places = Place({ { 11, 0.0 }, { 16, 25.0 }, { 17, 36.0 }, { 18, 46.0 } });
  EXPECT_NEAR(places.GetArc(6), Textbook(16), Exact);
  EXPECT_NEAR(places.GetArc(7), Textbook(16) + 11.0, 1e-6);
  EXPECT_EQ(places.GetArc(8), 0.0) << "a third molar's place is not settled";
}

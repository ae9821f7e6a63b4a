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
#include "itkPoseTracing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
itk::DentalContour::PointType
MakePoint(double u, double v)
{
  itk::DentalContour::PointType point;
  point[0] = u;
  point[1] = v;
  return point;
}
} // namespace

TEST(PoseTracing, NormalsPointOcclusallyAndArcRunsOverGaps)
{
  itk::PoseGeometry geometry;
  geometry.pixelSpacing = { { 0.25, 0.25 } };
  itk::DentalContour::PolylinesType lines(2);
  for (int i = 0; i <= 10; ++i)
  {
    lines[0].points.push_back(MakePoint(50.0 - i, 7.0));
    // The second tooth is drawn back to front.
    lines[1].points.push_back(MakePoint(20.0 + i, 7.0));
  }
  lines[0].code = itk::ToothCode(13);
  lines[1].code = itk::ToothCode(14);
  const itk::PoseTracing upper(geometry, lines, itk::ToothCode::JawEnum::Upper);
  ASSERT_EQ(upper.Size(), 22u);
  EXPECT_NEAR(upper.arc.back(), 30.0, 1e-12);
  EXPECT_NEAR(upper.length, 20.0, 1e-12);
  for (std::size_t i = 0; i < upper.Size(); ++i)
  {
    EXPECT_NEAR(upper.nu[i], 0.0, 1e-9);
    EXPECT_NEAR(upper.nv[i], 1.0, 1e-9);
  }
  const itk::PoseTracing lower(geometry, lines, itk::ToothCode::JawEnum::Lower);
  EXPECT_NEAR(lower.nv[3], -1.0, 1e-9);
}

TEST(PoseTracing, NormalsOfALabialBorderAloneFaceForward)
{
  itk::PoseGeometry geometry;
  geometry.pixelSpacing = { { 0.25, 0.25 } };
  // Incisors that lean forward: the labial border of the lower ones faces down as well, that of the upper ones up.
  itk::DentalContour::PolylineType lower, upper;
  for (int i = 0; i <= 20; ++i)
  {
    lower.points.push_back(MakePoint(100.0 - 0.5 * i, 50.0 + i));
    upper.points.push_back(MakePoint(100.0 - 0.5 * i, 50.0 - i));
  }
  const itk::PoseTracing lowerTracing(geometry, { lower }, itk::ToothCode::JawEnum::Lower);
  const itk::PoseTracing upperTracing(geometry, { upper }, itk::ToothCode::JawEnum::Upper);
  for (std::size_t i = 0; i < lowerTracing.Size(); ++i)
  {
    EXPECT_GT(lowerTracing.nu[i], 0.8);
    EXPECT_GT(upperTracing.nu[i], 0.8);
  }
}

TEST(PoseTracing, ClosedCrownKeepsItsOcclusalPart)
{
  itk::PoseGeometry geometry;
  geometry.pixelSpacing = { { 0.25, 0.25 } };
  itk::DentalContour::PolylineType circle;
  circle.closed = true;
  for (int i = 0; i < 72; ++i)
  {
    circle.points.push_back(MakePoint(20.0 * std::cos(i * M_PI / 36.0), 20.0 * std::sin(i * M_PI / 36.0)));
  }
  const itk::PoseTracing tracing(geometry, { circle }, itk::ToothCode::JawEnum::Upper);
  EXPECT_GT(tracing.Size(), 30u);
  EXPECT_LT(tracing.Size(), 50u);
  for (std::size_t i = 0; i < tracing.Size(); ++i)
  {
    // Down or to the front, and outward.
    EXPECT_TRUE(tracing.v[i] > 2.0 || tracing.u[i] > 2.0);
    EXPECT_GT(tracing.nu[i] * tracing.u[i] + tracing.nv[i] * tracing.v[i], 0.0);
  }
}

namespace
{
/** A crown as a box of 40 by 60 px, the corner of the front and the neck at (u, 0). Of an upper tooth: down is
 * occlusal.
 */
itk::DentalContour::PolylineType
MakeCrown(double u, unsigned int code)
{
  itk::DentalContour::PolylineType crown;
  crown.closed = true;
  crown.code = itk::ToothCode(code);
  for (int i = 0; i < 60; ++i)
  {
    crown.points.push_back(MakePoint(u, i));
  }
  for (int i = 0; i < 40; ++i)
  {
    crown.points.push_back(MakePoint(u - i, 60.0));
  }
  for (int i = 0; i < 60; ++i)
  {
    crown.points.push_back(MakePoint(u - 40.0, 60.0 - i));
  }
  for (int i = 0; i < 40; ++i)
  {
    crown.points.push_back(MakePoint(u - 40.0 + i, 0.0));
  }
  return crown;
}

/** Points of a tooth more than 6 px above its biting edge, on its side to the front: a contact, or the labial border.
 */
std::size_t
CountAtTheSide(const itk::PoseTracing & tracing, unsigned int code, double u)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < tracing.Size(); ++i)
  {
    count += tracing.tooth[i] == code && std::abs(tracing.u[i] - u) < 0.01 && tracing.v[i] < 54.0 ? 1 : 0;
  }
  return count;
}
} // namespace

TEST(PoseTracing, SidesOfCrownsThatTheirNeighboursHideAreNoOutline)
{
  itk::PoseGeometry geometry;
  geometry.pixelSpacing = { { 0.25, 0.25 } };
  const auto Make = [&geometry](const itk::DentalContour::PolylinesType & lines) {
    return itk::PoseTracing(geometry, lines, itk::ToothCode::JawEnum::Upper, 0);
  };
  // Which order and which way round is not the point: the same border, as label maps have it; a gap of half a
  // millimetre; an overlap, as masks of each tooth by itself have it.
  for (const double gap : { 0.0, 2.0, -6.0 })
  {
    const auto             front = MakeCrown(100.0, 11);
    auto                   behind = MakeCrown(60.0 - gap, 12);
    const itk::PoseTracing row = Make({ front, behind });
    EXPECT_GT(CountAtTheSide(row, 11, 100.0), 50u) << gap;
    EXPECT_EQ(CountAtTheSide(row, 12, 60.0 - gap), 0u) << gap;
    std::reverse(behind.points.begin(), behind.points.end());
    EXPECT_EQ(Make({ behind, front }).Size(), row.Size()) << gap;
    // All of both biting edges is there but what lies in the other crown.
    std::size_t edge = 0;
    for (std::size_t i = 0; i < row.Size(); ++i)
    {
      edge += row.v[i] > 59.5 ? 1 : 0;
    }
    EXPECT_GE(edge, 80u - 2u * 6u - 2u) << gap;
  }
  // A gap of two millimetres between teeth is seen, and what is drawn of one tooth twice hides nothing.
  EXPECT_GT(CountAtTheSide(Make({ MakeCrown(100.0, 11), MakeCrown(52.0, 12) }), 12, 52.0), 50u);
  EXPECT_GT(CountAtTheSide(Make({ MakeCrown(100.0, 11), MakeCrown(98.0, 11) }), 11, 98.0), 50u);
  // An open line ends where it was ended by hand.
  auto open = MakeCrown(60.0, 12);
  open.closed = false;
  EXPECT_EQ(Make({ MakeCrown(100.0, 11), open }).Size(), Make({ MakeCrown(100.0, 11) }).Size() + open.points.size());
}

TEST(PoseTracing, ASigmaOfTheFileStandsForTheUsualJitterAndAWeightDividesIt)
{
  itk::PoseGeometry geometry;
  // Half a working pixel: 1.2 px of the picture are the usual 0.6 of the working plane.
  geometry.pixelSpacing = { { 0.125, 0.125 } };
  itk::DentalContour::PolylineType line;
  for (int i = 0; i < 5; ++i)
  {
    line.points.push_back(MakePoint(50.0 - i, 7.0));
  }
  line.weights = { 1.0, 1.0, 0.5, 1.0, 1.0 };
  line.sigmas = { 1.2, 2.4, 2.4, 0.0, 0.01 };
  const itk::PoseTracing tracing(geometry, { line }, itk::ToothCode::JawEnum::Upper);
  ASSERT_EQ(tracing.Size(), 5u);
  EXPECT_NEAR(tracing.weight[0], 1.0, 1e-12);
  EXPECT_NEAR(tracing.weight[1], 0.25, 1e-12);
  EXPECT_NEAR(tracing.weight[2], 0.125, 1e-12);
  // Nobody said one, and one that no hand has.
  EXPECT_NEAR(tracing.weight[3], 1.0, 1e-12);
  EXPECT_NEAR(tracing.weight[4], 4.0, 1e-12);
}

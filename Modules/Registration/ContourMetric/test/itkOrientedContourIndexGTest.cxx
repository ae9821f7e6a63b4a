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
#include "itkOrientedContourIndex.h"

#include "itkReproducibleRandom.h"

#include "itkGTest.h"

#include <cmath>

namespace
{
/** Points of a wavy curve as polylines of these lengths; the last one is closed where wanted. */
itk::ContourArrays
MakeContour(const std::vector<std::size_t> & lengths, bool closeLast)
{
  itk::ContourArrays contour;
  double             t = 0.0;
  std::uint8_t       code = 11;
  for (std::size_t k = 0; k < lengths.size(); ++k)
  {
    const auto first = static_cast<std::uint32_t>(contour.GetNumberOfPoints());
    for (std::size_t i = 0; i < lengths[k]; ++i)
    {
      const auto id = static_cast<std::uint32_t>(contour.GetNumberOfPoints());
      contour.points.push_back(100.0 * std::cos(0.05 * t) + 3.0 * std::sin(t));
      contour.points.push_back(60.0 * std::sin(0.05 * t));
      contour.codes.push_back(code);
      if (i > 0)
      {
        contour.segments.push_back(id - 1);
        contour.segments.push_back(id);
      }
      t += 1.0;
    }
    if (closeLast && k + 1 == lengths.size())
    {
      contour.segments.push_back(static_cast<std::uint32_t>(contour.GetNumberOfPoints() - 1));
      contour.segments.push_back(first);
    }
    t += 3.0;
    code = static_cast<std::uint8_t>(code == 18 ? 11 : code + 1);
  }
  return contour;
}
} // namespace

TEST(ContourStrand, FindsPolylinesClosedOnesAndLonePoints)
{
  itk::ContourArrays contour = MakeContour({ 5, 1, 6 }, true);
  // The segments in another order and direction.
  std::vector<std::uint32_t> segments;
  for (std::size_t k = contour.segments.size(); k > 0; k -= 2)
  {
    segments.push_back(contour.segments[k - 1]);
    segments.push_back(contour.segments[k - 2]);
  }
  contour.segments = segments;
  const auto strands = itk::ContourStrand::FindAll(contour);
  ASSERT_EQ(strands.size(), 3u);
  EXPECT_EQ(strands[0].ids, (std::vector<std::uint32_t>{ 0, 1, 2, 3, 4 }));
  EXPECT_FALSE(strands[0].closed);
  EXPECT_EQ(strands[1].ids, std::vector<std::uint32_t>{ 5 });
  EXPECT_EQ(strands[1].GetNumberOfSegments(), 0u);
  EXPECT_TRUE(strands[2].closed);
  EXPECT_EQ(strands[2].ids.size(), 6u);
  EXPECT_EQ(strands[2].GetNumberOfSegments(), 6u);

  // A point without weight cuts; three segments in a point make three strands.
  contour = MakeContour({ 7 }, false);
  contour.weights.assign(7, 1.0);
  contour.weights[3] = 0.0;
  EXPECT_EQ(itk::ContourStrand::FindAll(contour).size(), 2u);
  contour.weights.clear();
  contour.segments.insert(contour.segments.end(), { 3, 0 });
  std::size_t points = 0;
  for (const auto & strand : itk::ContourStrand::FindAll(contour))
  {
    points += strand.GetNumberOfSegments();
  }
  EXPECT_EQ(points, 7u);
}

TEST(ContourStrand, DirectionsFollowTheContourAndForgetItsNoise)
{
  itk::ReproducibleRandom random(2);
  itk::ContourArrays      circle;
  for (std::uint32_t i = 0; i < 200; ++i)
  {
    const double t = 2.0 * 3.14159265358979 * i / 200.0;
    circle.points.push_back(100.0 * std::cos(t) + random.Normal(0.0, 0.4));
    circle.points.push_back(100.0 * std::sin(t) + random.Normal(0.0, 0.4));
    circle.segments.insert(circle.segments.end(), { i, (i + 1) % 200 });
  }
  const auto strands = itk::ContourStrand::FindAll(circle);
  ASSERT_EQ(strands.size(), 1u);
  const auto error = [&](double sigma) {
    const auto directions = strands[0].GetSegmentDirections(circle, sigma);
    double     sum = 0.0;
    for (std::size_t i = 0; i < 200; ++i)
    {
      const double t = 2.0 * 3.14159265358979 * (static_cast<double>(i) + 0.5) / 200.0;
      sum += std::pow(directions[2 * i] * std::cos(t) + directions[2 * i + 1] * std::sin(t), 2);
    }
    return std::sqrt(sum / 200.0);
  };
  EXPECT_GT(error(0.0), 0.1);
  EXPECT_LT(error(8.0), 0.04);
}

TEST(OrientedContourIndex, FindsWhatBruteForceFinds)
{
  const itk::ContourArrays  contour = MakeContour({ 40, 1, 25, 1, 30 }, true);
  const auto                strands = itk::ContourStrand::FindAll(contour);
  itk::OrientedContourIndex index;
  index.Initialize(contour, strands, 3.0);
  EXPECT_EQ(index.GetTargets().size(), 39u + 24u + 30u + 2u);
  itk::ReproducibleRandom random(4);
  for (int query = 0; query < 3000; ++query)
  {
    const double       far = query % 3 == 0 ? 2000.0 : 120.0;
    const double       x = random.Uniform(-far, far);
    const double       y = random.Uniform(-far, far);
    const double       angle = random.Uniform(0.0, 6.3);
    const double       weight = query % 2 == 0 ? 0.0 : random.Uniform(0.0, 400.0);
    const std::uint8_t code = static_cast<std::uint8_t>(query % 5 == 0 ? 0 : 11 + query % 8);
    const auto         allowed = itk::OrientedContourIndex::GetAllowedCodes(code, query % 3);
    double             best = std::numeric_limits<double>::infinity();
    std::uint32_t      first = 0;
    for (std::uint32_t k = 0; k < index.GetTargets().size(); ++k)
    {
      const auto & t = index.GetTargets()[k];
      if ((t.code & allowed) == 0)
      {
        continue;
      }
      const double part = std::min(1.0, std::max(0.0, ((x - t.x) * t.dx + (y - t.y) * t.dy) * t.inverseSquaredLength));
      const double dx = t.x + part * t.dx - x;
      const double dy = t.y + part * t.dy - y;
      const double sine = std::cos(angle) * t.directionY - std::sin(angle) * t.directionX;
      const double total = dx * dx + dy * dy + weight * sine * sine;
      if (total < best)
      {
        best = total;
        first = k;
      }
    }
    const auto match = index.Find(x, y, std::cos(angle), std::sin(angle), weight, allowed);
    EXPECT_EQ(match.squaredDistance, best);
    if (best < std::numeric_limits<double>::infinity())
    {
      EXPECT_EQ(match.target, first);
      const auto & t = index.GetTargets()[first];
      EXPECT_NEAR(match.x, t.x + match.part * t.dx, 1e-12);
      EXPECT_NEAR(match.squaredPositionDistance, std::pow(match.x - x, 2) + std::pow(match.y - y, 2), 1e-6);
    }
  }
}

TEST(OrientedContourIndex, KnowsToothNeighbours)
{
  using Index = itk::OrientedContourIndex;
  const auto allows = [](std::uint8_t a, std::uint8_t b, unsigned int range) {
    return (Index::GetAllowedCodes(a, range) & Index::GetCodeMask(b)) != 0;
  };
  EXPECT_TRUE(allows(11, 11, 0));
  EXPECT_TRUE(allows(11, 21, 0));
  EXPECT_TRUE(allows(11, 22, 1));
  EXPECT_FALSE(allows(11, 13, 1));
  EXPECT_FALSE(allows(11, 41, 8));
  EXPECT_FALSE(allows(31, 18, 8));
  EXPECT_TRUE(allows(48, 41, 7));
  EXPECT_TRUE(allows(0, 37, 0));
  EXPECT_TRUE(allows(37, 0, 0));
  EXPECT_EQ(Index::GetCodeMask(99), Index::GetCodeMask(0));
}

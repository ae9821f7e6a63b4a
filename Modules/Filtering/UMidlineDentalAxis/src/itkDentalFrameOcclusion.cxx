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
#include "itkDentalFrameOcclusion.h"

#include "itkFlatKdTree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace itk
{
namespace DentalFrameKernel
{
Contact
FindContact(const Samples & upper, const Samples & lower)
{
  Contact    contact;
  const auto measure = [](const Samples & from, const Samples & to) {
    const FlatKdTree<3> tree(to.points);
    std::vector<double> distances;
    distances.reserve(from.points.size());
    std::uint32_t guess = FlatKdTree<3>::None;
    for (const Vector3 & p : from.points)
    {
      double squared = std::numeric_limits<double>::infinity();
      guess = tree.Nearest(p, squared, guess);
      distances.push_back(std::sqrt(squared));
    }
    return distances;
  };
  contact.upperDistances = measure(upper, lower);
  contact.lowerDistances = measure(lower, upper);
  std::vector<double> all = contact.upperDistances;
  all.insert(all.end(), contact.lowerDistances.begin(), contact.lowerDistances.end());
  contact.distance = Quantile(all, 0.12);
  const double limit = std::max(1.0, contact.distance);
  Vector3      mean{ 0.0, 0.0, 0.0 };
  double       count = 0.0;
  const auto   visit = [&](auto && body) {
    for (std::size_t i = 0; i < upper.points.size(); ++i)
    {
      if (contact.upperDistances[i] <= limit)
      {
        body(upper.points[i]);
      }
    }
    for (std::size_t i = 0; i < lower.points.size(); ++i)
    {
      if (contact.lowerDistances[i] <= limit)
      {
        body(lower.points[i]);
      }
    }
  };
  visit([&](const Vector3 & p) {
    mean = mean + p;
    count += 1.0;
  });
  mean = (1.0 / std::max(1.0, count)) * mean;
  Matrix3 covariance{};
  visit([&](const Vector3 & p) {
    const Vector3 d = p - mean;
    for (unsigned int r = 0; r < 3; ++r)
    {
      for (unsigned int c = 0; c < 3; ++c)
      {
        covariance[r][c] += d[r] * d[c];
      }
    }
  });
  Vector3 values;
  Matrix3 vectors;
  SymmetricEigen(covariance, values, vectors);
  contact.direction = Dot(vectors[0], upper.centroid - lower.centroid) < 0.0 ? -1.0 * vectors[0] : vectors[0];
  return contact;
}

namespace
{
double
AngleBetween(const Vector3 & a, const Vector3 & b)
{
  return std::atan2(Norm(Cross(a, b)), Dot(a, b)) / Degree;
}
} // namespace

bool
VerticalsFit(const Jaw & upper, const Jaw & lower, const Contact & contact, DentalFrameResult & result)
{
  const Vector3 z = Unit(upper.Superior() + lower.Superior());
  result.contactDistance = contact.distance;
  result.verticalSeparation = Dot(upper.samples.centroid - lower.samples.centroid, z);
  result.verticalDisagreement = AngleBetween(upper.Superior(), lower.Superior());
  std::vector<double> crowns;
  for (const std::uint32_t i : upper.vertical.crowns)
  {
    crowns.push_back(contact.upperDistances[i]);
  }
  for (const std::uint32_t i : lower.vertical.crowns)
  {
    crowns.push_back(contact.lowerDistances[i]);
  }
  result.crownDistance = Quantile(crowns, 0.12);
  result.crownPlaneGap = Dot(upper.vertical.centre - lower.vertical.centre, z);
  return result.crownDistance < 8.0 && result.verticalSeparation > 1.0 && result.verticalDisagreement < 25.0 &&
         result.crownPlaneGap > -8.0 && result.crownPlaneGap < 14.0;
}

/** The whole test: one arch over the other as well. */
bool
TestOcclusion(const Jaw & upper, const Jaw & lower, const Contact & contact, DentalFrameResult & result)
{
  const bool    verticalsFit = VerticalsFit(upper, lower, contact, result);
  const Vector3 z = Unit(upper.Superior() + lower.Superior());
  const Vector3 between = upper.arch.centre - lower.arch.centre;
  result.anteriorDisagreement = AngleBetween(upper.arch.anterior, lower.arch.anterior);
  result.archCentreDistance = Norm(between - Dot(between, z) * z);
  return verticalsFit && result.archCentreDistance < 15.0;
}
} // namespace DentalFrameKernel
} // namespace itk

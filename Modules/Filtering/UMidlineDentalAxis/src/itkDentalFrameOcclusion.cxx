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
  const auto measure = [](const Samples & from, const Samples & to, std::vector<std::uint32_t> & nearest) {
    const FlatKdTree<3> tree(to.points);
    std::vector<double> distances;
    distances.reserve(from.points.size());
    std::uint32_t guess = FlatKdTree<3>::None;
    for (const Vector3 & p : from.points)
    {
      double squared = std::numeric_limits<double>::infinity();
      guess = tree.Nearest(p, squared, guess);
      distances.push_back(std::sqrt(squared));
      nearest.push_back(guess);
    }
    return distances;
  };
  contact.upperDistances = measure(upper, lower, contact.upperNearest);
  contact.lowerDistances = measure(lower, upper, contact.lowerNearest);
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
/** mm within which a sample is near the other jaw where the two touch. Where they stand apart, the contact's own
 * distance and 2 mm. */
constexpr double NearOtherJaw = 4.0;
/** mm below the surface that counts as inside: twice what scans are put together with, and the samples' spacing. */
constexpr double DeepInside = 1.0;
/** Share of what is near the other jaw that may lie inside it. In right pairs it is some 1 %, and up to 9 % where a
 * deep bite lays the incisors' edges beside each other, at which a nearest sample's normal says little; of pairs that
 * were put at one origin 20 % and more. */
constexpr double MostInside = 0.14;
/** mm that a crown may be from the border of its shell and be near it. */
constexpr double NearRim = 3.0;

double
AngleBetween(const Vector3 & a, const Vector3 & b)
{
  return std::atan2(Norm(Cross(a, b)), Dot(a, b)) / Degree;
}

/** Share of the samples near the other jaw that lie inside it. Each sample's nearest one of the other jaw stands for
 * the surface there: a tooth that meets its antagonist is on its outer side, whatever the depth of the bite, while of
 * two jaws that were both moved to the origin about a third of what is near lies inside. */
double
MeasureInterpenetration(const Jaw & upper, const Jaw & lower, const Contact & contact)
{
  std::size_t near = 0;
  std::size_t inside = 0;
  const auto  count = [&](const Samples &                    from,
                         const std::vector<double> &        distances,
                         const std::vector<std::uint32_t> & nearest,
                         const Samples &                    to) {
    for (std::size_t i = 0; i < from.points.size(); ++i)
    {
      if (distances[i] < std::max(NearOtherJaw, contact.distance + 2.0))
      {
        ++near;
        inside += Dot(from.points[i] - to.points[nearest[i]], to.normals[nearest[i]]) < -DeepInside ? 1 : 0;
      }
    }
  };
  count(upper.samples, contact.upperDistances, contact.upperNearest, lower.samples);
  count(lower.samples, contact.lowerDistances, contact.lowerNearest, upper.samples);
  return near == 0 ? 0.0 : static_cast<double>(inside) / static_cast<double>(near);
}

/** Median distance between the rings of crowns, seen along the vertical: where one arch lies over the other each crown
 * has one of the other jaw a few mm beside it. */
double
MeasureArchDistance(const Jaw & upper, const Jaw & lower, const Vector3 & z)
{
  Vector3    e1 = UnitRejection(std::abs(z[0]) < 0.6 ? Vector3{ 1.0, 0.0, 0.0 } : Vector3{ 0.0, 1.0, 0.0 }, z);
  Vector3    e2 = Cross(z, e1);
  const auto flatten = [&](const Jaw & jaw) {
    std::vector<std::array<double, 2>> points;
    for (const std::uint32_t i : jaw.vertical.crowns)
    {
      points.push_back({ Dot(jaw.samples.points[i], e1), Dot(jaw.samples.points[i], e2) });
    }
    return points;
  };
  const auto          u = flatten(upper);
  const auto          l = flatten(lower);
  std::vector<double> distances;
  const auto          measure = [&](const auto & from, const auto & to) {
    const FlatKdTree<2> tree(to);
    for (const auto & p : from)
    {
      double squared = std::numeric_limits<double>::infinity();
      tree.Nearest(p, squared);
      distances.push_back(std::sqrt(squared));
    }
  };
  measure(u, l);
  measure(l, u);
  return Quantile(distances, 0.5);
}
} // namespace

double
OcclusalLook(const Jaw & jaw, const std::vector<Vector3> & rim)
{
  const auto & crowns = jaw.vertical.crowns;
  if (crowns.empty() || rim.empty())
  {
    return 0.0;
  }
  const FlatKdTree<3> tree(rim);
  double              roughness = 0.0;
  double              atRim = 0.0;
  for (const std::uint32_t i : crowns)
  {
    double squared = NearRim * NearRim;
    atRim += tree.Nearest(jaw.samples.points[i], squared) != FlatKdTree<3>::None ? 1.0 : 0.0;
    roughness += jaw.samples.roughness[i];
  }
  const double size = static_cast<double>(crowns.size());
  return roughness / (size * std::max(1e-9, jaw.samples.meanRoughness)) - 2.0 * atRim / size;
}

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
  using FindingEnum = DentalFrameEnums::OcclusionFinding;
  result.occlusionFinding = result.verticalDisagreement >= 25.0                           ? FindingEnum::NotOpposed
                            : result.crownDistance >= 8.0 || result.crownPlaneGap >= 14.0 ? FindingEnum::FarApart
                            : result.verticalSeparation <= 1.0 || result.crownPlaneGap <= -8.0
                              ? FindingEnum::NotOverEachOther
                              : FindingEnum::InOcclusion;
  return result.occlusionFinding == FindingEnum::InOcclusion;
}

/** The whole test: one arch over the other as well, and neither inside the other. */
bool
TestOcclusion(const Jaw & upper, const Jaw & lower, const Contact & contact, DentalFrameResult & result)
{
  using FindingEnum = DentalFrameEnums::OcclusionFinding;
  const bool    verticalsFit = VerticalsFit(upper, lower, contact, result);
  const Vector3 z = Unit(upper.Superior() + lower.Superior());
  const Vector3 between = upper.arch.centre - lower.arch.centre;
  result.anteriorDisagreement = AngleBetween(upper.arch.anterior, lower.arch.anterior);
  result.archCentreDistance = Norm(between - Dot(between, z) * z);
  result.archDistance = MeasureArchDistance(upper, lower, z);
  result.interpenetration = MeasureInterpenetration(upper, lower, contact);
  if (verticalsFit && result.archDistance >= 6.0)
  {
    result.occlusionFinding = FindingEnum::ArchesBesideEachOther;
  }
  else if (verticalsFit && result.interpenetration >= MostInside)
  {
    result.occlusionFinding = FindingEnum::Interpenetrating;
  }
  return result.occlusionFinding == FindingEnum::InOcclusion;
}
} // namespace DentalFrameKernel
} // namespace itk

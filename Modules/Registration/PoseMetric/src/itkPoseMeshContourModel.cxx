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
#include "itkPoseMeshContourModel.h"

#include "itkMeshSilhouette.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
// How the two sides of an arch are paired, for the middle of their outlines (Documentation/Robust.md, step 1). What is
// paired is one tooth with its namesake: their places differ by the asymmetry of an arch, some millimetres, and by less
// than a tooth, some 7 mm.
/** mm, in place and direction together, within which the other side's namesake is looked for. */
constexpr double PairingReach = 4.0;
/** Weight of the difference in height: the sides differ most there, as where the occlusal plane is canted. */
constexpr double PairingHeightWeight = 0.5;
/** mm a unit normal: opposite flanks of a cusp, whose normals are 2 apart, are as far as the reach and never paired. */
constexpr double PairingNormalWeight = 2.0;
/** px: the differences of partners are smoothed along the run with this sigma, as the pairing jumps from sample to
 * sample and the anatomy does not, which changes over a tooth of some 28 px. */
constexpr double SmoothingSigma = 3.0;
/** Samples to either side that the smoothing sees: at a spacing of half a pixel three sigma. */
constexpr std::size_t SmoothingReach = 18;

/** Of the box around both; none of surfaces without a point. */
std::vector<std::array<double, 3>>
MakeCorners(const TriangleSurface & surface, const TriangleSurface * other)
{
  std::array<std::array<double, 3>, 2> box{};
  bool                                 isEmpty = true;
  for (const TriangleSurface * each : { &surface, other })
  {
    if (each == nullptr)
    {
      continue;
    }
    for (const auto & point : each->points)
    {
      for (unsigned int d = 0; d < 3; ++d)
      {
        const double x = point[d];
        box[0][d] = isEmpty ? x : std::min(box[0][d], x);
        box[1][d] = isEmpty ? x : std::max(box[1][d], x);
      }
      isEmpty = false;
    }
  }
  std::vector<std::array<double, 3>> corners;
  for (unsigned int corner = 0; !isEmpty && corner < 8; ++corner)
  {
    corners.push_back({ { box[corner & 1][0], box[(corner >> 1) & 1][1], box[(corner >> 2) & 1][2] } });
  }
  return corners;
}
} // namespace

PoseMeshContourModel::PoseMeshContourModel(const TriangleSurface & surface,
                                           ToothCode::JawEnum      jaw,
                                           bool                    useFacingFilter)
  : m_Silhouette(std::make_unique<MeshSilhouette>(surface))
  , m_Corners(MakeCorners(surface, nullptr))
  , m_Jaw(jaw)
  , m_UseFacingFilter(useFacingFilter)
{}

PoseMeshContourModel::PoseMeshContourModel(const TriangleSurface & surface,
                                           const TriangleSurface & other,
                                           ToothCode::JawEnum      jaw,
                                           bool                    useFacingFilter)
  : m_Silhouette(std::make_unique<MeshSilhouette>(surface))
  , m_Other(std::make_unique<MeshSilhouette>(other))
  , m_Corners(MakeCorners(surface, &other))
  , m_Jaw(jaw)
  , m_UseFacingFilter(useFacingFilter)
{}

PoseMeshContourModel::~PoseMeshContourModel() = default;

OpenSilhouette
PoseMeshContourModel::ComputeOpen(const MeshSilhouette & silhouette, const PoseModel & model) const
{
  OpenSilhouetteOptions options;
  options.jaw = m_Jaw;
  options.direction = model.GetGeometry().direction;
  options.pitch = options.direction == CephalometricDirectionEnum::Lateral ? model.GetParameters()[PosePitch] : 0.0;
  options.spacing = Spacing;
  options.facingOnly = m_UseFacingFilter;
  return ComputeOpenSilhouette(silhouette, model.GetProjection(), options);
}

PoseContour
PoseMeshContourModel::Compute(const PoseModel & model) const
{
  VerifyPlaces(model, m_Corners);
  PoseContour contour;
  static_cast<OpenSilhouette &>(contour) = this->ComputeOpen(*m_Silhouette, model);
  if (!m_Other)
  {
    return contour;
  }
  const OpenSilhouette other = this->ComputeOpen(*m_Other, model);
  // Pair each point with the nearest of the other side in (x, |y|, z / 2, 2 mm normal).
  const std::size_t        n = contour.Size();
  std::vector<double>      du(n), dv(n);
  std::vector<long>        partner(n, -1);
  std::vector<std::size_t> order(other.Size());
  for (std::size_t j = 0; j < order.size(); ++j)
  {
    order[j] = j;
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return other.rim[a][0] != other.rim[b][0] ? other.rim[a][0] < other.rim[b][0] : a < b;
  });
  for (std::size_t i = 0; i < n; ++i)
  {
    const auto & p = contour.rim[i];
    double       best = PairingReach * PairingReach;
    auto         it = std::lower_bound(
      order.begin(), order.end(), p[0] - PairingReach, [&](std::size_t j, double x) { return other.rim[j][0] < x; });
    for (; it != order.end() && other.rim[*it][0] < p[0] + PairingReach; ++it)
    {
      const auto & q = other.rim[*it];
      const double dx = p[0] - q[0];
      const double dy = std::abs(p[1]) - std::abs(q[1]);
      const double dz = PairingHeightWeight * (p[2] - q[2]);
      const double dn = contour.nu[i] * other.nu[*it] + contour.nv[i] * other.nv[*it];
      const double d = dx * dx + dy * dy + dz * dz + PairingNormalWeight * PairingNormalWeight * (2.0 - 2.0 * dn);
      if (d < best)
      {
        best = d;
        partner[i] = static_cast<long>(*it);
      }
    }
    if (partner[i] >= 0)
    {
      du[i] = other.u[partner[i]] - contour.u[i];
      dv[i] = other.v[partner[i]] - contour.v[i];
    }
  }
  PoseContour mean;
  for (std::size_t r = 0; r < contour.runs.size(); ++r)
  {
    const std::size_t begin = contour.runs[r];
    const std::size_t end = r + 1 < contour.runs.size() ? contour.runs[r + 1] : n;
    bool              open = false;
    for (std::size_t i = begin; i < end; ++i)
    {
      if (partner[i] < 0)
      {
        open = false;
        continue;
      }
      double            sw = 0.0, su = 0.0, sv = 0.0;
      const std::size_t reach = SmoothingReach;
      for (std::size_t j = i > begin + reach ? i - reach : begin; j < std::min(end, i + reach + 1); ++j)
      {
        if (partner[j] >= 0)
        {
          const double d = Spacing * (static_cast<double>(j) - static_cast<double>(i));
          const double w = std::exp(-d * d / (2.0 * SmoothingSigma * SmoothingSigma));
          sw += w;
          su += w * du[j];
          sv += w * dv[j];
        }
      }
      const std::size_t j = static_cast<std::size_t>(partner[i]);
      double            nu = contour.nu[i] + other.nu[j];
      double            nv = contour.nv[i] + other.nv[j];
      const double      length = std::hypot(nu, nv);
      if (length < 1e-9)
      {
        open = false;
        continue;
      }
      if (!open)
      {
        mean.runs.push_back(mean.u.size());
        open = true;
      }
      mean.u.push_back(contour.u[i] + 0.5 * su / sw);
      mean.v.push_back(contour.v[i] + 0.5 * sv / sw);
      mean.nu.push_back(nu / length);
      mean.nv.push_back(nv / length);
      mean.rim.push_back(contour.rim[i]);
      mean.rimOther.push_back(other.rim[j]);
    }
  }
  return mean;
}
} // namespace itk

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
#include "itkPoseContourModel.h"

#include "itkMeshSilhouette.h"
#include "itkPoseTracing.h"

#include <algorithm>
#include <cmath>

namespace itk
{
PoseContourModel::PoseContourModel(const TriangleSurface & surface, bool upper, bool useFacingFilter)
  : m_Silhouette(std::make_unique<MeshSilhouette>(surface))
  , m_Upper(upper)
  , m_UseFacingFilter(useFacingFilter)
{}

PoseContourModel::PoseContourModel(const TriangleSurface & surface,
                                   const TriangleSurface & other,
                                   bool                    upper,
                                   bool                    useFacingFilter)
  : m_Silhouette(std::make_unique<MeshSilhouette>(surface))
  , m_Other(std::make_unique<MeshSilhouette>(other))
  , m_Upper(upper)
  , m_UseFacingFilter(useFacingFilter)
{}

PoseContourModel::~PoseContourModel() = default;
PoseContourModel::PoseContourModel(PoseContourModel &&) noexcept = default;
PoseContourModel &
PoseContourModel::operator=(PoseContourModel &&) noexcept = default;

PoseContour
PoseContourModel::ComputeOpen(const MeshSilhouette & silhouette, const PoseModel & model) const
{
  PoseContour                 contour;
  const PerspectiveProjection projection = model.GetProjection();
  const Silhouette            boundary = silhouette.ComputeOuterBoundary(projection);
  const double                cosPitch = std::cos(model.GetParameters()[PosePitch]);
  const double                sinPitch = std::sin(model.GetParameters()[PosePitch]);
  const double                largest = boundary.loops.empty() ? 0.0 : boundary.loops.front().Area();
  for (const SilhouetteLoop & loop : boundary.loops)
  {
    // Specks are no anatomy.
    if (loop.Area() < 0.02 * largest)
    {
      continue;
    }
    const std::vector<SilhouetteSample> samples = ResampleSilhouetteLoopBySpacing(loop, projection, Spacing);
    const std::size_t                   n = samples.size();
    if (n < 8)
    {
      continue;
    }
    // The polygon has the mesh's facets: tangents over +-1.5 px.
    std::vector<double> nu(n), nv(n);
    std::vector<char>   keep(n);
    for (std::size_t i = 0; i < n; ++i)
    {
      double tu = 0.0, tv = 0.0;
      for (std::size_t d = 1; d <= 3; ++d)
      {
        const SilhouetteSample & a = samples[(i + n - d) % n];
        const SilhouetteSample & b = samples[(i + d) % n];
        tu += b.u - a.u;
        tv += b.v - a.v;
      }
      const double length = std::hypot(tu, tv);
      nu[i] = length > 1e-9 ? tv / length : samples[i].normal[0];
      nv[i] = length > 1e-9 ? -tu / length : samples[i].normal[1];
      keep[i] = !m_UseFacingFilter ||
                PoseTracing::Faces(cosPitch * nu[i] + sinPitch * nv[i], -sinPitch * nu[i] + cosPitch * nv[i], m_Upper);
    }
    // Begin behind a gap, so that no run is split at the loop's first point.
    std::size_t begin = 0;
    while (begin < n && keep[begin])
    {
      ++begin;
    }
    bool open = false;
    for (std::size_t k = 0; k < n; ++k)
    {
      const std::size_t i = (begin + k) % n;
      if (!keep[i])
      {
        open = false;
        continue;
      }
      if (!open)
      {
        contour.runs.push_back(contour.u.size());
        open = true;
      }
      contour.u.push_back(samples[i].u);
      contour.v.push_back(samples[i].v);
      contour.nu.push_back(nu[i]);
      contour.nv.push_back(nv[i]);
      contour.rim.push_back(samples[i].rim);
    }
  }
  return contour;
}

PoseContour
PoseContourModel::Compute(const PoseModel & model) const
{
  PoseContour contour = this->ComputeOpen(*m_Silhouette, model);
  if (!m_Other)
  {
    return contour;
  }
  const PoseContour other = this->ComputeOpen(*m_Other, model);
  // Pair each point with the nearest of the other side in (x, |y|, z / 2, 2 mm normal); z is where the sides differ
  // most.
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
    double       best = 16.0;
    auto         it = std::lower_bound(
      order.begin(), order.end(), p[0] - 4.0, [&](std::size_t j, double x) { return other.rim[j][0] < x; });
    for (; it != order.end() && other.rim[*it][0] < p[0] + 4.0; ++it)
    {
      const auto & q = other.rim[*it];
      const double dx = p[0] - q[0];
      const double dy = std::abs(p[1]) - std::abs(q[1]);
      const double dz = 0.5 * (p[2] - q[2]);
      const double dn = contour.nu[i] * other.nu[*it] + contour.nv[i] * other.nv[*it];
      const double d = dx * dx + dy * dy + dz * dz + 4.0 * (2.0 - 2.0 * dn);
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
      // The differences smoothed along the run, sigma 3 px: the pairing jumps, the anatomy does not.
      double            sw = 0.0, su = 0.0, sv = 0.0;
      const std::size_t reach = 18;
      for (std::size_t j = i > begin + reach ? i - reach : begin; j < std::min(end, i + reach + 1); ++j)
      {
        if (partner[j] >= 0)
        {
          const double d = Spacing * (static_cast<double>(j) - static_cast<double>(i));
          const double w = std::exp(-d * d / 18.0);
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

void
PoseContourModel::Reproject(PoseContour & contour, const PoseModel & from, const PoseModel & to)
{
  const double turn = to.GetParameters()[PosePitch] - from.GetParameters()[PosePitch];
  const double c = std::cos(turn);
  const double s = std::sin(turn);
  for (std::size_t i = 0; i < contour.Size(); ++i)
  {
    // The change of the surface points' projections: a middle contour keeps its smoothing.
    double before[2], after[2];
    from.Project(contour.rim[i].data(), before);
    to.Project(contour.rim[i].data(), after);
    double du = after[0] - before[0];
    double dv = after[1] - before[1];
    if (!contour.rimOther.empty())
    {
      from.Project(contour.rimOther[i].data(), before);
      to.Project(contour.rimOther[i].data(), after);
      du = 0.5 * (du + after[0] - before[0]);
      dv = 0.5 * (dv + after[1] - before[1]);
    }
    contour.u[i] += du;
    contour.v[i] += dv;
    const double nu = contour.nu[i];
    contour.nu[i] = c * nu - s * contour.nv[i];
    contour.nv[i] = s * nu + c * contour.nv[i];
  }
}
} // namespace itk

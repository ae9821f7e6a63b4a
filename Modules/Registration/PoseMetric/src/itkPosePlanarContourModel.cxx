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
#include "itkPosePlanarContourModel.h"

#include "itkContourResampling.h"
#include "itkForEachKeptSample.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
using Point2 = std::array<double, 2>;

/** Normals are those of chords over this many samples to both sides, as those of a scan's outline are. */
constexpr std::size_t TangentReach = 3;

/** Points every PoseContourModel::Spacing px along a polyline; the ends of an open one are kept. */
std::vector<Point2>
Resample(const std::vector<Point2> & points, bool closed)
{
  const double length = ComputePolylineLength(points, closed);
  if (!(length > 0.0))
  {
    return { points.front() };
  }
  const auto steps = static_cast<std::size_t>(std::max(1.0, std::floor(length / PoseContourModel::Spacing + 0.5)));
  std::vector<Point2> samples;
  for (const ContourPosition & position : ResamplePolyline(points, closed, closed ? steps : steps + 1))
  {
    const Point2 & p = points[position.segment];
    const Point2 & q = points[(position.segment + 1) % points.size()];
    samples.push_back({ { p[0] + position.share * (q[0] - p[0]), p[1] + position.share * (q[1] - p[1]) } });
  }
  return samples;
}

/** Unit normals (v, -u of the tangent), turned outward. */
std::vector<Point2>
MakeNormals(const std::vector<Point2> & samples, bool closed, ToothCode::JawEnum jaw)
{
  const std::size_t   n = samples.size();
  std::vector<Point2> normals(n, { { 0.0, 0.0 } });
  double              area = 0.0;
  double              outward = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::size_t reach = std::min(TangentReach, (n - 1) / 2);
    const Point2 &    a = closed ? samples[(i + n - reach) % n] : samples[i >= reach ? i - reach : 0];
    const Point2 &    b = closed ? samples[(i + reach) % n] : samples[std::min(n - 1, i + reach)];
    const double      length = std::hypot(b[0] - a[0], b[1] - a[1]);
    if (length > 1e-9)
    {
      normals[i] = { { (b[1] - a[1]) / length, -(b[0] - a[0]) / length } };
    }
    outward += normals[i][0] + (jaw == ToothCode::JawEnum::Upper ? normals[i][1] : -normals[i][1]);
    const Point2 & next = samples[(i + 1) % n];
    area += samples[i][0] * next[1] - samples[i][1] * next[0];
  }
  if (closed ? area < 0.0 : outward < 0.0)
  {
    for (Point2 & normal : normals)
    {
      normal = { { -normal[0], -normal[1] } };
    }
  }
  return normals;
}

/** The point of the plane y = 0 that is seen at w. */
std::array<double, 3>
Lift(const PerspectiveProjection & projection, const Point2 & w)
{
  // (row_u - u row_3).(x, 0, z, 1) = 0 and the same of v.
  const auto & a = projection.matrix;
  double       m[2][3];
  for (int k = 0; k < 2; ++k)
  {
    m[k][0] = a[4 * k] - w[k] * a[8];
    m[k][1] = a[4 * k + 2] - w[k] * a[10];
    m[k][2] = a[4 * k + 3] - w[k] * a[11];
  }
  const double determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
  return { { (m[0][1] * m[1][2] - m[1][1] * m[0][2]) / determinant,
             0.0,
             (m[1][0] * m[0][2] - m[0][0] * m[1][2]) / determinant } };
}
} // namespace

PosePlanarContourModel::PosePlanarContourModel(const PoseGeometry &                 geometry,
                                               const DentalContour::PolylinesType & outline,
                                               const PoseParameters &               pose,
                                               ToothCode::JawEnum                   jaw,
                                               bool                                 useFacingFilter)
  : m_Drawn(geometry, pose)
{
  const PerspectiveProjection projection = m_Drawn.GetProjection();
  const double                c = std::cos(pose[PosePitch]);
  const double                s = std::sin(pose[PosePitch]);
  for (const DentalContour::PolylineType & polyline : outline)
  {
    if (polyline.points.empty())
    {
      continue;
    }
    std::vector<Point2> points;
    for (const auto & pixel : polyline.points)
    {
      points.push_back(PoseModel::ToWorkingPlane(geometry, { { pixel[0], pixel[1] } }));
    }
    const bool                closed = polyline.closed && points.size() > 2;
    const std::vector<Point2> samples = Resample(points, closed);
    const std::vector<Point2> normals = MakeNormals(samples, closed, jaw);
    const std::size_t         n = samples.size();
    std::vector<char>         keep(n, 1);
    if (closed && useFacingFilter)
    {
      for (std::size_t i = 0; i < n; ++i)
      {
        // Facing is judged in the dental frame's own plane.
        keep[i] = FacesOcclusallyOrAnteriorly(
          c * normals[i][0] + s * normals[i][1], -s * normals[i][0] + c * normals[i][1], jaw);
      }
    }
    ForEachKeptSample(keep, [&](std::size_t i, bool begins) {
      if (begins)
      {
        m_Contour.runs.push_back(m_Contour.u.size());
      }
      m_Contour.u.push_back(samples[i][0]);
      m_Contour.v.push_back(samples[i][1]);
      m_Contour.nu.push_back(normals[i][0]);
      m_Contour.nv.push_back(normals[i][1]);
      m_Contour.rim.push_back(Lift(projection, samples[i]));
      m_Contour.position.push_back(static_cast<std::uint8_t>(polyline.code.GetPosition()));
    });
  }
}

PoseContour
PosePlanarContourModel::Compute(const PoseModel & model) const
{
  PoseContour contour = m_Contour;
  Reproject(contour, m_Drawn, model);
  return contour;
}
} // namespace itk

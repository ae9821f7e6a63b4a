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
#include "itkMeshSilhouette.h"

#include "itkContourResampling.h"
#include "itkSilhouetteArrangement.h"
#include "itkSilhouetteEdges.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace itk
{
namespace
{
using Vector3 = std::array<double, 3>;

/** The point of a mesh edge that projects to a given share of the way between its projected ends. */
Vector3
PointOnEdge(const Vector3 & a, double depthA, const Vector3 & b, double depthB, double t)
{
  const double lambda = t * depthA / (t * depthA + (1.0 - t) * depthB);
  return { a[0] + lambda * (b[0] - a[0]), a[1] + lambda * (b[1] - a[1]), a[2] + lambda * (b[2] - a[2]) };
}
} // namespace

class MeshSilhouette::Implementation : public SilhouetteEdges
{
public:
  using SilhouetteEdges::SilhouetteEdges;
};

MeshSilhouette::MeshSilhouette(const TriangleSurface & surface, PosesEnum poses)
  : m_Implementation(std::make_unique<Implementation>(surface))
{
  if (poses == PosesEnum::Many)
  {
    this->ClusterEdges();
  }
}

void
MeshSilhouette::ClusterEdges()
{
  m_Implementation->ClusterEdges();
}

MeshSilhouette::~MeshSilhouette() = default;
MeshSilhouette::MeshSilhouette(MeshSilhouette &&) noexcept = default;
MeshSilhouette &
MeshSilhouette::operator=(MeshSilhouette &&) noexcept = default;

std::size_t
MeshSilhouette::GetNumberOfEdges() const
{
  return m_Implementation->GetNumberOfEdges();
}

std::size_t
MeshSilhouette::GetNumberOfBoundaryEdges() const
{
  return m_Implementation->GetNumberOfBoundaryEdges();
}

std::size_t
MeshSilhouette::GetNumberOfNonManifoldEdges() const
{
  return m_Implementation->GetNumberOfNonManifoldEdges();
}

std::size_t
MeshSilhouette::GetNumberOfComponents() const
{
  return m_Implementation->GetNumberOfComponents();
}

auto
MeshSilhouette::ComputeSilhouetteEdges(const PerspectiveProjection & projection) const -> std::vector<EdgeType>
{
  std::vector<EdgeType> result;
  if (m_Implementation->GetNumberOfEdges() == 0)
  {
    return result;
  }
  const auto candidates = m_Implementation->FindCandidates(projection, m_Implementation->MakeGrid(projection));
  result.reserve(candidates.size());
  for (const SilhouetteEdges::EdgeType & edge : candidates)
  {
    result.emplace_back(edge.a, edge.b);
  }
  return result;
}

Silhouette
MeshSilhouette::ComputeOuterBoundary(const PerspectiveProjection & projection) const
{
  Silhouette                   result;
  const SilhouetteEdges &      mesh = *m_Implementation;
  const std::vector<Vector3> & points = mesh.GetPoints();
  if (mesh.GetNumberOfEdges() == 0)
  {
    return result;
  }
  const SilhouetteEdges::GridType grid = mesh.MakeGrid(projection);
  const auto                      candidates = mesh.FindCandidates(projection, grid);
  SilhouetteArrangement           arrangement(mesh.MakeSegments(projection, grid, candidates));
  const auto stretches = arrangement.WalkOuterBoundaries(mesh.GetNumberOfComponents(), mesh.GetComponentOfPoint());

  const double cell = 1.0 / grid.scale;
  for (const std::vector<SilhouetteStretch> & walked : stretches)
  {
    SilhouetteLoop loop;
    loop.points.reserve(walked.size());
    loop.rimStart.reserve(walked.size());
    loop.rimEnd.reserve(walked.size());
    loop.edges.reserve(walked.size());
    for (const SilhouetteStretch & stretch : walked)
    {
      const SilhouetteSegment & segment = arrangement.GetSegment(stretch.segment);
      const Vector3 &           a = points[segment.a];
      const Vector3 &           b = points[segment.b];
      const double              depthA = projection.Depth(a.data());
      const double              depthB = projection.Depth(b.data());
      const double              from = stretch.from.Value();
      const double              to = stretch.to.Value();
      const double x = static_cast<double>(segment.px) + from * static_cast<double>(segment.qx - segment.px);
      const double y = static_cast<double>(segment.py) + from * static_cast<double>(segment.qy - segment.py);
      loop.points.push_back({ grid.u0 + x * cell, grid.v0 + y * cell });
      loop.rimStart.push_back(PointOnEdge(a, depthA, b, depthB, from));
      loop.rimEnd.push_back(PointOnEdge(a, depthA, b, depthB, to));
      loop.edges.push_back({ segment.a, segment.b });
    }
    result.loops.push_back(std::move(loop));
  }
  if (result.loops.size() > 1)
  {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t l = 0; l < result.loops.size(); ++l)
    {
      order.emplace_back(-result.loops[l].Area(), l);
    }
    std::sort(order.begin(), order.end());
    std::vector<SilhouetteLoop> sorted;
    sorted.reserve(order.size());
    for (const auto & entry : order)
    {
      sorted.push_back(std::move(result.loops[entry.second]));
    }
    result.loops = std::move(sorted);
  }
  return result;
}

std::vector<SilhouetteSample>
SampleSilhouetteLoopCorners(const SilhouetteLoop & loop)
{
  std::vector<SilhouetteSample> samples(loop.points.size());
  double                        arcLength = 0.0;
  for (std::size_t i = 0; i < loop.points.size(); ++i)
  {
    const auto &       p = loop.points[i];
    const auto &       q = loop.points[i + 1 < loop.points.size() ? i + 1 : 0];
    const double       du = q[0] - p[0];
    const double       dv = q[1] - p[1];
    const double       norm = std::hypot(du, dv);
    SilhouetteSample & sample = samples[i];
    sample.u = p[0];
    sample.v = p[1];
    // Two crossings of one edge may be the same in double precision.
    sample.normal = norm > 0.0 ? std::array<double, 2>{ dv / norm, -du / norm }
                    : i > 0    ? samples[i - 1].normal
                               : std::array<double, 2>{ 0.0, 0.0 };
    sample.rim = loop.rimStart[i];
    sample.arcLength = arcLength;
    sample.segment = static_cast<std::uint32_t>(i);
    arcLength += norm;
  }
  return samples;
}

std::vector<SilhouetteSample>
ResampleSilhouetteLoop(const SilhouetteLoop & loop, const PerspectiveProjection & projection, std::size_t count)
{
  std::vector<SilhouetteSample>      samples;
  const std::vector<ContourPosition> positions = ResamplePolyline(loop.points, true, count);
  const double                       length = ComputePolylineLength(loop.points, true);
  samples.reserve(count);
  for (std::size_t k = 0; k < positions.size(); ++k)
  {
    const std::size_t i = positions[k].segment;
    const double      t = positions[k].share;
    const auto &      p = loop.points[i];
    const auto &      q = loop.points[i + 1 < loop.points.size() ? i + 1 : 0];
    const double      du = q[0] - p[0];
    const double      dv = q[1] - p[1];
    const double      norm = std::hypot(du, dv);
    SilhouetteSample  sample;
    sample.u = p[0] + t * du;
    sample.v = p[1] + t * dv;
    sample.normal = { dv / norm, -du / norm };
    sample.rim = PointOnEdge(loop.rimStart[i],
                             projection.Depth(loop.rimStart[i].data()),
                             loop.rimEnd[i],
                             projection.Depth(loop.rimEnd[i].data()),
                             t);
    sample.arcLength = length * static_cast<double>(k) / static_cast<double>(count);
    sample.segment = static_cast<std::uint32_t>(i);
    samples.push_back(sample);
  }
  return samples;
}

std::vector<SilhouetteSample>
ResampleSilhouetteLoopBySpacing(const SilhouetteLoop & loop, const PerspectiveProjection & projection, double spacing)
{
  if (!(spacing > 0.0))
  {
    throw std::invalid_argument("The spacing of contour points must be positive.");
  }
  const double count = std::floor(ComputePolylineLength(loop.points, true) / spacing + 0.5);
  return ResampleSilhouetteLoop(loop, projection, static_cast<std::size_t>(std::max(1.0, count)));
}
} // namespace itk

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
#include "itkDentalPhantomScanDefects.h"

#include "itkDentalPhantomMath.h"
#include "itkReproducibleRandom.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace itk
{
using namespace DentalPhantomMath;

namespace
{
using PointType = std::array<double, 3>;

enum ScanDefectStream : std::uint64_t
{
  FlapStream = 1,
  CrumbStream = 3,
  SpeckStream = 5,
  HoleStream = 7
};

double
SquaredDistance(const PointType & a, const PointType & b)
{
  return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]);
}

PointType
Unit(PointType v)
{
  const double l = std::max(std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]), 1e-12);
  for (double & value : v)
  {
    value /= l;
  }
  return v;
}

PointType
Rastered(PointType p)
{
  for (double & value : p)
  {
    value = Quantise(value);
  }
  return p;
}

struct MeshTraits : public OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};

/** Quadric edge collapse (Garland, Heckbert 1997) onto existing vertices, so that labels stay. */
void
Decimate(std::uint32_t numberOfTriangles, DentalPhantomJawSurface & jaw)
{
  using MeshType = OpenMesh::TriMesh_ArrayKernelT<MeshTraits>;
  MeshType mesh;
  mesh.request_face_status();
  mesh.request_edge_status();
  mesh.request_halfedge_status();
  mesh.request_vertex_status();
  OpenMesh::VPropHandleT<std::uint32_t> number;
  mesh.add_property(number);
  std::vector<MeshType::VertexHandle> handles;
  std::map<PointType, std::size_t>    fixed;
  for (const auto & landmark : jaw.landmarks)
  {
    fixed.emplace(landmark.point, 0);
  }
  for (std::size_t i = 0; i < jaw.surface.points.size(); ++i)
  {
    const PointType & p = jaw.surface.points[i];
    handles.push_back(mesh.add_vertex(MeshType::Point(p[0], p[1], p[2])));
    mesh.property(number, handles.back()) = static_cast<std::uint32_t>(i);
    mesh.status(handles.back()).set_locked(fixed.count(p) > 0);
  }
  for (const auto & t : jaw.surface.triangles)
  {
    if (!mesh.add_face(handles[t[0]], handles[t[1]], handles[t[2]]).is_valid())
    {
      throw std::logic_error("A phantom's mesh is no manifold and can't be decimated.");
    }
  }
  OpenMesh::Decimater::DecimaterT<MeshType>          decimater(mesh);
  OpenMesh::Decimater::ModQuadricT<MeshType>::Handle quadric;
  decimater.add(quadric);
  decimater.module(quadric).unset_max_err();
  decimater.initialize();
  decimater.decimate_to_faces(0, numberOfTriangles);
  mesh.garbage_collection();

  DentalPhantomJawSurface small;
  small.landmarks = jaw.landmarks;
  for (const auto vertex : mesh.vertices())
  {
    const std::uint32_t id = mesh.property(number, vertex);
    small.surface.points.push_back(jaw.surface.points[id]);
    small.labels.push_back(jaw.labels[id]);
  }
  for (const auto face : mesh.faces())
  {
    TriangleSurface::TriangleType triangle{};
    unsigned int                  corner = 0;
    for (auto it = mesh.cfv_ccwiter(face); it.is_valid(); ++it)
    {
      triangle[corner++] = static_cast<std::uint32_t>(it->idx());
    }
    small.surface.triangles.push_back(triangle);
  }
  jaw = std::move(small);
}

/** The longest border loop, in the direction of its triangles. */
std::vector<std::uint32_t>
FindBorder(const TriangleSurface & surface)
{
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto & t : surface.triangles)
  {
    for (unsigned int k = 0; k < 3; ++k)
    {
      edges.insert({ t[k], t[(k + 1) % 3] });
    }
  }
  std::map<std::uint32_t, std::uint32_t> next;
  for (const auto & edge : edges)
  {
    if (edges.count({ edge.second, edge.first }) == 0)
    {
      next.emplace(edge.first, edge.second);
    }
  }
  std::vector<std::uint32_t> longest;
  while (!next.empty())
  {
    std::vector<std::uint32_t> loop;
    auto                       it = next.begin();
    while (it != next.end())
    {
      loop.push_back(it->first);
      const std::uint32_t to = it->second;
      next.erase(it);
      it = next.find(to);
    }
    if (loop.size() > longest.size())
    {
      longest = std::move(loop);
    }
  }
  return longest;
}

/** A sheet that hangs on a stretch of the border and leads away from the arch and toward the occlusal side. */
void
AddFlap(double                             occlusal,
        const std::vector<std::uint32_t> & border,
        ReproducibleRandom &               random,
        DentalPhantomJawSurface &          jaw)
{
  const double wanted = random.Uniform(10.0, 24.0);
  const double reach = random.Uniform(5.0, 14.0);
  const double rise = random.Uniform(0.3, 1.1);
  const double phase = random.Uniform(0.0, 6.283185307179586);
  const double place = random.Uniform();
  if (border.size() < 12)
  {
    return;
  }
  // A ridge line: the centroid of the crowns near each border point decides which way is outward.
  auto &                     points = jaw.surface.points;
  std::vector<std::uint32_t> chain;
  double                     length = 0.0;
  std::size_t                at = static_cast<std::size_t>(place * static_cast<double>(border.size()));
  while (length < wanted && chain.size() + 2 < border.size())
  {
    const std::uint32_t id = border[at % border.size()];
    if (!chain.empty())
    {
      length += std::sqrt(SquaredDistance(points[chain.back()], points[id]));
    }
    chain.push_back(id);
    ++at;
  }
  std::vector<PointType> outward;
  for (const std::uint32_t id : chain)
  {
    PointType centre{};
    double    sum = 1e-9;
    for (std::size_t v = 0; v < jaw.labels.size(); v += 3)
    {
      const double d = SquaredDistance(points[v], points[id]);
      if (jaw.labels[v] != 0 && d < 400.0)
      {
        for (unsigned int k = 0; k < 3; ++k)
        {
          centre[k] += points[v][k];
        }
        sum += 1.0;
      }
    }
    PointType away = { { points[id][0] - centre[0] / sum, points[id][1] - centre[1] / sum, 0.0 } };
    away = Unit(away);
    away[2] = occlusal * rise;
    outward.push_back(Unit(away));
  }
  constexpr int              rows = 6;
  std::vector<std::uint32_t> before = chain;
  for (int r = 1; r <= rows; ++r)
  {
    std::vector<std::uint32_t> row;
    for (std::size_t i = 0; i < chain.size(); ++i)
    {
      const double a = static_cast<double>(i) / static_cast<double>(chain.size() - 1);
      // Full width in the middle, none at the ends; folds along it.
      const double t = reach * r / rows * std::sqrt(std::max(0.02, 4.0 * a * (1.0 - a)));
      const double fold = 0.12 * t * std::sin(9.0 * a + phase + 0.4 * r);
      PointType    p = points[chain[i]];
      for (unsigned int k = 0; k < 3; ++k)
      {
        p[k] += t * outward[i][k];
      }
      p[2] += fold + occlusal * 0.02 * t * t;
      row.push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back(Rastered(p));
      jaw.labels.push_back(0);
    }
    for (std::size_t i = 0; i + 1 < row.size(); ++i)
    {
      // The border's edge runs from chain[i] to chain[i + 1]; its new neighbour runs back.
      jaw.surface.triangles.push_back({ { before[i + 1], before[i], row[i] } });
      jaw.surface.triangles.push_back({ { before[i + 1], row[i], row[i + 1] } });
    }
    before = row;
  }
}

/** A loose, bent, ragged disc. */
void
AddPatch(const PointType &         centre,
         const PointType &         normal,
         double                    radius,
         int                       rings,
         int                       sectors,
         ReproducibleRandom &      random,
         DentalPhantomJawSurface & jaw)
{
  PointType side = { { -normal[1], normal[0], 0.0 } };
  if (std::abs(normal[2]) > 0.9)
  {
    side = { { 1.0, 0.0, 0.0 } };
  }
  side = Unit(side);
  const PointType     up = { { normal[1] * side[2] - normal[2] * side[1],
                               normal[2] * side[0] - normal[0] * side[2],
                               normal[0] * side[1] - normal[1] * side[0] } };
  auto &              points = jaw.surface.points;
  const std::uint32_t middle = static_cast<std::uint32_t>(points.size());
  const auto          add = [&](double x, double y) {
    const double bulge = -(x * x + y * y) / (4.0 * radius) + 0.05 * radius * random.Normal();
    PointType    p = centre;
    for (unsigned int k = 0; k < 3; ++k)
    {
      p[k] += x * side[k] + y * up[k] + bulge * normal[k];
    }
    points.push_back(Rastered(p));
    jaw.labels.push_back(0);
  };
  add(0.0, 0.0);
  std::vector<double> ragged(sectors);
  for (double & value : ragged)
  {
    value = radius * random.Uniform(0.6, 1.0);
  }
  for (int r = 1; r <= rings; ++r)
  {
    for (int s = 0; s < sectors; ++s)
    {
      const double angle = 6.283185307179586 * s / sectors;
      const double d = ragged[s] * r / rings;
      add(d * std::cos(angle), 0.7 * d * std::sin(angle));
    }
  }
  const auto id = [&](int r, int s) {
    return r == 0 ? middle : middle + 1u + static_cast<std::uint32_t>((r - 1) * sectors + s % sectors);
  };
  for (int r = 0; r < rings; ++r)
  {
    for (int s = 0; s < sectors; ++s)
    {
      if (r > 0)
      {
        jaw.surface.triangles.push_back({ { id(r, s), id(r + 1, s), id(r, s + 1) } });
      }
      jaw.surface.triangles.push_back({ { id(r, s + 1), id(r + 1, s), id(r + 1, s + 1) } });
    }
  }
}

void
OpenHole(double radius, ReproducibleRandom & random, DentalPhantomJawSurface & jaw)
{
  const auto &      points = jaw.surface.points;
  const std::size_t seed = random.Integer(static_cast<std::uint32_t>(points.size()));
  const double      r = random.Uniform(0.4, 1.0) * radius;
  for (const auto & landmark : jaw.landmarks)
  {
    if (SquaredDistance(landmark.point, points[seed]) < (r + 1.0) * (r + 1.0))
    {
      return;
    }
  }
  auto & triangles = jaw.surface.triangles;
  triangles.erase(std::remove_if(triangles.begin(),
                                 triangles.end(),
                                 [&](const auto & t) {
                                   return std::any_of(t.begin(), t.end(), [&](std::uint32_t id) {
                                     return SquaredDistance(points[id], points[seed]) < r * r;
                                   });
                                 }),
                  triangles.end());
}

/** Removes points that no triangle uses. */
void
Compact(DentalPhantomJawSurface & jaw)
{
  std::vector<std::uint32_t> number(jaw.surface.points.size(), 0xffffffffu);
  for (const auto & t : jaw.surface.triangles)
  {
    for (const std::uint32_t id : t)
    {
      number[id] = 0;
    }
  }
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < number.size(); ++i)
  {
    if (number[i] == 0)
    {
      jaw.surface.points[count] = jaw.surface.points[i];
      jaw.labels[count] = jaw.labels[i];
      number[i] = count++;
    }
  }
  jaw.surface.points.resize(count);
  jaw.labels.resize(count);
  for (auto & t : jaw.surface.triangles)
  {
    for (std::uint32_t & id : t)
    {
      id = number[id];
    }
  }
}
} // namespace

void
ApplyDentalPhantomScanDefects(unsigned int jaw, const DentalPhantomScan & scan, DentalPhantomJawSurface & result)
{
  if (scan.decimateTo > 0 && result.surface.triangles.size() > scan.decimateTo)
  {
    Decimate(scan.decimateTo, result);
  }
  const double occlusal = jaw == 0 ? -1.0 : 1.0;
  if (scan.flaps > 0)
  {
    ReproducibleRandom random(scan.seed, FlapStream + jaw);
    // Of the jaw itself: flaps hang on it, not on each other.
    const auto border = FindBorder(result.surface);
    for (std::uint32_t i = 0; i < scan.flaps; ++i)
    {
      AddFlap(occlusal, border, random, result);
    }
  }
  const std::size_t  solid = result.surface.points.size();
  ReproducibleRandom crumbs(scan.seed, CrumbStream + jaw);
  for (std::uint32_t i = 0; i < scan.crumbs; ++i)
  {
    // Beside a molar or premolar, on the tongue's side or the cheek's.
    const bool   tongue = crumbs.Uniform() < 0.6;
    const double radius = crumbs.Uniform(3.0, 8.0);
    const double distance = crumbs.Uniform(3.0, 9.0);
    const double tilt = crumbs.Uniform(-0.5, 0.5);
    PointType    tooth{};
    for (unsigned int attempt = 0; attempt < 200; ++attempt)
    {
      const std::size_t id = crumbs.Integer(static_cast<std::uint32_t>(solid));
      tooth = result.surface.points[id];
      if (result.labels[id] % 10 > 3)
      {
        break;
      }
    }
    const double    outward = (tooth[1] > 0.0 ? 1.0 : -1.0) * (tongue ? -1.0 : 1.0);
    const PointType centre = { { tooth[0], tooth[1] + outward * (distance + 5.0), tooth[2] } };
    AddPatch(centre, Unit({ { tilt, -outward, occlusal * 0.6 } }), radius, 5, 14, crumbs, result);
  }
  ReproducibleRandom specks(scan.seed, SpeckStream + jaw);
  for (std::uint32_t i = 0; i < scan.specks; ++i)
  {
    const PointType from = result.surface.points[specks.Integer(static_cast<std::uint32_t>(solid))];
    const PointType direction = Unit({ { specks.Normal(), specks.Normal(), specks.Normal() } });
    const double    distance = specks.Uniform(2.0, 15.0);
    const double    radius = specks.Uniform(0.2, 0.8);
    AddPatch(
      { { from[0] + distance * direction[0], from[1] + distance * direction[1], from[2] + distance * direction[2] } },
      direction,
      radius,
      1,
      3 + static_cast<int>(specks.Integer(5)),
      specks,
      result);
  }
  ReproducibleRandom holes(scan.seed, HoleStream + jaw);
  for (std::uint32_t i = 0; i < scan.holes; ++i)
  {
    OpenHole(scan.holeRadius, holes, result);
  }
  if (scan.holes > 0)
  {
    Compact(result);
  }
}
} // namespace itk

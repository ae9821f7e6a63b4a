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
#include "itkSilhouetteEdges.h"

#include "itkDisjointSets.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace itk
{
namespace
{
using Vector3 = std::array<double, 3>;

constexpr std::uint32_t NoPoint = 0xffffffffu;

/** Faces with a larger ratio of two sides to twice the area, in parts of the surface's radius, are always tested
 * exactly. */
constexpr double NeedleRatio = 1e5;

Vector3
Subtract(const Vector3 & a, const Vector3 & b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double
Norm(const Vector3 & a)
{
  return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

Vector3
CrossProduct(const Vector3 & a, const Vector3 & b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

double
DotProduct(const Vector3 & a, const Vector3 & b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

using HalfEdge = SilhouetteHalfEdge;

inline bool
IsBefore(const HalfEdge & x, const HalfEdge & y)
{
  return x.other != y.other ? x.other < y.other
                            : (x.opposite != y.opposite ? x.opposite < y.opposite : x.face < y.face);
}

/** The few edges at a point in order. */
void
SortFew(HalfEdge * begin, HalfEdge * end)
{
  if (end - begin > 24)
  {
    std::sort(begin, end, IsBefore);
    return;
  }
  for (HalfEdge * i = begin + 1; i < end; ++i)
  {
    const HalfEdge value = *i;
    HalfEdge *     at = i;
    for (; at != begin && IsBefore(value, at[-1]); --at)
    {
      *at = at[-1];
    }
    *at = value;
  }
}
/** What SilhouetteEdges::Snap() gives, of many points: the same operations, in a loop that is vectorised. */
constexpr std::size_t BatchSize = 64;
struct Batch
{
  double       x[BatchSize];
  double       y[BatchSize];
  double       z[BatchSize];
  std::int32_t gridX[BatchSize];
  std::int32_t gridY[BatchSize];
};

void
SnapBatch(const PerspectiveProjection & projection, const SilhouetteEdges::GridType & grid, Batch & batch)
{
  const std::array<double, 12> m = projection.matrix;
  const double                 u0 = grid.u0;
  const double                 v0 = grid.v0;
  const double                 scale = grid.scale;
  for (std::size_t i = 0; i < BatchSize; ++i)
  {
    const double x = batch.x[i];
    const double y = batch.y[i];
    const double z = batch.z[i];
    const double depth = m[8] * x + m[9] * y + m[10] * z + m[11];
    const double u = (m[0] * x + m[1] * y + m[2] * z + m[3]) / depth;
    const double v = (m[4] * x + m[5] * y + m[6] * z + m[7]) / depth;
    batch.gridX[i] = static_cast<std::int32_t>((u - u0) * scale + 0.5);
    batch.gridY[i] = static_cast<std::int32_t>((v - v0) * scale + 0.5);
  }
}
} // namespace

SilhouetteEdges::SilhouetteEdges(const TriangleSurface & surface)
  : m_Points(surface.points)
{
  this->TakePoints(surface);
  std::vector<TriangleType>         merged;
  const std::vector<TriangleType> & triangles = this->MergePoints(surface.triangles, merged);
  if (triangles.empty())
  {
    return;
  }
  this->MeasureBox(triangles);
  this->BuildComponents(triangles);
  this->BuildEdges(triangles);
}

void
SilhouetteEdges::TakePoints(const TriangleSurface & surface)
{
  for (std::size_t i = 0; i < m_Points.size(); ++i)
  {
    for (double & x : m_Points[i])
    {
      if (!std::isfinite(x))
      {
        std::ostringstream message;
        message << "Point " << i << " of the surface is not finite.";
        throw std::invalid_argument(message.str());
      }
      x += 0.0; // -0 to +0
    }
  }
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    for (const std::uint32_t corner : surface.triangles[t])
    {
      if (corner >= m_Points.size())
      {
        std::ostringstream message;
        message << "Triangle " << t << " of the surface names point " << corner << " of " << m_Points.size() << ".";
        throw std::invalid_argument(message.str());
      }
    }
  }
}

/** Points at one position become the first of them; triangles with two corners at one position are left out. Returns
 * the given triangles where that changes nothing. */
auto
SilhouetteEdges::MergePoints(const std::vector<TriangleType> & triangles, std::vector<TriangleType> & merged) const
  -> const std::vector<TriangleType> &
{
  std::vector<std::uint32_t> canonical(m_Points.size());
  std::size_t                capacity = 16;
  while (capacity < 2 * m_Points.size())
  {
    capacity *= 2;
  }
  std::vector<std::uint32_t> table(capacity, NoPoint);
  bool                       isSame = true;
  for (std::uint32_t i = 0; i < m_Points.size(); ++i)
  {
    std::uint64_t hash = 0;
    for (const double x : m_Points[i])
    {
      std::uint64_t bits;
      std::memcpy(&bits, &x, sizeof bits);
      hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
    std::size_t slot = hash & (capacity - 1);
    while (table[slot] != NoPoint && m_Points[table[slot]] != m_Points[i])
    {
      slot = (slot + 1) & (capacity - 1);
    }
    if (table[slot] == NoPoint)
    {
      table[slot] = i;
    }
    canonical[i] = table[slot];
    isSame = isSame && canonical[i] == i;
  }
  const auto isProper = [](const TriangleType & t) { return t[0] != t[1] && t[1] != t[2] && t[2] != t[0]; };
  if (isSame && std::all_of(triangles.begin(), triangles.end(), isProper))
  {
    return triangles;
  }
  merged.reserve(triangles.size());
  for (const TriangleType & triangle : triangles)
  {
    const TriangleType t{ canonical[triangle[0]], canonical[triangle[1]], canonical[triangle[2]] };
    if (isProper(t))
    {
      merged.push_back(t);
    }
  }
  return merged;
}

/** The box of the points that triangles use. */
void
SilhouetteEdges::MeasureBox(const std::vector<TriangleType> & triangles)
{
  m_Low.fill(std::numeric_limits<double>::max());
  m_High.fill(std::numeric_limits<double>::lowest());
  std::vector<std::uint8_t> isUsed(m_Points.size(), 0);
  for (const TriangleType & triangle : triangles)
  {
    for (const std::uint32_t corner : triangle)
    {
      isUsed[corner] = 1;
    }
  }
  for (std::size_t i = 0; i < m_Points.size(); ++i)
  {
    for (unsigned int k = 0; k < 3 && isUsed[i] != 0; ++k)
    {
      m_Low[k] = std::min(m_Low[k], m_Points[i][k]);
      m_High[k] = std::max(m_High[k], m_Points[i][k]);
    }
  }
  for (unsigned int k = 0; k < 3; ++k)
  {
    m_Center[k] = 0.5 * (m_Low[k] + m_High[k]);
  }
  m_Radius = Norm(Subtract(m_High, m_Center));
}

void
SilhouetteEdges::BuildComponents(const std::vector<TriangleType> & triangles)
{
  DisjointSets              sets(m_Points.size());
  std::vector<std::uint8_t> isCorner(m_Points.size(), 0);
  for (const TriangleType & triangle : triangles)
  {
    for (const std::uint32_t corner : triangle)
    {
      isCorner[corner] = 1;
      sets.Join(triangle[0], corner);
    }
  }
  std::vector<std::uint32_t> number(m_Points.size(), NoPoint);
  m_ComponentOfPoint.assign(m_Points.size(), 0);
  for (std::uint32_t i = 0; i < m_Points.size(); ++i)
  {
    if (isCorner[i] != 0)
    {
      const std::uint32_t root = sets.Find(i);
      if (number[root] == NoPoint)
      {
        number[root] = static_cast<std::uint32_t>(m_NumberOfComponents++);
      }
      m_ComponentOfPoint[i] = number[root];
    }
  }
  if (m_NumberOfComponents == 1)
  {
    m_ComponentOfPoint.clear();
    m_ComponentOfPoint.shrink_to_fit();
  }
}

std::vector<SilhouetteFace>
SilhouetteEdges::MakeFaces(const std::vector<TriangleType> & triangles) const
{
  std::vector<SilhouetteFace> faces(triangles.size());
  const double                largest = NeedleRatio / m_Radius;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const Vector3 & a = m_Points[triangles[t][0]];
    const Vector3   ab = Subtract(m_Points[triangles[t][1]], a);
    const Vector3   ac = Subtract(m_Points[triangles[t][2]], a);
    const Vector3   bc = Subtract(ac, ab);
    const Vector3   normal = CrossProduct(ab, ac);
    const double    twiceArea = Norm(normal);
    const double    inverse = 1.0 / twiceArea;
    const double    sides[3] = { Norm(ab), Norm(ac), Norm(bc) };
    // Of whatever corner. Rounding must not make it smaller, nor not a number look good.
    const double ratio =
      1.000001 * (sides[0] + sides[1] + sides[2] - std::min(sides[0], std::min(sides[1], sides[2]))) * inverse;
    SilhouetteFace & face = faces[t];
    for (unsigned int k = 0; k < 3; ++k)
    {
      face.n[k] = static_cast<float>(normal[k] * inverse);
    }
    face.d = static_cast<float>(DotProduct(normal, Subtract(a, m_Center)) * inverse);
    face.ratio = ratio < largest ? static_cast<float>(ratio) : std::numeric_limits<float>::infinity();
    face.inverseArea = static_cast<float>(inverse);
  }
  return faces;
}

void
SilhouetteEdges::BuildEdges(const std::vector<TriangleType> & triangles)
{
  // Half-edges in buckets of their smaller point.
  std::vector<std::uint32_t> starts(m_Points.size() + 1, 0);
  for (const TriangleType & t : triangles)
  {
    ++starts[std::min(t[0], t[1]) + 1];
    ++starts[std::min(t[1], t[2]) + 1];
    ++starts[std::min(t[2], t[0]) + 1];
  }
  for (std::size_t i = 0; i < m_Points.size(); ++i)
  {
    starts[i + 1] += starts[i];
  }
  std::vector<HalfEdge> halves(3 * triangles.size());
  // Filled from behind, so that starts ends as it was.
  for (std::size_t t = triangles.size(); t-- > 0;)
  {
    for (unsigned int k = 3; k-- > 0;)
    {
      const std::uint32_t a = triangles[t][k];
      const std::uint32_t b = triangles[t][(k + 1) % 3];
      halves[--starts[std::min(a, b) + 1]] = { std::max(a, b),
                                               triangles[t][(k + 2) % 3],
                                               static_cast<std::uint32_t>(2 * t) + (a > b ? 1u : 0u) };
    }
  }
  std::vector<SilhouetteFace>        faces = this->MakeFaces(triangles);
  std::vector<SilhouetteRegularEdge> regular;
  regular.reserve(halves.size() / 2);
  m_SpecialStarts.push_back(0);
  const auto isGood = [&faces](const HalfEdge & half) {
    return faces[half.face / 2].ratio < std::numeric_limits<float>::infinity();
  };
  for (std::uint32_t a = 0; a < m_Points.size(); ++a)
  {
    HalfEdge * const begin = halves.data() + starts[a + 1];
    HalfEdge * const end = a + 2 < starts.size() ? halves.data() + starts[a + 2] : halves.data() + halves.size();
    SortFew(begin, end);
    for (HalfEdge * group = begin; group != end;)
    {
      HalfEdge * next = group;
      while (next != end && next->other == group->other)
      {
        ++next;
      }
      const std::uint32_t b = group->other;
      const auto          count = next - group;
      ++m_NumberOfEdges;
      if (count == 1)
      {
        m_Boundary.push_back({ a, b });
      }
      else if (count == 2 && isGood(group[0]) && isGood(group[1]))
      {
        regular.push_back({ a, static_cast<std::uint32_t>(group - halves.data()) });
      }
      else
      {
        m_NumberOfNonManifoldEdges += count > 2 ? 1 : 0;
        m_Special.push_back({ a, b });
        for (; group != next; ++group)
        {
          m_SpecialOpposites.push_back(group->opposite);
        }
        m_SpecialStarts.push_back(static_cast<std::uint32_t>(m_SpecialOpposites.size()));
      }
      group = next;
    }
  }
  m_LooseEdges = std::move(regular);
  m_LooseHalves = std::move(halves);
  m_LooseFaces = std::move(faces);
}

void
SilhouetteEdges::ClusterEdges()
{
  if (m_LooseEdges.empty())
  {
    return;
  }
  m_Regular.Build(m_LooseEdges, m_LooseHalves, m_LooseFaces, m_Radius);
  m_NumberOfRegular = m_LooseEdges.size();
  m_LooseEdges = {};
  m_LooseHalves = {};
  m_LooseFaces = {};
}

auto
SilhouetteEdges::MakeGrid(const PerspectiveProjection & projection) const -> GridType
{
  double     low[2] = { std::numeric_limits<double>::max(), std::numeric_limits<double>::max() };
  double     high[2] = { std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest() };
  double     depthMin = std::numeric_limits<double>::max();
  double     depthMax = 0.0;
  const auto include = [&](const Vector3 & point) {
    double       u = 0.0;
    double       v = 0.0;
    const double depth = projection.Project(point.data(), u, v);
    if (!(depth > 0.0) || !std::isfinite(depth) || !std::isfinite(u) || !std::isfinite(v))
    {
      return false;
    }
    depthMin = std::min(depthMin, depth);
    depthMax = std::max(depthMax, depth);
    low[0] = std::min(low[0], u);
    low[1] = std::min(low[1], v);
    high[0] = std::max(high[0], u);
    high[1] = std::max(high[1], v);
    return true;
  };
  // The projected box contains the projected surface as long as all of it is in front of the source.
  bool inFront = true;
  for (unsigned int corner = 0; corner < 8 && inFront; ++corner)
  {
    inFront = include(
      { (corner & 1u ? m_High : m_Low)[0], (corner & 2u ? m_High : m_Low)[1], (corner & 4u ? m_High : m_Low)[2] });
  }
  GridType grid;
  if (inFront)
  {
    double squares[2];
    for (unsigned int row = 0; row < 2; ++row)
    {
      squares[row] = 0.0;
      for (const double extreme : { low[row], high[row] })
      {
        double square = 0.0;
        for (unsigned int k = 0; k < 3; ++k)
        {
          const double x = projection.matrix[4 * row + k] - extreme * projection.matrix[8 + k];
          square += x * x;
        }
        squares[row] = std::max(squares[row], square);
      }
    }
    grid.magnification = std::sqrt(squares[0] + squares[1]) / depthMin;
  }
  else
  {
    low[0] = low[1] = std::numeric_limits<double>::max();
    high[0] = high[1] = std::numeric_limits<double>::lowest();
    const auto includeOrThrow = [&](std::uint32_t point) {
      if (!include(m_Points[point]))
      {
        std::ostringstream message;
        message << "Point " << point << " (" << m_Points[point][0] << ", " << m_Points[point][1] << ", "
                << m_Points[point][2]
                << ") of the surface is not in front of the X-ray source. Check the mesh's unit and the pose.";
        throw std::domain_error(message.str());
      }
    };
    for (const std::vector<EdgeType> * list : { &m_Boundary, &m_Special })
    {
      for (const EdgeType & edge : *list)
      {
        includeOrThrow(edge.a);
        includeOrThrow(edge.b);
      }
    }
    for (const SilhouetteRegularEdge & edge : m_LooseEdges)
    {
      includeOrThrow(edge.point);
      includeOrThrow(m_LooseHalves[edge.half].other);
    }
    for (std::size_t i = 0; i < m_NumberOfRegular; ++i)
    {
      includeOrThrow(m_Regular.GetEdges()[i].a);
      includeOrThrow(m_Regular.GetEdges()[i].b);
    }
    // No bound without the box: every edge is tested exactly.
    grid.magnification = std::numeric_limits<double>::infinity();
  }
  grid.depthMax = depthMax;
  grid.u0 = std::floor(low[0]) - 1.0;
  grid.v0 = std::floor(low[1]) - 1.0;
  const double extent = std::max(high[0] - grid.u0, high[1] - grid.v0) + 2.0;
  int          exponent = 0;
  std::frexp(extent, &exponent); // extent < 2^exponent
  grid.scale = std::ldexp(1.0, std::min(20, SilhouetteGrid::GridBits - exponent));
  return grid;
}

/** Whether no two faces of an edge cover both sides of its projection. */
template <typename TIterator>
inline bool
SilhouetteEdges::IsCandidate(const PerspectiveProjection & projection,
                             const GridType &              grid,
                             const EdgeType &              edge,
                             TIterator                     begin,
                             TIterator                     end) const
{
  const GridPoint a = this->Snap(projection, grid, edge.a);
  const GridPoint b = this->Snap(projection, grid, edge.b);
  bool            left = false;
  bool            right = false;
  for (; begin != end; ++begin)
  {
    const std::int64_t side = SilhouetteGrid::Orientation(a, b, this->Snap(projection, grid, *begin));
    left = left || side > 0;
    right = right || side < 0;
  }
  return !(left && right);
}

void
SilhouetteEdges::AppendLooseCandidates(const PerspectiveProjection & projection,
                                       const GridType &              grid,
                                       std::vector<EdgeType> &       candidates) const
{
  // Each point is in some six edges and as many times the third point of one's face: found once.
  constexpr std::int64_t unknown = std::numeric_limits<std::int64_t>::min();
  std::vector<GridPoint> places(m_Points.size(), GridPoint{ unknown, unknown });
  const auto             placeOf = [&](std::uint32_t point) -> const GridPoint & {
    if (places[point].x == unknown)
    {
      places[point] = this->Snap(projection, grid, point);
    }
    return places[point];
  };
  // By key, then by number: the order of the clusters.
  std::vector<std::uint64_t> found;
  for (std::size_t i = 0; i < m_LooseEdges.size(); ++i)
  {
    const SilhouetteRegularEdge &    edge = m_LooseEdges[i];
    const SilhouetteHalfEdge * const half = &m_LooseHalves[edge.half];
    const GridPoint                  a = placeOf(edge.point);
    const GridPoint                  b = placeOf(half[0].other);
    const std::int64_t               first = SilhouetteGrid::Orientation(a, b, placeOf(half[0].opposite));
    const std::int64_t               second = SilhouetteGrid::Orientation(a, b, placeOf(half[1].opposite));
    if ((first > 0 && second < 0) || (first < 0 && second > 0))
    {
      continue;
    }
    const std::uint32_t key = SilhouetteEdgeClusters::KeyOf(edge, m_LooseHalves, m_LooseFaces, m_Radius);
    found.push_back(static_cast<std::uint64_t>(key) << 32 | i);
  }
  std::sort(found.begin(), found.end());
  candidates.reserve(candidates.size() + found.size());
  for (const std::uint64_t entry : found)
  {
    const SilhouetteRegularEdge & edge = m_LooseEdges[static_cast<std::uint32_t>(entry)];
    candidates.push_back({ edge.point, m_LooseHalves[edge.half].other });
  }
}

auto
SilhouetteEdges::FindCandidates(const PerspectiveProjection & projection, const GridType & grid) const
  -> std::vector<EdgeType>
{
  std::vector<EdgeType> candidates(m_Boundary);
  for (std::size_t i = 0; i < m_Special.size(); ++i)
  {
    const std::uint32_t * opposites = m_SpecialOpposites.data();
    if (this->IsCandidate(
          projection, grid, m_Special[i], opposites + m_SpecialStarts[i], opposites + m_SpecialStarts[i + 1]))
    {
      candidates.push_back(m_Special[i]);
    }
  }
  if (m_NumberOfRegular == 0)
  {
    this->AppendLooseCandidates(projection, grid, candidates);
    return candidates;
  }

  // The source follows from the 3x4 matrix: M s + m = 0.
  const double * const m = projection.matrix.data();
  const Vector3        row0{ m[0], m[1], m[2] };
  const Vector3        row1{ m[4], m[5], m[6] };
  const Vector3        row2{ m[8], m[9], m[10] };
  const Vector3        c0 = CrossProduct(row1, row2);
  const Vector3        c1 = CrossProduct(row2, row0);
  const Vector3        c2 = CrossProduct(row0, row1);
  const double         determinant = DotProduct(row0, c0);
  Vector3              source;
  for (unsigned int k = 0; k < 3; ++k)
  {
    source[k] = -(m[3] * c0[k] + m[7] * c1[k] + m[11] * c2[k]) / determinant - m_Center[k];
  }
  const double distance = Norm(source);
  // Twice a projected triangle's area is det(M) 2 A n.(a - s) / (depths); rounding to the grid changes it by at most
  // 2 sqrt(2) e (sum of two sides) + 8 e^2. A face whose n.(a - s) exceeds what follows from that keeps its sign.
  const double rounding = 0.51 / grid.scale + 1e-9;
  const double factor = grid.depthMax * grid.depthMax * grid.depthMax / std::abs(determinant);
  const auto   perRatio = static_cast<float>(1.0001 * factor * 2.8285 * rounding * grid.magnification);
  const auto   perInverseArea = static_cast<float>(1.0001 * factor * 8.0 * rounding * rounding);
  // Single precision loses some 1e-7 of the distance.
  const auto                slack = static_cast<float>(4e-6 * (distance + m_Radius));
  const SilhouettePlaneTest test{ static_cast<float>(source[0]),
                                  static_cast<float>(source[1]),
                                  static_cast<float>(source[2]),
                                  static_cast<float>(1.000001 * distance),
                                  perRatio,
                                  perInverseArea,
                                  slack };

  const std::vector<std::uint32_t> found = m_Regular.FindCandidates(test);
  candidates.reserve(candidates.size() + found.size());
  const SilhouetteEdgeClusters::EdgeType * const edges = m_Regular.GetEdges();
  for (std::size_t i = 0; i < found.size(); ++i)
  {
#ifdef __GNUC__
    if (i + 16 < found.size())
    {
      __builtin_prefetch(&edges[found[i + 16] / 2]);
    }
#endif
    const SilhouetteEdgeClusters::EdgeType & edge = edges[found[i] / 2];
    const EdgeType                           ends{ edge.a, edge.b };
    if (edge.a != edge.b && ((found[i] & 1u) != 0 ||
                             this->IsCandidate(projection, grid, ends, edge.opposites.begin(), edge.opposites.end())))
    {
      candidates.push_back(ends);
    }
  }
  return candidates;
}

std::vector<SilhouetteSegment>
SilhouetteEdges::MakeSegments(const PerspectiveProjection & projection,
                              const GridType &              grid,
                              const std::vector<EdgeType> & edges) const
{
  std::vector<SilhouetteSegment> segments(edges.size());
  std::size_t                    count = 0;
  constexpr std::size_t          Half = BatchSize / 2;
  Batch                          batch;
  for (std::size_t first = 0; first < edges.size(); first += Half)
  {
    const std::size_t size = std::min(Half, edges.size() - first);
    for (std::size_t i = 0; i < Half; ++i)
    {
#ifdef __GNUC__
      if (first + i + Half < edges.size())
      {
        __builtin_prefetch(&m_Points[edges[first + i + Half].a]);
        __builtin_prefetch(&m_Points[edges[first + i + Half].b]);
      }
#endif
      // The rest of the last batch repeats an edge.
      const EdgeType & edge = edges[first + std::min(i, size - 1)];
      for (std::size_t k = 0; k < 2; ++k)
      {
        const Vector3 & point = m_Points[k == 0 ? edge.a : edge.b];
        batch.x[i + k * Half] = point[0];
        batch.y[i + k * Half] = point[1];
        batch.z[i + k * Half] = point[2];
      }
    }
    SnapBatch(projection, grid, batch);
    for (std::size_t i = 0; i < size; ++i)
    {
      const EdgeType & edge = edges[first + i];
      segments[count] = {
        batch.gridX[i], batch.gridY[i], batch.gridX[i + Half], batch.gridY[i + Half], edge.a, edge.b
      };
      count += batch.gridX[i] != batch.gridX[i + Half] || batch.gridY[i] != batch.gridY[i + Half] ? 1 : 0;
    }
  }
  segments.resize(count);
  return segments;
}
} // namespace itk

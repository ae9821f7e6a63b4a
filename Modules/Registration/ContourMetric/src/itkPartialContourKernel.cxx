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
#include "itkPartialContourKernel.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace itk
{
namespace
{
/** rho(sqrt z), its derivative by z, and k = sqrt(rho / z), the factor that makes a residual of a distance. */
struct RobustType
{
  RobustType(ContourMetricEnums::RobustKernel kernel, double width, double z)
  {
    const double c2 = width * width;
    switch (kernel)
    {
      case ContourMetricEnums::RobustKernel::GemanMcClure: {
        const double share = c2 / (c2 + z);
        rho = share * z;
        slope = share * share;
        factor = std::sqrt(share);
        slopeOfFactor = -0.5 * factor * share / c2;
        return;
      }
      case ContourMetricEnums::RobustKernel::Huber:
        if (z > c2)
        {
          const double d = std::sqrt(z);
          rho = 2.0 * width * d - c2;
          slope = width / d;
          factor = std::sqrt(rho / z);
          slopeOfFactor = (slope * z - rho) / (2.0 * factor * z * z);
          return;
        }
        break;
      case ContourMetricEnums::RobustKernel::Squares:
        break;
    }
    rho = z;
    slope = 1.0;
    factor = 1.0;
    slopeOfFactor = 0.0;
  }
  double rho;
  double slope;
  double factor;
  double slopeOfFactor;
};

using ConstMatrix = Eigen::Map<const Eigen::MatrixXd>;
} // namespace

struct PartialContourKernel::MapType
{
  explicit MapType(const ContourSimilarity & similarity)
    : c(std::cos(similarity.angle))
    , s(std::sin(similarity.angle))
    , scale(similarity.scale)
    , tx(similarity.tx)
    , ty(similarity.ty)
  {}
  void
  Turn(double x, double y, double & rx, double & ry) const
  {
    rx = c * x - s * y;
    ry = s * x + c * y;
  }
  void
  TurnBack(double x, double y, double & qx, double & qy) const
  {
    qx = c * x + s * y;
    qy = -s * x + c * y;
  }
  double c;
  double s;
  double scale;
  double tx;
  double ty;
};

/** Distance and angle of a match with their derivatives by scale, angle, tx, ty. */
struct PartialContourKernel::RowType
{
  /** d with a sign, D^2 = e^2 + phi^2. */
  double                          e;
  std::array<double, 4>           je;
  double                          phi;
  double                          phiByAngle;
  double                          z;
  double                          taper;
  std::array<double, 4>           jtaper;
  OrientedContourIndex::MatchType match;
};

void
PartialContourKernel::MakeSamples(const ContourArrays &              contour,
                                  const std::vector<ContourStrand> & strands,
                                  const OrientedContourIndex &       index,
                                  const SettingsType &               settings,
                                  std::vector<SampleType> &          samples)
{
  samples.clear();
  std::size_t target = 0;
  for (const ContourStrand & strand : strands)
  {
    const std::size_t segments = strand.GetNumberOfSegments();
    const std::size_t count = strand.ids.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      SampleType sample{};
      sample.id = strand.ids[i];
      sample.x = contour.points[2 * sample.id];
      sample.y = contour.points[2 * sample.id + 1];
      sample.weight = contour.weights.empty() ? 1.0 : contour.weights[sample.id];
      sample.allowed = settings.gateByTooth && !contour.codes.empty()
                         ? OrientedContourIndex::GetAllowedCodes(contour.codes[sample.id], settings.toothRange)
                         : OrientedContourIndex::AllCodes;
      const auto add = [&](std::size_t segment) {
        const auto & t = index.GetTargets()[target + segment];
        sample.directionX += t.directionX;
        sample.directionY += t.directionY;
        sample.length += 0.5 * t.length;
      };
      if (segments > 0)
      {
        if (i > 0 || strand.closed)
        {
          add((i + segments - 1) % segments);
        }
        if (i < segments)
        {
          add(i);
        }
        const double size = std::hypot(sample.directionX, sample.directionY);
        sample.directionX = size > 0.0 ? sample.directionX / size : 0.0;
        sample.directionY = size > 0.0 ? sample.directionY / size : 0.0;
      }
      samples.push_back(sample);
    }
    target += std::max<std::size_t>(segments, 1);
  }
}

void
PartialContourKernel::FindEnds(const ContourArrays & fixed, const std::vector<ContourStrand> & strands)
{
  m_Reach.clear();
  const auto isFree = [&](std::size_t s, std::uint32_t id) {
    if (strands[s].closed)
    {
      return false;
    }
    for (std::size_t other = 0; other < strands.size(); ++other)
    {
      if (other != s && !strands[other].closed)
      {
        for (const std::uint32_t end : { strands[other].ids.front(), strands[other].ids.back() })
        {
          if (std::hypot(fixed.points[2 * id] - fixed.points[2 * end],
                         fixed.points[2 * id + 1] - fixed.points[2 * end + 1]) < m_Settings.gapLength)
          {
            return false;
          }
        }
      }
    }
    return true;
  };
  for (std::size_t s = 0; s < strands.size(); ++s)
  {
    m_Reach.push_back(
      { strands[s].GetArcLengths(fixed).back(), isFree(s, strands[s].ids.front()), isFree(s, strands[s].ids.back()) });
  }
}

void
PartialContourKernel::MakeBlocks(const ContourArrays & fixed, const std::vector<ContourStrand> & strands)
{
  m_Blocks.clear();
  // Jaws and sides are drawn one by one.
  std::map<unsigned int, std::vector<std::size_t>> groups;
  std::vector<std::size_t>                         firstSample;
  std::size_t                                      count = 0;
  for (std::size_t s = 0; s < strands.size(); ++s)
  {
    const unsigned int code = fixed.codes.empty() ? 0u : fixed.codes[strands[s].ids[0]];
    groups[code / 10u].push_back(s);
    firstSample.push_back(count);
    count += strands[s].ids.size();
  }
  for (auto & group : groups)
  {
    std::vector<std::size_t> & members = group.second;
    // Order: by tooth; else along the direction in which the points spread most.
    double mean[2] = { 0.0, 0.0 };
    double n = 0.0;
    for (const std::size_t s : members)
    {
      for (const std::uint32_t id : strands[s].ids)
      {
        mean[0] += fixed.points[2 * id];
        mean[1] += fixed.points[2 * id + 1];
        n += 1.0;
      }
    }
    mean[0] /= n;
    mean[1] /= n;
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    for (const std::size_t s : members)
    {
      for (const std::uint32_t id : strands[s].ids)
      {
        const double dx = fixed.points[2 * id] - mean[0];
        const double dy = fixed.points[2 * id + 1] - mean[1];
        xx += dx * dx;
        xy += dx * dy;
        yy += dy * dy;
      }
    }
    const double axis = 0.5 * std::atan2(2.0 * xy, xx - yy);
    const auto   placeOf = [&](std::size_t s) {
      if (group.first != 0)
      {
        return static_cast<double>(fixed.codes[strands[s].ids[0]] % 10u);
      }
      double sum = 0.0;
      for (const std::uint32_t id : strands[s].ids)
      {
        sum += fixed.points[2 * id] * std::cos(axis) + fixed.points[2 * id + 1] * std::sin(axis);
      }
      return sum / static_cast<double>(strands[s].ids.size());
    };
    std::stable_sort(
      members.begin(), members.end(), [&](std::size_t a, std::size_t b) { return placeOf(a) < placeOf(b); });
    // Directions that make the gaps smallest, by dynamic programming over (as is, reversed).
    const auto end = [&](std::size_t s, bool back) { return back ? strands[s].ids.back() : strands[s].ids.front(); };
    const auto gap = [&](std::uint32_t a, std::uint32_t b) {
      return std::hypot(fixed.points[2 * a] - fixed.points[2 * b], fixed.points[2 * a + 1] - fixed.points[2 * b + 1]);
    };
    std::vector<std::array<double, 2>> best(members.size(), { { 0.0, 0.0 } });
    std::vector<std::array<int, 2>>    from(members.size(), { { 0, 0 } });
    for (std::size_t k = 1; k < members.size(); ++k)
    {
      for (int r = 0; r < 2; ++r)
      {
        best[k][r] = std::numeric_limits<double>::infinity();
        for (int q = 0; q < 2; ++q)
        {
          const double cost = best[k - 1][q] + gap(end(members[k - 1], q == 0), end(members[k], r == 1));
          if (cost < best[k][r])
          {
            best[k][r] = cost;
            from[k][r] = q;
          }
        }
      }
    }
    std::vector<int> reversed(members.size(), 0);
    reversed.back() = best.back()[0] <= best.back()[1] ? 0 : 1;
    for (std::size_t k = members.size(); k-- > 1;)
    {
      reversed[k - 1] = from[k][reversed[k]];
    }

    BlockType                block;
    std::vector<std::size_t> all;
    std::vector<double>      sense;
    for (std::size_t k = 0; k < members.size(); ++k)
    {
      const std::size_t size = strands[members[k]].ids.size();
      for (std::size_t i = 0; i < size; ++i)
      {
        all.push_back(firstSample[members[k]] + (reversed[k] != 0 ? size - 1 - i : i));
        sense.push_back(reversed[k] != 0 ? -1.0 : 1.0);
      }
    }
    const std::size_t limit = std::max<std::size_t>(m_Settings.maximumNumberOfCorrelatedPoints, 1);
    const std::size_t step = (all.size() + limit - 1) / limit;
    block.weightOfEach = static_cast<double>(step);
    double length = 0.0;
    for (std::size_t k = 0; k < all.size(); ++k)
    {
      const SampleType & sample = m_FixedSamples[all[k]];
      if (k > 0)
      {
        length += gap(m_FixedSamples[all[k - 1]].id, sample.id);
      }
      if (k % step != step / 2 && !(all.size() <= step / 2 && k == 0))
      {
        continue;
      }
      double tx = sense[k] * sample.directionX;
      double ty = sense[k] * sample.directionY;
      if (tx == 0.0 && ty == 0.0 && all.size() > 1)
      {
        // A lone point: the way from the point before to the point after.
        const SampleType & a = m_FixedSamples[all[k > 0 ? k - 1 : 0]];
        const SampleType & b = m_FixedSamples[all[std::min(k + 1, all.size() - 1)]];
        const double       size = std::hypot(b.x - a.x, b.y - a.y);
        tx = size > 0.0 ? (b.x - a.x) / size : 0.0;
        ty = size > 0.0 ? (b.y - a.y) / size : 0.0;
      }
      block.samples.push_back(all[k]);
      block.normalX.push_back(-ty);
      block.normalY.push_back(tx);
      block.arc.push_back(length);
    }
    m_Blocks.push_back(std::move(block));
  }
}

void
PartialContourKernel::Initialize(const ContourArrays & fixed,
                                 const ContourArrays & moving,
                                 const SettingsType &  settings)
{
  m_Settings = settings;
  this->ForgetNoise();
  for (const ContourArrays * contour : { &fixed, &moving })
  {
    bool any = false;
    for (std::size_t i = 0; i < contour->GetNumberOfPoints(); ++i)
    {
      const double weight = contour->weights.empty() ? 1.0 : contour->weights[i];
      if (!std::isfinite(contour->points[2 * i]) || !std::isfinite(contour->points[2 * i + 1]) ||
          !std::isfinite(weight))
      {
        throw std::invalid_argument("a contour's point or weight is not finite");
      }
      any = any || weight > 0.0;
    }
    if (!any)
    {
      throw std::invalid_argument("a contour has no point of positive weight");
    }
  }
  m_NumberOfFixedPoints = fixed.GetNumberOfPoints();
  m_NumberOfMovingPoints = moving.GetNumberOfPoints();
  const std::vector<ContourStrand> fixedStrands = ContourStrand::FindAll(fixed);
  const std::vector<ContourStrand> movingStrands = ContourStrand::FindAll(moving);
  m_FixedIndex.Initialize(fixed, fixedStrands, settings.directionSmoothing);
  m_MovingIndex.Initialize(moving, movingStrands, settings.directionSmoothing);
  MakeSamples(fixed, fixedStrands, m_FixedIndex, settings, m_FixedSamples);
  MakeSamples(moving, movingStrands, m_MovingIndex, settings, m_MovingSamples);
  this->FindEnds(fixed, fixedStrands);
  m_SumOfWeights = 0.0;
  double length = 0.0;
  for (const SampleType & sample : m_FixedSamples)
  {
    m_SumOfWeights += sample.weight;
    length += sample.length;
  }
  m_FixedSpacing = length / static_cast<double>(m_FixedSamples.size());
  this->MakeBlocks(fixed, fixedStrands);

  const auto & targets = m_MovingIndex.GetTargets();
  m_EndNormals.assign(targets.size(), { { 0.0, 0.0, 0.0, 0.0 } });
  const auto addNormal = [&](std::size_t i, double * xy) {
    const double inverse = targets[i].length > 0.0 ? 1.0 / targets[i].length : 0.0;
    xy[0] -= targets[i].dy * inverse;
    xy[1] += targets[i].dx * inverse;
  };
  for (std::size_t first = 0; first < targets.size();)
  {
    std::size_t end = first + 1;
    while (end < targets.size() && targets[end].strand == targets[first].strand)
    {
      ++end;
    }
    for (std::size_t k = first; k < end; ++k)
    {
      addNormal(k, &m_EndNormals[k][0]);
      addNormal(k, &m_EndNormals[k][2]);
      if (!targets[k].startIsEnd)
      {
        addNormal(k == first ? end - 1 : k - 1, &m_EndNormals[k][0]);
      }
      if (!targets[k].endIsEnd)
      {
        addNormal(k + 1 == end ? first : k + 1, &m_EndNormals[k][2]);
      }
    }
    first = end;
  }
}

bool
PartialContourKernel::ComputeForward(const MapType & map, const SampleType & sample, RowType & row) const
{
  double       qx;
  double       qy;
  double       ux;
  double       uy;
  const double inverseScale = 1.0 / map.scale;
  map.TurnBack((sample.x - map.tx) * inverseScale, (sample.y - map.ty) * inverseScale, qx, qy);
  map.TurnBack(sample.directionX, sample.directionY, ux, uy);
  const double weight = m_Settings.directionWeight * inverseScale;
  row.match = m_MovingIndex.Find(qx, qy, ux, uy, weight * weight, sample.allowed);
  if (!(row.match.squaredDistance < std::numeric_limits<double>::infinity()))
  {
    return false;
  }
  const auto & target = m_MovingIndex.GetTargets()[row.match.target];
  double       rx;
  double       ry;
  map.Turn(row.match.x, row.match.y, rx, ry);
  // From the matched place to the point of the tracing.
  const double dx = sample.x - (map.scale * rx + map.tx);
  const double dy = sample.y - (map.scale * ry + map.ty);
  const bool   atVertex = row.match.part <= 0.0 || row.match.part >= 1.0;
  double       nx;
  double       ny;
  const double inverseLength = target.length > 0.0 ? 1.0 / target.length : 0.0;
  map.Turn(-target.dy * inverseLength, target.dx * inverseLength, nx, ny);
  if (atVertex)
  {
    const double * side = &m_EndNormals[row.match.target][row.match.part <= 0.0 ? 0 : 2];
    double         sx;
    double         sy;
    map.Turn(side[0], side[1], sx, sy);
    const double d = std::hypot(dx, dy);
    row.e = sx * dx + sy * dy < 0.0 ? -d : d;
    if (d > 0.0)
    {
      nx = dx / row.e;
      ny = dy / row.e;
    }
  }
  else
  {
    row.e = nx * dx + ny * dy;
  }
  row.je = { { -(nx * rx + ny * ry), -map.scale * (ny * rx - nx * ry), -nx, -ny } };
  row.phi = 0.0;
  row.phiByAngle = 0.0;
  if (m_Settings.directionWeight > 0.0)
  {
    row.phi = m_Settings.directionWeight * (target.directionX * uy - target.directionY * ux);
    row.phiByAngle = -m_Settings.directionWeight * (target.directionX * ux + target.directionY * uy);
  }
  row.z = row.e * row.e + row.phi * row.phi;
  row.taper = 1.0;
  row.jtaper = { { 0.0, 0.0, 0.0, 0.0 } };
  return true;
}

void
PartialContourKernel::ComputeSigned(
  const MapType & map, const SampleType & sample, double nx, double ny, double * r, double * jr) const
{
  RowType row;
  if (!this->ComputeForward(map, sample, row))
  {
    *r = 0.0;
    std::fill_n(jr, 4, 0.0);
    return;
  }
  const auto & target = m_MovingIndex.GetTargets()[row.match.target];
  double       mx = 0.0;
  double       my = 0.0;
  if (target.length > 0.0)
  {
    map.Turn(-target.dy / target.length, target.dx / target.length, mx, my);
    if ((target.startIsEnd && row.match.part <= 0.0) || (target.endIsEnd && row.match.part >= 1.0))
    {
      double rx;
      double ry;
      map.Turn(row.match.x, row.match.y, rx, ry);
      const double dx = sample.x - (map.scale * rx + map.tx);
      const double dy = sample.y - (map.scale * ry + map.ty);
      row.e = mx * dx + my * dy;
      row.je = { { -(mx * rx + my * ry), -map.scale * (my * rx - mx * ry) + (mx * dy - my * dx), -mx, -my } };
    }
  }
  const double sign = nx * mx + ny * my < 0.0 ? -1.0 : 1.0;
  *r = sign * row.e;
  for (unsigned int a = 0; a < 4; ++a)
  {
    jr[a] = sign * row.je[a];
  }
}

bool
PartialContourKernel::ComputeReverse(const MapType & map, const SampleType & sample, RowType & row) const
{
  double rx;
  double ry;
  double ux;
  double uy;
  map.Turn(sample.x, sample.y, rx, ry);
  map.Turn(sample.directionX, sample.directionY, ux, uy);
  const double x = map.scale * rx + map.tx;
  const double y = map.scale * ry + map.ty;
  row.match = m_FixedIndex.Find(x, y, ux, uy, m_Settings.directionWeight * m_Settings.directionWeight, sample.allowed);
  if (!(row.match.squaredDistance < std::numeric_limits<double>::infinity()))
  {
    return false;
  }
  const auto &      target = m_FixedIndex.GetTargets()[row.match.target];
  const ReachType & reach = m_Reach[target.strand];
  const bool        atVertex = row.match.part <= 0.0 || row.match.part >= 1.0;
  const double      arc = target.arc + row.match.part * target.length;
  const double      toStart = reach.startIsFree ? arc : std::numeric_limits<double>::infinity();
  const double      toEnd = reach.endIsFree ? reach.length - arc : std::numeric_limits<double>::infinity();
  const double      distance = std::min(toStart, toEnd);
  const double      longest = reach.startIsFree && reach.endIsFree ? 0.5 * reach.length : reach.length;
  const double      taper = std::min(m_Settings.taperLength, longest);
  if (!(distance > 1e-9 * reach.length))
  {
    return false;
  }
  const double tangentX = target.length > 0.0 ? target.dx / target.length : 0.0;
  const double tangentY = target.length > 0.0 ? target.dy / target.length : 0.0;
  double       nx = -tangentY;
  double       ny = tangentX;
  const double dx = x - row.match.x;
  const double dy = y - row.match.y;
  row.e = nx * dx + ny * dy;
  if (atVertex)
  {
    const double d = std::hypot(dx, dy);
    row.e = row.e < 0.0 ? -d : d;
    if (d > 0.0)
    {
      nx = dx / row.e;
      ny = dy / row.e;
    }
  }
  const auto along = [&](double vx, double vy) {
    return std::array<double, 4>{ { vx * rx + vy * ry, map.scale * (vy * rx - vx * ry), vx, vy } };
  };
  row.je = along(nx, ny);
  row.phi = m_Settings.directionWeight * (ux * target.directionY - uy * target.directionX);
  row.phiByAngle = -m_Settings.directionWeight * (ux * target.directionX + uy * target.directionY);
  row.z = row.e * row.e + row.phi * row.phi;
  row.taper = 1.0;
  row.jtaper = { { 0.0, 0.0, 0.0, 0.0 } };
  if (distance < taper)
  {
    const double part = distance / taper;
    row.taper = part * part * (3.0 - 2.0 * part);
    if (!atVertex)
    {
      const double slope = 6.0 * part * (1.0 - part) / taper * (toStart <= toEnd ? 1.0 : -1.0);
      row.jtaper = along(slope * tangentX, slope * tangentY);
    }
  }
  return true;
}

void
PartialContourKernel::WriteRows(const RowType & row, double factor, double *& residuals, double *& jacobian) const
{
  const RobustType robust(m_Settings.robustKernel, m_Settings.width, row.z);
  const bool       two = m_Settings.directionWeight > 0.0;
  const double     k = factor * row.taper * robust.factor;
  *residuals++ = k * row.e;
  if (two)
  {
    *residuals++ = k * row.phi;
  }
  if (jacobian == nullptr)
  {
    return;
  }
  std::array<double, 4> jk;
  for (unsigned int a = 0; a < 4; ++a)
  {
    const double jz = 2.0 * (row.e * row.je[a] + (a == 1 ? row.phi * row.phiByAngle : 0.0));
    jk[a] = factor * (row.taper * robust.slopeOfFactor * jz + row.jtaper[a] * robust.factor);
    *jacobian++ = k * row.je[a] + jk[a] * row.e;
  }
  for (unsigned int a = 0; two && a < 4; ++a)
  {
    *jacobian++ = (a == 1 ? k * row.phiByAngle : 0.0) + jk[a] * row.phi;
  }
}

std::size_t
PartialContourKernel::GetNumberOfResiduals() const
{
  const std::size_t rowsOfPoint = m_Settings.directionWeight > 0.0 ? 2 : 1;
  return rowsOfPoint * (m_FixedSamples.size() + (m_Settings.reverseWeight > 0.0 ? m_MovingSamples.size() : 0)) + 4;
}

void
PartialContourKernel::EvaluateResiduals(const ContourSimilarity & similarity,
                                        double *                  residuals,
                                        double *                  jacobian) const
{
  const MapType     map(similarity);
  const std::size_t rowsOfPoint = m_Settings.directionWeight > 0.0 ? 2 : 1;
  const double      unit = std::sqrt(1.0 / m_SumOfWeights);
  const double      sigma = std::sqrt(this->GetVariance());
  RowType           row;
  const auto        skip = [&](std::size_t rows) {
    std::fill_n(residuals, rows, 0.0);
    residuals += rows;
    if (jacobian != nullptr)
    {
      std::fill_n(jacobian, 4 * rows, 0.0);
      jacobian += 4 * rows;
    }
  };
  if (m_Factors.empty())
  {
    for (const SampleType & sample : m_FixedSamples)
    {
      if (this->ComputeForward(map, sample, row))
      {
        this->WriteRows(row, unit * std::sqrt(sample.weight), residuals, jacobian);
      }
      else
      {
        skip(rowsOfPoint);
      }
    }
  }
  else
  {
    std::size_t rest = rowsOfPoint * m_FixedSamples.size();
    for (std::size_t b = 0; b < m_Blocks.size(); ++b)
    {
      const BlockType & block = m_Blocks[b];
      const auto        n = static_cast<Eigen::Index>(block.samples.size());
      Eigen::MatrixXd   rows(n, jacobian == nullptr ? 1 : 5);
      for (Eigen::Index i = 0; i < n; ++i)
      {
        double r;
        double jr[4];
        this->ComputeSigned(map, m_FixedSamples[block.samples[i]], block.normalX[i], block.normalY[i], &r, jr);
        const double root = m_Factors[b].roots[static_cast<std::size_t>(i)];
        rows(i, 0) = root * r;
        for (Eigen::Index a = 1; a < rows.cols(); ++a)
        {
          rows(i, a) = root * jr[a - 1];
        }
      }
      ConstMatrix(m_Factors[b].lower.data(), n, n).triangularView<Eigen::Lower>().solveInPlace(rows);
      for (Eigen::Index i = 0; i < n; ++i)
      {
        *residuals++ = unit * sigma * rows(i, 0);
        for (Eigen::Index a = 1; a < rows.cols(); ++a)
        {
          *jacobian++ = unit * sigma * rows(i, a);
        }
      }
      rest -= block.samples.size();
    }
    skip(rest);
  }
  if (m_Settings.reverseWeight > 0.0)
  {
    for (const SampleType & sample : m_MovingSamples)
    {
      if (this->ComputeReverse(map, sample, row))
      {
        const double stretch = m_FixedSpacing > 0.0 && sample.length > 0.0 ? sample.length / m_FixedSpacing : 1.0;
        this->WriteRows(row, unit * std::sqrt(m_Settings.reverseWeight * sample.weight * stretch), residuals, jacobian);
      }
      else
      {
        skip(rowsOfPoint);
      }
    }
  }

  const PartialContourPrior & prior = m_Settings.prior;
  double                      rx;
  double                      ry;
  map.Turn(prior.at[0], prior.at[1], rx, ry);
  const double difference[4] = { std::log(map.scale) - prior.logScale,
                                 similarity.angle - prior.angle,
                                 map.scale * rx + map.tx - prior.position[0],
                                 map.scale * ry + map.ty - prior.position[1] };
  const double sigmas[4] = { prior.logScaleSigma, prior.angleSigma, prior.positionSigma, prior.positionSigma };
  const double slopes[4][4] = { { 1.0 / map.scale, 0.0, 0.0, 0.0 },
                                { 0.0, 1.0, 0.0, 0.0 },
                                { rx, -map.scale * ry, 1.0, 0.0 },
                                { ry, map.scale * rx, 0.0, 1.0 } };
  for (unsigned int k = 0; k < 4; ++k)
  {
    const double factor = unit * sigma / sigmas[k];
    *residuals++ = factor * difference[k];
    for (unsigned int a = 0; jacobian != nullptr && a < 4; ++a)
    {
      *jacobian++ = factor * slopes[k][a];
    }
  }
}

double
PartialContourKernel::Evaluate(const ContourSimilarity & similarity, GradientType * gradient) const
{
  const std::size_t   count = this->GetNumberOfResiduals();
  std::vector<double> residuals(count);
  std::vector<double> jacobian(gradient == nullptr ? 0 : 4 * count);
  this->EvaluateResiduals(similarity, residuals.data(), gradient == nullptr ? nullptr : jacobian.data());
  double value = 0.0;
  for (const double residual : residuals)
  {
    value += residual * residual;
  }
  if (gradient != nullptr)
  {
    gradient->fill(0.0);
    for (std::size_t i = 0; i < count; ++i)
    {
      for (unsigned int a = 0; a < 4; ++a)
      {
        (*gradient)[a] += 2.0 * residuals[i] * jacobian[4 * i + a];
      }
    }
  }
  return value;
}

double
PartialContourKernel::EvaluateApproximately(const ContourSimilarity & similarity, std::size_t numberOfPoints) const
{
  const MapType map(similarity);
  const auto    mean = [&](const std::vector<SampleType> & samples, bool reverse, double & sumOfWeights) {
    const std::size_t count = samples.size();
    const std::size_t used = std::min(count, std::max<std::size_t>(numberOfPoints, 1));
    double            sum = 0.0;
    RowType           row;
    sumOfWeights = 0.0;
    for (std::size_t k = 0; k < used; ++k)
    {
      const SampleType & sample = samples[(2 * k + 1) * count / (2 * used)];
      const double       weight =
        reverse ? sample.weight * (m_FixedSpacing > 0.0 && sample.length > 0.0 ? sample.length / m_FixedSpacing : 1.0)
                         : sample.weight;
      sumOfWeights += weight;
      if (reverse ? this->ComputeReverse(map, sample, row) : this->ComputeForward(map, sample, row))
      {
        sum += weight * row.taper * row.taper * RobustType(m_Settings.robustKernel, m_Settings.width, row.z).rho;
      }
    }
    return sum / sumOfWeights;
  };
  double weight = 0.0;
  double value = mean(m_FixedSamples, false, weight);
  if (m_Settings.reverseWeight > 0.0)
  {
    // Weights of the thinned points stand for all.
    double all = 0.0;
    for (const SampleType & sample : m_MovingSamples)
    {
      all += sample.weight * (m_FixedSpacing > 0.0 && sample.length > 0.0 ? sample.length / m_FixedSpacing : 1.0);
    }
    value += m_Settings.reverseWeight * mean(m_MovingSamples, true, weight) * all / m_SumOfWeights;
  }
  const PartialContourPrior & prior = m_Settings.prior;
  double                      rx;
  double                      ry;
  map.Turn(prior.at[0], prior.at[1], rx, ry);
  const auto square = [](double x) { return x * x; };
  return value + this->GetValueOfUnitInformation() *
                   (square((std::log(map.scale) - prior.logScale) / prior.logScaleSigma) +
                    square((similarity.angle - prior.angle) / prior.angleSigma) +
                    square((map.scale * rx + map.tx - prior.position[0]) / prior.positionSigma) +
                    square((map.scale * ry + map.ty - prior.position[1]) / prior.positionSigma));
}

bool
PartialContourKernel::UpdateNoise(const ContourSimilarity & similarity)
{
  const MapType               map(similarity);
  const PartialContourPrior & prior = m_Settings.prior;
  double                      ax;
  double                      ay;
  map.Turn(prior.at[0], prior.at[1], ax, ay);
  std::vector<FactorType>          factors(m_Blocks.size());
  std::vector<std::vector<double>> weights(m_Blocks.size());
  std::vector<std::vector<double>> used(m_Blocks.size());
  std::vector<std::vector<double>> residuals(m_Blocks.size());
  std::vector<std::vector<double>> jacobians(m_Blocks.size());
  double                           sumOfWeights = 0.0;
  for (std::size_t b = 0; b < m_Blocks.size(); ++b)
  {
    BlockType &         block = m_Blocks[b];
    const std::size_t   n = block.samples.size();
    std::vector<double> nu(block.normalX);
    std::vector<double> nv(block.normalY);
    factors[b].roots.assign(n, 0.0);
    weights[b].assign(n, 0.0);
    used[b].assign(n, 0.0);
    residuals[b].assign(n, 0.0);
    jacobians[b].assign(4 * n, 0.0);
    for (std::size_t i = 0; i < n; ++i)
    {
      const SampleType & sample = m_FixedSamples[block.samples[i]];
      RowType            row;
      if (!this->ComputeForward(map, sample, row))
      {
        continue;
      }
      const double robust = RobustType(m_Settings.robustKernel, m_Settings.width, row.z).slope;
      weights[b][i] = block.weightOfEach * sample.weight;
      factors[b].roots[i] = std::sqrt(robust);
      // The levels are those of the points that belong to the contour.
      used[b][i] = row.z <= m_Settings.width * m_Settings.width ? weights[b][i] : 0.0;
      sumOfWeights += weights[b][i] * robust;
      double jr[4];
      this->ComputeSigned(map, sample, block.normalX[i], block.normalY[i], &residuals[b][i], jr);
      // By log scale and angle about the prior's point, and by the place where it lands: the priors' own parameters.
      jacobians[b][i] = jr[0] * map.scale - map.scale * (jr[2] * ax + jr[3] * ay);
      jacobians[b][n + i] = jr[1] - map.scale * (jr[3] * ax - jr[2] * ay);
      jacobians[b][2 * n + i] = jr[2];
      jacobians[b][3 * n + i] = jr[3];
      // The direction in which the residual sees an error of the point.
      nu[i] = -jr[2];
      nv[i] = -jr[3];
    }
    block.correlation.resize(n * n);
    ContourNoiseModel::ComputeCorrelation(
      block.arc.data(), nu.data(), nv.data(), n, m_Settings.correlationLength, block.correlation.data());
  }
  if (!(sumOfWeights > 1e-3))
  {
    return false;
  }
  ContourNoiseLevels noise = m_Settings.noise;
  if (m_Settings.estimateNoise)
  {
    const auto                                square = [](double x) { return x * x; };
    const double                              precision[4] = { 1.0 / square(prior.logScaleSigma),
                                                               1.0 / square(prior.angleSigma),
                                                               1.0 / square(prior.positionSigma),
                                                               1.0 / square(prior.positionSigma) };
    const double                              offset[4] = { std::log(map.scale) - prior.logScale,
                                                            similarity.angle - prior.angle,
                                                            map.scale * ax + map.tx - prior.position[0],
                                                            map.scale * ay + map.ty - prior.position[1] };
    std::vector<ContourNoiseModel::BlockType> views;
    for (std::size_t b = 0; b < m_Blocks.size(); ++b)
    {
      views.push_back({ m_Blocks[b].samples.size(),
                        m_Blocks[b].correlation.data(),
                        used[b].data(),
                        residuals[b].data(),
                        jacobians[b].data() });
    }
    noise = ContourNoiseModel::Estimate(views, precision, offset, 4, m_Settings.noise);
  }
  for (std::size_t b = 0; b < m_Blocks.size(); ++b)
  {
    const std::size_t n = m_Blocks[b].samples.size();
    const auto        size = static_cast<Eigen::Index>(n);
    Eigen::MatrixXd   covariance(size, size);
    ContourNoiseModel::ComputeCovariance(
      m_Blocks[b].correlation.data(), weights[b].data(), n, noise, covariance.data());
    const Eigen::LLT<Eigen::MatrixXd> cholesky(covariance);
    if (cholesky.info() != Eigen::Success)
    {
      return false;
    }
    factors[b].lower.resize(n * n);
    Eigen::Map<Eigen::MatrixXd>(factors[b].lower.data(), size, size) = cholesky.matrixL();
  }
  m_Factors = std::move(factors);
  m_Noise = noise;
  return true;
}

void
PartialContourKernel::ForgetNoise()
{
  m_Factors.clear();
  m_Noise = m_Settings.noise;
}

PartialContourOverlap
PartialContourKernel::ComputeOverlap(const ContourSimilarity & similarity, double distance) const
{
  const MapType         map(similarity);
  PartialContourOverlap overlap;
  RowType               row;
  double                matched = 0.0;
  double                squares = 0.0;
  const double          limit = distance * distance;
  for (const SampleType & sample : m_FixedSamples)
  {
    if (!this->ComputeForward(map, sample, row) || !(row.e * row.e <= limit))
    {
      continue;
    }
    const auto & target = m_MovingIndex.GetTargets()[row.match.target];
    if ((target.startIsEnd && row.match.part <= 0.0) || (target.endIsEnd && row.match.part >= 1.0))
    {
      // Beyond the end, or beside it?
      double tx;
      double ty;
      double rx;
      double ry;
      map.Turn(target.dx, target.dy, tx, ty);
      map.Turn(row.match.x, row.match.y, rx, ry);
      const double along = tx * (sample.x - map.scale * rx - map.tx) + ty * (sample.y - map.scale * ry - map.ty);
      if (std::abs(along) > 1e-9 * target.length)
      {
        continue;
      }
    }
    matched += sample.weight;
    squares += sample.weight * row.e * row.e;
    overlap.largest = std::max(overlap.largest, std::abs(row.e));
  }
  overlap.fixedShare = matched / m_SumOfWeights;
  overlap.rms = matched > 0.0 ? std::sqrt(squares / matched) : 0.0;
  double covered = 0.0;
  double all = 0.0;
  for (const SampleType & sample : m_MovingSamples)
  {
    const double weight = sample.weight * (sample.length > 0.0 ? sample.length : 1.0);
    all += weight;
    if (this->ComputeReverse(map, sample, row) && row.e * row.e <= limit)
    {
      covered += weight;
    }
  }
  overlap.movingShare = covered / all;
  return overlap;
}

std::vector<double>
PartialContourKernel::GetFixedDistances(const ContourSimilarity & similarity) const
{
  const MapType       map(similarity);
  std::vector<double> distances(m_NumberOfFixedPoints, std::numeric_limits<double>::quiet_NaN());
  RowType             row;
  for (const SampleType & sample : m_FixedSamples)
  {
    if (this->ComputeForward(map, sample, row))
    {
      distances[sample.id] = std::sqrt(row.z);
    }
  }
  return distances;
}

std::vector<double>
PartialContourKernel::GetMovingDistances(const ContourSimilarity & similarity) const
{
  const MapType       map(similarity);
  std::vector<double> distances(m_NumberOfMovingPoints, std::numeric_limits<double>::quiet_NaN());
  RowType             row;
  for (const SampleType & sample : m_MovingSamples)
  {
    if (this->ComputeReverse(map, sample, row))
    {
      distances[sample.id] = std::sqrt(row.z);
    }
  }
  return distances;
}
} // namespace itk

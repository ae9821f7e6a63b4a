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
#include "itkContourChamferKernel.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace itk
{
namespace
{
/** The similarity with its sine and cosine. */
struct Map
{
  explicit Map(const ContourSimilarity & similarity)
    : c(std::cos(similarity.angle))
    , s(std::sin(similarity.angle))
    , scale(similarity.scale)
    , tx(similarity.tx)
    , ty(similarity.ty)
  {}

  /** s R q: the mapped point relative to t. */
  void
  Rotate(double qx, double qy, double & rx, double & ry) const
  {
    rx = scale * (c * qx - s * qy);
    ry = scale * (s * qx + c * qy);
  }

  void
  Invert(double px, double py, double & qx, double & qy) const
  {
    const double rx = (px - tx) / scale;
    const double ry = (py - ty) / scale;
    qx = c * rx + s * ry;
    qy = -s * rx + c * ry;
  }

  double c;
  double s;
  double scale;
  double tx;
  double ty;
};

/** Distance of a fixed point to the moving point q under the map, q's place, and the unit vector of the distance. */
struct Pair
{
  double distance;
  double rx;
  double ry;
  double nx;
  double ny;
};

inline Pair
MakePair(const Map & map, double qx, double qy, double fixedX, double fixedY)
{
  Pair pair;
  map.Rotate(qx, qy, pair.rx, pair.ry);
  const double dx = pair.rx + map.tx - fixedX;
  const double dy = pair.ry + map.ty - fixedY;
  pair.distance = std::sqrt(dx * dx + dy * dy);
  const double inverse = pair.distance > 0.0 ? 1.0 / pair.distance : 0.0;
  pair.nx = dx * inverse;
  pair.ny = dy * inverse;
  return pair;
}

inline Pair
MatchMoving(const Map & map, const ContourDistanceIndex & fixed, double qx, double qy)
{
  double rx;
  double ry;
  map.Rotate(qx, qy, rx, ry);
  const ContourDistanceIndex::NearestType nearest = fixed.FindNearest(rx + map.tx, ry + map.ty);
  return MakePair(map, qx, qy, nearest.x, nearest.y);
}

inline Pair
MatchFixed(const Map & map, const ContourDistanceIndex & moving, double px, double py)
{
  double qx;
  double qy;
  map.Invert(px, py, qx, qy);
  const ContourDistanceIndex::NearestType nearest = moving.FindNearest(qx, qy);
  return MakePair(map, nearest.x, nearest.y, px, py);
}

/** Pairs of some points at a time, so that each step is a loop of its own that is vectorised. */
constexpr std::size_t BatchSize = 64;
struct PairBatch
{
  Pair   pairs[BatchSize];
  double places[2 * BatchSize];
  double nearest[2 * BatchSize];
};

inline void
MatchMoving(const Map & map, const ContourDistanceIndex & fixed, const double * q, std::size_t count, PairBatch & batch)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    double rx;
    double ry;
    map.Rotate(q[2 * i], q[2 * i + 1], rx, ry);
    batch.places[2 * i] = rx + map.tx;
    batch.places[2 * i + 1] = ry + map.ty;
  }
  fixed.FindNearestPoints(batch.places, count, batch.nearest);
  for (std::size_t i = 0; i < count; ++i)
  {
    batch.pairs[i] = MakePair(map, q[2 * i], q[2 * i + 1], batch.nearest[2 * i], batch.nearest[2 * i + 1]);
  }
}

inline void
MatchFixed(const Map & map, const ContourDistanceIndex & moving, const double * p, std::size_t count, PairBatch & batch)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    map.Invert(p[2 * i], p[2 * i + 1], batch.places[2 * i], batch.places[2 * i + 1]);
  }
  moving.FindNearestPoints(batch.places, count, batch.nearest);
  for (std::size_t i = 0; i < count; ++i)
  {
    batch.pairs[i] = MakePair(map, batch.nearest[2 * i], batch.nearest[2 * i + 1], p[2 * i], p[2 * i + 1]);
  }
}

/** Weighted mean over a side's points of the distance that the matcher gives, and its gradient. */
template <typename TMatch>
double
AccumulateMean(const std::vector<double> &          points,
               const std::vector<double> &          weights,
               double                               truncation,
               double                               scale,
               ContourChamferKernel::GradientType * gradient,
               const TMatch &                       match)
{
  const std::size_t count = weights.size();
  double            sum = 0.0;
  double            sumOfWeights = 0.0;
  double            byScale = 0.0;
  double            byAngle = 0.0;
  double            byX = 0.0;
  double            byY = 0.0;
  PairBatch         batch;
  for (std::size_t first = 0; first < count; first += BatchSize)
  {
    const std::size_t size = std::min(BatchSize, count - first);
    match(&points[2 * first], size, batch);
    for (std::size_t i = 0; i < size; ++i)
    {
      const Pair & pair = batch.pairs[i];
      const double weight = weights[first + i];
      sumOfWeights += weight;
      if (pair.distance >= truncation)
      {
        sum += weight * truncation;
        continue;
      }
      sum += weight * pair.distance;
      byScale += weight * (pair.nx * pair.rx + pair.ny * pair.ry);
      byAngle += weight * (pair.ny * pair.rx - pair.nx * pair.ry);
      byX += weight * pair.nx;
      byY += weight * pair.ny;
    }
  }
  if (gradient != nullptr)
  {
    (*gradient)[0] += byScale / (scale * sumOfWeights);
    (*gradient)[1] += byAngle / sumOfWeights;
    (*gradient)[2] += byX / sumOfWeights;
    (*gradient)[3] += byY / sumOfWeights;
  }
  return sum / sumOfWeights;
}

} // namespace

void
ContourChamferKernel::InitializeSide(SideType &            side,
                                     const ContourArrays & contour,
                                     DistanceEnum          distance,
                                     SearchEnum            search)
{
  side = SideType();
  side.numberOfPoints = contour.GetNumberOfPoints();
  std::vector<std::uint32_t> newId(side.numberOfPoints);
  for (std::size_t i = 0; i < side.numberOfPoints; ++i)
  {
    const double weight = contour.weights.empty() ? 1.0 : contour.weights[i];
    if (!std::isfinite(contour.points[2 * i]) || !std::isfinite(contour.points[2 * i + 1]) || !std::isfinite(weight))
    {
      throw std::invalid_argument("a contour's point or weight is not finite");
    }
    if (weight > 0.0)
    {
      newId[i] = static_cast<std::uint32_t>(side.ids.size());
      side.ids.push_back(static_cast<std::uint32_t>(i));
      side.weights.push_back(weight);
      side.points.push_back(contour.points[2 * i]);
      side.points.push_back(contour.points[2 * i + 1]);
    }
    else
    {
      newId[i] = std::numeric_limits<std::uint32_t>::max();
    }
  }
  if (side.ids.empty())
  {
    throw std::invalid_argument("a contour has no point of positive weight");
  }
  side.index.SetSearch(search);
  if (distance == DistanceEnum::PointToPoint)
  {
    side.index.SetPoints(side.points.data(), side.ids.size());
    return;
  }
  std::vector<std::uint32_t> segments;
  for (std::size_t i = 0; i + 1 < contour.segments.size(); i += 2)
  {
    const std::uint32_t from = newId.at(contour.segments[i]);
    const std::uint32_t to = newId.at(contour.segments[i + 1]);
    if (from != std::numeric_limits<std::uint32_t>::max() && to != std::numeric_limits<std::uint32_t>::max())
    {
      segments.push_back(from);
      segments.push_back(to);
    }
  }
  side.index.SetSegments(side.points.data(), side.ids.size(), segments.data(), segments.size() / 2);
}

void
ContourChamferKernel::Initialize(const ContourArrays & fixed,
                                 const ContourArrays & moving,
                                 DistanceEnum          distance,
                                 SearchEnum            search)
{
  InitializeSide(m_Fixed, fixed, distance, search);
  InitializeSide(m_Moving, moving, distance, search);
}

double
ContourChamferKernel::Evaluate(const ContourSimilarity & similarity,
                               DirectionEnum             direction,
                               GradientType *            gradient,
                               double                    truncation) const
{
  const Map map(similarity);
  if (gradient != nullptr)
  {
    gradient->fill(0.0);
  }
  double value = 0.0;
  if (direction != DirectionEnum::FixedToMoving)
  {
    value += AccumulateMean(m_Moving.points,
                            m_Moving.weights,
                            truncation,
                            map.scale,
                            gradient,
                            [&](const double * q, std::size_t count, PairBatch & batch) {
                              MatchMoving(map, m_Fixed.index, q, count, batch);
                            });
  }
  if (direction != DirectionEnum::MovingToFixed)
  {
    value += AccumulateMean(m_Fixed.points,
                            m_Fixed.weights,
                            truncation,
                            map.scale,
                            gradient,
                            [&](const double * p, std::size_t count, PairBatch & batch) {
                              MatchFixed(map, m_Moving.index, p, count, batch);
                            });
  }
  return value;
}

double
ContourChamferKernel::EvaluateApproximately(const ContourSimilarity & similarity,
                                            DirectionEnum             direction,
                                            double                    truncation,
                                            std::size_t               numberOfPoints) const
{
  const Map map(similarity);
  double    value = 0.0;
  if (direction != DirectionEnum::FixedToMoving)
  {
    const SampleType & sample = TakeSample(m_Moving, numberOfPoints);
    for (std::size_t i = 0; i < sample.weights.size(); ++i)
    {
      double rx;
      double ry;
      map.Rotate(sample.points[2 * i], sample.points[2 * i + 1], rx, ry);
      sample.places[2 * i] = rx + map.tx;
      sample.places[2 * i + 1] = ry + map.ty;
    }
    value += MeanOfSample(sample, m_Fixed.index, 1.0, truncation);
  }
  if (direction != DirectionEnum::MovingToFixed)
  {
    const SampleType & sample = TakeSample(m_Fixed, numberOfPoints);
    for (std::size_t i = 0; i < sample.weights.size(); ++i)
    {
      map.Invert(sample.points[2 * i], sample.points[2 * i + 1], sample.places[2 * i], sample.places[2 * i + 1]);
    }
    value += MeanOfSample(sample, m_Moving.index, map.scale, truncation);
  }
  return value;
}

/** Evenly spaced points of a side, kept for the next call. */
auto
ContourChamferKernel::TakeSample(const SideType & side, std::size_t numberOfPoints) -> const SampleType &
{
  SampleType &      sample = side.sample;
  const std::size_t count = side.weights.size();
  const std::size_t used = std::min(count, std::max<std::size_t>(numberOfPoints, 1));
  if (sample.weights.size() != used)
  {
    sample.points.clear();
    sample.weights.clear();
    for (std::size_t k = 0; k < used; ++k)
    {
      const std::size_t i = (2 * k + 1) * count / (2 * used);
      sample.points.push_back(side.points[2 * i]);
      sample.points.push_back(side.points[2 * i + 1]);
      sample.weights.push_back(side.weights[i]);
    }
    sample.places.resize(2 * used);
    sample.distances.resize(used);
  }
  return sample;
}

/** Weighted mean of the distances, times the scale, at the sample's places. */
double
ContourChamferKernel::MeanOfSample(const SampleType &           sample,
                                   const ContourDistanceIndex & index,
                                   double                       scale,
                                   double                       truncation)
{
  index.FindApproximateDistances(sample.places.data(), sample.weights.size(), sample.distances.data());
  double sum = 0.0;
  double sumOfWeights = 0.0;
  for (std::size_t i = 0; i < sample.weights.size(); ++i)
  {
    sum += sample.weights[i] * std::min(truncation, scale * sample.distances[i]);
    sumOfWeights += sample.weights[i];
  }
  return sum / sumOfWeights;
}

std::vector<double>
ContourChamferKernel::GetMovingToFixedDistances(const ContourSimilarity & similarity) const
{
  const Map           map(similarity);
  std::vector<double> distances(m_Moving.numberOfPoints, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < m_Moving.ids.size(); ++i)
  {
    distances[m_Moving.ids[i]] =
      MatchMoving(map, m_Fixed.index, m_Moving.points[2 * i], m_Moving.points[2 * i + 1]).distance;
  }
  return distances;
}

std::vector<double>
ContourChamferKernel::GetFixedToMovingDistances(const ContourSimilarity & similarity) const
{
  const Map           map(similarity);
  std::vector<double> distances(m_Fixed.numberOfPoints, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < m_Fixed.ids.size(); ++i)
  {
    distances[m_Fixed.ids[i]] =
      MatchFixed(map, m_Moving.index, m_Fixed.points[2 * i], m_Fixed.points[2 * i + 1]).distance;
  }
  return distances;
}
} // namespace itk

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
#ifndef itkPartialContourTestCase_h
#define itkPartialContourTestCase_h

#include "itkPartialContourMetricv4.h"
#include "itkReproducibleRandom.h"

#include <algorithm>
#include <cmath>
#include <vector>

/** A silhouette like a row of cusps, and a tracing of a part of it with noise and outliers under a known similarity. */
namespace PartialContourTestCase
{
using MetricType = itk::PartialContourMetricv4;
using ContourType = itk::DentalContour;
using TransformType = MetricType::TransformType;
using PointType = ContourType::PointType;
using ParametersType = MetricType::ParametersType;

inline PointType
Cusps(double part)
{
  PointType point;
  point[0] = 320.0 * part - 160.0;
  point[1] = 45.0 * std::cos(2.8 * part) + 9.0 * std::abs(std::sin(7.0 * 3.14159265358979 * part)) + 20.0 * part;
  return point;
}

inline ContourType::Pointer
MakeMoving()
{
  std::vector<PointType> points;
  for (int i = 0; i < 250; ++i)
  {
    points.push_back(Cusps(i / 249.0));
  }
  const auto contour = ContourType::New();
  contour->AddPolyline(points);
  return contour;
}

inline TransformType::Pointer
MakeTransform(double scale, double angle, double tx, double ty)
{
  const auto     transform = TransformType::New();
  ParametersType parameters(4);
  parameters[0] = scale;
  parameters[1] = angle;
  parameters[2] = tx;
  parameters[3] = ty;
  transform->SetParameters(parameters);
  return transform;
}

inline TransformType::Pointer
MakeTruth()
{
  return MakeTransform(1.06, 0.07, 310.0, 420.0);
}

/** Points every 3 px or so over [from, to] of the silhouette; this share of them, in runs of four, is elsewhere. */
inline ContourType::Pointer
MakeFixed(double from, double to, double noise, double outliers, std::uint64_t seed = 5)
{
  itk::ReproducibleRandom random(seed);
  const auto              truth = MakeTruth();
  std::vector<PointType>  points;
  const int               count = static_cast<int>(std::lround(110.0 * (to - from)));
  double                  lift = 0.0;
  double                  due = 0.0;
  for (int i = 0; i < count; ++i)
  {
    PointType point = truth->TransformPoint(Cusps(from + (to - from) * i / (count - 1.0)));
    if (i % 4 == 0)
    {
      due += 4.0 * outliers;
      lift = due >= 4.0 ? random.Uniform(12.0, 25.0) : 0.0;
      due -= due >= 4.0 ? 4.0 : 0.0;
    }
    point[0] += random.Normal(0.0, noise);
    point[1] += random.Normal(0.0, noise) + lift;
    points.push_back(point);
  }
  const auto contour = ContourType::New();
  contour->AddPolyline(points);
  return contour;
}

/** Root mean square over the part of the silhouette that is traced of where it should be, px. */
inline double
MeanError(const TransformType * transform, double from, double to)
{
  const auto truth = MakeTruth();
  double     sum = 0.0;
  for (int i = 0; i <= 100; ++i)
  {
    const PointType point = Cusps(from + (to - from) * 0.01 * i);
    sum += truth->TransformPoint(point).SquaredEuclideanDistanceTo(transform->TransformPoint(point)) / 101.0;
  }
  return std::sqrt(sum);
}
} // namespace PartialContourTestCase

#endif

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
#ifndef itkSyntheticContours_h
#define itkSyntheticContours_h

#include "itkDentalContour.h"
#include "itkReproducibleRandom.h"
#include "itkSimilarity2DTransform.h"

#include <algorithm>
#include <cmath>
#include <vector>

/** A closed silhouette with bumps like cusps, and its image under a known similarity as tracing. */
namespace SyntheticContours
{
using ContourType = itk::DentalContour;
using TransformType = itk::Similarity2DTransform<double>;
using PointType = ContourType::PointType;

inline PointType
Outline(double part)
{
  const double t = 2.0 * 3.14159265358979 * part;
  PointType    point;
  point[0] = 120.0 * std::cos(t) + 3.0 * std::sin(3.0 * t);
  point[1] = 45.0 * std::sin(t) + (std::sin(t) > 0.0 ? 6.0 * std::abs(std::sin(7.0 * t)) : 0.0) +
             8.0 * std::cos(2.0 * t) + 4.0 * std::sin(5.0 * t);
  return point;
}

inline ContourType::Pointer
MakeSilhouette(std::size_t count = 220)
{
  std::vector<PointType> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    points.push_back(Outline(static_cast<double>(i) / static_cast<double>(count)));
  }
  const auto contour = ContourType::New();
  contour->AddPolyline(points, itk::ToothCode(), count >= 3);
  return contour;
}

inline TransformType::Pointer
MakeTransform(double scale, double angle, double tx, double ty)
{
  const auto                    transform = TransformType::New();
  TransformType::ParametersType parameters(4);
  parameters[0] = scale;
  parameters[1] = angle;
  parameters[2] = tx;
  parameters[3] = ty;
  transform->SetParameters(parameters);
  return transform;
}

/** The outline between two parts of its length, moved, with white noise of this sigma. */
inline ContourType::Pointer
MakeTracing(const TransformType *     transform,
            std::size_t               count = 79,
            double                    from = 0.0,
            double                    to = 1.0,
            double                    noise = 0.0,
            itk::ReproducibleRandom * random = nullptr)
{
  std::vector<PointType> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double part = (static_cast<double>(i) + 0.3) / static_cast<double>(count);
    PointType    point = transform->TransformPoint(Outline(from + (to - from) * part));
    if (random != nullptr)
    {
      point[0] += random->Normal(0.0, noise);
      point[1] += random->Normal(0.0, noise);
    }
    points.push_back(point);
  }
  const auto contour = ContourType::New();
  contour->AddPolyline(points);
  return contour;
}

/** Largest distance, over the outline, between two transforms. */
inline double
LargestDifference(const TransformType * a, const TransformType * b)
{
  double largest = 0.0;
  for (int i = 0; i < 100; ++i)
  {
    const PointType point = Outline(0.01 * i);
    largest = std::max(largest, a->TransformPoint(point).EuclideanDistanceTo(b->TransformPoint(point)));
  }
  return largest;
}
} // namespace SyntheticContours

#endif

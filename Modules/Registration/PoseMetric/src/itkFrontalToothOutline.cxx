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
#include "itkFrontalToothOutline.h"

#include "itkContourResampling.h"
#include "itkPoseModel.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
/** Positions of front teeth, whose edges are drawn; of those behind them the buccal borders are. */
constexpr unsigned int LastFrontToothOfOutline = 3;
/** Of a normal's component toward the root, beyond which a closed outline is the neck and no border. */
constexpr double OutlineFacesRoot = 0.5;
} // namespace

FrontalToothOutline::FrontalToothOutline(const PoseGeometry &                geometry,
                                         const DentalContour::PolylineType & polyline,
                                         ToothCode::JawEnum                  jaw)
{
  m_Position = polyline.code.GetPosition();
  if (polyline.outline == DentalContour::OutlineEnum::Tooth)
  {
    m_Failure = "it is of a whole tooth with its root, as its \"outline\" says: on a frontal radiograph draw incisal "
                "edges, buccal borders or crowns";
    return;
  }
  std::vector<PointType> drawn;
  for (const auto & pixel : polyline.points)
  {
    drawn.push_back(PoseModel::ToWorkingPlane(geometry, { { pixel[0], pixel[1] } }));
  }
  const double length = drawn.size() < 2 ? 0.0 : ComputePolylineLength(drawn, polyline.closed);
  if (length < SmallestLength)
  {
    m_Failure = "it is " + std::to_string(std::lround(length)) + " px of 0.25 mm long, and at least " +
                std::to_string(std::lround(SmallestLength)) + " are needed";
    return;
  }
  const auto             points = Resample(drawn, polyline.closed);
  const std::size_t      n = points.size();
  const double           occlusal = jaw == ToothCode::JawEnum::Upper ? 1.0 : -1.0;
  const double           outward = polyline.code.IsLeft() ? 1.0 : -1.0;
  std::vector<PointType> normals;
  double                 away = 0.0;
  double                 area = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const PointType & a = points[i];
    const PointType & b = points[(i + 1) % n];
    normals.push_back(ComputeNormal(points, i, polyline.closed));
    away += occlusal * normals.back()[1] + (m_Position > LastFrontToothOfOutline ? outward * normals.back()[0] : 0.0);
    area += a[0] * b[1] - a[1] * b[0];
  }
  const bool isInward = polyline.closed ? area < 0.0 : away < 0.0;
  // A closed outline begins behind the longest part that looks at the root, so that what is left is one run.
  std::size_t begin = 0;
  if (polyline.closed)
  {
    const auto looksAtRoot = [&](std::size_t i) {
      return (isInward ? -occlusal : occlusal) * normals[i % n][1] < -OutlineFacesRoot;
    };
    std::size_t longest = 0, run = 0;
    for (std::size_t i = 0; i < 2 * n; ++i)
    {
      run = looksAtRoot(i) ? std::min(run + 1, n) : 0;
      if (run > longest)
      {
        longest = run;
        begin = (i + 1) % n;
      }
    }
  }
  for (std::size_t k = 0; k < n; ++k)
  {
    const std::size_t i = (begin + k) % n;
    const PointType normal{ { isInward ? -normals[i][0] : normals[i][0], isInward ? -normals[i][1] : normals[i][1] } };
    if (!polyline.closed || occlusal * normal[1] >= -OutlineFacesRoot)
    {
      this->AddPoint(points[i], normal, 0.0);
    }
  }
  for (const PointType & p : m_Points)
  {
    m_Centroid[0] += p[0] / static_cast<double>(m_Points.size());
    m_Centroid[1] += p[1] / static_cast<double>(m_Points.size());
  }
  m_Reference = m_Centroid;
}
} // namespace itk

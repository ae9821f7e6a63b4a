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
#include "itkSceneDetector.h"

#include "itkShortNumber.h"
#include <cmath>
#include <stdexcept>
#include <string>

namespace itk
{
SceneDetector::SceneDetector(const ProjectionType & projection, double sourceToDetector)
  : m_Projection(projection)
  , m_Distance(sourceToDetector)
{
  if (!(sourceToDetector > 0.0) || !std::isfinite(sourceToDetector))
  {
    throw std::invalid_argument("the source-to-detector distance is " + ShortNumber(sourceToDetector) +
                                " mm, not above 0");
  }
  auto &       p = m_Projection;
  const double norm = std::sqrt(p[8] * p[8] + p[9] * p[9] + p[10] * p[10]);
  // A homogeneous matrix has any sign and size. The scene's origin is in the head, in front of the source.
  const double factor = (p[11] < 0.0 ? -1.0 : 1.0) / norm;
  for (double & element : p)
  {
    element *= factor;
  }
  const auto minor = [&p](unsigned int a, unsigned int b, unsigned int row, unsigned int other) {
    return p[4 * row + a] * p[4 * other + b] - p[4 * row + b] * p[4 * other + a];
  };
  const double determinant = p[0] * minor(1, 2, 1, 2) - p[1] * minor(0, 2, 1, 2) + p[2] * minor(0, 1, 1, 2);
  if (!std::isfinite(determinant) || determinant == 0.0 || !(p[11] > 0.0))
  {
    throw std::invalid_argument("the projection is none: its matrix has no source in front of which the scene lies");
  }
  m_Inverse = { { minor(1, 2, 1, 2) / determinant,
                  -minor(1, 2, 0, 2) / determinant,
                  minor(1, 2, 0, 1) / determinant,
                  -minor(0, 2, 1, 2) / determinant,
                  minor(0, 2, 0, 2) / determinant,
                  -minor(0, 2, 0, 1) / determinant,
                  minor(0, 1, 1, 2) / determinant,
                  -minor(0, 1, 0, 2) / determinant,
                  minor(0, 1, 0, 1) / determinant } };
  for (unsigned int d = 0; d < 3; ++d)
  {
    m_Axis[d] = p[8 + d];
    m_Source[d] = -(m_Inverse[3 * d] * p[3] + m_Inverse[3 * d + 1] * p[7] + m_Inverse[3 * d + 2] * p[11]);
  }
}

SceneDetector::PointType
SceneDetector::GetCentralPoint() const
{
  return m_Source + m_Axis * m_Distance;
}

SceneDetector::PixelType
SceneDetector::GetCentralPixel() const
{
  return this->GetPixel(this->GetCentralPoint());
}

SceneDetector::PointType
SceneDetector::GetPoint(double u, double v) const
{
  // The inverse takes a pixel of depth 1 to a point of depth 1.
  PointType point = m_Source;
  for (unsigned int d = 0; d < 3; ++d)
  {
    point[d] += m_Distance * (m_Inverse[3 * d] * u + m_Inverse[3 * d + 1] * v + m_Inverse[3 * d + 2]);
  }
  return point;
}

SceneDetector::PixelType
SceneDetector::GetPixel(const PointType & point) const
{
  std::array<double, 3> rows{};
  for (unsigned int row = 0; row < 3; ++row)
  {
    rows[row] = m_Projection[4 * row + 3];
    for (unsigned int d = 0; d < 3; ++d)
    {
      rows[row] += m_Projection[4 * row + d] * point[d];
    }
  }
  PixelType pixel;
  pixel[0] = rows[0] / rows[2];
  pixel[1] = rows[1] / rows[2];
  return pixel;
}
} // namespace itk

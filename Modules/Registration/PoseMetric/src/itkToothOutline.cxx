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
#include "itkToothOutline.h"

#include <cmath>

namespace itk
{
void
ToothOutline::AddPoint(const PointType & point, const PointType & normal, double lingual)
{
  m_Arc.push_back(
    m_Points.empty() ? 0.0 : m_Arc.back() + std::hypot(point[0] - m_Points.back()[0], point[1] - m_Points.back()[1]));
  m_Points.push_back(point);
  m_Normals.push_back(normal);
  m_Lingual.push_back(lingual);
}
} // namespace itk

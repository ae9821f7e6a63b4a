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
#include "itkMakeContourArrays.h"

#include <cmath>

namespace itk
{
ContourArrays
MakeContourArrays(const DentalContour & contour)
{
  ContourArrays arrays;
  const auto *  points = contour.GetPoints();
  if (points == nullptr)
  {
    return arrays;
  }
  const auto count = static_cast<std::size_t>(points->Size());
  arrays.points.reserve(2 * count);
  bool weighted = false;
  for (std::size_t i = 0; i < count; ++i)
  {
    const DentalContour::PointType & point = points->ElementAt(i);
    if (!std::isfinite(point[0]) || !std::isfinite(point[1]))
    {
      itkGenericExceptionMacro("Point " << i << " of the contour, " << point
                                        << ", is not finite; remove it before measuring distances.");
    }
    arrays.points.push_back(point[0]);
    arrays.points.push_back(point[1]);
    weighted = weighted || contour.GetPointWeight(i) != 1.0;
  }
  if (weighted)
  {
    arrays.weights.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      arrays.weights.push_back(contour.GetPointWeight(i));
    }
  }
  const auto * cells = contour.GetCells();
  if (cells != nullptr)
  {
    arrays.segments.reserve(2 * cells->Size());
    for (auto it = cells->Begin(); it != cells->End(); ++it)
    {
      const auto * cell = it.Value();
      if (cell->GetNumberOfPoints() != 2)
      {
        itkGenericExceptionMacro("Cell " << it.Index() << " of the contour has " << cell->GetNumberOfPoints()
                                         << " points; a contour is made of line cells.");
      }
      for (unsigned int k = 0; k < 2; ++k)
      {
        const auto id = cell->GetPointIds()[k];
        if (id >= count)
        {
          itkGenericExceptionMacro("Cell " << it.Index() << " of the contour names point " << id << " of " << count
                                           << "; build contours with AddPolyline().");
        }
        arrays.segments.push_back(static_cast<std::uint32_t>(id));
      }
    }
  }
  return arrays;
}
} // namespace itk

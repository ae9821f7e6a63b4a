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
#include "itkMakePosePolylines.h"

#include "itkDentalContour.h"

namespace itk
{
std::vector<PosePolyline>
MakePosePolylines(const DentalContour & contour)
{
  std::vector<PosePolyline> polylines;
  for (const auto & polyline : contour.GetPolylines())
  {
    PosePolyline converted;
    converted.tooth = polyline.code.GetFDI();
    converted.closed = polyline.closed;
    converted.weights = polyline.weights;
    for (const auto & point : polyline.points)
    {
      converted.points.push_back({ { point[0], point[1] } });
    }
    polylines.push_back(std::move(converted));
  }
  return polylines;
}
} // namespace itk

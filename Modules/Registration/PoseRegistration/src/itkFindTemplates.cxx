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
#include "itkFindTemplates.h"

#include <algorithm>
#include <array>

namespace itk
{
namespace
{
using OutlineType = ToothOutlineComparison::OutlineType;

void
AddOutline(const std::string &                 name,
           const DentalContour::PolylineType & polyline,
           const std::array<double, 2> &       spacing,
           std::vector<OutlineType> &          outlines)
{
  const bool isOfAPart =
    polyline.outline == DentalContour::OutlineEnum::Crown || polyline.outline == DentalContour::OutlineEnum::Labial;
  if (!polyline.closed || isOfAPart)
  {
    return;
  }
  OutlineType outline{ name, {} };
  for (const auto & point : polyline.points)
  {
    outline.points.push_back({ { spacing[0] * point[0], spacing[1] * point[1] } });
  }
  outlines.push_back(outline);
}

std::vector<DentalContour::PolylineType>
GetPolylines(const DentalContour * contour)
{
  return contour != nullptr ? contour->GetPolylines() : std::vector<DentalContour::PolylineType>{};
}
} // namespace

std::vector<ToothOutlineComparison::TemplateType>
FindTemplates(const PoseProblem & problem, const PoseGeometry & geometry)
{
  const auto &                excluded = problem.options.excludedTeeth;
  const std::array<double, 2> spacing{ { geometry.pixelSpacing[0], geometry.pixelSpacing[1] } };
  std::vector<OutlineType>    outlines;
  for (const PoseJawInput & jaw : problem.jaws)
  {
    for (const auto & polyline : GetPolylines(jaw.tracing))
    {
      const std::string name =
        (jaw.jaw == ToothCode::JawEnum::Upper ? "U" : "L") + std::to_string(polyline.code.GetPosition());
      const bool isExcluded = std::find(excluded.begin(), excluded.end(), polyline.code.GetFDI()) != excluded.end();
      // A tooth's first outline is the one that is used.
      const bool isDrawnAlready =
        std::any_of(outlines.begin(), outlines.end(), [&](const OutlineType & other) { return other.name == name; });
      if (polyline.code.IsKnown() && !isExcluded && !isDrawnAlready)
      {
        AddOutline(name, polyline, spacing, outlines);
      }
    }
  }
  std::vector<OutlineType> stock;
  for (const auto & polyline : GetPolylines(problem.stockOutlines))
  {
    AddOutline((polyline.code.IsKnown() ? polyline.code.GetName() : "an outline") + " of the stock",
               polyline,
               { { 1.0, 1.0 } },
               stock);
  }
  return ToothOutlineComparison::FindTemplates(outlines, stock);
}
} // namespace itk

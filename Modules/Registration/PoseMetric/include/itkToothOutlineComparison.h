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
#ifndef itkToothOutlineComparison_h
#define itkToothOutlineComparison_h

#include "PoseMetricExport.h"

#include <array>
#include <string>
#include <vector>

namespace itk
{
/** \class ToothOutlineComparison
 * \brief Whether closed outlines of whole teeth are one stock outline (a template), moved, turned and scaled.
 *
 * Analysis software offers an outline a tooth, which is placed by tip and axis: in a public set of three tracings the
 * upper incisors of two patients agree to 0.46 pixels under a similarity. Teeth that were drawn differ by their shapes,
 * and two drawings of one tooth by the hand's drift: outlines that agree better than hands draw were not drawn.
 *
 * The similarity, with or without a reflection (of the other jaw, of a face that looks the other way), is the one with
 * the smallest root mean square of the distances from either outline to the other. Outlines are compared as lines: how
 * many points they have, and where they begin, does not matter.
 *
 * \ingroup PoseMetric
 */
class PoseMetric_EXPORT ToothOutlineComparison
{
public:
  using PointType = std::array<double, 2>;
  /** A closed line, without its first point at the end. */
  using LineType = std::vector<PointType>;

  /** Largest distance of outlines that are one, mm. Whatever hands drew of the phantoms of 20 patients is 0.107 mm or
   * more apart (264 pairs of one tooth of two patients, 114 of two teeth of one; medians 0.24 to 0.32); a line whose
   * points are rounded to pixels of 0.1 mm is 0.03 mm beside itself. */
  static constexpr double LargestDistance = 0.07;

  /** How far the outlines are apart: root mean square, in the units of the second; infinite where one of them has fewer
   * than 8 points, no area or a coordinate that is not finite. */
  static double
  ComputeDistance(const LineType & first, const LineType & second);

  /** An outline and what it is called. */
  struct OutlineType
  {
    /** "U1". */
    std::string name;
    /** mm. */
    LineType points;
  };
  /** An outline that is another one, moved. */
  struct TemplateType
  {
    /** Of the outline of the tracing. */
    std::string name;
    /** The outline that is closest to it. */
    std::string of;
    /** mm. */
    double distance;
  };

  /** Those outlines of a tracing that are another one of it, or one of a stock.
   * \param stock  outlines of any size, of which the names are given as they are. */
  static std::vector<TemplateType>
  FindTemplates(const std::vector<OutlineType> & outlines, const std::vector<OutlineType> & stock);
};
} // namespace itk

#endif

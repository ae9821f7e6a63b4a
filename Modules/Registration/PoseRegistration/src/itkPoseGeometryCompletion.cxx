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
#include "itkPoseGeometryCompletion.h"

#include "itkPoseFrameOperations.h"
#include "itkSurfaceParts.h"
#include "itkShortNumber.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace itk
{
namespace
{
bool
IsExcluded(const PoseRegistrationOptions & options, std::uint8_t tooth)
{
  const auto & excluded = options.excludedTeeth;
  return tooth != 0 && std::find(excluded.begin(), excluded.end(), tooth) != excluded.end();
}

/** What was drawn on the radiograph: its extent and centre. */
class DrawingExtent
{
public:
  void
  Add(const double * pixel)
  {
    for (unsigned int k = 0; k < 2; ++k)
    {
      m_Low[k] = std::min(m_Low[k], pixel[k]);
      m_High[k] = std::max(m_High[k], pixel[k]);
      m_Sum[k] += pixel[k];
    }
    m_Count += 1.0;
  }
  bool
  IsEmpty() const
  {
    return m_Count == 0.0;
  }
  std::array<double, 2>
  GetCentre() const
  {
    return { { m_Sum[0] / m_Count, m_Sum[1] / m_Count } };
  }
  /** Along the arch: the vertical part of its slant counts half. */
  double
  GetLength() const
  {
    return std::max(1.0, std::hypot(m_High[0] - m_Low[0], 0.5 * (m_High[1] - m_Low[1])));
  }

private:
  double m_Low[2] = { 1e300, 1e300 };
  double m_High[2] = { -1e300, -1e300 };
  double m_Sum[2] = { 0, 0 };
  double m_Count = 0.0;
};

DrawingExtent
MeasureTracings(const PoseProblem & problem)
{
  DrawingExtent extent;
  for (const PoseJawInput & jaw : problem.jaws)
  {
    if (jaw.tracing.IsNull())
    {
      continue;
    }
    for (const auto & polyline : jaw.tracing->GetPolylines())
    {
      if (IsExcluded(problem.options, polyline.code.GetFDI()))
      {
        continue;
      }
      for (const auto & p : polyline.points)
      {
        extent.Add(p.GetDataPointer());
      }
    }
  }
  return extent;
}

/** The marks that have a counterpart; depth: how far these lie apart along x, mm. */
DrawingExtent
MeasureLandmarks(const PoseProblem & problem, double & depth)
{
  DrawingExtent extent;
  double        front = -1e300, back = 1e300;
  for (const PoseJawInput & jaw : problem.jaws)
  {
    if (jaw.landmarks.IsNull() || jaw.counterparts.IsNull())
    {
      continue;
    }
    for (const auto & landmark : jaw.landmarks->GetLandmarks())
    {
      const auto * counterpart = jaw.counterparts->Find(CephalometricLandmarkSet::MakeName(landmark.meaning));
      if (counterpart == nullptr)
      {
        continue;
      }
      extent.Add(landmark.point.GetDataPointer());
      double x = 0.0;
      for (const auto & p : counterpart->points)
      {
        x += ToDentalFrame(jaw.frame, { { p[0], p[1], p[2] } })[0] / static_cast<double>(counterpart->points.size());
      }
      front = std::max(front, x);
      back = std::min(back, x);
    }
  }
  depth = std::max(0.0, front - back);
  return extent;
}

/** The outlines of whole teeth that have a crown; depth: how far the crowns lie apart along x, mm. */
DrawingExtent
MeasureOutlines(const PoseProblem & problem, double & depth)
{
  DrawingExtent extent;
  double        front = -1e300, back = 1e300;
  for (const PoseJawInput & jaw : problem.jaws)
  {
    if (jaw.tracing.IsNull() || jaw.crowns.IsNull())
    {
      continue;
    }
    for (const auto & polyline : jaw.tracing->GetPolylines())
    {
      const auto * crown = polyline.code.IsKnown() ? jaw.crowns->Find(polyline.code) : nullptr;
      if (crown == nullptr || IsExcluded(problem.options, polyline.code.GetFDI()))
      {
        continue;
      }
      double middle[2] = { 0.0, 0.0 };
      for (const auto & p : polyline.points)
      {
        middle[0] += p[0] / static_cast<double>(polyline.points.size());
        middle[1] += p[1] / static_cast<double>(polyline.points.size());
      }
      extent.Add(middle);
      const auto   centroid = crown->surface->AreaCentroid();
      const double x = ToDentalFrame(jaw.frame, { { centroid[0], centroid[1], centroid[2] } })[0];
      front = std::max(front, x);
      back = std::min(back, x);
    }
  }
  depth = std::max(0.0, front - back);
  return extent;
}

/** What the nominal geometry does not know, as the start has it. */
PoseGeometry
TakeFromStart(const PoseProblem & problem)
{
  PoseGeometry geometry = problem.nominal;
  if (!problem.initialGeometry)
  {
    return geometry;
  }
  if (!geometry.principalPointKnown)
  {
    geometry.principalPoint = problem.initialGeometry->principalPoint;
  }
  if (!geometry.pixelSpacingKnown)
  {
    geometry.pixelSpacing = problem.initialGeometry->pixelSpacing;
  }
  return geometry;
}
} // namespace

PoseGeometry
CompleteGeometry(const PoseProblem & problem)
{
  const PoseRegistrationOptions & options = problem.options;
  if (problem.initialGeometry && (options.fixScale || options.fixRotation || options.fixTranslation))
  {
    // What is held at a start is held in the geometry that it is of.
    return TakeFromStart(problem);
  }
  // An earlier estimate is a start and no fact: what is estimated is estimated from what this run uses, so that the
  // answer at the start's place is that of a run from nothing.
  PoseGeometry  geometry = problem.nominal;
  double        depth = 0.0;
  DrawingExtent extent;
  if (options.tracedSide != TracedSideEnum::Standard)
  {
    extent = MeasureTracings(problem);
  }
  const bool byTeeth = extent.IsEmpty();
  if (byTeeth)
  {
    extent = MeasureLandmarks(problem, depth);
  }
  if (extent.IsEmpty())
  {
    extent = MeasureOutlines(problem, depth);
  }
  if (extent.IsEmpty())
  {
    return TakeFromStart(problem);
  }
  if (!geometry.principalPointKnown)
  {
    geometry.principalPoint = extent.GetCentre();
  }
  if (!geometry.pixelSpacingKnown)
  {
    // The length of the arches along x against that of the tracing. Teeth at the back may be untraced: the search over
    // scale settles the rest.
    for (const PoseJawInput & jaw : problem.jaws)
    {
      if (jaw.surface == nullptr || byTeeth)
      {
        continue;
      }
      const auto extent =
        SurfaceParts(*jaw.surface)
          .ComputeExtent(*jaw.surface, { { jaw.frame.rotation[0], jaw.frame.rotation[1], jaw.frame.rotation[2] } });
      depth = std::max(depth, extent.second - extent.first);
    }
    // Marks that all stand above one place tell no scale: as on most films.
    const double spacing = depth > 5.0
                             ? depth * geometry.sourceToDetector / geometry.sourceToMidsagittal / extent.GetLength()
                             : PoseWorkingPixel;
    geometry.pixelSpacing = { { spacing, spacing } };
  }
  return geometry;
}

void
CheckGeometry(const PoseGeometry & geometry)
{
  if (!(geometry.sourceToMidsagittal > 0.0) || !(geometry.sourceToDetector > geometry.sourceToMidsagittal))
  {
    throw PoseGeometryError("source-to-midsagittal distance " + ShortNumber(geometry.sourceToMidsagittal) +
                            " mm must be positive and smaller than the source-to-detector distance " +
                            ShortNumber(geometry.sourceToDetector) + " mm");
  }
  if (!(geometry.pixelSpacing[0] > 0.0) || !(geometry.pixelSpacing[1] > 0.0))
  {
    throw PoseGeometryError("the pixel spacing must be positive; mark it as unknown where it is not known");
  }
}
} // namespace itk

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
#ifndef itkCrownRegionKernel_h
#define itkCrownRegionKernel_h

#include "CrownRegionExport.h"
#include "itkToothCode.h"
#include "itkTriangleSurface.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace itk
{
/** \struct CrownRegionOptions
 * \brief Parameters of ComputeCrownRegion(); lengths in mm.
 * \ingroup CrownRegion
 */
struct CrownRegion_EXPORT CrownRegionOptions
{
  /** The gingival margin is looked for between these depths below the occlusal surface. */
  double minimumCrownHeight{ 2.5 };
  double maximumCrownHeight{ 12.5 };
  /** Where the margin is taken to be without evidence: at the midline, and from posteriorDistance of arch length on. */
  double anteriorCrownHeight{ 7.9 };
  double posteriorCrownHeight{ 5.5 };
  double posteriorDistance{ 36.0 };
  /** Cost of a margin that is off the expected height by crownHeightScale, in radians of turning angle. */
  double priorWeight{ 0.08 };
  double crownHeightScale{ 2.5 };
  /** Cost of a change of the margin's height, radians a mm. */
  double smoothness{ 0.15 };
  /** Cost of a margin behind another valley, by that valley's turning angle. */
  double passedWeight{ 0.6 };
  /** No tooth is where all lies deeper than this below the occlusal surface; up to 1.5 mm more where a margin is plain.
   */
  double gapDepth{ 3.5 };
  /** The crowns end this far above the valley's bottom: its gingival half is not theirs. */
  double marginInset{ 0.15 };
  /** The final line runs within this distance of that margin, in the valley that costs it least. */
  double marginReach{ 3.5 };
  /** Crowns lie within this horizontal distance of the arch's middle line. */
  double archHalfWidth{ 9.0 };
  /** Pieces of crown, and holes in it, that are smaller (mm^2) are given to what surrounds them. */
  double minimumPieceArea{ 12.0 };
  /** Polled between steps; true ends with an invalid result. */
  std::function<bool()> abort;
};

/** \struct CrownRegionResult
 * \brief What ComputeCrownRegion() found.
 * \ingroup CrownRegion
 */
struct CrownRegion_EXPORT CrownRegionResult
{
  /** False where no arch was found; the masks are 0 then. */
  bool valid{ false };
  /** 1 on crowns, 0 elsewhere; at each point and each triangle. */
  std::vector<std::uint8_t> points;
  std::vector<std::uint8_t> triangles;
  /** Area of the crowns' triangles, mm^2. */
  double area{ 0.0 };
  /** Mean depth of the margin below the occlusal surface, mm. */
  double meanCrownHeight{ 0.0 };
  /** Mean turning angle (radians) of the surface across the margin; below about 0.2 there is hardly a valley. */
  double marginAngle{ 0.0 };
};

/** The crowns of one jaw from its shape alone: what stands above the gingival valley along the arch. `axes` (rows x
 * anterior, y left, z superior) and `origin` are its UMDA frame, q = axes (p - origin); the origin is inside the arch.
 * Surfaces in mm; either winding. Open shells, palates and closed casts. Documentation/CrownRegion.md describes the
 * method. Deterministic; single-threaded. Throws std::invalid_argument of an unknown jaw. */
CrownRegion_EXPORT CrownRegionResult
ComputeCrownRegion(const TriangleSurface &                      surface,
                   ToothCode::JawEnum                           jaw,
                   const std::array<std::array<double, 3>, 3> & axes,
                   const std::array<double, 3> &                origin,
                   const CrownRegionOptions &                   options = {});

/** The crowns by labels, one a point, 0 = not a tooth: triangles of which at least two corners are labelled. Throws
 * std::invalid_argument where the numbers differ. */
CrownRegion_EXPORT CrownRegionResult
CrownRegionFromLabels(const TriangleSurface & surface, const std::vector<std::uint8_t> & labels);
} // namespace itk

#endif

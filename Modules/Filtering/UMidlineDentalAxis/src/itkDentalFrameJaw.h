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
#ifndef itkDentalFrameJaw_h
#define itkDentalFrameJaw_h

#include "itkDentalFrameArch.h"

#include <vector>

// One jaw on its way through the steps, and what is said of it at the end: baseline, midpoint, incisal edge and how far
// each can be trusted. Private to this module.
namespace itk
{
namespace DentalFrameKernel
{
/** Vertical and U of one jaw, on the way to its frame. */
struct Jaw
{
  const TriangleSurface * surface{ nullptr };
  ToothCode::JawEnum      jaw{ ToothCode::JawEnum::Upper };
  bool                    valid{ false };
  /** The normals had to be turned: the mesh is wound inward. */
  bool     turned{ false };
  Samples  samples;
  Vertical vertical;
  Arch     arch;
  double   margin{ 0.0 };

  Vector3
  Superior() const
  {
    return jaw == ToothCode::JawEnum::Upper ? -1.0 * vertical.direction : vertical.direction;
  }
};

/** The crowns with whole height, as the mirror plane wants them. */
OrientedPointSet
MirrorSet(const Jaw & jaw, const DentalFrameOptions & options);

/** The plane across which the sets are their own mirror images, searched in every direction about the vertical. */
MidsagittalPlaneResult
CoarseMirror(const std::vector<OrientedPointSet> & sets, const Vector3 & vertical, const DentalFrameOptions & options);

/** Takes over the mirror plane. The crowns are as high on the left as on the right: their plane loses its roll, which
 * missing teeth had given it. */
void
SetMirror(Jaw & jaw, const MidsagittalPlaneResult & mirror);

/** Takes the mesh as wound the other way. */
void
TurnSamples(Jaw & jaw);

/** The jaw's own mirror plane and its U; the vertical is known. */
void
FindArch(Jaw & jaw, const DentalFrameOptions & options);

/** From 0 to 1 between two values, in either order: how far a measure supports a confidence. */
double
Ramp(double value, double zero, double one);

/** Baseline, midpoint, incisal edge and the confidences, from the jaw's own U; the axes are set. */
void
Describe(const Jaw & jaw, DentalJawFrame & frame);
} // namespace DentalFrameKernel
} // namespace itk

#endif

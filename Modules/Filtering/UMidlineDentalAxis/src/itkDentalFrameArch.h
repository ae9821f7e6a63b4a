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
#ifndef itkDentalFrameArch_h
#define itkDentalFrameArch_h

#include "itkDentalFrameVertical.h"
#include "itkMidsagittalPlaneEstimator.h"
#include "itkToothCode.h"

#include <array>
#include <cstddef>

// The estimator's third step: the crowns, seen along the vertical, lie on a U; its axis is the anterior direction.
// Private to this module.
namespace itk
{
namespace DentalFrameKernel
{
/** Terms of the U's curve: enough for a jaw's shape, too few to follow single teeth. */
constexpr std::size_t ArchTerms = 5;

/** The U: r(phi) = sum a_k cos(k phi) about a centre, phi counted from the anterior direction. */
struct Arch
{
  Vector3                       anterior{ 0.0, 0.0, 0.0 };
  Vector3                       lateral{ 0.0, 0.0, 0.0 };
  Vector3                       centre{ 0.0, 0.0, 0.0 };
  std::array<double, ArchTerms> terms{};
  double                        radius{ 0.0 };
  /** mm: robust spread of the crowns about the U. */
  double spread{ 0.0 };
  /** How clear it is where the front is: 0 for a closed ring, 1 or more for a U. */
  double                 resultant{ 0.0 };
  MidsagittalPlaneResult mirror;
  /** Angle that the crowns reach on the side where they reach less. */
  double reach{ 0.0 };
  bool   valid{ false };
};

/** The U's distance from its centre in the direction phi. */
double
ArchRadius(const std::array<double, ArchTerms> & terms, double phi);

/** The paper's X: baseline between left and right molars, across which is the anterior direction. Which points of the
 * left and the right crowns belong together is what their mirror symmetry says: uneven trimming or a missing molar then
 * turns nothing. The U is the even curve about that axis. The front is where the crowns say, or such
 * that the lateral axis goes with the one given. */
Arch
FitArch(const Samples &                samples,
        const Vertical &               vertical,
        ToothCode::JawEnum             jaw,
        const MidsagittalPlaneResult & mirror,
        const Vector3 *                givenLateral = nullptr);
} // namespace DentalFrameKernel
} // namespace itk

#endif

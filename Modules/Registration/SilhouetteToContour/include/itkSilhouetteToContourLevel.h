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
#ifndef itkSilhouetteToContourLevel_h
#define itkSilhouetteToContourLevel_h

#include <array>
#include <cstddef>
#include <string>

namespace itk
{
/** \class SilhouetteToContourLevel
 * \brief What one level of SilhouetteToContourRegistrationMethod may search, and how.
 *
 * Bounds are half-widths around the estimate at the level's start.
 *
 * \ingroup SilhouetteToContour
 */
struct SilhouetteToContourLevel
{
  /** Fraction: 0.35 allows 0.65 to 1.35 times the current scale. In [0, 1). */
  double scaleBound{ 0.35 };
  /** Radians. */
  double rotationBound{ 0.0 };
  /** Shift of the silhouette's centroid in u and in v, mm in the plane of the pixel spacing. */
  double translationBound{ 0.0 };
  /** Candidates on a grid over the bounds before the optimizer runs: this many a parameter, the current estimate always
   * among them; 0: none. */
  unsigned int numberOfScales{ 0 };
  unsigned int numberOfRotations{ 0 };
  unsigned int numberOfTranslations{ 0 };
  /** The optimizer runs from this many of the best candidates; the best result is kept. */
  unsigned int numberOfStarts{ 1 };
  /** Maximum of the optimizer's iterations from a start; 0 leaves the optimizer's own. */
  std::size_t numberOfIterations{ 0 };
};

/** \class SilhouetteToContourLevelResult
 * \brief How a level of SilhouetteToContourRegistrationMethod went.
 * \ingroup SilhouetteToContour
 */
struct SilhouetteToContourLevelResult
{
  /** Parameters of the transform (scale, rad, px, px) and value of the metric at the level's start and end. */
  std::array<double, 4> initialParameters{};
  std::array<double, 4> finalParameters{};
  double                initialValue{ 0.0 };
  double                finalValue{ 0.0 };
  /** Scale, rotation, shift of the centroid in u and v: -1 where the result lies on the lower bound, +1 on the upper,
   * else 0. A parameter that was held fixed gives 0. */
  std::array<int, 4> boundsHit{};
  std::size_t        numberOfIterations{ 0 };
  std::size_t        numberOfEvaluations{ 0 };
  std::size_t        numberOfCandidates{ 0 };
  std::string        stopConditionDescription;
};
} // namespace itk

#endif

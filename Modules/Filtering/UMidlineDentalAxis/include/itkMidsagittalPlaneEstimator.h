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
#ifndef itkMidsagittalPlaneEstimator_h
#define itkMidsagittalPlaneEstimator_h

#include "UMidlineDentalAxisExport.h"

#include <array>
#include <vector>

namespace itk
{
/** \struct OrientedPointSet
 * \brief Surface samples with unit normals, mm, as flat arrays. Free of ITK headers.
 * \ingroup UMidlineDentalAxis
 */
struct UMidlineDentalAxis_EXPORT OrientedPointSet
{
  using VectorType = std::array<double, 3>;

  std::vector<VectorType> points;  /**< mm. */
  std::vector<VectorType> normals; /**< Of length 1, as many as points. */
};

/** \struct MidsagittalPlaneOptions
 * \brief Parameters of EstimateMidsagittalPlane().
 * \ingroup UMidlineDentalAxis
 */
struct UMidlineDentalAxis_EXPORT MidsagittalPlaneOptions
{
  /** A point is matched at (p, normalWeight * n), mm: without normals the arch interlocks one tooth off. */
  double normalWeight{ 2.0 };
  /** Share of the pairs, the closest ones, that an update uses. */
  double trimmedFraction{ 0.75 };
  /** Distances count up to this value (mm) while searching, and as inliers. */
  double truncationDistance{ 2.0 };
  /** And up to this one where the leaders are ranked: teeth that are mirror images of each other lie within it, and
   * those that have none, as beside a closed gap or a milk molar, count alike wherever they come to lie. */
  double rankingDistance{ 1.0 };
  /** Samples of all jaws together while searching, and in the final updates. */
  unsigned int searchSamples{ 600 };
  unsigned int finalSamples{ 4000 };
  /** Angle between the starts about z, and how far they go to either side of the lateral direction given; degrees. */
  double startStep{ 10.0 };
  double startRange{ 90.0 };
  /** Restart the winner from yaw and offset steps around it (+-2.5, 5, 8, 12 degrees by -1.5, 0, 1.5 mm), again
   * while that finds a better one. */
  bool restarts{ true };
};

/** \struct MidsagittalPlaneResult
 * \brief The plane dot(normal, p) = offset about which the arches mirror best.
 * \ingroup UMidlineDentalAxis
 */
struct UMidlineDentalAxis_EXPORT MidsagittalPlaneResult
{
  /** False where there were too few samples; the plane is then meaningless. */
  bool valid{ false };
  /** Unit normal; its sign is not determined by the symmetry (it is the sign of the start). */
  std::array<double, 3> normal{ { 0.0, 1.0, 0.0 } };
  double                offset{ 0.0 };
  /** Mean over the samples of min(distance to the mirrored surface, truncation distance), mm. */
  double residual{ 0.0 };
  /** Share of the samples whose mirror image is nearer than the truncation distance. */
  double inlierFraction{ 0.0 };
  /** Residual of the best solution that differs by more than 2 degrees or 1 mm, minus the winner's; mm. */
  double margin{ 0.0 };

  friend bool
  operator==(const MidsagittalPlaneResult & a, const MidsagittalPlaneResult & b)
  {
    return a.valid == b.valid && a.normal == b.normal && a.offset == b.offset && a.residual == b.residual &&
           a.inlierFraction == b.inlierFraction && a.margin == b.margin;
  }
};

/** The mirror plane of one arch or of several together: trimmed mirror-ICP on six-dimensional points (p, w n), starts
 * about z, restarts of the winner in yaw and offset, closed-form update (Documentation/UMDA.md derives it).
 *
 * Mirror images are matched within one set only. Deterministic, and independent of the frame of the input up to
 * rounding: samples are taken by index and the starts are counted from a direction of the data.
 *
 * \param jaws  samples of each jaw in one common frame; uniform over the surface.
 * \param vertical  unit vector about which the starts are spread (either sign).
 * \param lateral  a first normal of the plane, or zeros where none is known. */
UMidlineDentalAxis_EXPORT MidsagittalPlaneResult
EstimateMidsagittalPlane(const std::vector<OrientedPointSet> & jaws,
                         const std::array<double, 3> &         vertical,
                         const std::array<double, 3> &         lateral,
                         const MidsagittalPlaneOptions &       options);
} // namespace itk

#endif

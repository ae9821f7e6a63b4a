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
#ifndef itkOpenSilhouette_h
#define itkOpenSilhouette_h

#include "SilhouetteContourExport.h"
#include "itkCephalometricDirection.h"
#include "itkMeshSilhouette.h"
#include "itkPerspectiveProjection.h"
#include "itkToothCode.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace itk
{
/** \struct OpenSilhouetteOptions
 * \brief What ComputeOpenSilhouette() keeps.
 * \ingroup SilhouetteContour
 */
struct SilhouetteContour_EXPORT OpenSilhouetteOptions
{
  ToothCode::JawEnum jaw{ ToothCode::JawEnum::Upper }; /**< Whose outline it is: what may be traced differs. */
  /** From where the picture was taken: what may be traced differs. */
  CephalometricDirectionEnum direction{ CephalometricDirectionEnum::Lateral };
  /** Angle (rad) about the lateral axis from the dental frame to the picture: facing is judged in the dental frame, so
   * that the head's pitch does not change which part is kept. In a frontal picture pitch turns nothing: 0. */
  double pitch{ 0.0 };
  /** Between samples, units of the picture. */
  double spacing{ 0.5 };
  /** Normals are those of chords over this far to both sides, units of the picture. */
  double tangentReach{ 1.5 };
  /** Loops with less than this share of the largest one's area are specks. */
  double smallestPart{ 0.02 };
  /** Off: every sample is kept. */
  bool facingOnly{ true };
  /** On: OpenSilhouette::edges is filled. */
  bool keepEdges{ false };
};

/** \struct OpenSilhouette
 * \brief The part of an outline that a tracing can lie on: samples with outward normals and their surface points.
 * \ingroup SilhouetteContour
 */
struct OpenSilhouette
{
  std::vector<double> u;  /**< First coordinate of each sample, units of the picture. */
  std::vector<double> v;  /**< Second coordinate. */
  std::vector<double> nu; /**< Outward normal in the plane, of length 1 with nv. */
  std::vector<double> nv; /**< Its second component. */
  /** Object frame, mm. */
  std::vector<std::array<double, 3>> rim;
  /** The mesh edge on which rim lies, as indices into the surface's points; empty unless it was asked for. */
  std::vector<std::array<std::uint32_t, 2>> edges;
  /** Starts of the connected runs in the arrays above. */
  std::vector<std::size_t> runs;
  /** Number of samples. */
  std::size_t
  Size() const
  {
    return u.size();
  }
};

/** Whether an outward normal is occlusal (within 78 degrees) or anterior and at most 30 degrees apical: what can be
 * traced of the crowns, and no palate, underside or distal end. In the dental frame's own plane, u anterior, v
 * inferior. */
inline bool
FacesOcclusallyOrAnteriorly(double nu, double nv, ToothCode::JawEnum jaw)
{
  const double occlusal = jaw == ToothCode::JawEnum::Upper ? nv : -nv;
  return occlusal > -0.5 && (occlusal > 0.2 || nu > 0.2);
}

/** The same of a frontal picture, u to one side: occlusal, or to either side and at most 30 degrees apical. */
inline bool
FacesOcclusallyOrSideways(double nu, double nv, ToothCode::JawEnum jaw)
{
  return FacesOcclusallyOrAnteriorly(std::abs(nu), nv, jaw);
}

/** By the direction of the picture. */
inline bool
CanBeTraced(double nu, double nv, ToothCode::JawEnum jaw, CephalometricDirectionEnum direction)
{
  return direction == CephalometricDirectionEnum::Lateral ? FacesOcclusallyOrAnteriorly(nu, nv, jaw)
                                                          : FacesOcclusallyOrSideways(nu, nv, jaw);
}

/** The occlusally and anteriorly (frontal: or sideways) facing part of the outer boundary of a surface's projection.
 * `projection` maps to a picture with u anterior and v inferior (patient facing right; frontal: to one side) in units
 * of about a pixel (0.25 mm). Empty where there is nothing to project; throws as
 * MeshSilhouette::ComputeOuterBoundary(). */
SilhouetteContour_EXPORT OpenSilhouette
ComputeOpenSilhouette(const MeshSilhouette &        silhouette,
                      const PerspectiveProjection & projection,
                      const OpenSilhouetteOptions & options);
} // namespace itk

#endif

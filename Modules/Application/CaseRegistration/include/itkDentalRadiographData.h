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
#ifndef itkDentalRadiographData_h
#define itkDentalRadiographData_h

#include "itkValueSource.h"

#include "itkCephalometricGeometry.h"
#include "itkCephalometricLandmarkSet.h"
#include "itkImage.h"
#include "itkPixelSpacingVerdict.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace itk
{
/** \struct DentalRadiographData
 * \brief A radiograph of a case in memory: picture, landmarks to register with, geometry with the origin of each value.
 *
 * The case itself has one, and each of its views.
 *
 * \ingroup CaseRegistration
 */
struct DentalRadiographData
{
  using ImageType = Image<float, 2>;

  /** Where each value of the geometry came from. */
  struct SourcesType
  {
    /** Frontal: of the distance to the midcoronal plane. */
    ValueSourceEnum sourceToMidsagittal{ ValueSourceEnum::Default };
    ValueSourceEnum sourceToDetector{ ValueSourceEnum::Default };
    /** Frontal: of whether the source is behind or in front. */
    ValueSourceEnum sourceSide{ ValueSourceEnum::Default };
    /** Frontal: of where the patient's left is. */
    ValueSourceEnum facing{ ValueSourceEnum::Default };
    ValueSourceEnum pixelSpacing{ ValueSourceEnum::Estimated };
    ValueSourceEnum principalPoint{ ValueSourceEnum::Estimated };
  };

  /** Null without a radiograph. */
  ImageType::Pointer          image;
  std::array<unsigned int, 2> imageSize{ { 0, 0 } };
  /** Identity pose. Without a known spacing it has none; without a known principal point that is (0, 0). A view's is
   * complete, begun with what is likely. */
  CephalometricGeometry::Pointer geometry;
  SourcesType                    sources;
  /** How the pixel spacing came about, in words. */
  std::string spacingProvenance;
  /** What plane the pixel spacing is known to be of. */
  PixelSpacingVerdictEnum spacingVerdict{ PixelSpacingVerdictEnum::Unknown };
  /** Marked on the radiograph, to register with; null where none were given. */
  CephalometricLandmarkSet::Pointer cephalometricLandmarks;
  /** Contours whose codes do not say their side: U1, L6. */
  std::size_t sidelessContours{ 0 };
  /** mm a pixel and origin (mm) of the grid in which markups lie; nothing where nobody knows. */
  std::optional<std::array<double, 4>> markupsGrid;

  /** Whether the geometry has a pixel spacing, known or begun with. */
  bool
  HasPixelSpacing() const
  {
    return geometry->HasPixelSpacing();
  }
  /** Whether somebody said where the central ray meets the detector. */
  bool
  HasPrincipalPoint() const
  {
    return sources.principalPoint != ValueSourceEnum::Estimated;
  }
};
} // namespace itk

#endif

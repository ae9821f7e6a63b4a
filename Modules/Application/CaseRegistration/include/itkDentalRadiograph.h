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
#ifndef itkDentalRadiograph_h
#define itkDentalRadiograph_h

#include "itkCephalometricGeometry.h"
#include "itkCephalometricLandmarkSet.h"

#include <array>
#include <optional>
#include <string>

namespace itk
{
/** \struct DentalRadiograph
 * \brief A radiograph of a case as the case file says it: the picture, what is known of its geometry, what was drawn on
 * it. The case itself has one, and each of its views.
 *
 * Nothing is defaulted here but what the contract defaults: an absent optional is unknown. Paths are as they can be
 * opened from the current directory.
 *
 * \ingroup CaseRegistration
 */
struct DentalRadiograph
{
  std::string imageFile; /**< The picture; "" where the case has none. */
  /** Width and height, where the file states them. */
  std::optional<std::array<unsigned int, 2>> imageSize;
  std::optional<std::array<double, 2>>       pixelSpacing;
  /** Of the pixel spacing: at the plane through the ear rods (midsagittal; frontal: midcoronal) instead of the
   * detector. */
  bool                                             spacingAtMidsagittalPlane{ false };
  bool                                             spacingPlaneIsGiven{ false };
  std::optional<CephalometricGeometry::FacingEnum> facing;
  /** mm, to the plane through the ear rods (midsagittal; frontal: midcoronal) and to the detector. */
  std::optional<double>                                sourceToMidsagittal;
  std::optional<double>                                sourceToDetector;
  std::optional<CephalometricGeometry::SourceSideEnum> sourceSide;
  std::optional<std::array<double, 2>>                 principalPoint;

  std::string contoursFile; /**< The tracing; "" where there is none. */
  /** mm a pixel that the radiograph had where markups were made on it, whose positions are in mm. */
  std::optional<std::array<double, 2>> markupsSpacing;
  /** A file of landmarks to register with; "" where none is named. */
  std::string cephalometricLandmarksFile;
  /** The landmarks themselves, where the case file holds them; else null. */
  CephalometricLandmarkSet::ConstPointer cephalometricLandmarks;
  /** Only for measuring errors: nothing that registers reads it. */
  std::string landmarks2DFile;
};
} // namespace itk

#endif

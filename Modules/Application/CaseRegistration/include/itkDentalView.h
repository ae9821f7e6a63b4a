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
#ifndef itkDentalView_h
#define itkDentalView_h

#include "itkCephalometricGeometry.h"
#include "itkCephalometricLandmarkSet.h"

#include <array>
#include <optional>
#include <string>

namespace itk
{
/** \struct DentalView
 * \brief A further radiograph of a case, as its case file says it ("views").
 *
 * As of DentalCase nothing is defaulted here but what the contract defaults, and paths are as they can be opened.
 *
 * \ingroup CaseRegistration
 */
struct DentalView
{
  std::string                          name;
  CephalometricGeometry::DirectionEnum direction{ CephalometricGeometry::DirectionEnum::Frontal };

  std::string                                imageFile;
  std::optional<std::array<unsigned int, 2>> imageSize;
  std::optional<std::array<double, 2>>       pixelSpacing;
  /** At the plane through the ear rods instead of the detector. */
  bool spacingAtEarRods{ false };

  /** Frontal: where the patient's left and the source are. */
  std::optional<CephalometricGeometry::PatientLeftEnum>   patientLeft;
  std::optional<CephalometricGeometry::FrontalSourceEnum> frontalSource;
  /** Lateral. */
  std::optional<CephalometricGeometry::FacingEnum>     facing;
  std::optional<CephalometricGeometry::SourceSideEnum> sourceSide;
  /** mm, to the plane through the ear rods, midcoronal or midsagittal. */
  std::optional<double>                sourceToEarRods;
  std::optional<double>                sourceToDetector;
  std::optional<std::array<double, 2>> principalPoint;
  /** px. */
  std::optional<double> principalPointSigma;

  std::string contoursFile;
  std::string cephalometricLandmarksFile;
  /** The landmarks themselves, where the case file holds them; else null. */
  CephalometricLandmarkSet::ConstPointer cephalometricLandmarks;
  /** Only for measuring errors: nothing that registers reads it. */
  std::string landmarks2DFile;
  bool        sameHeadPosition{ true };
};
} // namespace itk

#endif

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
#ifndef itkPixelSpacingVerdict_h
#define itkPixelSpacingVerdict_h

#include "CephalogramExport.h"

#include <array>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>

namespace itk
{
/** What a radiograph's pixel spacing is worth. \ingroup Cephalogram */
enum class PixelSpacingVerdictEnum : uint8_t
{
  /** Physical size of the detector's pixels, magnification not corrected. */
  Detector,
  /** Corrected by the maker for magnification, with a statement that it was. */
  Calibrated,
  /** The detector's, divided by the file's estimated radiographic magnification factor. */
  EstimatedMagnification,
  /** No spacing, or one whose plane cannot be told. Never used as a number. */
  Unknown,
  /** Given by the user, who overrides the file. */
  UserGiven
};

/** The plane in which a spacing holds. \ingroup Cephalogram */
enum class SpacingPlaneEnum : uint8_t
{
  Detector,
  /** The patient's midsagittal plane, more exactly the plane that the calibration meant. */
  Midsagittal,
  Unknown
};

Cephalogram_EXPORT std::ostream &
                   operator<<(std::ostream & os, PixelSpacingVerdictEnum verdict);
Cephalogram_EXPORT std::ostream &
                   operator<<(std::ostream & os, SpacingPlaneEnum plane);

/** \class RadiographSpacingTags
 * \brief What DICOM has to say on a projection radiograph's spacing. Pairs are in the file's order, row\\column, mm.
 * \ingroup Cephalogram */
struct RadiographSpacingTags
{
  /** (0018,1164) */
  std::optional<std::array<double, 2>> imagerPixelSpacing;
  /** (0028,0030) */
  std::optional<std::array<double, 2>> pixelSpacing;
  /** (0018,1114), above 1 */
  std::optional<double> magnificationFactor;
  /** (0028,0A02) and (0028,0A04), both empty where absent */
  std::string calibrationType;
  std::string calibrationDescription;
};

/** \class PixelSpacingDecision
 * \brief The verdict, the spacing it stands for, and the reason in words.
 * \ingroup Cephalogram */
struct PixelSpacingDecision
{
  PixelSpacingVerdictEnum verdict{ PixelSpacingVerdictEnum::Unknown }; /**< What the spacing is worth. */
  SpacingPlaneEnum        plane{ SpacingPlaneEnum::Unknown };          /**< The plane in which the spacing is true. */
  /** mm, (u, v); nothing where the verdict is Unknown. */
  std::optional<std::array<double, 2>> spacing;
  /** Which values of the file led to it. */
  std::string reason;
};

/** Decides by the table that Documentation/Cephalogram.md gives:
 *
 * | imager pixel spacing | pixel spacing | also | verdict |
 * |---|---|---|---|
 * | - | - | | Unknown |
 * | - | given | | Unknown |
 * | given | - | | Detector |
 * | given | - | magnification factor | EstimatedMagnification: divided by it |
 * | given | equal | | Detector |
 * | given | different | calibration type or description | Calibrated: the pixel spacing |
 * | given | different | neither | Unknown |
 *
 * Two spacings are equal that differ by less than 1e-4 of their value: the same number written with fewer digits.
 *
 * \ingroup Cephalogram */
Cephalogram_EXPORT PixelSpacingDecision
DecidePixelSpacing(const RadiographSpacingTags & tags);
} // namespace itk

#endif

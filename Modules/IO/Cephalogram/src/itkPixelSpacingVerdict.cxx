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
#include "itkPixelSpacingVerdict.h"

#include <cmath>
#include <locale>
#include <sstream>

namespace itk
{
namespace
{
using SpacingType = std::array<double, 2>;

constexpr double EqualityTolerance = 1e-4;

bool
AreEqual(const SpacingType & a, const SpacingType & b)
{
  return std::abs(a[0] - b[0]) <= EqualityTolerance * std::abs(a[0]) &&
         std::abs(a[1] - b[1]) <= EqualityTolerance * std::abs(a[1]);
}

/** DICOM's row\column, spacing between rows first, to (u, v). */
SpacingType
ToImageAxes(const SpacingType & rowColumn)
{
  return { { rowColumn[1], rowColumn[0] } };
}

/** As in the file. */
std::string
Text(const char * name, const SpacingType & rowColumn)
{
  std::ostringstream os;
  os.imbue(std::locale::classic());
  os << name << ' ' << rowColumn[0] << '\\' << rowColumn[1];
  return os.str();
}
} // namespace

std::ostream &
operator<<(std::ostream & os, PixelSpacingVerdictEnum verdict)
{
  switch (verdict)
  {
    case PixelSpacingVerdictEnum::Detector:
      return os << "Detector";
    case PixelSpacingVerdictEnum::Calibrated:
      return os << "Calibrated";
    case PixelSpacingVerdictEnum::EstimatedMagnification:
      return os << "EstimatedMagnification";
    case PixelSpacingVerdictEnum::UserGiven:
      return os << "UserGiven";
    default:
      return os << "Unknown";
  }
}

std::ostream &
operator<<(std::ostream & os, SpacingPlaneEnum plane)
{
  switch (plane)
  {
    case SpacingPlaneEnum::Detector:
      return os << "detector";
    case SpacingPlaneEnum::Midsagittal:
      return os << "midsagittal";
    default:
      return os << "unknown";
  }
}

PixelSpacingDecision
DecidePixelSpacing(const RadiographSpacingTags & tags)
{
  PixelSpacingDecision decision;
  const std::string    imager =
    tags.imagerPixelSpacing ? Text("ImagerPixelSpacing (0018,1164)", *tags.imagerPixelSpacing) : std::string();
  const std::string pixel = tags.pixelSpacing ? Text("PixelSpacing (0028,0030)", *tags.pixelSpacing) : std::string();

  if (!tags.imagerPixelSpacing)
  {
    decision.reason = tags.pixelSpacing
                        ? pixel + " alone, without ImagerPixelSpacing (0018,1164): its plane cannot be told"
                        : "neither ImagerPixelSpacing (0018,1164) nor PixelSpacing (0028,0030)";
    return decision;
  }
  if (!tags.pixelSpacing)
  {
    decision.spacing = ToImageAxes(*tags.imagerPixelSpacing);
    if (!tags.magnificationFactor)
    {
      decision.verdict = PixelSpacingVerdictEnum::Detector;
      decision.plane = SpacingPlaneEnum::Detector;
      decision.reason = imager;
      return decision;
    }
    for (double & value : *decision.spacing)
    {
      value /= *tags.magnificationFactor;
    }
    decision.verdict = PixelSpacingVerdictEnum::EstimatedMagnification;
    decision.plane = SpacingPlaneEnum::Midsagittal;
    std::ostringstream os;
    os.imbue(std::locale::classic());
    os << imager << " / EstimatedRadiographicMagnificationFactor (0018,1114) " << *tags.magnificationFactor;
    decision.reason = os.str();
    return decision;
  }
  if (AreEqual(*tags.imagerPixelSpacing, *tags.pixelSpacing))
  {
    decision.verdict = PixelSpacingVerdictEnum::Detector;
    decision.plane = SpacingPlaneEnum::Detector;
    decision.spacing = ToImageAxes(*tags.imagerPixelSpacing);
    decision.reason = imager + ", PixelSpacing (0028,0030) the same";
    return decision;
  }
  if (tags.calibrationType.empty() && tags.calibrationDescription.empty())
  {
    decision.reason = pixel + " differs from " + imager +
                      ", and neither PixelSpacingCalibrationType (0028,0A02) nor -Description (0028,0A04) says why";
    return decision;
  }
  decision.verdict = PixelSpacingVerdictEnum::Calibrated;
  decision.plane = SpacingPlaneEnum::Midsagittal;
  decision.spacing = ToImageAxes(*tags.pixelSpacing);
  decision.reason = pixel + ", calibrated from " + imager + ':';
  if (!tags.calibrationType.empty())
  {
    decision.reason += " PixelSpacingCalibrationType (0028,0A02) " + tags.calibrationType;
  }
  if (!tags.calibrationDescription.empty())
  {
    decision.reason += " PixelSpacingCalibrationDescription (0028,0A04) \"" + tags.calibrationDescription + '"';
  }
  return decision;
}
} // namespace itk

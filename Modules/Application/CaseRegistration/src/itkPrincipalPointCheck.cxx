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
#include "itkPrincipalPointCheck.h"

#include <cmath>
#include <sstream>
#include <string>

namespace itk
{
namespace
{
constexpr double RadiansPerDegree = 0.017453292519943295;

/** Ear rods are 75 to 95 mm from the middle of an adult's teeth, along 25 to 40 degrees below the horizontal: a skull
 * is no longer than this, and no head hangs or is thrown back so far. */
constexpr double FarthestDistance = 130.0;
constexpr double SteepestDirection = 62.0;
constexpr double HighestDirection = -20.0;
/** The same against the occlusal plane, so that a head that was tipped is no wrong principal point. */
constexpr double SteepestToOcclusal = 50.0;
constexpr double HighestToOcclusal = -30.0;
/** The middle of a picture, or of a drawing, is given where nothing is known of ear rods: no direction is told. */
constexpr double NearDistance = 40.0;

/** Where a point is taken to be the ear rods: somewhat less than what is let pass. */
constexpr double RodDistances[2] = { 50.0, 120.0 };
constexpr double RodDirections[2] = { 5.0, 60.0 };

/** Above the ear rods, by whatever angle, are no teeth of a head that stands: with rows counted from the lower edge
 * they seem to be. */
constexpr double DirectionOfAnotherRowOrder = 0.0;

struct SightOfJaw
{
  double distance;
  /** Below the horizontal, degrees. */
  double direction;
};

SightOfJaw
SightFrom(double forward, double down)
{
  return { std::hypot(forward, down), std::atan2(down, forward) / RadiansPerDegree };
}

std::string
DescribePlace(double u, double v, double forward, double down)
{
  std::ostringstream text;
  text << '[' << u << ", " << v << "] lies " << std::lround(std::abs(forward)) << " mm "
       << (forward >= 0.0 ? "behind" : "in front of") << " and " << std::lround(std::abs(down)) << " mm "
       << (down >= 0.0 ? "above" : "below") << " the middle of the jaw";
  return text.str();
}

bool
IsOfRods(const SightOfJaw & sight)
{
  return sight.distance >= RodDistances[0] && sight.distance <= RodDistances[1] &&
         sight.direction >= RodDirections[0] && sight.direction <= RodDirections[1];
}

bool
IsTheMiddle(const CephalometricGeometry::PixelIndexType & point, unsigned int width, unsigned int height)
{
  constexpr double tolerance = 1.0;
  return std::abs(point[0] - 0.5 * width) <= tolerance && std::abs(point[1] - 0.5 * height) <= tolerance;
}
} // namespace

std::optional<RegistrationFinding>
CheckPrincipalPoint(const CephalometricGeometry *       geometry,
                    const std::array<unsigned int, 2> & imageSize,
                    const JawSeenFromPrincipalPoint &   seen)
{
  const auto       point = geometry->GetPrincipalPoint();
  const auto       spacing = geometry->GetPixelSpacing();
  const double     magnification = geometry->GetSourceToDetectorDistance() / geometry->GetSourceToMidsagittalDistance();
  const SightOfJaw given = SightFrom(seen.forward, seen.down);
  const double     toOcclusal = given.direction - seen.occlusalSlope / RadiansPerDegree;

  const double     facing = geometry->GetFacing() == CephalometricGeometry::FacingEnum::Left ? -1.0 : 1.0;
  const double     forward = seen.forward + facing * (point[0] - point[1]) * spacing[0] / magnification;
  const double     down = seen.down + (point[1] - point[0]) * spacing[1] / magnification;
  const SightOfJaw exchanged = SightFrom(forward, down);

  const bool isFar = given.distance > FarthestDistance;
  const bool isSteep = given.direction > SteepestDirection && toOcclusal > SteepestToOcclusal;
  const bool isHigh = given.direction < HighestDirection && toOcclusal < HighestToOcclusal;
  const bool isElsewhere = isFar || (given.distance > NearDistance && (isSteep || isHigh));
  const bool isOfRods = IsOfRods(exchanged);
  const bool isExchangedMiddle =
    IsTheMiddle(point, imageSize[1], imageSize[0]) && !IsTheMiddle(point, imageSize[0], imageSize[1]);
  if (!isElsewhere && !isExchangedMiddle)
  {
    return std::nullopt;
  }
  RegistrationFinding finding{
    RegistrationStatusEnum::Suspect, "principal-point", std::string(), {}, {}, std::string()
  };
  std::string text = "the principal point " + DescribePlace(point[0], point[1], seen.forward, seen.down);
  if (isExchangedMiddle)
  {
    text += ": with its two numbers exchanged it is the middle of the radiograph; give [u, v], to the right and down";
  }
  else
  {
    text += ", where no ear rods are";
    text += isOfRods
              ? ": were its two numbers exchanged? " + DescribePlace(point[1], point[0], forward, down)
              : ": is principal_point_px in pixels of this radiograph, and not in mm or of another copy? Leave it "
                "out where it is not known";
    finding.value = isFar ? given.distance : given.direction;
    finding.limit = isFar ? FarthestDistance : isSteep ? SteepestDirection : HighestDirection;
    finding.unit = isFar ? "mm" : "deg";
  }
  finding.text = text;
  return finding;
}

std::optional<RegistrationFinding>
CheckRowOrder(const CephalometricGeometry *       geometry,
              const std::array<unsigned int, 2> & imageSize,
              const JawSeenFromPrincipalPoint &   seen)
{
  const auto       point = geometry->GetPrincipalPoint();
  const double     spacing = geometry->GetPixelSpacing()[1];
  const double     magnification = geometry->GetSourceToDetectorDistance() / geometry->GetSourceToMidsagittalDistance();
  const SightOfJaw given = SightFrom(seen.forward, seen.down);
  if (imageSize[1] == 0 || !(given.distance > NearDistance) || !(given.direction < DirectionOfAnotherRowOrder))
  {
    return std::nullopt;
  }
  const double row = point[1] + seen.down * magnification / spacing;
  const double down = (imageSize[1] - 1.0 - row - point[1]) * spacing / magnification;
  if (!IsOfRods(SightFrom(seen.forward, down)))
  {
    return std::nullopt;
  }
  std::ostringstream text;
  text
    << "the jaw lies " << std::lround(-seen.down)
    << " mm above the principal point, where no head has its teeth; with rows counted from the other edge it would lie "
    << std::lround(down)
    << " mm below it: was what was drawn counted from the radiograph's lower edge? Count v from its top: its height "
       "less what was written";
  return RegistrationFinding{
    RegistrationStatusEnum::Suspect, "upward-drawing", text.str(), given.direction, DirectionOfAnotherRowOrder, "deg"
  };
}
} // namespace itk

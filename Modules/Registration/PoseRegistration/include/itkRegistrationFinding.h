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
#ifndef itkRegistrationFinding_h
#define itkRegistrationFinding_h

#include "PoseRegistrationExport.h"

#include <cstdint>
#include <optional>
#include <string>

namespace itk
{
/** What can be said of a registered jaw. Ordered from good to bad, so that the worst of several is their maximum. */
enum class RegistrationStatusEnum : std::uint8_t
{
  Ok,
  /** A person should look; the findings say why. */
  Suspect,
  /** Not to be used. */
  Failed
};

/** "ok", "suspect", "failed". */
PoseRegistration_EXPORT const char *
ToString(RegistrationStatusEnum status);

/** \struct RegistrationFinding
 * \brief Why a jaw is not simply ok: of its scan before a registration, or of the fit after it.
 *
 * Documentation/Findings.md lists every code with what to do about it.
 *
 * \ingroup PoseRegistration
 */
struct RegistrationFinding
{
  RegistrationStatusEnum severity{ RegistrationStatusEnum::Suspect }; /**< How much it weighs: suspect or failed. */
  /** Short and stable, for programs: "poor-fit". */
  std::string code;
  /** For a person. */
  std::string text;
  /** What was measured, and the limit that it is beyond, both in the unit; absent where no number decides. A unit "px"
   * is a pixel of 0.25 mm on the detector, "sd" a standard deviation; "" has no dimension. */
  std::optional<double> value;
  std::optional<double> limit;
  std::string           unit;
  /** The same in every field. */
  bool
  operator==(const RegistrationFinding & other) const
  {
    return severity == other.severity && code == other.code && text == other.text && value == other.value &&
           limit == other.limit && unit == other.unit;
  }
  bool
  operator!=(const RegistrationFinding & other) const
  {
    return !(*this == other);
  }
};
} // namespace itk

#endif

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
#ifndef itkScalePrior_h
#define itkScalePrior_h

#include "RegistrationCommonExport.h"

#include <cstdint>
#include <iosfwd>

namespace itk
{
/** \class ScalePrior
 * \brief How well the scale of a radiograph, pixel spacing times magnification, is known beforehand.
 * \ingroup RegistrationCommon
 */
class RegistrationCommon_EXPORT ScalePrior
{
public:
  /** Where the pixel spacing of the radiograph comes from: said by the user or known of the detector, read from an
   * image file that does not say which plane it is of, assumed, or estimated by the registration. */
  enum class SpacingSource : std::uint8_t
  {
    Given,
    Dicom,
    Default,
    Estimated
  };

  /** Standard deviation of the scale's logarithm: 1.6 % for the magnification of an unknown patient in a known spacing,
   * 5 % for an image file, whose spacing may be that of the detector or of the patient's plane, 25 % for an assumed or
   * estimated one. */
  static double
  GetSigma(SpacingSource source);
};

extern RegistrationCommon_EXPORT std::ostream &
                                 operator<<(std::ostream & os, ScalePrior::SpacingSource value);
} // namespace itk

#endif

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
#ifndef itkDentalPhantomAcquisition_h
#define itkDentalPhantomAcquisition_h

#include "DentalPhantomExport.h"
#include "itkDentalPhantomLevel.h"

#include <cstdint>
#include <ostream>
#include <string>

namespace itk
{
/** \struct DentalPhantomAcquisition
 * \brief How a phantom's radiograph is taken and traced: head, machine and hand, drawn for a seed. Lengths in mm,
 * angles in radians, noise in px.
 *
 * The figures are those of a DentalPhantomLevel.
 *
 * \ingroup DentalPhantom
 */
struct DentalPhantom_EXPORT DentalPhantomAcquisition
{
  /** The tables of DentalPhantomLevel that have names. */
  enum class CohortEnum : uint8_t
  {
    Ideal,
    Typical,
    Hard,
    Real,
    RealHard,
    Standard,
    Practice
  };

  /** The same for the same seed and level. */
  static DentalPhantomAcquisition
  Draw(std::uint64_t seed, const DentalPhantomLevel & level);
  static DentalPhantomAcquisition
  Draw(std::uint64_t seed, CohortEnum cohort);

  /** "real-hard" and so on. */
  static const std::string &
  GetName(CohortEnum cohort);

  /** Turns of the head about the vertical, the anterior and the lateral axis. */
  double yaw{ 0.0 };
  double roll{ 0.0 };
  double pitch{ 0.0 };
  /** The teeth's midpoint from the ear rods, head not turned. */
  double anterior{ 0.0 };
  double down{ 0.0 };

  double trueSourceToMidsagittal{ 1524.0 };  /**< mm, of the machine as it is. */
  double trueSourceToDetector{ 1674.0 };     /**< mm, of the machine as it is. */
  double givenSourceToMidsagittal{ 1524.0 }; /**< mm, as the case file says it. */
  double givenSourceToDetector{ 1674.0 };    /**< mm, as the case file says it. */
  /** In the detector plane, u and v alike; known. */
  double pixelSpacing{ 0.25 };
  /** Principal point as fractions of the image's width and height, facing right. */
  double principalU{ 0.25 };
  double principalV{ 0.45 };

  double correlatedNoise{ 0.0 };    /**< 1 sd of the drift along a border, px. */
  double whiteNoise{ 0.0 };         /**< 1 sd of each point's own error, px. */
  double correlationLength{ 15.0 }; /**< Of the drift, px. */
  /** Of the tooth rotations, degrees, 1 sd. */
  double toothRotationDegrees{ 5.0 };

  /** Position (2..6) of a tooth that the side which is not traced lacks, in that jaw; 0 for none. */
  unsigned int missingPosition{ 0 };
  unsigned int missingJaw{ 0 };
  /** Position (2..6) of a tooth of the traced side without a tracing, upper and lower; 0 for none. */
  unsigned int untracedPosition[2]{ 0, 0 };
};

DentalPhantom_EXPORT std::ostream &
                     operator<<(std::ostream & os, DentalPhantomAcquisition::CohortEnum cohort);
} // namespace itk

#endif

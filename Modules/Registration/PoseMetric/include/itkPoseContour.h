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
#ifndef itkPoseContour_h
#define itkPoseContour_h

#include "itkOpenSilhouette.h"

#include <array>
#include <cstdint>
#include <vector>

namespace itk
{
/** \struct PoseContour
 * \brief The moving contour at one pose: an open silhouette on the working plane, rim points in the dental frame.
 * \ingroup PoseMetric
 */
struct PoseContour : OpenSilhouette
{
  /** Where the contour is the middle of two (bisected tracing): the other side's points, else empty. */
  std::vector<std::array<double, 3>> rimOther;
  /** Position of the tooth in its quadrant, 1 (central incisor) to 8, 0 where it is not known; empty where nothing asks
   * for it. The sides of the patient are not told apart: on a lateral radiograph a tooth lies on its fellow. */
  std::vector<std::uint8_t> position;
};
} // namespace itk

#endif

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
#ifndef itkPoseStartSearch_h
#define itkPoseStartSearch_h

#include "PoseRegistrationExport.h"
#include "itkPoseEstimator.h"

#include <vector>

namespace itk
{
/** \class PoseStartSearch
 * \brief Exhaustive search over in-plane rotation, shift and scale of the tracing against one contour.
 *
 * Distances in position and normal, truncated at 12 px, are read from a table (2 px, 16 directions); every third
 * tracing point is used. The starts are the best grid points that differ by more than 5 degrees or 10 px.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT PoseStartSearch
{
public:
  /** Half range and step of the grid, rad and px; kappas are tried one by one. */
  double              rotationRange{ 0.5585053606381855 };
  double              rotationStep{ 0.06981317007977318 };
  double              uRange{ 64.0 };
  double              vRange{ 40.0 };
  double              shiftStep{ 8.0 };
  std::vector<double> kappas{ 0.0 };
  unsigned int        maximumStarts{ 6 };
  /** A pose to refine and its cost in the table. */
  struct Start
  {
    PoseParameters parameters{ {} };
    double         cost{ 0.0 };
  };

  /** \param pose  where the contours were made; roll, yaw and ty are kept. */
  std::vector<Start>
  Search(const PoseEstimator & estimator, const std::vector<PoseContour> & contours, const PoseParameters & pose) const;
};
} // namespace itk

#endif

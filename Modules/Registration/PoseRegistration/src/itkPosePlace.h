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
#ifndef itkPosePlace_h
#define itkPosePlace_h

#include "itkLeastSquaresSumMetricv4.h"
#include "itkPoseModel.h"

#include <vector>

namespace itk
{
/** \namespace itk::PosePlace
 * \brief The pose in the values of a metric's state, which may have blocks beside it.
 *
 * A pose has blocks of its own, "pose" and "scale", in the state of each sum that is registered.
 * \ingroup PoseRegistration
 */
namespace PosePlace
{
/** The pose at a place of the metric's state. */
PoseParameters
ToPose(const LeastSquaresMetricv4 & metric, const std::vector<double> & place);

/** The place with another pose, all else as it was. */
std::vector<double>
WithPose(const LeastSquaresMetricv4 & metric, std::vector<double> place, const PoseParameters & pose);

/** How far what is seen of the scans moves between two places: root mean square, px. */
double
Distance(const LeastSquaresSumMetricv4 & metric, const std::vector<double> & from, const std::vector<double> & to);
} // namespace PosePlace
} // namespace itk

#endif

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
#include "itkPosePlace.h"

#include <cmath>

namespace itk
{
namespace PosePlace
{
PoseParameters
ToPose(const LeastSquaresMetricv4 & metric, const std::vector<double> & place)
{
  PoseParameters    pose{ {} };
  const std::size_t offset = metric.GetState().GetOffset("pose");
  for (unsigned int k = 0; k < PoseKappa; ++k)
  {
    pose[k] = place[offset + k];
  }
  pose[PoseKappa] = place[metric.GetState().GetOffset("scale")];
  return pose;
}

std::vector<double>
WithPose(const LeastSquaresMetricv4 & metric, std::vector<double> place, const PoseParameters & pose)
{
  const std::size_t offset = metric.GetState().GetOffset("pose");
  for (unsigned int k = 0; k < PoseKappa; ++k)
  {
    place[offset + k] = pose[k];
  }
  place[metric.GetState().GetOffset("scale")] = pose[PoseKappa];
  return place;
}

double
Distance(const LeastSquaresSumMetricv4 & metric, const std::vector<double> & from, const std::vector<double> & to)
{
  double sum = 0.0;
  double count = 0.0;
  metric.AddSquaredMotion(from, to, sum, count);
  return count > 0.0 ? std::sqrt(sum / count) : 0.0;
}
} // namespace PosePlace
} // namespace itk

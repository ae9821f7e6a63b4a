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
#ifndef itkPoseMatching_h
#define itkPoseMatching_h

#include "itkPoseContour.h"
#include "itkPoseModel.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

/** What both directions of a match between tracing and moving contour share. Private to this module. */
namespace itk
{
namespace PoseMatching
{
/** What the kernel sees of a match beyond its residual: past the end of the contour the distance along it. Continuous,
 * as is FacingWeight(): a switch would let a step of a thousandth of a pixel change the criterion. */
inline double
BeyondEnd(double tangential)
{
  return std::max(0.0, std::abs(tangential) - 1.0);
}

/** 1 where contour and tracing face the same way, 0 where their normals differ by more than some 65 degrees. */
inline double
FacingWeight(double cosine)
{
  const double t = std::min(1.0, std::max(0.0, (cosine - 0.4) / 0.2));
  return t * t * (3.0 - 2.0 * t);
}

/** Bits of the tooth positions that a point with this code may be matched with; bit 0 is a tooth that is not known. */
inline std::uint32_t
GetAllowedPositions(std::uint8_t tooth, unsigned int range)
{
  const int position = tooth % 10;
  if (position == 0)
  {
    return ~0u;
  }
  std::uint32_t allowed = 1u;
  for (int k = 1; k <= 8; ++k)
  {
    if (std::abs(k - position) <= static_cast<int>(std::min(range, 8u)))
    {
      allowed |= 1u << k;
    }
  }
  return allowed;
}

/** Projection of a contour sample's surface point by the parameters: 2x7. Where the contour is the middle of two, the
 * middle's. */
inline void
ComputeSampleJacobian(const PoseModel & model, const PoseContour & contour, std::size_t j, double jacobian[14])
{
  double w[2];
  model.ProjectWithJacobian(contour.rim[j].data(), w, jacobian);
  if (!contour.rimOther.empty())
  {
    double other[14];
    model.ProjectWithJacobian(contour.rimOther[j].data(), w, other);
    for (int a = 0; a < 14; ++a)
    {
      jacobian[a] = 0.5 * (jacobian[a] + other[a]);
    }
  }
}
} // namespace PoseMatching
} // namespace itk

#endif

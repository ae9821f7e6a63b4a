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
#include "itkPoseContourModel.h"

#include <cmath>

namespace itk
{
PoseContourModel::~PoseContourModel() = default;

void
PoseContourModel::Reproject(PoseContour & contour, const PoseModel & from, const PoseModel & to)
{
  const double turn = to.GetParameters()[PosePitch] - from.GetParameters()[PosePitch];
  const double c = std::cos(turn);
  const double s = std::sin(turn);
  for (std::size_t i = 0; i < contour.Size(); ++i)
  {
    // The change of the surface points' projections: a middle contour keeps its smoothing.
    double before[2], after[2];
    from.Project(contour.rim[i].data(), before);
    to.Project(contour.rim[i].data(), after);
    double du = after[0] - before[0];
    double dv = after[1] - before[1];
    if (!contour.rimOther.empty())
    {
      from.Project(contour.rimOther[i].data(), before);
      to.Project(contour.rimOther[i].data(), after);
      du = 0.5 * (du + after[0] - before[0]);
      dv = 0.5 * (dv + after[1] - before[1]);
    }
    contour.u[i] += du;
    contour.v[i] += dv;
    const double nu = contour.nu[i];
    contour.nu[i] = c * nu - s * contour.nv[i];
    contour.nv[i] = s * nu + c * contour.nv[i];
  }
}
} // namespace itk

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

#include "itkMacro.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace itk
{
namespace
{
/** No place where a scan may lie. */
[[noreturn]] void
Refuse(const PoseModel & model, const char * what)
{
  static const char * const names[] = { "pitch", "roll", "yaw", "tx", "ty", "tz", "kappa" };
  std::ostringstream        pose;
  const auto &              parameters = model.GetParameters();
  for (std::size_t k = 0; k < parameters.size(); ++k)
  {
    pose << (k == 0 ? "" : ", ") << names[k] << ' ' << parameters[k];
  }
  itkGenericExceptionMacro("The pose (" << pose.str() << "; rad, mm) is none that a scan may have: " << what
                                        << ". An optimizer has left the radiograph: give it a smaller step, learning "
                                           "rate or bounds (Documentation/Pipeline.md), or a start that is nearer.");
}

/** Grows a box on the working plane; refuses what is not there. */
struct Extent
{
  double low[2]{ 0.0, 0.0 };
  double high[2]{ 0.0, 0.0 };
  bool   isEmpty{ true };

  void
  Add(const PoseModel & model, bool isInFront, const double w[2])
  {
    if (!isInFront)
    {
      Refuse(model, "the scan does not lie in front of the X-ray source");
    }
    for (unsigned int d = 0; d < 2; ++d)
    {
      if (!std::isfinite(w[d]))
      {
        Refuse(model, "it is not finite");
      }
      low[d] = isEmpty ? w[d] : std::min(low[d], w[d]);
      high[d] = isEmpty ? w[d] : std::max(high[d], w[d]);
    }
    isEmpty = false;
  }

  void
  Verify(const PoseModel & model) const
  {
    if (high[0] - low[0] > PoseContourModel::LargestExtent || high[1] - low[1] > PoseContourModel::LargestExtent)
    {
      Refuse(model, "its outline would be more than 5 m large on the detector");
    }
  }
};
} // namespace

PoseContourModel::~PoseContourModel() = default;

void
PoseContourModel::VerifyPlaces(const PoseModel & model, const std::vector<std::array<double, 3>> & points)
{
  Extent extent;
  for (const auto & point : points)
  {
    double     w[2] = { 0.0, 0.0 };
    const bool isInFront = model.Project(point.data(), w);
    extent.Add(model, isInFront, w);
  }
  extent.Verify(model);
}

void
PoseContourModel::Reproject(PoseContour & contour, const PoseModel & from, const PoseModel & to)
{
  const double turn = to.GetParameters()[PosePitch] - from.GetParameters()[PosePitch];
  const double c = std::cos(turn);
  const double s = std::sin(turn);
  Extent       extent;
  for (std::size_t i = 0; i < contour.Size(); ++i)
  {
    // The change of the surface points' projections: a middle contour keeps its smoothing.
    double before[2] = { 0.0, 0.0 };
    double after[2] = { 0.0, 0.0 };
    from.Project(contour.rim[i].data(), before);
    const bool isInFront = to.Project(contour.rim[i].data(), after);
    extent.Add(to, isInFront, after);
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
  extent.Verify(to);
}
} // namespace itk

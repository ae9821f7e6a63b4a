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
#include "itkLandmarkPoseStart.h"

#include "itkForEachTerm.h"
#include "itkPoseModel.h"
#include "itkPoseStateBlocks.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace itk
{
namespace
{
using CorrespondenceType = LandmarkPoseMetricv4::CorrespondenceType;

/** Those of the first view that are of the pose as it is, not of a jaw's own. */
template <typename TTerm>
std::vector<const TTerm *>
FindTermsOfPose(const LeastSquaresMetricv4 & metric)
{
  std::vector<const TTerm *> found;
  ForEachTerm<TTerm>(
    metric, metric.GetState().GetValues(), [&](const TTerm & term, const LeastSquaresMetricv4::PositionType &) {
      if (term.GetPoseBlock() == std::string("pose") && term.GetScaleBlock() == std::string("scale"))
      {
        found.push_back(&term);
      }
    });
  return found;
}

/** rad: outlines are matched with what is nearest, and a crown's centre and an outline's are not quite one point, so
 * that one start may end beside the answer. From further ones, turned to either side, the best is taken. */
constexpr double OutlineTurn = 0.05;

/** The pose that brings the points to the marks by a similarity of the plane, all of them but one, and turns further.
 */
PoseStart::StartType
Solve(const PoseGeometry &                    geometry,
      const std::vector<CorrespondenceType> & correspondences,
      std::size_t                             leftOut,
      const PoseStart::RequestType &          request,
      double                                  turn = 0.0)
{
  PoseStart::StartType start;
  start.parameters = request.pose;
  // What a pitch turns, in the working plane: angles from the images before.
  PoseParameters straight = request.pose;
  straight[PoseTx] = straight[PoseTz] = 0.0;
  if (!request.holdRotation)
  {
    straight[PosePitch] = 0.0;
  }
  const PoseModel                    model(geometry, straight);
  std::vector<std::array<double, 2>> from, to;
  std::array<double, 3>              centre{ { 0.0, 0.0, 0.0 } };
  std::array<double, 2>              fromMean{ { 0.0, 0.0 } };
  std::array<double, 2>              toMean{ { 0.0, 0.0 } };
  for (std::size_t i = 0; i < correspondences.size(); ++i)
  {
    std::array<double, 2> image;
    if (i == leftOut || !model.Project(correspondences[i].moving.GetDataPointer(), image.data()))
    {
      continue;
    }
    from.push_back(image);
    to.push_back(PoseModel::ToWorkingPlane(geometry, { { correspondences[i].fixed[0], correspondences[i].fixed[1] } }));
    for (unsigned int d = 0; d < 3; ++d)
    {
      centre[d] += correspondences[i].moving[d];
    }
    for (unsigned int d = 0; d < 2; ++d)
    {
      fromMean[d] += from.back()[d];
      toMean[d] += to.back()[d];
    }
  }
  if (from.empty())
  {
    return start;
  }
  const auto count = static_cast<double>(from.size());
  for (double & c : centre)
  {
    c /= count;
  }
  for (unsigned int d = 0; d < 2; ++d)
  {
    fromMean[d] /= count;
    toMean[d] /= count;
  }
  double cosine = 0.0, sine = 0.0, size = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    const double a = from[i][0] - fromMean[0], b = from[i][1] - fromMean[1];
    const double c = to[i][0] - toMean[0], d = to[i][1] - toMean[1];
    cosine += a * c + b * d;
    sine += a * d - b * c;
    size += a * a + b * b;
  }
  if (from.size() > 1 && size > 0.0)
  {
    if (!request.holdRotation)
    {
      // c = Ry(pitch) p, w = (c_x, -c_z): a positive pitch takes x to -z, that is to +w_v, as a positive angle does.
      start.parameters[PosePitch] = std::atan2(sine, cosine);
    }
    if (request.searchScale)
    {
      start.parameters[PoseKappa] += std::log(std::max(1e-3, std::hypot(cosine, sine) / size));
    }
  }
  start.parameters[PosePitch] += turn;
  PoseModel(geometry, start.parameters)
    .SolveTranslation(centre.data(), toMean.data(), start.parameters[PoseTx], start.parameters[PoseTz]);
  return start;
}
} // namespace

std::vector<const LandmarkPoseMetricv4 *>
LandmarkPoseStart::FindTerms(const LeastSquaresMetricv4 & metric)
{
  return FindTermsOfPose<LandmarkPoseMetricv4>(metric);
}

std::vector<const ToothOutlinePoseMetricv4 *>
LandmarkPoseStart::FindOutlineTerms(const LeastSquaresMetricv4 & metric)
{
  return FindTermsOfPose<ToothOutlinePoseMetricv4>(metric);
}

std::vector<PoseStart::StartType>
LandmarkPoseStart::Search(const LeastSquaresMetricv4 & metric, const RequestType & request) const
{
  std::vector<CorrespondenceType> correspondences;
  PoseGeometry                    geometry;
  for (const LandmarkPoseMetricv4 * term : FindTerms(metric))
  {
    geometry = term->GetTransform()->GetPoseGeometry();
    const auto own = term->GetCorrespondences();
    correspondences.insert(correspondences.end(), own.begin(), own.end());
  }
  bool hasOutlines = false;
  for (const ToothOutlinePoseMetricv4 * term : FindOutlineTerms(metric))
  {
    hasOutlines = true;
    geometry = term->GetTransform()->GetPoseGeometry();
    for (const auto & own : term->GetCorrespondences())
    {
      correspondences.push_back({ own.first, own.second });
    }
  }
  std::vector<StartType> starts;
  if (correspondences.empty())
  {
    return starts;
  }
  starts.push_back(Solve(geometry, correspondences, correspondences.size(), request));
  if (hasOutlines && !request.holdRotation)
  {
    for (const double turn : { -OutlineTurn, OutlineTurn })
    {
      starts.push_back(Solve(geometry, correspondences, correspondences.size(), request, turn));
    }
  }
  if (correspondences.size() >= 4)
  {
    for (std::size_t i = 0; i < correspondences.size(); ++i)
    {
      starts.push_back(Solve(geometry, correspondences, i, request));
    }
  }
  return starts;
}
} // namespace itk

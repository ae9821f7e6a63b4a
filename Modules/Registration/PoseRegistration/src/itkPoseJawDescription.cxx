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
#include "itkPoseJawDescription.h"

#include "itkPoseFrameOperations.h"
#include "itkSurfaceParts.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace itk
{
void
PlaceJaw(const PoseGeometry & geometry, const PoseParameters & parameters, PoseJawResult & result)
{
  const PoseModel model(geometry, parameters);
  ToMeshMotion(result.frame,
               model.GetRotation(),
               { { parameters[PoseTx], parameters[PoseTx + 1], parameters[PoseTx + 2] } },
               result.rotation,
               result.translation);
  result.projection = model.GetPixelProjection(result.frame);
}

void
DescribeJaw(const PoseJawInput &            input,
            const TriangleSurface &         surface,
            const PoseRegistrationOptions & options,
            PoseJawResult &                 result)
{
  const auto extent = SurfaceParts(surface).ComputeExtent(surface, { { 0.0, 1.0, 0.0 } });
  result.archWidth = extent.second - extent.first;
  double sum = 0.0, area = 0.0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const auto normal = surface.AreaNormal(t);
    sum += normal[2];
    area += std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
  }
  result.winding = area > 0.0 ? (input.jaw == ToothCode::JawEnum::Upper ? -sum : sum) / area : 0.0;
  result.draftedShare = input.tracing.IsNotNull() ? input.tracing->GetDraftedShare() : 0.0;
  std::size_t                        other = 0, all = 0;
  const DentalContour::PolylinesType none;
  for (const auto & polyline : input.tracing.IsNotNull() ? input.tracing->GetPolylines() : none)
  {
    const std::uint8_t tooth = polyline.code.GetFDI();
    all += polyline.points.size();
    const bool wrong = tooth != 0 && polyline.code.IsLeft() == (options.tracedSide == TracedSideEnum::Right);
    other += wrong ? polyline.points.size() : 0;
  }
  if (all > 0 && (options.tracedSide == TracedSideEnum::Right || options.tracedSide == TracedSideEnum::Left))
  {
    result.otherSideCodes = static_cast<double>(other) / static_cast<double>(all);
  }
}

void
DescribeFit(const SilhouettePoseMetricv4 &               metric,
            const SilhouettePoseMetricv4::PositionType & x,
            const std::array<double, 49> &               covariance,
            const PoseGeometry &                         geometry,
            PoseJawResult &                              jaw)
{
  const auto statistics = metric.ComputeFitStatistics(x);
  const auto contours = metric.GetContours(x);
  for (std::size_t s = 0; s < contours.size(); ++s)
  {
    PoseFitStatistics fit = statistics[s];
    const auto        sigma = metric.PredictSigma(s, x, covariance);
    fit.predictedSigma = sigma[0];
    fit.extrapolatedSigma = sigma[1];
    fit.overlap = metric.GetKernel().ComputeOverlap(s, contours[s]);
    // Two strands of a jaw: the worse one speaks.
    if (s == 0 || fit.cost > jaw.fit.cost)
    {
      jaw.fit = fit;
    }
    for (std::size_t i = 0; i < contours[s].Size(); ++i)
    {
      jaw.contour.push_back(PoseModel::ToPixel(geometry, { { contours[s].u[i], contours[s].v[i] } }));
      jaw.contourNormals.push_back(PoseModel::ToPixelNormal(geometry, { { contours[s].nu[i], contours[s].nv[i] } }));
      jaw.contourPoints.push_back(ToMeshFrame(jaw.frame, contours[s].rim[i]));
    }
  }
}
void
DescribeOutlines(const ToothOutlinePoseMetricv4 &                          metric,
                 const std::vector<ToothOutlineComparison::TemplateType> & templates,
                 const ToothOutlinePoseMetricv4::PositionType &            x,
                 PoseJawResult &                                           jaw)
{
  for (const auto & residual : metric.ComputeOutlineResiduals(x))
  {
    jaw.outlines.push_back({ residual.name,
                             residual.shift,
                             residual.shiftDistance,
                             residual.distance,
                             residual.weight,
                             residual.matchedShare,
                             residual.isTemplate,
                             "",
                             0.0,
                             residual.crown });
    const auto found =
      std::find_if(templates.begin(), templates.end(), [&](const auto & each) { return each.name == residual.name; });
    if (found != templates.end())
    {
      jaw.outlines.back().templateOf = found->of;
      jaw.outlines.back().templateDistance = found->distance;
    }
  }
}

void
DescribeLandmarks(const LandmarkPoseMetricv4 &               metric,
                  const LandmarkPoseMetricv4::PositionType & x,
                  PoseJawResult &                            jaw)
{
  for (const auto & residual : metric.ComputeLandmarkResiduals(x))
  {
    jaw.landmarks.push_back({ residual.name,
                              { { residual.difference[0], residual.difference[1] } },
                              { { residual.sigma[0], residual.sigma[1] } },
                              residual.distance,
                              residual.weight });
  }
}

void
DescribeMiddle(const TriangleSurface &        surface,
               const PoseGeometry &           geometry,
               const PoseModel &              model,
               const std::array<double, 49> & covariance,
               PoseJawResult &                jaw)
{
  constexpr double behindIncisors = 35.0;
  constexpr double halfWidth = 22.0;
  // Half a molar to each side of its place, along the arch and across it.
  constexpr double    halfMolar = 5.0;
  double              front = -1e300;
  std::vector<double> heights;
  for (const auto & p : surface.points)
  {
    front = std::max<double>(front, p[0]);
    heights.push_back(jaw.jaw == ToothCode::JawEnum::Upper ? -p[2] : p[2]);
  }
  if (heights.empty())
  {
    return;
  }
  // Where cusps and edges are: on the occlusal side, but for a speck or a single high cusp.
  const auto occlusal = heights.begin() + static_cast<std::ptrdiff_t>(0.98 * static_cast<double>(heights.size() - 1));
  std::nth_element(heights.begin(), occlusal, heights.end());
  const double height = jaw.jaw == ToothCode::JawEnum::Upper ? -*occlusal : *occlusal;
  double       sum = 0.0;
  for (const bool molar : { false, true })
  {
    std::array<double, 14> jacobian{};
    for (const double side : { -1.0, 1.0 })
    {
      const double p[3] = { molar ? front - behindIncisors : front, molar ? side * halfWidth : 0.0, height };
      double       w[2], own[14];
      model.ProjectWithJacobian(p, w, own);
      for (unsigned int a = 0; a < 14; ++a)
      {
        jacobian[a] += 0.5 * own[a];
      }
    }
    const auto   own = PoseModel::PropagateCovariance(jacobian.data(), covariance);
    const double variance = std::max(0.0, 0.5 * (own[0] + own[3])) + jaw.GetBiteVariance(geometry);
    jaw.molarSigma = std::sqrt(variance);
    sum += variance;
    jaw.largestMiddleSigma = std::max(jaw.largestMiddleSigma, std::sqrt(variance));
  }
  jaw.middleSigma = std::sqrt(0.5 * sum);

  // The cusps of either side: where one is missing the other one stands for both.
  const double up = jaw.jaw == ToothCode::JawEnum::Upper ? -1.0 : 1.0;
  double       places = 0.0;
  double       place[2] = { 0.0, 0.0 };
  for (const double side : { -1.0, 1.0 })
  {
    std::array<double, 3> cusp{ { 0.0, 0.0, -1e300 } };
    for (const auto & p : surface.points)
    {
      if (std::abs(p[0] - (front - behindIncisors)) < halfMolar && std::abs(side * p[1] - halfWidth) < halfMolar &&
          up * p[2] > cusp[2])
      {
        cusp = { { p[0], p[1], up * p[2] } };
      }
    }
    // A scan's gingiva or palate is no tooth: cusps reach to the level of the others, but for a curve of Spee.
    if (cusp[2] > up * height - 4.0)
    {
      const double p[3] = { cusp[0], cusp[1], up * cusp[2] };
      double       w[2];
      model.Project(p, w);
      place[0] += w[0];
      place[1] += w[1];
      places += 1.0;
    }
  }
  if (places > 0.0)
  {
    jaw.molarPlace = { { place[0] / places, place[1] / places } };
  }
}
} // namespace itk

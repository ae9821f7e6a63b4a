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
#include "itkPoseRegistrationKernel.h"

#include "itkKeepTriangles.h"
#include "itkMidlineSide.h"
#include "itkParallelFor.h"
#include "itkPoseEstimator.h"
#include "itkPoseGroupRegistration.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace itk
{
namespace
{
using Vector3 = std::array<double, 3>;

/** All that belongs to one jaw. */
struct Jaw
{
  const PoseJawInput *                           input{ nullptr };
  TriangleSurface                                surface;
  PoseArch                                       arch;
  std::vector<std::unique_ptr<PoseContourModel>> models;
};

TriangleSurface
ToDentalFrame(const TriangleSurface & surface, const PoseFrame & frame)
{
  TriangleSurface moved;
  moved.triangles = surface.triangles;
  moved.points.resize(surface.points.size());
  for (std::size_t i = 0; i < surface.points.size(); ++i)
  {
    const Vector3 d{ { surface.points[i][0] - frame.origin[0],
                       surface.points[i][1] - frame.origin[1],
                       surface.points[i][2] - frame.origin[2] } };
    for (int k = 0; k < 3; ++k)
    {
      moved.points[i][k] =
        frame.rotation[3 * k] * d[0] + frame.rotation[3 * k + 1] * d[1] + frame.rotation[3 * k + 2] * d[2];
    }
  }
  return moved;
}

bool
IsLeft(std::uint8_t tooth)
{
  return tooth / 10 == 2 || tooth / 10 == 3;
}

std::vector<PosePolyline>
SelectPolylines(const PoseJawInput & jaw, const PoseRegistrationOptions & options)
{
  std::vector<PosePolyline> selected;
  for (const PosePolyline & polyline : jaw.tracing)
  {
    const auto & excluded = options.excludedTeeth;
    if (polyline.tooth == 0 || std::find(excluded.begin(), excluded.end(), polyline.tooth) == excluded.end())
    {
      selected.push_back(polyline);
    }
  }
  return selected;
}

/** Different ones. */
std::size_t
CountPoints(const std::vector<PosePolyline> & polylines)
{
  std::set<std::array<double, 2>> points;
  for (const PosePolyline & polyline : polylines)
  {
    points.insert(polyline.points.begin(), polyline.points.end());
  }
  return points.size();
}

/** Fills in what is not known: the principal point by the tracing's centroid, the spacing from the arch's length. */
PoseGeometry
CompleteGeometry(const std::vector<PoseJawInput> & jaws, PoseGeometry geometry, const PoseRegistrationOptions & options)
{
  double low[2] = { 1e300, 1e300 };
  double high[2] = { -1e300, -1e300 };
  double sum[2] = { 0, 0 };
  double count = 0.0;
  for (const PoseJawInput & jaw : jaws)
  {
    for (const PosePolyline & polyline : SelectPolylines(jaw, options))
    {
      for (const auto & p : polyline.points)
      {
        for (int k = 0; k < 2; ++k)
        {
          low[k] = std::min(low[k], p[k]);
          high[k] = std::max(high[k], p[k]);
          sum[k] += p[k];
        }
        count += 1.0;
      }
    }
  }
  if (count == 0.0)
  {
    return geometry;
  }
  if (!geometry.principalPointKnown)
  {
    geometry.principalPoint = { { sum[0] / count, sum[1] / count } };
  }
  if (!geometry.pixelSpacingKnown)
  {
    // The length of the arches along x against that of the tracing. Teeth at the back may be untraced: the search over
    // scale settles the rest.
    double depth = 0.0;
    for (const PoseJawInput & jaw : jaws)
    {
      if (jaw.surface == nullptr)
      {
        continue;
      }
      double front = -1e300, back = 1e300;
      for (const auto & p : jaw.surface->points)
      {
        const double x = jaw.frame.rotation[0] * (p[0] - jaw.frame.origin[0]) +
                         jaw.frame.rotation[1] * (p[1] - jaw.frame.origin[1]) +
                         jaw.frame.rotation[2] * (p[2] - jaw.frame.origin[2]);
        front = std::max(front, x);
        back = std::min(back, x);
      }
      depth = std::max(depth, front - back);
    }
    const double pixels = std::max(1.0, std::hypot(high[0] - low[0], 0.5 * (high[1] - low[1])));
    const double spacing = depth * geometry.sourceToDetector / geometry.sourceToMidsagittal / pixels;
    geometry.pixelSpacing = { { spacing, spacing } };
  }
  return geometry;
}

void
CheckGeometry(const PoseGeometry & geometry)
{
  if (!(geometry.sourceToMidsagittal > 0.0) || !(geometry.sourceToDetector > geometry.sourceToMidsagittal))
  {
    throw std::invalid_argument("source-to-midsagittal distance " + std::to_string(geometry.sourceToMidsagittal) +
                                " mm must be positive and smaller than the source-to-detector distance " +
                                std::to_string(geometry.sourceToDetector) + " mm");
  }
  if (!(geometry.pixelSpacing[0] > 0.0) || !(geometry.pixelSpacing[1] > 0.0))
  {
    throw std::invalid_argument("the pixel spacing must be positive; mark it as unknown where it is not known");
  }
}

/** Pose and projection in the mesh's frame, and the equivalent similarity. */
void
FillJaw(const Jaw & jaw, const PoseGeometry & geometry, const PoseParameters & parameters, PoseJawResult & result)
{
  const PoseModel   model(geometry, parameters);
  const PoseFrame & frame = jaw.input->frame;
  const auto &      r = model.GetRotation();
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      result.rotation[3 * i + j] =
        r[3 * i] * frame.rotation[j] + r[3 * i + 1] * frame.rotation[3 + j] + r[3 * i + 2] * frame.rotation[6 + j];
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    result.translation[i] = parameters[PoseTx + i] - result.rotation[3 * i] * frame.origin[0] -
                            result.rotation[3 * i + 1] * frame.origin[1] - result.rotation[3 * i + 2] * frame.origin[2];
  }
  result.projection = model.GetPixelProjection(frame);

  // Least squares similarity from q = (f m x / sp_u, -m z / sp_v) of the dental frame.
  double      sq[2] = { 0, 0 }, sp[2] = { 0, 0 }, qq = 0.0, dot = 0.0, cross = 0.0, pp = 0.0;
  std::size_t n = 0;
  const auto  visit = [&](const Vector3 & p, double q[2], double image[2]) {
    const double m = geometry.sourceToDetector / (geometry.sourceToMidsagittal + geometry.sourceSign * p[1]);
    q[0] = geometry.facingSign * m * p[0] / geometry.pixelSpacing[0];
    q[1] = -m * p[2] / geometry.pixelSpacing[1];
    double w[2];
    model.Project(p.data(), w);
    const auto pixel = PoseModel::ToPixel(geometry, { { w[0], w[1] } });
    image[0] = pixel[0];
    image[1] = pixel[1];
  };
  const std::size_t step = std::max<std::size_t>(1, jaw.surface.points.size() / 2000);
  for (std::size_t i = 0; i < jaw.surface.points.size(); i += step, ++n)
  {
    double q[2], p[2];
    visit(jaw.surface.points[i], q, p);
    for (int k = 0; k < 2; ++k)
    {
      sq[k] += q[k];
      sp[k] += p[k];
    }
  }
  if (n == 0)
  {
    return;
  }
  const double count = static_cast<double>(n);
  for (std::size_t i = 0; i < jaw.surface.points.size(); i += step)
  {
    double q[2], p[2];
    visit(jaw.surface.points[i], q, p);
    for (int k = 0; k < 2; ++k)
    {
      q[k] -= sq[k] / count;
      p[k] -= sp[k] / count;
    }
    qq += q[0] * q[0] + q[1] * q[1];
    pp += p[0] * p[0] + p[1] * p[1];
    dot += q[0] * p[0] + q[1] * p[1];
    cross += q[0] * p[1] - q[1] * p[0];
  }
  result.similarityAngle = std::atan2(cross, dot);
  result.similarityScale = qq > 0.0 ? std::hypot(dot, cross) / qq : 1.0;
  const double c = result.similarityScale * std::cos(result.similarityAngle);
  const double s = result.similarityScale * std::sin(result.similarityAngle);
  result.similarityTranslation = { { (sp[0] - c * sq[0] + s * sq[1]) / count,
                                     (sp[1] - s * sq[0] - c * sq[1]) / count } };
  result.similarityRms = std::sqrt(std::max(0.0, pp - result.similarityScale * std::hypot(dot, cross)) / count);
}
/** The best pose on the other side's contour, against the solution. */
double
OtherSideDeviance(const PoseEstimator &         estimator,
                  const std::vector<Jaw> &      jaws,
                  const PoseRegistrationOptions & options,
                  const PoseGroupResult &       group)
{
  std::vector<PoseStrand> strands = estimator.GetStrands();
  for (PoseStrand & strand : strands)
  {
    strand.models = { jaws[strand.jaw].models.back().get() };
  }
  PoseRegistrationOptions quick = options;
  quick.yawStarts = { 0.0 };
  quick.startsPerYaw = 3;
  quick.maximumEvaluations = 8;
  quick.useInitialPose = false;
  quick.progress = nullptr;
  PoseGroupRegistration other(estimator.GetGeometry(), quick, std::move(strands));
  PoseGroupResult       otherGroup;
  other.Run(otherGroup);
  if (otherGroup.candidates.empty())
  {
    return 0.0;
  }
  std::array<double, 2> deviance{};
  ParallelFor(2, options.numberOfThreads, [&](std::size_t k) {
    const PoseGroupResult & run = k == 0 ? group : otherGroup;
    PoseState               state;
    state.parameters = run.parameters;
    state.noise = { run.smoothSigma, run.whiteSigma };
    deviance[k] = (k == 0 ? estimator : other.GetEstimator()).ComputeDeviance(state);
  });
  return deviance[1] - deviance[0];
}

/** Names the likely mistake behind a poor fit. */
void
TryExchangedAndFlipped(const std::vector<PoseJawInput> & inputs,
                       const std::vector<std::size_t> &  members,
                       const PoseGeometry &              nominal,
                       const PoseRegistrationOptions &     options,
                       PoseGroupResult &                 group)
{
  PoseRegistrationOptions quick = options;
  quick.checkHypotheses = false;
  quick.yawStarts = { 0.0 };
  quick.maximumEvaluations = 6;
  quick.useInitialPose = false;
  quick.useJointPose = true;
  quick.progress = nullptr;
  std::vector<PoseJawInput> jaws;
  for (std::size_t j : members)
  {
    jaws.push_back(inputs[j]);
    jaws.back().initialPose.reset();
  }
  const auto score = [&](const std::vector<PoseJawInput> & trial, const PoseGeometry & geometry) {
    const PoseRegistrationResult result = PoseRegistrationKernel::Run(trial, geometry, quick);
    return result.groups.empty() || result.groups[0].candidates.empty() ? 1.0 : result.groups[0].score;
  };
  PoseGeometry flipped = nominal;
  flipped.facingSign = -nominal.facingSign;
  group.otherFacingScore = score(jaws, flipped);
  if (jaws.size() == 2)
  {
    // Exchanged files: what was called upper is the lower jaw, the frame stands on its head about x.
    std::swap(jaws[0].tracing, jaws[1].tracing);
    for (PoseJawInput & jaw : jaws)
    {
      jaw.upper = !jaw.upper;
      for (int k = 3; k < 9; ++k)
      {
        jaw.frame.rotation[k] = -jaw.frame.rotation[k];
      }
    }
    group.exchangedScore = score(jaws, nominal);
  }
}

/** What the verdict wants to know of a jaw besides the fit. */
void
DescribeJaw(const Jaw & jaw, const PoseRegistrationOptions & options, PoseJawResult & result)
{
  double low = 0.0, high = 0.0;
  for (const auto & p : jaw.surface.points)
  {
    low = std::min(low, p[1]);
    high = std::max(high, p[1]);
  }
  result.archWidth = high - low;
  double sum = 0.0, area = 0.0;
  for (std::size_t t = 0; t < jaw.surface.triangles.size(); ++t)
  {
    const auto normal = jaw.surface.AreaNormal(t);
    sum += normal[2];
    area += std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
  }
  result.winding = area > 0.0 ? (jaw.input->upper ? -sum : sum) / area : 0.0;
  std::size_t other = 0, all = 0;
  for (const PosePolyline & polyline : jaw.input->tracing)
  {
    all += polyline.points.size();
    const bool wrong =
      polyline.tooth != 0 && IsLeft(polyline.tooth) == (options.tracedSide == PoseTracedSideEnum::Right);
    other += wrong ? polyline.points.size() : 0;
  }
  if (all > 0 && (options.tracedSide == PoseTracedSideEnum::Right || options.tracedSide == PoseTracedSideEnum::Left))
  {
    result.otherSideCodes = static_cast<double>(other) / static_cast<double>(all);
  }
}
} // namespace

TriangleSurface
PoseRegistrationKernel::SelectSide(const TriangleSurface & surface, double side, double margin)
{
  return KeepTriangles(surface, SelectMidlineSide(surface, { { 0.0, 1.0, 0.0 } }, { { 0.0, 0.0, 0.0 } }, side, margin));
}

PoseRegistrationResult
PoseRegistrationKernel::Run(const std::vector<PoseJawInput> & inputs,
                          const PoseGeometry &              nominal,
                          const PoseRegistrationOptions &     options)
{
  PoseRegistrationResult result;
  result.geometry = CompleteGeometry(inputs, nominal, options);
  CheckGeometry(result.geometry);
  result.jaws.resize(inputs.size());

  // What is there, per jaw.
  std::vector<Jaw>                     jaws(inputs.size());
  std::vector<std::vector<PoseStrand>> strands(inputs.size());
  const bool                           mean = options.tracedSide == PoseTracedSideEnum::Mean;
  const bool                           oneSide =
    options.tracedSide == PoseTracedSideEnum::Right || options.tracedSide == PoseTracedSideEnum::Left;
  ParallelFor(inputs.size(), options.numberOfThreads, [&](std::size_t j) {
    const PoseJawInput & input = inputs[j];
    Jaw &                jaw = jaws[j];
    jaw.input = &input;
    result.jaws[j].upper = input.upper;
    if (input.surface == nullptr || input.surface->triangles.empty())
    {
      result.jaws[j].failure = "there is no surface";
      return;
    }
    const std::vector<PosePolyline> polylines = SelectPolylines(input, options);
    const std::size_t               points = CountPoints(polylines);
    if (points < 5)
    {
      result.jaws[j].failure = "the tracing has " + std::to_string(points) + " different points, at least 5 are needed";
      return;
    }
    jaw.surface = ToDentalFrame(*input.surface, input.frame);
    jaw.arch = PoseArch(jaw.surface, input.upper);
    const auto side = [&](double sign) {
      return options.useSideSelection ? PoseRegistrationKernel::SelectSide(jaw.surface, sign, options.midlineMargin)
                                      : jaw.surface;
    };
    const auto add = [&](const std::vector<PosePolyline> & part, std::vector<const PoseContourModel *> models) {
      PoseStrand strand;
      strand.tracing = PoseTracing(result.geometry, part, input.upper, options.maximumTracingPoints);
      strand.models = std::move(models);
      strand.arch = &jaw.arch;
      strand.upper = input.upper;
      strand.jaw = j;
      if (strand.tracing.Size() > 0)
      {
        strands[j].push_back(std::move(strand));
      }
    };
    const bool filter = options.useFacingFilter;
    if (mean)
    {
      jaw.models.push_back(std::make_unique<PoseContourModel>(side(1.0), side(-1.0), input.upper, filter));
      add(polylines, { jaw.models[0].get() });
    }
    else if (options.tracedSide == PoseTracedSideEnum::Both)
    {
      std::vector<PosePolyline> right, left, unknown;
      for (const PosePolyline & polyline : polylines)
      {
        (polyline.tooth == 0 ? unknown : IsLeft(polyline.tooth) ? left : right).push_back(polyline);
      }
      jaw.models.push_back(std::make_unique<PoseContourModel>(side(1.0), input.upper, filter));
      jaw.models.push_back(std::make_unique<PoseContourModel>(side(-1.0), input.upper, filter));
      add(right, { jaw.models[0].get() });
      add(left, { jaw.models[1].get() });
      add(unknown, { jaw.models[0].get(), jaw.models[1].get() });
    }
    else
    {
      const double sign = options.tracedSide == PoseTracedSideEnum::Right ? 1.0 : -1.0;
      jaw.models.push_back(std::make_unique<PoseContourModel>(side(sign), input.upper, filter));
      add(polylines, { jaw.models[0].get() });
      if (options.checkHypotheses && options.useSideSelection)
      {
        jaw.models.push_back(std::make_unique<PoseContourModel>(side(-sign), input.upper, filter));
      }
    }
    if (strands[j].empty())
    {
      result.jaws[j].failure = "no part of the tracing can lie on the occlusal or anterior outline";
    }
  });

  // Groups of jaws with one pose.
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t j = 0; j < inputs.size(); ++j)
  {
    if (!result.jaws[j].failure.empty())
    {
      continue;
    }
    if (options.useJointPose && !groups.empty())
    {
      groups[0].push_back(j);
    }
    else
    {
      groups.push_back({ j });
    }
  }
  result.groupOfJaw.assign(inputs.size(), groups.size());
  for (const auto & members : groups)
  {
    std::vector<PoseStrand> groupStrands;
    for (std::size_t j : members)
    {
      groupStrands.insert(groupStrands.end(), strands[j].begin(), strands[j].end());
    }
    PoseGroupResult group;
    group.jaws = members;
    group.bisected = mean;
    PoseRegistrationOptions groupOptions = options;
    const auto            started =
      std::find_if(members.begin(), members.end(), [&](std::size_t j) { return inputs[j].initialPose.has_value(); });
    if (started != members.end())
    {
      groupOptions.initialPose = *inputs[*started].initialPose;
      groupOptions.useInitialPose = true;
    }
    PoseGroupRegistration run(result.geometry, groupOptions, std::move(groupStrands));
    if (!run.Run(group))
    {
      result.aborted = true;
      return result;
    }
    const std::size_t index = result.groups.size();
    if (group.candidates.empty())
    {
      for (std::size_t j : members)
      {
        result.jaws[j].failure = "no start was found: the contour of the surface is empty";
      }
      result.groups.push_back(std::move(group));
      continue;
    }
    // Beside a given start or held parameters any free search looks better.
    const bool searched =
      !groupOptions.useInitialPose && !options.fixRotation && !options.fixScale && !options.fixTranslation;
    if (searched && options.checkHypotheses && options.useSideSelection && oneSide)
    {
      group.otherSideDeviance = OtherSideDeviance(run.GetEstimator(), jaws, options, group);
    }
    if (searched && options.checkHypotheses && group.score > options.poorScore)
    {
      TryExchangedAndFlipped(inputs, members, nominal, options, group);
    }
    const PoseEstimator & estimator = run.GetEstimator();
    const auto            contours = estimator.ComputeContours(group.parameters);
    for (std::size_t j : members)
    {
      PoseJawResult & jaw = result.jaws[j];
      result.groupOfJaw[j] = index;
      jaw.registered = true;
      FillJaw(jaws[j], result.geometry, group.parameters, jaw);
      DescribeJaw(jaws[j], options, jaw);
      const PoseFrame & frame = inputs[j].frame;
      bool              first = true;
      for (std::size_t s = 0; s < contours.size(); ++s)
      {
        if (estimator.GetStrands()[s].jaw != j)
        {
          continue;
        }
        PoseFitStatistics fit = estimator.ComputeStatistics(s, contours[s]);
        const auto        sigma = estimator.PredictedSigma(s, group.parameters, contours, group.covariance);
        fit.predictedSigma = sigma[0];
        fit.extrapolatedSigma = sigma[1];
        fit.overlap = estimator.ComputeOverlap(s, contours[s]);
        // Two strands of a jaw: the worse one speaks.
        if (first || fit.cost > jaw.fit.cost)
        {
          jaw.fit = fit;
        }
        first = false;
        for (std::size_t i = 0; i < contours[s].Size(); ++i)
        {
          jaw.contour.push_back(PoseModel::ToPixel(result.geometry, { { contours[s].u[i], contours[s].v[i] } }));
          const auto & p = contours[s].rim[i];
          Vector3      q = frame.origin;
          for (int a = 0; a < 3; ++a)
          {
            for (int b = 0; b < 3; ++b)
            {
              q[a] += frame.rotation[3 * b + a] * p[b];
            }
          }
          jaw.contourPoints.push_back(q);
        }
      }
    }
    result.groups.push_back(std::move(group));
  }
  return result;
}

std::array<double, 4>
PoseRegistrationKernel::LandmarkCovariance(const PoseRegistrationResult &  result,
                                         const PoseJawInput &          jaw,
                                         std::size_t                   jawIndex,
                                         const std::array<double, 3> & point)
{
  std::array<double, 4> covariance{};
  const std::size_t     groupIndex = result.groupOfJaw.at(jawIndex);
  if (groupIndex >= result.groups.size())
  {
    return covariance;
  }
  const PoseGroupResult & group = result.groups[groupIndex];
  const PoseModel         model(result.geometry, group.parameters);
  double                  p[3];
  for (int k = 0; k < 3; ++k)
  {
    p[k] = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      p[k] += jaw.frame.rotation[3 * k + c] * (point[c] - jaw.frame.origin[c]);
    }
  }
  double w[2], jacobian[14];
  model.ProjectWithJacobian(p, w, jacobian);
  const double scale[2] = { PoseWorkingPixel * result.geometry.facingSign / result.geometry.pixelSpacing[0],
                            PoseWorkingPixel / result.geometry.pixelSpacing[1] };
  for (int a = 0; a < 2; ++a)
  {
    for (int b = 0; b < 2; ++b)
    {
      double sum = 0.0;
      for (int i = 0; i < 7; ++i)
      {
        for (int k = 0; k < 7; ++k)
        {
          sum += jacobian[7 * a + i] * group.covariance[7 * i + k] * jacobian[7 * b + k];
        }
      }
      covariance[2 * a + b] = scale[a] * scale[b] * sum;
    }
  }
  return covariance;
}
} // namespace itk

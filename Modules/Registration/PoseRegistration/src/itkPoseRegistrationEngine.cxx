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
#include "itkPoseRegistrationEngine.h"

#include "itkFindSilhouettes.h"
#include "itkGemanMcClureKernel.h"
#include "itkLandmarkPoseStart.h"
#include "itkPoseFrameOperations.h"
#include "itkSquaresKernel.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

namespace itk
{
namespace
{
std::shared_ptr<const TriangleSurface>
ToDentalFrame(const TriangleSurface & surface, const PoseFrame & frame)
{
  auto moved = std::make_shared<TriangleSurface>();
  moved->triangles = surface.triangles;
  moved->points.resize(surface.points.size());
  for (std::size_t i = 0; i < surface.points.size(); ++i)
  {
    const auto q = ToDentalFrame(frame, { { surface.points[i][0], surface.points[i][1], surface.points[i][2] } });
    for (int k = 0; k < 3; ++k)
    {
      moved->points[i][k] = q[k];
    }
  }
  return moved;
}

bool
IsExcluded(const PoseRegistrationOptions & options, std::uint8_t tooth)
{
  const auto & excluded = options.excludedTeeth;
  return tooth != 0 && std::find(excluded.begin(), excluded.end(), tooth) != excluded.end();
}

/** What was drawn on the radiograph: its extent and centre. */
class DrawingExtent
{
public:
  void
  Add(const double * pixel)
  {
    for (unsigned int k = 0; k < 2; ++k)
    {
      m_Low[k] = std::min(m_Low[k], pixel[k]);
      m_High[k] = std::max(m_High[k], pixel[k]);
      m_Sum[k] += pixel[k];
    }
    m_Count += 1.0;
  }
  bool
  IsEmpty() const
  {
    return m_Count == 0.0;
  }
  std::array<double, 2>
  GetCentre() const
  {
    return { { m_Sum[0] / m_Count, m_Sum[1] / m_Count } };
  }
  /** Along the arch: the vertical part of its slant counts half. */
  double
  GetLength() const
  {
    return std::max(1.0, std::hypot(m_High[0] - m_Low[0], 0.5 * (m_High[1] - m_Low[1])));
  }

private:
  double m_Low[2] = { 1e300, 1e300 };
  double m_High[2] = { -1e300, -1e300 };
  double m_Sum[2] = { 0, 0 };
  double m_Count = 0.0;
};

DrawingExtent
MeasureTracings(const PoseProblem & problem)
{
  DrawingExtent extent;
  for (const PoseJawInput & jaw : problem.jaws)
  {
    if (jaw.tracing.IsNull())
    {
      continue;
    }
    for (const auto & polyline : jaw.tracing->GetPolylines())
    {
      if (IsExcluded(problem.options, polyline.code.GetFDI()))
      {
        continue;
      }
      for (const auto & p : polyline.points)
      {
        extent.Add(p.GetDataPointer());
      }
    }
  }
  return extent;
}

/** The marks that have a counterpart; depth: how far these lie apart along x, mm. */
DrawingExtent
MeasureLandmarks(const PoseProblem & problem, double & depth)
{
  DrawingExtent extent;
  double        front = -1e300, back = 1e300;
  for (const PoseJawInput & jaw : problem.jaws)
  {
    if (jaw.landmarks.IsNull() || jaw.counterparts.IsNull())
    {
      continue;
    }
    for (const auto & landmark : jaw.landmarks->GetLandmarks())
    {
      const auto * counterpart = jaw.counterparts->Find(CephalometricLandmarkSet::MakeName(landmark.meaning));
      if (counterpart == nullptr)
      {
        continue;
      }
      extent.Add(landmark.point.GetDataPointer());
      double x = 0.0;
      for (const auto & p : counterpart->points)
      {
        x += ToDentalFrame(jaw.frame, { { p[0], p[1], p[2] } })[0] / static_cast<double>(counterpart->points.size());
      }
      front = std::max(front, x);
      back = std::min(back, x);
    }
  }
  depth = std::max(0.0, front - back);
  return extent;
}

/** The outlines of whole teeth that have a crown; depth: how far the crowns lie apart along x, mm. */
DrawingExtent
MeasureOutlines(const PoseProblem & problem, double & depth)
{
  DrawingExtent extent;
  double        front = -1e300, back = 1e300;
  for (const PoseJawInput & jaw : problem.jaws)
  {
    if (jaw.tracing.IsNull() || jaw.crowns.IsNull())
    {
      continue;
    }
    for (const auto & polyline : jaw.tracing->GetPolylines())
    {
      const auto * crown = polyline.code.IsKnown() ? jaw.crowns->Find(polyline.code) : nullptr;
      if (crown == nullptr || IsExcluded(problem.options, polyline.code.GetFDI()))
      {
        continue;
      }
      double middle[2] = { 0.0, 0.0 };
      for (const auto & p : polyline.points)
      {
        middle[0] += p[0] / static_cast<double>(polyline.points.size());
        middle[1] += p[1] / static_cast<double>(polyline.points.size());
      }
      extent.Add(middle);
      const auto   centroid = crown->surface->AreaCentroid();
      const double x = ToDentalFrame(jaw.frame, { { centroid[0], centroid[1], centroid[2] } })[0];
      front = std::max(front, x);
      back = std::min(back, x);
    }
  }
  depth = std::max(0.0, front - back);
  return extent;
}

/** Fills in what is not known: the principal point by the drawing's centroid, the spacing from the arch's length. */
PoseGeometry
CompleteGeometry(const PoseProblem & problem)
{
  PoseGeometry  geometry = problem.nominal;
  double        depth = 0.0;
  DrawingExtent extent;
  if (problem.options.tracedSide != TracedSideEnum::Standard)
  {
    extent = MeasureTracings(problem);
  }
  const bool byTeeth = extent.IsEmpty();
  if (byTeeth)
  {
    extent = MeasureLandmarks(problem, depth);
  }
  if (extent.IsEmpty())
  {
    extent = MeasureOutlines(problem, depth);
  }
  if (extent.IsEmpty())
  {
    return geometry;
  }
  if (!geometry.principalPointKnown)
  {
    geometry.principalPoint = extent.GetCentre();
  }
  if (!geometry.pixelSpacingKnown)
  {
    // The length of the arches along x against that of the tracing. Teeth at the back may be untraced: the search over
    // scale settles the rest.
    for (const PoseJawInput & jaw : problem.jaws)
    {
      if (jaw.surface == nullptr || byTeeth)
      {
        continue;
      }
      double front = -1e300, back = 1e300;
      for (const auto & p : jaw.surface->points)
      {
        const double x = ToDentalFrame(jaw.frame, { { p[0], p[1], p[2] } })[0];
        front = std::max(front, x);
        back = std::min(back, x);
      }
      depth = std::max(depth, front - back);
    }
    // Marks that all stand above one place tell no scale: as on most films.
    const double spacing = depth > 5.0
                             ? depth * geometry.sourceToDetector / geometry.sourceToMidsagittal / extent.GetLength()
                             : PoseWorkingPixel;
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

/** Pose and projection in the mesh's frame. */
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

/** What the verdict wants to know of a jaw besides the fit. */
void
DescribeJaw(const PoseJawInput &            input,
            const TriangleSurface &         surface,
            const PoseRegistrationOptions & options,
            PoseJawResult &                 result)
{
  double low = 0.0, high = 0.0;
  for (const auto & p : surface.points)
  {
    low = std::min<double>(low, p[1]);
    high = std::max<double>(high, p[1]);
  }
  result.archWidth = high - low;
  double sum = 0.0, area = 0.0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const auto normal = surface.AreaNormal(t);
    sum += normal[2];
    area += std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
  }
  result.winding = area > 0.0 ? (input.jaw == ToothCode::JawEnum::Upper ? -sum : sum) / area : 0.0;
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

/** How a jaw's tracing is explained at the solution, and its moving contour in pixels and on the mesh. */
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
      jaw.contourPoints.push_back(ToMeshFrame(jaw.frame, contours[s].rim[i]));
    }
  }
}
/** The outlines of whole teeth of a jaw at the solution. */
void
DescribeOutlines(const ToothOutlinePoseMetricv4 &               metric,
                 const ToothOutlinePoseMetricv4::PositionType & x,
                 PoseJawResult &                                jaw)
{
  for (const auto & residual : metric.ComputeOutlineResiduals(x))
  {
    jaw.outlines.push_back({ residual.name,
                             residual.shift,
                             residual.distance,
                             residual.weight,
                             residual.matchedShare,
                             residual.isTemplate });
  }
}

/** The landmarks of a jaw at the solution. */
void
DescribeLandmarks(const LandmarkPoseMetricv4 &               metric,
                  const LandmarkPoseMetricv4::PositionType & x,
                  PoseJawResult &                            jaw)
{
  for (const auto & residual : metric.ComputeLandmarkResiduals(x))
  {
    jaw.landmarks.push_back(
      { residual.name, { { residual.difference[0], residual.difference[1] } }, residual.distance, residual.weight });
  }
}

/** The uncertainty of the middle of both sides at the front of the arch and 35 mm behind it, where first molars stand:
 * what drawings that are of no side determine. */
void
DescribeMiddle(const TriangleSurface &        surface,
               const PoseGeometry &           geometry,
               const PoseModel &              model,
               const std::array<double, 49> & covariance,
               PoseJawResult &                jaw)
{
  constexpr double    behindIncisors = 35.0;
  constexpr double    halfWidth = 22.0;
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
    sum += variance;
    jaw.largestMiddleSigma = std::max(jaw.largestMiddleSigma, std::sqrt(variance));
  }
  jaw.middleSigma = std::sqrt(0.5 * sum);
}
} // namespace

std::vector<PoseRegistrationEngine::JawType>
PoseRegistrationEngine::PrepareJaws(const PoseProblem &      problem,
                                    const PoseGeometry &     geometry,
                                    PoseRegistrationResult & result) const
{
  const PoseRegistrationOptions & options = problem.options;
  std::vector<JawType>            jaws(problem.jaws.size());
  auto                            transform = CephalometricPoseTransform::New();
  transform->SetPoseGeometry(geometry);
  for (std::size_t j = 0; j < jaws.size(); ++j)
  {
    const PoseJawInput & input = problem.jaws[j];
    result.jaws[j].jaw = input.jaw;
    result.jaws[j].frame = input.frame;
    if (input.surface == nullptr || input.surface->triangles.empty())
    {
      result.jaws[j].failure = "there is no surface";
      continue;
    }
    if (input.landmarks.IsNotNull() && input.counterparts.IsNotNull())
    {
      const auto counterparts = LandmarkCounterpartSet::New();
      for (LandmarkCounterpartSet::CounterpartType counterpart : input.counterparts->GetCounterparts())
      {
        if (counterpart.jaw != input.jaw || input.landmarks->Find(counterpart.name) == nullptr)
        {
          continue;
        }
        for (auto & point : counterpart.points)
        {
          const auto q = ToDentalFrame(input.frame, { { point[0], point[1], point[2] } });
          std::copy(q.begin(), q.end(), point.Begin());
        }
        counterparts->Add(counterpart);
      }
      if (!counterparts->GetCounterparts().empty())
      {
        jaws[j].landmarks = LandmarkPoseMetricv4::New();
        jaws[j].landmarks->SetTransform(transform);
        jaws[j].landmarks->SetCounterparts(counterparts);
        jaws[j].landmarks->SetCephalometricLandmarks(input.landmarks);
        if (options.useRobustKernel)
        {
          jaws[j].landmarks->SetRobustKernel(GemanMcClureKernel::New());
        }
      }
    }
    if (input.tracing.IsNull())
    {
      continue;
    }
    if (options.tracedSide == TracedSideEnum::Standard)
    {
      this->PrepareOutlines(input, options, transform, jaws[j], result.jaws[j]);
      continue;
    }
    jaws[j].metric = SilhouettePoseMetricv4::New();
    jaws[j].metric->SetTransform(transform);
    jaws[j].metric->SetFixedContour(input.tracing);
    jaws[j].metric->SetJaw(input.jaw);
    jaws[j].metric->SetTracedSide(options.tracedSide);
    jaws[j].metric->SetUseSideSelection(options.useSideSelection);
    jaws[j].metric->SetMidlineMargin(options.midlineMargin);
    jaws[j].metric->SetUseFacingFilter(options.useFacingFilter);
    jaws[j].metric->SetUseOrientation(options.useOrientation);
    jaws[j].metric->SetOrientationWeight(options.orientationWeight);
    jaws[j].metric->SetGateByTooth(options.gateByTooth);
    jaws[j].metric->SetToothRange(options.toothRange);
    jaws[j].metric->SetReverseWeight(options.reverseWeight);
    jaws[j].metric->SetTaperLength(options.taperLength);
    jaws[j].metric->SetGapLength(options.gapLength);
    jaws[j].metric->SetMaximumTracingPoints(options.maximumTracingPoints);
    jaws[j].metric->SetExcludedTeeth(options.excludedTeeth);
  }
  monitor->ForEach(jaws.size(), options.numberOfThreads, [&](std::size_t j) {
    if (!result.jaws[j].failure.empty())
    {
      return;
    }
    jaws[j].surface = ToDentalFrame(*problem.jaws[j].surface, problem.jaws[j].frame);
    if (jaws[j].metric.IsNull())
    {
      return;
    }
    jaws[j].metric->SetMovingSurface(jaws[j].surface);
    jaws[j].metric->Prepare();
    const std::string failure = jaws[j].metric->GetFailure();
    if (!failure.empty())
    {
      // Landmarks speak for the jaw where its tracing cannot.
      (jaws[j].landmarks.IsNotNull() ? result.jaws[j].tracingFailure : result.jaws[j].failure) = failure;
      jaws[j].metric = nullptr;
    }
  });
  return jaws;
}

void
PoseRegistrationEngine::PrepareOutlines(const PoseJawInput &               input,
                                        const PoseRegistrationOptions &    options,
                                        const CephalometricPoseTransform * transform,
                                        JawType &                          jaw,
                                        PoseJawResult &                    result) const
{
  const auto crowns = ToothCrownSet::New();
  if (input.crowns.IsNotNull())
  {
    for (ToothCrownSet::CrownType crown : input.crowns->GetCrowns())
    {
      if (crown.tooth.GetJaw() == input.jaw)
      {
        crown.surface = ToDentalFrame(*crown.surface, input.frame);
        crowns->Add(crown);
      }
    }
  }
  auto metric = ToothOutlinePoseMetricv4::New();
  metric->SetTransform(transform);
  metric->SetCrowns(crowns);
  metric->SetFixedContour(input.tracing);
  metric->SetJaw(input.jaw);
  metric->SetExcludedTeeth(options.excludedTeeth);
  std::vector<unsigned int> marked;
  if (jaw.landmarks.IsNotNull())
  {
    for (const auto & landmark : input.landmarks->GetLandmarks())
    {
      if (landmark.meaning.jaw == input.jaw &&
          jaw.landmarks->GetCounterparts()->Find(CephalometricLandmarkSet::MakeName(landmark.meaning)) != nullptr)
      {
        marked.push_back(landmark.meaning.position);
      }
    }
    metric->SetMarkedTeeth(marked);
    // What a textbook's place gets wrong, landmark and crown get wrong alike: both together were worse than one.
    constexpr double surestPlaceOfATextbook = 1.0;
    metric->SetMaximumCutSigma(surestPlaceOfATextbook);
  }
  metric->Prepare();
  for (const auto & unused : metric->GetUnused())
  {
    result.unusedOutlines.push_back(unused.name + ": " + unused.reason);
  }
  if (metric->GetFailure().empty())
  {
    jaw.outlines = metric;
    if (jaw.landmarks.IsNotNull())
    {
      jaw.landmarks->SetOutlinedTeeth(metric->GetTeethPositions());
    }
  }
  else if (jaw.landmarks.IsNull())
  {
    result.failure = metric->GetFailure();
  }
}

PoseRegistrationEngine::MetricType::Pointer
PoseRegistrationEngine::MakeMetric(const PoseProblem &              problem,
                                   const PoseGeometry &             geometry,
                                   const std::vector<JawType> &     jaws,
                                   const std::vector<std::size_t> & members) const
{
  auto sum = MetricType::New();
  for (const std::size_t j : members)
  {
    if (jaws[j].metric.IsNotNull())
    {
      sum->AddMetric(jaws[j].metric);
    }
  }
  PosePriors(problem.options, geometry.pixelSpacingKnown).AddTo(*sum);
  for (const std::size_t j : members)
  {
    if (jaws[j].outlines.IsNotNull())
    {
      sum->AddMetric(jaws[j].outlines, MetricType::SettingsEnum::Own);
    }
    if (jaws[j].landmarks.IsNotNull())
    {
      // The errors of marks and of whole teeth are known: neither the width nor the levels that a tracing's points go
      // through are theirs.
      sum->AddMetric(jaws[j].landmarks, MetricType::SettingsEnum::Own);
    }
  }
  for (const PoseProblemTerm & term : problem.terms)
  {
    // What a user has set of kernel and noise is the user's.
    sum->AddMetric(term.metric, MetricType::SettingsEnum::Own);
  }
  sum->Initialize();
  return sum;
}

PoseRegistrationResult
PoseRegistrationEngine::Run(const PoseProblem & problem, std::vector<GroupType> * answered) const
{
  const PoseRegistrationOptions & options = problem.options;
  PoseRegistrationResult          result;
  result.geometry = problem.completed ? *problem.completed : CompleteGeometry(problem);
  CheckGeometry(result.geometry);
  result.jaws.resize(problem.jaws.size());
  const std::vector<JawType> jaws = this->PrepareJaws(problem, result.geometry, result);

  // Groups of jaws with one pose.
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t j = 0; j < jaws.size(); ++j)
  {
    const bool anyEvidence =
      jaws[j].HasEvidence() || (options.useJointPose && std::any_of(jaws.begin(), jaws.end(), [](const JawType & jaw) {
                                  return jaw.HasEvidence();
                                }));
    if (result.jaws[j].failure.empty() && !anyEvidence)
    {
      result.jaws[j].failure = "nothing was drawn of this jaw, and no other jaw shares its frame";
    }
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
  result.groupOfJaw.assign(jaws.size(), groups.size());
  for (std::size_t g = 0; g < groups.size(); ++g)
  {
    const std::vector<std::size_t> & members = groups[g];
    const auto                       index = static_cast<unsigned int>(g);
    PoseProblem                      own = problem;
    own.completed = result.geometry;
    own.jaws.clear();
    own.terms.clear();
    for (const std::size_t j : members)
    {
      own.jaws.push_back(problem.jaws[j]);
    }
    std::copy_if(
      problem.terms.begin(), problem.terms.end(), std::back_inserter(own.terms), [&own](const PoseProblemTerm & term) {
        return term.jaw == ToothCode::JawEnum::Unknown ||
               std::any_of(
                 own.jaws.begin(), own.jaws.end(), [&](const PoseJawInput & jaw) { return jaw.jaw == term.jaw; });
      });
    const auto started = std::find_if(
      own.jaws.begin(), own.jaws.end(), [](const PoseJawInput & jaw) { return jaw.initialPose.has_value(); });
    if (started != own.jaws.end())
    {
      own.options.initialPose = *started->initialPose;
      own.options.useInitialPose = true;
    }
    PoseGroupResult group;
    group.jaws = members;
    group.bisected = IsBisected(options.tracedSide);
    const MetricType::Pointer metric = this->MakeMetric(own, result.geometry, jaws, members);
    if (groupObserver)
    {
      groupObserver(index, static_cast<unsigned int>(groups.size()), metric);
    }
    PoseGroupRegistration registration(
      own.options,
      result.geometry.pixelSpacingKnown,
      metric,
      parts,
      optimizer,
      start,
      *monitor,
      [&](PoseStageEnum stage) {
        if (stageObserver)
        {
          stageObserver(index, stage);
        }
      },
      index,
      !stageObserver);
    if (!registration.Run(group))
    {
      result.aborted = true;
      return result;
    }
    if (group.candidates.empty())
    {
      for (const std::size_t j : members)
      {
        result.jaws[j].failure = "no start was found: nothing of what was drawn can be matched with the surface";
      }
      result.groups.push_back(std::move(group));
      continue;
    }
    const GroupType answer{ own, registration.GetMetric(), registration.GetSolution(), index };
    this->TryHypotheses(answer, group);
    if (answered != nullptr)
    {
      answered->push_back(answer);
    }
    if (monitor->IsAborted())
    {
      result.aborted = true;
      return result;
    }
    const auto  silhouettes = FindSilhouettes(*metric, registration.GetSolution());
    const auto  landmarks = LandmarkPoseStart::FindTerms(*metric);
    const auto  outlines = LandmarkPoseStart::FindOutlineTerms(*metric);
    std::size_t nextSilhouette = 0;
    std::size_t nextLandmarks = 0;
    std::size_t nextOutlines = 0;
    for (std::size_t m = 0; m < members.size(); ++m)
    {
      PoseJawResult & jaw = result.jaws[members[m]];
      result.groupOfJaw[members[m]] = g;
      jaw.registered = true;
      PlaceJaw(result.geometry, group.parameters, jaw);
      DescribeJaw(problem.jaws[members[m]], *jaws[members[m]].surface, options, jaw);
      // The jaws' terms are the sum's first of their kind, in the order of the jaws.
      const JawType & prepared = jaws[members[m]];
      jaw.placedByOther = !prepared.HasEvidence();
      if (prepared.metric.IsNotNull())
      {
        const FoundSilhouette & found = silhouettes[nextSilhouette++];
        DescribeFit(*found.metric, found.position, group.covariance, result.geometry, jaw);
      }
      const std::vector<double> pose(group.parameters.begin(), group.parameters.end());
      if (prepared.outlines.IsNotNull())
      {
        DescribeOutlines(*outlines[nextOutlines++], pose, jaw);
      }
      if (prepared.landmarks.IsNotNull())
      {
        DescribeLandmarks(*landmarks[nextLandmarks++], pose, jaw);
      }
      DescribeMiddle(
        *prepared.surface, result.geometry, PoseModel(result.geometry, group.parameters), group.covariance, jaw);
    }
    result.groups.push_back(std::move(group));
  }
  return result;
}

std::string
PoseRegistrationEngine::GetObstacle(const PoseProblem & problem)
{
  const PoseRegistrationOptions & options = problem.options;
  const bool isHeld = options.useInitialPose || options.fixRotation || options.fixScale || options.fixTranslation;
  return isHeld ? "beside a given start or held values any free search looks better" : "";
}

void
PoseRegistrationEngine::TryHypotheses(const GroupType & group, PoseGroupResult & result) const
{
  if (!group.problem.options.checkHypotheses || !GetObstacle(group.problem).empty())
  {
    return;
  }
  for (const auto & hypothesis : hypotheses)
  {
    if (monitor->IsAborted())
    {
      return;
    }
    if (!hypothesis->IsWorthTrying(group.problem, result))
    {
      continue;
    }
    const std::string obstacle = hypothesis->GetObstacle(group.problem);
    if (!obstacle.empty())
    {
      result.untried[hypothesis->GetCode()] = obstacle;
      continue;
    }
    const auto outcome = this->TryHypothesis(group, *hypothesis);
    if (!outcome)
    {
      return;
    }
    result.outcomes[hypothesis->GetCode()] = *outcome;
  }
}

std::optional<PoseHypothesisOutcome>
PoseRegistrationEngine::TryHypothesis(const GroupType & group, const PoseHypothesis & hypothesis) const
{
  PoseProblem question = hypothesis.Apply(group.problem);
  question.options.useJointPose = true;
  PoseRegistrationResult answer;
  answer.geometry = question.completed ? *question.completed : CompleteGeometry(question);
  answer.jaws.resize(question.jaws.size());
  const std::vector<JawType> jaws = this->PrepareJaws(question, answer.geometry, answer);
  std::vector<std::size_t>   members;
  for (std::size_t j = 0; j < jaws.size(); ++j)
  {
    if (answer.jaws[j].failure.empty() && jaws[j].HasEvidence())
    {
      members.push_back(j);
    }
  }
  PoseHypothesisOutcome outcome;
  if (members.empty() || monitor->IsAborted())
  {
    return outcome;
  }
  PoseGroupResult           result;
  const MetricType::Pointer metric = this->MakeMetric(question, answer.geometry, jaws, members);
  PoseGroupRegistration     other(
    question.options,
    group.problem.completed->pixelSpacingKnown,
    metric,
    parts,
    optimizer,
    start,
    *monitor,
    [](PoseStageEnum) {},
    group.index,
    true);
  if (!other.Run(result))
  {
    return std::nullopt;
  }
  if (!result.candidates.empty())
  {
    outcome.score = result.score;
    if (hypothesis.GetComparesDeviance())
    {
      std::array<double, 2> deviance{};
      monitor->ForEach(2, group.problem.options.numberOfThreads, [&](std::size_t k) {
        deviance[k] = k == 0 ? PoseGroupRegistration::ComputeDeviance(*group.metric, group.solution)
                             : PoseGroupRegistration::ComputeDeviance(*other.GetMetric(), other.GetSolution());
      });
      outcome.deviance = deviance[1] - deviance[0];
    }
  }
  return outcome;
}
} // namespace itk

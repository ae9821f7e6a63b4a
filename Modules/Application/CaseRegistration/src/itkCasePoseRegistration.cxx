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
#include "itkCasePoseRegistration.h"

#include "itkCaseChecks.h"
#include "itkCaseCrowns.h"
#include "itkCaseSimilarityRegistration.h"
#include "itkContourDistanceFilter.h"
#include "itkMeshSilhouette.h"
#include "itkParallelFor.h"
#include "itkPartialContourMetricv4.h"
#include "itkPixelSpacingVerdict.h"
#include "itkPoseModel.h"
#include "itkPoseRegistrationKernel.h"
#include "itkRegistrationVerdict.h"

#include "itkTimeProbe.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace itk
{
namespace
{
using JawEnum = ToothCode::JawEnum;

/** mm on the detector within which the moving contour counts as matched. */
constexpr double MatchedWithin = 2.5;

PoseTracedSideEnum
ToPoseSide(TracedSideEnum side)
{
  switch (side)
  {
    case TracedSideEnum::Left:
      return PoseTracedSideEnum::Left;
    case TracedSideEnum::Mean:
      return PoseTracedSideEnum::Mean;
    case TracedSideEnum::Both:
      return PoseTracedSideEnum::Both;
    default:
      return PoseTracedSideEnum::Right;
  }
}

PoseFrame
ToPoseFrame(const DentalJawFrame & frame)
{
  PoseFrame poseFrame;
  for (unsigned int row = 0; row < 3; ++row)
  {
    std::copy(frame.axes[row].begin(), frame.axes[row].end(), poseFrame.rotation.begin() + 3 * row);
  }
  poseFrame.origin = frame.origin;
  return poseFrame;
}

PoseGeometry
ToPoseGeometry(const DentalCaseData & data)
{
  const CephalometricGeometry & geometry = *data.geometry;
  PoseGeometry                  pose;
  pose.sourceToMidsagittal = geometry.GetSourceToMidsagittalDistance();
  pose.sourceToDetector = geometry.GetSourceToDetectorDistance();
  pose.sourceSign = geometry.GetSourceSign();
  pose.facingSign = geometry.GetFacingSign();
  pose.pixelSpacingKnown = data.HasPixelSpacing();
  pose.principalPointKnown = data.HasPrincipalPoint();
  for (unsigned int d = 0; d < 2; ++d)
  {
    if (pose.pixelSpacingKnown)
    {
      pose.pixelSpacing[d] = geometry.GetPixelSpacing()[d];
    }
    pose.principalPoint[d] = geometry.GetPrincipalPoint()[d];
  }
  return pose;
}

std::vector<PosePolyline>
ToPosePolylines(const DentalContour * contour)
{
  std::vector<PosePolyline> polylines;
  for (const auto & polyline : contour->GetPolylines())
  {
    PosePolyline converted;
    converted.tooth = polyline.code.GetFDI();
    converted.closed = polyline.closed;
    converted.weights = polyline.weights;
    for (const auto & point : polyline.points)
    {
      converted.points.push_back({ { point[0], point[1] } });
    }
    polylines.push_back(converted);
  }
  return polylines;
}

/** How well spacing x magnification is known. What a file's estimated or corrected magnification hides is not the
 * detector's pixel: it may be off by what the maker assumed. */
double
PriorOfScale(const DentalCaseData & data, const PoseRegistrationOptions & options)
{
  using MetricType = PartialContourMetricv4;
  std::ostringstream detector;
  detector << PixelSpacingVerdictEnum::Detector;
  return data.sources.pixelSpacing == ValueSourceEnum::DICOM && data.spacingVerdict != detector.str()
           ? MetricType::GetScaleSigma(ContourMetricEnums::SpacingSource::Dicom)
           : options.kappaSigma;
}

/** A user's pose, mesh (mm) to cephalostat, as the kernel's parameters: R = Ry Rx Rz of the dental frame. */
PoseParameters
PoseToParameters(const std::array<double, 12> & pose, const PoseFrame & frame)
{
  double         rotation[3][3];
  PoseParameters parameters{};
  for (unsigned int row = 0; row < 3; ++row)
  {
    parameters[PoseTx + row] = pose[4 * row + 3];
    for (unsigned int column = 0; column < 3; ++column)
    {
      rotation[row][column] = 0.0;
      for (unsigned int d = 0; d < 3; ++d)
      {
        rotation[row][column] += pose[4 * row + d] * frame.rotation[3 * column + d];
      }
      parameters[PoseTx + row] += pose[4 * row + column] * frame.origin[column];
    }
  }
  parameters[PosePitch] = std::atan2(rotation[0][2], rotation[2][2]);
  parameters[PoseRoll] = std::asin(std::max(-1.0, std::min(1.0, -rotation[1][2])));
  parameters[PoseYaw] = std::atan2(rotation[1][0], rotation[1][1]);
  return parameters;
}

/** A user's similarity on the projection of the jaw's own frame, as the pose that it amounts to: mesh (mm) to
 * cephalostat. Its scale is no part of that. */
std::array<double, 12>
SimilarityToPose(const SimilarityParameters & similarity, const PoseFrame & own, const PoseGeometry & geometry)
{
  const double magnification = geometry.sourceToDetector / geometry.sourceToMidsagittal * similarity.scale;
  const double c = std::cos(geometry.facingSign * similarity.rotation);
  const double s = std::sin(geometry.facingSign * similarity.rotation);
  const double pitch[3][3] = { { c, 0.0, s }, { 0.0, 1.0, 0.0 }, { -s, 0.0, c } };
  const std::array<double, 3> translation{
    { geometry.facingSign * (similarity.translation[0] - geometry.principalPoint[0]) * geometry.pixelSpacing[0] /
        magnification,
      0.0,
      -(similarity.translation[1] - geometry.principalPoint[1]) * geometry.pixelSpacing[1] / magnification }
  };
  std::array<double, 12> pose{};
  for (unsigned int row = 0; row < 3; ++row)
  {
    pose[4 * row + 3] = translation[row];
    for (unsigned int column = 0; column < 3; ++column)
    {
      for (unsigned int d = 0; d < 3; ++d)
      {
        pose[4 * row + column] += pitch[row][d] * own.rotation[3 * d + column];
      }
      pose[4 * row + 3] -= pose[4 * row + column] * own.origin[column];
    }
  }
  return pose;
}

/** What the case says to start from, a jaw each, in the frames that the jaws are registered in. */
void
SetInitialPoses(const DentalCaseData &      data,
                const DentalFrameResult &   frames,
                const PoseGeometry &        geometry,
                std::vector<PoseJawInput> & inputs,
                CaseResult &                result)
{
  const DentalCase & description = data.description;
  if (!description.initialPose && description.initialSimilarity.empty())
  {
    return;
  }
  if (!geometry.principalPointKnown || !geometry.pixelSpacingKnown)
  {
    result.warnings.push_back("\"init\" is not used: it means nothing without pixel spacing and principal point");
    return;
  }
  for (PoseJawInput & input : inputs)
  {
    if (description.initialPose)
    {
      input.initialPose = PoseToParameters(*description.initialPose, input.frame);
      continue;
    }
    const auto similarity = description.initialSimilarity.find(input.upper ? JawEnum::Upper : JawEnum::Lower);
    if (similarity != description.initialSimilarity.end())
    {
      const PoseFrame own = ToPoseFrame(input.upper ? frames.upper : frames.lower);
      input.initialPose = PoseToParameters(SimilarityToPose(similarity->second, own, geometry), input.frame);
      (*input.initialPose)[PoseKappa] = std::log(similarity->second.scale);
    }
  }
}

/** The similarity on the geometry's own projection of the jaw's frame that comes nearest (least squares over the
 * vertices) to a full projection. */
SimilarityParameters
FitSimilarity(const TriangleSurface &        surface,
              const std::array<double, 12> & meshToFrame,
              const std::array<double, 12> & projection,
              const CephalometricGeometry &  geometry)
{
  const double S = geometry.GetSourceToMidsagittalDistance();
  const double D = geometry.GetSourceToDetectorDistance();
  double       mean[4] = { 0.0, 0.0, 0.0, 0.0 };
  double       dot = 0.0;
  double       cross = 0.0;
  double       squares = 0.0;
  double       count = 0.0;
  for (const auto & point : surface.points)
  {
    double frame[3];
    double homogeneous[3];
    for (unsigned int row = 0; row < 3; ++row)
    {
      frame[row] = meshToFrame[4 * row + 3];
      homogeneous[row] = projection[4 * row + 3];
      for (unsigned int d = 0; d < 3; ++d)
      {
        frame[row] += meshToFrame[4 * row + d] * point[d];
        homogeneous[row] += projection[4 * row + d] * point[d];
      }
    }
    const double m = D / (S + geometry.GetSourceSign() * frame[1]);
    const double values[4] = { geometry.GetFacingSign() * m * frame[0] / geometry.GetPixelSpacing()[0],
                               -m * frame[2] / geometry.GetPixelSpacing()[1],
                               homogeneous[0] / homogeneous[2],
                               homogeneous[1] / homogeneous[2] };
    // Running covariance: no cancellation (Welford).
    count += 1.0;
    double delta[4];
    for (unsigned int d = 0; d < 4; ++d)
    {
      delta[d] = values[d] - mean[d];
      mean[d] += delta[d] / count;
    }
    const double weight = (count - 1.0) / count;
    dot += weight * (delta[0] * delta[2] + delta[1] * delta[3]);
    cross += weight * (delta[0] * delta[3] - delta[1] * delta[2]);
    squares += weight * (delta[0] * delta[0] + delta[1] * delta[1]);
  }
  SimilarityParameters similarity;
  similarity.scale = std::hypot(dot, cross) / squares;
  similarity.rotation = std::atan2(cross, dot);
  const double c = dot / squares;
  const double s = cross / squares;
  similarity.translation = { { mean[2] - c * mean[0] + s * mean[1], mean[3] - s * mean[0] - c * mean[1] } };
  return similarity;
}

CaseStatusEnum
ToCaseStatus(RegistrationVerdict::StatusEnum status)
{
  switch (status)
  {
    case RegistrationVerdict::StatusEnum::Ok:
      return CaseStatusEnum::Ok;
    case RegistrationVerdict::StatusEnum::Suspect:
      return CaseStatusEnum::Suspect;
    default:
      return CaseStatusEnum::Failed;
  }
}

/** The same landmark of the other side; null without one. */
const DentalLandmarkSet<3>::LandmarkType *
FindOtherSide(const DentalLandmarkSet<3> & landmarks, const std::string & name)
{
  const auto   kindOf = [](const std::string & text) { return text.substr(std::min(text.size(), text.find('_'))); };
  const auto * own = landmarks.Find(name);
  for (const auto & landmark : landmarks.GetLandmarks())
  {
    if (landmark.tooth == own->tooth.GetContralateral() && kindOf(landmark.name) == kindOf(name))
    {
      return &landmark;
    }
  }
  return nullptr;
}

/** The projection of a scan at the solution. */
PerspectiveProjection
PlaceJaw(const PoseJawResult & poseJaw, double kappa, const CephalometricGeometry * geometry)
{
  const auto spacing = geometry->GetPixelSpacing();
  // Scale is spacing x magnification: as a geometry it is a pixel of another size.
  auto placed = CephalometricGeometry::New();
  placed->CopyParameters(geometry);
  placed->SetPixelSpacing(spacing * std::exp(-kappa));
  CephalometricGeometry::RotationType rotation;
  CephalometricGeometry::VectorType   translation;
  for (unsigned int row = 0; row < 3; ++row)
  {
    translation[row] = poseJaw.translation[row];
    for (unsigned int column = 0; column < 3; ++column)
    {
      rotation(row, column) = poseJaw.rotation[3 * row + column];
    }
  }
  placed->SetPose(rotation, translation);
  return placed->GetProjection();
}

/** The exact silhouette of the whole scan at the solution, and the paper's figures on it. */
void
MeasureWholeSilhouette(const Silhouette &            silhouette,
                       const PerspectiveProjection & projection,
                       DentalContour *               tracing,
                       unsigned int                  numberOfPoints,
                       JawResult &                   result)
{
  auto contour = DentalContour::New();
  if (!silhouette.loops.empty())
  {
    DentalContour::PolylineType polyline;
    polyline.closed = true;
    for (const SilhouetteSample & sample : ResampleSilhouetteLoop(silhouette.loops.front(), projection, numberOfPoints))
    {
      DentalContour::PointType point;
      point[0] = sample.u;
      point[1] = sample.v;
      polyline.points.push_back(point);
    }
    contour->AddPolyline(polyline);
  }
  auto distances = ContourDistanceFilter::New();
  distances->SetFixedContour(tracing);
  distances->SetMovingContour(contour);
  distances->Update();
  result.metrics.emplace_back("whole", ToContourFigures(distances));
  result.contours.emplace_back("whole", contour);
}

/** The result's way of writing a projection: from the mesh file's unit. */
std::array<double, 12>
FromFileUnit(std::array<double, 12> projection, double millimetresPerUnit)
{
  for (unsigned int i = 0; i < 12; ++i)
  {
    projection[i] *= i % 4 < 3 ? millimetresPerUnit : 1.0;
  }
  return projection;
}

/** The minima of a jaw's group that are places of their own: what ends less than a working pixel from the best is not.
 */
std::vector<AlignmentCandidate>
ListCandidates(const PoseGroupResult & group,
               const PoseFrame &       frame,
               const PoseGeometry &    geometry,
               double                  millimetresPerUnit)
{
  std::vector<AlignmentCandidate> candidates;
  for (const PoseCandidate & minimum : group.candidates)
  {
    if (!candidates.empty() && minimum.distance < 1.0)
    {
      continue;
    }
    AlignmentCandidate candidate;
    candidate.projection =
      FromFileUnit(PoseModel(geometry, minimum.parameters).GetPixelProjection(frame), millimetresPerUnit);
    candidate.score = minimum.score;
    candidate.distance =
      minimum.distance * PoseWorkingPixel / (0.5 * (geometry.pixelSpacing[0] + geometry.pixelSpacing[1]));
    candidates.push_back(candidate);
  }
  return candidates;
}

void
MeasureMatchedContour(const PoseJawResult & pose, DentalContour * tracing, double spacing, JawResult & result)
{
  // The method's contour holds everything that could be matched: keep what lies beside the tracing, in pieces.
  const double                          maximumDistance = MatchedWithin / spacing;
  const double                          maximumGap = 3.0 / spacing;
  auto                                  contour = DentalContour::New();
  std::vector<DentalContour::PointType> points;
  for (const auto & position : pose.contour)
  {
    DentalContour::PointType point;
    point[0] = position[0];
    point[1] = position[1];
    bool beside = false;
    for (auto it = tracing->GetPoints()->Begin(); it != tracing->GetPoints()->End() && !beside; ++it)
    {
      beside = it.Value().EuclideanDistanceTo(point) < maximumDistance;
    }
    if (!points.empty() && (!beside || points.back().EuclideanDistanceTo(point) > maximumGap))
    {
      contour->AddPolyline(points);
      points.clear();
    }
    if (beside)
    {
      points.push_back(point);
    }
  }
  contour->AddPolyline(points);
  if (contour->GetNumberOfPoints() == 0)
  {
    return;
  }
  auto distances = ContourDistanceFilter::New();
  distances->SetFixedContour(tracing);
  distances->SetMovingContour(contour);
  distances->Update();
  result.metrics.emplace_back("matched", ToContourFigures(distances));
  result.contours.emplace_back("matched", contour);
}
} // namespace

void
RegisterCaseByPose(const DentalCaseData &                 data,
                   const DentalFrameResult &              frames,
                   const std::array<TriangleSurface, 2> & surfaces,
                   const CasePoseSettings &               settings,
                   CaseResult &                           result)
{
  std::vector<PoseJawInput>      inputs;
  std::vector<JawEnum>           jaws;
  std::array<TriangleSurface, 2> crowns;
  const bool                     joint = frames.jawsShareFrame && frames.joint.valid;
  for (const auto & entry : result.jaws)
  {
    if (entry.second.status == CaseStatusEnum::Failed)
    {
      continue;
    }
    const bool             upper = entry.first == JawEnum::Upper;
    const DentalJawFrame & own = upper ? frames.upper : frames.lower;
    PoseJawInput           input;
    input.surface = &surfaces[upper ? 0 : 1];
    if (data.description.crowns != CrownsEnum::Off)
    {
      crowns[upper ? 0 : 1] = SelectCaseCrowns(data, entry.first, own, *input.surface);
      input.surface = &crowns[upper ? 0 : 1];
    }
    input.frame = ToPoseFrame(joint ? frames.joint : own);
    input.upper = upper;
    input.tracing = ToPosePolylines(data.GetJaw(entry.first).contour);
    inputs.push_back(input);
    jaws.push_back(entry.first);
  }
  if (inputs.empty())
  {
    return;
  }
  PoseRegistrationOptions options = settings.options;
  options.tracedSide = ToPoseSide(data.description.tracedSide);
  options.useJointPose = options.useJointPose && joint;
  options.fixScale = data.description.fixScale;
  options.fixRotation = data.description.fixRotation;
  options.fixTranslation = data.description.fixTranslation;
  if (!settings.kappaSigmaIsGiven)
  {
    options.kappaSigma = PriorOfScale(data, options);
  }
  options.numberOfThreads = settings.numberOfThreads;
  options.progress = settings.progress;

  TimeProbe probe;
  probe.Start();
  const PoseGeometry geometry = ToPoseGeometry(data);
  SetInitialPoses(data, frames, geometry, inputs, result);
  const PoseRegistrationResult pose = PoseRegistrationKernel::Run(inputs, geometry, options);
  probe.Stop();
  if (pose.aborted)
  {
    throw ProcessAborted(__FILE__, __LINE__);
  }

  CephalometricGeometry::PixelSpacingType spacing;
  CephalometricGeometry::PixelIndexType   principal;
  for (unsigned int d = 0; d < 2; ++d)
  {
    spacing[d] = pose.geometry.pixelSpacing[d];
    principal[d] = pose.geometry.principalPoint[d];
  }
  result.geometry->SetPixelSpacing(spacing);
  result.geometry->SetPrincipalPoint(principal);

  const auto verdicts = RegistrationVerdict::Evaluate(pose);
  options.useInitialPose =
    options.useInitialPose ||
    std::any_of(inputs.begin(), inputs.end(), [](const PoseJawInput & input) { return input.initialPose.has_value(); });
  const auto isClosed = [](const DentalJawFrame & frame) {
    return frame.valid && frame.openness <= OpennessOfClosedCast;
  };
  const bool closedTold = isClosed(frames.upper) || isClosed(frames.lower);
  for (const std::string & sentence : RegistrationVerdict::GetNotCheckable(pose, options))
  {
    // Said already by the checks of the input, of each cast.
    if (!closedTold || sentence != RegistrationVerdict::ClosedCastLine)
    {
      result.notCheckable.push_back(sentence);
    }
  }

  // The largest part of what remains, and the jaws do not need each other.
  TimeProbe silhouetteProbe;
  silhouetteProbe.Start();
  std::vector<PerspectiveProjection> projections(inputs.size());
  std::vector<Silhouette>            silhouettes(inputs.size());
  ParallelFor(inputs.size(), settings.numberOfThreads, [&](std::size_t i) {
    if (pose.jaws[i].registered)
    {
      const double kappa = pose.groups[pose.groupOfJaw[i]].parameters[PoseKappa];
      projections[i] = PlaceJaw(pose.jaws[i], kappa, result.geometry);
      silhouettes[i] = MeshSilhouette(surfaces[inputs[i].upper ? 0 : 1]).ComputeOuterBoundary(projections[i]);
    }
  });
  silhouetteProbe.Stop();

  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    const PoseJawResult & poseJaw = pose.jaws[i];
    JawResult &           jaw = result.jaws[jaws[i]];
    jaw.seconds.emplace_back("registration", probe.GetTotal());
    if (!poseJaw.registered)
    {
      jaw.AddReason(CaseStatusEnum::Failed, poseJaw.failure);
      continue;
    }
    jaw.registered = true;
    for (const auto & reason : verdicts[i].reasons)
    {
      // Said already by the checks of the input.
      if (reason.code != "arch-width" && reason.code != "inward-winding")
      {
        jaw.AddReason(ToCaseStatus(reason.severity), reason.text);
      }
    }
    const double unit = data.description.millimetresPerUnit;
    jaw.projection = FromFileUnit(poseJaw.projection, unit);
    for (unsigned int row = 0; row < 3; ++row)
    {
      for (unsigned int column = 0; column < 3; ++column)
      {
        jaw.meshToCephalostat[4 * row + column] = poseJaw.rotation[3 * row + column];
      }
      jaw.meshToCephalostat[4 * row + 3] = poseJaw.translation[row];
    }
    jaw.meshToUMDA = MeshToFrame(inputs[i].upper ? frames.upper : frames.lower);
    jaw.similarity =
      FitSimilarity(surfaces[inputs[i].upper ? 0 : 1], jaw.meshToUMDA, poseJaw.projection, *result.geometry);

    const PoseGroupResult & group = pose.groups[pose.groupOfJaw[i]];
    const double            kappa = group.parameters[PoseKappa];
    jaw.details = { { "pitch_rad", group.parameters[PosePitch] },
                    { "roll_rad", group.parameters[PoseRoll] },
                    { "yaw_rad", group.parameters[PoseYaw] },
                    { "scale_factor", std::exp(kappa) },
                    { "scale_prior_sd",
                      data.HasPixelSpacing() ? options.kappaSigma : options.kappaSigmaWithoutSpacing },
                    { "noise_correlated_px", group.smoothSigma },
                    { "noise_white_px", group.whiteSigma },
                    { "fit_cost", poseJaw.fit.cost },
                    { "fit_median_px", poseJaw.fit.medianResidual },
                    { "fit_p90_px", poseJaw.fit.p90Residual },
                    { "fit_inlier_share", poseJaw.fit.inlierShare },
                    { "overlap", poseJaw.fit.overlap },
                    { "prior_tension_sd", *std::max_element(group.priorTension.begin(), group.priorTension.end()) },
                    { "ambiguity_margin", group.margin },
                    { "similarity_rms_px", poseJaw.similarityRms } };

    jaw.candidates = ListCandidates(group, inputs[i].frame, pose.geometry, unit);

    TimeProbe contourProbe;
    contourProbe.Start();
    DentalContour * tracing = data.GetJaw(jaws[i]).contour;
    MeasureWholeSilhouette(
      silhouettes[i], projections[i], tracing, settings.numberOfContourPoints[inputs[i].upper ? 0 : 1], jaw);
    MeasureMatchedContour(poseJaw, tracing, 0.5 * (spacing[0] + spacing[1]), jaw);
    contourProbe.Stop();
    jaw.seconds.emplace_back("contour", contourProbe.GetTotal() + silhouetteProbe.GetTotal());

    PredictLandmarks(data, jaws[i], jaw);
    if (data.landmarks3D.IsNotNull())
    {
      for (LandmarkPrediction & landmark : jaw.landmarks)
      {
        const auto &          point = data.landmarks3D->Find(landmark.name)->point;
        std::array<double, 3> inMillimetres;
        for (unsigned int d = 0; d < 3; ++d)
        {
          inMillimetres[d] = point[d] * unit;
        }
        landmark.covariance = PoseRegistrationKernel::LandmarkCovariance(pose, inputs[i], i, inMillimetres);
        const auto * other = data.description.tracedSide == TracedSideEnum::Mean
                               ? FindOtherSide(*data.landmarks3D, landmark.name)
                               : nullptr;
        if (other != nullptr)
        {
          // The middle of two projections is the projection of the middle but for the perspective between them.
          for (unsigned int d = 0; d < 3; ++d)
          {
            inMillimetres[d] = 0.5 * (point[d] + other->point[d]) * unit;
          }
          landmark.middleCovariance = PoseRegistrationKernel::LandmarkCovariance(pose, inputs[i], i, inMillimetres);
        }
      }
    }
  }
}
} // namespace itk

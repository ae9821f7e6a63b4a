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

#include "itkCaseCourse.h"
#include "itkCaseCrowns.h"
#include "itkCasePoseDescription.h"
#include "itkCaseSimilarityRegistration.h"
#include "itkCaseViews.h"
#include "itkLandmarkProjectionFilter.h"
#include "itkPosePriors.h"
#include "itkPoseRegistrationMethod.h"
#include "itkProjectionSimilarityFilter.h"
#include "itkRegistrationVerdictFilter.h"
#include "itkRigidTransformRows.h"

#include "itkTimeProbe.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

namespace itk
{
namespace
{
using JawEnum = ToothCode::JawEnum;
using MeshType = DentalCaseData::MeshType;
using AxisType = UMidlineDentalAxisFilter<MeshType>;
using MethodType = PoseRegistrationMethod<MeshType>;

unsigned int
ToIndex(JawEnum jaw)
{
  return jaw == JawEnum::Upper ? 0 : 1;
}

/** Whether the scan is not one whole jaw in mm, of which everything else follows. */
bool
HasScanOfNoUse(const JawResult & jaw)
{
  return std::any_of(jaw.findings.begin(), jaw.findings.end(), [](const RegistrationFinding & finding) {
    return finding.code == "both-jaws" || finding.code == "same-scan" || finding.code == "partial-arch" ||
           finding.code == "arch-width";
  });
}

/** Whether a finding says that the drawing means something else. */
bool
IsOtherReading(const std::string & code)
{
  return code == "turned-image" || code == "pixel-spacing" || code == "facing" || code == "jaws-exchanged" ||
         code == "upward-drawing" || code == "other-side";
}

/** A case file's pose is checked to 1e-4 when it is read. */
constexpr double RotationTolerance = 1e-3;

/** What the case says to start from, a jaw each. */
void
SetInitialTransforms(const DentalCaseData &               data,
                     const std::map<JawEnum, JawResult> & jaws,
                     AxisType *                           axis,
                     MethodType *                         method,
                     CaseResult &                         result)
{
  const DentalCase & description = data.description;
  if (!description.HasStart())
  {
    return;
  }
  const auto & initialGeometry = description.initialGeometry;
  if (initialGeometry.IsNotNull())
  {
    if (initialGeometry->GetFacing() != data.geometry->GetFacing())
    {
      result.warnings.push_back("\"init\" is not used: it is of a radiograph that faces the other way");
      return;
    }
    method->SetInitialGeometry(initialGeometry);
    std::string taken = data.HasPrincipalPoint() ? "" : "principal point";
    if (!data.HasPixelSpacing())
    {
      taken += taken.empty() ? "pixel spacing" : " and pixel spacing";
    }
    // Where nothing is held they are estimated as without a start, which the case's own warnings say.
    if (!taken.empty() && (description.fixScale || description.fixRotation || description.fixTranslation))
    {
      result.warnings.push_back("\"init\": " + taken + " taken with the start, as the case gives none");
    }
  }
  else if (!data.HasPrincipalPoint() || !data.HasPixelSpacing())
  {
    result.warnings.push_back("\"init\" is not used: it means nothing without pixel spacing and principal point");
    return;
  }
  for (const auto & entry : jaws)
  {
    const auto placement = description.initialPlacements.find(entry.first);
    if (placement != description.initialPlacements.end())
    {
      method->SetInitialTransform(
        entry.first, ToRigidTransform(placement->second.meshToCephalostat, RotationTolerance), placement->second.scale);
      continue;
    }
    if (description.initialPose)
    {
      method->SetInitialTransform(entry.first, ToRigidTransform(*description.initialPose, RotationTolerance));
      continue;
    }
    const auto similarity = description.initialSimilarity.find(entry.first);
    if (similarity != description.initialSimilarity.end() && FrameOf(axis, entry.first)->Get() != nullptr)
    {
      // It acts on the projection of the jaw's own frame: the place that it amounts to, its scale apart.
      method->SetInitialTransform(entry.first,
                                  PlaceInCephalostat(FrameOf(axis, entry.first), similarity->second, data.geometry),
                                  similarity->second.scale);
    }
  }
}

bool
HasCounterpart(const LandmarkCounterpartSet * counterparts, JawEnum jaw)
{
  const auto & all = counterparts->GetCounterparts();
  return std::any_of(all.begin(), all.end(), [jaw](const auto & counterpart) { return counterpart.jaw == jaw; });
}

/** Whether a jaw has something to register with: a tracing, or a landmark that was found on its scan. */
bool
HasEvidence(const DentalCaseData & data, const LandmarkCounterpartSet * counterparts, JawEnum jaw)
{
  return CountTracingPoints(data.GetJaw(jaw).contour) >= MinimumTracingPoints ||
         (counterparts != nullptr && HasCounterpart(counterparts, jaw));
}

/** Now that it is known which landmarks are on the scans: a jaw without evidence is placed by the other one, whose
 * frame it shares, or has failed and is taken out. */
void
SettleEvidence(const DentalCaseData &          data,
               const LandmarkCounterpartSet *  counterparts,
               const CaseViews &               views,
               AxisType *                      axis,
               const PoseRegistrationOptions & options,
               std::map<JawEnum, JawResult> &  jaws,
               CaseResult &                    result)
{
  const bool share = options.useJointPose && axis->GetJointTransformOutput()->Get() != nullptr;
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    if (jaws.count(jaw) == 0 || HasEvidence(data, counterparts, jaw))
    {
      continue;
    }
    const bool    isOnAView = views.HasEvidence(jaw);
    const JawEnum other = OtherJaw(jaw);
    if (!share || jaws.count(other) == 0 || !HasEvidence(data, counterparts, other))
    {
      result.jaws[jaw].AddFinding(
        RegistrationStatusEnum::Failed,
        "no-evidence",
        isOnAView ? "it was drawn on a further view alone, and no other jaw that shares its frame is on the lateral "
                    "radiograph, where a start is searched"
                  : "there is no tracing of this jaw, and none of its landmarks was found on the scan: see "
                    "the warnings");
      jaws.erase(jaw);
    }
  }
}

} // namespace

unsigned int
CountTracingPoints(const DentalContour * contour)
{
  unsigned int points = 0;
  for (DentalContour::PointIdentifier id = 0; contour != nullptr && id < contour->GetNumberOfPoints(); ++id)
  {
    points += contour->GetPointWeight(id) > 0.0 ? 1 : 0;
  }
  return points;
}

void
RegisterCaseByPose(const DentalCaseData & data, AxisType * axis, const CasePoseSettings & settings, CaseResult & result)
{
  std::map<JawEnum, JawResult> jaws;
  for (const auto & entry : result.jaws)
  {
    if (entry.second.status != RegistrationStatusEnum::Failed)
    {
      jaws.insert(entry);
    }
  }
  if (jaws.empty())
  {
    return;
  }
  auto method = MethodType::New();
  method->SetGeometry(data.geometry);
  method->SetPrincipalPointKnown(data.HasPrincipalPoint());
  method->SetNumberOfWorkUnits(settings.numberOfThreads);
  method->SetUpperFrame(axis->GetUpperTransformOutput());
  method->SetLowerFrame(axis->GetLowerTransformOutput());
  method->SetJointFrame(axis->GetJointTransformOutput());
  LandmarkCounterpartSet::Pointer counterparts;
  if (data.cephalometricLandmarks.IsNotNull())
  {
    counterparts = FindCaseCounterparts(data,
                                        data.cephalometricLandmarks,
                                        CephalometricGeometry::DirectionEnum::Lateral,
                                        data.description.tracedSide == TracedSideEnum::Standard,
                                        axis,
                                        "",
                                        result);
    method->SetCephalometricLandmarks(data.cephalometricLandmarks);
    method->SetLandmarkCounterparts(counterparts);
  }
  const CaseViews views(data, axis, result);
  for (const auto & view : views.GetViews())
  {
    method->AddView(view);
  }
  SettleEvidence(data, counterparts, views, axis, settings.options, jaws, result);
  if (jaws.empty())
  {
    return;
  }
  if (const auto crowns = FindCaseToothCrowns(data, axis, result.unusableLandmarks); crowns.IsNotNull())
  {
    method->SetToothCrowns(crowns);
  }
  method->SetStockOutlines(data.stockOutlines);
  for (const auto & entry : jaws)
  {
    const auto &      input = data.GetJaw(entry.first);
    MeshType::Pointer mesh = input.mesh;
    DentalContour *   tracing = input.contour.GetPointer();
    const bool        hasLandmarks = counterparts.IsNotNull() && HasCounterpart(counterparts, entry.first);
    // Beside landmarks a few points are too few to be a tracing; a jaw that the other one places has none at all.
    if (CountTracingPoints(tracing) < (hasLandmarks ? MinimumTracingPoints : 1))
    {
      tracing = nullptr;
    }
    if (data.description.crowns != CrownsEnum::Off)
    {
      mesh = SelectCaseCrowns(data, entry.first, FrameOf(axis, entry.first)->Get());
    }
    if (entry.first == JawEnum::Upper)
    {
      method->SetUpperMesh(mesh);
      method->SetUpperContour(tracing);
    }
    else
    {
      method->SetLowerMesh(mesh);
      method->SetLowerContour(tracing);
    }
  }
  PoseRegistrationOptions options = settings.options;
  options.tracedSide = data.description.tracedSide;
  options.fixScale = data.description.fixScale;
  options.fixRotation = data.description.fixRotation;
  options.fixTranslation = data.description.fixTranslation;
  method->SetOptions(options);
  if (!settings.kappaSigmaIsGiven)
  {
    method->SetSpacingSource(SpacingSourceOf(data));
  }
  SetInitialTransforms(data, jaws, axis, method, result);
  if (settings.configure)
  {
    settings.configure(*method);
  }

  auto verdict = RegistrationVerdictFilter::New();
  verdict->SetSolution(method->GetOutput());
  verdict->SetImageSize({ { data.imageSize[0], data.imageSize[1] } });
  TimeProbe probe;
  probe.Start();
  const CaseStepObserver steps(method);
  settings.run(method);
  probe.Stop();
  verdict->Update();
  const PoseSolution * solution = method->GetOutput();
  const PoseGeometry & geometry = solution->GetResult().geometry;

  CephalometricGeometry::PixelSpacingType spacing;
  CephalometricGeometry::PixelIndexType   principal;
  for (unsigned int d = 0; d < 2; ++d)
  {
    spacing[d] = geometry.pixelSpacing[d];
    principal[d] = geometry.principalPoint[d];
  }
  result.geometry->SetPixelSpacing(spacing);
  result.geometry->SetPrincipalPoint(principal);

  const auto isClosed = [](const DentalJawFrame & frame) {
    return frame.valid && frame.openness <= DentalJawFrame::OpennessOfClosedCast;
  };
  const bool closedTold = isClosed(axis->GetFrame().upper) || isClosed(axis->GetFrame().lower);
  for (const std::string & sentence : verdict->GetNotCheckable())
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
  const auto silhouettes =
    MakeWholeSilhouettes(data, *solution, settings.numberOfContourPoints, settings.numberOfThreads);
  silhouetteProbe.Stop();

  const double unit = data.description.millimetresPerUnit;
  KeepCourse(steps.GetRecorder(), solution, unit, result);
  for (const auto & entry : jaws)
  {
    JawResult &           jaw = result.jaws[entry.first];
    const PoseJawResult & poseJaw = solution->GetJaw(entry.first);
    jaw.seconds.emplace_back("registration", probe.GetTotal());
    if (!poseJaw.registered)
    {
      jaw.AddFinding(RegistrationStatusEnum::Failed, "not-registered", poseJaw.failure);
      continue;
    }
    DescribePlacedJaw(*solution, entry.first, unit, counterparts, jaw);
    if (poseJaw.placedByOther)
    {
      jaw.placedBy = ToString(OtherJaw(entry.first));
    }
    for (const std::string & unused : poseJaw.unusedOutlines)
    {
      result.warnings.push_back(unused);
    }
    for (const PoseOutlineFit & outline : poseJaw.outlines)
    {
      if (!outline.templateOf.empty())
      {
        std::ostringstream text;
        text.imbue(std::locale::classic());
        text << "outline " << outline.name << ": it is that of " << outline.templateOf << ", moved, turned and scaled ("
             << std::fixed << std::setprecision(2) << outline.templateDistance
             << " mm apart, closer than hands draw): of a template tip and axis count, its shape is not the tooth's";
        result.warnings.push_back(text.str());
      }
    }
    const auto numberBefore = static_cast<std::ptrdiff_t>(jaw.findings.size());
    // Jaws in one frame have one pose: the scan of either spoils both.
    const bool isOfNoUse =
      HasScanOfNoUse(jaw) ||
      (result.jawsShareFrame && std::any_of(result.jaws.begin(), result.jaws.end(), [](const auto & each) {
         return HasScanOfNoUse(each.second);
       }));
    for (const RegistrationFinding & finding : verdict->GetVerdict(entry.first).findings)
    {
      // With such a scan some reading of the drawing always fits better than another one.
      if (isOfNoUse && IsOtherReading(finding.code))
      {
        continue;
      }
      // What the checks of the scan have said already, they said with what is in the file.
      const bool isSaid = std::any_of(jaw.findings.begin(),
                                      jaw.findings.begin() + numberBefore,
                                      [&](const RegistrationFinding & said) { return said.code == finding.code; });
      if (isSaid)
      {
        jaw.RaiseFinding(finding.code, finding.severity);
      }
      else
      {
        jaw.AddFinding(finding);
      }
    }
    for (const RegistrationFinding & finding : verdict->GetVerdict(entry.first).takenBack)
    {
      result.warnings.push_back(std::string(ToString(entry.first)) + ": " + finding.text +
                                "; the other jaw's tracing bears the pose out: look at where it differs");
    }
    // An unsure axis is a reason to look at how the drawing fits. Where it fits without doubt, it is none.
    if (jaw.findings.size() == 1 && jaw.HasFinding("unsure-axis") &&
        RegistrationVerdict::IsAxisBorneOut(solution->GetGroup(entry.first),
                                            poseJaw,
                                            verdict->GetVerdict(entry.first),
                                            solution->GetOptions(),
                                            verdict->GetThresholds()))
    {
      result.warnings.push_back(std::string(ToString(entry.first)) + ": " + jaw.findings.front().text +
                                (poseJaw.fit.numberOfPoints > 0 ? "; the tracing bears it out"
                                                                : "; what was drawn fits, and tells the middles of "
                                                                  "both sides, which depend little on the axis"));
      jaw.RemoveFinding("unsure-axis");
    }
    jaw.meshToUMDA = ToRows(*FrameOf(axis, entry.first)->Get());

    auto similarity = ProjectionSimilarityFilter::New();
    similarity->SetSolution(solution);
    similarity->SetMesh(data.GetJaw(entry.first).mesh);
    similarity->SetFrame(FrameOf(axis, entry.first));
    similarity->SetJaw(entry.first);
    similarity->Update();
    const auto & parameters = similarity->GetTransform()->GetParameters();
    jaw.similarity = { parameters[0], parameters[1], { { parameters[2], parameters[3] } } };

    const PoseGroupResult & group = solution->GetGroup(entry.first);
    jaw.priors =
      DescribePriors(group, PosePriors(solution->GetOptions(), data.HasPixelSpacing()).GetFitSigmas(group.bisected));
    const double kappa = group.parameters[PoseKappa];
    jaw.details = { { "pitch_rad", group.parameters[PosePitch] },
                    { "roll_rad", group.parameters[PoseRoll] },
                    { "yaw_rad", group.parameters[PoseYaw] },
                    { "scale_factor", std::exp(kappa) },
                    { "scale_prior_sd",
                      data.HasPixelSpacing() ? solution->GetOptions().kappaSigma : options.kappaSigmaWithoutSpacing } };
    const bool traced = poseJaw.fit.numberOfPoints > 0;
    if (traced)
    {
      jaw.details.insert(jaw.details.end(),
                         { { "noise_correlated_px", group.smoothSigma },
                           { "noise_white_px", group.whiteSigma },
                           { "fit_cost", poseJaw.fit.cost },
                           { "fit_median_px", poseJaw.fit.medianResidual },
                           { "fit_p90_px", poseJaw.fit.p90Residual },
                           { "fit_inlier_share", poseJaw.fit.inlierShare },
                           { "overlap", poseJaw.fit.overlap } });
    }
    else
    {
      jaw.details.insert(
        jaw.details.end(),
        { { "middle_sigma_px", poseJaw.middleSigma }, { "largest_middle_sigma_px", poseJaw.largestMiddleSigma } });
    }
    jaw.details.insert(
      jaw.details.end(),
      { { "prior_tension_sd", *std::max_element(group.priorTension.begin(), group.priorTension.end()) },
        { "ambiguity_margin", group.margin },
        { "similarity_rms_px", similarity->GetRMS() } });
    for (const auto & alternative : solution->GetAlternatives(entry.first, unit))
    {
      jaw.candidates.push_back({ ToRows(alternative.projection), alternative.score, alternative.distance });
    }

    TimeProbe contourProbe;
    contourProbe.Start();
    DentalContour * tracing = data.GetJaw(entry.first).contour;
    if (!traced)
    {
      // No outline was matched as a whole: where a stage began is shown by the silhouette.
      DentalContour * const silhouette = silhouettes[ToIndex(entry.first)];
      jaw.outline = CollectRimPoints(*silhouette);
      DescribeWithoutDistances(*solution, entry.first, silhouette, jaw);
      jaw.seconds.emplace_back("contour", silhouetteProbe.GetTotal());
      continue;
    }
    Measure(tracing, silhouettes[ToIndex(entry.first)], "whole", jaw);
    MeasureMatched(tracing, *solution, entry.first, jaw);
    MeasureTeeth(tracing, jaw.contours.back().second, jaw);
    contourProbe.Stop();
    jaw.seconds.emplace_back("contour", contourProbe.GetTotal() + silhouetteProbe.GetTotal());
  }
  ProjectLandmarks(data, solution, axis, result);
  views.Describe(*solution, *verdict, settings, result);
  for (const auto & entry : jaws)
  {
    JawResult & jaw = result.jaws[entry.first];
    if (solution->IsRegistered(entry.first) && !jaw.expectedError)
    {
      // Without landmarks it is what was drawn that is expected to be so far off.
      const bool traced = solution->GetJaw(entry.first).fit.numberOfPoints > 0;
      jaw.expectedError = LandmarkProjectionFilter::ToMeanDistance(traced ? solution->GetTracingSigma(entry.first)
                                                                          : solution->GetMiddleSigma(entry.first));
    }
    LeaveOutBoundlessError(data.imageSize, jaw);
  }
  for (auto & entry : result.jaws)
  {
    if (!entry.second.placedBy.empty())
    {
      // No better than the jaw that placed it, of whose scan the checks may have said something.
      const auto other = result.jaws.find(OtherJaw(entry.first));
      entry.second.RaiseFinding("placed-by-other", other->second.status);
    }
  }
}
} // namespace itk

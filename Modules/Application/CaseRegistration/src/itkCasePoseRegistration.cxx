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

#include "itkCaseCrowns.h"
#include "itkCaseSimilarityRegistration.h"
#include "itkContourDistanceFilter.h"
#include "itkLandmarkProjectionFilter.h"
#include "itkMatchedContourFilter.h"
#include "itkLandmarkCounterpartFilter.h"
#include "itkMeshSilhouetteContourSource.h"
#include "itkParallelFor.h"
#include "itkPixelSpacingVerdict.h"
#include "itkPoseFrameOperations.h"
#include "itkPoseModel.h"
#include "itkPosePriors.h"
#include "itkPoseRegistrationMethod.h"
#include "itkProjectionSimilarityFilter.h"
#include "itkRegistrationCourseRecorder.h"
#include "itkRegistrationVerdictFilter.h"
#include "itkToothCrownFilter.h"

#include "itkCommand.h"
#include "itkTimeProbe.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <typeinfo>

namespace itk
{
namespace
{
using JawEnum = ToothCode::JawEnum;
using MeshType = DentalCaseData::MeshType;
using AxisType = UMidlineDentalAxisFilter<MeshType>;
using MethodType = PoseRegistrationMethod<MeshType>;

/** mm on the detector within which the moving contour counts as matched, and what is a gap of it. */
constexpr double MatchedWithin = 2.5;
constexpr double MatchedGap = 3.0;

unsigned int
ToIndex(JawEnum jaw)
{
  return jaw == JawEnum::Upper ? 0 : 1;
}

AxisType::DecoratedTransformType *
FrameOf(AxisType * axis, JawEnum jaw)
{
  return jaw == JawEnum::Upper ? axis->GetUpperTransformOutput() : axis->GetLowerTransformOutput();
}

/** What a file's estimated or corrected magnification hides is not the detector's pixel: it may be off by what the
 * maker assumed. */
ScalePrior::SpacingSource
SpacingSourceOf(const DentalCaseData & data)
{
  std::ostringstream detector;
  detector << PixelSpacingVerdictEnum::Detector;
  // A ruler that somebody traced is as sure of its plane as a calibration in DICOM.
  std::ostringstream calibrated;
  calibrated << PixelSpacingVerdictEnum::Calibrated;
  return (data.sources.pixelSpacing == ValueSourceEnum::DICOM && data.spacingVerdict != detector.str()) ||
             data.spacingVerdict == calibrated.str()
           ? ScalePrior::SpacingSource::Dicom
           : ScalePrior::SpacingSource::Given;
}

MethodType::RigidTransformType::Pointer
MakeTransform(const std::array<double, 12> & rows)
{
  MethodType::RigidTransformType::MatrixType rotation;
  MethodType::RigidTransformType::OffsetType offset;
  for (unsigned int row = 0; row < 3; ++row)
  {
    offset[row] = rows[4 * row + 3];
    for (unsigned int column = 0; column < 3; ++column)
    {
      rotation(row, column) = rows[4 * row + column];
    }
  }
  auto transform = MethodType::RigidTransformType::New();
  // A case file's pose is checked to 1e-4 when it is read.
  transform->SetMatrix(rotation, 1e-3);
  transform->SetOffset(offset);
  return transform;
}

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
  if (!data.HasPrincipalPoint() || !data.HasPixelSpacing())
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
        entry.first, MakeTransform(placement->second.meshToCephalostat), placement->second.scale);
      continue;
    }
    if (description.initialPose)
    {
      method->SetInitialTransform(entry.first, MakeTransform(*description.initialPose));
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

std::array<double, 12>
ToRows(const PoseSolution::ProjectionMatrixType & projection)
{
  std::array<double, 12> rows;
  for (unsigned int i = 0; i < 12; ++i)
  {
    rows[i] = projection(i / 4, i % 4);
  }
  return rows;
}

/** Mesh to dental frame. */
std::array<double, 12>
ToRows(const PoseFrame & frame)
{
  std::array<double, 12> rows{};
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 3; ++column)
    {
      rows[4 * row + column] = frame.rotation[3 * row + column];
      rows[4 * row + 3] -= frame.rotation[3 * row + column] * frame.origin[column];
    }
  }
  return rows;
}

/** The paper's figures between a jaw's tracing and a contour. */
void
Measure(DentalContour * tracing, DentalContour * contour, const char * name, JawResult & result)
{
  auto distances = ContourDistanceFilter::New();
  distances->SetFixedContour(tracing);
  distances->SetMovingContour(contour);
  distances->Update();
  result.metrics.emplace_back(name, ToContourFigures(distances));
  result.contours.emplace_back(name, contour);
}

/** The same data with no pipeline behind it. What two threads pull at once must have no source in common: an update
 * that meets another one's takes the meeting for a loop in the pipeline, marks the source as modified, and so runs it
 * again under the other's hands. */
template <typename TData>
typename TData::Pointer
MakeDetached(const TData * data)
{
  auto detached = TData::New();
  detached->Graft(data);
  return detached;
}

/** The exact silhouette of the whole scan at the solution, its points a given number. */
DentalContour::Pointer
MakeWholeSilhouette(const MeshType * mesh, CephalometricGeometry * placed, unsigned int numberOfPoints)
{
  auto silhouette = MeshSilhouetteContourSource<MeshType>::New();
  silhouette->SetInput(mesh);
  silhouette->SetGeometry(placed);
  silhouette->LargestPartOnlyOn();
  silhouette->SetNumberOfPoints(numberOfPoints);
  silhouette->Update();
  DentalContour::Pointer contour = silhouette->GetOutput();
  contour->DisconnectPipeline();
  return contour;
}

void
ProjectLandmarks(const DentalCaseData & data, const PoseSolution * solution, CaseResult & result)
{
  if (data.landmarks3D.IsNull())
  {
    return;
  }
  auto projection = LandmarkProjectionFilter::New();
  projection->SetSolution(solution);
  projection->SetLandmarks(data.landmarks3D);
  projection->SetMillimetresPerUnit(data.description.millimetresPerUnit);
  projection->Update();
  const auto toRows = [](const LandmarkProjectionFilter::CovarianceType & covariance) {
    return std::array<double, 4>{ { covariance(0, 0), covariance(0, 1), covariance(1, 0), covariance(1, 1) } };
  };
  const bool bisected = IsBisected(data.description.tracedSide);
  for (auto & entry : result.jaws)
  {
    JawResult & jaw = entry.second;
    if (!solution->IsRegistered(entry.first))
    {
      continue;
    }
    for (const auto & place : projection->GetOutput()->GetLandmarks())
    {
      if (place.tooth.GetJaw() != entry.first)
      {
        continue;
      }
      LandmarkPrediction landmark;
      landmark.name = place.name;
      landmark.position = { { place.point[0], place.point[1] } };
      landmark.covariance = toRows(projection->GetCovariance(place.name));
      if (bisected && projection->HasMiddleCovariance(place.name))
      {
        landmark.middleCovariance = toRows(projection->GetMiddleCovariance(place.name));
      }
      jaw.landmarks.push_back(landmark);
    }
  }
  for (const auto & middle : projection->GetMiddles())
  {
    if (bisected)
    {
      result.jaws[middle.jaw].middles.push_back({ middle.name,
                                                  { { middle.point[0], middle.point[1] } },
                                                  LandmarkProjectionFilter::ToSigma(middle.covariance) });
    }
  }
}

/** The mean distance of a two-dimensional normal error of this standard deviation an axis. */
double
ToMeanDistance(double sigma)
{
  return std::sqrt(0.5 * 3.14159265358979323846) * sigma;
}

/** How far off the jaw's landmarks are expected to be; without any, what is drawn of it. */
void
PredictError(double ownSigma, JawResult & jaw)
{
  double      sum = 0.0;
  std::size_t count = 0;
  const auto  add = [&](double sigma) {
    sum += sigma;
    ++count;
  };
  for (const MiddlePrediction & middle : jaw.middles)
  {
    add(middle.sigma);
  }
  if (count == 0)
  {
    for (const LandmarkPrediction & landmark : jaw.landmarks)
    {
      add(landmark.GetSigma());
    }
  }
  jaw.expectedError = ToMeanDistance(count > 0 ? sum / static_cast<double>(count) : ownSigma);
}

std::string
ToName(JawEnum jaw)
{
  return jaw == JawEnum::Upper ? "upper" : "lower";
}

bool
HasCounterpart(const LandmarkCounterpartSet * counterparts, JawEnum jaw)
{
  const auto & all = counterparts->GetCounterparts();
  return std::any_of(all.begin(), all.end(), [jaw](const auto & counterpart) { return counterpart.jaw == jaw; });
}

/** Where the landmarks are on the scans; what is not used, and why, is a warning. */
LandmarkCounterpartSet::Pointer
FindCounterparts(const DentalCaseData & data, AxisType * axis, CaseResult & result)
{
  auto filter = LandmarkCounterpartFilter::New();
  filter->SetCephalometricLandmarks(data.cephalometricLandmarks);
  if (data.landmarks3D.IsNotNull())
  {
    filter->SetScanLandmarks(data.landmarks3D);
    filter->SetMillimetresPerUnit(data.description.millimetresPerUnit);
  }
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    if (data.GetJaw(jaw).mesh.IsNull())
    {
      continue;
    }
    filter->SetLabels(jaw, data.GetJaw(jaw).labels);
    if (jaw == JawEnum::Upper)
    {
      filter->SetUpperMesh(data.upper.mesh);
      filter->SetUpperFrame(FrameOf(axis, jaw));
    }
    else
    {
      filter->SetLowerMesh(data.lower.mesh);
      filter->SetLowerFrame(FrameOf(axis, jaw));
    }
  }
  filter->SetExcludedTeeth(data.description.excludedTeeth);
  filter->SetIgnoreSides(data.description.tracedSide == TracedSideEnum::Standard);
  filter->Update();
  for (const auto & unused : filter->GetUnused())
  {
    result.warnings.push_back("landmark " + unused.name + " is not used: " + unused.reason);
  }
  LandmarkCounterpartSet::Pointer counterparts = filter->GetOutput();
  counterparts->DisconnectPipeline();
  return counterparts;
}

/** The names of the stages that have steps; hypotheses have their own criterion and are not among them. */
const std::map<unsigned int, std::string> StageNames{
  { static_cast<unsigned int>(PoseStageEnum::Start), "start" },
  { static_cast<unsigned int>(PoseStageEnum::Candidates), "candidates" },
  { static_cast<unsigned int>(PoseStageEnum::Refinement), "refinement" }
};

/** How far the outlines of the jaws of a group are apart under two poses: root mean square, pixels of 0.25 mm, as steps
 * are measured. */
double
MeasureMotion(const PoseRegistrationResult & found,
              const PoseGroupResult &        group,
              const std::vector<double> &    from,
              const std::vector<double> &    to)
{
  double         sum = 0.0;
  std::size_t    count = 0;
  PoseParameters poses[2];
  std::copy(from.begin(), from.end(), poses[0].begin());
  std::copy(to.begin(), to.end(), poses[1].begin());
  const PoseModel models[2] = { PoseModel(found.geometry, poses[0]), PoseModel(found.geometry, poses[1]) };
  for (const std::size_t j : group.jaws)
  {
    for (const auto & point : found.jaws[j].contourPoints)
    {
      const auto p = ToDentalFrame(found.jaws[j].frame, point);
      double     w[2][2];
      if (models[0].Project(p.data(), w[0]) && models[1].Project(p.data(), w[1]))
      {
        const double du = w[1][0] - w[0][0];
        const double dv = w[1][1] - w[0][1];
        sum += du * du + dv * dv;
        ++count;
      }
    }
  }
  return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0.0;
}

/** Listens to the steps of a method as long as it lives. */
class StepObserver
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(StepObserver);
  explicit StepObserver(MethodType * method)
    : m_Method(method)
  {
    auto command = FunctionCommand::New();
    command->SetCallback([this](const EventObject & event) {
      const PoseRegistrationIteration & iteration = m_Method->GetCurrentIteration();
      if (typeid(event) != typeid(IterationEvent) || iteration.hypothesis)
      {
        return;
      }
      const LeastSquaresIteration & step = iteration.step;
      m_Recorder.Add(iteration.group,
                     static_cast<unsigned int>(iteration.stage),
                     iteration.candidate,
                     { step.value, step.accepted, step.stepLength, iteration.kernelWidth },
                     { iteration.pose.begin(), iteration.pose.end() });
    });
    m_Tag = method->AddObserver(IterationEvent(), command);
  }
  ~StepObserver() { m_Method->RemoveObserver(m_Tag); }

  const RegistrationCourseRecorder &
  GetRecorder() const
  {
    return m_Recorder;
  }

private:
  MethodType *               m_Method;
  unsigned long              m_Tag{ 0 };
  RegistrationCourseRecorder m_Recorder;
};

/** What the method did, and where each jaw was when its stages began. */
void
KeepCourse(const RegistrationCourseRecorder & recorder,
           const PoseSolution *               solution,
           double                             millimetresPerUnit,
           CaseResult &                       result)
{
  const PoseRegistrationResult & found = solution->GetResult();
  for (std::size_t g = 0; g < found.groups.size(); ++g)
  {
    const PoseGroupResult & group = found.groups[g];
    std::vector<JawEnum>    jaws;
    for (const std::size_t j : group.jaws)
    {
      jaws.push_back(found.jaws[j].jaw);
    }
    auto stages = recorder.Finish(static_cast<unsigned int>(g),
                                  jaws,
                                  StageNames,
                                  { group.parameters.begin(), group.parameters.end() },
                                  [&](const std::vector<double> & from, const std::vector<double> & to) {
                                    return MeasureMotion(found, group, from, to);
                                  });
    if (stages.empty())
    {
      continue;
    }
    stages.back().stopCondition = group.stopCondition;
    for (const RegistrationStageCourse & stage : stages)
    {
      for (const RegistrationCandidateCourse & candidate : stage.candidates)
      {
        if (!candidate.chosen)
        {
          continue;
        }
        PoseParameters pose{ {} };
        std::copy(candidate.first.begin(), candidate.first.end(), pose.begin());
        for (const std::size_t j : group.jaws)
        {
          const PoseJawResult & jaw = found.jaws[j];
          if (jaw.registered)
          {
            auto projection = PoseModel(found.geometry, pose).GetPixelProjection(jaw.frame);
            for (unsigned int i = 0; i < 12; ++i)
            {
              projection[i] *= i % 4 < 3 ? millimetresPerUnit : 1.0;
            }
            result.jaws[jaw.jaw].stages.push_back({ stage.name, projection, {} });
          }
        }
      }
    }
    result.jaws[jaws.front()].course = stages;
  }
}

std::vector<ParameterPrior>
DescribePriors(const PoseGroupResult & group, const PosePriors::SigmasType & sigmas)
{
  constexpr double                      degrees = 180.0 / 3.14159265358979323846;
  const std::pair<const char *, double> names[] = { { "pitch_deg", degrees }, { "roll_deg", degrees },
                                                    { "yaw_deg", degrees },   { "x_mm", 1.0 },
                                                    { "y_mm", 1.0 },          { "z_mm", 1.0 },
                                                    { "scale", 1.0 } };
  std::vector<ParameterPrior>           priors;
  for (unsigned int k = 0; k < 7; ++k)
  {
    // 0 is held, infinity is free: of neither there is a prior.
    if (sigmas[k] > 0.0 && std::isfinite(sigmas[k]))
    {
      priors.push_back(
        { names[k].first, names[k].second * group.parameters[k], names[k].second * sigmas[k], group.priorTension[k] });
    }
  }
  return priors;
}

/** How far each point of the tracing, and each tooth's drawing, lies from the contour that it was matched with. */
void
MeasureTeeth(DentalContour * tracing, DentalContour * contour, JawResult & jaw)
{
  auto distances = ContourDistanceFilter::New();
  distances->SetFixedContour(tracing);
  distances->SetMovingContour(contour);
  distances->SetDistance(ContourDistanceFilter::DistanceEnum::PointToSegment);
  distances->Update();
  jaw.tracingDistances = distances->GetFixedToMovingDistances();
  for (DentalContour::PointIdentifier id = 0; id < tracing->GetNumberOfPoints(); ++id)
  {
    const double distance = jaw.tracingDistances[id];
    if (!std::isfinite(distance))
    {
      continue;
    }
    const ToothCode   code = tracing->GetToothCode(id);
    const std::string name = code.IsKnown() ? code.GetName() : std::string();
    auto              tooth = std::find_if(
      jaw.residuals.begin(), jaw.residuals.end(), [&](const ToothResidual & other) { return other.code == name; });
    if (tooth == jaw.residuals.end())
    {
      tooth = jaw.residuals.insert(tooth, ToothResidual());
      tooth->code = name;
    }
    ++tooth->count;
    tooth->mean += distance;
    tooth->rms += distance * distance;
    tooth->maximum = std::max(tooth->maximum, distance);
  }
  for (ToothResidual & tooth : jaw.residuals)
  {
    tooth.mean /= static_cast<double>(tooth.count);
    tooth.rms = std::sqrt(tooth.rms / static_cast<double>(tooth.count));
  }
}

/** The points of the outline that lie within a distance (pixels) of the tracing: of the rest nobody can see whether it
 * fits. All of them where nothing was traced. */
std::vector<std::array<double, 3>>
KeepMatchedOutline(const PoseJawResult & jaw, const DentalContour * tracing, double within)
{
  if (jaw.fit.numberOfPoints == 0 || tracing == nullptr || tracing->GetNumberOfPoints() == 0)
  {
    return jaw.contourPoints;
  }
  std::vector<std::array<double, 3>> kept;
  for (std::size_t i = 0; i < jaw.contour.size(); ++i)
  {
    for (DentalContour::PointIdentifier id = 0; id < tracing->GetNumberOfPoints(); ++id)
    {
      const auto point = tracing->GetPoint(id);
      if (std::hypot(point[0] - jaw.contour[i][0], point[1] - jaw.contour[i][1]) < within)
      {
        kept.push_back(jaw.contourPoints[i]);
        break;
      }
    }
  }
  return kept;
}

/** The crowns that the outlines of a standard tracing are compared with. */
ToothCrownSet::Pointer
FindCrowns(const DentalCaseData & data, AxisType * axis)
{
  auto filter = ToothCrownFilter::New();
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    const auto & input = data.GetJaw(jaw);
    if (input.mesh.IsNull() || input.contour.IsNull())
    {
      continue;
    }
    filter->SetLabels(jaw, input.labels);
    if (jaw == JawEnum::Upper)
    {
      filter->SetUpperContour(input.contour);
      filter->SetUpperMesh(input.mesh);
      filter->SetUpperFrame(FrameOf(axis, jaw));
    }
    else
    {
      filter->SetLowerContour(input.contour);
      filter->SetLowerMesh(input.mesh);
      filter->SetLowerFrame(FrameOf(axis, jaw));
    }
  }
  if (data.landmarks3D.IsNotNull())
  {
    filter->SetScanLandmarks(data.landmarks3D);
    filter->SetMillimetresPerUnit(data.description.millimetresPerUnit);
  }
  filter->SetExcludedTeeth(data.description.excludedTeeth);
  filter->Update();
  ToothCrownSet::Pointer crowns = filter->GetOutput();
  crowns->DisconnectPipeline();
  return crowns;
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
    const JawEnum other = jaw == JawEnum::Upper ? JawEnum::Lower : JawEnum::Upper;
    if (!share || jaws.count(other) == 0 || !HasEvidence(data, counterparts, other))
    {
      result.jaws[jaw].AddFinding(
        RegistrationStatusEnum::Failed,
        "no-evidence",
        "there is no tracing of this jaw, and none of its landmarks was found on the scan: see "
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
    counterparts = FindCounterparts(data, axis, result);
    method->SetCephalometricLandmarks(data.cephalometricLandmarks);
    method->SetLandmarkCounterparts(counterparts);
  }
  SettleEvidence(data, counterparts, axis, settings.options, jaws, result);
  if (jaws.empty())
  {
    return;
  }
  const auto isTraced = [&](const auto & entry) { return CountTracingPoints(data.GetJaw(entry.first).contour) > 0; };
  if (data.description.tracedSide == TracedSideEnum::Standard && std::any_of(jaws.begin(), jaws.end(), isTraced))
  {
    method->SetToothCrowns(FindCrowns(data, axis));
  }
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
  const StepObserver steps(method);
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
  std::array<MeshType::Pointer, 2>              meshes;
  std::array<CephalometricGeometry::Pointer, 2> geometries;
  std::array<DentalContour::Pointer, 2>         silhouettes;
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    if (solution->IsRegistered(jaw))
    {
      const std::size_t i = jaw == JawEnum::Upper ? 0 : 1;
      meshes[i] = MakeDetached<MeshType>(data.GetJaw(jaw).mesh);
      geometries[i] = MakeDetached<CephalometricGeometry>(method->GetGeometryOutput(jaw));
    }
  }
  ParallelFor(2, settings.numberOfThreads, [&](std::size_t i) {
    if (meshes[i].IsNotNull())
    {
      silhouettes[i] = MakeWholeSilhouette(meshes[i], geometries[i], settings.numberOfContourPoints[i]);
    }
  });
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
    jaw.registered = true;
    if (poseJaw.placedByOther)
    {
      jaw.placedBy = ToName(entry.first == JawEnum::Upper ? JawEnum::Lower : JawEnum::Upper);
    }
    for (const PoseLandmarkFit & landmark : poseJaw.landmarks)
    {
      jaw.usedLandmarks.push_back({ landmark.name,
                                    counterparts->Find(landmark.name)->source,
                                    landmark.residual,
                                    landmark.distance,
                                    landmark.weight });
    }
    for (const PoseOutlineFit & outline : poseJaw.outlines)
    {
      jaw.usedOutlines.push_back(
        { outline.name, outline.shift, outline.distance, outline.weight, outline.matchedShare, outline.isTemplate });
    }
    for (const std::string & unused : poseJaw.unusedOutlines)
    {
      result.warnings.push_back("outline " + unused);
    }
    const JawResult before = jaw;
    for (const RegistrationFinding & finding : verdict->GetVerdict(entry.first).findings)
    {
      // What the checks of the scan have said already, they said with what is in the file.
      if (!before.HasFinding(finding.code) || finding.severity > before.status)
      {
        jaw.AddFinding(finding);
      }
    }
    jaw.projection = ToRows(solution->GetProjectionMatrix(entry.first, unit));
    jaw.meshToCephalostat = ToRows(method->GetTransform(entry.first));
    jaw.meshToUMDA = ToRows(FrameOf(axis, entry.first)->Get());

    auto similarity = ProjectionSimilarityFilter::New();
    similarity->SetSolution(solution);
    similarity->SetMesh(data.GetJaw(entry.first).mesh);
    similarity->SetFrame(FrameOf(axis, entry.first));
    similarity->SetJaw(entry.first);
    similarity->Update();
    const auto & parameters = similarity->GetTransform()->GetParameters();
    jaw.similarity = { parameters[0], parameters[1], { { parameters[2], parameters[3] } } };

    const PoseGroupResult & group = solution->GetGroup(entry.first);
    jaw.pose = { ToRows(poseJaw.frame), group.parameters, group.covariance };
    jaw.priors =
      DescribePriors(group, PosePriors(solution->GetOptions(), data.HasPixelSpacing()).GetFitSigmas(group.bisected));
    jaw.outline = KeepMatchedOutline(poseJaw, data.GetJaw(entry.first).contour, MatchedWithin / spacing[0]);
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
      // Nothing that distances could be measured from: the silhouette is there to look at.
      jaw.contours.emplace_back("whole", silhouettes[ToIndex(entry.first)]);
      jaw.seconds.emplace_back("contour", silhouetteProbe.GetTotal());
      continue;
    }
    Measure(tracing, silhouettes[ToIndex(entry.first)], "whole", jaw);
    auto         matched = MatchedContourFilter::New();
    const double pixel = 0.5 * (spacing[0] + spacing[1]);
    matched->SetFixedContour(tracing);
    matched->SetMovingContour(solution->MakeMovingContour(entry.first));
    matched->SetMaximumDistance(MatchedWithin / pixel);
    matched->SetMaximumGap(MatchedGap / pixel);
    matched->Update();
    if (matched->GetOutput()->GetNumberOfPoints() > 0)
    {
      DentalContour::Pointer contour = matched->GetOutput();
      contour->DisconnectPipeline();
      Measure(tracing, contour, "matched", jaw);
    }
    MeasureTeeth(tracing, jaw.contours.back().second, jaw);
    contourProbe.Stop();
    jaw.seconds.emplace_back("contour", contourProbe.GetTotal() + silhouetteProbe.GetTotal());
  }
  ProjectLandmarks(data, solution, result);
  for (const auto & entry : jaws)
  {
    if (solution->IsRegistered(entry.first))
    {
      const PoseJawResult & jaw = solution->GetJaw(entry.first);
      const double          ownSigma = jaw.fit.numberOfPoints > 0 ? jaw.fit.predictedSigma : jaw.middleSigma;
      // The verdict's pixels are of 0.25 mm.
      PredictError(ownSigma * 0.25 / (0.5 * (spacing[0] + spacing[1])), result.jaws[entry.first]);
    }
  }
  for (auto & entry : result.jaws)
  {
    JawResult & jaw = entry.second;
    if (!jaw.placedBy.empty())
    {
      const auto other = result.jaws.find(entry.first == JawEnum::Upper ? JawEnum::Lower : JawEnum::Upper);
      jaw.AddFinding(other->second.status,
                     "placed-by-other",
                     "nothing was drawn of this jaw: the " + jaw.placedBy +
                       " one, whose frame it shares, placed it, as the jaws bit on each other when they were scanned");
    }
  }
}
} // namespace itk

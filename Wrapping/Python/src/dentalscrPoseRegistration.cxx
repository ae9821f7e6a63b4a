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
#include "dentalscrOptimizers.h"
#include "dentalscrPoseRegistration.h"

#include "itkContourTransformFilter.h"
#include "itkExchangedJawsHypothesis.h"
#include "itkExchangedLandmarksHypothesis.h"
#include "itkGeometryPlacementFilter.h"
#include "itkLandmarkMatrixProjectionFilter.h"
#include "itkLandmarkCounterpartFilter.h"
#include "itkLandmarkProjectionFilter.h"
#include "itkMatchedContourFilter.h"
#include "itkMillimetreLandmarksHypothesis.h"
#include "itkOtherFacingHypothesis.h"
#include "itkOtherSideHypothesis.h"
#include "itkOtherSpacingHypothesis.h"
#include "itkTurnedDrawingHypothesis.h"
#include "itkPoseRegistrationMethod.h"
#include "itkPoseRegistrationOptionTable.h"
#include "itkPoseStartSearch.h"
#include "itkProjectionSimilarityFilter.h"
#include "itkRegistrationVerdictFilter.h"
#include "itkRigidTransformRows.h"
#include "itkScanCheckFilter.h"
#include "itkToothCrownFilter.h"
#include "itkTracedSideFilter.h"
#include "itkSimilarityPlacementFilter.h"
#include "itkSurfaceSplatWidthCalculator.h"
#include "itkTracingPixelSpacingFilter.h"

#include "dentalscrLandmarks.h"

#include <sstream>

namespace dentalscr
{
namespace
{
using MethodType = itk::PoseRegistrationMethod<MeshType>;
using OptionsType = itk::PoseRegistrationOptions;
using SolutionType = itk::PoseSolution;
using IterationType = itk::PoseRegistrationIteration;
using RigidType = itk::VersorRigid3DTransform<double>;
using FrameType = itk::DataObjectDecorator<RigidType>;
using itk::RegistrationVerdict;
using StatusEnum = RegistrationVerdict::StatusEnum;
using StageEnum = itk::PoseStageEnum;
using JawEnum = itk::ToothCode::JawEnum;

JawEnum
Checked(JawEnum jaw)
{
  if (jaw == JawEnum::Unknown)
  {
    throw std::invalid_argument("a jaw is Upper or Lower here");
  }
  return jaw;
}

const char *
ToText(StatusEnum status)
{
  return status == StatusEnum::Ok ? "ok" : status == StatusEnum::Suspect ? "suspect" : "failed";
}

template <unsigned int VRows, unsigned int VColumns>
py::array_t<double>
ToArray(const itk::Matrix<double, VRows, VColumns> & matrix)
{
  std::vector<double> values;
  for (unsigned int i = 0; i < VRows * VColumns; ++i)
  {
    values.push_back(matrix(i / VColumns, i % VColumns));
  }
  return MakeArray<double>(values, { VRows, VColumns });
}

/** A frame as the input of a filter: the transform is shared, so that it maps with the same bits. */
FrameType::Pointer
ToFrame(const RigidType * transform)
{
  if (transform == nullptr)
  {
    return nullptr;
  }
  auto frame = FrameType::New();
  frame->Set(transform);
  return frame;
}

/** Every field of what a solution holds, in one order, for writing and for reading. */
template <typename TField>
void
VisitFields(itk::PoseFrame & frame, TField && field)
{
  field(frame.rotation);
  field(frame.origin);
}
template <typename TField>
void
VisitFields(itk::PoseFitStatistics & fit, TField && field)
{
  field(fit.numberOfPoints);
  field(fit.cost);
  field(fit.medianResidual);
  field(fit.rmsResidual);
  field(fit.p90Residual);
  field(fit.inlierShare);
  field(fit.overlap);
  field(fit.codeOffset);
  field(fit.hasCodes);
  field(fit.predictedSigma);
  field(fit.extrapolatedSigma);
  field(fit.tracingLength);
  field(fit.contourLength);
}
template <typename TField>
void
VisitFields(itk::PoseJawResult & jaw, TField && field)
{
  bool isUpper = jaw.jaw == itk::ToothCode::JawEnum::Upper;
  field(isUpper);
  jaw.jaw = isUpper ? itk::ToothCode::JawEnum::Upper : itk::ToothCode::JawEnum::Lower;
  field(jaw.registered);
  VisitFields(jaw.frame, field);
  field(jaw.failure);
  field(jaw.rotation);
  field(jaw.translation);
  field(jaw.projection);
  VisitFields(jaw.fit, field);
  field(jaw.archWidth);
  field(jaw.winding);
  field(jaw.otherSideCodes);
  field(jaw.draftedShare);
  field(jaw.contour);
  field(jaw.contourNormals);
  field(jaw.contourPoints);
  std::size_t landmarks = jaw.landmarks.size();
  field(landmarks);
  jaw.landmarks.resize(landmarks);
  for (itk::PoseLandmarkFit & landmark : jaw.landmarks)
  {
    field(landmark.name);
    field(landmark.residual);
    field(landmark.distance);
    field(landmark.weight);
  }
  std::size_t outlines = jaw.outlines.size();
  field(outlines);
  jaw.outlines.resize(outlines);
  for (itk::PoseOutlineFit & outline : jaw.outlines)
  {
    field(outline.name);
    field(outline.shift);
    field(outline.shiftDistance);
    field(outline.distance);
    field(outline.weight);
    field(outline.matchedShare);
    field(outline.isTemplate);
    field(outline.crown);
  }
  field(jaw.unusedOutlines);
  field(jaw.tracingFailure);
  field(jaw.placedByOther);
  field(jaw.middleSigma);
  field(jaw.largestMiddleSigma);
}
template <typename TField>
void
VisitFields(itk::PoseCandidate & candidate, TField && field)
{
  field(candidate.parameters);
  field(candidate.deviance);
  field(candidate.score);
  field(candidate.cost);
  field(candidate.codeTerm);
  field(candidate.distance);
}
template <typename TField>
void
VisitFields(itk::PoseGroupResult & group, TField && field)
{
  field(group.jaws);
  field(group.parameters);
  field(group.covariance);
  field(group.smoothSigma);
  field(group.whiteSigma);
  field(group.priorTension);
  field(group.score);
  std::size_t count = group.candidates.size();
  field(count);
  group.candidates.resize(count);
  for (itk::PoseCandidate & candidate : group.candidates)
  {
    VisitFields(candidate, field);
  }
  field(group.margin);
  field(group.evaluations);
  field(group.converged);
  field(group.stopCondition);
  field(group.bisected);
  field(group.untried);
  std::map<std::string, std::array<double, 5>> outcomes;
  for (const auto & outcome : group.outcomes)
  {
    const itk::PoseHypothesisOutcome & found = outcome.second;
    outcomes[outcome.first] = {
      { found.score, found.deviance, found.pixelSpacing[0], found.pixelSpacing[1], found.headMove }
    };
  }
  field(outcomes);
  group.outcomes.clear();
  for (const auto & outcome : outcomes)
  {
    const std::array<double, 5> & kept = outcome.second;
    group.outcomes[outcome.first] = { kept[0], kept[1], { { kept[2], kept[3] } }, kept[4] };
  }
}
template <typename TField>
void
VisitFields(itk::PoseRegistrationResult & result, TField && field)
{
  std::size_t jaws = result.jaws.size();
  field(jaws);
  result.jaws.resize(jaws);
  for (itk::PoseJawResult & jaw : result.jaws)
  {
    VisitFields(jaw, field);
  }
  std::size_t groups = result.groups.size();
  field(groups);
  result.groups.resize(groups);
  for (itk::PoseGroupResult & group : result.groups)
  {
    VisitFields(group, field);
  }
  field(result.groupOfJaw);
  itk::PoseGeometry & geometry = result.geometry;
  field(geometry.sourceToMidsagittal);
  field(geometry.sourceToDetector);
  field(geometry.sourceSign);
  field(geometry.facingSign);
  field(geometry.pixelSpacing);
  field(geometry.pixelSpacingKnown);
  field(geometry.principalPoint);
  field(geometry.principalPointKnown);
}
template <typename TField>
void
VisitFields(OptionsType & options, TField && field)
{
  int side = static_cast<int>(options.tracedSide);
  field(side);
  options.tracedSide = static_cast<itk::TracedSideEnum>(side);
  field(options.fixScale);
  field(options.fixRotation);
  field(options.fixTranslation);
  field(options.useInitialPose);
  field(options.initialPose);
  std::vector<int> teeth(options.excludedTeeth.begin(), options.excludedTeeth.end());
  field(teeth);
  options.excludedTeeth.assign(teeth.begin(), teeth.end());
  for (const auto & entry : itk::PoseRegistrationOptionTable::GetEntries())
  {
    std::visit([&](auto member) { field(options.*member); }, entry.field);
  }
}

template <typename T>
py::tuple
ToState(T object)
{
  py::list values;
  VisitFields(object, [&values](auto & value) { values.append(py::cast(value)); });
  return py::tuple(values);
}

template <typename T>
T
FromState(const py::tuple & state)
{
  T           object;
  std::size_t next = 0;
  VisitFields(object, [&](auto & value) { value = state[next++].cast<std::decay_t<decltype(value)>>(); });
  return object;
}

void
WrapOptions(py::module_ & module)
{
  py::class_<OptionsType> type(
    module,
    "PoseRegistrationOptions",
    "Every ingredient of the robust method; px are units of 0.25 mm in the detector plane, angles are in rad.");
  type.def(py::init<>())
    .def_readwrite("tracedSide", &OptionsType::tracedSide, "Which side's outline was traced.")
    .def_readwrite("fixScale", &OptionsType::fixScale, "Hold the scale at its start.")
    .def_readwrite("fixRotation", &OptionsType::fixRotation, "Hold the rotation at its start.")
    .def_readwrite("fixTranslation", &OptionsType::fixTranslation, "Hold the shift at its start.")
    .def_readwrite("useInitialPose", &OptionsType::useInitialPose, "Start from initialPose instead of a search.")
    .def_readwrite("initialPose",
                   &OptionsType::initialPose,
                   "pitch, roll, yaw (rad), tx, ty, tz (mm), kappa of the dental frame; a copy.")
    .def_property(
      "excludedTeeth",
      [](const OptionsType & self) { return std::vector<int>(self.excludedTeeth.begin(), self.excludedTeeth.end()); },
      [](OptionsType & self, const std::vector<int> & teeth) { self.excludedTeeth.assign(teeth.begin(), teeth.end()); },
      "FDI numbers of teeth to leave out; a copy.");
  // Whatever else there is has its name, its type and its words from the one table that command lines use, too.
  for (const auto & entry : itk::PoseRegistrationOptionTable::GetEntries())
  {
    std::visit(
      [&](auto field) {
        using ValueType = std::decay_t<decltype(std::declval<OptionsType &>().*field)>;
        type.def_property(
          entry.name.c_str(),
          [field](const OptionsType & self) -> ValueType { return self.*field; },
          [field](OptionsType & self, const ValueType & value) { self.*field = value; },
          py::doc(entry.description.c_str()));
      },
      entry.field);
  }
  type
    .def_static(
      "GetEntries",
      []() {
        std::vector<std::pair<std::string, std::string>> entries;
        for (const auto & entry : itk::PoseRegistrationOptionTable::GetEntries())
        {
          entries.emplace_back(entry.name, entry.description);
        }
        return entries;
      },
      "(name, description) of what SetOption() and the command line's --option take.")
    .def(
      "SetOption",
      [](OptionsType & self, const std::string & assignment) {
        itk::PoseRegistrationOptionTable::Set(self, assignment);
      },
      py::arg("assignment"),
      "\"NAME=VALUE\" as on the command line; a value out of range is an error.")
    .def(
      "GetOption",
      [](const OptionsType & self, const std::string & name) {
        return itk::PoseRegistrationOptionTable::Get(self, name);
      },
      py::arg("name"),
      "The value as the command line writes it.")
    .def("GetChanges", &itk::PoseRegistrationOptionTable::GetChanges, "What differs from the defaults, as assignments.")
    .def("__copy__", [](const OptionsType & self) { return self; })
    .def(
      "__deepcopy__", [](const OptionsType & self, const py::dict &) { return self; }, py::arg("memo"))
    .def(py::pickle([](const OptionsType & self) { return ToState(self); },
                    [](const py::tuple & state) { return FromState<OptionsType>(state); }))
    .def("__repr__", [](const OptionsType & self) {
      std::string text = "<dentalscr.PoseRegistrationOptions";
      for (const std::string & change : itk::PoseRegistrationOptionTable::GetChanges(self))
      {
        text += ' ' + change;
      }
      return text + '>';
    });
}

void
WrapIteration(py::module_ & module)
{
  BindEnum<StageEnum>(module,
                      "PoseStage",
                      { { "Start", StageEnum::Start },
                        { "Candidates", StageEnum::Candidates },
                        { "Refinement", StageEnum::Refinement },
                        { "Uncertainty", StageEnum::Uncertainty } },
                      "What a pose registration is at.");
  py::class_<IterationType>(
    module,
    "PoseIteration",
    "A tried step of one candidate: what a command of PoseRegistrationMethod asks GetCurrentIteration() for.")
    .def_property_readonly(
      "level",
      [](const IterationType & self) { return 4 * self.group + static_cast<unsigned int>(self.stage); },
      "4 group + stage.")
    .def_readonly("group", &IterationType::group, "Jaws with a pose of their own are groups, one after the other.")
    .def_readonly("stage", &IterationType::stage, "The part of the registration that runs.")
    .def_readonly(
      "candidate", &IterationType::candidate, "Candidates are refined at the same time; their steps may alternate.")
    .def_readonly(
      "hypothesis", &IterationType::hypothesis, "Whether it is of another reading that is tried beside the result.")
    .def_readonly(
      "pose", &IterationType::pose, "Best so far: pitch, roll, yaw (rad), tx, ty, tz (mm), kappa of the dental frame.")
    .def_property_readonly(
      "position",
      [](const IterationType & self) {
        return MakeArray(std::vector<double>(self.step.position.begin(), self.step.position.end()));
      },
      "The free parameters as an optimizer sees them.")
    .def_property_readonly(
      "value", [](const IterationType & self) { return self.step.value; }, "Of the criterion, at the best position.")
    .def_property_readonly(
      "trialValue", [](const IterationType & self) { return self.step.trialValue; }, "Where the step led.")
    .def_property_readonly(
      "accepted", [](const IterationType & self) { return self.step.accepted; }, "Whether it lowered the value.")
    .def_property_readonly(
      "stepLength", [](const IterationType & self) { return self.step.stepLength; }, "Root mean square, px of 0.25 mm.")
    .def_property_readonly(
      "damping", [](const IterationType & self) { return self.step.damping; }, "The damping of the step.")
    .def_property_readonly(
      "iteration",
      [](const IterationType & self) { return self.step.iteration; },
      "Steps accepted so far, of this candidate in this stage.")
    .def_property_readonly(
      "evaluations",
      [](const IterationType & self) { return self.step.evaluations; },
      "Steps tried so far, of this candidate in this stage.")
    .def_readonly("kernelWidth", &IterationType::kernelWidth, "px of 0.25 mm.")
    .def_property_readonly(
      "smoothNoise",
      [](const IterationType & self) { return self.noise.smooth; },
      "Standard deviation of the tracer's drift, px of 0.25 mm.")
    .def_property_readonly(
      "whiteNoise",
      [](const IterationType & self) { return self.noise.white; },
      "Standard deviation of the points' own errors, px of 0.25 mm.")
    .def("__repr__", [](const IterationType & self) {
      std::ostringstream text;
      text << "<dentalscr.PoseIteration level " << 4 * self.group + static_cast<unsigned int>(self.stage)
           << ", candidate " << self.candidate << ", value " << self.step.value
           << (self.step.accepted ? ", accepted" : ", rejected") << ", step " << self.step.stepLength << " px>";
      return text.str();
    });
}

void
WrapSolution(py::module_ & module)
{
  using CandidateType = itk::PoseCandidate;
  py::class_<CandidateType>(module, "PoseCandidate", "One minimum of the criterion.")
    .def_readonly("parameters", &CandidateType::parameters, "pitch, roll, yaw (rad), tx, ty, tz (mm), kappa.")
    .def_readonly("deviance",
                  &CandidateType::deviance,
                  "What candidates are ranked by: minus twice the logarithm of their posterior weight.")
    .def_readonly("score", &CandidateType::score, "Cost and code term: what starts are ranked by.")
    .def_readonly("cost", &CandidateType::cost, "Robust cost at a fixed kernel width, without the code term; no unit.")
    .def_readonly("codeTerm", &CandidateType::codeTerm, "What tooth codes that do not fit add to the cost.")
    .def_readonly("distance", &CandidateType::distance, "Of its contour from the best candidate's, px of 0.25 mm.")
    .def("__repr__", [](const CandidateType & self) {
      return "<dentalscr.PoseCandidate score " + std::to_string(self.score) + ", " + std::to_string(self.distance) +
             " px from the best>";
    });

  using OutcomeType = itk::PoseHypothesisOutcome;
  py::class_<OutcomeType>(module, "PoseHypothesisOutcome", "What came of another reading of the same input.")
    .def_readonly("score", &OutcomeType::score, "Of its best candidate; 1 where there is none.")
    .def_readonly(
      "deviance",
      &OutcomeType::deviance,
      "Minus twice the log likelihood under it minus that of the result: clearly negative where it explains "
      "the evidence better. 0 where it was not asked for.")
    .def_readonly("pixelSpacing",
                  &OutcomeType::pixelSpacing,
                  "mm a pixel in the detector plane that its best candidate amounts to; 0 where there is none.")
    .def_readonly("headMove",
                  &OutcomeType::headMove,
                  "How far its best candidate moves the head for a further view, the largest of turns and shifts in "
                  "standard deviations of patients who are turned in the ear rods; 0 where nothing may be moved.")
    .def("__repr__", [](const OutcomeType & self) {
      return "<dentalscr.PoseHypothesisOutcome score " + std::to_string(self.score) + ", deviance " +
             std::to_string(self.deviance) + '>';
    });

  py::class_<SolutionType, itk::DataObject, itk::SmartPointer<SolutionType>>(
    module,
    "PoseSolution",
    R"(What a pose registration found: poses, covariance, candidates, fit, and why a jaw was not registered.

Points of a jaw are in the frame of its mesh, mm; pixels are continuous indices of the radiograph. A question about a
jaw that had no input or was not registered is an error: ask IsRegistered() first.)")
    .def(
      "HasJaw",
      [](const SolutionType & self, JawEnum jaw) { return self.GetIndex(Checked(jaw)) >= 0; },
      py::arg("jaw"),
      "Whether the jaw had a mesh and a contour.")
    .def("GetViewNames",
         &SolutionType::GetViewNames,
         "Returns the names of the views beside the first radiograph, in the order in which they were added.")
    .def("MakeViewSolution",
         &SolutionType::MakeViewSolution,
         py::arg("name"),
         "Returns the same solution as the view of that name shows it: its geometry takes points of a scan (mm) to "
         "pixels of "
         "that radiograph. Everything downstream takes it.")
    .def(
      "IsRegistered",
      [](const SolutionType & self, JawEnum jaw) { return self.IsRegistered(Checked(jaw)); },
      py::arg("jaw"),
      "Whether a jaw has a pose.")
    .def(
      "GetFailure",
      [](const SolutionType & self, JawEnum jaw) { return self.GetJaw(Checked(jaw)).failure; },
      py::arg("jaw"),
      "Why the jaw was not registered; empty where it was.")
    .def(
      "GetStatus",
      [](const SolutionType & self, JawEnum jaw) {
        const int index = self.GetIndex(Checked(jaw));
        self.GetJaw(jaw);
        return ToText(RegistrationVerdict::Evaluate(self.GetResult())[static_cast<std::size_t>(index)].status);
      },
      py::arg("jaw"),
      "\"ok\", \"suspect\" or \"failed\" by the usual thresholds; RegistrationVerdict() has the reasons.")
    .def(
      "GetJawsShareFrame",
      [](const SolutionType & self) {
        const auto & groups = self.GetResult().groupOfJaw;
        return groups.size() == 2 && groups[0] == groups[1] && groups[0] < self.GetResult().groups.size();
      },
      "Whether one pose was fitted to both jaws.")
    .def(
      "GetProjectionMatrix",
      [](const SolutionType & self, JawEnum jaw) { return ToArray(self.GetProjectionMatrix(Checked(jaw))); },
      py::arg("jaw"),
      "(3, 4): mesh frame (mm) to homogeneous pixel index.")
    .def(
      "ProjectPoint",
      [](const SolutionType & self, JawEnum jaw, const SolutionType::PointType & point) {
        return self.ProjectPoint(Checked(jaw), point);
      },
      py::arg("jaw"),
      py::arg("point"),
      "Point of a jaw's scan (mm, in the frame of its mesh) to the continuous pixel index (u, v).")
    .def(
      "ProjectPoints",
      [](const SolutionType & self, JawEnum jaw, const DoubleArray & points) {
        if (points.ndim() != 2 || points.shape(1) != 3)
        {
          throw std::invalid_argument("points have the wrong shape; (N, 3) is needed");
        }
        std::vector<SolutionType::PixelIndexType> result(static_cast<std::size_t>(points.shape(0)));
        for (std::size_t i = 0; i < result.size(); ++i)
        {
          SolutionType::PointType point;
          for (unsigned int d = 0; d < 3; ++d)
          {
            point[d] = points.at(i, d);
          }
          result[i] = self.ProjectPoint(Checked(jaw), point);
        }
        return MakeRows<2>(result);
      },
      py::arg("jaw"),
      py::arg("points"),
      "All rows of an (N, 3) array: (N, 2).")
    .def(
      "ComputeCovariance",
      [](const SolutionType & self, JawEnum jaw, const SolutionType::PointType & point) {
        return ToArray(self.ComputeCovariance(Checked(jaw), point));
      },
      py::arg("jaw"),
      py::arg("point"),
      "(2, 2) square pixels: of the projection of a point.")
    .def(
      "GetPose",
      [](const SolutionType & self, JawEnum jaw) { return self.GetGroup(Checked(jaw)).parameters; },
      py::arg("jaw"),
      "pitch, roll, yaw (rad), tx, ty, tz (mm), kappa of the dental frame.")
    .def(
      "GetPoseCovariance",
      [](const SolutionType & self, JawEnum jaw) {
        const auto & covariance = self.GetGroup(Checked(jaw)).covariance;
        return MakeArray(std::vector<double>(covariance.begin(), covariance.end()), { 7, 7 });
      },
      py::arg("jaw"),
      "(7, 7): of GetPose().")
    .def(
      "GetTransform",
      [](const SolutionType & self, JawEnum jaw) { return self.MakeRigidTransform(Checked(jaw)); },
      py::arg("jaw"),
      "Mesh frame to cephalostat frame, mm.")
    .def(
      "GetPoseTransform",
      [](const SolutionType & self, JawEnum jaw) { return self.MakePoseTransform(Checked(jaw)); },
      py::arg("jaw"),
      "Dental frame to the radiograph.")
    .def(
      "GetFrame",
      [](const SolutionType & self, JawEnum jaw) { return MakeMatrix44(itk::ToRows(self.GetJaw(Checked(jaw)).frame)); },
      py::arg("jaw"),
      "(4, 4): mesh frame to the dental frame that the pose is of.")
    .def(
      "GetGeometry",
      [](const SolutionType & self, JawEnum jaw) {
        auto geometry = itk::CephalometricGeometry::New();
        self.CopyToGeometry(Checked(jaw), geometry);
        return geometry;
      },
      py::arg("jaw"),
      "A geometry with the pose of the jaw's mesh; the scale of the fit is in its pixel spacing.")
    .def(
      "GetMovingContour",
      [](const SolutionType & self, JawEnum jaw) { return self.MakeMovingContour(Checked(jaw)); },
      py::arg("jaw"),
      "What could be matched, at the solution, pixels; open.")
    .def(
      "GetMovingContourPoints",
      [](const SolutionType & self, JawEnum jaw) { return MakeRows<3>(self.GetJaw(Checked(jaw)).contourPoints); },
      py::arg("jaw"),
      "(N, 3): the points of the mesh that GetMovingContour() shows.")
    .def(
      "GetFit",
      [](const SolutionType & self, JawEnum jaw) { return ToDict(self.GetJaw(Checked(jaw)).fit); },
      py::arg("jaw"),
      "How well the tracing is explained, px of 0.25 mm.")
    .def(
      "GetCandidates",
      [](const SolutionType & self, JawEnum jaw) { return self.GetGroup(Checked(jaw)).candidates; },
      py::arg("jaw"),
      "The minima that were refined to the end, best first.")
    .def(
      "GetScore",
      [](const SolutionType & self, JawEnum jaw) { return self.GetGroup(Checked(jaw)).score; },
      py::arg("jaw"),
      "Score of a jaw's fit, by which minima are ranked: the cost at a fixed kernel width and the "
      "code term. It has no unit, and less is better.")
    .def(
      "GetMargin",
      [](const SolutionType & self, JawEnum jaw) { return self.GetGroup(Checked(jaw)).margin; },
      py::arg("jaw"),
      "1 minus the odds of the best candidate that lies elsewhere; 1 where there is none.")
    .def(
      "GetOutcomes",
      [](const SolutionType & self, JawEnum jaw) { return self.GetGroup(Checked(jaw)).outcomes; },
      py::arg("jaw"),
      "{code: PoseHypothesisOutcome} of the hypotheses that were tried beside the result: other-side, and where the "
      "fit "
      "is poor facing and jaws-exchanged, of landmarks landmarks-exchanged and landmarks-mm.")
    .def(
      "GetUntried",
      [](const SolutionType & self, JawEnum jaw) { return self.GetGroup(Checked(jaw)).untried; },
      py::arg("jaw"),
      "{code: why} of the hypotheses that were worth trying and could not be asked.")
    .def(
      "GetNoiseLevels",
      [](const SolutionType & self, JawEnum jaw) {
        const auto & group = self.GetGroup(Checked(jaw));
        return std::make_pair(group.smoothSigma, group.whiteSigma);
      },
      py::arg("jaw"),
      "Standard deviations (drift, each point's own), px of 0.25 mm.")
    .def(
      "GetPriorTension",
      [](const SolutionType & self, JawEnum jaw) { return self.GetGroup(Checked(jaw)).priorTension; },
      py::arg("jaw"),
      "Of GetPose(), standard deviations of the priors; 0 where there is none.")
    .def(
      "HasConverged",
      [](const SolutionType & self, JawEnum jaw) { return self.GetGroup(Checked(jaw)).converged; },
      py::arg("jaw"),
      "Whether the optimizer ended by a tolerance.")
    .def(
      "GetStopConditionDescription",
      [](const SolutionType & self, JawEnum jaw) { return self.GetGroup(Checked(jaw)).stopCondition; },
      py::arg("jaw"),
      "Why the optimizer ended, in words.")
    .def(
      "GetNumberOfEvaluations",
      [](const SolutionType & self, JawEnum jaw) { return self.GetGroup(Checked(jaw)).evaluations; },
      py::arg("jaw"),
      "How many times the metric was evaluated.")
    .def(
      "GetOptions", [](const SolutionType & self) { return self.GetOptions(); }, "What was asked for; a copy.")
    .def(py::pickle(
      [](const SolutionType & self) { return py::make_tuple(ToState(self.GetResult()), ToState(self.GetOptions())); },
      [](const py::tuple & state) {
        auto solution = SolutionType::New();
        solution->SetResult(FromState<itk::PoseRegistrationResult>(state[0].cast<py::tuple>()),
                            FromState<OptionsType>(state[1].cast<py::tuple>()));
        return solution;
      }))
    .def("__str__",
         [](const SolutionType & self) {
           std::ostringstream text;
           self.Print(text);
           return text.str();
         })
    .def("__repr__", [](const SolutionType & self) {
      std::string text = "<dentalscr.PoseSolution";
      for (const auto & jaw : self.GetResult().jaws)
      {
        text += std::string(jaw.jaw == itk::ToothCode::JawEnum::Upper ? " upper " : " lower ") +
                (jaw.registered ? "registered" : "not registered");
      }
      return text + '>';
    });
}

void
WrapParts(py::module_ & module)
{
  using HypothesisType = itk::PoseHypothesis;
  py::class_<HypothesisType, itk::SmartPointer<HypothesisType>>(
    module, "PoseHypothesis", "Another reading of the same input, tried beside the result to name a likely mistake.")
    .def(
      "GetName",
      [](const HypothesisType & self) { return std::string(self.GetNameOfClass()); },
      "Name of the class in C++.")
    .def("GetCode", &HypothesisType::GetCode, "Short and stable, as the verdict's codes.");
  const auto wrapHypothesis = [&module](auto pointer, const char * name, const char * doc) {
    using T = typename decltype(pointer)::ObjectType;
    py::class_<T, HypothesisType, itk::SmartPointer<T>>(module, name, doc).def(New<T>());
  };
  wrapHypothesis(itk::OtherSideHypothesis::Pointer(),
                 "OtherSideHypothesis",
                 "The other side's outline was traced: its likelihood is compared.");
  wrapHypothesis(itk::OtherFacingHypothesis::Pointer(), "OtherFacingHypothesis", "The patient faces the other way.");
  wrapHypothesis(
    itk::ExchangedJawsHypothesis::Pointer(), "ExchangedJawsHypothesis", "Upper and lower scan were exchanged.");
  wrapHypothesis(itk::ExchangedLandmarksHypothesis::Pointer(),
                 "ExchangedLandmarksHypothesis",
                 "The landmarks' names are of the other jaw.");
  wrapHypothesis(itk::MillimetreLandmarksHypothesis::Pointer(),
                 "MillimetreLandmarksHypothesis",
                 "The landmarks are in millimetres, not in pixels.");
  wrapHypothesis(itk::OtherSpacingHypothesis::Pointer(),
                 "OtherSpacingHypothesis",
                 "The pixel spacing is another one: the scale is left to the fit.");
  using TurnedType = itk::TurnedDrawingHypothesis;
  py::class_<TurnedType, HypothesisType, itk::SmartPointer<TurnedType>>(
    module, "TurnedDrawingHypothesis", "The radiograph was turned by quarter turns before or after it was drawn on.")
    .def(New<TurnedType>())
    .def("SetQuarterTurns", &TurnedType::SetQuarterTurns, py::arg("turns"), "1, 2 or 3, clockwise.")
    .def("GetQuarterTurns",
         &TurnedType::GetQuarterTurns,
         "By how many quarter turns, clockwise as it is seen, the drawing is turned back.");

  using StartType = itk::PoseStart;
  using SearchType = itk::PoseStartSearch;
  py::class_<StartType, itk::SmartPointer<StartType>>(
    module, "PoseStart", "Finds poses where a registration may begin.");
  py::class_<SearchType, StartType, itk::SmartPointer<SearchType>>(
    module,
    "PoseStartSearch",
    "Exhaustive search over in-plane rotation, shift and scale of the tracing against one contour.")
    .def(New<SearchType>())
    .dentalscrProperty(
      SearchType, RotationRange, "half the range of rotations that are tried, rad; 0.559 by default (32 degrees).")
    .dentalscrProperty(SearchType, RotationStep, "the step between rotations, rad; 0.070 by default (4 degrees).")
    .dentalscrProperty(SearchType,
                       HorizontalRange,
                       "half the range of horizontal shifts of the contour's centre from the tracing's, pixels; 64 "
                       "by default.")
    .dentalscrProperty(SearchType,
                       VerticalRange,
                       "half the range of vertical shifts of the contour's centre from the tracing's, pixels; 40 by "
                       "default.")
    .dentalscrProperty(SearchType, ShiftStep, "the step between shifts, pixels; 8 by default.")
    .def("SetKappas",
         &SearchType::SetKappas,
         py::arg("kappas"),
         "Logarithms of the scale factors that are tried where the scale is searched.")
    .def("GetKappas",
         &SearchType::GetKappas,
         "Logarithms of the scale factors that are tried where the scale is searched.");
}

std::vector<itk::ToothCode>
ToTeeth(const std::vector<std::string> & codes)
{
  std::vector<itk::ToothCode> teeth;
  for (const std::string & code : codes)
  {
    teeth.push_back(itk::ToothCode::FromString(code, itk::ToothCode::NumberingEnum::Quadrant));
  }
  return teeth;
}

/** What FindLandmarkCounterparts() of the Python package gives, as the method takes it. */
itk::LandmarkCounterpartSet::Pointer
ToCounterparts(const py::dict & counterparts)
{
  using SetType = itk::LandmarkCounterpartSet;
  auto made = SetType::New();
  for (const auto & item : counterparts)
  {
    const auto               values = item.second.cast<py::tuple>();
    const auto               points = values[0].cast<py::array_t<double, py::array::c_style | py::array::forcecast>>();
    SetType::CounterpartType counterpart;
    counterpart.name = item.first.cast<std::string>();
    counterpart.jaw = itk::CephalometricLandmarkSet::ParseName(counterpart.name).jaw;
    if (points.ndim() != 2 || points.shape(1) != 3)
    {
      throw std::invalid_argument("the points of " + counterpart.name + " are (1 or 2, 3)");
    }
    for (py::ssize_t i = 0; i < points.shape(0); ++i)
    {
      counterpart.points.emplace_back(points.data(i, 0));
    }
    const auto rule = values[1].cast<std::string>();
    if (rule != "foremost" && rule != "middle")
    {
      throw std::invalid_argument("the rule of " + counterpart.name + " is foremost or middle, not " + rule);
    }
    counterpart.rule = rule == "foremost" ? SetType::RuleEnum::Foremost : SetType::RuleEnum::Middle;
    counterpart.sigmaAlong = values[2].cast<double>();
    counterpart.sigmaAcross = values[3].cast<double>();
    counterpart.source = values[4].cast<std::string>();
    made->Add(counterpart);
  }
  return made;
}

/** What FindToothCrowns() of the Python package gives. */
itk::ToothCrownSet::Pointer
ToCrowns(const py::dict & crowns)
{
  auto made = itk::ToothCrownSet::New();
  for (const auto & item : crowns)
  {
    const auto values = item.second.cast<py::tuple>();
    const auto points = values[0].cast<py::array_t<double, py::array::c_style | py::array::forcecast>>();
    const auto triangles = values[1].cast<py::array_t<std::uint32_t, py::array::c_style | py::array::forcecast>>();
    const auto name = item.first.cast<std::string>();
    itk::ToothCrownSet::CrownType crown;
    crown.tooth = itk::ToothCode::FromString(name, itk::ToothCode::NumberingEnum::Quadrant);
    if (points.ndim() != 2 || points.shape(1) != 3 || triangles.ndim() != 2 || triangles.shape(1) != 3)
    {
      throw std::invalid_argument("points and triangles of " + name + " are (n, 3) and (m, 3)");
    }
    auto surface = std::make_shared<itk::TriangleSurface>();
    for (py::ssize_t i = 0; i < points.shape(0); ++i)
    {
      surface->points.push_back({ points.at(i, 0), points.at(i, 1), points.at(i, 2) });
    }
    for (py::ssize_t i = 0; i < triangles.shape(0); ++i)
    {
      surface->triangles.push_back({ triangles.at(i, 0), triangles.at(i, 1), triangles.at(i, 2) });
      for (const std::uint32_t corner : surface->triangles.back())
      {
        if (corner >= surface->points.size())
        {
          throw std::invalid_argument("a triangle of " + name + " has a point that is not there");
        }
      }
    }
    crown.surface = surface;
    crown.sigmaAlong = values[2].cast<double>();
    crown.sigmaWidth = values[3].cast<double>();
    crown.source = values[4].cast<std::string>();
    made->Add(crown);
  }
  return made;
}

void
WrapPoseMethod(py::module_ & module)
{
  ProcessClass<MethodType> type(module, "PoseRegistrationMethod", "The robust registration.");
  DefineQuasiNewton(type);
  using SourceEnum = itk::ScalePrior::SpacingSource;
  type.def(New<MethodType>())
    .def("_SetUpperMesh", &MethodType::SetUpperMesh, py::arg("mesh"))
    .def("_SetLowerMesh", &MethodType::SetLowerMesh, py::arg("mesh"))
    .def("_SetUpperContour", &MethodType::SetUpperContour, py::arg("contour"))
    .def("_SetLowerContour", &MethodType::SetLowerContour, py::arg("contour"))
    .def("_SetGeometry", &MethodType::SetGeometry, py::arg("geometry"))
    .def(
      "_SetUpperFrame",
      [](MethodType & self, const RigidType * transform) { self.SetUpperFrame(ToFrame(transform)); },
      py::arg("transform"))
    .def(
      "_SetLowerFrame",
      [](MethodType & self, const RigidType * transform) { self.SetLowerFrame(ToFrame(transform)); },
      py::arg("transform"))
    .def(
      "_SetJointFrame",
      [](MethodType & self, const RigidType * transform) { self.SetJointFrame(ToFrame(transform)); },
      py::arg("transform"))
    .def(
      "_SetCephalometricLandmarks",
      [](MethodType & self, const py::object & landmarks) {
        self.SetCephalometricLandmarks(
          landmarks.is_none() ? nullptr : FromCephalometricDict(landmarks.cast<py::dict>()).GetPointer());
      },
      py::arg("landmarks"))
    .def(
      "_SetLandmarkCounterparts",
      [](MethodType & self, const py::object & counterparts) {
        self.SetLandmarkCounterparts(counterparts.is_none() ? nullptr : ToCounterparts(counterparts).GetPointer());
      },
      py::arg("counterparts"))
    .def(
      "_SetToothCrowns",
      [](MethodType & self, const py::object & crowns) {
        self.SetToothCrowns(crowns.is_none() ? nullptr : ToCrowns(crowns).GetPointer());
      },
      py::arg("crowns"))
    .def(
      "_AddView",
      [](MethodType &                       self,
         const std::string &                name,
         const itk::CephalometricGeometry * geometry,
         const itk::DentalContour *         upper,
         const itk::DentalContour *         lower,
         const py::object &                 landmarks,
         const py::object &                 counterparts,
         bool                               sameHeadPosition,
         double                             principalPointSigma) {
        auto view = itk::CephalogramView::New();
        view->SetName(name);
        view->SetGeometry(geometry);
        view->SetUpperContour(upper);
        view->SetLowerContour(lower);
        if (!landmarks.is_none())
        {
          view->SetCephalometricLandmarks(FromCephalometricDict(landmarks.cast<py::dict>()));
        }
        if (!counterparts.is_none())
        {
          view->SetLandmarkCounterparts(ToCounterparts(counterparts));
        }
        view->SetSameHeadPosition(sameHeadPosition);
        view->SetPrincipalPointSigma(principalPointSigma);
        self.AddView(view);
      },
      py::arg("name"),
      py::arg("geometry"),
      py::arg("upperContour"),
      py::arg("lowerContour"),
      py::arg("landmarks"),
      py::arg("counterparts"),
      py::arg("sameHeadPosition"),
      py::arg("principalPointSigma"))
    .def("ClearViews", &MethodType::ClearViews, "Removes all views: the lateral radiograph stands alone again.")
    .def("SetOptions", &MethodType::SetOptions, py::arg("options"), "Sets all options at once.")
    .def(
      "GetOptions", [](const MethodType & self) { return self.GetOptions(); }, "A copy.")
    .def(
      "SetTracedSide", &MethodType::SetTracedSide, py::arg("side"), "Sets the patient's side whose outline was traced.")
    .def("GetTracedSide", &MethodType::GetTracedSide, "Returns the patient's side whose outline was traced.")
    .dentalscrBoolean(MethodType, PrincipalPointKnown, "whether the geometry's principal point is known, not a guess.")
    .def(
      "_SetInitialTransform",
      [](MethodType & self, JawEnum jaw, const RigidType & transform, double scaleFactor) {
        self.SetInitialTransform(Checked(jaw), &transform, scaleFactor);
      },
      py::arg("jaw"),
      py::arg("transform"),
      py::arg("scaleFactor"))
    .def("ClearInitialTransforms", &MethodType::ClearInitialTransforms, "Back to a search.")
    .def(
      "_SetInitialGeometry",
      [](MethodType & self, const itk::CephalometricGeometry * geometry) { self.SetInitialGeometry(geometry); },
      py::arg("geometry"))
    .def(
      "SetOptimizer",
      [](MethodType & self, OptimizerBaseType * optimizer) { self.SetOptimizer(optimizer); },
      py::arg("optimizer"),
      R"(A LevenbergMarquardtOptimizerv4, of which candidates take clones, also in other threads.

Its own tolerances and numbers of iterations are set by the options; its events are sent in the thread that runs
Execute(), and StopOptimization() in a command of it ends the registration.)")
    .def(
      "GetOptimizer",
      [](MethodType & self) { return OptimizerBaseType::Pointer(self.GetModifiableOptimizer()); },
      "The optimizer.")
    .def("SetStart", &MethodType::SetStart, py::arg("start"), "Sets where the registration starts from.")
    .def(
      "SetSpacingSource",
      [](MethodType & self, SourceEnum source) { self.SetSpacingSource(source); },
      py::arg("source"),
      "Where the pixel spacing comes from: its prior of the scale takes the place of the option kappaSigma.")
    .def("ClearSpacingSource", &MethodType::ClearSpacingSource, "Back to the option.")
    .def("SetRobustKernel", &MethodType::SetRobustKernel, py::arg("kernel"), "Of the silhouettes; None: the options'.")
    .def("SetNoiseModel", &MethodType::SetNoiseModel, py::arg("model"), "Of the silhouettes; None: the options'.")
    .def("SetCovarianceNoiseModel",
         &MethodType::SetCovarianceNoiseModel,
         py::arg("model"),
         "Of the silhouettes in the covariance; None: the options'.")
    .def(
      "AddMetric",
      [](MethodType & self, MetricBaseType * metric, JawEnum jaw) { self.AddMetric(metric, jaw); },
      py::arg("metric"),
      py::arg_v("jaw", JawEnum::Unknown, "Jaw.Unknown"),
      R"(A further term of the sum that is minimized: a LeastSquaresMetric of your own, a prior, another sum.

It may read the blocks "pose" and "scale", which are those of the dental frame, or have blocks of its own. Jaws that
stand apart have a sum each: with a jaw it is a term of that jaw's alone. Its robust kernel and noise stay its own. The
registration works on clones of it.)")
    .def("ClearMetrics", &MethodType::ClearMetrics, "Takes all terms of one's own out.")
    .def(
      "GetMetrics", [](const MethodType & self) { return self.GetMetrics(); }, "What was added.")
    .def(
      "GetMetric",
      [](MethodType & self) { return itk::SmartPointer<MetricBaseType>(self.GetModifiableMetric()); },
      "The sum of the group that runs, at the position of the last IterationEvent; None before the first group.")
    .def(
      "AddHypothesis",
      [](MethodType & self, const itk::PoseHypothesis * hypothesis) { self.AddHypothesis(hypothesis); },
      py::arg("hypothesis"),
      "Adds another hypothesis of what the drawing may be, which is fitted too.")
    .def("ClearHypotheses", &MethodType::ClearHypotheses, "Takes all hypotheses out.")
    .def(
      "_TryHypothesis",
      [](MethodType & self, const itk::PoseHypothesis & hypothesis, JawEnum jaw) {
        itk::PoseHypothesisOutcome outcome;
        Run(&self, [&]() { outcome = self.TryHypothesis(&hypothesis, Checked(jaw)); });
        return outcome;
      },
      py::arg("hypothesis"),
      py::arg("jaw"))
    .def("GetCurrentLevel",
         &MethodType::GetCurrentLevel,
         "4 group + stage: 0 starts, 1 candidates, 2 refinement, 3 uncertainty.")
    .def("GetNumberOfLevels", &MethodType::GetNumberOfLevels, "How many levels a refinement has.")
    .def(
      "GetCurrentIteration",
      [](const MethodType & self) { return self.GetCurrentIteration(); },
      "The step that the last IterationEvent was about; a copy.")
    .def("GetCurrentCandidate",
         &MethodType::GetCurrentCandidate,
         "Of the stage; candidates are refined at the same time and their steps may alternate.")
    .def("GetOptimizerIteration",
         &MethodType::GetOptimizerIteration,
         "Steps that were accepted in this stage, of this candidate.")
    .def("GetMetricValue",
         &MethodType::GetMetricValue,
         "With the kernel width and the noise of GetCurrentIteration(): comparable as long as these stay.")
    .def("GetStepLength", &MethodType::GetStepLength, "Root mean square, px of 0.25 mm.")
    .def("GetStepAccepted",
         &MethodType::GetStepAccepted,
         "Whether the last step tried lowered the value, within an iteration event.")
    .def(
      "GetOptimizerPosition",
      [](const MethodType & self) {
        const auto position = self.GetOptimizerPosition();
        return py::tuple(py::cast(std::vector<double>(position.begin(), position.end())));
      },
      "pitch, roll, yaw (rad), tx, ty, tz (mm), kappa.")
    .def("GetOptimizerStopConditionDescription",
         &MethodType::GetOptimizerStopConditionDescription,
         "Why the optimizer ended, in words.")
    .def("GetJawsShareFrame", &MethodType::GetJawsShareFrame, "Whether one frame was used for both jaws.")
    .def("_GetSolution", [](const MethodType & self) {
      // A copy: the next Execute() does not change it.
      auto solution = SolutionType::New();
      solution->SetResult(self.GetOutput()->GetResult(), self.GetOutput()->GetOptions());
      return solution;
    });
}

/** What RegistrationFinding() of the Python package takes. */
py::list
FindingsToList(const std::vector<itk::RegistrationFinding> & findings)
{
  py::list list;
  for (const auto & finding : findings)
  {
    list.append(
      py::make_tuple(ToText(finding.severity), finding.code, finding.text, finding.value, finding.limit, finding.unit));
  }
  return list;
}

py::object
ToObject(const RegistrationVerdict::JawVerdict & verdict)
{
  return py::make_tuple(ToText(verdict.status), FindingsToList(verdict.findings));
}

void
WrapDownstream(py::module_ & module)
{
  using ViewThresholdsType = itk::ViewVerdict::Thresholds;
  py::class_<ViewThresholdsType>(
    module, "ViewVerdictThresholds", "When a further view is suspect; standard deviations unless said.")
    .def(py::init<>())
    .def_readwrite("landmarkApart",
                   &ViewThresholdsType::landmarkApart,
                   "Distance above which a landmark of the view is a gross error, standard deviations.")
    .def_readwrite(
      "suspectLandmarkRatio",
      &ViewThresholdsType::suspectLandmarkRatio,
      "Root mean square of the other landmarks' distances above which the view is suspect, standard deviations.")
    .def_readwrite("suspectCost",
                   &ViewThresholdsType::suspectCost,
                   "Robust cost of the view's tracing above which it is suspect, no unit.")
    .def_readwrite("suspectPriorTension",
                   &ViewThresholdsType::suspectPriorTension,
                   "Distance of move and scale from their priors above which the view is suspect, standard deviations.")
    .def_readwrite(
      "suspectDeviance",
      &ViewThresholdsType::suspectDeviance,
      "Difference of the robust criterion below which the other reading of the view (sides, source) is named.")
    .def_readwrite("suspectDevianceOfLandmark",
                   &ViewThresholdsType::suspectDevianceOfLandmark,
                   "The same for each landmark that was let go, where most of what was drawn was.")
    .def_readwrite("suspectDevianceOfOutline",
                   &ViewThresholdsType::suspectDevianceOfOutline,
                   "The same for each outline that was let go, where most of what was drawn was.")
    .def_readwrite("suspectMoveDeviance",
                   &ViewThresholdsType::suspectMoveDeviance,
                   "The same of a head that was turned between the radiographs and not said to be.")
    .def_readwrite(
      "suspectHeadMove",
      &ViewThresholdsType::suspectHeadMove,
      "And how far the head is moved then, standard deviations of patients who are turned in the ear rods.");

  using ThresholdsType = RegistrationVerdict::Thresholds;
  py::class_<ThresholdsType>(
    module, "RegistrationVerdictThresholds", "What is suspect and what has failed; px of 0.25 mm and mm.")
    .def(py::init<>())
    .def_readwrite(
      "suspectCost", &ThresholdsType::suspectCost, "Robust cost above which a jaw is suspect (poor-fit), no unit.")
    .def_readwrite(
      "failedCost", &ThresholdsType::failedCost, "Robust cost above which a jaw has failed (no-fit), no unit.")
    .def_readwrite("suspectP90",
                   &ThresholdsType::suspectP90,
                   "90 % quantile of the distances above which a jaw is suspect, pixels of 0.25 mm.")
    .def_readwrite("suspectMedian",
                   &ThresholdsType::suspectMedian,
                   "Median distance above which a jaw is suspect, pixels of 0.25 mm.")
    .def_readwrite("suspectInlierShare",
                   &ThresholdsType::suspectInlierShare,
                   "Share of the tracing within 4 px below which a jaw is suspect, 0 to 1.")
    .def_readwrite("failedInlierShare",
                   &ThresholdsType::failedInlierShare,
                   "Share of the tracing within 4 px below which a jaw has failed, 0 to 1.")
    .def_readwrite("suspectSmoothSigma",
                   &ThresholdsType::suspectSmoothSigma,
                   "Estimated drift of the tracing above which it is called rough, pixels of 0.25 mm.")
    .def_readwrite("suspectPredictedSigma",
                   &ThresholdsType::suspectPredictedSigma,
                   "Predicted standard deviation at the tracing above which a jaw is suspect, pixels of 0.25 mm.")
    .def_readwrite("suspectExtrapolatedSigma",
                   &ThresholdsType::suspectExtrapolatedSigma,
                   "Predicted standard deviation anywhere on the outline above which a jaw is suspect, pixels "
                   "of 0.25 mm.")
    .def_readwrite("failedPredictedSigma",
                   &ThresholdsType::failedPredictedSigma,
                   "Predicted standard deviation above which a jaw has failed (undetermined), pixels of 0.25 mm.")
    .def_readwrite("suspectCodeOffset",
                   &ThresholdsType::suspectCodeOffset,
                   "Offset of tooth codes along the arch above which a jaw is suspect, mm.")
    .def_readwrite("suspectMargin",
                   &ThresholdsType::suspectMargin,
                   "Margin to the best other place below which a jaw is suspect (ambiguous), in the score's "
                   "unit.")
    .def_readwrite("suspectPitch",
                   &ThresholdsType::suspectPitch,
                   "Pitch beyond which the pose stands at the edge of the search, rad, either way.")
    .def_readwrite("suspectPriorTension",
                   &ThresholdsType::suspectPriorTension,
                   "Distance of scale or move from their priors above which a jaw is suspect, standard "
                   "deviations.")
    .def_readwrite("suspectRotationTension",
                   &ThresholdsType::suspectRotationTension,
                   "Distance of roll and yaw from their prior above which a jaw is suspect, standard deviations.")
    .def_readwrite("suspectOtherSideDeviance",
                   &ThresholdsType::suspectOtherSideDeviance,
                   "Difference of minus twice the log likelihood below which the other side is named.")
    .def_readwrite("suspectWinding",
                   &ThresholdsType::suspectWinding,
                   "Share of the surface, signed, below which the faces are taken to look inward.")
    .def_readwrite("suspectDraftedShare",
                   &ThresholdsType::suspectDraftedShare,
                   "Share of a jaw's tracing above which drafts that nobody mended make it suspect, 0 to 1.")
    .def_readwrite("failedPitch", &ThresholdsType::failedPitch, "Pitch beyond which a patient stands on the head, rad.")
    .def_readwrite("suspectMiddleSigma",
                   &ThresholdsType::suspectMiddleSigma,
                   "Predicted standard deviation of the middles of both sides, over incisors and first molars, "
                   "where landmarks alone placed a jaw, pixels of 0.25 mm.")
    .def_readwrite("suspectLargestMiddleSigma",
                   &ThresholdsType::suspectLargestMiddleSigma,
                   "The same of the worse of them, pixels of 0.25 mm.")
    .def_readwrite("landmarkApart",
                   &ThresholdsType::landmarkApart,
                   "Distance of a landmark above which it is a gross error, standard deviations.")
    .def_readwrite("suspectLandmarkRatio",
                   &ThresholdsType::suspectLandmarkRatio,
                   "Root mean square of the landmarks' distances above which they are rough, standard "
                   "deviations.")
    .def_readwrite("suspectOutlineRatio",
                   &ThresholdsType::suspectOutlineRatio,
                   "Root mean square of what the pose leaves free of the outlines' shifts above which they contradict "
                   "each other, where they alone place it, standard deviations.")
    .def_readwrite("shortestFilm", &ThresholdsType::shortestFilm, "Length below which a radiograph is no head's, mm.")
    .def_readwrite("suspectFilmLength",
                   &ThresholdsType::suspectFilmLength,
                   "Length of the radiograph above which a spacing that only the fit tells is suspect, mm.")
    .def_readwrite(
      "failedFilmLength", &ThresholdsType::failedFilmLength, "Length of the radiograph above which it has failed, mm.")
    .def_readwrite(
      "minimumArchWidth", &ThresholdsType::minimumArchWidth, "Width below which an arch is no human's, mm.")
    .def_readwrite(
      "maximumArchWidth", &ThresholdsType::maximumArchWidth, "Width above which an arch is no human's, mm.")
    .def_readwrite("hypothesisGain",
                   &ThresholdsType::hypothesisGain,
                   "How much better the score of another hypothesis must be to be named.")
    .def_readwrite("spacingScore",
                   &ThresholdsType::spacingScore,
                   "Score up to which the drawing is said to fit with another pixel spacing.")
    .def_readwrite("spacingDifference",
                   &ThresholdsType::spacingDifference,
                   "Logarithm of the ratio of two spacings from which on they differ.")
    .def_readwrite("borneOutCost",
                   &ThresholdsType::borneOutCost,
                   "Cost up to which a fit bears out a dental axis that was unsure, where roll and yaw are determined.")
    .def_readwrite("borneOutMargin", &ThresholdsType::borneOutMargin, "Margin from which on it does.")
    .def_readwrite("borneOutPoorCost",
                   &ThresholdsType::borneOutPoorCost,
                   "Cost up to which a tracing may fit poorly where the other jaw's bears the pose out.")
    .def_readwrite("borneOutInlierShare",
                   &ThresholdsType::borneOutInlierShare,
                   "Share of its points within 4 pixels of 0.25 mm from which on it may, 0 to 1.")
    .def_readwrite(
      "borneOutOtherCost", &ThresholdsType::borneOutOtherCost, "Cost up to which the other jaw's tracing does.")
    .def_readwrite("borneOutSmoothSigma",
                   &ThresholdsType::borneOutSmoothSigma,
                   "Drift of both up to which it does, pixels of 0.25 mm, 1 sd.")
    .def_readwrite("view", &ThresholdsType::view, "Of each further view.");

  using VerdictType = itk::RegistrationVerdictFilter;
  ProcessClass<VerdictType>(module, "RegistrationVerdictFilter", "Judges a pose registration.")
    .def(New<VerdictType>())
    .def("_SetSolution", &VerdictType::SetSolution, py::arg("solution"))
    .def("SetThresholds",
         &VerdictType::SetThresholds,
         py::arg("thresholds"),
         "Sets the limits beyond which findings are given.")
    .def(
      "SetImageSize",
      [](VerdictType & self, const itk::Size<2> & size) { self.SetImageSize(size); },
      py::arg("size"),
      "(width, height) of the radiograph, pixels: what a spacing that only the fit tells is judged by. (0, 0): "
      "unknown.")
    .def(
      "GetImageSize",
      [](const VerdictType & self) { return self.GetImageSize(); },
      "Width and height of the radiograph, pixels; (0, 0), the default, is unknown.")
    .def(
      "GetThresholds", [](const VerdictType & self) { return self.GetThresholds(); }, "A copy.")
    .def("GetNotCheckable", &VerdictType::GetNotCheckable, "What the data could not tell, as sentences.")
    .def(
      "_GetVerdict",
      [](VerdictType & self, JawEnum jaw) -> py::object {
        if (self.GetSolution() == nullptr || self.GetSolution()->GetIndex(Checked(jaw)) < 0)
        {
          return py::none();
        }
        return ToObject(self.GetVerdict(jaw));
      },
      py::arg("jaw"))
    .def("_GetViewVerdicts", [](VerdictType & self) {
      py::dict verdicts;
      for (const auto & view : self.GetSolution()->GetResult().views)
      {
        verdicts[py::str(view.name)] = ToObject(self.GetViewVerdict(view.name));
      }
      return verdicts;
    });

  using ProjectionType = itk::LandmarkProjectionFilter;
  ProcessClass<ProjectionType>(
    module, "LandmarkProjectionFilter", "Landmarks of the scans as a registration places them, with uncertainty.")
    .def(New<ProjectionType>())
    .def("_SetSolution", &ProjectionType::SetSolution, py::arg("solution"))
    .def(
      "_SetLandmarks",
      [](ProjectionType & self, const py::dict & landmarks) { self.SetLandmarks(FromDict<3>(landmarks)); },
      py::arg("landmarks"))
    .dentalscrProperty(ProjectionType, MillimetresPerUnit, "the length of the scan landmarks' unit, mm; 1 by default.")
    .dentalscrBoolean(ProjectionType,
                      Bisected,
                      "whether what was drawn tells of the middles between the sides alone, so that the expected error "
                      "is that of the middles. Off by default.")
    .def("HasExpectedError",
         &ProjectionType::HasExpectedError,
         py::arg("jaw"),
         "Whether the output has a landmark of the jaw. Valid after Execute().")
    .def("GetExpectedError",
         &ProjectionType::GetExpectedError,
         py::arg("jaw"),
         "Distance, pixels, that a landmark of the jaw is expected to be off by: the mean over its landmarks, or over "
         "its middles where Bisected is on and there are any. Valid after Execute().")
    .def("_GetOutput", [](ProjectionType & self) { return ToDict<2>(self.GetOutput()); })
    .def(
      "GetCovariance",
      [](const ProjectionType & self, const std::string & name) { return ToArray(self.GetCovariance(name)); },
      py::arg("name"),
      "(2, 2) square pixels.")
    .def("GetSigma", &ProjectionType::GetSigma, py::arg("name"), "Standard deviation an axis, pixels.")
    .def("HasMiddleCovariance",
         &ProjectionType::HasMiddleCovariance,
         py::arg("name"),
         "Whether a landmark of the output, by its name, has a covariance of the middle of both "
         "sides. Valid after Execute().")
    .def(
      "GetMiddles",
      [](const ProjectionType & self) {
        py::dict middles;
        for (const auto & middle : self.GetMiddles())
        {
          middles[py::str(middle.name)] =
            py::make_tuple(py::make_tuple(middle.point[0], middle.point[1]), ToArray(middle.covariance));
        }
        return middles;
      },
      "{\"U6_MB\": ((u, v), (2, 2) square pixels)} between each right landmark's image and its left one's.")
    .def(
      "GetMiddleCovariance",
      [](const ProjectionType & self, const std::string & name) { return ToArray(self.GetMiddleCovariance(name)); },
      py::arg("name"),
      "(2, 2) square pixels: of the middle between a right landmark and its left one.");

  using CheckType = itk::ScanCheckFilter;
  ProcessClass<CheckType>(module, "ScanCheckFilter", "What can be said of the scans before anything is registered.")
    .def(New<CheckType>())
    .def("_SetUpperMesh", &CheckType::SetUpperMesh, py::arg("mesh"))
    .def("_SetLowerMesh", &CheckType::SetLowerMesh, py::arg("mesh"))
    .def("_SetFrames", &CheckType::SetFrames, py::arg("frames"))
    .def(
      "_SetLandmarks",
      [](CheckType & self, const py::dict & landmarks) { self.SetLandmarks(FromDict<3>(landmarks)); },
      py::arg("landmarks"))
    .dentalscrProperty(
      CheckType, MillimetresPerUnit, "the length of the unit of landmarks and mesh files, mm; 1 by default.")
    .def(
      "_GetFindings",
      [](CheckType & self, JawEnum jaw) { return FindingsToList(self.GetFindings(Checked(jaw))); },
      py::arg("jaw"))
    .def("GetNotCheckable", &CheckType::GetNotCheckable, "What the data could not tell, as sentences.");

  using CounterpartType = itk::LandmarkCounterpartFilter;
  ProcessClass<CounterpartType>(
    module, "LandmarkCounterpartFilter", "Where the landmarks of a cephalometric analysis are on the scans.")
    .def(New<CounterpartType>())
    .def(
      "_SetCephalometricLandmarks",
      [](CounterpartType & self, const py::dict & landmarks) {
        self.SetCephalometricLandmarks(FromCephalometricDict(landmarks));
      },
      py::arg("landmarks"))
    .def(
      "_SetScanLandmarks",
      [](CounterpartType & self, const py::dict & landmarks) { self.SetScanLandmarks(FromDict<3>(landmarks)); },
      py::arg("landmarks"))
    .def("_SetUpperMesh", &CounterpartType::SetUpperMesh, py::arg("mesh"))
    .def("_SetLowerMesh", &CounterpartType::SetLowerMesh, py::arg("mesh"))
    .def(
      "_SetUpperFrame",
      [](CounterpartType & self, const RigidType * transform) { self.SetUpperFrame(ToFrame(transform)); },
      py::arg("transform"))
    .def(
      "_SetLowerFrame",
      [](CounterpartType & self, const RigidType * transform) { self.SetLowerFrame(ToFrame(transform)); },
      py::arg("transform"))
    .def("SetLabels",
         &CounterpartType::SetLabels,
         py::arg("jaw"),
         py::arg("labels"),
         "FDI number by point of the jaw's mesh, 0 gingiva; empty: none.")
    .def("GetLabels",
         &CounterpartType::GetLabels,
         py::arg("jaw"),
         "FDI number by point of the mesh, 0 for gingiva; empty where there are none.")
    .def(
      "SetExcludedTeeth",
      [](CounterpartType & self, const std::vector<std::string> & teeth) { self.SetExcludedTeeth(ToTeeth(teeth)); },
      py::arg("teeth"),
      "Codes of teeth that are left out: [\"UR3\"].")
    .dentalscrProperty(CounterpartType, MillimetresPerUnit, "the length of the scan landmarks' unit, mm; 1 by default.")
    .dentalscrProperty(CounterpartType,
                       Direction,
                       "the direction of the radiograph. A frontal one shows both sides beside each other: there only "
                       "a central incisor's landmark may do without a side, and is the middle of both. Lateral by "
                       "default.")
    .dentalscrBoolean(CounterpartType,
                      IgnoreSides,
                      "whether the side in a name is ignored, so that \"UR6_MB\" is the middle of both as in a "
                      "standard tracing. Off by default.")
    .def("_GetCounterparts",
         [](CounterpartType & self) {
           py::dict result;
           for (const auto & counterpart : self.GetOutput()->GetCounterparts())
           {
             std::vector<double> points;
             for (const auto & point : counterpart.points)
             {
               points.insert(points.end(), point.Begin(), point.End());
             }
             result[py::str(counterpart.name)] = py::make_tuple(
               MakeArray<double>(points, { static_cast<py::ssize_t>(counterpart.points.size()), 3 }),
               counterpart.rule == itk::LandmarkCounterpartSet::RuleEnum::Foremost ? "foremost" : "middle",
               counterpart.sigmaAlong,
               counterpart.sigmaAcross,
               counterpart.source);
           }
           return result;
         })
    .def(
      "GetUnused",
      [](const CounterpartType & self) {
        std::vector<std::pair<std::string, std::string>> unused;
        for (const auto & entry : self.GetUnused())
        {
          unused.emplace_back(entry.name, entry.reason);
        }
        return unused;
      },
      "The landmarks that are not used, as their file calls them, and why. Valid after Execute().");

  using CrownType = itk::ToothCrownFilter;
  ProcessClass<CrownType>(
    module, "ToothCrownFilter", "Cuts the crowns of the teeth that an analysis has outlined out of the scans.")
    .def(New<CrownType>())
    .def("_SetUpperContour", &CrownType::SetUpperContour, py::arg("contour"))
    .def("_SetLowerContour", &CrownType::SetLowerContour, py::arg("contour"))
    .def("_SetUpperMesh", &CrownType::SetUpperMesh, py::arg("mesh"))
    .def("_SetLowerMesh", &CrownType::SetLowerMesh, py::arg("mesh"))
    .def(
      "_SetUpperFrame",
      [](CrownType & self, const RigidType * transform) { self.SetUpperFrame(ToFrame(transform)); },
      py::arg("transform"))
    .def(
      "_SetLowerFrame",
      [](CrownType & self, const RigidType * transform) { self.SetLowerFrame(ToFrame(transform)); },
      py::arg("transform"))
    .def(
      "_SetScanLandmarks",
      [](CrownType & self, const py::dict & landmarks) { self.SetScanLandmarks(FromDict<3>(landmarks)); },
      py::arg("landmarks"))
    .def("SetLabels",
         &CrownType::SetLabels,
         py::arg("jaw"),
         py::arg("labels"),
         "FDI number by point of the jaw's mesh, 0 gingiva; empty: none.")
    .def("GetLabels",
         &CrownType::GetLabels,
         py::arg("jaw"),
         "FDI number by point of the mesh, 0 for gingiva; empty where there are none.")
    .def(
      "SetExcludedTeeth",
      [](CrownType & self, const std::vector<std::string> & teeth) { self.SetExcludedTeeth(ToTeeth(teeth)); },
      py::arg("teeth"),
      "Codes of teeth that are left out: [\"UR3\"].")
    .dentalscrProperty(CrownType, MillimetresPerUnit, "the length of the scan landmarks' unit, mm; 1 by default.")
    .def("_GetCrowns",
         [](CrownType & self) {
           py::dict result;
           for (const auto & crown : self.GetOutput()->GetCrowns())
           {
             std::vector<double>        points;
             std::vector<std::uint32_t> triangles;
             for (const auto & point : crown.surface->points)
             {
               points.insert(points.end(), point.begin(), point.end());
             }
             for (const auto & triangle : crown.surface->triangles)
             {
               triangles.insert(triangles.end(), triangle.begin(), triangle.end());
             }
             result[py::str(crown.tooth.GetName())] = py::make_tuple(
               MakeArray<double>(points, { static_cast<py::ssize_t>(crown.surface->points.size()), 3 }),
               MakeArray<std::uint32_t>(triangles, { static_cast<py::ssize_t>(crown.surface->triangles.size()), 3 }),
               crown.sigmaAlong,
               crown.sigmaWidth,
               crown.source);
           }
           return result;
         })
    .def(
      "GetMissing",
      [](const CrownType & self) {
        std::vector<std::string> missing;
        for (const itk::ToothCode & tooth : self.GetMissing())
        {
          missing.push_back(tooth.GetName());
        }
        return missing;
      },
      "Names of teeth of the tracings whose crowns were not found.");

  using SideType = itk::TracedSideFilter;
  ProcessClass<SideType>(
    module, "TracedSideFilter", "Which side's outlines a drawing shows, and the drawing without the other side's.")
    .def(New<SideType>())
    .def("_SetUpperContour", &SideType::SetUpperContour, py::arg("contour"))
    .def("_SetLowerContour", &SideType::SetLowerContour, py::arg("contour"))
    .def(
      "_SetCephalometricLandmarks",
      [](SideType & self, const py::object & landmarks) {
        self.SetCephalometricLandmarks(
          landmarks.is_none() ? nullptr : FromCephalometricDict(landmarks.cast<py::dict>()).GetPointer());
      },
      py::arg("landmarks"))
    .def("SetTracedSide",
         &SideType::SetTracedSide,
         py::arg("side"),
         "Sets the side that is said of the drawing, or taken where nothing tells; Right by default.")
    .def("GetTracedSide",
         &SideType::GetTracedSide,
         "Returns the side that is said of the drawing, or taken where nothing tells; Right by default.")
    .dentalscrBoolean(SideType, TracedSideIsGiven, "whether somebody said the traced side. Off by default.")
    .dentalscrBoolean(SideType,
                      CodesHaveSides,
                      "whether the codes of the tracing were written with their sides. On by default; off for a file "
                      "with codes such as U1 and L6.")
    .def("GetSettledSide", &SideType::GetSettledSide, "Which side was traced. Valid after Execute().")
    .def(
      "GetReason",
      [](const SideType & self) { return std::string(itk::ToString(self.GetReason())); },
      "What that was decided by, as a clause. Valid after Execute().")
    .def(
      "GetLeftOutTeeth",
      [](const SideType & self) {
        std::vector<std::string> names;
        for (const itk::ToothCode & tooth : self.GetLeftOutTeeth())
        {
          names.push_back(tooth.GetName());
        }
        return names;
      },
      "Names of the other side's teeth that are left out, one a polyline. Valid after Execute().")
    .def("_TakeOutput", [](SideType & self, JawEnum jaw) {
      itk::DentalContour::Pointer contour = self.GetOutput(jaw);
      contour->DisconnectPipeline();
      return contour;
    });

  using MatchedType = itk::MatchedContourFilter;
  ProcessClass<MatchedType>(
    module, "MatchedContourFilter", "The part of a moving contour that has a tracing beside it.")
    .def(New<MatchedType>())
    .def("_SetFixedContour", &MatchedType::SetFixedContour, py::arg("contour"))
    .def("_SetMovingContour", &MatchedType::SetMovingContour, py::arg("contour"))
    .dentalscrProperty(
      MatchedType, MaximumDistance, "the distance up to which a point is matched, pixels; 10 by default.")
    .dentalscrProperty(MatchedType, MaximumGap, "the length of a gap that is closed, pixels; 12 by default.")
    .def("_TakeOutput", [](MatchedType & self) {
      itk::DentalContour::Pointer contour = self.GetOutput();
      contour->DisconnectPipeline();
      return contour;
    });

  using SimilarityType = itk::ProjectionSimilarityFilter;
  ProcessClass<SimilarityType>(
    module, "ProjectionSimilarityFilter", "The 2-D similarity that comes nearest to a registered pose.")
    .def(New<SimilarityType>())
    .def("_SetSolution", &SimilarityType::SetSolution, py::arg("solution"))
    .def("_SetMesh", &SimilarityType::SetMesh, py::arg("mesh"))
    .def(
      "_SetFrame",
      [](SimilarityType & self, const RigidType & transform) { self.SetFrame(ToFrame(&transform)); },
      py::arg("transform"))
    .def("SetJaw", &SimilarityType::SetJaw, py::arg("jaw"), "Sets the jaw: Upper (the default) or Lower.")
    .def("GetJaw", &SimilarityType::GetJaw, "Returns the jaw: Upper (the default) or Lower.")
    .def("GetRMS", &SimilarityType::GetRMS, "What the similarity leaves, pixels.")
    .def("_GetTransform", [](SimilarityType & self) {
      return itk::Similarity2DTransform<double>::Pointer(self.GetTransformOutput()->GetModifiable());
    });
}
/** What lies between the filters of the paper's chain, where a pose is not known. */
void
WrapSimilarityChain(py::module_ & module)
{
  using PlacementType = itk::GeometryPlacementFilter;
  ProcessClass<PlacementType>(module, "GeometryPlacementFilter", "A radiograph's geometry with an object in it.")
    .def(New<PlacementType>())
    .def("_SetGeometry", &PlacementType::SetGeometry, py::arg("geometry"))
    .def(
      "_SetFrame",
      [](PlacementType & self, const RigidType & transform) { self.SetFrame(ToFrame(&transform)); },
      py::arg("transform"))
    .dentalscrBoolean(PlacementType,
                      CentralRayThroughOrigin,
                      "whether the central ray is laid through the origin of the frame. Off by default.")
    .def("_TakeOutput", [](PlacementType & self) {
      itk::CephalometricGeometry::Pointer geometry = self.GetOutput();
      geometry->DisconnectPipeline();
      return geometry;
    });

  using WidthType = itk::SurfaceSplatWidthCalculator;
  ProcessClass<WidthType>(module, "SurfaceSplatWidthCalculator", "The width of a DRR's splats that closes a surface.")
    .def(New<WidthType>())
    .def("_SetMesh", &WidthType::SetMesh, py::arg("mesh"))
    .def("_SetGeometry", &WidthType::SetGeometry, py::arg("geometry"))
    .dentalscrProperty(WidthType,
                       WidthFactor,
                       "the standard deviation of a splat over the mean distance between vertices; 0.7 by default.")
    .def("GetSigma", &WidthType::GetSigma, "mm in the detector plane.");

  using SpacingType = itk::TracingPixelSpacingFilter;
  ProcessClass<SpacingType>(
    module, "TracingPixelSpacingFilter", "A geometry with a rough pixel spacing where none is known.")
    .def(New<SpacingType>())
    .def("_SetGeometry", &SpacingType::SetGeometry, py::arg("geometry"))
    .def(
      "_SetJaw",
      [](SpacingType &              self,
         JawEnum                    jaw,
         const MeshType *           mesh,
         const itk::DentalContour * contour,
         const RigidType *          frame) { self.SetJaw(Checked(jaw), mesh, contour, ToFrame(frame)); },
      py::arg("jaw"),
      py::arg("mesh"),
      py::arg("contour"),
      py::arg("frame"))
    .dentalscrProperty(SpacingType,
                       DefaultPixelSpacing,
                       "the pixel spacing in the detector plane where nothing can be measured, mm; 0.25 by default.")
    .def("_TakeOutput", [](SpacingType & self) {
      itk::CephalometricGeometry::Pointer geometry = self.GetOutput();
      geometry->DisconnectPipeline();
      return geometry;
    });

  using SimilarityType = itk::SimilarityPlacementFilter;
  ProcessClass<SimilarityType>(module, "SimilarityPlacementFilter", "Where a similarity puts the scan.")
    .def(New<SimilarityType>())
    .def(
      "_SetSimilarity",
      [](SimilarityType & self, const itk::Similarity2DTransform<double> & transform) {
        self.SetSimilarity(&transform);
      },
      py::arg("transform"))
    .def(
      "_SetFrame",
      [](SimilarityType & self, const RigidType & transform) { self.SetFrame(ToFrame(&transform)); },
      py::arg("transform"))
    .def("_SetGeometry", &SimilarityType::SetGeometry, py::arg("geometry"))
    .dentalscrProperty(SimilarityType,
                       MillimetresPerUnit,
                       "the length of the unit of the points that the projection matrix acts on, mm; 1 by default.")
    .def(
      "GetProjectionMatrix",
      [](SimilarityType & self) { return ToArray(self.GetProjectionMatrix()); },
      "(3, 4): mesh, in the unit of its file, to homogeneous pixel index.")
    .def("_GetTransform",
         [](SimilarityType & self) { return RigidType::Pointer(self.GetTransformOutput()->GetModifiable()); });

  using ContourType = itk::ContourTransformFilter;
  ProcessClass<ContourType>(module, "ContourTransformFilter", "A contour that a similarity has moved.")
    .def(New<ContourType>())
    .def(
      "_SetInput",
      [](ContourType & self, const itk::DentalContour * contour) { self.SetInput(contour); },
      py::arg("contour"))
    .def(
      "_SetTransform",
      [](ContourType & self, const itk::Similarity2DTransform<double> & transform) { self.SetTransform(&transform); },
      py::arg("transform"))
    .def("_TakeOutput", [](ContourType & self) {
      itk::DentalContour::Pointer contour = self.GetOutput();
      contour->DisconnectPipeline();
      return contour;
    });

  using MatrixType = itk::LandmarkMatrixProjectionFilter;
  ProcessClass<MatrixType>(module, "LandmarkMatrixProjectionFilter", "Landmarks by a projection matrix alone.")
    .def(New<MatrixType>())
    .def(
      "_SetLandmarks",
      [](MatrixType & self, const py::dict & landmarks) { self.SetLandmarks(FromDict<3>(landmarks)); },
      py::arg("landmarks"))
    .def(
      "_SetProjectionMatrix",
      [](MatrixType & self, const DoubleArray & values) {
        if (values.ndim() != 2 || values.shape(0) != 3 || values.shape(1) != 4)
        {
          throw std::invalid_argument("a projection matrix has the wrong shape; (3, 4) is needed");
        }
        MatrixType::ProjectionMatrixType matrix;
        for (unsigned int i = 0; i < 12; ++i)
        {
          matrix(i / 4, i % 4) = values.at(i / 4, i % 4);
        }
        self.SetProjectionMatrix(matrix);
      },
      py::arg("matrix"))
    .def("SetJaw",
         &MatrixType::SetJaw,
         py::arg("jaw"),
         "Sets the jaw whose landmarks are projected; Unknown, the default, is both.")
    .def("GetJaw", &MatrixType::GetJaw, "Returns the jaw whose landmarks are projected; Unknown, the default, is both.")
    .def("_GetOutput", [](MatrixType & self) { return ToDict<2>(self.GetOutput()); });
}
} // namespace

void
WrapPoseRegistration(py::module_ & module)
{
  WrapOptions(module);
  WrapIteration(module);
  WrapSolution(module);
  WrapParts(module);
  WrapPoseMethod(module);
  WrapDownstream(module);
  WrapSimilarityChain(module);
}
} // namespace dentalscr

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
#include "dentalscrPoseConversions.h"
#include "dentalscrPoseRegistration.h"

#include "itkPoseRegistrationMethod.h"
#include "itkPoseRegistrationOptionTable.h"
#include "itkRigidTransformRows.h"

#include <sstream>

namespace dentalscr
{
namespace
{
using OptionsType = itk::PoseRegistrationOptions;
using SolutionType = itk::PoseSolution;
using IterationType = itk::PoseRegistrationIteration;
using itk::RegistrationVerdict;
using StageEnum = itk::PoseStageEnum;
using JawEnum = itk::ToothCode::JawEnum;

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
    field(landmark.sigma);
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
    field(outline.templateOf);
    field(outline.templateDistance);
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
      [](const SolutionType & self, JawEnum jaw) { return MatrixToArray(self.GetProjectionMatrix(Checked(jaw))); },
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
        return MatrixToArray(self.ComputeCovariance(Checked(jaw), point));
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
} // namespace

void
WrapPoseSolution(py::module_ & module)
{
  WrapOptions(module);
  WrapIteration(module);
  WrapSolution(module);
}
} // namespace dentalscr

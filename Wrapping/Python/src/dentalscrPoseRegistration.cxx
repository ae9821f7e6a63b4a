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
#include "dentalscrLandmarks.h"
#include "dentalscrOptimizers.h"
#include "dentalscrPoseConversions.h"
#include "dentalscrPoseRegistration.h"

#include "itkExchangedJawsHypothesis.h"
#include "itkExchangedLandmarksHypothesis.h"
#include "itkMillimetreLandmarksHypothesis.h"
#include "itkOtherFacingHypothesis.h"
#include "itkOtherSideHypothesis.h"
#include "itkOtherSpacingHypothesis.h"
#include "itkPoseRegistrationMethod.h"
#include "itkPoseStartSearch.h"
#include "itkTurnedDrawingHypothesis.h"
#include "itkUpwardDrawingHypothesis.h"

#include <sstream>

namespace dentalscr
{
namespace
{
using PoseMethodType = itk::PoseRegistrationMethod<MeshType>;
using OptionsType = itk::PoseRegistrationOptions;
using SolutionType = itk::PoseSolution;
using JawEnum = itk::ToothCode::JawEnum;

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

  wrapHypothesis(itk::UpwardDrawingHypothesis::Pointer(),
                 "UpwardDrawingHypothesis",
                 "The rows of the drawing were counted from below: above and below are exchanged, the scale is free.");

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

void
WrapPoseMethod(py::module_ & module)
{
  ProcessClass<PoseMethodType> type(module, "PoseRegistrationMethod", "The robust registration.");
  DefineQuasiNewton(type);
  using SourceEnum = itk::ScalePrior::SpacingSource;
  type.def(New<PoseMethodType>())
    .def("_SetUpperMesh", &PoseMethodType::SetUpperMesh, py::arg("mesh"))
    .def("_SetLowerMesh", &PoseMethodType::SetLowerMesh, py::arg("mesh"))
    .def("_SetUpperContour", &PoseMethodType::SetUpperContour, py::arg("contour"))
    .def("_SetLowerContour", &PoseMethodType::SetLowerContour, py::arg("contour"))
    .def("_SetGeometry", &PoseMethodType::SetGeometry, py::arg("geometry"))
    .def(
      "_SetUpperFrame",
      [](PoseMethodType & self, const RigidType * transform) { self.SetUpperFrame(ToFrame(transform)); },
      py::arg("transform"))
    .def(
      "_SetLowerFrame",
      [](PoseMethodType & self, const RigidType * transform) { self.SetLowerFrame(ToFrame(transform)); },
      py::arg("transform"))
    .def(
      "_SetJointFrame",
      [](PoseMethodType & self, const RigidType * transform) { self.SetJointFrame(ToFrame(transform)); },
      py::arg("transform"))
    .def(
      "_SetCephalometricLandmarks",
      [](PoseMethodType & self, const py::object & landmarks) {
        self.SetCephalometricLandmarks(
          landmarks.is_none() ? nullptr : FromCephalometricDict(landmarks.cast<py::dict>()).GetPointer());
      },
      py::arg("landmarks"))
    .def(
      "_SetLandmarkCounterparts",
      [](PoseMethodType & self, const py::object & counterparts) {
        self.SetLandmarkCounterparts(counterparts.is_none() ? nullptr : ToCounterparts(counterparts).GetPointer());
      },
      py::arg("counterparts"))
    .def(
      "_SetStockOutlines",
      [](PoseMethodType & self, const itk::DentalContour * outlines) { self.SetStockOutlines(outlines); },
      py::arg("outlines"))
    .def(
      "_SetToothCrowns",
      [](PoseMethodType & self, const py::object & crowns) {
        self.SetToothCrowns(crowns.is_none() ? nullptr : ToCrowns(crowns).GetPointer());
      },
      py::arg("crowns"))
    .def(
      "_AddView",
      [](PoseMethodType &                   self,
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
    .def("ClearViews", &PoseMethodType::ClearViews, "Removes all views: the lateral radiograph stands alone again.")
    .def("SetOptions", &PoseMethodType::SetOptions, py::arg("options"), "Sets all options at once.")
    .def(
      "GetOptions", [](const PoseMethodType & self) { return self.GetOptions(); }, "A copy.")
    .def("SetTracedSide",
         &PoseMethodType::SetTracedSide,
         py::arg("side"),
         "Sets the patient's side whose outline was traced.")
    .def("GetTracedSide", &PoseMethodType::GetTracedSide, "Returns the patient's side whose outline was traced.")
    .dentalscrBoolean(
      PoseMethodType, PrincipalPointKnown, "whether the geometry's principal point is known, not a guess.")
    .def(
      "_SetInitialTransform",
      [](PoseMethodType & self, JawEnum jaw, const RigidType & transform, double scaleFactor) {
        self.SetInitialTransform(Checked(jaw), &transform, scaleFactor);
      },
      py::arg("jaw"),
      py::arg("transform"),
      py::arg("scaleFactor"))
    .def("ClearInitialTransforms", &PoseMethodType::ClearInitialTransforms, "Back to a search.")
    .def(
      "_SetInitialGeometry",
      [](PoseMethodType & self, const itk::CephalometricGeometry * geometry) { self.SetInitialGeometry(geometry); },
      py::arg("geometry"))
    .def(
      "SetOptimizer",
      [](PoseMethodType & self, OptimizerBaseType * optimizer) { self.SetOptimizer(optimizer); },
      py::arg("optimizer"),
      R"(A LevenbergMarquardtOptimizerv4, of which candidates take clones, also in other threads.

Its own tolerances and numbers of iterations are set by the options; its events are sent in the thread that runs
Execute(), and StopOptimization() in a command of it ends the registration.)")
    .def(
      "GetOptimizer",
      [](PoseMethodType & self) { return OptimizerBaseType::Pointer(self.GetModifiableOptimizer()); },
      "The optimizer.")
    .def("SetStart", &PoseMethodType::SetStart, py::arg("start"), "Sets where the registration starts from.")
    .def(
      "SetSpacingSource",
      [](PoseMethodType & self, SourceEnum source) { self.SetSpacingSource(source); },
      py::arg("source"),
      "Where the pixel spacing comes from: its prior of the scale takes the place of the option kappaSigma.")
    .def("ClearSpacingSource", &PoseMethodType::ClearSpacingSource, "Back to the option.")
    .def(
      "SetRobustKernel", &PoseMethodType::SetRobustKernel, py::arg("kernel"), "Of the silhouettes; None: the options'.")
    .def("SetNoiseModel", &PoseMethodType::SetNoiseModel, py::arg("model"), "Of the silhouettes; None: the options'.")
    .def("SetCovarianceNoiseModel",
         &PoseMethodType::SetCovarianceNoiseModel,
         py::arg("model"),
         "Of the silhouettes in the covariance; None: the options'.")
    .def(
      "AddMetric",
      [](PoseMethodType & self, MetricBaseType * metric, JawEnum jaw) { self.AddMetric(metric, jaw); },
      py::arg("metric"),
      py::arg_v("jaw", JawEnum::Unknown, "Jaw.Unknown"),
      R"(A further term of the sum that is minimized: a LeastSquaresMetric of your own, a prior, another sum.

It may read the blocks "pose" and "scale", which are those of the dental frame, or have blocks of its own. Jaws that
stand apart have a sum each: with a jaw it is a term of that jaw's alone. Its robust kernel and noise stay its own. The
registration works on clones of it.)")
    .def("ClearMetrics", &PoseMethodType::ClearMetrics, "Takes all terms of one's own out.")
    .def(
      "GetMetrics", [](const PoseMethodType & self) { return self.GetMetrics(); }, "What was added.")
    .def(
      "GetMetric",
      [](PoseMethodType & self) { return itk::SmartPointer<MetricBaseType>(self.GetModifiableMetric()); },
      "The sum of the group that runs, at the position of the last IterationEvent; None before the first group.")
    .def(
      "AddHypothesis",
      [](PoseMethodType & self, const itk::PoseHypothesis * hypothesis) { self.AddHypothesis(hypothesis); },
      py::arg("hypothesis"),
      "Adds another hypothesis of what the drawing may be, which is fitted too.")
    .def("ClearHypotheses", &PoseMethodType::ClearHypotheses, "Takes all hypotheses out.")
    .def(
      "_TryHypothesis",
      [](PoseMethodType & self, const itk::PoseHypothesis & hypothesis, JawEnum jaw) {
        itk::PoseHypothesisOutcome outcome;
        Run(&self, [&]() { outcome = self.TryHypothesis(&hypothesis, Checked(jaw)); });
        return outcome;
      },
      py::arg("hypothesis"),
      py::arg("jaw"))
    .def("GetCurrentLevel",
         &PoseMethodType::GetCurrentLevel,
         "4 group + stage: 0 starts, 1 candidates, 2 refinement, 3 uncertainty.")
    .def("GetNumberOfLevels", &PoseMethodType::GetNumberOfLevels, "How many levels a refinement has.")
    .def(
      "GetCurrentIteration",
      [](const PoseMethodType & self) { return self.GetCurrentIteration(); },
      "The step that the last IterationEvent was about; a copy.")
    .def("GetCurrentCandidate",
         &PoseMethodType::GetCurrentCandidate,
         "Of the stage; candidates are refined at the same time and their steps may alternate.")
    .def("GetOptimizerIteration",
         &PoseMethodType::GetOptimizerIteration,
         "Steps that were accepted in this stage, of this candidate.")
    .def("GetMetricValue",
         &PoseMethodType::GetMetricValue,
         "With the kernel width and the noise of GetCurrentIteration(): comparable as long as these stay.")
    .def("GetStepLength", &PoseMethodType::GetStepLength, "Root mean square, px of 0.25 mm.")
    .def("GetStepAccepted",
         &PoseMethodType::GetStepAccepted,
         "Whether the last step tried lowered the value, within an iteration event.")
    .def(
      "GetOptimizerPosition",
      [](const PoseMethodType & self) {
        const auto position = self.GetOptimizerPosition();
        return py::tuple(py::cast(std::vector<double>(position.begin(), position.end())));
      },
      "pitch, roll, yaw (rad), tx, ty, tz (mm), kappa.")
    .def("GetOptimizerStopConditionDescription",
         &PoseMethodType::GetOptimizerStopConditionDescription,
         "Why the optimizer ended, in words.")
    .def("GetJawsShareFrame", &PoseMethodType::GetJawsShareFrame, "Whether one frame was used for both jaws.")
    .def("_GetSolution", [](const PoseMethodType & self) {
      // A copy: the next Execute() does not change it.
      auto solution = SolutionType::New();
      solution->SetResult(self.GetOutput()->GetResult(), self.GetOutput()->GetOptions());
      return solution;
    });
}
} // namespace

void
WrapPoseRegistration(py::module_ & module)
{
  WrapPoseSolution(module);
  WrapParts(module);
  WrapPoseMethod(module);
  WrapPoseDownstream(module);
}
} // namespace dentalscr

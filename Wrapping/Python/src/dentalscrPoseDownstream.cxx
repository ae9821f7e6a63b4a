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
#include "dentalscrPoseConversions.h"
#include "dentalscrPoseRegistration.h"

#include "itkContourTransformFilter.h"
#include "itkGeometryPlacementFilter.h"
#include "itkLandmarkCounterpartFilter.h"
#include "itkLandmarkMatrixProjectionFilter.h"
#include "itkLandmarkProjectionFilter.h"
#include "itkMatchedContourFilter.h"
#include "itkPictureCheckFilter.h"
#include "itkProjectionSimilarityFilter.h"
#include "itkRegistrationVerdictFilter.h"
#include "itkScanCheckFilter.h"
#include "itkSimilarityPlacementFilter.h"
#include "itkSurfaceSplatWidthCalculator.h"
#include "itkToothCrownFilter.h"
#include "itkTracedSideFilter.h"
#include "itkTracingPixelSpacingFilter.h"

#include <sstream>

namespace dentalscr
{
namespace
{
using SolutionType = itk::PoseSolution;
using itk::RegistrationVerdict;
using JawEnum = itk::ToothCode::JawEnum;

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
    .def_readwrite("biteMean",
                   &ThresholdsType::biteMean,
                   "Of jaws that marks placed each by itself: how far the cusps of upper and lower first molars stand "
                   "apart on average, across the occlusal plane, mm.")
    .def_readwrite("biteSigma", &ThresholdsType::biteSigma, "Its standard deviation beside that of the poses, mm.")
    .def_readwrite("suspectBite",
                   &ThresholdsType::suspectBite,
                   "Distance from that average above which the jaws do not bite, standard deviations.")
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
    .def_readwrite("spacingShare",
                   &ThresholdsType::spacingShare,
                   "Share of a tracing's score up to which another pixel spacing is suspect, 0 to 1.")
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
    .def(
      "_SetCounterparts",
      [](ProjectionType & self, const py::object & counterparts) {
        self.SetCounterparts(counterparts.is_none() ? nullptr : ToCounterparts(counterparts).GetPointer());
      },
      py::arg("counterparts"))
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
      [](const ProjectionType & self, const std::string & name) { return MatrixToArray(self.GetCovariance(name)); },
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
            py::make_tuple(py::make_tuple(middle.point[0], middle.point[1]), MatrixToArray(middle.covariance));
        }
        return middles;
      },
      "{\"U6_MB\": ((u, v), (2, 2) square pixels)} between each right landmark's image and its left one's; of "
      "counterparts, too, where the landmarks have none of that name.")
    .def(
      "GetMiddleSources",
      [](const ProjectionType & self) {
        py::dict sources;
        for (const auto & middle : self.GetMiddles())
        {
          sources[py::str(middle.name)] = middle.source;
        }
        return sources;
      },
      "{\"U6_MB\": \"landmarks_3d\"}: how the points of each middle were found on the scan.")
    .def(
      "GetMiddleCovariance",
      [](const ProjectionType & self, const std::string & name) {
        return MatrixToArray(self.GetMiddleCovariance(name));
      },
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

  using PictureCheckType = itk::PictureCheckFilter;
  ProcessClass<PictureCheckType>(
    module, "PictureCheckFilter", "Whether a radiograph is the one that was drawn on, as far as its grey values tell.")
    .def(New<PictureCheckType>())
    .def("_SetRadiograph", &PictureCheckType::SetRadiograph, py::arg("radiograph"))
    .def("_SetUpperContour", &PictureCheckType::SetUpperContour, py::arg("contour"))
    .def("_SetLowerContour", &PictureCheckType::SetLowerContour, py::arg("contour"))
    .def("_SetGeometry", &PictureCheckType::SetGeometry, py::arg("geometry"))
    .def("_GetFindings", [](PictureCheckType & self) { return FindingsToList(self.GetFindings()); })
    .def("GetNotCheckable", &PictureCheckType::GetNotCheckable, "What the data could not tell, as sentences.");

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
    .def("_SetSolution", &CounterpartType::SetSolution, py::arg("solution"))
    .def("_SetUpperTracing", &CounterpartType::SetUpperTracing, py::arg("contour"))
    .def("_SetLowerTracing", &CounterpartType::SetLowerTracing, py::arg("contour"))
    .dentalscrBoolean(
      CounterpartType, Bisected, "whether the tracings are the middle between both sides' images. Off by default.")
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
      [](SimilarityType & self) { return MatrixToArray(self.GetProjectionMatrix()); },
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
WrapPoseDownstream(py::module_ & module)
{
  WrapDownstream(module);
  WrapSimilarityChain(module);
}
} // namespace dentalscr

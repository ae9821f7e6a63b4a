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

#include "itkLandmarkPoseMetricv4.h"
#include "itkSilhouettePoseMetricv4.h"
#include "itkToothOutlinePoseMetricv4.h"
#include "itkViewPoseMetricv4.h"

namespace dentalscr
{
namespace
{
using JawEnum = itk::ToothCode::JawEnum;

void
WrapSilhouettesAndLandmarks(py::module_ & module)
{
  using PoseMetricType = itk::PoseMetricv4;
  MetricClass<PoseMetricType>(
    module, "PoseMetricv4", "Base of the terms whose residuals are those of a scan's pose on a radiograph.")
    .def("SetTransform",
         &PoseMetricType::SetTransform,
         py::arg("transform"),
         "Its geometry is the radiograph's; its parameters are where pose and scale begin.")
    .def(
      "GetTransform",
      [](const PoseMetricType & self) {
        return PoseMetricType::TransformType::Pointer(const_cast<PoseMetricType::TransformType *>(self.GetTransform()));
      },
      "The transform from the dental frame (mm) to pixels that the metric moves.")
    .def("SetPoseBlock", &PoseMetricType::SetPoseBlock, py::arg("name"), "Another body has another one.")
    .def(
      "GetPoseBlock",
      [](const PoseMetricType & self) { return std::string(self.GetPoseBlock()); },
      "Name of the block of the pose.")
    .def("SetScaleBlock", &PoseMetricType::SetScaleBlock, py::arg("name"), "Another view has another one.")
    .def(
      "GetScaleBlock",
      [](const PoseMetricType & self) { return std::string(self.GetScaleBlock()); },
      "Name of the block of the scale.");

  using LandmarkType = itk::LandmarkPoseMetricv4;
  py::class_<LandmarkType, PoseMetricType, itk::SmartPointer<LandmarkType>>(
    module, "LandmarkPoseMetricv4", "Landmarks of a scan against landmarks of the radiograph: a term of its pose.")
    .def(New<LandmarkType>())
    .def(
      "_SetMovingLandmarks",
      [](LandmarkType & self, const py::dict & landmarks) { self.SetMovingLandmarks(FromDict<3>(landmarks)); },
      py::arg("landmarks"))
    .def(
      "_SetFixedLandmarks",
      [](LandmarkType & self, const py::dict & landmarks) { self.SetFixedLandmarks(FromDict<2>(landmarks)); },
      py::arg("landmarks"))
    .dentalscrProperty(LandmarkType,
                       Sigma,
                       "the standard deviation an axis of marks without a covariance of their own, pixels of the "
                       "radiograph; 4 by default.")
    .dentalscrProperty(
      LandmarkType, KernelWidthInSigmas, "the width of the robust kernel in standard deviations; 4 by default.")
    .def(
      "SetCovariance",
      [](LandmarkType & self, const std::string & name, const DoubleArray & covariance) {
        if (covariance.ndim() != 2 || covariance.shape(0) != 2 || covariance.shape(1) != 2)
        {
          throw std::invalid_argument("the covariance of a mark is a 2 x 2 matrix, square pixels");
        }
        LandmarkType::CovarianceType matrix;
        for (unsigned int i = 0; i < 4; ++i)
        {
          matrix(i / 2, i % 2) = covariance.at(i / 2, i % 2);
        }
        self.SetCovariance(name, matrix);
      },
      py::arg("name"),
      py::arg("covariance"),
      "Of one mark, square pixels, instead of Sigma.")
    .def("ClearCovariances", &LandmarkType::ClearCovariances, "Takes back all covariances.")
    .def("GetMatchedNames", &LandmarkType::GetMatchedNames, "In the order of the residuals, u and v each.");

  using SilhouetteType = itk::SilhouettePoseMetricv4;
  py::class_<SilhouetteType, PoseMetricType, itk::SmartPointer<SilhouetteType>>(
    module,
    "SilhouettePoseMetricv4",
    R"(A scan's silhouette against a tracing of it: the term of a jaw in a registration of its pose.

Reads the blocks "pose" and "scale", or as named. The mesh is in its dental frame, as UMidlineDentalAxis() returns it.)")
    .def(New<SilhouetteType>())
    .def(
      "_SetMovingMesh", [](SilhouetteType & self, const MeshType * mesh) { self.SetMovingMesh(mesh); }, py::arg("mesh"))
    .def(
      "_SetFixedContour",
      [](SilhouetteType & self, const itk::DentalContour * contour) { self.SetFixedContour(contour); },
      py::arg("contour"))
    .def(
      "_SetMovingContour",
      [](SilhouetteType & self, const itk::DentalContour * contour) { self.SetMovingContour(contour); },
      py::arg("contour"))
    .def("SetJaw", &SilhouetteType::SetJaw, py::arg("jaw"), "Sets the jaw of the scan: Upper (the default) or Lower.")
    .def("GetJaw", &SilhouetteType::GetJaw, "Returns the jaw of the scan: Upper (the default) or Lower.")
    .def("SetTracedSide",
         &SilhouetteType::SetTracedSide,
         py::arg("side"),
         "Sets the patient's side whose outline was traced; Right by default.")
    .def("GetTracedSide",
         &SilhouetteType::GetTracedSide,
         "Returns the patient's side whose outline was traced; Right by default.")
    .dentalscrBoolean(SilhouetteType, UseSideSelection, "whether the scan is cut at the midline plane. On by default.")
    .dentalscrProperty(
      SilhouetteType, MidlineMargin, "how far beyond the midline plane the scan is kept, mm; -0.5 by default.")
    .dentalscrBoolean(SilhouetteType,
                      UseFacingFilter,
                      "whether the occlusal and anterior part of the outline alone is kept. On by default.")
    .dentalscrBoolean(SilhouetteType, UseOrientation, "whether directions are matched beside positions. On by default.")
    .dentalscrProperty(
      SilhouetteType, OrientationWeight, "the weight of directions, pixels a unit normal; 8 by default.")
    .dentalscrProperty(
      SilhouetteType, MaximumTracingPoints, "the number of points above which a tracing is thinned; 200 by default.")
    .dentalscrBoolean(SilhouetteType,
                      GateByTooth,
                      "whether a point that carries a tooth's code is matched with that tooth alone, or one up to "
                      "ToothRange positions away. Off by default.")
    .dentalscrProperty(SilhouetteType,
                       ToothRange,
                       "the number of positions along the arch that a code may be off, under GateByTooth; 1 by "
                       "default.")
    .dentalscrProperty(SilhouetteType,
                       ReverseWeight,
                       "the weight of the direction from the outline to the tracing, beside the forward one; 0 by "
                       "default.")
    .dentalscrProperty(SilhouetteType,
                       TaperLength,
                       "the length from an end of the tracing over which the reverse direction fades in, pixels; 6 "
                       "by default.")
    .dentalscrProperty(SilhouetteType,
                       GapLength,
                       "the length of a gap in the tracing below which it has no ends there, pixels; 8 by default.")
    .def("SetExcludedTeeth", &SilhouetteType::SetExcludedTeeth, py::arg("teeth"), "FDI numbers.")
    .def(
      "GetExcludedTeeth",
      [](const SilhouetteType & self) {
        return std::vector<int>(self.GetExcludedTeeth().begin(), self.GetExcludedTeeth().end());
      },
      "FDI numbers of the teeth that are left out.")
    .def(
      "GetKernelWidth", &SilhouetteType::GetKernelWidth, "Width of the robust kernel, pixels of 0.25 mm; 3 by default.")
    .def("GetFailure", &SilhouetteType::GetFailure, "Why the tracing can't be matched; empty where it can.")
    .def(
      "GetFit",
      [](const SilhouetteType & self) {
        py::list result;
        for (const auto & fit : self.ComputeFitStatistics(Ready(self).GetState().GetValues()))
        {
          py::dict values = ToDict(fit);
          // What takes a covariance, or the contour that was found.
          for (const char * name : { "overlap", "predictedSigma", "extrapolatedSigma" })
          {
            values.attr("pop")(name);
          }
          result.append(values);
        }
        return result;
      },
      "How well each strand of the tracing is explained, px of 0.25 mm.");
}

void
WrapOutlines(py::module_ & module)
{
  using OutlineType = itk::ToothOutlinePoseMetricv4;
  using ErrorsType = OutlineType::ErrorsType;
  py::class_<ErrorsType>(module, "ToothOutlineErrors", "What hands get wrong of a tooth, standard deviations.")
    .def(py::init<>())
    .def_readwrite("along", &ErrorsType::along, "Of its place along the occlusal plane, mm on the detector.")
    .def_readwrite("across", &ErrorsType::across, "Of its place across the occlusal plane, mm on the detector.")
    .def_readwrite("turn", &ErrorsType::turn, "Of a hand that draws the tooth: how far it is turned, rad.")
    .def_readwrite("size", &ErrorsType::size, "Of a hand that draws the tooth: a share of its size.")
    .def_readwrite("templateTurn", &ErrorsType::templateTurn, "Of a stock template: how far it is turned, rad.")
    .def_readwrite("templateSize", &ErrorsType::templateSize, "Of a stock template: a share of its size.")
    .def_readwrite("lingual", &ErrorsType::lingual, "How far the inner side lies beside the edge, mm on the detector.")
    .def_readwrite("drift", &ErrorsType::drift, "Of the line, correlated along it, px of 0.25 mm.")
    .def_readwrite("jitter", &ErrorsType::jitter, "Each point's own, px of 0.25 mm.")
    .def_readwrite(
      "frontalJitter", &ErrorsType::frontalJitter, "Each point's own on a frontal radiograph, px of 0.25 mm.");

  py::class_<OutlineType, itk::PoseMetricv4, itk::SmartPointer<OutlineType>>(
    module, "ToothOutlinePoseMetricv4", "Crowns of a scan against outlines of whole teeth: a term of its pose.")
    .def(New<OutlineType>())
    .def(
      "_SetCrowns",
      [](OutlineType & self, const py::dict & crowns) { self.SetCrowns(ToCrowns(crowns)); },
      py::arg("crowns"))
    .def(
      "_SetFixedContour",
      [](OutlineType & self, const itk::DentalContour * contour) { self.SetFixedContour(contour); },
      py::arg("contour"))
    .def("SetJaw", &OutlineType::SetJaw, py::arg("jaw"), "Sets the jaw of the scan: Upper (the default) or Lower.")
    .def("GetJaw", &OutlineType::GetJaw, "Returns the jaw of the scan: Upper (the default) or Lower.")
    .def("SetErrors", &OutlineType::SetErrors, py::arg("errors"), "What hands get wrong (ToothOutlineErrors).")
    .def(
      "GetErrors", [](const OutlineType & self) { return self.GetErrors(); }, "A copy: give it back to SetErrors().")
    .def(
      "SetMarkedTeeth",
      [](OutlineType & self, const std::vector<std::string> & teeth) { self.SetMarkedTeeth(ToTeeth(teeth)); },
      py::arg("teeth"),
      "Names of teeth whose landmarks are registered with as well: the two share a part of their error.")
    .dentalscrProperty(OutlineType,
                       MaximumCutSigma,
                       "how far from where it was cut a crown may be, standard deviation along the arch, mm: others "
                       "are left out; without a limit by default.")
    .def(
      "SetExcludedTeeth",
      [](OutlineType & self, const std::vector<std::uint8_t> & teeth) { self.SetExcludedTeeth(teeth); },
      py::arg("teeth"),
      "FDI numbers of teeth to leave out.")
    .def("GetFailure",
         &OutlineType::GetFailure,
         "Why no outline can be matched; empty where one can. Valid after Initialize(), which says it as an error.")
    .def(
      "GetOutlinedTeeth",
      [](const OutlineType & self) {
        std::vector<std::string> names;
        for (const itk::ToothCode & tooth : self.GetOutlinedTeeth())
        {
          names.push_back(tooth.GetName());
        }
        return names;
      },
      "Names of the teeth whose outlines are used. Valid after Initialize().")
    .def(
      "GetUnused",
      [](const OutlineType & self) {
        py::dict unused;
        for (const auto & outline : self.GetUnused())
        {
          unused[py::str(outline.name)] = outline.reason;
        }
        return unused;
      },
      "Outlines that are not used and why: name (\"U6\"; of a frontal radiograph \"UR6\") to a sentence.")
    .def("_GetOutlineResiduals", [](const OutlineType & self) {
      py::list list;
      for (const auto & residual : self.ComputeOutlineResiduals(Ready(self).GetState().GetValues()))
      {
        std::vector<double> crown;
        for (const auto & point : residual.crown)
        {
          crown.insert(crown.end(), point.begin(), point.end());
        }
        list.append(py::make_tuple(residual.name,
                                   MakeArray(std::vector<double>(residual.shift.begin(), residual.shift.end())),
                                   residual.distance,
                                   residual.weight,
                                   residual.matchedShare,
                                   residual.isTemplate,
                                   MakeArray(crown, { static_cast<py::ssize_t>(residual.crown.size()), 2 })));
      }
      return list;
    });
}

void
WrapViews(py::module_ & module)
{
  using ViewType = itk::ViewPoseMetricv4;
  MetricClass<ViewType>(module,
                        "ViewPoseMetricv4",
                        R"(A term of another view: the one that it holds, with the head where it was for that view.

Reads the body's "pose", how the head was moved for the view, and the view's scale: blocks of 6, 6 and 1 parameters
(GetBlocks()). Kernel, noise and matches are those of the term that it holds. Priors say how far the head may have
moved: a ParameterPriorMetricv4 on the second block.)")
    .def(New<ViewType>())
    .def(
      "SetTerm",
      [](ViewType & self, itk::PoseMetricv4 * term) { self.SetTerm(term); },
      py::arg("term"),
      "The term with the view's radiograph, whose geometry is its transform's.")
    .def(
      "GetTerm",
      [](const ViewType & self) {
        return itk::SmartPointer<itk::PoseMetricv4>(const_cast<itk::PoseMetricv4 *>(self.GetTerm()));
      },
      "The term that it holds.")
    .def("SetView", &ViewType::SetView, py::arg("name"), "Name of the view, after which its blocks are named.")
    .def(
      "GetView", [](const ViewType & self) { return std::string(self.GetView()); }, "Name of the view.")
    .def(
      "GetTermValues",
      [](const ViewType & self) { return MakeArray(ViewType::MakeTermPosition(Ready(self).GetState().GetValues())); },
      "Where the scan is in the view: pitch, roll, yaw (rad), tx, ty, tz (mm), kappa, by the values of the state.");
}
} // namespace

void
WrapPoseTerms(py::module_ & module)
{
  WrapSilhouettesAndLandmarks(module);
  WrapOutlines(module);
  WrapViews(module);
}
} // namespace dentalscr

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

#include "itkLandmarkErrorFilter.h"
#include "itkRegistrationOverlayFilter.h"

namespace dentalscr
{
namespace
{
using ErrorType = itk::LandmarkErrorFilter;
using StatisticsType = itk::LandmarkErrorStatistics;
using GroupEnum = itk::ToothCode::GroupEnum;
using JawEnum = itk::ToothCode::JawEnum;
using OverlayType = itk::RegistrationOverlayFilter;

py::dict
StatisticsToDict(const StatisticsType & statistics)
{
  py::dict result;
  result["count"] = statistics.GetCount();
  if (statistics.GetCount() == 0)
  {
    return result;
  }
  result["mean"] = statistics.GetMean();
  result["rmse"] = statistics.GetRMSE();
  result["std"] = statistics.GetStandardDeviation();
  result["maximum"] = statistics.GetMaximum();
  py::dict groups;
  for (const auto & group : { std::make_pair("incisors_canines", GroupEnum::IncisorsAndCanines),
                              std::make_pair("premolars", GroupEnum::Premolars),
                              std::make_pair("molars", GroupEnum::Molars) })
  {
    if (statistics.GetCount(group.second) > 0)
    {
      groups[group.first] = statistics.GetMean(group.second);
    }
  }
  result["groups"] = groups;
  if (statistics.GetCountInMillimetres() > 0)
  {
    py::dict rates;
    for (const double threshold : StatisticsType::SuccessThresholds)
    {
      rates[py::float_(threshold)] = statistics.GetSuccessDetectionRate(threshold);
    }
    result["mean_mm"] = statistics.GetMeanInMillimetres();
    result["rmse_mm"] = statistics.GetRMSEInMillimetres();
    result["std_mm"] = statistics.GetStandardDeviationInMillimetres();
    result["success_detection_rate"] = rates;
  }
  return result;
}
} // namespace

void
WrapEvaluation(py::module_ & module)
{
  ProcessClass<ErrorType>(module, "LandmarkErrorFilter", "Distances between predicted and marked landmarks.")
    .def(New<ErrorType>())
    .def(
      "_SetPredictedLandmarks",
      [](ErrorType & self, const py::dict & landmarks) { self.SetPredictedLandmarks(FromDict<2>(landmarks)); },
      py::arg("landmarks"))
    .def(
      "_SetReferenceLandmarks",
      [](ErrorType & self, const py::dict & landmarks) { self.SetReferenceLandmarks(FromDict<2>(landmarks)); },
      py::arg("landmarks"))
    .def("SetJaw", &ErrorType::SetJaw, py::arg("jaw"), "Unknown, the default, is both.")
    .def("GetJaw", &ErrorType::GetJaw, "The jaw whose landmarks count; Unknown, the default, is both.")
    .dentalscrBoolean(ErrorType,
                      BisectSides,
                      "whether the middle between left and right is measured where both are there. Off by default.")
    .def("SetPixelSpacing", &ErrorType::SetPixelSpacing, py::arg("spacing"), "mm (u, v); 0 is unknown.")
    .def(
      "GetPixelSpacing",
      [](const ErrorType & self) { return self.GetPixelSpacing(); },
      "The pixel spacing (u, v) by which errors are told in mm; 0, the default, is unknown.")
    .def("GetUnpairedLandmarks", &ErrorType::GetUnpairedLandmarks, "Names whose partner is missing.")
    .def("_GetStatistics", [](const ErrorType & self) { return StatisticsToDict(self.GetStatistics()); })
    .def("_GetErrors", [](const ErrorType & self) {
      py::dict result;
      for (const auto & error : self.GetErrors())
      {
        result[py::str(error.name)] = error.distance;
      }
      return result;
    });

  ProcessClass<OverlayType>(module, "RegistrationOverlayFilter", "The picture by which a person judges a registration.")
    .def(New<OverlayType>())
    .def("_SetRadiograph", &OverlayType::SetRadiograph, py::arg("image"))
    .def("_SetFixedContour", &OverlayType::SetFixedContour, py::arg("contour"))
    .def(
      "_SetMovingContour",
      [](OverlayType & self, unsigned int number, const itk::DentalContour * contour, const std::string & label) {
        self.SetMovingContour(number, contour, label);
      },
      py::arg("number"),
      py::arg("contour"),
      py::arg("label"))
    .def("_GetNumberOfMovingContours", &OverlayType::GetNumberOfMovingContours)
    .def(
      "_SetPredictedLandmarks",
      [](OverlayType & self, const py::dict & landmarks) { self.SetPredictedLandmarks(FromDict<2>(landmarks)); },
      py::arg("landmarks"))
    .def(
      "_SetReferenceLandmarks",
      [](OverlayType & self, const py::dict & landmarks) { self.SetReferenceLandmarks(FromDict<2>(landmarks)); },
      py::arg("landmarks"))
    .def("SetLandmarkSigmas", &OverlayType::SetLandmarkSigmas, py::arg("sigmas"), "px by name.")
    .def("GetLandmarkSigmas",
         &OverlayType::GetLandmarkSigmas,
         "Standard deviation an axis of each predicted landmark by its name, pixels.")
    .def("SetPixelSpacing",
         &OverlayType::SetPixelSpacing,
         py::arg("spacing"),
         "Sets the pixel spacing (u, v) in the detector plane, mm. With 0, the default, lengths are "
         "written in pixels.")
    .def(
      "GetPixelSpacing",
      [](const OverlayType & self) { return self.GetPixelSpacing(); },
      "Returns the pixel spacing (u, v) in the detector plane, mm. With 0, the default, lengths "
      "are written in pixels.")
    .def("SetRadiographSize",
         &OverlayType::SetRadiographSize,
         py::arg("width"),
         py::arg("height"),
         "Width and height of the radiograph, pixels, for the frame where there is no image to show.")
    .def("SetWindow",
         &OverlayType::SetWindow,
         py::arg("black"),
         py::arg("white"),
         "Grey values that are shown as black and as white. Both 0, the default, stand for the 0.2 "
         "and 99.8 % quantiles.")
    .def("SetPictureSize",
         &OverlayType::SetPictureSize,
         py::arg("width"),
         py::arg("height"),
         "Sets the size of the output (width, height), pixels; 1400 by 900 by default.")
    .def(
      "GetPictureSize",
      [](const OverlayType & self) { return self.GetPictureSize(); },
      "Returns the size of the output (width, height), pixels; 1400 by 900 by default.")
    .def(
      "SetTitle",
      [](OverlayType & self, const std::string & title) { self.SetTitle(title); },
      py::arg("title"),
      "Sets the line above the picture.")
    .def(
      "GetTitle",
      [](const OverlayType & self) { return std::string(self.GetTitle()); },
      "Returns the line above the picture.")
    .def(
      "SetStatus",
      [](OverlayType & self, const std::string & status) { self.SetStatus(status); },
      py::arg("status"),
      "Sets the word of the badge: \"ok\", \"suspect\", \"failed\" or any other. None is drawn "
      "where it is empty, which is the default.")
    .def(
      "GetStatus",
      [](const OverlayType & self) { return std::string(self.GetStatus()); },
      "Returns the word of the badge: \"ok\", \"suspect\", \"failed\" or any other. None is drawn "
      "where it is empty, which is the default.")
    .def("SetTextLines",
         &OverlayType::SetTextLines,
         py::arg("lines"),
         "Sets the lines of text beside the radiograph; long ones are wrapped.")
    .def("GetTextLines",
         &OverlayType::GetTextLines,
         "Returns the lines of text beside the radiograph; long ones are wrapped.")
    .def("SetView",
         &OverlayType::SetView,
         py::arg("firstU"),
         py::arg("lastU"),
         py::arg("firstV"),
         py::arg("lastV"),
         "First and last pixel index of u, then of v.")
    .def("SetViewToContours",
         &OverlayType::SetViewToContours,
         "Shows the region around tracing and landmarks, which is the default.")
    .dentalscrProperty(OverlayType,
                       Margin,
                       "the free border around tracing and landmarks, as a part of their larger extent; 0.2 by "
                       "default.")
    .def("_TakeOutput", [](OverlayType & self) {
      itk::SmartPointer<PictureType> picture = self.GetOutput();
      picture->DisconnectPipeline();
      return picture;
    });
}
} // namespace dentalscr

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
ToDict(const StatisticsType & statistics)
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
    .def("GetJaw", &ErrorType::GetJaw)
    .dentalscrBoolean(ErrorType, BisectSides)
    .def("SetPixelSpacing", &ErrorType::SetPixelSpacing, py::arg("spacing"), "mm (u, v); 0 is unknown.")
    .def("GetPixelSpacing", [](const ErrorType & self) { return self.GetPixelSpacing(); })
    .def("GetUnpairedLandmarks", &ErrorType::GetUnpairedLandmarks, "Names whose partner is missing.")
    .def("_GetStatistics", [](const ErrorType & self) { return ToDict(self.GetStatistics()); })
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
    .def("GetLandmarkSigmas", &OverlayType::GetLandmarkSigmas)
    .def("SetPixelSpacing", &OverlayType::SetPixelSpacing, py::arg("spacing"))
    .def("GetPixelSpacing", [](const OverlayType & self) { return self.GetPixelSpacing(); })
    .def("SetRadiographSize", &OverlayType::SetRadiographSize, py::arg("width"), py::arg("height"))
    .def("SetWindow", &OverlayType::SetWindow, py::arg("black"), py::arg("white"))
    .def("SetPictureSize", &OverlayType::SetPictureSize, py::arg("width"), py::arg("height"))
    .def("GetPictureSize", [](const OverlayType & self) { return self.GetPictureSize(); })
    .def(
      "SetTitle", [](OverlayType & self, const std::string & title) { self.SetTitle(title); }, py::arg("title"))
    .def("GetTitle", [](const OverlayType & self) { return std::string(self.GetTitle()); })
    .def(
      "SetStatus", [](OverlayType & self, const std::string & status) { self.SetStatus(status); }, py::arg("status"))
    .def("GetStatus", [](const OverlayType & self) { return std::string(self.GetStatus()); })
    .def("SetTextLines", &OverlayType::SetTextLines, py::arg("lines"))
    .def("GetTextLines", &OverlayType::GetTextLines)
    .def("SetView",
         &OverlayType::SetView,
         py::arg("firstU"),
         py::arg("lastU"),
         py::arg("firstV"),
         py::arg("lastV"),
         "First and last pixel index of u, then of v.")
    .def("SetViewToContours", &OverlayType::SetViewToContours)
    .dentalscrProperty(OverlayType, Margin)
    .def("_TakeOutput", [](OverlayType & self) {
      itk::SmartPointer<PictureType> picture = self.GetOutput();
      picture->DisconnectPipeline();
      return picture;
    });
}
} // namespace dentalscr

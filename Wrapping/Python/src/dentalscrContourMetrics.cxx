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
#include "dentalscrContourMethod.h"

#include "itkContourChamferMetricv4.h"
#include "itkContourDistanceFilter.h"
#include "itkContourOverlapFilter.h"
#include "itkScalePrior.h"

#include <sstream>

namespace dentalscr
{
namespace
{
using SimilarityType = itk::Similarity2DTransform<double>;
using DistanceFilterType = itk::ContourDistanceFilter;
using OverlapFilterType = itk::ContourOverlapFilter;
using MetricDirectionEnum = itk::ContourMetricEnums::Direction;
using DistanceEnum = itk::ContourMetricEnums::Distance;
using ContourMetricType = itk::ContourToContourMetricv4;
using ChamferType = itk::ContourChamferMetricv4;

/** Where a contour is moved to before it is compared; None is where it lies. */
template <typename TFilter>
void
SetTransformOrNone(TFilter & filter, const SimilarityType * transform)
{
  if (transform == nullptr)
  {
    filter.SetTransformInput(nullptr);
  }
  else
  {
    filter.SetTransform(transform);
  }
}

void
WrapComparisons(py::module_ & module)
{
  BindEnum<MetricDirectionEnum>(module,
                                "ContourDirection",
                                { { "Symmetric", MetricDirectionEnum::Symmetric },
                                  { "MovingToFixed", MetricDirectionEnum::MovingToFixed },
                                  { "FixedToMoving", MetricDirectionEnum::FixedToMoving } },
                                "Which way distances between two contours are taken.");
  BindEnum<DistanceEnum>(
    module,
    "ContourPointDistance",
    { { "PointToPoint", DistanceEnum::PointToPoint }, { "PointToSegment", DistanceEnum::PointToSegment } },
    "To what distances are taken: the nearest point, or the nearest place on a line.");
  ProcessClass<DistanceFilterType>(module, "ContourDistanceFilter", "Distances between two contours.")
    .def(New<DistanceFilterType>())
    .def("_SetFixedContour", &DistanceFilterType::SetFixedContour, py::arg("contour"))
    .def("_SetMovingContour", &DistanceFilterType::SetMovingContour, py::arg("contour"))
    .def("_SetTransform", &SetTransformOrNone<DistanceFilterType>, py::arg("transform"))
    .def("SetDistance",
         &DistanceFilterType::SetDistance,
         py::arg("distance"),
         "Sets how the distance of a point, in pixels, is measured: PointToPoint (the default, the paper's) or "
         "PointToSegment.")
    .def("GetDistance",
         &DistanceFilterType::GetDistance,
         "Returns how the distance of a point is measured: PointToPoint (the default, the paper's) or "
         "PointToSegment.")
    .def(
      "GetMovingToFixedMean", [](const DistanceFilterType & self) { return self.GetMovingToFixedMean(); }, "px.")
    .def(
      "GetFixedToMovingMean", [](const DistanceFilterType & self) { return self.GetFixedToMovingMean(); }, "px.")
    .def(
      "GetChamfer", [](const DistanceFilterType & self) { return self.GetChamfer(); }, "Average of the two means, px.")
    .def(
      "GetMovingToFixedHausdorff",
      [](const DistanceFilterType & self) { return self.GetMovingToFixedHausdorff(); },
      "px.")
    .def(
      "GetFixedToMovingHausdorff",
      [](const DistanceFilterType & self) { return self.GetFixedToMovingHausdorff(); },
      "px.")
    .def(
      "GetHausdorff", [](const DistanceFilterType & self) { return self.GetHausdorff(); }, "px.")
    .def(
      "GetMovingToFixedDistances",
      [](const DistanceFilterType & self) { return MakeArray(self.GetMovingToFixedDistances()); },
      "One a point, px; NaN for points of weight 0.")
    .def(
      "GetFixedToMovingDistances",
      [](const DistanceFilterType & self) { return MakeArray(self.GetFixedToMovingDistances()); },
      "One a point, px; NaN for points of weight 0.")
    .def(
      "GetFixedToMovingDistancesByTooth",
      [](const DistanceFilterType & self) {
        py::dict teeth;
        for (const auto & tooth : self.GetFixedToMovingDistancesByTooth())
        {
          py::dict figures;
          figures["count"] = tooth.numberOfPoints;
          figures["mean"] = tooth.mean;
          figures["rms"] = tooth.rms;
          figures["maximum"] = tooth.maximum;
          teeth[py::str(tooth.tooth.GetName())] = figures;
        }
        return teeth;
      },
      "{\"UR1\": {\"count\", \"mean\", \"rms\", \"maximum\"}}, px: how far the fixed contour's drawing of each tooth "
      "lies "
      "from the moving contour, over its points that count; \"\" for those without a code.");
  ProcessClass<OverlapFilterType>(
    module, "ContourOverlapFilter", "How much of an open tracing and of a contour lies together.")
    .def(New<OverlapFilterType>())
    .def("_SetFixedContour", &OverlapFilterType::SetFixedContour, py::arg("contour"))
    .def("_SetMovingContour", &OverlapFilterType::SetMovingContour, py::arg("contour"))
    .def("_SetTransform", &SetTransformOrNone<OverlapFilterType>, py::arg("transform"))
    .dentalscrProperty(OverlapFilterType,
                       MaximumDistance,
                       "the distance beyond which contours do not lie together, pixels; 5 by default.")
    .dentalscrProperty(OverlapFilterType,
                       GapLength,
                       "the length of a gap in the tracing below which it has no ends there, pixels; 8 by default.")
    .def(
      "GetFixedShare", [](const OverlapFilterType & self) { return self.GetFixedShare(); }, "Of the tracing, 0 to 1.")
    .def(
      "GetMovingShare", [](const OverlapFilterType & self) { return self.GetMovingShare(); }, "Of the outline, 0 to 1.")
    .def(
      "GetRootMeanSquare", [](const OverlapFilterType & self) { return self.GetRootMeanSquare(); }, "px.")
    .def(
      "GetLargestDistance", [](const OverlapFilterType & self) { return self.GetLargestDistance(); }, "px.")
    .def(
      "GetFixedDistances",
      [](const OverlapFilterType & self) { return MakeArray(self.GetFixedDistances()); },
      "One a point, px; NaN for points that are ignored.")
    .def(
      "GetMovingDistances",
      [](const OverlapFilterType & self) { return MakeArray(self.GetMovingDistances()); },
      "One a point, px; NaN for points without tracing beside them.");
}

/** Metrics as objects: what SetMetric() takes. */
void
WrapMetrics(py::module_ & module)
{
  using SpacingSourceEnum = itk::ScalePrior::SpacingSource;
  BindEnum<SpacingSourceEnum>(module,
                              "SpacingSource",
                              { { "Given", SpacingSourceEnum::Given },
                                { "Dicom", SpacingSourceEnum::Dicom },
                                { "Default", SpacingSourceEnum::Default },
                                { "Estimated", SpacingSourceEnum::Estimated } },
                              "Where a pixel spacing comes from, for the scale's prior.");
  py::class_<ContourMetricType, itk::SmartPointer<ContourMetricType>>(
    module, "ContourToContourMetricv4", "A figure of merit between two contours, for SetMetric().")
    .def(
      "GetName",
      [](const ContourMetricType & self) { return std::string(self.GetNameOfClass()); },
      "Name of the class in C++.")
    .def(
      "GetPivot",
      [](const ContourMetricType & self) { return std::make_pair(self.GetPivot()[0], self.GetPivot()[1]); },
      "Of scale and rotation, in the moving frame, px.")
    .def("GetReferenceLength", &ContourMetricType::GetReferenceLength, "What makes the four parameters alike, px.")
    .def("__str__", [](const ContourMetricType & self) {
      std::ostringstream text;
      self.Print(text);
      return text.str();
    });
  py::class_<ChamferType, ContourMetricType, itk::SmartPointer<ChamferType>>(
    module, "ContourChamferMetricv4", "Symmetric or one-sided Chamfer distance: the sum of the directed means, px.")
    .def(New<ChamferType>())
    .def("SetDirection",
         &ChamferType::SetDirection,
         py::arg("direction"),
         "Sets which contour's points are measured: Symmetric (both, the default), MovingToFixed or "
         "FixedToMoving.")
    .def("GetDirection",
         &ChamferType::GetDirection,
         "Returns which contour's points are measured: Symmetric (both, the default), MovingToFixed "
         "or FixedToMoving.")
    .def("SetDistance",
         &ChamferType::SetDistance,
         py::arg("distance"),
         "Sets how the distance of a point, in pixels, is measured: PointToPoint (the default, the paper's) or "
         "PointToSegment.")
    .def("GetDistance",
         &ChamferType::GetDistance,
         "Returns how the distance of a point is measured: PointToPoint (the default, the paper's) or "
         "PointToSegment.")
    .dentalscrProperty(
      ChamferType, Truncation, "the distance that all larger ones count as, pixels; infinity by default.");
}
} // namespace

void
WrapContourMetrics(py::module_ & module)
{
  WrapComparisons(module);
  WrapMetrics(module);
}
} // namespace dentalscr

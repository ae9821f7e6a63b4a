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

#include "itkCoherentPointDriftContourRegistrationMethod.h"
#include "itkIntensityRegistrationMethod.h"
#include "itkIterativeClosestPointContourRegistrationMethod.h"

#include <type_traits>

namespace dentalscr
{
void
WrapBaselines(py::module_ & module)
{
  using MotionEnum = itk::ContourBaselineEnums::Motion;
  BindEnum<MotionEnum>(module,
                       "Motion",
                       { { "Rigid", MotionEnum::Rigid }, { "Similarity", MotionEnum::Similarity } },
                       "What a baseline may estimate; Rigid keeps the start's scale.");
  const auto defineBaseline = [](auto & type) {
    using MethodClass = typename std::decay_t<decltype(type)>::type;
    type.def(New<MethodClass>());
    DefineContourMethod(type);
    type
      .def(
        "SetMotion",
        [](MethodClass & self, MotionEnum motion) { self.SetMotion(motion); },
        py::arg("motion"),
        "Sets what may move: Rigid (shift and angle) or Similarity (the default, and scale).")
      .def(
        "GetMotion",
        [](const MethodClass & self) { return self.GetMotion(); },
        "Returns what may move: Rigid (shift and angle) or Similarity (the default, and scale).")
      .def("SetMaximumNumberOfIterations",
           &MethodClass::SetMaximumNumberOfIterations,
           py::arg("value"),
           "Sets the most iterations of a run.")
      .def("GetMaximumNumberOfIterations",
           &MethodClass::GetMaximumNumberOfIterations,
           "Returns the most iterations of a run.");
  };

  using ICPType = itk::IterativeClosestPointContourRegistrationMethod;
  ProcessClass<ICPType> icp(
    module, "IterativeClosestPointContourRegistrationMethod", "Iterative closest points between two contours.");
  defineBaseline(icp);
  icp
    .def("SetDirection",
         &ICPType::SetDirection,
         py::arg("direction"),
         "Sets whose points look for their nearest: FixedToMoving (the default), MovingToFixed or "
         "Symmetric.")
    .def("GetDirection",
         &ICPType::GetDirection,
         "Returns whose points look for their nearest: FixedToMoving (the default), MovingToFixed or "
         "Symmetric.")
    .dentalscrProperty(ICPType,
                       TrimmedFraction,
                       "the share of the pairs that is left out, in [0, 0.9]; 0 by default, which is plain ICP.")
    .dentalscrProperty(
      ICPType, Tolerance, "the move below which it ends, pixels of the fixed contour; 1e-4 by default.");

  using CPDType = itk::CoherentPointDriftContourRegistrationMethod;
  ProcessClass<CPDType> cpd(
    module, "CoherentPointDriftContourRegistrationMethod", "Coherent point drift between two contours.");
  defineBaseline(cpd);
  cpd
    .dentalscrProperty(
      CPDType, OutlierWeight, "the share of points that belong to nothing, in [0, 0.99]; 0 by default.")
    .dentalscrProperty(
      CPDType, Tolerance, "the move below which it ends, pixels of the fixed contour; 1e-3 by default.");

  using IntensityType = itk::IntensityRegistrationMethod;
  using MeasureEnum = itk::IntensityRegistrationEnums::Measure;
  BindEnum<MeasureEnum>(module,
                        "IntensityMeasure",
                        { { "MutualInformation", MeasureEnum::MutualInformation },
                          { "NormalizedCorrelation", MeasureEnum::NormalizedCorrelation },
                          { "GradientCorrelation", MeasureEnum::GradientCorrelation } },
                        "How two radiographs are compared.");
  ProcessClass<IntensityType> intensity(
    module, "IntensityRegistrationMethod", "Aligns a DRR with the radiograph by their grey values.");
  defineBaseline(intensity);
  intensity.def("_SetFixedImage", &IntensityType::SetFixedImage, py::arg("image"))
    .def("_SetMovingImage", &IntensityType::SetMovingImage, py::arg("image"))
    .def("SetMeasure",
         &IntensityType::SetMeasure,
         py::arg("measure"),
         "Sets the measure of likeness of the two images; MutualInformation by default.")
    .def("GetMeasure",
         &IntensityType::GetMeasure,
         "Returns the measure of likeness of the two images; MutualInformation by default.")
    .dentalscrProperty(IntensityType,
                       Margin,
                       "the free border of the region of interest, as a part of the tracing's larger extent; 0.15 "
                       "by default.");
}
} // namespace dentalscr

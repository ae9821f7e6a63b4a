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
#ifndef dentalscrContourMethod_h
#define dentalscrContourMethod_h

#include "dentalscrBinding.h"

#include "itkOptimizerParameters.h"
#include "itkSimilarity2DTransform.h"

#include <vector>

namespace dentalscr
{
inline itk::Similarity2DTransform<double>::Pointer
CopySimilarity(const itk::Similarity2DTransform<double> * transform)
{
  auto copy = itk::Similarity2DTransform<double>::New();
  copy->SetFixedParameters(transform->GetFixedParameters());
  copy->SetParameters(transform->GetParameters());
  return copy;
}

inline py::tuple
ParametersToTuple(const itk::OptimizerParameters<double> & parameters)
{
  return py::tuple(py::cast(std::vector<double>(parameters.begin(), parameters.end())));
}

/** What the registration of contours has in common, whatever the method. */
template <typename TMethod>
void
DefineContourMethod(ProcessClass<TMethod> & type)
{
  type.def("_SetFixedContour", &TMethod::SetFixedContour, py::arg("contour"))
    .def("_SetMovingContour", &TMethod::SetMovingContour, py::arg("contour"))
    .def(
      "_SetInitialTransform",
      [](TMethod & self, const itk::Similarity2DTransform<double> * transform) {
        if (transform == nullptr)
        {
          self.SetInitialTransformInput(nullptr);
        }
        else
        {
          self.SetInitialTransform(transform);
        }
      },
      py::arg("transform"))
    .def("_GetTransform", [](const TMethod & self) { return CopySimilarity(self.GetTransform()); })
    .def(
      "GetInitialParameters",
      [](const TMethod & self) { return ParametersToTuple(self.GetInitialParameters()); },
      "The start (scale, rad, px, px).")
    .def(
      "GetCurrentLevel", [](const TMethod & self) { return self.GetCurrentLevel(); }, "0 is the coarsest.")
    .def(
      "GetOptimizerIteration",
      [](const TMethod & self) { return self.GetOptimizerIteration(); },
      "Number of the current iteration, from 0.")
    .def(
      "GetMetricValue",
      [](const TMethod & self) { return self.GetMetricValue(); },
      "Value of the metric at the current iteration, pixels for the chamfer metrics.")
    .def(
      "GetOptimizerPosition",
      [](const TMethod & self) { return ParametersToTuple(self.GetOptimizerPosition()); },
      "Parameters of the transform: (scale, rad, px, px).")
    .def(
      "GetOptimizerStopConditionDescription",
      [](const TMethod & self) { return self.GetOptimizerStopConditionDescription(); },
      "Why the optimizer ended, in words.");
}

/** Parts of WrapRegistration(), in files of their own. */
void
WrapContourMetrics(py::module_ & module);
void
WrapBaselines(py::module_ & module);
} // namespace dentalscr

#endif

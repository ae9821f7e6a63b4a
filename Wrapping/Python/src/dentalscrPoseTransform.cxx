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
#include "dentalscrConversions.h"

#include "itkCephalometricPoseTransform.h"
#include "itkTransformFactory.h"

#include <sstream>

namespace dentalscr
{
namespace
{
using PoseTransformType = itk::CephalometricPoseTransform;
using BaseType = itk::TransformBaseTemplate<double>;

PoseTransformType::ParametersType
ToParameters(const std::vector<double> & values)
{
  PoseTransformType::ParametersType parameters(static_cast<unsigned int>(values.size()));
  std::copy(values.begin(), values.end(), parameters.begin());
  return parameters;
}

PoseTransformType::Pointer
Copy(const PoseTransformType & transform)
{
  return transform.Clone();
}

PoseTransformType::InputPointType
ToPoint(const DoubleArray & points, py::ssize_t row)
{
  PoseTransformType::InputPointType point;
  for (unsigned int d = 0; d < 3; ++d)
  {
    point[d] = points.at(row, d);
  }
  return point;
}
} // namespace

void
WrapPoseTransform(py::module_ & module)
{
  itk::TransformFactory<PoseTransformType>::RegisterTransform();
  py::class_<PoseTransformType, BaseType, itk::SmartPointer<PoseTransformType>>(
    module,
    "CephalometricPoseTransform",
    R"(Maps a point of the dental frame (mm) to the radiograph (continuous pixel index) under the seven parameters of a pose.

Parameters are (pitch, roll, yaw, tx, ty, tz, kappa): rad, mm, and the logarithm of the factor on the magnification.
Fixed parameters are the distances from the source to the midsagittal plane and to the detector (mm), the signs of the
source's side and of the facing, the pixel spacing (mm) and the principal point (px); SetGeometry() fills them.

Parameters
----------
geometry : CephalometricGeometry, optional
    With a pixel spacing; its pose is not taken.
parameters : seven numbers, optional)")
    .def(py::init([](const itk::CephalometricGeometry * geometry, const std::vector<double> & parameters) {
           auto transform = PoseTransformType::New();
           if (geometry != nullptr)
           {
             transform->SetGeometry(geometry);
           }
           if (!parameters.empty())
           {
             transform->SetParameters(ToParameters(parameters));
           }
           return transform;
         }),
         py::arg("geometry") = py::none(),
         py::arg("parameters") = std::vector<double>())
    .def(
      "SetParameters",
      [](PoseTransformType & self, const std::vector<double> & values) { self.SetParameters(ToParameters(values)); },
      py::arg("parameters"),
      "Sets the seven parameters: rotation (rad), translation (mm), kappa (the logarithm of the "
      "scale).")
    .def(
      "SetFixedParameters",
      [](PoseTransformType & self, const std::vector<double> & values) {
        self.SetFixedParameters(ToParameters(values));
      },
      py::arg("parameters"),
      "Sets the nine fixed parameters, the geometry; eight, as in older files, are those of a "
      "lateral radiograph.")
    .def("SetIdentity", &PoseTransformType::SetIdentity, "All seven parameters 0; the geometry stays.")
    .def("SetGeometry", &PoseTransformType::SetGeometry, py::arg("geometry"), "Copies it; its pose is not taken.")
    .def("CopyToGeometry",
         &PoseTransformType::CopyToGeometry,
         py::arg("geometry"),
         "Gives a geometry all of this transform; ProjectPoint(p) is TransformPoint(p) then.")
    .def(
      "SetParametersFromRotation",
      [](PoseTransformType &            self,
         const DoubleArray &            rotation,
         const itk::Vector<double, 3> & translation,
         double                         kappa) {
        if (rotation.ndim() != 2 || rotation.shape(0) != 3 || rotation.shape(1) != 3)
        {
          throw std::invalid_argument("a rotation is a 3 x 3 matrix");
        }
        PoseTransformType::RotationType matrix;
        for (unsigned int i = 0; i < 9; ++i)
        {
          matrix(i / 3, i % 3) = rotation.at(i / 3, i % 3);
        }
        self.SetParametersFromRotation(matrix, translation, kappa);
      },
      py::arg("rotation"),
      py::arg("translation"),
      py::arg("kappa") = 0.0,
      "c = rotation p + translation (mm), and kappa.")
    .def("GetRigidTransform", &PoseTransformType::GetRigidTransform, "Dental frame to cephalostat frame, mm.")
    .def_property_readonly(
      "matrix",
      [](const PoseTransformType & self) {
        std::vector<double> values(16, 0.0);
        const auto          rigid = self.GetRigidTransform();
        for (unsigned int row = 0; row < 3; ++row)
        {
          for (unsigned int column = 0; column < 3; ++column)
          {
            values[4 * row + column] = rigid->GetMatrix()(row, column);
          }
          values[4 * row + 3] = rigid->GetOffset()[row];
        }
        values.back() = 1.0;
        return MakeArray<double>(values, { 4, 4 });
      },
      "(4, 4), of the rigid part: dental frame to cephalostat frame, mm; a copy. The projection follows it, and so "
      "does the scale exp(kappa).")
    .def("GetScaleFactor", &PoseTransformType::GetScaleFactor, "exp(kappa).")
    .def(
      "TransformPoint",
      [](const PoseTransformType & self, const PoseTransformType::InputPointType & point) {
        return self.TransformPoint(point);
      },
      py::arg("point"),
      "Point of the dental frame (mm) to the continuous pixel index (u, v).")
    .def(
      "TransformPoints",
      [](const PoseTransformType & self, const DoubleArray & points) {
        if (points.ndim() != 2 || points.shape(1) != 3)
        {
          throw std::invalid_argument("points have the wrong shape; (N, 3) is needed");
        }
        std::vector<PoseTransformType::OutputPointType> result(static_cast<std::size_t>(points.shape(0)));
        for (std::size_t i = 0; i < result.size(); ++i)
        {
          result[i] = self.TransformPoint(ToPoint(points, static_cast<py::ssize_t>(i)));
        }
        return MakeRows<2>(result);
      },
      py::arg("points"),
      "All rows of an (N, 3) array: (N, 2).")
    .def(
      "ComputeJacobianWithRespectToParameters",
      [](const PoseTransformType & self, const PoseTransformType::InputPointType & point) {
        PoseTransformType::JacobianType jacobian;
        self.ComputeJacobianWithRespectToParameters(point, jacobian);
        return MatrixToArray(jacobian);
      },
      py::arg("point"),
      "(2, 7): pixels a rad, a mm and a unit of kappa.")
    .def(
      "ComputeJacobianWithRespectToPosition",
      [](const PoseTransformType & self, const PoseTransformType::InputPointType & point) {
        PoseTransformType::JacobianPositionType jacobian;
        self.ComputeJacobianWithRespectToPosition(point, jacobian);
        return MatrixToArray(jacobian);
      },
      py::arg("point"),
      "(2, 3): pixels a mm.")
    .def("__copy__", &Copy)
    .def(
      "__deepcopy__", [](const PoseTransformType & self, const py::dict &) { return Copy(self); }, py::arg("memo"))
    .def("__repr__",
         [](const PoseTransformType & self) {
           std::ostringstream text;
           text.precision(9);
           text << "<dentalscr.CephalometricPoseTransform parameters (";
           for (unsigned int i = 0; i < PoseTransformType::NumberOfParameters; ++i)
           {
             text << (i > 0 ? ", " : "") << self.GetParameters()[i];
           }
           text << ")>";
           return text.str();
         })
    .def(py::pickle(
      [](const PoseTransformType & self) {
        const auto & parameters = self.GetParameters();
        const auto & fixed = self.GetFixedParameters();
        return py::make_tuple(std::vector<double>(parameters.begin(), parameters.end()),
                              std::vector<double>(fixed.begin(), fixed.end()));
      },
      [](const py::tuple & state) {
        auto transform = PoseTransformType::New();
        // A spacing of 0 is a geometry that was not set yet.
        const auto fixed = state[1].cast<std::vector<double>>();
        if (fixed[PoseTransformType::PixelSpacingU] > 0.0)
        {
          transform->SetFixedParameters(ToParameters(fixed));
        }
        transform->SetParameters(ToParameters(state[0].cast<std::vector<double>>()));
        return transform;
      }));
}
} // namespace dentalscr

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
#include "dentalscrBinding.h"

#include "itkCephalometricPoseTransform.h"
#include "itkTransformFactory.h"

#include <sstream>

namespace dentalscr
{
namespace
{
using TransformType = itk::CephalometricPoseTransform;
using BaseType = itk::TransformBaseTemplate<double>;
using PointType = TransformType::InputPointType;

TransformType::ParametersType
ToParameters(const std::vector<double> & values)
{
  TransformType::ParametersType parameters(static_cast<unsigned int>(values.size()));
  std::copy(values.begin(), values.end(), parameters.begin());
  return parameters;
}

TransformType::Pointer
Copy(const TransformType & transform)
{
  return transform.Clone();
}

template <typename TMatrix>
py::array_t<double>
ToArray(const TMatrix & matrix)
{
  return MakeArray(std::vector<double>(matrix.begin(), matrix.end()),
                   { static_cast<py::ssize_t>(matrix.rows()), static_cast<py::ssize_t>(matrix.cols()) });
}

PointType
ToPoint(const DoubleArray & points, py::ssize_t row)
{
  PointType point;
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
  itk::TransformFactory<TransformType>::RegisterTransform();
  py::class_<TransformType, BaseType, itk::SmartPointer<TransformType>>(
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
           auto transform = TransformType::New();
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
      [](TransformType & self, const std::vector<double> & values) { self.SetParameters(ToParameters(values)); },
      py::arg("parameters"),
      "Sets the seven parameters: rotation (rad), translation (mm), kappa (the logarithm of the "
      "scale).")
    .def(
      "SetFixedParameters",
      [](TransformType & self, const std::vector<double> & values) { self.SetFixedParameters(ToParameters(values)); },
      py::arg("parameters"),
      "Sets the nine fixed parameters, the geometry; eight, as in older files, are those of a "
      "lateral radiograph.")
    .def("SetIdentity", &TransformType::SetIdentity, "All seven parameters 0; the geometry stays.")
    .def("SetGeometry", &TransformType::SetGeometry, py::arg("geometry"), "Copies it; its pose is not taken.")
    .def("CopyToGeometry",
         &TransformType::CopyToGeometry,
         py::arg("geometry"),
         "Gives a geometry all of this transform; ProjectPoint(p) is TransformPoint(p) then.")
    .def(
      "SetParametersFromRotation",
      [](TransformType & self, const DoubleArray & rotation, const itk::Vector<double, 3> & translation, double kappa) {
        if (rotation.ndim() != 2 || rotation.shape(0) != 3 || rotation.shape(1) != 3)
        {
          throw std::invalid_argument("a rotation is a 3 x 3 matrix");
        }
        TransformType::RotationType matrix;
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
    .def("GetRigidTransform", &TransformType::GetRigidTransform, "Dental frame to cephalostat frame, mm.")
    .def_property_readonly(
      "matrix",
      [](const TransformType & self) {
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
    .def("GetScaleFactor", &TransformType::GetScaleFactor, "exp(kappa).")
    .def(
      "TransformPoint",
      [](const TransformType & self, const PointType & point) { return self.TransformPoint(point); },
      py::arg("point"),
      "Point of the dental frame (mm) to the continuous pixel index (u, v).")
    .def(
      "TransformPoints",
      [](const TransformType & self, const DoubleArray & points) {
        if (points.ndim() != 2 || points.shape(1) != 3)
        {
          throw std::invalid_argument("points have the wrong shape; (N, 3) is needed");
        }
        std::vector<TransformType::OutputPointType> result(static_cast<std::size_t>(points.shape(0)));
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
      [](const TransformType & self, const PointType & point) {
        TransformType::JacobianType jacobian;
        self.ComputeJacobianWithRespectToParameters(point, jacobian);
        return ToArray(jacobian);
      },
      py::arg("point"),
      "(2, 7): pixels a rad, a mm and a unit of kappa.")
    .def(
      "ComputeJacobianWithRespectToPosition",
      [](const TransformType & self, const PointType & point) {
        TransformType::JacobianPositionType jacobian;
        self.ComputeJacobianWithRespectToPosition(point, jacobian);
        return ToArray(jacobian);
      },
      py::arg("point"),
      "(2, 3): pixels a mm.")
    .def("__copy__", &Copy)
    .def(
      "__deepcopy__", [](const TransformType & self, const py::dict &) { return Copy(self); }, py::arg("memo"))
    .def("__repr__",
         [](const TransformType & self) {
           std::ostringstream text;
           text.precision(9);
           text << "<dentalscr.CephalometricPoseTransform parameters (";
           for (unsigned int i = 0; i < TransformType::NumberOfParameters; ++i)
           {
             text << (i > 0 ? ", " : "") << self.GetParameters()[i];
           }
           text << ")>";
           return text.str();
         })
    .def(py::pickle(
      [](const TransformType & self) {
        const auto & parameters = self.GetParameters();
        const auto & fixed = self.GetFixedParameters();
        return py::make_tuple(std::vector<double>(parameters.begin(), parameters.end()),
                              std::vector<double>(fixed.begin(), fixed.end()));
      },
      [](const py::tuple & state) {
        auto transform = TransformType::New();
        // A spacing of 0 is a geometry that was not set yet.
        const auto fixed = state[1].cast<std::vector<double>>();
        if (fixed[TransformType::PixelSpacingU] > 0.0)
        {
          transform->SetFixedParameters(ToParameters(fixed));
        }
        transform->SetParameters(ToParameters(state[0].cast<std::vector<double>>()));
        return transform;
      }));
}
} // namespace dentalscr

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
#include "itkMemoryFile.h"
#include "itkReadTransformText.h"
#include "itkSimilarity2DTransform.h"
#include "itkTextFile.h"
#include "itkTransformFileReader.h"
#include "itkTransformFileWriter.h"
#include "itkVersorRigid3DTransform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace dentalscr
{
namespace
{
using SimilarityType = itk::Similarity2DTransform<double>;
using RigidType = itk::VersorRigid3DTransform<double>;
using BaseType = itk::TransformBaseTemplate<double>;

std::vector<double>
ToVector(const itk::OptimizerParameters<double> & parameters)
{
  return { parameters.begin(), parameters.end() };
}

/** What is no number would end the process where a matrix of it is inverted: VNL calls abort(). */
template <typename TValues>
const TValues &
Finite(const TValues & values)
{
  if (!std::all_of(std::begin(values), std::end(values), [](double value) { return std::isfinite(value); }))
  {
    throw std::invalid_argument("a transform is of finite numbers; one of these is NaN or infinite");
  }
  return values;
}

double
Finite(double value)
{
  Finite(std::array<double, 1>{ { value } });
  return value;
}

template <typename TTransform>
void
SetParameters(TTransform & self, const std::vector<double> & values, bool fixed)
{
  typename TTransform::ParametersType      parameters = self.GetParameters();
  typename TTransform::FixedParametersType fixedParameters = self.GetFixedParameters();
  const std::size_t                        count = fixed ? fixedParameters.size() : parameters.size();
  if (values.size() != count)
  {
    throw std::invalid_argument(std::string(self.GetNameOfClass()) + " has " + std::to_string(count) +
                                (fixed ? " fixed" : "") + " parameters, not " + std::to_string(values.size()));
  }
  Finite(values);
  if (fixed)
  {
    std::copy(values.begin(), values.end(), fixedParameters.begin());
    self.SetFixedParameters(fixedParameters);
  }
  else
  {
    std::copy(values.begin(), values.end(), parameters.begin());
    self.SetParameters(parameters);
  }
}

py::tuple
ToTuple(const std::vector<double> & values)
{
  return py::tuple(py::cast(values));
}

/** What the two transforms have in common. */
template <typename TTransform>
void
DefineTransform(py::class_<TTransform, BaseType, itk::SmartPointer<TTransform>> & type)
{
  constexpr unsigned int dimension = TTransform::InputSpaceDimension;
  using PointType = itk::Point<double, dimension>;
  type
    .def(
      "SetParameters",
      [](TTransform & self, const std::vector<double> & values) { SetParameters(self, values, false); },
      py::arg("parameters"),
      "Sets the parameters, in the order that ITK's transform of the same name has.")
    .def(
      "SetFixedParameters",
      [](TTransform & self, const std::vector<double> & values) { SetParameters(self, values, true); },
      py::arg("parameters"),
      "Sets the fixed parameters: the centre.")
    .def(
      "GetDimension", [](const TTransform &) { return dimension; }, "Number of axes of the points.")
    .def(
      "SetCenter",
      [](TTransform & self, const PointType & center) { self.SetCenter(Finite(center)); },
      py::arg("center"),
      "Sets the centre of rotation and scale, in the unit of the points.")
    .def(
      "GetCenter",
      [](const TTransform & self) { return PointType(self.GetCenter()); },
      "Returns the centre of rotation and scale, in the unit of the points.")
    .def(
      "SetTranslation",
      [](TTransform & self, const itk::Vector<double, dimension> & translation) {
        self.SetTranslation(Finite(translation));
      },
      py::arg("translation"),
      "Sets the translation, in the unit of the points.")
    .def(
      "GetTranslation",
      [](const TTransform & self) { return itk::Vector<double, dimension>(self.GetTranslation()); },
      "Returns the translation, in the unit of the points.")
    .def(
      "GetMatrix",
      [](const TTransform & self) {
        std::vector<double> values;
        for (unsigned int i = 0; i < dimension * dimension; ++i)
        {
          values.push_back(self.GetMatrix()(i / dimension, i % dimension));
        }
        return ToTuple(values);
      },
      "Row-major.")
    .def(
      "GetInverse",
      [](const TTransform & self) {
        auto inverse = TTransform::New();
        // Finite parameters may have products that are not.
        const auto & matrix = self.GetMatrix().GetVnlMatrix();
        if (!matrix.is_finite() || !self.GetInverse(inverse))
        {
          throw std::invalid_argument("the transform has no inverse");
        }
        return inverse;
      },
      "The inverse as a new transform of the same class.")
    .def(
      "TransformPoint",
      [](const TTransform & self, const PointType & point) { return PointType(self.TransformPoint(point)); },
      py::arg("point"),
      "The place that a point goes to, in the unit of the points.")
    .def(
      "TransformPoints",
      [](const TTransform & self, const DoubleArray & points) {
        if (points.ndim() != 2 || points.shape(1) != static_cast<py::ssize_t>(dimension))
        {
          throw std::invalid_argument("points have the wrong shape; (N, " + std::to_string(dimension) + ") is needed");
        }
        std::vector<PointType> result(static_cast<std::size_t>(points.shape(0)));
        for (std::size_t i = 0; i < result.size(); ++i)
        {
          PointType point;
          for (unsigned int d = 0; d < dimension; ++d)
          {
            point[d] = points.at(i, d);
          }
          result[i] = self.TransformPoint(point);
        }
        return MakeRows<dimension>(result);
      },
      py::arg("points"),
      "All rows of an array; a copy.")
    .def_property_readonly(
      "matrix",
      [](const TTransform & self) {
        std::vector<double> values((dimension + 1) * (dimension + 1), 0.0);
        for (unsigned int row = 0; row < dimension; ++row)
        {
          for (unsigned int column = 0; column < dimension; ++column)
          {
            values[row * (dimension + 1) + column] = self.GetMatrix()(row, column);
          }
          values[row * (dimension + 1) + dimension] = self.GetOffset()[row];
        }
        values.back() = 1.0;
        return MakeArray<double>(values, { dimension + 1, dimension + 1 });
      },
      "Homogeneous, for column vectors; a copy.")
    .def("__repr__",
         [](const TTransform & self) {
           std::ostringstream text;
           text.precision(9);
           text << "<dentalscr." << self.GetNameOfClass() << " parameters (";
           const auto parameters = ToVector(self.GetParameters());
           for (std::size_t i = 0; i < parameters.size(); ++i)
           {
             text << (i > 0 ? ", " : "") << parameters[i];
           }
           text << "), centre " << self.GetCenter() << ">";
           return text.str();
         })
    .def("__copy__",
         [](const TTransform & self) {
           auto copy = TTransform::New();
           copy->SetFixedParameters(self.GetFixedParameters());
           copy->SetParameters(self.GetParameters());
           return copy;
         })
    .def(
      "__deepcopy__",
      [](const TTransform & self, const py::dict &) {
        auto copy = TTransform::New();
        copy->SetFixedParameters(self.GetFixedParameters());
        copy->SetParameters(self.GetParameters());
        return copy;
      },
      py::arg("memo"))
    .def(py::pickle(
      [](const TTransform & self) {
        const auto & fixed = self.GetFixedParameters();
        return py::make_tuple(ToVector(self.GetParameters()), std::vector<double>(fixed.begin(), fixed.end()));
      },
      [](const py::tuple & state) {
        auto transform = TTransform::New();
        SetParameters(*transform, state[1].cast<std::vector<double>>(), true);
        SetParameters(*transform, state[0].cast<std::vector<double>>(), false);
        return transform;
      }));
}
} // namespace

void
WrapTransforms(py::module_ & module)
{
  py::class_<BaseType, itk::SmartPointer<BaseType>>(
    module, "Transform", "Maps points; which way is the maker's to say.")
    .def(
      "GetName", [](const BaseType & self) { return std::string(self.GetNameOfClass()); }, "Name of the class in C++.")
    .def(
      "GetParameters",
      [](const BaseType & self) { return ToTuple(ToVector(self.GetParameters())); },
      "The parameters, in the order that ITK's transform of the same name has.")
    .def(
      "GetFixedParameters",
      [](const BaseType & self) {
        const auto & fixed = self.GetFixedParameters();
        return ToTuple(std::vector<double>(fixed.begin(), fixed.end()));
      },
      "The fixed parameters.")
    .def(
      "GetNumberOfParameters",
      [](const BaseType & self) { return self.GetParameters().size(); },
      "How many parameters it has.")
    .def(
      "__eq__",
      [](const BaseType & self, const BaseType & other) {
        return self.GetTransformTypeAsString() == other.GetTransformTypeAsString() &&
               self.GetParameters() == other.GetParameters() && self.GetFixedParameters() == other.GetFixedParameters();
      },
      py::is_operator());

  py::class_<SimilarityType, BaseType, itk::SmartPointer<SimilarityType>> similarity(
    module,
    "Similarity2DTransform",
    R"(p = scale R(angle) (q - center) + center + translation, in the plane.

Parameters are (scale, angle, tx, ty), fixed parameters the centre, as in SimpleITK. A registration's result maps the
moving contour to the fixed one.

Parameters
----------
scale : float, optional
angle : float, optional
    Radians, from u towards v.
translation, center : pair of numbers, optional)");
  similarity
    .def(py::init([](double                         scale,
                     double                         angle,
                     const itk::Vector<double, 2> & translation,
                     const itk::Point<double, 2> &  center) {
           auto transform = SimilarityType::New();
           transform->SetCenter(Finite(center));
           transform->SetScale(Finite(scale));
           transform->SetAngle(Finite(angle));
           transform->SetTranslation(Finite(translation));
           return transform;
         }),
         py::arg("scale") = 1.0,
         py::arg("angle") = 0.0,
         py::arg("translation") = itk::Vector<double, 2>(0.0),
         py::arg("center") = itk::Point<double, 2>(0.0))
    .def(
      "SetScale",
      [](SimilarityType & self, double scale) { self.SetScale(Finite(scale)); },
      py::arg("scale"),
      "Sets the scale factor, no unit.")
    .def(
      "GetScale", [](const SimilarityType & self) { return self.GetScale(); }, "Returns the scale factor, no unit.")
    .def(
      "SetAngle",
      [](SimilarityType & self, double angle) { self.SetAngle(Finite(angle)); },
      py::arg("angle"),
      "Sets the angle of rotation, rad.")
    .def(
      "GetAngle", [](const SimilarityType & self) { return self.GetAngle(); }, "Returns the angle of rotation, rad.");
  DefineTransform(similarity);

  py::class_<RigidType, BaseType, itk::SmartPointer<RigidType>> rigid(
    module,
    "VersorRigid3DTransform",
    R"(A rigid motion of space: three versor parameters and three of translation, as in SimpleITK.

Parameters
----------
matrix : (4, 4) or (3, 4) array, optional
    A rigid motion to begin with.)");
  rigid.def(py::init([](const py::object & matrix) {
              auto transform = RigidType::New();
              if (!matrix.is_none())
              {
                const auto values = matrix.cast<DoubleArray>();
                if (values.ndim() != 2 || values.shape(0) < 3 || values.shape(0) > 4 || values.shape(1) != 4)
                {
                  throw std::invalid_argument("a rigid motion is a 4 x 4 or 3 x 4 matrix");
                }
                RigidType::MatrixType       rotation;
                RigidType::OutputVectorType translation;
                for (unsigned int row = 0; row < 3; ++row)
                {
                  for (unsigned int column = 0; column < 3; ++column)
                  {
                    rotation(row, column) = Finite(values.at(row, column));
                  }
                  translation[row] = Finite(values.at(row, 3));
                }
                transform->SetMatrix(rotation);
                transform->SetTranslation(translation);
              }
              return transform;
            }),
            py::arg("matrix") = py::none());
  DefineTransform(rigid);

  module.def(
    "ReadTransform",
    [](const std::string & fileName) {
      BaseType::Pointer            transform;
      const py::gil_scoped_release released;
      auto                         reader = itk::TransformFileReaderTemplate<double>::New();
      // What ITK reads has been looked at; it tells the format by the extension.
      const std::string     text = itk::ReadTransformText(fileName);
      const itk::MemoryFile memory(".tfm");
      std::ofstream(memory.GetName(), std::ios::binary) << text;
      reader->SetFileName(memory.GetName());
      reader->Update();
      if (reader->GetTransformList()->empty())
      {
        throw std::invalid_argument(fileName + " holds no transform");
      }
      transform = reader->GetTransformList()->front().GetPointer();
      if (dynamic_cast<SimilarityType *>(transform.GetPointer()) == nullptr &&
          dynamic_cast<RigidType *>(transform.GetPointer()) == nullptr &&
          dynamic_cast<itk::CephalometricPoseTransform *>(transform.GetPointer()) == nullptr)
      {
        throw std::invalid_argument(
          fileName + " holds a " + transform->GetNameOfClass() +
          "; Similarity2DTransform, VersorRigid3DTransform and CephalometricPoseTransform are read");
      }
      return transform;
    },
    py::arg("fileName"),
    "Reads a transform of any kind that the package knows from an ITK transform file (.tfm, "
    ".txt).");
  module.def(
    "WriteTransform",
    [](const BaseType & transform, const std::string & fileName) {
      const py::gil_scoped_release released;
      // ITK doesn't notice a full disk; the extension tells it the format.
      const itk::MemoryFile memory(std::filesystem::path(fileName).extension().string());
      auto                  writer = itk::TransformFileWriterTemplate<double>::New();
      writer->SetFileName(memory.GetName());
      writer->SetInput(&transform);
      writer->Update();
      itk::WriteFileAtomically(fileName, memory.GetContent());
    },
    py::arg("transform"),
    py::arg("fileName"),
    "Writes a transform to an ITK transform file (.tfm, .txt).");
}
} // namespace dentalscr

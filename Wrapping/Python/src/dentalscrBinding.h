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
#ifndef dentalscrBinding_h
#define dentalscrBinding_h

#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "itkContinuousIndex.h"
#include "itkFixedArray.h"
#include "itkImage.h"
#include "itkLowerCase.h"
#include "itkMesh.h"
#include "itkPoint.h"
#include "itkProcessObject.h"
#include "itkRGBPixel.h"
#include "itkSize.h"
#include "itkSmartPointer.h"
#include "itkVector.h"

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

PYBIND11_DECLARE_HOLDER_TYPE(T, itk::SmartPointer<T>, true)

namespace pybind11
{
namespace detail
{
template <typename T>
struct holder_helper<itk::SmartPointer<T>>
{
  static T *
  get(const itk::SmartPointer<T> & pointer)
  {
    return pointer.GetPointer();
  }
};

/** ITK's small fixed vectors: from any sequence of numbers, to a tuple. */
template <typename TArray, typename TValue, unsigned int VLength>
struct fixed_sequence_caster
{
  static_assert(VLength == 2 || VLength == 3, "Points and vectors of the plane and of space.");
  PYBIND11_TYPE_CASTER(TArray,
                       const_name<std::is_integral<TValue>::value>(
                         const_name<VLength == 2>(const_name("Tuple[int, int]"), const_name("Tuple[int, int, int]")),
                         const_name<VLength == 2>(const_name("Tuple[float, float]"),
                                                  const_name("Tuple[float, float, float]"))));

  bool
  load(handle source, bool)
  {
    if (!PySequence_Check(source.ptr()) || PyUnicode_Check(source.ptr()))
    {
      return false;
    }
    const Py_ssize_t length = PySequence_Size(source.ptr());
    if (length != static_cast<Py_ssize_t>(VLength))
    {
      PyErr_Clear();
      return false;
    }
    for (unsigned int i = 0; i < VLength; ++i)
    {
      const auto          item = reinterpret_steal<object>(PySequence_GetItem(source.ptr(), i));
      make_caster<TValue> element;
      if (!item || !element.load(item, true))
      {
        PyErr_Clear();
        return false;
      }
      value[i] = cast_op<TValue>(element);
    }
    return true;
  }

  static handle
  cast(const TArray & array, return_value_policy, handle)
  {
    tuple result(VLength);
    for (unsigned int i = 0; i < VLength; ++i)
    {
      result[i] = pybind11::cast(static_cast<TValue>(array[i]));
    }
    return result.release();
  }
};

template <unsigned int VLength>
struct type_caster<itk::Point<double, VLength>> : fixed_sequence_caster<itk::Point<double, VLength>, double, VLength>
{};
template <unsigned int VLength>
struct type_caster<itk::Vector<double, VLength>> : fixed_sequence_caster<itk::Vector<double, VLength>, double, VLength>
{};
template <unsigned int VLength>
struct type_caster<itk::FixedArray<double, VLength>>
  : fixed_sequence_caster<itk::FixedArray<double, VLength>, double, VLength>
{};
template <unsigned int VLength>
struct type_caster<itk::ContinuousIndex<double, VLength>>
  : fixed_sequence_caster<itk::ContinuousIndex<double, VLength>, double, VLength>
{};
template <unsigned int VLength>
struct type_caster<itk::Size<VLength>> : fixed_sequence_caster<itk::Size<VLength>, std::size_t, VLength>
{};
template <unsigned int VLength>
struct type_caster<itk::Index<VLength>> : fixed_sequence_caster<itk::Index<VLength>, std::ptrdiff_t, VLength>
{};
} // namespace detail
} // namespace pybind11

namespace dentalscr
{
namespace py = pybind11;

using MeshType = itk::Mesh<float, 3>;
using ImageType = itk::Image<float, 2>;
using PictureType = itk::Image<itk::RGBPixel<unsigned char>, 2>;

using DoubleArray = py::array_t<double, py::array::c_style | py::array::forcecast>;
using FloatArray = py::array_t<float, py::array::c_style | py::array::forcecast>;

/** Base that Python sees of every process object: what a class needs beside its own members. */
template <typename T>
using ProcessClass = py::class_<T, itk::ProcessObject, itk::SmartPointer<T>>;

/** Makes an object by New(), as a constructor without arguments. */
template <typename T>
auto
New()
{
  return py::init([]() {
    typename T::Pointer object = T::New();
    return object;
  });
}

/** Brings a process object up to date with the interpreter released: commands run with it taken, a Python exception in
 * one of them (or Ctrl-C) ends the run and comes out unchanged. */
void
Run(itk::ProcessObject * process, const std::function<void()> & body);
inline void
Run(itk::ProcessObject * process)
{
  Run(process, [process]() { process->Update(); });
}

/** Calls _InvokeCommand(key) of the owner, a Python object that it does not keep alive, at an event of an object; the
 * events have SimpleITK's numbers. Returns the observer's tag. */
unsigned long
AddPythonCommand(itk::Object & object, const py::object & owner, int event, unsigned long key);

/** An array that owns its values. */
template <typename T>
py::array_t<T>
MakeArray(const std::vector<T> & values, std::vector<py::ssize_t> shape = {})
{
  if (shape.empty())
  {
    shape.push_back(static_cast<py::ssize_t>(values.size()));
  }
  py::array_t<T> array(shape);
  std::copy(values.begin(), values.end(), array.mutable_data());
  return array;
}

/** Rows of VColumns numbers from arrays, points and vectors. */
template <std::size_t VColumns, typename TContainer>
py::array_t<double>
MakeRows(const TContainer & rows)
{
  py::array_t<double> array({ static_cast<py::ssize_t>(rows.size()), static_cast<py::ssize_t>(VColumns) });
  double *            out = array.mutable_data();
  for (const auto & row : rows)
  {
    for (std::size_t i = 0; i < VColumns; ++i)
    {
      *out++ = static_cast<double>(row[i]);
    }
  }
  return array;
}

/** A 3x4 row-major matrix as an array. */
inline py::array_t<double>
MakeMatrix34(const std::array<double, 12> & matrix)
{
  return MakeArray<double>(std::vector<double>(matrix.begin(), matrix.end()), { 3, 4 });
}

/** A rigid 3x4 as a 4x4. */
inline py::array_t<double>
MakeMatrix44(const std::array<double, 12> & matrix)
{
  std::vector<double> values(matrix.begin(), matrix.end());
  values.insert(values.end(), { 0.0, 0.0, 0.0, 1.0 });
  return MakeArray<double>(values, { 4, 4 });
}

/** Binds an enumeration; a value may also be given by its name, in any case: "upper" for Jaw.Upper. */
template <typename E>
py::enum_<E>
BindEnum(py::handle scope, const char * name, const std::vector<std::pair<const char *, E>> & values, const char * doc)
{
  py::enum_<E> type(scope, name, doc);
  for (const auto & value : values)
  {
    type.value(value.first, value.second);
  }
  const std::string typeName = name;
  // pybind11 gives these no words.
  type.def_property_readonly(
    "value", [](E value) { return static_cast<int>(value); }, "The value as a number.");
  type.def(py::init([values, typeName](const std::string & text) {
             std::string all;
             for (const auto & value : values)
             {
               const std::string candidate = value.first;
               if (itk::LowerCase(candidate) == itk::LowerCase(text))
               {
                 return value.second;
               }
               all += (all.empty() ? "" : ", ") + candidate;
             }
             throw std::invalid_argument("\"" + text + "\" is no " + typeName + "; use one of " + all);
           }),
           py::arg("name"));
  py::implicitly_convertible<py::str, E>();
  return type;
}

void
WrapErrors(py::module_ & module);
void
WrapData(py::module_ & module);
void
WrapTransforms(py::module_ & module);
void
WrapGeometry(py::module_ & module);
void
WrapProcessObject(py::module_ & module);
void
WrapInputOutput(py::module_ & module);
void
WrapFilters(py::module_ & module);
void
WrapRegistration(py::module_ & module);
void
WrapPoseTransform(py::module_ & module);
void
WrapPoseMetrics(py::module_ & module);
void
WrapPoseRegistration(py::module_ & module);
void
WrapEvaluation(py::module_ & module);
void
WrapPhantom(py::module_ & module);
void
WrapCase(py::module_ & module);
void
WrapExperiment(py::module_ & module);
} // namespace dentalscr

/** Set and Get of a member under one name. What is set is said in words that follow "Sets" and "Returns": "the width of
 * the splats, mm; 0.5 by default.", and of a switch "whether ...". */
#define dentalscrProperty(T, name, words) \
  def("Set" #name, &T::Set##name, py::arg("value"), "Sets " words).def("Get" #name, &T::Get##name, "Returns " words)
/** The same with On and Off. */
#define dentalscrBoolean(T, name, words)                                             \
  dentalscrProperty(T, name, words)                                                  \
    .def(#name "On", &T::name##On, "The same as Set" #name "(True). It sets " words) \
    .def(#name "Off", &T::name##Off, "The same as Set" #name "(False). It sets " words)

#endif

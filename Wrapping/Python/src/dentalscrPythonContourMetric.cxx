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
#include "dentalscrPythonContourMetric.h"

#include <algorithm>
#include <cmath>

namespace dentalscr
{
void
PythonContourMetric::SetFunction(const py::function & function)
{
  m_Function = function;
  this->Modified();
}

PythonContourMetric::~PythonContourMetric()
{
  if (Py_IsInitialized())
  {
    const py::gil_scoped_acquire interpreter;
    m_Function = py::object();
  }
  else
  {
    m_Function.release();
  }
}

void
PythonContourMetric::PrintSelf(std::ostream & os, itk::Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Fixed: " << m_Fixed.size() / 2 << " points" << std::endl;
  os << indent << "Moving: " << m_Moving.size() / 2 << " points" << std::endl;
}

void
PythonContourMetric::InitializeContours(const itk::ContourArrays & fixed, const itk::ContourArrays & moving)
{
  m_Fixed = fixed.points;
  m_Moving = moving.points;
}

double
PythonContourMetric::Call(const itk::ContourSimilarity & similarity, std::vector<double> * derivatives) const
{
  const double                 c = similarity.scale * std::cos(similarity.angle);
  const double                 s = similarity.scale * std::sin(similarity.angle);
  const py::gil_scoped_acquire interpreter;
  const auto                   count = static_cast<py::ssize_t>(m_Moving.size() / 2);
  py::array_t<double>          moved({ count, py::ssize_t{ 2 } });
  double *                     out = moved.mutable_data();
  for (py::ssize_t i = 0; i < count; ++i)
  {
    const double x = m_Moving[2 * i];
    const double y = m_Moving[2 * i + 1];
    out[2 * i] = c * x - s * y + similarity.tx;
    out[2 * i + 1] = s * x + c * y + similarity.ty;
  }
  const auto       fixed = MakeArray(m_Fixed, { static_cast<py::ssize_t>(m_Fixed.size() / 2), 2 });
  const py::object result = m_Function(fixed, moved);
  const auto       toNumber = [](const py::object & object) {
    double value = 0.0;
    try
    {
      value = object.cast<double>();
    }
    catch (const py::cast_error &)
    {
      throw py::type_error("a metric returns a number, or a number and derivatives, not " +
                           py::repr(object).cast<std::string>());
    }
    if (!std::isfinite(value))
    {
      throw py::value_error("a metric returned " + std::to_string(value) +
                            "; give a finite value for every place of the contour, a large one where it is bad");
    }
    return value;
  };
  if (!py::isinstance<py::tuple>(result))
  {
    return toNumber(result);
  }
  const auto pair = result.cast<py::tuple>();
  if (pair.size() != 2)
  {
    throw py::value_error("a metric returns a value, or a value and its derivatives by the moved points");
  }
  if (derivatives != nullptr)
  {
    const auto array = pair[1].cast<DoubleArray>();
    if (array.ndim() != 2 || array.shape(0) != count || array.shape(1) != 2)
    {
      throw py::value_error("a metric's derivatives have the shape of the moved points, (" + std::to_string(count) +
                            ", 2)");
    }
    if (!std::all_of(array.data(), array.data() + array.size(), [](double d) { return std::isfinite(d); }))
    {
      throw py::value_error("a metric's derivatives are finite numbers; return the value alone to have them estimated");
    }
    derivatives->assign(array.data(), array.data() + array.size());
  }
  return toNumber(pair[0]);
}

auto
PythonContourMetric::ComputeValue(const itk::ContourSimilarity &            similarity,
                                  itk::ContourChamferKernel::GradientType * gradient) const -> MeasureType
{
  if (gradient == nullptr)
  {
    return this->Call(similarity, nullptr);
  }
  std::vector<double> derivatives;
  const double        value = this->Call(similarity, &derivatives);
  gradient->fill(0.0);
  if (!derivatives.empty())
  {
    // p = s R q + t, by the chain rule.
    const double c = std::cos(similarity.angle);
    const double s = std::sin(similarity.angle);
    for (std::size_t i = 0; i < derivatives.size(); i += 2)
    {
      const double x = c * m_Moving[i] - s * m_Moving[i + 1];
      const double y = s * m_Moving[i] + c * m_Moving[i + 1];
      (*gradient)[0] += derivatives[i] * x + derivatives[i + 1] * y;
      (*gradient)[1] += similarity.scale * (derivatives[i + 1] * x - derivatives[i] * y);
      (*gradient)[2] += derivatives[i];
      (*gradient)[3] += derivatives[i + 1];
    }
    return value;
  }
  // Steps that move no point by more than a thousandth of a pixel.
  double reach = 1.0;
  for (std::size_t i = 0; i < m_Moving.size(); i += 2)
  {
    reach = std::max(reach, std::hypot(m_Moving[i], m_Moving[i + 1]));
  }
  const double steps[4] = { 1e-3 / reach, 1e-3 / (reach * similarity.scale), 1e-3, 1e-3 };
  for (unsigned int i = 0; i < 4; ++i)
  {
    itk::ContourSimilarity low = similarity;
    itk::ContourSimilarity high = similarity;
    double * const         lowValue[4] = { &low.scale, &low.angle, &low.tx, &low.ty };
    double * const         highValue[4] = { &high.scale, &high.angle, &high.tx, &high.ty };
    *lowValue[i] -= steps[i];
    *highValue[i] += steps[i];
    (*gradient)[i] = (this->Call(high, nullptr) - this->Call(low, nullptr)) / (2.0 * steps[i]);
  }
  return value;
}
} // namespace dentalscr

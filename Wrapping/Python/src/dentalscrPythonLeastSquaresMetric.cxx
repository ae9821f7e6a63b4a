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
#include "dentalscrPythonLeastSquaresMetric.h"

#include "itkPoseStateBlocks.h"

#include <algorithm>
#include <cmath>

namespace dentalscr
{
namespace
{
using BlockType = itk::RegistrationState::BlockType;

BlockType
ToBlock(const py::handle & item)
{
  if (!py::isinstance<py::str>(item))
  {
    try
    {
      return item.cast<BlockType>();
    }
    catch (const py::cast_error &)
    {
      throw py::type_error("blocks() gives names (\"pose\", \"scale\") or StateBlock objects, not " +
                           py::repr(item).cast<std::string>());
    }
  }
  const auto name = item.cast<std::string>();
  if (name == "pose")
  {
    return itk::PoseStateBlocks::MakePose();
  }
  if (name == "scale")
  {
    return itk::PoseStateBlocks::MakeScale();
  }
  throw py::value_error("there is no standard block \"" + name +
                        "\", only \"pose\" and \"scale\"; make a block of your own with StateBlock()");
}

void
CheckFinite(const DoubleArray & array, const char * what)
{
  if (!std::all_of(array.data(), array.data() + array.size(), [](double value) { return std::isfinite(value); }))
  {
    throw py::value_error(std::string(what) +
                          " are finite numbers for every place; give large residuals where a place is bad");
  }
}

DoubleArray
ToArray(const py::object & object, const char * what)
{
  auto array = DoubleArray::ensure(object);
  if (!array)
  {
    throw py::type_error(std::string(what) + " are an array of numbers, not " + py::repr(object).cast<std::string>());
  }
  return array;
}

/** The metric of a wrapper, or null: the collector may come before the constructor has run. */
PythonLeastSquaresMetric *
FindMetric(PyObject * self)
{
  auto holder = reinterpret_cast<py::detail::instance *>(self)->get_value_and_holder();
  return holder.holder_constructed() ? holder.value_ptr<PythonLeastSquaresMetric>() : nullptr;
}
} // namespace

PythonLeastSquaresMetric::~PythonLeastSquaresMetric()
{
  if (Py_IsInitialized())
  {
    const py::gil_scoped_acquire interpreter;
    m_Object = py::object();
  }
  else
  {
    m_Object.release();
  }
}

void
PythonLeastSquaresMetric::Bind(const py::object & object)
{
  m_Object = object;
}

void
PythonLeastSquaresMetric::SetupType(PyHeapTypeObject * heapType)
{
  PyTypeObject * type = &heapType->ht_type;
  type->tp_flags |= Py_TPFLAGS_HAVE_GC;
  type->tp_traverse = [](PyObject * self, visitproc visit, void * arg) {
#if PY_VERSION_HEX >= 0x03090000
    Py_VISIT(Py_TYPE(self));
#endif
    const Self * metric = FindMetric(self);
    // Held by a sum or a registration as well, the metric needs its object whatever Python does.
    if (metric != nullptr && metric->GetReferenceCount() == 1)
    {
      Py_VISIT(metric->m_Object.ptr());
    }
    return 0;
  };
  type->tp_clear = [](PyObject * self) {
    if (Self * metric = FindMetric(self))
    {
      metric->m_Object = py::object();
    }
    return 0;
  };
}

const py::object &
PythonLeastSquaresMetric::GetObject() const
{
  if (!m_Object)
  {
    throw std::runtime_error(
      "a LeastSquaresMetric lacks its Python object: call super().__init__() in your __init__()");
  }
  return m_Object;
}

auto
PythonLeastSquaresMetric::DeclareBlocks() const -> BlocksType
{
  if (!m_Blocks)
  {
    const py::gil_scoped_acquire interpreter;
    const py::object             given = this->GetObject().attr("blocks")();
    BlocksType                   blocks;
    if (py::isinstance<py::str>(given) || py::isinstance<BlockType>(given))
    {
      blocks.push_back(ToBlock(given));
    }
    else
    {
      for (const py::handle item : given)
      {
        blocks.push_back(ToBlock(item));
      }
    }
    m_Blocks = std::move(blocks);
  }
  return *m_Blocks;
}

py::dict
PythonLeastSquaresMetric::MakeValues(const PositionType & x) const
{
  py::dict values;
  auto     next = x.begin();
  for (const BlockType & block : this->DeclareBlocks())
  {
    const auto end = next + static_cast<std::ptrdiff_t>(block.parameters.size());
    values[py::str(block.name)] = MakeArray(std::vector<double>(next, end));
    next = end;
  }
  return values;
}

void
PythonLeastSquaresMetric::CallResiduals(const PositionType & x, VectorType & residuals) const
{
  const auto array = ToArray(this->GetObject().attr("residuals")(this->MakeValues(x)), "residuals");
  if (array.ndim() > 1)
  {
    throw py::value_error("residuals are an array of one dimension, not of " + std::to_string(array.ndim()));
  }
  CheckFinite(array, "residuals");
  if (!m_Count)
  {
    m_Count = array.size();
  }
  if (array.size() != *m_Count)
  {
    throw py::value_error("residuals() gave " + std::to_string(*m_Count) + " residuals before and gives " +
                          std::to_string(array.size()) +
                          " now; their number stays the same, one that does not count is 0");
  }
  residuals.set_size(static_cast<unsigned int>(array.size()));
  std::copy(array.data(), array.data() + array.size(), residuals.begin());
}

bool
PythonLeastSquaresMetric::CallJacobian(const PositionType & x, MatrixType & jacobian) const
{
  const py::object given = this->GetObject().attr("jacobian")(this->MakeValues(x));
  if (given.is_none())
  {
    return false;
  }
  const auto   rows = static_cast<unsigned int>(*m_Count);
  unsigned int first = 0;
  jacobian.set_size(rows, static_cast<unsigned int>(x.size()));
  jacobian.fill(0.0);
  const auto fill = [&](const py::object & object, std::size_t columns, const std::string & what) {
    const auto array = ToArray(object, "a metric's derivatives");
    if (array.ndim() != 2 || array.shape(0) != *m_Count || array.shape(1) != static_cast<py::ssize_t>(columns))
    {
      throw py::value_error("jacobian() has a row a residual and a column a parameter, (" + std::to_string(rows) +
                            ", " + std::to_string(columns) + ") for " + what);
    }
    CheckFinite(array, "a metric's derivatives");
    for (unsigned int i = 0; i < rows; ++i)
    {
      for (unsigned int k = 0; k < columns; ++k)
      {
        jacobian(i, first + k) = array.at(i, k);
      }
    }
  };
  if (!py::isinstance<py::dict>(given))
  {
    fill(given, x.size(), "all blocks one beside the other");
    return true;
  }
  const auto  parts = given.cast<py::dict>();
  std::size_t used = 0;
  for (const BlockType & block : this->DeclareBlocks())
  {
    if (parts.contains(block.name))
    {
      fill(parts[py::str(block.name)], block.parameters.size(), "block \"" + block.name + '"');
      ++used;
    }
    first += static_cast<unsigned int>(block.parameters.size());
  }
  if (used != parts.size())
  {
    throw py::value_error("jacobian() has derivatives by a block that blocks() does not name");
  }
  return true;
}

itk::SizeValueType
PythonLeastSquaresMetric::GetNumberOfResiduals() const
{
  if (!m_Count)
  {
    const py::gil_scoped_acquire interpreter;
    VectorType                   residuals;
    this->CallResiduals(this->GetState().GetValues(), residuals);
  }
  return static_cast<itk::SizeValueType>(*m_Count);
}

void
PythonLeastSquaresMetric::ComputeResiduals(const PositionType & x, VectorType & residuals, MatrixType * jacobian) const
{
  const py::gil_scoped_acquire interpreter;
  this->CallResiduals(x, residuals);
  if (jacobian != nullptr && !this->CallJacobian(x, *jacobian))
  {
    this->ComputeJacobianByDifferences(x, *jacobian);
  }
}

void
PythonLeastSquaresMetric::InitializeTerm()
{
  m_Count.reset();
}

itk::LightObject::Pointer
PythonLeastSquaresMetric::InternalClone() const
{
  auto clone = Self::New();
  {
    const py::gil_scoped_acquire interpreter;
    clone->m_Object = m_Object;
  }
  clone->m_Blocks = m_Blocks;
  clone->m_Count = m_Count;
  clone->CopyState(*this);
  return clone.GetPointer();
}

void
PythonLeastSquaresMetric::PrintSelf(std::ostream & os, itk::Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  const py::gil_scoped_acquire interpreter;
  os << indent << "Object: " << (m_Object ? py::repr(m_Object).cast<std::string>() : "(none)") << std::endl;
  os << indent << "Blocks: " << (m_Blocks ? m_Blocks->size() : 0) << std::endl;
  os << indent << "Residuals: " << (m_Count ? *m_Count : 0) << std::endl;
}
} // namespace dentalscr

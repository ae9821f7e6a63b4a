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
#ifndef dentalscrPythonLeastSquaresMetric_h
#define dentalscrPythonLeastSquaresMetric_h

#include "dentalscrPoseRegistration.h"

#include <optional>

namespace dentalscr
{
/** \class PythonLeastSquaresMetric
 * \brief A term whose blocks, residuals and, if it has them, derivatives are those of a Python object.
 *
 * The object is an instance of dentalscr.LeastSquaresMetric, which wraps the metric and is known to it by Bind(). The
 * two hold each other: while nothing but the wrapper holds the metric, Python's garbage collector sees that cycle
 * (SetupType()); otherwise the object lives as long as the metric. Clones share the object. The interpreter is taken
 * for each call, in whatever thread it is made; an exception in a call comes out of what runs unchanged. */
class PythonLeastSquaresMetric : public itk::LeastSquaresMetricv4
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(PythonLeastSquaresMetric);

  using Self = PythonLeastSquaresMetric;
  using Superclass = itk::LeastSquaresMetricv4;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(PythonLeastSquaresMetric, LeastSquaresMetricv4);

  /** The object with blocks(), residuals(values) and jacobian(values). */
  void
  Bind(const py::object & object);

  /** For pybind11: lets the garbage collector look into the wrapper. */
  static void
  SetupType(PyHeapTypeObject * heapType);

  BlocksType
  DeclareBlocks() const override;
  itk::SizeValueType
  GetNumberOfResiduals() const override;
  void
  ComputeResiduals(const PositionType & x, VectorType & residuals, MatrixType * jacobian) const override;

protected:
  PythonLeastSquaresMetric() = default;
  ~PythonLeastSquaresMetric() override;
  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override;
  void
  InitializeTerm() override;
  itk::LightObject::Pointer
  InternalClone() const override;

private:
  /** With the interpreter taken; throws where the object is gone. */
  const py::object &
  GetObject() const;
  py::dict
  MakeValues(const PositionType & x) const;
  void
  CallResiduals(const PositionType & x, VectorType & residuals) const;
  /** False where the object has no derivatives. */
  bool
  CallJacobian(const PositionType & x, MatrixType & jacobian) const;

  py::object m_Object;
  /** Asked for once: what a metric reads does not change. */
  mutable std::optional<BlocksType> m_Blocks;
  /** Since the last Initialize(). */
  mutable std::optional<py::ssize_t> m_Count;
};
} // namespace dentalscr

#endif

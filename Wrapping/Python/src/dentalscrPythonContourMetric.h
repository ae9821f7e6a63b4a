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
#ifndef dentalscrPythonContourMetric_h
#define dentalscrPythonContourMetric_h

#include "dentalscrBinding.h"

#include "itkContourToContourMetricv4.h"

namespace dentalscr
{
/** \class PythonContourMetric
 * \brief A metric whose value is a Python callable's: f(fixed, moved) of two (N, 2) arrays, pixels of the radiograph.
 *
 * `moved` is the moving contour under the similarity that is tried. The callable returns the value, or the value and
 * its derivatives by the moved points, (M, 2); without them the gradient is found by central differences. The
 * interpreter is taken for each call; an exception in it comes out of the registration unchanged. */
class PythonContourMetric : public itk::ContourToContourMetricv4
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(PythonContourMetric);

  using Self = PythonContourMetric;
  using Superclass = itk::ContourToContourMetricv4;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(PythonContourMetric, ContourToContourMetricv4);

  void
  SetFunction(const py::function & function);

protected:
  PythonContourMetric() = default;
  ~PythonContourMetric() override;

  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override;

  void
  InitializeContours(const itk::ContourArrays & fixed, const itk::ContourArrays & moving) override;

  MeasureType
  ComputeValue(const itk::ContourSimilarity &            similarity,
               itk::ContourChamferKernel::GradientType * gradient) const override;

private:
  double
  Call(const itk::ContourSimilarity & similarity, std::vector<double> * derivatives) const;

  py::object          m_Function;
  std::vector<double> m_Fixed;
  std::vector<double> m_Moving;
};
} // namespace dentalscr

#endif

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
#ifndef itkCurveFitMetric_h
#define itkCurveFitMetric_h

#include "itkLeastSquaresMetricv4.h"

#include <cmath>
#include <string>
#include <vector>

/** A metric as a user writes one, in as few lines as that takes: points beside a curve a exp(b t), without derivatives
 * of its own. */
class CurveFitMetric : public itk::LeastSquaresMetricv4
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(CurveFitMetric);

  using Self = CurveFitMetric;
  using Superclass = itk::LeastSquaresMetricv4;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(CurveFitMetric, LeastSquaresMetricv4);

  std::string         block{ "curve" };
  std::vector<double> ordinates{ 2.1, 2.6, 3.6, 4.7, 6.2 };
  double              sigma{ 0.5 };

  BlocksType
  DeclareBlocks() const override
  {
    // The rate is small and moves much: an optimizer had better see 8 of it as one.
    return { { block, { { "a", 2.3, 1.0, 0.0, true }, { "b", 0.2, 8.0, 0.25, true } } } };
  }
  itk::SizeValueType
  GetNumberOfResiduals() const override
  {
    return ordinates.size();
  }
  void
  ComputeResiduals(const PositionType & x, VectorType & residuals, MatrixType * jacobian) const override
  {
    residuals.set_size(static_cast<unsigned int>(ordinates.size()));
    for (unsigned int i = 0; i < residuals.size(); ++i)
    {
      residuals[i] = (x[0] * std::exp(x[1] * i) - ordinates[i]) / sigma;
    }
    if (jacobian != nullptr)
    {
      this->ComputeJacobianByDifferences(x, *jacobian);
    }
  }

protected:
  CurveFitMetric() = default;
  ~CurveFitMetric() override = default;
  itk::LightObject::Pointer
  InternalClone() const override
  {
    auto clone = Self::New();
    clone->block = block;
    clone->ordinates = ordinates;
    clone->sigma = sigma;
    clone->CopyState(*this);
    return clone.GetPointer();
  }
};

#endif

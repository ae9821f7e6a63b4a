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
#ifndef itkLeastSquaresTestMetric_h
#define itkLeastSquaresTestMetric_h

#include "itkLeastSquaresMetric.h"

#include "itkObjectToObjectMetricBase.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <string>
#include <utility>

/** Sums of squares that are given as functions, and a record of what is called in which order. */
namespace LeastSquaresTest
{
using ParametersType = itk::OptimizerParameters<double>;

class Metric
  : public itk::ObjectToObjectMetricBaseTemplate<double>
  , public itk::LeastSquaresMetric
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(Metric);

  using Self = Metric;
  using Superclass = itk::ObjectToObjectMetricBaseTemplate<double>;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;
  using ParametersType = LeastSquaresTest::ParametersType;

  itkNewMacro(Self);
  itkTypeMacro(Metric, ObjectToObjectMetricBaseTemplate);

  /** Fills residuals and Jacobian, whose sizes are set. */
  std::function<void(const ParametersType &, vnl_vector<double> &, vnl_matrix<double> &)> function;
  /** By default the sum of the squared residuals. */
  std::function<double(const ParametersType &)> criterion;
  std::size_t                                   numberOfResiduals{ 0 };
  ParametersType                                maximumSteps;
  /** V: GetValue, R: GetResiduals, M: GetMaximumSteps, S: SetParameters, L: GetStepLength. */
  mutable std::string calls;

  static Pointer
  Make(std::initializer_list<double> start, std::size_t count, decltype(function) residuals)
  {
    const Pointer metric = New();
    metric->m_Parameters.SetSize(start.size());
    std::copy(start.begin(), start.end(), metric->m_Parameters.begin());
    metric->numberOfResiduals = count;
    metric->function = std::move(residuals);
    return metric;
  }

  double
  Evaluate(const ParametersType & x) const
  {
    if (criterion)
    {
      return criterion(x);
    }
    vnl_vector<double> residuals;
    vnl_matrix<double> jacobian;
    this->Fill(x, residuals, jacobian);
    return residuals.squared_magnitude();
  }

  void
  Initialize() override
  {}
  NumberOfParametersType
  GetNumberOfParameters() const override
  {
    return m_Parameters.GetSize();
  }
  NumberOfParametersType
  GetNumberOfLocalParameters() const override
  {
    return m_Parameters.GetSize();
  }
  void
  SetParameters(ParametersType & parameters) override
  {
    calls += 'S';
    m_Parameters = parameters;
  }
  const ParametersType &
  GetParameters() const override
  {
    return m_Parameters;
  }
  bool
  HasLocalSupport() const override
  {
    return false;
  }
  void
  UpdateTransformParameters(const DerivativeType &, ParametersValueType) override
  {}
  MeasureType
  GetValue() const override
  {
    calls += 'V';
    return this->Evaluate(m_Parameters);
  }
  void
  GetDerivative(DerivativeType & derivative) const override
  {
    vnl_vector<double> residuals;
    vnl_matrix<double> jacobian;
    this->Fill(m_Parameters, residuals, jacobian);
    derivative.SetSize(m_Parameters.GetSize());
    derivative.copy_in((-2.0 * (residuals * jacobian)).data_block());
  }
  void
  GetValueAndDerivative(MeasureType & value, DerivativeType & derivative) const override
  {
    value = this->GetValue();
    this->GetDerivative(derivative);
  }

  itk::SizeValueType
  GetNumberOfResiduals() const override
  {
    return numberOfResiduals;
  }
  void
  GetResiduals(vnl_vector<double> & residuals, vnl_matrix<double> * jacobian) const override
  {
    calls += 'R';
    vnl_matrix<double> unused;
    this->Fill(m_Parameters, residuals, jacobian != nullptr ? *jacobian : unused);
  }
  double
  GetStepLength(const ParametersType & from, const ParametersType & to) const override
  {
    calls += 'L';
    return LeastSquaresMetric::GetStepLength(from, to);
  }
  ParametersType
  GetMaximumSteps() const override
  {
    calls += 'M';
    return maximumSteps;
  }

protected:
  Metric() = default;
  ~Metric() override = default;

private:
  void
  Fill(const ParametersType & x, vnl_vector<double> & residuals, vnl_matrix<double> & jacobian) const
  {
    residuals.set_size(numberOfResiduals);
    jacobian.set_size(numberOfResiduals, x.GetSize());
    jacobian.fill(0.0);
    function(x, residuals, jacobian);
  }

  ParametersType m_Parameters;
};

/** Rosenbrock's valley as residuals, from its usual start; the minimum is 0 at (1, 1). */
inline Metric::Pointer
MakeRosenbrock()
{
  return Metric::Make({ -1.2, 1.0 }, 2, [](const ParametersType & x, vnl_vector<double> & r, vnl_matrix<double> & j) {
    r[0] = 10.0 * (x[1] - x[0] * x[0]);
    r[1] = 1.0 - x[0];
    j(0, 0) = -20.0 * x[0];
    j(0, 1) = 10.0;
    j(1, 0) = -1.0;
  });
}

/** A line of unit slope through (0, 2), with a fifth of the points elsewhere: Geman-McClure of width 1, reweighted. */
inline Metric::Pointer
MakeRobustLine()
{
  const auto distance = [](const ParametersType & x, unsigned int i) {
    const double t = 0.1 * i;
    return x[0] + x[1] * t - (2.0 + t + (i % 5 == 3 ? 4.0 + 0.1 * (i % 7) : 0.0));
  };
  const auto metric = Metric::Make(
    { 2.6, 0.9 }, 50, [distance](const ParametersType & x, vnl_vector<double> & r, vnl_matrix<double> & j) {
      for (unsigned int i = 0; i < 50; ++i)
      {
        const double d = distance(x, i);
        const double weight = 1.0 / ((1.0 + d * d) * (1.0 + d * d));
        r[i] = std::sqrt(weight) * d;
        j(i, 0) = std::sqrt(weight);
        j(i, 1) = std::sqrt(weight) * 0.1 * i;
      }
    });
  metric->criterion = [distance](const ParametersType & x) {
    double sum = 0.0;
    for (unsigned int i = 0; i < 50; ++i)
    {
      const double d = distance(x, i);
      sum += d * d / (1.0 + d * d);
    }
    return sum;
  };
  return metric;
}

/** log(x / 0.01), which is no number from 0 down: a full step from 4 leads there. */
inline Metric::Pointer
MakeLogarithm(double start = 4.0)
{
  return Metric::Make({ start }, 1, [](const ParametersType & x, vnl_vector<double> & r, vnl_matrix<double> & j) {
    r[0] = std::log(x[0] / 0.01);
    j(0, 0) = 1.0 / x[0];
  });
}
} // namespace LeastSquaresTest

#endif

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
#include "itkLevenbergMarquardtOptimizerv4.h"

#include "vnl/algo/vnl_levenberg_marquardt.h"
#include "vnl/vnl_least_squares_function.h"

#include <algorithm>
#include <exception>
#include <sstream>

namespace itk
{
/** The metric as VNL sees it. Exceptions must not cross MINPACK's frames: they are kept, and end the run. */
class LevenbergMarquardtOptimizerv4::FunctionType : public vnl_least_squares_function
{
public:
  FunctionType(Self * optimizer, const LeastSquaresMetric & residuals, unsigned int numberOfParameters)
    : vnl_least_squares_function(
        numberOfParameters, static_cast<unsigned int>(residuals.GetNumberOfResiduals()), use_gradient)
    , m_Optimizer(optimizer)
    , m_Residuals(residuals)
    , m_Position(numberOfParameters)
  {}

  void
  f(const vnl_vector<double> & x, vnl_vector<double> & fx) override
  {
    this->Guard([&] {
      ++m_Optimizer->m_NumberOfEvaluations;
      this->MoveTo(x);
      vnl_vector<double> residuals;
      m_Residuals.GetResiduals(residuals, nullptr);
      // fx is a view: its memory must stay.
      std::copy(residuals.begin(), residuals.end(), fx.begin());
    });
  }

  void
  gradf(const vnl_vector<double> & x, vnl_matrix<double> & jacobian) override
  {
    this->Guard([&] {
      ++m_Optimizer->m_NumberOfJacobians;
      this->MoveTo(x);
      vnl_vector<double> residuals;
      vnl_matrix<double> rows;
      m_Residuals.GetResiduals(residuals, &rows);
      std::copy(rows.begin(), rows.end(), jacobian.begin());
    });
  }

  /** Called with the first position, after each accepted step but the last, and with the last position. */
  void
  trace(int, const vnl_vector<double> & x, const vnl_vector<double> & fx) override
  {
    if (m_NumberOfCalls++ == 0)
    {
      return;
    }
    this->Guard([&] {
      this->MoveTo(x);
      m_Optimizer->m_CurrentMetricValue = fx.squared_magnitude();
      ++m_Optimizer->m_CurrentIteration;
      m_Optimizer->InvokeEvent(IterationEvent());
      if (m_Optimizer->m_CurrentIteration >= m_Optimizer->m_NumberOfIterations)
      {
        m_HasReachedMaximum = true;
        this->throw_failure();
      }
    });
  }

  void
  MoveTo(const vnl_vector<double> & x)
  {
    std::copy(x.begin(), x.end(), m_Position.begin());
    m_Optimizer->m_Metric->SetParameters(m_Position);
  }

  void
  Rethrow() const
  {
    if (m_Exception)
    {
      std::rethrow_exception(m_Exception);
    }
  }

  bool
  HasReachedMaximum() const
  {
    return m_HasReachedMaximum;
  }

private:
  template <typename TCall>
  void
  Guard(const TCall & call)
  {
    if (m_Exception || m_HasReachedMaximum)
    {
      this->throw_failure();
      return;
    }
    try
    {
      call();
    }
    catch (...)
    {
      m_Exception = std::current_exception();
      this->throw_failure();
    }
  }

  Self *                     m_Optimizer;
  const LeastSquaresMetric & m_Residuals;
  ParametersType             m_Position;
  std::exception_ptr         m_Exception;
  unsigned int               m_NumberOfCalls{ 0 };
  bool                       m_HasReachedMaximum{ false };
};

LevenbergMarquardtOptimizerv4::LevenbergMarquardtOptimizerv4()
{
  this->m_NumberOfIterations = 100;
}

void
LevenbergMarquardtOptimizerv4::StartOptimization(bool doOnlyInitialization)
{
  if (this->m_Metric.IsNull())
  {
    itkExceptionMacro("No metric: call SetMetric() first.");
  }
  const auto * residuals = dynamic_cast<const LeastSquaresMetric *>(this->m_Metric.GetPointer());
  if (residuals == nullptr)
  {
    itkExceptionMacro("The metric " << this->m_Metric->GetNameOfClass()
                                    << " has no residuals; give one that does, as PartialContourMetricv4, or take "
                                       "another optimizer, as LBFGSBOptimizerv4.");
  }
  Superclass::StartOptimization(doOnlyInitialization);
  if (doOnlyInitialization)
  {
    return;
  }
  const auto count = static_cast<unsigned int>(this->m_Metric->GetNumberOfParameters());
  if (residuals->GetNumberOfResiduals() < count)
  {
    itkExceptionMacro("The metric has " << residuals->GetNumberOfResiduals() << " residuals, fewer than its " << count
                                        << " parameters.");
  }
  this->m_CurrentIteration = 0;
  m_NumberOfEvaluations = 0;
  m_NumberOfJacobians = 0;
  m_StopConditionDescription.clear();
  this->InvokeEvent(StartEvent());

  vnl_vector<double> x(count);
  std::copy(this->m_Metric->GetParameters().begin(), this->m_Metric->GetParameters().end(), x.begin());
  std::ostringstream text;
  text << this->GetNameOfClass() << ": ";
  if (this->m_NumberOfIterations == 0)
  {
    this->m_CurrentMetricValue = this->m_Metric->GetValue();
    text << "Maximum number of iterations (0) reached.";
  }
  else
  {
    FunctionType            function(this, *residuals, count);
    vnl_levenberg_marquardt solver(function);
    solver.set_f_tolerance(m_ValueTolerance);
    solver.set_x_tolerance(m_StepTolerance);
    solver.set_g_tolerance(m_GradientTolerance);
    // Steps that are not accepted count as evaluations only.
    solver.set_max_function_evals(static_cast<int>(std::min<SizeValueType>(20 * this->m_NumberOfIterations, 1000000)));
    solver.minimize_using_gradient(x);
    function.Rethrow();
    function.MoveTo(x);
    this->m_CurrentMetricValue = this->m_Metric->GetValue();
    switch (solver.get_failure_code())
    {
      case vnl_nonlinear_minimizer::CONVERGED_FTOL:
        text << "The sum of squares falls by less than the tolerance (" << m_ValueTolerance << ").";
        break;
      case vnl_nonlinear_minimizer::CONVERGED_XTOL:
        text << "The step is smaller than the tolerance (" << m_StepTolerance << ").";
        break;
      case vnl_nonlinear_minimizer::CONVERGED_XFTOL:
        text << "Sum of squares and step change by less than their tolerances (" << m_ValueTolerance << ", "
             << m_StepTolerance << ").";
        break;
      case vnl_nonlinear_minimizer::CONVERGED_GTOL:
        text << "The gradient is smaller than the tolerance (" << m_GradientTolerance << ").";
        break;
      case vnl_nonlinear_minimizer::FAILED_FTOL_TOO_SMALL:
      case vnl_nonlinear_minimizer::FAILED_XTOL_TOO_SMALL:
      case vnl_nonlinear_minimizer::FAILED_GTOL_TOO_SMALL:
        text << "No further improvement is possible in double precision.";
        break;
      case vnl_nonlinear_minimizer::TOO_MANY_ITERATIONS:
        text << "Maximum number of evaluations (" << 20 * this->m_NumberOfIterations << ") reached.";
        break;
      default:
        if (function.HasReachedMaximum())
        {
          text << "Maximum number of iterations (" << this->m_NumberOfIterations << ") reached.";
        }
        else
        {
          text << "The solver gave up (code " << static_cast<int>(solver.get_failure_code()) << ").";
        }
    }
  }
  m_StopConditionDescription = text.str();
  this->InvokeEvent(EndEvent());
}

void
LevenbergMarquardtOptimizerv4::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "ValueTolerance: " << m_ValueTolerance << std::endl;
  os << indent << "StepTolerance: " << m_StepTolerance << std::endl;
  os << indent << "GradientTolerance: " << m_GradientTolerance << std::endl;
  os << indent << "NumberOfEvaluations: " << m_NumberOfEvaluations << std::endl;
  os << indent << "NumberOfJacobians: " << m_NumberOfJacobians << std::endl;
  os << indent << "StopConditionDescription: " << m_StopConditionDescription << std::endl;
}
} // namespace itk

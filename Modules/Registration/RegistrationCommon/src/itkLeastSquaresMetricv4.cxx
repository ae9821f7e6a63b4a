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
#include "itkLeastSquaresMetricv4.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <typeinfo>
#include <utility>

namespace itk
{
void
LeastSquaresMetricv4::UpdateBlocks() const
{
  RegistrationState state;
  for (const BlockType & block : this->DeclareBlocks())
  {
    // What is known of a block stays.
    const bool isThere =
      m_State.HasBlock(block.name) && m_State.GetBlock(block.name).parameters.size() == block.parameters.size();
    state.AddBlock(isThere ? m_State.GetBlock(block.name) : block);
  }
  const auto & before = m_State.GetBlocks();
  const auto & now = state.GetBlocks();
  if (!std::equal(before.begin(), before.end(), now.begin(), now.end(), [](const BlockType & a, const BlockType & b) {
        return a.name == b.name && a.parameters.size() == b.parameters.size();
      }))
  {
    m_State = state;
    m_Parameters = m_State.GetFreeParameters();
  }
}

ModifiedTimeType
LeastSquaresMetricv4::GetMTime() const
{
  ModifiedTimeType time = std::max(Superclass::GetMTime(), m_CriterionTime.GetMTime());
  for (const Object * object : { this->GetFixedObject(), this->GetMovingObject() })
  {
    time = object == nullptr ? time : std::max(time, object->GetMTime());
  }
  return time;
}

void
LeastSquaresMetricv4::StateChanged()
{
  m_CriterionTime.Modified();
  m_Parameters = m_State.GetFreeParameters();
}

void
LeastSquaresMetricv4::SettingsChanged()
{
  m_CriterionTime.Modified();
}

const RegistrationState &
LeastSquaresMetricv4::GetState() const
{
  this->UpdateBlocks();
  return m_State;
}

void
LeastSquaresMetricv4::SetBlockValues(const std::string & block, const std::vector<double> & values)
{
  this->UpdateBlocks();
  m_State.SetBlockValues(block, values);
  this->StateChanged();
}

void
LeastSquaresMetricv4::SetValues(const PositionType & x)
{
  this->UpdateBlocks();
  m_State.SetValues(x);
  this->StateChanged();
}

std::vector<double>
LeastSquaresMetricv4::GetBlockValues(const std::string & block) const
{
  return this->GetState().GetBlockValues(block);
}

void
LeastSquaresMetricv4::SetBlockFree(const std::string & block, const std::vector<bool> & isFree)
{
  this->UpdateBlocks();
  m_State.SetBlockFree(block, isFree);
  this->StateChanged();
}

void
LeastSquaresMetricv4::SetBlockFree(const std::string & block, bool isFree)
{
  this->UpdateBlocks();
  m_State.SetBlockFree(block, isFree);
  this->StateChanged();
}

double
LeastSquaresMetricv4::ComputeValue(const PositionType & x) const
{
  VectorType residuals;
  this->ComputeResiduals(x, residuals, nullptr);
  return residuals.squared_magnitude();
}

void
LeastSquaresMetricv4::ComputeGradient(const PositionType & x, VectorType & gradient) const
{
  VectorType residuals;
  MatrixType jacobian;
  this->ComputeResiduals(x, residuals, &jacobian);
  gradient.set_size(static_cast<unsigned int>(x.size()));
  for (unsigned int k = 0; k < gradient.size(); ++k)
  {
    gradient[k] = 0.0;
    for (unsigned int i = 0; i < residuals.size(); ++i)
    {
      gradient[k] += 2.0 * jacobian(i, k) * residuals[i];
    }
  }
}

void
LeastSquaresMetricv4::AddSquaredMotion(const PositionType &, const PositionType &, double &, double &) const
{}

void
LeastSquaresMetricv4::AddFit(const PositionType &, RegistrationFit &) const
{}

void
LeastSquaresMetricv4::SetReach(double)
{}

void
LeastSquaresMetricv4::SetKernelWidth(double)
{}

void
LeastSquaresMetricv4::SetRobustKernel(const RobustKernel *)
{}

void
LeastSquaresMetricv4::SetNoiseModel(const ResidualNoiseModel *)
{}

void
LeastSquaresMetricv4::SetNoiseLevels(const ContourNoiseLevels &, const ResidualNoiseModel *)
{}

bool
LeastSquaresMetricv4::GetNoiseLevels(ContourNoiseLevels &, const ResidualNoiseModel *) const
{
  return false;
}

double
LeastSquaresMetricv4::ComputeKnownDeviance(const PositionType & x, bool noiseIsEstimated) const
{
  ContourNoiseLevels levels;
  return noiseIsEstimated && this->GetNoiseLevels(levels) ? 0.0 : this->ComputeValue(x);
}

void
LeastSquaresMetricv4::SetJoins(JoinsEnum joins)
{
  if (m_Joins != joins)
  {
    m_Joins = joins;
    this->SettingsChanged();
  }
}

void
LeastSquaresMetricv4::UpdateNoiseCorrelation(const PositionType &)
{}

void
LeastSquaresMetricv4::AppendNoiseBlocks(const PositionType &, std::vector<ResidualNoiseBlock> &) const
{}

void
LeastSquaresMetricv4::AddFixedInformation(const PositionType & x,
                                          MatrixType &         information,
                                          VectorType &         gradient,
                                          double &             value) const
{
  VectorType residuals;
  MatrixType jacobian;
  this->ComputeResiduals(x, residuals, &jacobian);
  for (unsigned int i = 0; i < residuals.size(); ++i)
  {
    value += residuals[i] * residuals[i];
    for (unsigned int a = 0; a < jacobian.cols(); ++a)
    {
      gradient[a] += jacobian(i, a) * residuals[i];
      for (unsigned int b = 0; b < jacobian.cols(); ++b)
      {
        information(a, b) += jacobian(i, a) * jacobian(i, b);
      }
    }
  }
}

double
LeastSquaresMetricv4::EstimateNoise(double minimumWeight)
{
  const PositionType &            x = m_State.GetValues();
  const auto &                    free = m_State.GetFreeIndices();
  const auto                      all = static_cast<unsigned int>(x.size());
  const std::size_t               p = free.size();
  std::vector<ResidualNoiseBlock> blocks;
  this->UpdateNoiseCorrelation(x);
  this->AppendNoiseBlocks(x, blocks);
  MatrixType information(all, all, 0.0);
  VectorType gradient(all, 0.0);
  double     fixedValue = 0.0;
  this->AddFixedInformation(x, information, gradient, fixedValue);

  // The free parameters alone, as flat arrays.
  std::vector<double> freeInformation(p * p);
  std::vector<double> freeGradient(p);
  for (std::size_t a = 0; a < p; ++a)
  {
    freeGradient[a] = gradient[static_cast<unsigned int>(free[a])];
    for (std::size_t b = 0; b < p; ++b)
    {
      freeInformation[p * b + a] = information(static_cast<unsigned int>(free[a]), static_cast<unsigned int>(free[b]));
    }
  }
  std::vector<const ResidualNoiseModel *> models;
  for (ResidualNoiseBlock & block : blocks)
  {
    if (std::find(models.begin(), models.end(), block.model) == models.end())
    {
      models.push_back(block.model);
    }
    std::vector<double> columns(block.count * p);
    for (std::size_t a = 0; a < p; ++a)
    {
      std::copy_n(block.jacobian.begin() + static_cast<std::ptrdiff_t>(block.count * free[a]),
                  block.count,
                  columns.begin() + static_cast<std::ptrdiff_t>(block.count * a));
    }
    block.jacobian.swap(columns);
    for (double & weight : block.weights)
    {
      weight = std::max(weight, minimumWeight);
    }
  }

  double deviance = 0.0;
  for (const ResidualNoiseModel * model : models)
  {
    std::vector<ContourNoiseModel::BlockType> own;
    std::vector<double>                       otherInformation = freeInformation;
    std::vector<double>                       otherGradient = freeGradient;
    double                                    otherValue = fixedValue;
    for (const ResidualNoiseBlock & block : blocks)
    {
      if (block.model == model)
      {
        own.push_back({ block.count,
                        block.correlation.data(),
                        block.weights.data(),
                        block.residuals.data(),
                        block.jacobian.data() });
        continue;
      }
      // What has another model counts with the levels that it has.
      ContourNoiseLevels levels;
      this->GetNoiseLevels(levels, block.model);
      std::vector<double> factor(block.count * block.count);
      ContourNoiseModel::ComputeCovariance(
        block.correlation.data(), block.weights.data(), block.count, levels, factor.data());
      ContourNoiseModel::Factor(factor.data(), block.count);
      std::vector<double> residuals = block.residuals;
      std::vector<double> jacobian = block.jacobian;
      ContourNoiseModel::Whiten(factor.data(), block.count, residuals.data(), 1);
      ContourNoiseModel::Whiten(factor.data(), block.count, jacobian.data(), p);
      for (std::size_t i = 0; i < block.count; ++i)
      {
        otherValue += residuals[i] * residuals[i];
        for (std::size_t a = 0; a < p; ++a)
        {
          otherGradient[a] += jacobian[block.count * a + i] * residuals[i];
          for (std::size_t b = 0; b < p; ++b)
          {
            otherInformation[p * b + a] += jacobian[block.count * a + i] * jacobian[block.count * b + i];
          }
        }
      }
    }
    ContourNoiseLevels levels;
    this->GetNoiseLevels(levels, model);
    double own2 = 0.0;
    levels =
      ContourNoiseModel::Estimate(own, otherInformation.data(), otherGradient.data(), otherValue, p, levels, &own2);
    this->SetNoiseLevels(levels, model);
    deviance += own2;
  }
  return deviance;
}

void
LeastSquaresMetricv4::Hold(HoldEnum)
{}

void
LeastSquaresMetricv4::InitializeTerm()
{}

void
LeastSquaresMetricv4::Initialize()
{
  this->UpdateBlocks();
  this->InitializeTerm();
  if (m_State.GetNumberOfParameters() == 0)
  {
    itkExceptionMacro("This metric reads no parameters: its DeclareBlocks() (blocks() of a metric in Python) must name "
                      "at least one block.");
  }
  if (m_State.GetNumberOfFreeParameters() == 0)
  {
    std::ostringstream state;
    m_State.Print(state, "  ");
    itkExceptionMacro(
      "All parameters are held, there is nothing to optimize: free some with SetBlockFree(). The state:\n"
      << state.str());
  }
  this->StateChanged();
}

void
LeastSquaresMetricv4::SetEvaluationCallback(EvaluationCallbackType callback)
{
  m_EvaluationCallback = std::move(callback);
}

void
LeastSquaresMetricv4::AnnounceEvaluation() const
{
  // Terms read their blocks' values by place: without blocks there is nothing to read.
  if (m_State.GetNumberOfParameters() == 0)
  {
    itkExceptionMacro("The metric reads no parameters yet: set its inputs and call Initialize().");
  }
  if (m_EvaluationCallback)
  {
    m_EvaluationCallback();
  }
}

LeastSquaresMetricv4::MeasureType
LeastSquaresMetricv4::EvaluateValue() const
{
  this->m_Value = this->ComputeValue(m_State.GetValues());
  return this->m_Value;
}

void
LeastSquaresMetricv4::EvaluateDerivative(DerivativeType & derivative) const
{
  VectorType gradient;
  this->ComputeGradient(m_State.GetValues(), gradient);
  const auto & free = m_State.GetFreeIndices();
  derivative.SetSize(static_cast<unsigned int>(free.size()));
  for (std::size_t a = 0; a < free.size(); ++a)
  {
    // v4 metrics return minus the gradient.
    derivative[a] = -gradient[static_cast<unsigned int>(free[a])] / m_State.GetFreeScale(a);
  }
}

LeastSquaresMetricv4::MeasureType
LeastSquaresMetricv4::GetValue() const
{
  this->AnnounceEvaluation();
  return this->EvaluateValue();
}

void
LeastSquaresMetricv4::GetDerivative(DerivativeType & derivative) const
{
  this->AnnounceEvaluation();
  this->EvaluateDerivative(derivative);
}

void
LeastSquaresMetricv4::GetValueAndDerivative(MeasureType & value, DerivativeType & derivative) const
{
  this->AnnounceEvaluation();
  value = this->EvaluateValue();
  this->EvaluateDerivative(derivative);
}

LeastSquaresMetricv4::NumberOfParametersType
LeastSquaresMetricv4::GetNumberOfParameters() const
{
  return static_cast<NumberOfParametersType>(m_State.GetNumberOfFreeParameters());
}

LeastSquaresMetricv4::NumberOfParametersType
LeastSquaresMetricv4::GetNumberOfLocalParameters() const
{
  return this->GetNumberOfParameters();
}

void
LeastSquaresMetricv4::SetParameters(ParametersType & parameters)
{
  m_State.SetFreeParameters(parameters);
  // As given: divided by the scale and multiplied again they might differ in the last bit.
  m_Parameters = parameters;
}

const LeastSquaresMetricv4::ParametersType &
LeastSquaresMetricv4::GetParameters() const
{
  return m_Parameters;
}

void
LeastSquaresMetricv4::UpdateTransformParameters(const DerivativeType & derivative, ParametersValueType factor)
{
  ParametersType parameters = m_Parameters;
  if (derivative.Size() != parameters.Size())
  {
    itkExceptionMacro("An update of " << derivative.Size() << " parameters for " << parameters.Size() << " free ones.");
  }
  for (unsigned int i = 0; i < parameters.Size(); ++i)
  {
    parameters[i] += factor * derivative[i];
  }
  this->SetParameters(parameters);
}

void
LeastSquaresMetricv4::GetResiduals(VectorType & residuals, MatrixType * jacobian) const
{
  this->AnnounceEvaluation();
  if (jacobian == nullptr)
  {
    this->ComputeResiduals(m_State.GetValues(), residuals, nullptr);
    return;
  }
  MatrixType all;
  this->ComputeResiduals(m_State.GetValues(), residuals, &all);
  const auto & free = m_State.GetFreeIndices();
  jacobian->set_size(residuals.size(), static_cast<unsigned int>(free.size()));
  for (unsigned int i = 0; i < residuals.size(); ++i)
  {
    for (unsigned int a = 0; a < free.size(); ++a)
    {
      (*jacobian)(i, a) = all(i, static_cast<unsigned int>(free[a])) / m_State.GetFreeScale(a);
    }
  }
}

double
LeastSquaresMetricv4::GetStepLength(const ParametersType & from, const ParametersType & to) const
{
  double sum = 0.0;
  double count = 0.0;
  this->AddSquaredMotion(m_State.Expand(from), m_State.Expand(to), sum, count);
  return count > 0.0 ? std::sqrt(sum / count) : LeastSquaresMetric::GetStepLength(from, to);
}

LeastSquaresMetricv4::ParametersType
LeastSquaresMetricv4::GetMaximumSteps() const
{
  return m_State.GetMaximumSteps();
}

void
LeastSquaresMetricv4::ComputeJacobianByDifferences(const PositionType & x, MatrixType & jacobian) const
{
  std::vector<double> scales;
  for (const BlockType & block : this->GetState().GetBlocks())
  {
    for (const auto & parameter : block.parameters)
    {
      scales.push_back(parameter.scale);
    }
  }
  for (unsigned int k = 0; k < x.size(); ++k)
  {
    // Differences of second order: the error is of the order of the step squared.
    const double step = 1e-5 / scales[k];
    PositionType position = x;
    VectorType   before, after;
    position[k] = x[k] - step;
    this->ComputeResiduals(position, before, nullptr);
    position[k] = x[k] + step;
    this->ComputeResiduals(position, after, nullptr);
    if (k == 0)
    {
      jacobian.set_size(before.size(), static_cast<unsigned int>(x.size()));
    }
    for (unsigned int i = 0; i < before.size(); ++i)
    {
      jacobian(i, k) = (after[i] - before[i]) / (2.0 * step);
    }
  }
}

LeastSquaresMetricv4::Pointer
LeastSquaresMetricv4::CloneTerm(const Self & term)
{
  const LightObject::Pointer copy = term.InternalClone();
  auto * const               metric = dynamic_cast<Self *>(copy.GetPointer());
  if (metric == nullptr || typeid(*metric) != typeid(term))
  {
    itkGenericExceptionMacro("The term " << term.GetNameOfClass() << " cannot be cloned: implement InternalClone() of "
                                         << term.GetNameOfClass() << ", which makes one with New() and copies members "
                                         << "and state. What it has now makes "
                                         << (copy.IsNull() ? "nothing" : copy->GetNameOfClass()) << '.');
  }
  return metric;
}

void
LeastSquaresMetricv4::CopyState(const Self & other)
{
  m_State = other.GetState();
  m_Parameters = other.m_Parameters;
  m_Joins = other.m_Joins;
}

void
LeastSquaresMetricv4::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "State: " << std::endl;
  std::ostringstream text;
  text << indent.GetNextIndent();
  m_State.Print(os, text.str());
  os << indent << "Parameters: " << m_Parameters << std::endl;
  os << indent << "Joins: " << static_cast<int>(m_Joins) << std::endl;
  os << indent << "EvaluationCallback: " << (m_EvaluationCallback ? "set" : "(none)") << std::endl;
}
} // namespace itk

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
#include "itkLeastSquaresSumMetricv4.h"

#include <algorithm>

namespace itk
{
void
LeastSquaresSumMetricv4::AddMetric(MetricType * metric, SettingsEnum settings)
{
  if (metric == nullptr || metric == this)
  {
    itkExceptionMacro("AddMetric() wants a term: " << (metric == nullptr ? "it was given none."
                                                                         : "a sum is none of its "
                                                                           "own."));
  }
  const RegistrationState & own = metric->GetState();
  for (const BlockType & block : own.GetBlocks())
  {
    m_State.AddBlock(block);
  }
  m_Metrics.push_back({ metric, settings, {} });
  this->UpdatePlaces();
  this->StateChanged();
  this->Modified();
}

void
LeastSquaresSumMetricv4::RemoveMetric(const MetricType * metric)
{
  const auto found = std::find_if(
    m_Metrics.begin(), m_Metrics.end(), [&](const TermType & term) { return term.metric.GetPointer() == metric; });
  if (found == m_Metrics.end())
  {
    itkExceptionMacro("RemoveMetric() was given a metric that is no term of this sum.");
  }
  m_Metrics.erase(found);
  // The blocks that only this term read go with it; the others keep their values.
  const RegistrationState before = m_State;
  m_State = RegistrationState();
  for (BlockType block : this->DeclareBlocks())
  {
    m_State.AddBlock(before.GetBlock(block.name));
  }
  this->UpdatePlaces();
  this->StateChanged();
  this->Modified();
}

LeastSquaresSumMetricv4::MetricType *
LeastSquaresSumMetricv4::GetMetric(SizeValueType index) const
{
  if (index >= m_Metrics.size())
  {
    itkExceptionMacro("The sum has " << m_Metrics.size() << " terms; there is no term " << index << '.');
  }
  return m_Metrics[index].metric;
}

LeastSquaresSumMetricv4::SettingsEnum
LeastSquaresSumMetricv4::GetMetricSettings(SizeValueType index) const
{
  this->GetMetric(index);
  return m_Metrics[index].settings;
}

ModifiedTimeType
LeastSquaresSumMetricv4::GetMTime() const
{
  ModifiedTimeType time = Superclass::GetMTime();
  for (const TermType & term : m_Metrics)
  {
    time = std::max(time, term.metric->GetMTime());
  }
  return time;
}

LeastSquaresSumMetricv4::BlocksType
LeastSquaresSumMetricv4::DeclareBlocks() const
{
  RegistrationState state;
  for (const TermType & term : m_Metrics)
  {
    // With the values that a term has: a block that it declares since it was added begins where the term says.
    for (const BlockType & block : term.metric->GetState().GetBlocks())
    {
      state.AddBlock(block);
    }
  }
  return state.GetBlocks();
}

void
LeastSquaresSumMetricv4::UpdatePlaces() const
{
  for (TermType & term : m_Metrics)
  {
    term.places.clear();
    for (const BlockType & block : term.metric->DeclareBlocks())
    {
      const std::size_t offset = m_State.GetOffset(block.name);
      for (std::size_t k = 0; k < block.parameters.size(); ++k)
      {
        term.places.push_back(offset + k);
      }
    }
  }
}

LeastSquaresSumMetricv4::PositionType
LeastSquaresSumMetricv4::GetTermPosition(SizeValueType index, const PositionType & x) const
{
  const TermType & term = m_Metrics[index];
  PositionType     position(term.places.size());
  for (std::size_t k = 0; k < position.size(); ++k)
  {
    position[k] = x[term.places[k]];
  }
  return position;
}

void
LeastSquaresSumMetricv4::InitializeTerm()
{
  if (m_Metrics.empty())
  {
    itkExceptionMacro("A sum of nothing: call AddMetric() with at least one term.");
  }
  for (const TermType & term : m_Metrics)
  {
    term.metric->UpdateBlocks();
    term.metric->InitializeTerm();
  }
  this->UpdatePlaces();
}

SizeValueType
LeastSquaresSumMetricv4::GetNumberOfResiduals() const
{
  SizeValueType count = 0;
  for (const TermType & term : m_Metrics)
  {
    count += term.metric->GetNumberOfResiduals();
  }
  return count;
}

void
LeastSquaresSumMetricv4::ComputeResiduals(const PositionType & x, VectorType & residuals, MatrixType * jacobian) const
{
  std::vector<VectorType> parts(m_Metrics.size());
  std::vector<MatrixType> jacobians(m_Metrics.size());
  unsigned int            count = 0;
  for (std::size_t t = 0; t < m_Metrics.size(); ++t)
  {
    m_Metrics[t].metric->ComputeResiduals(
      this->GetTermPosition(t, x), parts[t], jacobian != nullptr ? &jacobians[t] : nullptr);
    count += parts[t].size();
  }
  residuals.set_size(count);
  if (jacobian != nullptr)
  {
    jacobian->set_size(count, static_cast<unsigned int>(x.size()));
    jacobian->fill(0.0);
  }
  unsigned int row = 0;
  for (std::size_t t = 0; t < m_Metrics.size(); ++t)
  {
    for (unsigned int i = 0; i < parts[t].size(); ++i, ++row)
    {
      residuals[row] = parts[t][i];
      for (unsigned int k = 0; k < jacobians[t].cols(); ++k)
      {
        (*jacobian)(row, static_cast<unsigned int>(m_Metrics[t].places[k])) = jacobians[t](i, k);
      }
    }
  }
}

double
LeastSquaresSumMetricv4::ComputeValue(const PositionType & x) const
{
  double value = 0.0;
  for (std::size_t t = 0; t < m_Metrics.size(); ++t)
  {
    value += m_Metrics[t].metric->ComputeValue(this->GetTermPosition(t, x));
  }
  return value;
}

void
LeastSquaresSumMetricv4::ComputeGradient(const PositionType & x, VectorType & gradient) const
{
  gradient.set_size(static_cast<unsigned int>(x.size()));
  gradient.fill(0.0);
  VectorType part;
  for (std::size_t t = 0; t < m_Metrics.size(); ++t)
  {
    m_Metrics[t].metric->ComputeGradient(this->GetTermPosition(t, x), part);
    for (unsigned int k = 0; k < part.size(); ++k)
    {
      gradient[static_cast<unsigned int>(m_Metrics[t].places[k])] += part[k];
    }
  }
}

void
LeastSquaresSumMetricv4::AddSquaredMotion(const PositionType & from,
                                          const PositionType & to,
                                          double &             sum,
                                          double &             count) const
{
  for (std::size_t t = 0; t < m_Metrics.size(); ++t)
  {
    m_Metrics[t].metric->AddSquaredMotion(this->GetTermPosition(t, from), this->GetTermPosition(t, to), sum, count);
  }
}

void
LeastSquaresSumMetricv4::AddFit(const PositionType & x, RegistrationFit & fit) const
{
  for (std::size_t t = 0; t < m_Metrics.size(); ++t)
  {
    m_Metrics[t].metric->AddFit(this->GetTermPosition(t, x), fit);
  }
}

void
LeastSquaresSumMetricv4::SetKernelWidth(double width)
{
  for (const TermType & term : m_Metrics)
  {
    if (term.settings == SettingsEnum::OfTheSum)
    {
      term.metric->SetKernelWidth(width);
    }
  }
}

void
LeastSquaresSumMetricv4::SetRobustKernel(const RobustKernel * kernel)
{
  for (const TermType & term : m_Metrics)
  {
    if (term.settings == SettingsEnum::OfTheSum)
    {
      term.metric->SetRobustKernel(kernel);
    }
  }
}

void
LeastSquaresSumMetricv4::SetNoiseModel(const ResidualNoiseModel * model)
{
  for (const TermType & term : m_Metrics)
  {
    if (term.settings == SettingsEnum::OfTheSum)
    {
      term.metric->SetNoiseModel(model);
    }
  }
}

void
LeastSquaresSumMetricv4::SetNoiseLevels(const ContourNoiseLevels & levels, const ResidualNoiseModel * model)
{
  for (const TermType & term : m_Metrics)
  {
    if (term.settings == SettingsEnum::OfTheSum)
    {
      term.metric->SetNoiseLevels(levels, model);
    }
  }
}

bool
LeastSquaresSumMetricv4::GetNoiseLevels(ContourNoiseLevels & levels, const ResidualNoiseModel * model) const
{
  return std::any_of(m_Metrics.begin(), m_Metrics.end(), [&](const TermType & term) {
    return term.settings == SettingsEnum::OfTheSum && term.metric->GetNoiseLevels(levels, model);
  });
}

double
LeastSquaresSumMetricv4::ComputeKnownDeviance(const PositionType & x, bool noiseIsEstimated) const
{
  double deviance = 0.0;
  for (std::size_t t = 0; t < m_Metrics.size(); ++t)
  {
    deviance += m_Metrics[t].metric->ComputeKnownDeviance(
      this->GetTermPosition(t, x), noiseIsEstimated && m_Metrics[t].settings == SettingsEnum::OfTheSum);
  }
  return deviance;
}

void
LeastSquaresSumMetricv4::SetReach(double standardDeviations)
{
  // Of all terms: where a registration is does not depend on whose settings a term has.
  for (const TermType & term : m_Metrics)
  {
    term.metric->SetReach(standardDeviations);
  }
}

void
LeastSquaresSumMetricv4::UpdateNoiseCorrelation(const PositionType & x)
{
  for (std::size_t t = 0; t < m_Metrics.size(); ++t)
  {
    m_Metrics[t].metric->UpdateNoiseCorrelation(this->GetTermPosition(t, x));
  }
}

void
LeastSquaresSumMetricv4::AppendNoiseBlocks(const PositionType & x, std::vector<ResidualNoiseBlock> & blocks) const
{
  for (std::size_t t = 0; t < m_Metrics.size(); ++t)
  {
    if (m_Metrics[t].settings == SettingsEnum::Own)
    {
      continue;
    }
    std::vector<ResidualNoiseBlock> own;
    m_Metrics[t].metric->AppendNoiseBlocks(this->GetTermPosition(t, x), own);
    for (ResidualNoiseBlock & block : own)
    {
      std::vector<double> columns(block.count * x.size(), 0.0);
      for (std::size_t k = 0; k < m_Metrics[t].places.size(); ++k)
      {
        std::copy_n(block.jacobian.begin() + static_cast<std::ptrdiff_t>(block.count * k),
                    block.count,
                    columns.begin() + static_cast<std::ptrdiff_t>(block.count * m_Metrics[t].places[k]));
      }
      block.jacobian.swap(columns);
      blocks.push_back(std::move(block));
    }
  }
}

void
LeastSquaresSumMetricv4::AddFixedInformation(const PositionType & x,
                                             MatrixType &         information,
                                             VectorType &         gradient,
                                             double &             value) const
{
  for (std::size_t t = 0; t < m_Metrics.size(); ++t)
  {
    const auto & places = m_Metrics[t].places;
    const auto   count = static_cast<unsigned int>(places.size());
    MatrixType   ownInformation(count, count, 0.0);
    VectorType   ownGradient(count, 0.0);
    if (m_Metrics[t].settings == SettingsEnum::Own)
    {
      // All of its residuals, with the noise that it has: none of it is estimated here.
      m_Metrics[t].metric->LeastSquaresMetricv4::AddFixedInformation(
        this->GetTermPosition(t, x), ownInformation, ownGradient, value);
    }
    else
    {
      m_Metrics[t].metric->AddFixedInformation(this->GetTermPosition(t, x), ownInformation, ownGradient, value);
    }
    for (unsigned int a = 0; a < count; ++a)
    {
      gradient[static_cast<unsigned int>(places[a])] += ownGradient[a];
      for (unsigned int b = 0; b < count; ++b)
      {
        information(static_cast<unsigned int>(places[a]), static_cast<unsigned int>(places[b])) += ownInformation(a, b);
      }
    }
  }
}

void
LeastSquaresSumMetricv4::Hold(HoldEnum what)
{
  for (std::size_t t = 0; t < m_Metrics.size(); ++t)
  {
    MetricType & metric = *m_Metrics[t].metric;
    metric.SetValues(this->GetTermPosition(t, m_State.GetValues()));
    metric.Hold(what);
  }
}

LightObject::Pointer
LeastSquaresSumMetricv4::InternalClone() const
{
  auto clone = Self::New();
  for (const TermType & term : m_Metrics)
  {
    clone->m_Metrics.push_back({ CloneTerm(*term.metric), term.settings, term.places });
  }
  clone->CopyState(*this);
  return clone.GetPointer();
}

void
LeastSquaresSumMetricv4::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  for (std::size_t t = 0; t < m_Metrics.size(); ++t)
  {
    os << indent << "Metric " << t
       << (m_Metrics[t].settings == SettingsEnum::Own ? ", kernel and noise its own: " : ": ") << std::endl;
    m_Metrics[t].metric->Print(os, indent.GetNextIndent());
  }
}
} // namespace itk

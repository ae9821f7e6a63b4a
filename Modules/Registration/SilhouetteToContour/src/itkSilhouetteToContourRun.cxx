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
#include "itkSilhouetteToContourRun.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
/** Moving points that rank the candidates of a grid. */
constexpr SizeValueType CandidatePoints = 48;
} // namespace

SilhouetteToContourRegistrationMethod::RunType::RunType(Self * method)
  : m_Method(method)
  , m_Metric(method->m_Metric)
  , m_Optimizer(method->m_Optimizer)
  , m_Adapter(OptimizerAdapter::Make(m_Optimizer, method->m_RandomSeed))
  , m_NumberOfIterations(m_Adapter->GetNumberOfIterations())
{
  m_ObserverTag =
    m_Optimizer->AddObserver(IterationEvent(), [this](const EventObject & event) { this->OnEvent(event); });
}

SilhouetteToContourRegistrationMethod::RunType::~RunType()
{
  m_Optimizer->RemoveObserver(m_ObserverTag);
  m_Adapter->SetNumberOfIterations(m_NumberOfIterations);
  m_Adapter->Restore();
  // What the run did to them is no reason to run again.
  m_Method->m_MetricMTimeAfterRun = m_Metric->GetMTime();
  m_Method->m_OptimizerMTimeAfterRun = m_Optimizer->GetMTime();
}

ContourSimilarity
SilhouetteToContourRegistrationMethod::RunType::RunLevel(unsigned int index, const ContourSimilarity & initial)
{
  m_Level = &m_Method->m_Levels[index];
  m_Metric->SetReference(initial);
  this->SetBounds();

  ParametersType origin(4);
  origin.Fill(0.0);
  LevelResultType result;
  result.initialValue = m_Metric->EvaluateAt(origin);
  const ParametersType initialParameters = MakeParameters(initial);
  std::copy_n(initialParameters.begin(), 4, result.initialParameters.begin());

  m_Method->SetIteration(index, 0, result.initialValue, initial);
  m_Method->m_CurrentCandidate = 0;
  m_Method->m_StepLength = 0.0;
  m_Method->InvokeEvent(MultiResolutionIterationEvent());
  // An observer may have changed the metric.
  result.initialValue = m_Metric->EvaluateAt(origin);
  this->ReportProgress(0.0);

  const std::vector<ParametersType> starts = this->FindStarts(result.numberOfCandidates);
  std::string                       stopConditionDescription;
  double                            best = result.initialValue;
  ParametersType                    bestPosition(origin);
  std::size_t                       evaluations = 0;
  for (std::size_t i = 0; i < starts.size(); ++i)
  {
    m_StartFraction = 0.3 + 0.7 * static_cast<double>(i) / static_cast<double>(starts.size());
    m_StartShare = 0.7 / static_cast<double>(starts.size());
    m_IterationsOfStart = 0;
    m_Method->m_CurrentCandidate = static_cast<unsigned int>(i);
    m_LastPosition = starts[i];
    m_Metric->ResetBest();
    const std::string stop = this->RunOptimizer(starts[i]);
    evaluations += m_Metric->GetNumberOfEvaluations();
    if (stopConditionDescription.empty() || m_Metric->GetBestValue() < best)
    {
      stopConditionDescription = stop;
    }
    if (m_Metric->GetBestValue() < best)
    {
      best = m_Metric->GetBestValue();
      bestPosition = m_Metric->GetBestParameters();
    }
  }

  for (unsigned int i = 0; i < 4; ++i)
  {
    bestPosition[i] = std::min(std::max(bestPosition[i], m_Lower[i]), m_Upper[i]);
    const double tolerance = 1e-6 * (m_Upper[i] - m_Lower[i]);
    if (m_Upper[i] > m_Lower[i])
    {
      result.boundsHit[i] = static_cast<int>(bestPosition[i] >= m_Upper[i] - tolerance) -
                            static_cast<int>(bestPosition[i] <= m_Lower[i] + tolerance);
    }
  }
  const ContourSimilarity final = m_Metric->GetSimilarity(bestPosition);
  const ParametersType    finalParameters = MakeParameters(final);
  std::copy_n(finalParameters.begin(), 4, result.finalParameters.begin());
  result.finalValue = m_Metric->EvaluateAt(bestPosition);
  result.numberOfIterations = m_Method->GetOptimizerIteration();
  result.numberOfEvaluations = evaluations;
  result.stopConditionDescription = stopConditionDescription;

  m_Method->SetIteration(index, m_Method->GetOptimizerIteration(), result.finalValue, final);
  m_Method->SetStopConditionDescription(stopConditionDescription);
  m_Method->m_LevelResults.push_back(result);
  return final;
}

void
SilhouetteToContourRegistrationMethod::RunType::SetBounds()
{
  const double length = m_Metric->GetReferenceLength();
  const double shift = m_Level->translationBound / m_Method->m_PixelSpacing;
  m_Lower.SetSize(4);
  m_Upper.SetSize(4);
  m_Lower[0] = m_Method->m_FixScale ? 0.0 : length * std::log1p(-m_Level->scaleBound);
  m_Upper[0] = m_Method->m_FixScale ? 0.0 : length * std::log1p(m_Level->scaleBound);
  m_Upper[1] = m_Method->m_FixRotation ? 0.0 : length * m_Level->rotationBound;
  m_Lower[1] = -m_Upper[1];
  m_Upper[2] = m_Method->m_FixTranslation ? 0.0 : shift;
  m_Lower[2] = -m_Upper[2];
  m_Upper[3] = m_Upper[2];
  m_Lower[3] = m_Lower[2];
  m_Metric->SetBounds(m_Lower, m_Upper);
}

auto
SilhouetteToContourRegistrationMethod::RunType::FindStarts(std::size_t & numberOfCandidates)
  -> std::vector<ParametersType>
{
  ParametersType origin(4);
  origin.Fill(0.0);
  unsigned int counts[4] = {
    m_Level->numberOfScales, m_Level->numberOfRotations, m_Level->numberOfTranslations, m_Level->numberOfTranslations
  };
  std::size_t total = 1;
  for (unsigned int i = 0; i < 4; ++i)
  {
    counts[i] = m_Upper[i] > m_Lower[i] ? std::max(counts[i], 1u) : 1u;
    total *= counts[i];
  }
  numberOfCandidates = 0;
  if (total == 1)
  {
    return { origin };
  }
  struct CandidateType
  {
    double         value;
    int            place[4];
    ParametersType position;
  };
  // Candidates stand in the middle of equal parts of the bounds; a single one at the current estimate.
  const auto coordinate = [&](unsigned int i, unsigned int k) {
    return counts[i] == 1 ? 0.0 : m_Lower[i] + (m_Upper[i] - m_Lower[i]) * (k + 0.5) / counts[i];
  };
  std::vector<CandidateType> candidates;
  candidates.reserve(total + 1);
  CandidateType current{ m_Metric->EvaluateApproximatelyAt(origin, CandidatePoints), { 0, 0, 0, 0 }, origin };
  for (unsigned int i = 0; i < 4; ++i)
  {
    const double part = (m_Upper[i] - m_Lower[i]) / counts[i];
    current.place[i] = part > 0.0 ? static_cast<int>(std::floor(-m_Lower[i] / part)) : 0;
  }
  candidates.push_back(current);
  for (std::size_t number = 0; number < total; ++number)
  {
    CandidateType candidate{ 0.0, { 0, 0, 0, 0 }, origin };
    std::size_t   rest = number;
    for (unsigned int i = 0; i < 4; ++i)
    {
      candidate.place[i] = static_cast<int>(rest % counts[i]);
      candidate.position[i] = coordinate(i, static_cast<unsigned int>(rest % counts[i]));
      rest /= counts[i];
    }
    candidate.value = m_Metric->EvaluateApproximatelyAt(candidate.position, CandidatePoints);
    candidates.push_back(candidate);
    if (number % 128 == 127)
    {
      this->ReportProgress(0.3 * static_cast<double>(number) / static_cast<double>(total));
    }
  }
  numberOfCandidates = candidates.size();
  std::vector<std::size_t> order(candidates.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    order[i] = i;
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return candidates[a].value < candidates[b].value;
  });
  std::vector<std::size_t> chosen;
  for (const std::size_t i : order)
  {
    if (chosen.size() >= m_Level->numberOfStarts)
    {
      break;
    }
    const bool isNew = std::none_of(chosen.begin(), chosen.end(), [&](std::size_t j) {
      int apart = 0;
      for (unsigned int k = 0; k < 4; ++k)
      {
        apart = std::max(apart, std::abs(candidates[i].place[k] - candidates[j].place[k]));
      }
      return apart <= 1;
    });
    if (isNew)
    {
      chosen.push_back(i);
    }
  }
  std::vector<ParametersType> starts;
  for (const std::size_t i : chosen)
  {
    starts.push_back(candidates[i].position);
  }
  return starts;
}

std::string
SilhouetteToContourRegistrationMethod::RunType::RunOptimizer(const ParametersType & start)
{
  m_Adapter->SetNumberOfIterations(m_Level->numberOfIterations > 0 ? m_Level->numberOfIterations
                                                                   : m_NumberOfIterations);
  ParametersType position(start);
  m_Metric->SetParameters(position);
  m_Adapter->Prepare(start, m_Lower, m_Upper);
  m_Optimizer->SetMetric(m_Metric);
  return m_Adapter->Start();
}

void
SilhouetteToContourRegistrationMethod::RunType::OnEvent(const EventObject & event)
{
  m_Method->CheckAbort();
  if (!m_Adapter->IsIteration(event))
  {
    return;
  }
  ++m_IterationsOfStart;
  const ContourSimilarity current = m_Metric->GetCurrentSimilarity();
  // The metric's own parameters are pixels.
  const ParametersType position = m_Metric->GetOptimizerParameters(current);
  m_Method->m_StepLength = (position - m_LastPosition).two_norm();
  m_LastPosition = position;
  m_Method->SetIteration(
    m_Method->GetCurrentLevel(), m_Method->GetOptimizerIteration() + 1, m_Metric->GetCurrentValue(), current);
  m_Method->InvokeEvent(IterationEvent());
  const double done = static_cast<double>(m_IterationsOfStart);
  this->ReportProgress(m_StartFraction + m_StartShare * done / (done + 20.0));
}

void
SilhouetteToContourRegistrationMethod::RunType::ReportProgress(double fractionOfLevel)
{
  const double done =
    (m_Method->GetCurrentLevel() + fractionOfLevel) / static_cast<double>(m_Method->GetNumberOfLevels());
  m_Method->UpdateProgress(static_cast<float>(done));
  m_Method->CheckAbort();
}
} // namespace itk

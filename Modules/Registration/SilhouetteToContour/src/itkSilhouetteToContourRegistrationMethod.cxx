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
#include "itkSilhouetteToContourRegistrationMethod.h"

#include "itkContourChamferMetricv4.h"
#include "itkLevenbergMarquardtOptimizerv4.h"
#include "itkMakeContourArrays.h"
#include "itkReproducibleRandom.h"

#include "itkAmoebaOptimizerv4.h"
#include "itkExhaustiveOptimizerv4.h"
#include "itkLBFGSBOptimizerv4.h"
#include "itkMath.h"
#include "itkOnePlusOneEvolutionaryOptimizerv4.h"
#include "itkRandomVariateGeneratorBase.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <sstream>
#include <typeinfo>

namespace itk
{
namespace
{
constexpr double        DegreesToRadians = Math::pi / 180.0;
constexpr SizeValueType CandidatePoints = 48;

using OnePlusOneType = OnePlusOneEvolutionaryOptimizerv4<double>;
using ExhaustiveType = ExhaustiveOptimizerv4<double>;

/** A normal generator that starts anew with every run, so that a rerun repeats. */
class SeededNormalGenerator : public Statistics::RandomVariateGeneratorBase
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(SeededNormalGenerator);
  using Self = SeededNormalGenerator;
  using Superclass = Statistics::RandomVariateGeneratorBase;
  using Pointer = SmartPointer<Self>;
  itkFactorylessNewMacro(Self);
  itkTypeMacro(SeededNormalGenerator, RandomVariateGeneratorBase);

  void
  SetSeed(uint64_t seed)
  {
    m_Random = ReproducibleRandom(seed);
  }
  double
  GetVariate() override
  {
    return m_Random.Normal();
  }

protected:
  SeededNormalGenerator() = default;
  ~SeededNormalGenerator() override = default;

private:
  ReproducibleRandom m_Random{ 0 };
};

/** Bounding box, centroid and whether there are two distinct points, of the points that count. */
struct ExtentType
{
  double low[2]{ 0.0, 0.0 };
  double high[2]{ 0.0, 0.0 };
  double centroid[2]{ 0.0, 0.0 };

  double
  GetDiagonal() const
  {
    return std::hypot(high[0] - low[0], high[1] - low[1]);
  }
};

ExtentType
MeasureExtent(const DentalContour & contour, const char * name)
{
  const ContourArrays arrays = MakeContourArrays(contour);
  ExtentType          extent;
  double              sumOfWeights = 0.0;
  for (std::size_t i = 0; i < arrays.GetNumberOfPoints(); ++i)
  {
    const double weight = arrays.weights.empty() ? 1.0 : arrays.weights[i];
    if (!(weight > 0.0))
    {
      continue;
    }
    for (int k = 0; k < 2; ++k)
    {
      const double x = arrays.points[2 * i + k];
      extent.low[k] = sumOfWeights > 0.0 ? std::min(extent.low[k], x) : x;
      extent.high[k] = sumOfWeights > 0.0 ? std::max(extent.high[k], x) : x;
      extent.centroid[k] += weight * x;
    }
    sumOfWeights += weight;
  }
  extent.centroid[0] /= sumOfWeights;
  extent.centroid[1] /= sumOfWeights;
  if (!(sumOfWeights > 0.0))
  {
    itkGenericExceptionMacro("The " << name
                                    << " contour has no point of positive weight; there is nothing to register.");
  }
  if (!(extent.GetDiagonal() > 0.0))
  {
    itkGenericExceptionMacro(
      "The " << name
             << " contour is a single point, which has neither size nor direction; give at least "
                "two distinct points.");
  }
  return extent;
}

ContourSimilarity
ComputeBoundingBoxSimilarity(const DentalContour & fixed, const DentalContour & moving)
{
  const ExtentType  to = MeasureExtent(fixed, "fixed");
  const ExtentType  from = MeasureExtent(moving, "moving");
  ContourSimilarity similarity;
  similarity.scale = to.GetDiagonal() / from.GetDiagonal();
  similarity.tx = to.centroid[0] - similarity.scale * from.centroid[0];
  similarity.ty = to.centroid[1] - similarity.scale * from.centroid[1];
  return similarity;
}

Array<double>
MakeArray(const OptimizerParameters<double> & parameters)
{
  Array<double> array(parameters.GetSize());
  std::copy(parameters.begin(), parameters.end(), array.begin());
  return array;
}

OptimizerParameters<double>
MakeParameters(const ContourSimilarity & similarity)
{
  OptimizerParameters<double> parameters(4);
  parameters[0] = similarity.scale;
  parameters[1] = similarity.angle;
  parameters[2] = similarity.tx;
  parameters[3] = similarity.ty;
  return parameters;
}

/** ITK's LBFGSB keeps its state in static variables of netlib's code: two at a time in one process disturb each other.
 */
std::recursive_mutex &
OneAtATime()
{
  static std::recursive_mutex mutex;
  return mutex;
}
} // namespace

/** One run of GenerateData(). */
class SilhouetteToContourRegistrationMethod::RunType
{
public:
  explicit RunType(Self * method)
    : m_Method(method)
    , m_Metric(method->m_Metric)
    , m_Optimizer(method->m_Optimizer)
    , m_NumberOfIterations(m_Optimizer->GetNumberOfIterations())
  {
    m_ObserverTag =
      m_Optimizer->AddObserver(IterationEvent(), [this](const EventObject & event) { this->OnEvent(event); });
    if (auto * amoeba = dynamic_cast<AmoebaOptimizerv4 *>(m_Optimizer.GetPointer()))
    {
      m_Amoeba = amoeba;
      m_SetSimplex = amoeba->GetAutomaticInitialSimplex();
    }
    if (auto * exhaustive = dynamic_cast<ExhaustiveType *>(m_Optimizer.GetPointer()))
    {
      m_Exhaustive = exhaustive;
      m_SetScales = !exhaustive->GetScalesInitialized();
    }
    if (auto * onePlusOne = dynamic_cast<OnePlusOneType *>(m_Optimizer.GetPointer()))
    {
      m_OnePlusOne = onePlusOne;
      m_NumberOfIterations = onePlusOne->GetMaximumIteration();
      const auto generator = SeededNormalGenerator::New();
      generator->SetSeed(method->m_RandomSeed);
      onePlusOne->SetNormalVariateGenerator(generator);
    }
    m_LBFGSB = dynamic_cast<LBFGSBOptimizerv4 *>(m_Optimizer.GetPointer());
    m_LevenbergMarquardt = dynamic_cast<LevenbergMarquardtOptimizerv4 *>(m_Optimizer.GetPointer());
  }

  ~RunType()
  {
    m_Optimizer->RemoveObserver(m_ObserverTag);
    this->SetNumberOfIterations(m_NumberOfIterations);
    if (m_SetSimplex)
    {
      m_Amoeba->AutomaticInitialSimplexOn();
    }
    if (m_SetScales)
    {
      m_Exhaustive->SetScales(OptimizerType::ScalesType());
    }
    // What the run did to them is no reason to run again.
    m_Method->m_MetricMTimeAfterRun = m_Metric->GetMTime();
    m_Method->m_OptimizerMTimeAfterRun = m_Optimizer->GetMTime();
  }

  RunType(const RunType &) = delete;
  RunType &
  operator=(const RunType &) = delete;

  /** Runs a level from the similarity and returns where it ends. */
  ContourSimilarity
  RunLevel(unsigned int index, const ContourSimilarity & initial)
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

    m_Method->m_CurrentLevel = index;
    m_Method->m_CurrentCandidate = 0;
    m_Method->m_StepLength = 0.0;
    m_Method->m_OptimizerIteration = 0;
    m_Method->m_MetricValue = result.initialValue;
    m_Method->m_OptimizerPosition = initialParameters;
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
    result.numberOfIterations = m_Method->m_OptimizerIteration;
    result.numberOfEvaluations = evaluations;
    result.stopConditionDescription = stopConditionDescription;

    m_Method->m_MetricValue = result.finalValue;
    m_Method->m_OptimizerPosition = finalParameters;
    m_Method->m_StopConditionDescription = stopConditionDescription;
    m_Method->m_LevelResults.push_back(result);
    return final;
  }

private:
  void
  SetNumberOfIterations(SizeValueType iterations)
  {
    if (m_OnePlusOne != nullptr)
    {
      m_OnePlusOne->SetMaximumIteration(iterations);
    }
    else if (m_Exhaustive == nullptr)
    {
      m_Optimizer->SetNumberOfIterations(iterations);
    }
  }

  void
  SetBounds()
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

  /** The best candidates of the level's grid that are no neighbours of each other, best first. */
  std::vector<ParametersType>
  FindStarts(std::size_t & numberOfCandidates)
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

  /** Returns the stop condition. */
  std::string
  RunOptimizer(const ParametersType & start)
  {
    if (m_Level->numberOfIterations > 0)
    {
      this->SetNumberOfIterations(m_Level->numberOfIterations);
    }
    else
    {
      this->SetNumberOfIterations(m_NumberOfIterations);
    }
    ParametersType position(start);
    m_Metric->SetParameters(position);
    if (m_LBFGSB != nullptr)
    {
      LBFGSBOptimizerv4::BoundSelectionType selection(4);
      selection.Fill(LBFGSBOptimizerv4::BOTHBOUNDED);
      m_LBFGSB->SetLowerBound(MakeArray(m_Lower));
      m_LBFGSB->SetUpperBound(MakeArray(m_Upper));
      m_LBFGSB->SetBoundSelection(selection);
      m_LBFGSB->SetInitialPosition(start);
    }
    if (m_SetSimplex)
    {
      ParametersType simplex(4);
      for (unsigned int i = 0; i < 4; ++i)
      {
        simplex[i] = 0.125 * (m_Upper[i] - m_Lower[i]);
      }
      m_Amoeba->SetInitialSimplexDelta(simplex, false);
    }
    if (m_Exhaustive != nullptr)
    {
      const auto & steps = m_Exhaustive->GetNumberOfSteps();
      if (steps.GetSize() != 4)
      {
        itkGenericExceptionMacro("ExhaustiveOptimizerv4 has " << steps.GetSize()
                                                              << " numbers of steps; call SetNumberOfSteps() with 4.");
      }
      if (m_SetScales)
      {
        OptimizerType::ScalesType scales(4);
        for (unsigned int i = 0; i < 4; ++i)
        {
          const double reach = std::min(m_Upper[i] - start[i], start[i] - m_Lower[i]);
          scales[i] = steps[i] > 0 ? reach / (steps[i] * m_Exhaustive->GetStepLength()) : 1.0;
        }
        m_Exhaustive->SetScales(scales);
      }
    }
    m_Optimizer->SetMetric(m_Metric);
    {
      std::unique_lock<std::recursive_mutex> lock(OneAtATime(), std::defer_lock);
      if (m_LBFGSB != nullptr)
      {
        lock.lock();
      }
      m_Optimizer->StartOptimization();
    }
    if (m_LBFGSB != nullptr && m_Optimizer->GetCurrentIteration() >= m_Optimizer->GetNumberOfIterations())
    {
      // ITK's text for it is "User requested".
      std::ostringstream text;
      text << m_Optimizer->GetNameOfClass() << ": Maximum number of iterations ("
           << m_Optimizer->GetNumberOfIterations() << ") reached.";
      return text.str();
    }
    return m_Optimizer->GetStopConditionDescription();
  }

  void
  OnEvent(const EventObject & event)
  {
    this->CheckAbort();
    // A step that was refused is no iteration, and the metric does not stand at the position that counts.
    if (m_LevenbergMarquardt != nullptr && !m_LevenbergMarquardt->GetStepAccepted())
    {
      return;
    }
    // Evaluations are reported by subclasses; Amoeba reports nothing else.
    if (typeid(event) == typeid(IterationEvent) ||
        (m_Amoeba != nullptr && typeid(event) == typeid(FunctionEvaluationIterationEvent)))
    {
      ++m_IterationsOfStart;
      ++m_Method->m_OptimizerIteration;
      m_Method->m_OptimizerPosition = MakeParameters(m_Metric->GetCurrentSimilarity());
      // The metric's own parameters are pixels.
      const ParametersType position = m_Metric->GetOptimizerParameters(m_Metric->GetCurrentSimilarity());
      m_Method->m_StepLength = (position - m_LastPosition).two_norm();
      m_LastPosition = position;
      m_Method->m_MetricValue = m_Metric->GetCurrentValue();
      m_Method->InvokeEvent(IterationEvent());
      const double done = static_cast<double>(m_IterationsOfStart);
      this->ReportProgress(m_StartFraction + m_StartShare * done / (done + 20.0));
    }
  }

  void
  ReportProgress(double fractionOfLevel)
  {
    const double done =
      (m_Method->m_CurrentLevel + fractionOfLevel) / static_cast<double>(m_Method->GetNumberOfLevels());
    m_Method->UpdateProgress(static_cast<float>(done));
    this->CheckAbort();
  }

  void
  CheckAbort()
  {
    if (m_Method->GetAbortGenerateData())
    {
      std::ostringstream text;
      text << "Aborted in level " << m_Method->m_CurrentLevel << " after " << m_Method->m_OptimizerIteration
           << " iterations.";
      m_Method->m_StopConditionDescription = text.str();
      ProcessAborted exception(__FILE__, __LINE__);
      exception.SetDescription(text.str());
      throw exception;
    }
  }

  Self *                          m_Method;
  MetricType::Pointer             m_Metric;
  OptimizerType::Pointer          m_Optimizer;
  SizeValueType                   m_NumberOfIterations;
  unsigned long                   m_ObserverTag{ 0 };
  LBFGSBOptimizerv4 *             m_LBFGSB{ nullptr };
  AmoebaOptimizerv4 *             m_Amoeba{ nullptr };
  LevenbergMarquardtOptimizerv4 * m_LevenbergMarquardt{ nullptr };
  ExhaustiveType *                m_Exhaustive{ nullptr };
  OnePlusOneType *                m_OnePlusOne{ nullptr };
  bool                            m_SetSimplex{ false };
  bool                            m_SetScales{ false };
  const LevelType *               m_Level{ nullptr };
  ParametersType                  m_Lower;
  ParametersType                  m_Upper;
  double                          m_StartFraction{ 0.0 };
  double                          m_StartShare{ 0.0 };
  std::size_t                     m_IterationsOfStart{ 0 };
  ParametersType                  m_LastPosition;
};

SilhouetteToContourRegistrationMethod::SilhouetteToContourRegistrationMethod()
  : m_InitialParameters(4)
  , m_OptimizerPosition(4)
{
  this->SetPrimaryInputName("FixedContour");
  this->AddRequiredInputName("MovingContour", 1);
  this->AddOptionalInputName("InitialTransform", 2);
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
  m_InitialParameters.Fill(0.0);
  m_OptimizerPosition.Fill(0.0);
  this->SetMetric(nullptr);
  this->SetOptimizer(nullptr);
  this->SetPresetToPaper();
}

void
SilhouetteToContourRegistrationMethod::SetMetric(MetricType * metric)
{
  if (metric == nullptr || m_Metric != metric)
  {
    m_Metric = metric == nullptr ? ContourChamferMetricv4::New().GetPointer() : metric;
    this->Modified();
  }
}

void
SilhouetteToContourRegistrationMethod::SetOptimizer(OptimizerType * optimizer)
{
  if (optimizer == nullptr)
  {
    m_Optimizer = LBFGSBOptimizerv4::New();
    this->Modified();
  }
  else if (m_Optimizer != optimizer)
  {
    m_Optimizer = optimizer;
    this->Modified();
  }
}

void
SilhouetteToContourRegistrationMethod::SetNumberOfLevels(unsigned int numberOfLevels)
{
  if (numberOfLevels == m_Levels.size())
  {
    return;
  }
  if (numberOfLevels < m_Levels.size())
  {
    m_Levels.resize(numberOfLevels);
  }
  while (m_Levels.size() < numberOfLevels)
  {
    LevelType level;
    if (m_Levels.empty())
    {
      level.rotationBound = 20.0 * DegreesToRadians;
      level.translationBound = 15.0;
    }
    else
    {
      level = m_Levels.back();
      level.scaleBound *= 0.5;
      level.rotationBound *= 0.5;
      level.translationBound *= 0.5;
      level.numberOfScales = 0;
      level.numberOfRotations = 0;
      level.numberOfTranslations = 0;
      level.numberOfStarts = 1;
    }
    m_Levels.push_back(level);
  }
  this->Modified();
}

void
SilhouetteToContourRegistrationMethod::SetLevel(unsigned int index, const LevelType & level)
{
  if (index >= m_Levels.size())
  {
    itkExceptionMacro("There is no level " << index << " of " << m_Levels.size()
                                           << "; call SetNumberOfLevels() first.");
  }
  if (!(level.scaleBound >= 0.0 && level.scaleBound < 1.0))
  {
    itkExceptionMacro("The bound on the scale, " << level.scaleBound << ", is not in [0, 1); 0.35 means +-35 %.");
  }
  if (!(level.rotationBound >= 0.0 && level.rotationBound <= Math::pi))
  {
    itkExceptionMacro("The bound on the rotation, " << level.rotationBound << " rad, is not in [0, pi].");
  }
  if (!(level.translationBound >= 0.0 && std::isfinite(level.translationBound)))
  {
    itkExceptionMacro("The bound on the shift, " << level.translationBound << " mm, is negative or not finite.");
  }
  if (level.numberOfStarts == 0)
  {
    itkExceptionMacro("A level needs at least one start.");
  }
  m_Levels[index] = level;
  this->Modified();
}

auto
SilhouetteToContourRegistrationMethod::GetLevel(unsigned int index) const -> const LevelType &
{
  if (index >= m_Levels.size())
  {
    itkExceptionMacro("There is no level " << index << " of " << m_Levels.size() << ".");
  }
  return m_Levels[index];
}

void
SilhouetteToContourRegistrationMethod::SetPixelSpacing(double spacing)
{
  if (!(spacing > 0.0) || !std::isfinite(spacing))
  {
    itkExceptionMacro("The pixel spacing " << spacing << " mm must be positive.");
  }
  if (spacing != m_PixelSpacing)
  {
    m_PixelSpacing = spacing;
    this->Modified();
  }
}

void
SilhouetteToContourRegistrationMethod::SetPresetToPaper()
{
  LevelType coarse;
  coarse.scaleBound = 0.35;
  coarse.rotationBound = 20.0 * DegreesToRadians;
  coarse.translationBound = 15.0;
  coarse.numberOfScales = 5;
  coarse.numberOfRotations = 5;
  coarse.numberOfTranslations = 7;
  coarse.numberOfStarts = 4;
  coarse.numberOfIterations = 60;
  LevelType fine;
  fine.scaleBound = 0.10;
  fine.rotationBound = 6.0 * DegreesToRadians;
  fine.translationBound = 3.75;
  fine.numberOfIterations = 100;
  LevelType superFine;
  superFine.scaleBound = 0.03;
  superFine.rotationBound = 2.0 * DegreesToRadians;
  superFine.translationBound = 1.0;
  superFine.numberOfIterations = 200;
  m_Levels = { coarse, fine, superFine };
  this->Modified();
}

void
SilhouetteToContourRegistrationMethod::SetPresetToBoundingBox()
{
  m_Levels.clear();
  this->Modified();
}

void
SilhouetteToContourRegistrationMethod::SetPresetToSingleStage()
{
  LevelType level;
  level.scaleBound = 0.35;
  level.rotationBound = 20.0 * DegreesToRadians;
  level.translationBound = 15.0;
  level.numberOfIterations = 80;
  m_Levels = { level };
  this->Modified();
}

void
SilhouetteToContourRegistrationMethod::SetPresetToGlobal()
{
  LevelType scan;
  scan.scaleBound = 0.5;
  scan.rotationBound = 45.0 * DegreesToRadians;
  scan.translationBound = 15.0;
  scan.numberOfScales = 5;
  scan.numberOfRotations = 9;
  scan.numberOfTranslations = 5;
  scan.numberOfStarts = 4;
  scan.numberOfIterations = 15;
  LevelType finish;
  finish.scaleBound = 0.10;
  finish.rotationBound = 6.0 * DegreesToRadians;
  finish.translationBound = 3.75;
  finish.numberOfIterations = 100;
  m_Levels = { scan, finish };
  this->Modified();
}

DataObject::Pointer
SilhouetteToContourRegistrationMethod::MakeOutput(DataObjectPointerArraySizeType)
{
  return DecoratedTransformType::New().GetPointer();
}

auto
SilhouetteToContourRegistrationMethod::GetOutput() -> DecoratedTransformType *
{
  return static_cast<DecoratedTransformType *>(this->ProcessObject::GetOutput(0));
}

auto
SilhouetteToContourRegistrationMethod::GetOutput() const -> const DecoratedTransformType *
{
  return static_cast<const DecoratedTransformType *>(this->ProcessObject::GetOutput(0));
}

auto
SilhouetteToContourRegistrationMethod::GetTransform() const -> const TransformType *
{
  return this->GetOutput()->Get();
}

auto
SilhouetteToContourRegistrationMethod::ComputeBoundingBoxTransform(const ContourType * fixed,
                                                                   const ContourType * moving) -> TransformType::Pointer
{
  if (fixed == nullptr || moving == nullptr)
  {
    itkGenericExceptionMacro("The bounding-box start needs a fixed and a moving contour.");
  }
  const auto transform = TransformType::New();
  transform->SetParameters(MakeParameters(ComputeBoundingBoxSimilarity(*fixed, *moving)));
  return transform;
}

ModifiedTimeType
SilhouetteToContourRegistrationMethod::GetMTime() const
{
  ModifiedTimeType latest = Superclass::GetMTime();
  if (m_Metric && m_Metric->GetMTime() != m_MetricMTimeAfterRun)
  {
    latest = std::max(latest, m_Metric->GetMTime());
  }
  if (m_Optimizer && m_Optimizer->GetMTime() != m_OptimizerMTimeAfterRun)
  {
    latest = std::max(latest, m_Optimizer->GetMTime());
  }
  return latest;
}

void
SilhouetteToContourRegistrationMethod::VerifyPreconditions() ITKv5_CONST
{
  if (this->GetFixedContour() == nullptr)
  {
    itkExceptionMacro("No fixed contour: call SetFixedContour() with the tracing.");
  }
  if (this->GetMovingContour() == nullptr)
  {
    itkExceptionMacro("No moving contour: call SetMovingContour() with the projected silhouette.");
  }
  Superclass::VerifyPreconditions();
}

void
SilhouetteToContourRegistrationMethod::GenerateData()
{
  m_LevelResults.clear();
  m_CurrentLevel = 0;
  m_OptimizerIteration = 0;
  m_StopConditionDescription.clear();

  ContourSimilarity similarity = ComputeBoundingBoxSimilarity(*this->GetFixedContour(), *this->GetMovingContour());
  if (const TransformType * initial = this->GetInitialTransform())
  {
    similarity.scale = initial->GetScale();
    similarity.angle = initial->GetAngle();
    similarity.tx = initial->GetOffset()[0];
    similarity.ty = initial->GetOffset()[1];
    if (!(similarity.scale > 0.0))
    {
      itkExceptionMacro("The initial transform's scale " << similarity.scale << " is not positive.");
    }
  }
  m_InitialParameters = MakeParameters(similarity);
  m_OptimizerPosition = m_InitialParameters;

  const auto transform = TransformType::New();
  transform->SetParameters(m_InitialParameters);
  {
    RunType run(this);
    m_Metric->SetFixedObject(this->GetFixedContour());
    m_Metric->SetMovingObject(this->GetMovingContour());
    m_Metric->SetMovingTransform(transform);
    if (m_FixTranslation)
    {
      MetricType::PointType origin;
      origin.Fill(0.0);
      m_Metric->SetPivot(origin);
    }
    else
    {
      m_Metric->UseCentroidAsPivot();
    }
    m_Metric->Initialize();
    ParametersType origin(4);
    origin.Fill(0.0);
    m_MetricValue = m_Metric->EvaluateAt(origin);
    for (unsigned int level = 0; level < m_Levels.size(); ++level)
    {
      similarity = run.RunLevel(level, similarity);
    }
    if (m_Levels.empty())
    {
      m_StopConditionDescription = "No level: the start is the result.";
    }
  }
  const auto result = TransformType::New();
  result->SetParameters(MakeParameters(similarity));
  this->GetOutput()->Set(result);
  this->UpdateProgress(1.0f);
}

void
SilhouetteToContourRegistrationMethod::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  itkPrintSelfObjectMacro(Metric);
  // By name: an optimizer of ITK that has no metric yet throws when it is printed.
  os << indent << "Optimizer: " << m_Optimizer->GetNameOfClass() << " (" << m_Optimizer.GetPointer() << ")"
     << std::endl;
  os << indent << "Levels: " << m_Levels.size() << std::endl;
  for (const LevelType & level : m_Levels)
  {
    os << indent.GetNextIndent() << "scale +-" << level.scaleBound << ", rotation +-" << level.rotationBound
       << " rad, shift +-" << level.translationBound << " mm, candidates " << level.numberOfScales << " x "
       << level.numberOfRotations << " x " << level.numberOfTranslations << "^2, starts " << level.numberOfStarts
       << ", iterations " << level.numberOfIterations << std::endl;
  }
  os << indent << "PixelSpacing: " << m_PixelSpacing << std::endl;
  os << indent << "RandomSeed: " << m_RandomSeed << std::endl;
  os << indent << "FixScale: " << (m_FixScale ? "On" : "Off") << std::endl;
  os << indent << "FixRotation: " << (m_FixRotation ? "On" : "Off") << std::endl;
  os << indent << "FixTranslation: " << (m_FixTranslation ? "On" : "Off") << std::endl;
  os << indent << "InitialParameters: " << m_InitialParameters << std::endl;
  os << indent << "LevelResults: " << m_LevelResults.size() << std::endl;
  os << indent << "CurrentLevel: " << m_CurrentLevel << std::endl;
  os << indent << "CurrentCandidate: " << m_CurrentCandidate << std::endl;
  os << indent << "StepLength: " << m_StepLength << std::endl;
  os << indent << "OptimizerIteration: " << m_OptimizerIteration << std::endl;
  os << indent << "MetricValue: " << m_MetricValue << std::endl;
  os << indent << "OptimizerPosition: " << m_OptimizerPosition << std::endl;
  os << indent << "StopConditionDescription: " << m_StopConditionDescription << std::endl;
  os << indent << "MetricMTimeAfterRun: " << m_MetricMTimeAfterRun << std::endl;
  os << indent << "OptimizerMTimeAfterRun: " << m_OptimizerMTimeAfterRun << std::endl;
}
} // namespace itk

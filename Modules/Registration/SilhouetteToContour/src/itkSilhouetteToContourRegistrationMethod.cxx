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

#include "itkSilhouetteToContourPresets.h"
#include "itkSilhouetteToContourRun.h"

#include "itkContourChamferMetricv4.h"

#include "itkLBFGSBOptimizerv4.h"
#include "itkMath.h"

#include <algorithm>
#include <cmath>

namespace itk
{
SilhouetteToContourRegistrationMethod::SilhouetteToContourRegistrationMethod()
{
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
      level.rotationBound = 20.0 * (Math::pi / 180.0);
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
  m_Levels = MakePresetLevels(SilhouetteToContourPresetEnum::Paper);
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
  m_Levels = MakePresetLevels(SilhouetteToContourPresetEnum::SingleStage);
  this->Modified();
}

void
SilhouetteToContourRegistrationMethod::SetPresetToGlobal()
{
  m_Levels = MakePresetLevels(SilhouetteToContourPresetEnum::Global);
  this->Modified();
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
SilhouetteToContourRegistrationMethod::GenerateData()
{
  m_LevelResults.clear();
  ContourSimilarity similarity = this->StartRun();

  const auto transform = TransformType::New();
  transform->SetParameters(this->GetInitialParameters());
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
    this->SetIteration(0, 0, m_Metric->EvaluateAt(origin), similarity);
    for (unsigned int level = 0; level < m_Levels.size(); ++level)
    {
      similarity = run.RunLevel(level, similarity);
    }
    if (m_Levels.empty())
    {
      this->SetStopConditionDescription("No level: the start is the result.");
    }
  }
  this->SetResult(similarity);
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
  os << indent << "LevelResults: " << m_LevelResults.size() << std::endl;
  os << indent << "CurrentCandidate: " << m_CurrentCandidate << std::endl;
  os << indent << "StepLength: " << m_StepLength << std::endl;
  os << indent << "MetricMTimeAfterRun: " << m_MetricMTimeAfterRun << std::endl;
  os << indent << "OptimizerMTimeAfterRun: " << m_OptimizerMTimeAfterRun << std::endl;
}
} // namespace itk

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
#include "itkCaseCourse.h"

#include "itkCasePoseDescription.h"

#include "itkCommand.h"
#include "itkMath.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <typeinfo>
#include <utility>

namespace itk
{
namespace
{
using JawEnum = ToothCode::JawEnum;

/** The names of the stages that have steps; hypotheses have their own criterion and are not among them. */
const std::map<unsigned int, std::string> StageNames{
  { static_cast<unsigned int>(PoseStageEnum::Start), "start" },
  { static_cast<unsigned int>(PoseStageEnum::Candidates), "candidates" },
  { static_cast<unsigned int>(PoseStageEnum::Refinement), "refinement" }
};

/** The recorder keeps parameters of any method. */
PoseParameters
ToPose(const std::vector<double> & parameters)
{
  PoseParameters pose{ {} };
  std::copy(parameters.begin(), parameters.end(), pose.begin());
  return pose;
}
} // namespace

CaseStepObserver::CaseStepObserver(MethodType * method)
  : m_Method(method)
{
  auto command = FunctionCommand::New();
  command->SetCallback([this](const EventObject & event) {
    const PoseRegistrationIteration & iteration = m_Method->GetCurrentIteration();
    if (typeid(event) != typeid(IterationEvent) || iteration.hypothesis)
    {
      return;
    }
    const LeastSquaresIteration & step = iteration.step;
    m_Recorder.Add(iteration.group,
                   static_cast<unsigned int>(iteration.stage),
                   iteration.candidate,
                   { step.value, step.accepted, step.stepLength, iteration.kernelWidth },
                   { iteration.pose.begin(), iteration.pose.end() });
  });
  m_Tag = method->AddObserver(IterationEvent(), command);
}

CaseStepObserver::~CaseStepObserver()
{
  m_Method->RemoveObserver(m_Tag);
}

void
KeepCourse(const RegistrationCourseRecorder & recorder,
           const PoseSolution *               solution,
           double                             millimetresPerUnit,
           CaseResult &                       result)
{
  const PoseRegistrationResult & found = solution->GetResult();
  for (std::size_t g = 0; g < found.groups.size(); ++g)
  {
    const PoseGroupResult & group = found.groups[g];
    std::vector<JawEnum>    jaws;
    for (const std::size_t j : group.jaws)
    {
      jaws.push_back(found.jaws[j].jaw);
    }
    auto stages = recorder.Finish(static_cast<unsigned int>(g),
                                  jaws,
                                  StageNames,
                                  { group.parameters.begin(), group.parameters.end() },
                                  [&](const std::vector<double> & from, const std::vector<double> & to) {
                                    return solution->ComputeMotion(g, ToPose(from), ToPose(to));
                                  });
    if (stages.empty())
    {
      continue;
    }
    stages.back().stopCondition = group.stopCondition;
    for (const RegistrationStageCourse & stage : stages)
    {
      for (const RegistrationCandidateCourse & candidate : stage.candidates)
      {
        if (!candidate.chosen)
        {
          continue;
        }
        for (const std::size_t j : group.jaws)
        {
          const PoseJawResult & jaw = found.jaws[j];
          if (jaw.registered)
          {
            const auto projection = solution->GetProjectionMatrix(jaw.jaw, ToPose(candidate.first), millimetresPerUnit);
            result.jaws[jaw.jaw].stages.push_back({ stage.name, ToRows(projection), {} });
          }
        }
      }
    }
    result.jaws[jaws.front()].course = stages;
  }
}

std::vector<ParameterPrior>
DescribePriors(const PoseGroupResult & group, const PosePriors::SigmasType & sigmas)
{
  constexpr double                      degrees = 180.0 / Math::pi;
  const std::pair<const char *, double> names[] = { { "pitch_deg", degrees }, { "roll_deg", degrees },
                                                    { "yaw_deg", degrees },   { "x_mm", 1.0 },
                                                    { "y_mm", 1.0 },          { "z_mm", 1.0 },
                                                    { "scale", 1.0 } };
  std::vector<ParameterPrior>           priors;
  for (unsigned int k = 0; k < 7; ++k)
  {
    // 0 is held, infinity is free: of neither there is a prior.
    if (sigmas[k] > 0.0 && std::isfinite(sigmas[k]))
    {
      priors.push_back(
        { names[k].first, names[k].second * group.parameters[k], names[k].second * sigmas[k], group.priorTension[k] });
    }
  }
  return priors;
}
} // namespace itk

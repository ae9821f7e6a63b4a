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

#include "itkPoseFrameOperations.h"
#include "itkPoseModel.h"

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

/** How far the outlines of the jaws of a group are apart under two poses: root mean square, pixels of 0.25 mm, as steps
 * are measured. */
double
MeasureMotion(const PoseRegistrationResult & found,
              const PoseGroupResult &        group,
              const std::vector<double> &    from,
              const std::vector<double> &    to)
{
  double         sum = 0.0;
  std::size_t    count = 0;
  PoseParameters poses[2];
  std::copy(from.begin(), from.end(), poses[0].begin());
  std::copy(to.begin(), to.end(), poses[1].begin());
  const PoseModel models[2] = { PoseModel(found.geometry, poses[0]), PoseModel(found.geometry, poses[1]) };
  for (const std::size_t j : group.jaws)
  {
    for (const auto & point : found.jaws[j].contourPoints)
    {
      const auto p = ToDentalFrame(found.jaws[j].frame, point);
      double     w[2][2];
      if (models[0].Project(p.data(), w[0]) && models[1].Project(p.data(), w[1]))
      {
        const double du = w[1][0] - w[0][0];
        const double dv = w[1][1] - w[0][1];
        sum += du * du + dv * dv;
        ++count;
      }
    }
  }
  return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0.0;
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
                                    return MeasureMotion(found, group, from, to);
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
        PoseParameters pose{ {} };
        std::copy(candidate.first.begin(), candidate.first.end(), pose.begin());
        for (const std::size_t j : group.jaws)
        {
          const PoseJawResult & jaw = found.jaws[j];
          if (jaw.registered)
          {
            auto projection = PoseModel(found.geometry, pose).GetPixelProjection(jaw.frame);
            for (unsigned int i = 0; i < 12; ++i)
            {
              projection[i] *= i % 4 < 3 ? millimetresPerUnit : 1.0;
            }
            result.jaws[jaw.jaw].stages.push_back({ stage.name, projection, {} });
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

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
#include "itkRegistrationCourseRecorder.h"

#include <cmath>
#include <limits>

namespace itk
{
void
RegistrationCourseRecorder::Add(unsigned int                group,
                                unsigned int                stage,
                                unsigned int                candidate,
                                const RegistrationStep &    step,
                                const std::vector<double> & position)
{
  RegistrationCandidateCourse & course = m_Courses[{ group, stage, candidate }];
  if (course.steps.empty())
  {
    course.candidate = candidate;
    course.first = position;
  }
  course.steps.push_back(step);
  course.last = position;
}

std::vector<RegistrationStageCourse>
RegistrationCourseRecorder::Finish(unsigned int                                group,
                                   const std::vector<ToothCode::JawEnum> &     jaws,
                                   const std::map<unsigned int, std::string> & names,
                                   const std::vector<double> &                 solution,
                                   const DistanceType &                        distance) const
{
  std::vector<RegistrationStageCourse> stages;
  for (const auto & name : names)
  {
    RegistrationStageCourse stage;
    stage.jaws = jaws;
    stage.name = name.second;
    for (auto course = m_Courses.lower_bound({ group, name.first, 0 });
         course != m_Courses.end() && std::get<0>(course->first) == group && std::get<1>(course->first) == name.first;
         ++course)
    {
      stage.candidates.push_back(course->second);
    }
    if (!stage.candidates.empty())
    {
      stages.push_back(stage);
    }
  }
  std::vector<double> target = solution;
  double              expected = 0.0;
  for (auto stage = stages.rbegin(); stage != stages.rend(); ++stage)
  {
    RegistrationCandidateCourse * nearest = nullptr;
    double                        least = std::numeric_limits<double>::max();
    for (RegistrationCandidateCourse & candidate : stage->candidates)
    {
      const double away = std::abs(distance(candidate.last, target) - expected);
      if (away < least)
      {
        least = away;
        nearest = &candidate;
      }
    }
    if (nearest != nullptr)
    {
      nearest->chosen = true;
      target = nearest->first;
      expected = nearest->steps.front().accepted ? nearest->steps.front().length : 0.0;
    }
  }
  return stages;
}
} // namespace itk

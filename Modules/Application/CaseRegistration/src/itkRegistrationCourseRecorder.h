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
#ifndef itkRegistrationCourseRecorder_h
#define itkRegistrationCourseRecorder_h

#include "itkRegistrationCourse.h"

#include <functional>
#include <map>
#include <tuple>

namespace itk
{
/** Keeps the steps of a registration by group of jaws, stage and candidate. Steps of several candidates may arrive in
 * turns; what is kept does not depend on it, and hence not on the number of threads. */
class RegistrationCourseRecorder
{
public:
  void
  Add(unsigned int                group,
      unsigned int                stage,
      unsigned int                candidate,
      const RegistrationStep &    step,
      const std::vector<double> & position);

  /** How far apart two positions are. */
  using DistanceType = std::function<double(const std::vector<double> &, const std::vector<double> &)>;

  /** The stages of a group in their order, the way to the solution marked: the candidate of the last stage that ended
   * at it, and back from stage to stage the one that ended where that one began. An observer sees a candidate after its
   * first step only: the one before it ended as far from there as that step was long, which tells apart those that
   * ended at one place. */
  std::vector<RegistrationStageCourse>
  Finish(unsigned int                                group,
         const std::vector<ToothCode::JawEnum> &     jaws,
         const std::map<unsigned int, std::string> & names,
         const std::vector<double> &                 solution,
         const DistanceType &                        distance) const;

private:
  /** By group, stage, candidate. */
  std::map<std::tuple<unsigned int, unsigned int, unsigned int>, RegistrationCandidateCourse> m_Courses;
};
} // namespace itk

#endif

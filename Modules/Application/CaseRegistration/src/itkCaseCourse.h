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
#ifndef itkCaseCourse_h
#define itkCaseCourse_h

#include "itkCaseResult.h"
#include "itkPosePriors.h"
#include "itkPoseRegistrationMethod.h"
#include "itkPoseSolution.h"
#include "itkRegistrationCourseRecorder.h"

#include <vector>

namespace itk
{
/** Not installed. Listens to the steps of a method as long as it lives. */
class CaseStepObserver
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(CaseStepObserver);
  using MethodType = PoseRegistrationMethod<DentalCaseData::MeshType>;
  explicit CaseStepObserver(MethodType * method);
  ~CaseStepObserver();

  const RegistrationCourseRecorder &
  GetRecorder() const
  {
    return m_Recorder;
  }

private:
  MethodType *               m_Method;
  unsigned long              m_Tag{ 0 };
  RegistrationCourseRecorder m_Recorder;
};

/** What the method did, and where each jaw was when its stages began. */
void
KeepCourse(const RegistrationCourseRecorder & recorder,
           const PoseSolution *               solution,
           double                             millimetresPerUnit,
           CaseResult &                       result);

/** Of each parameter that has one. */
std::vector<ParameterPrior>
DescribePriors(const PoseGroupResult & group, const PosePriors::SigmasType & sigmas);
} // namespace itk

#endif

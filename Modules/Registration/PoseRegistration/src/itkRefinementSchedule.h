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
#ifndef itkRefinementSchedule_h
#define itkRefinementSchedule_h

#include "itkPoseRegistrationIteration.h"

#include <vector>

namespace itk
{
/** \struct RefinementSchedule
 * \brief How a candidate is refined.
 * \ingroup PoseRegistration
 */
struct RefinementSchedule
{
  /** Of the kernel, px, one after the other; the last stays, unless the noise is estimated. */
  std::vector<double> widths;
  unsigned int        maximumEvaluations{ 14 };
  /** Of the last step, px. */
  double tolerance{ 0.005 };
  bool   similarityOnly{ false };
  bool   correlated{ true };
  bool   estimateNoise{ true };
  /** Near the end already: the noise is estimated before the first step, and no width comes before its own. */
  bool          isNear{ false };
  PoseStageEnum stage{ PoseStageEnum::Refinement };
};
} // namespace itk

#endif

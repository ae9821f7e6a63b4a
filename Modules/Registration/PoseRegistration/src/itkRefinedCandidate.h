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
#ifndef itkRefinedCandidate_h
#define itkRefinedCandidate_h

#include "itkLeastSquaresMetricv4.h"

#include <string>

namespace itk
{
/** \struct RefinedCandidate
 * \brief A pose on its way: where it is, the noise as it is estimated there, and how it fits.
 * \ingroup PoseRegistration
 */
struct RefinedCandidate
{
  LeastSquaresMetricv4::PositionType x;
  ContourNoiseLevels                 noise;
  unsigned int                       evaluations{ 0 };
  bool                               converged{ false };
  std::string                        stopCondition;
  double                             cost{ 1.0 };
  double                             codeTerm{ 0.0 };
  double                             score{ 1.0 };
  double                             deviance{ 0.0 };
};
} // namespace itk

#endif

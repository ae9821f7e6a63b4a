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
#ifndef itkRegistrationIterationInformation_h
#define itkRegistrationIterationInformation_h

#include "RegistrationCommonExport.h"

#include "itkOptimizerParameters.h"

#include <string>

namespace itk
{
/** \class RegistrationIterationInformation
 * \brief What an observer may ask a registration method inside an event, whatever it registers.
 *
 * Registration methods of this toolkit derive from it beside ProcessObject, so that RegistrationIterationCommand logs
 * any of them.
 *
 * \ingroup RegistrationCommon
 */
class RegistrationCommon_EXPORT RegistrationIterationInformation
{
public:
  virtual ~RegistrationIterationInformation();

  /** Level that runs or ran last, 0 the coarsest. */
  virtual unsigned int
  GetCurrentLevel() const = 0;

  /** Which of the candidates that are refined in this level, one after the other or at the same time; 0 by default, for
   * methods that refine one. */
  virtual unsigned int
  GetCurrentCandidate() const;

  /** Iteration of the optimizer within the level. */
  virtual std::size_t
  GetOptimizerIteration() const = 0;

  /** Value of the metric at GetOptimizerPosition(). */
  virtual double
  GetMetricValue() const = 0;

  /** Parameters of the transform (not the optimizer's balanced ones). */
  virtual OptimizerParameters<double>
  GetOptimizerPosition() const = 0;

  /** How far the step that is reported moves what is matched, in the method's own unit of length; 0 by default, for
   * methods that do not know. */
  virtual double
  GetStepLength() const;

  /** Whether that step was taken; true by default, for methods that report no others. */
  virtual bool
  GetStepAccepted() const;

  /** Why the optimizer stopped; of the level before while a level starts; empty before the first. */
  virtual std::string
  GetOptimizerStopConditionDescription() const = 0;
};
} // namespace itk

#endif

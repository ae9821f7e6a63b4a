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
#ifndef itkLeastSquaresIteration_h
#define itkLeastSquaresIteration_h

#include "itkIntTypes.h"
#include "itkOptimizerParameters.h"

namespace itk
{
/** \struct LeastSquaresIteration
 * \brief One tried step of LevenbergMarquardtOptimizerv4, as its observers see it.
 *
 * LevenbergMarquardtOptimizerv4::GetLastIteration() makes one, LevenbergMarquardtOptimizerv4::ReportIteration() passes
 * one of another run on to the observers.
 *
 * \ingroup RegistrationCommon
 */
struct LeastSquaresIteration
{
  /** Best position so far, in the metric's parameters. */
  OptimizerParameters<double> position;
  /** Value of the metric there. */
  double value{ 0.0 };
  /** Value at the position that was tried; equal to value where the step was accepted. */
  double trialValue{ 0.0 };
  /** How far away that is, in the metric's own unit of length. */
  double stepLength{ 0.0 };
  /** Damping after an accepted step, as the next one uses it; that of the trial where the step was rejected. */
  double damping{ 0.0 };
  /** Whether the step lowered the value. */
  bool accepted{ false };
  /** Steps accepted so far. */
  SizeValueType iteration{ 0 };
  /** Steps tried so far. */
  SizeValueType evaluations{ 0 };
};
} // namespace itk

#endif

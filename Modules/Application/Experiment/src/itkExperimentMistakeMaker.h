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
#ifndef itkExperimentMistakeMaker_h
#define itkExperimentMistakeMaker_h

#include "itkDentalCaseData.h"
#include "itkExperimentMistake.h"

namespace itk
{
/** Spoils a phantom case; its tracing, where another side's or patient's is asked for, must be that already. */
void
MakeExperimentMistake(ExperimentMistakeEnums::Mistake mistake, DentalCaseData & data);
} // namespace itk

#endif

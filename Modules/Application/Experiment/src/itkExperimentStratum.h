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
#ifndef itkExperimentStratum_h
#define itkExperimentStratum_h

#include "itkExperimentPlan.h"

#include <string>
#include <vector>

namespace itk
{
/** A kind of case that the studies of coverage and verdict draw. */
struct ExperimentStratum
{
  std::string                         name;
  DentalPhantomCaseSource::CohortEnum level{ DentalPhantomCaseSource::CohortEnum::Typical };
  ExperimentVariation                 variation;
  /** One jaw at a time: two registrations a case. */
  bool oneJawAtATime{ false };
  /** How many of a round of cases are of this kind. */
  unsigned int share{ 1 };
};

/** In the order of the tables. */
const std::vector<ExperimentStratum> &
GetExperimentStrata();

/** Registers the case of a record's seed by preset robust. */
void
RunStratum(const ExperimentStratum & stratum, ExperimentRecord & record, const ExperimentMonitor & monitor);

/** The kind of the i-th case: they take turns, so that any number of cases has its share of each. */
const ExperimentStratum &
GetExperimentStratum(std::size_t i);
} // namespace itk

#endif

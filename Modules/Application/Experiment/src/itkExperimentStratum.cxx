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
#include "itkExperimentStratum.h"

#include <algorithm>

namespace itk
{
const std::vector<ExperimentStratum> &
GetExperimentStrata()
{
  static const std::vector<ExperimentStratum> strata = []() {
    using CohortEnum = DentalPhantomCaseSource::CohortEnum;
    using SideEnum = ExperimentVariation::TracedSideEnum;
    std::vector<ExperimentStratum> made;
    const auto add = [&](const char * name, CohortEnum level, unsigned int share) -> ExperimentStratum & {
      made.emplace_back();
      made.back().name = name;
      made.back().level = level;
      made.back().share = share;
      return made.back();
    };
    add("ideal", CohortEnum::Ideal, 1);
    add("typical", CohortEnum::Typical, 4);
    add("hard", CohortEnum::Hard, 4);
    add("left side traced", CohortEnum::Typical, 1).variation.tracedSide = SideEnum::Left;
    add("bisected (middle)", CohortEnum::Typical, 1).variation.tracedSide = SideEnum::Mean;
    add("both sides traced", CohortEnum::Typical, 1).variation.tracedSide = SideEnum::Both;
    add("bias of each tooth", CohortEnum::Typical, 2).variation.toothBias = 1.0;
    add("buccal outline", CohortEnum::Typical, 1).variation.buccalOutline = true;
    add("spacing not known", CohortEnum::Typical, 1).variation.knowsPixelSpacing = false;
    add("principal point not known", CohortEnum::Typical, 1).variation.knowsPrincipalPoint = false;
    add("facing left, source left", CohortEnum::Typical, 1).variation.facesLeft = true;
    add("separate frames", CohortEnum::Typical, 1).variation.separateFrames = true;
    add("one jaw at a time", CohortEnum::Typical, 1).oneJawAtATime = true;
    add("hard, one jaw at a time", CohortEnum::Hard, 1).oneJawAtATime = true;
    return made;
  }();
  return strata;
}

const ExperimentStratum &
GetExperimentStratum(std::size_t i)
{
  // Rounds of one case of each kind that has some left.
  static const std::vector<const ExperimentStratum *> order = []() {
    std::vector<const ExperimentStratum *> made;
    unsigned int                           largest = 0;
    for (const ExperimentStratum & stratum : GetExperimentStrata())
    {
      largest = std::max(largest, stratum.share);
    }
    for (unsigned int round = 0; round < largest; ++round)
    {
      for (const ExperimentStratum & stratum : GetExperimentStrata())
      {
        if (round < stratum.share)
        {
          made.push_back(&stratum);
        }
      }
    }
    return made;
  }();
  return *order[i % order.size()];
}
void
RunStratum(const ExperimentStratum & stratum, ExperimentRecord & record, const ExperimentMonitor & monitor)
{
  using JawsEnum = ExperimentVariation::JawsEnum;
  const ExperimentMethod & method = *FindExperimentMethod("robust");
  for (const JawsEnum jaws : stratum.oneJawAtATime ? std::vector<JawsEnum>{ JawsEnum::UpperAlone, JawsEnum::LowerAlone }
                                                   : std::vector<JawsEnum>{ JawsEnum::Both })
  {
    monitor.Advance(0.0);
    ExperimentVariation variation = stratum.variation;
    variation.jaws = jaws;
    const ExperimentCase experimentCase =
      MakePhantomExperimentCase(record.seed, stratum.level, false, variation, monitor.GetAbort());
    ExperimentRunner runner(experimentCase);
    runner.SetAbort(monitor.GetAbort());
    record.Add(method.name, runner.Run(method));
  }
}
} // namespace itk

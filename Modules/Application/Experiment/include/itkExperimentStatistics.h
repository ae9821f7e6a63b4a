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
#ifndef itkExperimentStatistics_h
#define itkExperimentStatistics_h

#include "ExperimentExport.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace itk
{
/** A confidence interval of the pooled mean: the cases, not their landmarks, are drawn with replacement (cluster
 * bootstrap, percentiles), since the landmarks of a case err together. Each inner vector holds one case's errors.
 * Seeded. Both ends are NaN without errors.
 *
 * \ingroup Experiment */
Experiment_EXPORT std::pair<double, double>
                  BootstrapMeanInterval(const std::vector<std::vector<double>> & cases,
                                        double                                   confidence,
                                        unsigned int                             resamples,
                                        std::uint64_t                            seed);

/** Two-sided p value of the mean of paired differences under random flips of their signs. Every combination for up to
 * 14 pairs, else `flips` seeded ones, with the observed one counted (Phipson, Smyth 2010). 1 without pairs.
 *
 * \ingroup Experiment */
Experiment_EXPORT double
SignFlipTest(const std::vector<double> & differences, unsigned int flips, std::uint64_t seed);

/** Holm's adjustment of p values for their number, in their order.
 *
 * \ingroup Experiment */
Experiment_EXPORT std::vector<double>
                  AdjustByHolm(const std::vector<double> & pValues);
} // namespace itk

#endif

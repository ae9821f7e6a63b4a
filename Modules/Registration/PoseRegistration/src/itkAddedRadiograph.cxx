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
#include "itkAddedRadiograph.h"

#include "itkForEachTerm.h"
#include "itkPoseMetricv4.h"

namespace itk
{
std::string
DescribeAddedRadiograph(const PoseProblem & problem, const std::string & what)
{
  std::string description;
  for (const PoseProblemTerm & term : problem.terms)
  {
    ForEachTerm<PoseMetricv4>(*term.metric, [&](const PoseMetricv4 & added) {
      if (description.empty())
      {
        description = std::string("the added ") + added.GetNameOfClass() + ' ' + what;
      }
    });
  }
  return description;
}
} // namespace itk

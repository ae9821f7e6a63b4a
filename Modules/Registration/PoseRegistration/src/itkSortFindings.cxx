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
#include "itkSortFindings.h"

#include <algorithm>
#include <array>

namespace itk
{
namespace
{
/** The heaviest first: of the scans, where each other one may be why there is no arch in it, of what was drawn, the
 * readings of the drawing that fit where the given one does not, and what is wrong with landmarks that only measure. */
const std::array<const char *, 26> Causes{ { "same-scan",
                                             "both-jaws",
                                             "spikes",
                                             "partial-arch",
                                             "arch-width",
                                             "no-arch",
                                             "outline-off-bite",
                                             "outline-off-landmark",
                                             "jaws-exchanged",
                                             "not-drawn",
                                             "few-points",
                                             "no-evidence",
                                             "whole-teeth",
                                             "landmarks-exchanged",
                                             "landmarks-mm",
                                             "pixel-spacing",
                                             "turned-image",
                                             "upward-drawing",
                                             "facing",
                                             "upside-down",
                                             "film-size",
                                             "picture",
                                             "principal-point",
                                             "landmarks-coincide",
                                             "landmarks-off-scan",
                                             "landmarks-order" } };

/** They may be why it does not fit, or be wrong because it does not. */
const std::array<const char *, 5> Perhaps{
  { "side-codes", "sides-exchanged", "inward-winding", "unsure-axis", "tracing-unused" }
};
} // namespace

unsigned int
GetWeightOrder(const std::string & code)
{
  const auto cause = std::find(Causes.begin(), Causes.end(), code);
  const auto count = static_cast<unsigned int>(Causes.size());
  return cause != Causes.end() ? static_cast<unsigned int>(cause - Causes.begin())
         : std::find(Perhaps.begin(), Perhaps.end(), code) != Perhaps.end() ? count
                                                                            : count + 1;
}

void
SortFindings(std::vector<RegistrationFinding> & findings)
{
  std::stable_sort(
    findings.begin(), findings.end(), [](const RegistrationFinding & left, const RegistrationFinding & right) {
      const unsigned int leftOrder = GetWeightOrder(left.code);
      const unsigned int rightOrder = GetWeightOrder(right.code);
      return leftOrder != rightOrder ? leftOrder < rightOrder : left.severity > right.severity;
    });
}
} // namespace itk

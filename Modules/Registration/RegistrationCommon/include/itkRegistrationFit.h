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
#ifndef itkRegistrationFit_h
#define itkRegistrationFit_h

#include <cstddef>

namespace itk
{
/** \struct RegistrationFit
 * \brief How well the evidence is explained at a place, by a yardstick that does not depend on the noise estimated
 * there: what candidates are ranked by.
 * \ingroup RegistrationCommon
 */
struct RegistrationFit
{
  /** Sum over the points of 1 - sqrt(w), w the Geman-McClure weight at a fixed width of 4 px: 0 where a point fits. */
  double      cost{ 0.0 };
  std::size_t numberOfPoints{ 0 };
  /** Sum over the strands with tooth codes of |arc of the teeth - expected arc of their codes|, mm. */
  double      codeOffset{ 0.0 };
  std::size_t numberOfCodedStrands{ 0 };

  /** Mean over the points; 1, nothing fits, where there are none. */
  double
  GetMeanCost() const
  {
    return numberOfPoints > 0 ? cost / static_cast<double>(numberOfPoints) : 1.0;
  }
  /** Mean over the coded strands, mm; 0 where there are none. */
  double
  GetMeanCodeOffset() const
  {
    return numberOfCodedStrands > 0 ? codeOffset / static_cast<double>(numberOfCodedStrands) : 0.0;
  }
};
} // namespace itk

#endif

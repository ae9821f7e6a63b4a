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
#ifndef itkJawExchangeEvidence_h
#define itkJawExchangeEvidence_h

#include "UMidlineDentalAxisExport.h"

#include <optional>

namespace itk
{
struct DentalFrameResult;

/** \class JawExchangeEvidence
 * \brief How probable it is, from the shapes of two scans alone, that the upper one is the lower one and the other way
 * round.
 *
 * Two things tell the jaws apart. The upper arch is the wider at the first molars, where it bites over the lower; and
 * where both are in one frame, its incisors lie in front. Either is reversed in some people (a crossbite, a class III),
 * so each is a likelihood ratio with long tails that cannot exceed 30 to 1 by itself. Their product and a prior of
 * one case in a hundred make the probability: one of the two reversed leaves it small, both together raise the alarm.
 * Documentation/UMDA.md says where the numbers are from. Free of ITK headers.
 *
 * \ingroup UMidlineDentalAxis
 */
class UMidlineDentalAxis_EXPORT JawExchangeEvidence
{
public:
  /** Measures what the frames hold. */
  explicit JawExchangeEvidence(const DentalFrameResult & frames);
  /** From the measures themselves; what is not known says nothing. */
  JawExchangeEvidence(std::optional<double> molarWidthDifference, std::optional<double> overjet);

  /** Upper less lower width at the first molars, mm; none where one of them was not found. */
  const std::optional<double> &
  GetMolarWidthDifference() const
  {
    return m_MolarWidthDifference;
  }
  /** Upper incisal edge in front of the lower one, mm; none where the jaws do not share a frame. */
  const std::optional<double> &
  GetOverjet() const
  {
    return m_Overjet;
  }
  /** Natural logarithm of the likelihood of what was measured if the scans are exchanged, over that if they are not. */
  double
  GetLogLikelihoodRatio() const;
  /** With the prior; in [0, 1]. */
  double
  GetProbability() const;

private:
  std::optional<double> m_MolarWidthDifference;
  std::optional<double> m_Overjet;
};
} // namespace itk

#endif

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
#include "itkToothCode.h"

#include <optional>

namespace itk
{
struct DentalFrameResult;
struct DentalJawFrame;
struct TriangleSurface;

/** \class JawExchangeEvidence
 * \brief How probable it is, from the shapes of two scans alone, that the upper one is the lower one and the other way
 * round.
 *
 * Three things tell the jaws apart. The upper arch is the wider at the first molars, where it bites over the lower; its
 * incisors are the wider; and where both are in one frame, they lie in front. Each is reversed in some people or
 * measured wrongly (a crossbite, crowded or missing incisors, a class III), so each is a likelihood ratio with long
 * tails that cannot exceed 30 to 1 by itself. Their product and a prior of one case in a hundred make the probability:
 * one of them reversed leaves it small, two without a third that contradicts raise the alarm.
 * Documentation/UMDA.md says where the numbers are from. Free of ITK headers.
 *
 * \ingroup UMidlineDentalAxis
 */
class UMidlineDentalAxis_EXPORT JawExchangeEvidence
{
public:
  /** Measures what the frames hold and, on the surfaces that they were estimated of, in mm, how wide the incisors look.
   * Without surfaces nothing is known of incisors. */
  explicit JawExchangeEvidence(const DentalFrameResult & frames,
                               const TriangleSurface *   upper = nullptr,
                               const TriangleSurface *   lower = nullptr);
  /** From the measures themselves; what is not known says nothing. */
  JawExchangeEvidence(std::optional<double> molarWidthDifference,
                      std::optional<double> overjet,
                      std::optional<double> incisorContrastDifference = std::nullopt);

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
  /** How much more the lower jaw's incisors look like lower ones than the upper jaw's do
   * (DentalJawFrame::incisorContrast, a difference of correlations); none where one of them was not measured. */
  const std::optional<double> &
  GetIncisorContrastDifference() const
  {
    return m_IncisorContrastDifference;
  }
  /** How much more the labial surfaces in front look like incisors as wide as lower ones (5.4 and 5.9 mm) than like
   * upper ones (8.5 and 6.5 mm): a difference of two correlations, in [-2, 2], of the shape alone. None where there is
   * no frame or too little surface in front. The frame says which way is occlusal by the name of the jaw.
   * Documentation/UMDA.md says how it is measured. */
  static std::optional<double>
  MeasureIncisorContrast(const TriangleSurface & surface, const DentalJawFrame & frame, ToothCode::JawEnum jaw);
  /** How many of the three were measured. One alone never raises the alarm. */
  unsigned int
  GetNumberOfMeasures() const;
  /** Natural logarithm of the likelihood of what was measured if the scans are exchanged, over that if they are not. */
  double
  GetLogLikelihoodRatio() const;
  /** With the prior; in [0, 1]. */
  double
  GetProbability() const;

private:
  std::optional<double> m_MolarWidthDifference;
  std::optional<double> m_Overjet;
  std::optional<double> m_IncisorContrastDifference;
};
} // namespace itk

#endif

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
#include "itkJawExchangeEvidence.h"

#include "itkDentalFrameEstimator.h"
#include "itkDentalFrameIncisors.h"

#include <cmath>

namespace itk
{
namespace
{
/** Of a hundred cases one has its scans exchanged: a judgement, as nobody counted. */
constexpr double PriorProbability = 0.01;

/** Cosine between net normal and occlusal direction below which a shell is wound inward, as the verdict has it. */
constexpr double InwardWindingAgreement = -0.1;

/** A measure in people: a normal one, and a share of others around a mean of their own, in the unit of the measure. */
struct Distribution
{
  double mean;
  double sigma;
  double otherShare;
  double otherMean;
  double otherSigma;

  double
  Density(double value) const
  {
    const auto normal = [value](double centre, double width) {
      const double z = (value - centre) / width;
      return std::exp(-0.5 * z * z) / width;
    };
    return (1.0 - otherShare) * normal(mean, sigma) + otherShare * normal(otherMean, otherSigma);
  }

  /** Exchanged scans have the measure with the other sign. */
  double
  LogRatio(double value) const
  {
    return std::log(this->Density(-value) / this->Density(value));
  }
};

/** Upper less lower width at the first molars: 2.7 mm in the median of pairs of phantom level real, seeds 1000 to 1029,
 * less than the 4.8 mm between the mesiobuccal cusps of real arches, as the lower molars lie farther forward. The
 * others are crossbites, 9 % of people (NHANES III), and arches whose midline was missed. */
constexpr Distribution MolarWidth{ 3.0, 2.5, 0.15, -2.0, 4.0 };
/** Edge to edge, the others are class III and arches whose incisors were not found: 5 % or so of people. */
constexpr Distribution Overjet{ 2.5, 1.5, 0.10, 0.0, 4.0 };
/** Lower less upper incisor contrast, a difference of correlations, of pairs of phantom level real, seeds 3000 to 3199,
 * whose fit has 1.00, 0.14, 0.48, 0.40, 0.47. The others have crowded, worn or missing incisors. Both are wider here
 * and the others nearer to 0, since teeth of people differ more: so this measure, too, stays below 30 to 1. */
constexpr Distribution IncisorContrast{ 0.95, 0.2, 0.5, 0.1, 0.55 };
} // namespace

std::optional<double>
JawExchangeEvidence::MeasureIncisorContrast(const TriangleSurface & surface,
                                            const DentalJawFrame &  frame,
                                            ToothCode::JawEnum      jaw)
{
  using namespace DentalFrameMath;
  if (!frame.valid)
  {
    return std::nullopt;
  }
  // A closed body's winding has no say: its net normal is nothing.
  const bool turned =
    frame.openness > DentalJawFrame::OpennessOfClosedCast && frame.windingAgreement < InwardWindingAgreement;
  const double offMidline = Dot(frame.incisalEdge - frame.centroid, frame.axes[1]) - frame.midlineOffset;
  return DentalFrameKernel::IncisorContrast(surface,
                                            { frame.axes[0],
                                              frame.axes[1],
                                              (jaw == ToothCode::JawEnum::Upper ? -1.0 : 1.0) * frame.axes[2],
                                              frame.incisalEdge - offMidline * frame.axes[1],
                                              turned });
}

JawExchangeEvidence::JawExchangeEvidence(const DentalFrameResult & frames,
                                         const TriangleSurface *   upper,
                                         const TriangleSurface *   lower)
{
  if (frames.upper.valid && frames.lower.valid)
  {
    if (frames.upper.molarWidth > 0.0 && frames.lower.molarWidth > 0.0)
    {
      m_MolarWidthDifference = frames.upper.molarWidth - frames.lower.molarWidth;
    }
    if (frames.jawsShareFrame)
    {
      m_Overjet = frames.overjet;
    }
    if (upper != nullptr && lower != nullptr)
    {
      const auto ofUpper = MeasureIncisorContrast(*upper, frames.upper, ToothCode::JawEnum::Upper);
      const auto ofLower = MeasureIncisorContrast(*lower, frames.lower, ToothCode::JawEnum::Lower);
      if (ofUpper && ofLower)
      {
        m_IncisorContrastDifference = *ofLower - *ofUpper;
      }
    }
  }
}

JawExchangeEvidence::JawExchangeEvidence(std::optional<double> molarWidthDifference,
                                         std::optional<double> overjet,
                                         std::optional<double> incisorContrastDifference)
  : m_MolarWidthDifference(molarWidthDifference)
  , m_Overjet(overjet)
  , m_IncisorContrastDifference(incisorContrastDifference)
{}

unsigned int
JawExchangeEvidence::GetNumberOfMeasures() const
{
  return (m_MolarWidthDifference ? 1 : 0) + (m_Overjet ? 1 : 0) + (m_IncisorContrastDifference ? 1 : 0);
}

double
JawExchangeEvidence::GetLogLikelihoodRatio() const
{
  double ratio = 0.0;
  if (m_MolarWidthDifference)
  {
    ratio += MolarWidth.LogRatio(*m_MolarWidthDifference);
  }
  if (m_Overjet)
  {
    ratio += Overjet.LogRatio(*m_Overjet);
  }
  if (m_IncisorContrastDifference)
  {
    ratio += IncisorContrast.LogRatio(*m_IncisorContrastDifference);
  }
  return ratio;
}

double
JawExchangeEvidence::GetProbability() const
{
  const double odds = PriorProbability / (1.0 - PriorProbability) * std::exp(this->GetLogLikelihoodRatio());
  return odds / (1.0 + odds);
}
} // namespace itk

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
#include "itkDentalPhantomHand.h"

#include "itkDentalPhantomMath.h"
#include "itkReproducibleRandom.h"

#include <algorithm>
#include <cmath>

namespace itk
{
using namespace DentalPhantomMath;

namespace
{
enum HandStream : std::uint64_t
{
  BiasStream = 400,
  OutlineStream = 1000,
  LandmarkStream = 2000
};
} // namespace

DentalPhantomHand::DentalPhantomHand(const DentalPhantomLevel & level,
                                     std::uint64_t              seed,
                                     const PixelType &          along,
                                     double                     spacing)
  : m_Level(level)
  , m_Seed(seed)
  , m_Along(along)
  , m_Spacing(spacing)
{
  ReproducibleRandom random(seed, BiasStream);
  m_Bias[0] = level.readerBias / spacing * random.Normal();
  m_Bias[1] = level.readerBias / spacing * random.Normal();
}

double
DentalPhantomHand::Slip::GetPeak() const
{
  return std::min(0.98, std::max(0.05, 1.0 - 0.12 * statedSigma));
}

auto
DentalPhantomHand::Draw(std::uint64_t stream, double along, double across, const double shared[2], double part) const
  -> Slip
{
  ReproducibleRandom random(m_Seed, stream);
  // In a fixed order, whatever is used: a parameter more or less leaves the other draws as they were.
  const double own[2] = { random.Normal(), random.Normal() };
  const double turn = random.Normal();
  const double scale = random.Normal();
  const double factor = std::exp(m_Level.confidenceSpread * random.Normal());
  const double claimed = std::exp(m_Level.confidenceSpread * random.Normal());
  const double luck = random.Uniform();
  const double angle = 6.283185307179586 * random.Uniform();
  const double far = random.Uniform(std::min(5.0, m_Level.grossDistance), m_Level.grossDistance) / m_Spacing;

  // A confidence tells the items apart; without one they are alike.
  const double spread = m_Level.confidence == "none" ? 1.0 : factor;
  double       z[2];
  for (unsigned int d = 0; d < 2; ++d)
  {
    z[d] = std::sqrt(part) * shared[d] + std::sqrt(1.0 - part) * own[d];
  }
  const double a = spread * along / m_Spacing * z[0];
  const double c = spread * across / m_Spacing * z[1];
  Slip         slip;
  slip.shift = { { a * m_Along[0] - c * m_Along[1], a * m_Along[1] + c * m_Along[0] } };
  slip.turn = spread * m_Level.toothTurnDegrees * Degree * turn;
  slip.scale = std::max(0.5, 1.0 + spread * m_Level.toothScale * scale);
  slip.sigma = spread * std::sqrt(0.5 * (along * along + across * across)) / m_Spacing;
  slip.statedSigma = slip.sigma / spread * (m_Level.confidence == "uninformative" ? claimed : spread);
  slip.gross = luck < m_Level.grossProbability;
  for (unsigned int d = 0; d < 2; ++d)
  {
    slip.shift[d] += m_Bias[d] + (slip.gross ? far * (d == 0 ? std::cos(angle) : std::sin(angle)) : 0.0);
  }
  return slip;
}

auto
DentalPhantomHand::DrawOutline(unsigned int item) const -> Slip
{
  constexpr double none[2] = { 0.0, 0.0 };
  return this->Draw(OutlineStream + item, m_Level.toothAlong, m_Level.toothAcross, none, 0.0);
}

auto
DentalPhantomHand::DrawLandmark(unsigned int item, unsigned int kind) const -> Slip
{
  // The outline's own draws begin its stream.
  ReproducibleRandom outline(m_Seed, OutlineStream + item);
  const double       shared[2] = { outline.Normal(), outline.Normal() };
  return this->Draw(
    LandmarkStream + 10 * item + kind, m_Level.landmarkAlong, m_Level.landmarkAcross, shared, m_Level.sharedToothError);
}

void
DentalPhantomHand::Apply(const Slip & slip, std::vector<PixelType> & points)
{
  PixelType centre{};
  for (const PixelType & p : points)
  {
    centre[0] += p[0] / static_cast<double>(points.size());
    centre[1] += p[1] / static_cast<double>(points.size());
  }
  const double c = slip.scale * std::cos(slip.turn);
  const double s = slip.scale * std::sin(slip.turn);
  for (PixelType & p : points)
  {
    const PixelType r = { { p[0] - centre[0], p[1] - centre[1] } };
    p = { { centre[0] + slip.shift[0] + c * r[0] - s * r[1], centre[1] + slip.shift[1] + s * r[0] + c * r[1] } };
  }
}
} // namespace itk

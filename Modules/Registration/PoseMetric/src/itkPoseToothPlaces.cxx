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
#include "itkPoseToothPlaces.h"

#include "itkPoseArch.h"

#include <cmath>

namespace itk
{
namespace
{
/** The arch turns most at the canine: of the way from its middle to the next drawn tooth's the side view shows this
 * share, above and below (phantoms with the traits of real arches: 0.78 and 0.61, sd 0.14). Behind it, all of it. */
constexpr double       UpperShareBehindCanine = 0.78;
constexpr double       LowerShareBehindCanine = 0.62;
constexpr unsigned int Canine = 3;
} // namespace

PoseToothPlaces::PoseToothPlaces(const PoseGeometry & geometry, const PoseTracing & tracing)
{
  struct Drawn
  {
    double       u{ 0.0 };
    double       v{ 0.0 };
    double       points{ 0.0 };
    std::uint8_t tooth{ 0 };
  };
  std::array<Drawn, 8> drawn{};
  for (std::size_t i = 0; i < tracing.Size(); ++i)
  {
    if (PoseArch::ExpectedArc(tracing.tooth[i]) > 0.0)
    {
      Drawn & tooth = drawn[tracing.tooth[i] % 10];
      tooth.u += tracing.u[i];
      tooth.v += tracing.v[i];
      tooth.points += 1.0;
      tooth.tooth = tracing.tooth[i];
    }
  }
  // From the working plane to the arch, which lies about the midsagittal plane.
  const double millimetres = PoseWorkingPixel * geometry.sourceToMidsagittal / geometry.sourceToDetector;
  unsigned int previous = 0;
  for (unsigned int position = 1; position < drawn.size(); ++position)
  {
    Drawn & tooth = drawn[position];
    if (tooth.points == 0.0)
    {
      continue;
    }
    tooth.u /= tooth.points;
    tooth.v /= tooth.points;
    m_Arc[position] = PoseArch::CurveShare * PoseArch::ExpectedArc(tooth.tooth);
    if (position > Canine + 1 && previous >= Canine)
    {
      const Drawn & before = drawn[previous];
      const bool    upper = tooth.tooth < 30;
      const double  share = previous > Canine ? 1.0 : upper ? UpperShareBehindCanine : LowerShareBehindCanine;
      m_Arc[position] = m_Arc[previous] + millimetres * std::hypot(tooth.u - before.u, tooth.v - before.v) / share;
    }
    previous = position;
  }
}
} // namespace itk

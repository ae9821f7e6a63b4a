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
#include "itkDentalPhantomAcquisition.h"

#include "itkDentalPhantomMath.h"
#include "itkReproducibleRandom.h"

#include <cmath>

namespace itk
{
using namespace DentalPhantomMath;

namespace
{
/** On a raster that decimal files state without a tail of digits. */
double
Round(double value, double stepsPerUnit)
{
  return std::nearbyint(value * stepsPerUnit) / stepsPerUnit;
}
} // namespace

DentalPhantomAcquisition
DentalPhantomAcquisition::Draw(std::uint64_t seed, CohortEnum cohort)
{
  return Draw(seed, DentalPhantomLevel::Named(GetName(cohort)));
}

const std::string &
DentalPhantomAcquisition::GetName(CohortEnum cohort)
{
  return DentalPhantomLevel::GetNames()[static_cast<std::size_t>(cohort)];
}

DentalPhantomAcquisition
DentalPhantomAcquisition::Draw(std::uint64_t seed, const DentalPhantomLevel & level)
{
  // A stream a subject: a draw more in one does not move the others.
  ReproducibleRandom head(seed, 101);
  ReproducibleRandom machine(seed, 102);
  ReproducibleRandom teeth(seed, 103);
  ReproducibleRandom hand(seed, 104);
  const bool         ideal = level.knownMachine;

  DentalPhantomAcquisition result;
  const double             turn = level.turnDegrees;
  result.yaw = turn * Degree * head.Normal();
  result.roll = turn * Degree * head.Normal();
  result.pitch = head.Normal(level.pitchDegrees, level.pitchSigmaDegrees) * Degree;
  const double anterior = head.Uniform(66.0, 80.0);
  const double down = head.Uniform(36.0, 50.0);
  result.anterior = ideal ? 0.0 : anterior;
  result.down = ideal ? 0.0 : down;

  constexpr double distances[3] = { 1500.0, 1524.0, 1650.0 };
  const double     distance = distances[machine.Integer(3)];
  const double     gap = Round(machine.Uniform(110.0, 190.0), 100.0);
  result.trueSourceToMidsagittal = ideal ? 1524.0 : distance;
  result.trueSourceToDetector = result.trueSourceToMidsagittal + gap;
  result.givenSourceToMidsagittal = 1524.0;
  result.givenSourceToDetector = ideal ? result.trueSourceToDetector : 1674.0;
  result.pixelSpacing = Round(machine.Uniform(0.24, 0.26), 1e4);
  // Ear rods left of and above the teeth; the central ray through the teeth where it is ideal.
  const double earU = machine.Uniform(0.24, 0.27);
  const double earV = machine.Uniform(0.435, 0.465);
  const double teethU = machine.Uniform(0.70, 0.735);
  const double teethV = machine.Uniform(0.625, 0.665);
  result.principalU = ideal ? teethU : earU;
  result.principalV = ideal ? teethV : earV;

  result.toothRotationDegrees = level.toothRotationDegrees;
  const bool         lacks = teeth.Uniform() < level.lostToothProbability;
  const unsigned int lackingJaw = teeth.Integer(2);
  const unsigned int lackingPosition = 2 + teeth.Integer(5);
  if (lacks)
  {
    result.missingJaw = lackingJaw;
    result.missingPosition = lackingPosition;
  }

  result.correlatedNoise = level.correlatedNoise;
  result.whiteNoise = level.whiteNoise;
  result.correlationLength = hand.Uniform(10.0, 20.0);
  for (unsigned int & position : result.untracedPosition)
  {
    const bool         skips = hand.Uniform() < level.untracedProbability;
    const unsigned int skipped = 2 + hand.Integer(5);
    position = skips ? skipped : 0;
  }
  return result;
}

std::ostream &
operator<<(std::ostream & os, DentalPhantomAcquisition::CohortEnum cohort)
{
  return os << DentalPhantomAcquisition::GetName(cohort);
}
} // namespace itk

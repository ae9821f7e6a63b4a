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
#include "itkDentalPhantomParameters.h"

#include "itkDentalPhantomMath.h"
#include "itkReproducibleRandom.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace itk
{
using namespace DentalPhantomMath;

namespace
{
/** mesiodistal, buccolingual, crown height (mm), torque (degrees to the occlusal plane's normal). */
constexpr double MeanTeeth[2][7][4] = { { { 8.5, 7.0, 10.5, 20.0 },
                                          { 6.6, 6.0, 9.2, 17.0 },
                                          { 7.6, 8.0, 10.2, 7.0 },
                                          { 7.0, 9.0, 8.6, 2.0 },
                                          { 6.7, 9.0, 8.1, 3.0 },
                                          { 10.3, 11.0, 7.7, 5.0 },
                                          { 9.7, 11.0, 7.2, 7.0 } },
                                        { { 5.3, 6.0, 9.0, 18.0 },
                                          { 5.9, 6.4, 9.4, 16.0 },
                                          { 6.9, 7.6, 10.5, 6.0 },
                                          { 7.0, 7.6, 8.7, -4.0 },
                                          { 7.1, 8.1, 8.1, -7.0 },
                                          { 11.2, 10.4, 7.7, -10.0 },
                                          { 10.6, 10.2, 7.2, -12.0 } } };

constexpr double MeanThirdMolars[2][4] = { { 8.5, 10.0, 6.5, 8.0 }, { 10.0, 9.5, 7.0, -12.0 } };

std::array<double, 9>
RotationFromQuaternion(const std::array<double, 4> & q)
{
  const double w = q[0];
  const double x = q[1];
  const double y = q[2];
  const double z = q[3];
  return { { 1.0 - 2.0 * (y * y + z * z),
             2.0 * (x * y - w * z),
             2.0 * (x * z + w * y),
             2.0 * (x * y + w * z),
             1.0 - 2.0 * (x * x + z * z),
             2.0 * (y * z - w * x),
             2.0 * (x * z - w * y),
             2.0 * (y * z + w * x),
             1.0 - 2.0 * (x * x + y * y) } };
}

/** A normal draw without its tails: an arch with a tooth 4 sigma off is no test of anything. */
double
Draw(ReproducibleRandom & random, double mean, double sigma)
{
  return mean + sigma * Clamp(random.Normal(), -2.5, 2.5);
}
} // namespace

DentalPhantomJaw::DentalPhantomJaw()
{
  for (DentalPhantomTooth & tooth : thirdMolars)
  {
    tooth.missing = true;
  }
}

DentalPhantomParameters::DentalPhantomParameters()
{
  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    for (unsigned int i = 0; i < 14; ++i)
    {
      DentalPhantomTooth & tooth = jaws[jaw].teeth[i];
      const double *       mean = MeanTeeth[jaw][i % 7];
      tooth.mesiodistal = mean[0];
      tooth.buccolingual = mean[1];
      tooth.height = mean[2];
      tooth.torque = mean[3] * Degree;
    }
    for (DentalPhantomTooth & tooth : jaws[jaw].thirdMolars)
    {
      const double * mean = MeanThirdMolars[jaw];
      tooth.mesiodistal = mean[0];
      tooth.buccolingual = mean[1];
      tooth.height = mean[2];
      tooth.torque = mean[3] * Degree;
    }
  }
}

DentalPhantomParameters
DentalPhantomParameters::Draw(std::uint64_t seed)
{
  return Draw(seed, Variation());
}

DentalPhantomParameters
DentalPhantomParameters::Draw(std::uint64_t seed, const Variation & variation)
{
  DentalPhantomParameters result;
  // A stream a subject: a draw more in one does not move the others.
  ReproducibleRandom arch(seed, 1);
  ReproducibleRandom size(seed, 2);
  ReproducibleRandom place(seed, 3);
  ReproducibleRandom trim(seed, 4);

  const double scale = Clamp(arch.Normal(1.0, 0.045), 0.9, 1.1);
  switch (arch.Integer(3))
  {
    case 0:
      result.archFamily = ArchFamilyEnum::Tapered;
      result.archExponent = arch.Uniform(2.0, 2.1);
      result.archCoverage = arch.Uniform(72.0, 76.0) * Degree;
      result.archHalfWidth = arch.Uniform(28.0, 31.0) * scale;
      break;
    case 1:
      result.archFamily = ArchFamilyEnum::Ovoid;
      result.archExponent = arch.Uniform(2.05, 2.25);
      result.archCoverage = arch.Uniform(76.0, 82.0) * Degree;
      result.archHalfWidth = arch.Uniform(27.0, 31.0) * scale;
      break;
    default:
      result.archFamily = ArchFamilyEnum::Square;
      result.archExponent = arch.Uniform(2.3, 2.7);
      result.archCoverage = arch.Uniform(80.0, 87.0) * Degree;
      result.archHalfWidth = arch.Uniform(26.0, 30.0) * scale;
      break;
  }
  result.overjet = Clamp(arch.Normal(2.7, 0.7), 1.8, 5.0);
  result.overbite = Clamp(arch.Normal(2.0, 0.7), 0.3, 3.5);
  result.speeDepth = arch.Uniform(0.2, 2.2);
  result.wilson = arch.Uniform(0.5, 1.4);
  const bool spaced = arch.Uniform() < variation.spacedArchProbability;
  result.stoneBase = arch.Uniform() < variation.stoneBaseProbability;
  result.baseHeight = arch.Uniform(8.0, 14.0);
  result.scannerNoise = 0.01;
  result.noiseSeed = arch.NextBits();
  result.frame = FrameEnum::SharedScanner;
  result.frameSeed = arch.NextBits();

  const double torqueShift = arch.Normal(0.0, 4.0) * Degree;
  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    DentalPhantomJaw & target = result.jaws[jaw];
    double             widthFactor[7];
    double             depthFactor[7];
    double             heightFactor[7];
    for (unsigned int k = 0; k < 7; ++k)
    {
      widthFactor[k] = itk::Draw(size, scale, 0.03);
      depthFactor[k] = itk::Draw(size, scale, 0.04);
      heightFactor[k] = itk::Draw(size, scale, 0.06);
    }
    for (unsigned int i = 0; i < 14; ++i)
    {
      DentalPhantomTooth & tooth = target.teeth[i];
      const unsigned int   k = i % 7;
      // The two sides are alike, not equal.
      tooth.mesiodistal *= widthFactor[k] * itk::Draw(size, 1.0, 0.008);
      tooth.buccolingual *= depthFactor[k] * itk::Draw(size, 1.0, 0.01);
      tooth.height *= heightFactor[k] * itk::Draw(size, 1.0, 0.015);
      // Molars turn less than front teeth in any mouth, but the cohorts speak of one figure: keep one figure.
      tooth.rotation = itk::Draw(place, 0.0, variation.rotationDegrees * Degree);
      tooth.tip = itk::Draw(place, k < 3 ? 4.0 * Degree : 1.0 * Degree, variation.tipDegrees * Degree);
      tooth.torque += (k < 3 ? torqueShift : 0.0) + itk::Draw(place, 0.0, variation.torqueDegrees * Degree);
      tooth.buccalOffset = itk::Draw(place, 0.0, variation.buccalOffset);
      tooth.occlusalOffset = itk::Draw(place, 0.0, variation.occlusalOffset);
      tooth.mesialGap = spaced ? std::max(0.0, itk::Draw(place, 0.3, 0.4)) : itk::Draw(place, -0.05, 0.08);
    }
    target.distalExtension = { { trim.Uniform(1.5, 6.0), trim.Uniform(1.5, 6.0) } };
    target.buccalFlange = trim.Uniform(4.0, 9.0);
    target.lingualFlange = trim.Uniform(4.0, 8.0);
    target.trimSlopeAnterior = itk::Draw(trim, 0.0, 0.04);
    target.trimSlopeLeft = itk::Draw(trim, 0.0, 0.03);
    target.trimWave = trim.Uniform(0.0, 0.8);
    target.trimPhase = trim.Uniform(0.0, 6.283185307179586);
    target.palate = trim.Uniform() < (jaw == 0 ? variation.palateProbability : 0.0);
    target.palateDepth = trim.Uniform(9.0, 16.0);
  }
  return result;
}

auto
DentalPhantomParameters::ComputeFrame(unsigned int jaw) const -> RigidMotion
{
  RigidMotion motion;
  if (frame == FrameEnum::Anatomical)
  {
    return motion;
  }
  if (frame == FrameEnum::CentredScanner || frame == FrameEnum::UprightScanner)
  {
    return this->ComputeCentredFrame(jaw);
  }
  ReproducibleRandom random(frameSeed, frame == FrameEnum::SeparateScanner ? 1 + jaw : 0);
  // A uniform rotation is a uniform unit quaternion.
  double q[4];
  double norm = 0.0;
  for (double & value : q)
  {
    value = random.Normal();
    norm += value * value;
  }
  norm = std::sqrt(norm);
  for (double & value : q)
  {
    value /= norm;
  }
  motion.rotation = RotationFromQuaternion({ { q[0], q[1], q[2], q[3] } });
  for (double & value : motion.translation)
  {
    value = random.Uniform(-40.0, 40.0);
  }
  return motion;
}

auto
DentalPhantomParameters::ComputeCentredFrame(unsigned int jaw) const -> RigidMotion
{
  // Which axis is up is the program's habit, the same for both jaws; the tilt is the operator's, each jaw's own.
  ReproducibleRandom habit(frameSeed, 10);
  ReproducibleRandom tilt(frameSeed, 11 + jaw);
  const bool         yIsUp = habit.Uniform() < 0.5;
  // Up is the occlusal side (centred) or the cranial one (upright); the other two axes keep the hand.
  const double          up = frame == FrameEnum::CentredScanner && jaw == 0 ? -1.0 : 1.0;
  std::array<double, 9> base{};
  if (yIsUp)
  {
    // Rows: the patient's left (right for a jaw on its back), up, anterior.
    base = { { 0.0, up, 0.0, 0.0, 0.0, up, 1.0, 0.0, 0.0 } };
  }
  else
  {
    // Rows: the patient's right (left on its back), anterior, up, so that the picture faces away from the viewer.
    base = { { 0.0, -up, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, up } };
  }
  double q[4] = { 1.0, 0.0, 0.0, 0.0 };
  double norm = 1.0;
  for (unsigned int i = 1; i < 4; ++i)
  {
    // Half of 4 degrees (1 sd) about each axis.
    q[i] = 0.5 * 4.0 * Degree * Clamp(tilt.Normal(), -2.5, 2.5);
    norm += q[i] * q[i];
  }
  const auto tilted = RotationFromQuaternion(
    { { q[0] / std::sqrt(norm), q[1] / std::sqrt(norm), q[2] / std::sqrt(norm), q[3] / std::sqrt(norm) } });
  RigidMotion motion;
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 3; ++column)
    {
      double sum = 0.0;
      for (unsigned int k = 0; k < 3; ++k)
      {
        sum += tilted[3 * row + k] * base[3 * k + column];
      }
      motion.rotation[3 * row + column] = sum;
    }
  }
  motion.translation = {};
  const auto centre = motion.Apply(frameCentres[jaw]);
  for (unsigned int d = 0; d < 3; ++d)
  {
    motion.translation[d] = -centre[d];
  }
  return motion;
}

std::array<double, 3>
DentalPhantomParameters::RigidMotion::Apply(const std::array<double, 3> & point) const
{
  std::array<double, 3> result = translation;
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 3; ++column)
    {
      result[row] += rotation[3 * row + column] * point[column];
    }
  }
  return result;
}

std::array<double, 3>
DentalPhantomParameters::RigidMotion::ApplyInverse(const std::array<double, 3> & point) const
{
  std::array<double, 3> result{};
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 3; ++column)
    {
      result[column] += rotation[3 * row + column] * (point[row] - translation[row]);
    }
  }
  return result;
}

void
DentalPhantomParameters::Validate() const
{
  const auto check = [](const char * name, double value, double low, double high) {
    if (!(value >= low && value <= high))
    {
      std::ostringstream message;
      message << "Phantom parameter " << name << " is " << value << ", must be in [" << low << ", " << high << "].";
      throw std::invalid_argument(message.str());
    }
  };
  check("archExponent", archExponent, 1.8, 4.0);
  check("archCoverage", archCoverage, 1.0, 1.57);
  check("archHalfWidth", archHalfWidth, 18.0, 45.0);
  check("overjet", overjet, -5.0, 15.0);
  check("overbite", overbite, -8.0, 8.0);
  check("speeDepth", speeDepth, -3.0, 6.0);
  check("wilson", wilson, -2.0, 4.0);
  check("baseHeight", baseHeight, 1.0, 60.0);
  check("scannerNoise", scannerNoise, 0.0, 0.5);
  check("numberOfTriangles", numberOfTriangles, 2000.0, 4e6);
  check("scan.holeRadius", scan.holeRadius, 0.1, 10.0);
  check("scan.flaps", scan.flaps, 0.0, 20.0);
  check("scan.crumbs", scan.crumbs, 0.0, 50.0);
  check("scan.specks", scan.specks, 0.0, 1000.0);
  check("scan.holes", scan.holes, 0.0, 200.0);
  check("scan.decimateTo", scan.decimateTo, 0.0, 4e6);
  for (const DentalPhantomJaw & jaw : jaws)
  {
    for (unsigned int i = 0; i < DentalPhantomJaw::NumberOfTeeth; ++i)
    {
      const DentalPhantomTooth & tooth = jaw.GetTooth(i);
      if (tooth.missing)
      {
        // What is left of its place: nothing where the gap is closed.
        check("mesiodistal", tooth.mesiodistal, 0.0, 18.0);
        check("mesialGap", tooth.mesialGap, -2.0, 8.0);
        continue;
      }
      check("wear", tooth.wear, 0.0, 2.5);
      check("mesiodistal", tooth.mesiodistal, 3.0, 18.0);
      check("buccolingual", tooth.buccolingual, 3.0, 18.0);
      check("height", tooth.height, 4.0, 16.0);
      check("rotation", tooth.rotation, -1.6, 1.6);
      check("tip", tooth.tip, -0.7, 0.7);
      check("torque", tooth.torque, -0.9, 0.9);
      check("buccalOffset", tooth.buccalOffset, -6.0, 6.0);
      check("occlusalOffset", tooth.occlusalOffset, -8.0, 4.0);
      check("mesialGap", tooth.mesialGap, -2.0, 8.0);
    }
    check("distalExtension", std::min(jaw.distalExtension[0], jaw.distalExtension[1]), -12.0, 15.0);
    check("distalExtension", std::max(jaw.distalExtension[0], jaw.distalExtension[1]), -12.0, 15.0);
    check("buccalFlange", jaw.buccalFlange, 1.0, 20.0);
    check("lingualFlange", jaw.lingualFlange, 1.0, 20.0);
    check("trimSlopeAnterior", jaw.trimSlopeAnterior, -0.2, 0.2);
    check("trimSlopeLeft", jaw.trimSlopeLeft, -0.2, 0.2);
    check("trimWave", jaw.trimWave, 0.0, 3.0);
    check("palateDepth", jaw.palateDepth, 2.0, 25.0);
  }
}

void
DentalPhantomParameters::Write(std::ostream & os, const std::string & indent) const
{
  os << indent << "ArchFamily: " << archFamily << '\n';
  os << indent << "ArchExponent: " << archExponent << '\n';
  os << indent << "ArchCoverage: " << archCoverage << '\n';
  os << indent << "ArchHalfWidth: " << archHalfWidth << '\n';
  os << indent << "Overjet: " << overjet << '\n';
  os << indent << "Overbite: " << overbite << '\n';
  os << indent << "SpeeDepth: " << speeDepth << '\n';
  os << indent << "Wilson: " << wilson << '\n';
  os << indent << "StoneBase: " << stoneBase << '\n';
  os << indent << "BaseHeight: " << baseHeight << '\n';
  os << indent << "ScannerNoise: " << scannerNoise << '\n';
  os << indent << "NoiseSeed: " << noiseSeed << '\n';
  os << indent << "Frame: " << frame << '\n';
  os << indent << "FrameSeed: " << frameSeed << '\n';
  os << indent << "NumberOfTriangles: " << numberOfTriangles << '\n';
  os << indent << "Scan: flaps " << scan.flaps << ", crumbs " << scan.crumbs << ", specks " << scan.specks << ", holes "
     << scan.holes << " up to " << scan.holeRadius << ", decimated to " << scan.decimateTo << ", seed " << scan.seed
     << '\n';
  for (unsigned int j = 0; j < 2; ++j)
  {
    const DentalPhantomJaw & jaw = jaws[j];
    os << indent << (j == 0 ? "Upper" : "Lower") << ": distal extension " << jaw.distalExtension[0] << " "
       << jaw.distalExtension[1] << ", flanges " << jaw.buccalFlange << " " << jaw.lingualFlange << ", trimming "
       << jaw.trimSlopeAnterior << " " << jaw.trimSlopeLeft << " " << jaw.trimWave << " " << jaw.trimPhase
       << ", palate " << jaw.palate << " " << jaw.palateDepth << '\n';
    for (unsigned int i = 0; i < DentalPhantomJaw::NumberOfTeeth; ++i)
    {
      const DentalPhantomTooth & tooth = jaw.GetTooth(i);
      os << indent << "  " << (tooth.missing ? "missing" : "tooth") << ": size " << tooth.mesiodistal << " "
         << tooth.buccolingual << " " << tooth.height << ", rotation " << tooth.rotation << ", tip " << tooth.tip
         << ", torque " << tooth.torque << ", offset " << tooth.buccalOffset << " " << tooth.occlusalOffset
         << ", mesial gap " << tooth.mesialGap << (tooth.primary ? ", milk molar" : "") << ", wear " << tooth.wear
         << (tooth.settles ? "" : ", does not settle") << (tooth.bracket ? ", bracket" : "") << '\n';
    }
  }
}

std::ostream &
operator<<(std::ostream & os, DentalPhantomParameters::ArchFamilyEnum family)
{
  switch (family)
  {
    case DentalPhantomParameters::ArchFamilyEnum::Tapered:
      return os << "Tapered";
    case DentalPhantomParameters::ArchFamilyEnum::Ovoid:
      return os << "Ovoid";
    default:
      return os << "Square";
  }
}

std::ostream &
operator<<(std::ostream & os, DentalPhantomParameters::FrameEnum frame)
{
  switch (frame)
  {
    case DentalPhantomParameters::FrameEnum::Anatomical:
      return os << "Anatomical";
    case DentalPhantomParameters::FrameEnum::SharedScanner:
      return os << "SharedScanner";
    case DentalPhantomParameters::FrameEnum::CentredScanner:
      return os << "CentredScanner";
    case DentalPhantomParameters::FrameEnum::UprightScanner:
      return os << "UprightScanner";
    default:
      return os << "SeparateScanner";
  }
}
} // namespace itk

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
#ifndef itkDentalFrameCohort_h
#define itkDentalFrameCohort_h

#include "itkDentalFrameTestSupport.h"
#include "itkDentalPhantomLevel.h"
#include "itkDentalPhantomTraits.h"
#include "itkParallelFor.h"

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

// Pairs of scans as a level of the phantom draws them, and how exports lay them out; for tests and for the study.
namespace DentalFrameTest
{
/** Both jaws in the anatomical frame, as scanned. */
struct ScannedPair
{
  std::array<itk::TriangleSurface, 2> jaws;
  /** What the dentition was given, as in "extraction_closed". */
  std::string traits;
};

/** A pair of a level for a seed. Beyond what the level draws, scans differ in how much gingiva they show. */
inline ScannedPair
MakeScannedPair(std::uint64_t seed, const std::string & levelName)
{
  const bool                              stone = levelName == "stone";
  itk::DentalPhantomLevel                 level = itk::DentalPhantomLevel::Named(stone ? "typical" : levelName);
  itk::DentalPhantomParameters::Variation variation;
  variation.rotationDegrees = level.toothRotationDegrees;
  variation.tipDegrees = level.toothTipDegrees;
  variation.torqueDegrees = level.toothTorqueDegrees;
  variation.buccalOffset = level.buccalOffset;
  variation.occlusalOffset = level.occlusalOffset;
  variation.spacedArchProbability = level.spacedProbability;
  variation.palateProbability = level.palateProbability;
  level.gingivaLeast = 0.0;
  level.gingivaMost = 1.5;
  itk::DentalPhantomParameters parameters = itk::DentalPhantomParameters::Draw(seed, variation);
  parameters.frame = itk::DentalPhantomParameters::FrameEnum::Anatomical;
  parameters.scannerNoise = level.scannerNoise;
  ScannedPair pair;
  for (const auto & trait : itk::DentalPhantomTraits::Apply(seed, level, parameters))
  {
    pair.traits += (pair.traits.empty() ? "" : ",") + trait.name;
  }
  // Made at the density that the level decimates to: the frame takes samples by area, and decimation costs the most.
  parameters.numberOfTriangles = 20000;
  parameters.scan.decimateTo = 0;
  parameters.stoneBase = stone;
  const itk::DentalPhantomModel model(parameters, 1);
  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    pair.jaws[jaw] = model.MakeScan(jaw, 1).surface;
  }
  return pair;
}

/** How the files hold the two jaws. */
enum class Arrangement
{
  /** In occlusion, turned at random. */
  Shared,
  /** The same, the lower one 1 to 5 mm below contact, as casts are exported. */
  SharedWithGap,
  /** In occlusion, mirrored by a change of the hand: both are wound inward. */
  Mirrored,
  /** Each jaw at its own middle, both with the occlusal side toward +y or +z. */
  CentredY,
  CentredZ,
  /** Each jaw at its own middle, superior +z. */
  Upright,
  /** Each jaw at its own middle, turned at random. */
  Random
};
constexpr std::array<Arrangement, 7> Arrangements{ { Arrangement::Shared,
                                                     Arrangement::SharedWithGap,
                                                     Arrangement::Mirrored,
                                                     Arrangement::CentredY,
                                                     Arrangement::CentredZ,
                                                     Arrangement::Upright,
                                                     Arrangement::Random } };

inline const char *
NameOf(Arrangement arrangement)
{
  constexpr std::array<const char *, 7> names{
    { "shared", "gap", "mirrored", "centred-y", "centred-z", "upright", "random" }
  };
  return names[static_cast<std::size_t>(arrangement)];
}

struct ArrangedPair
{
  std::array<itk::TriangleSurface, 2> jaws;
  std::array<Motion, 2>               motions;
  bool                                share{ false };
};

/** The middle that a program moves a scan to the origin by: mean of the vertices, centre of the bounding box, or
 * centroid of the area. */
inline Vector3
MiddleOf(const itk::TriangleSurface & surface, unsigned int kind)
{
  if (kind == 2)
  {
    return surface.AreaCentroid();
  }
  Vector3 low{ 1e9, 1e9, 1e9 };
  Vector3 high{ -1e9, -1e9, -1e9 };
  Vector3 mean{ 0, 0, 0 };
  for (const Vector3 & p : surface.points)
  {
    for (unsigned int d = 0; d < 3; ++d)
    {
      low[d] = std::min(low[d], p[d]);
      high[d] = std::max(high[d], p[d]);
      mean[d] += p[d] / static_cast<double>(surface.points.size());
    }
  }
  return kind == 0 ? mean : Vector3{ 0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), 0.5 * (low[2] + high[2]) };
}

/** After a motion, a turn of a few degrees about a random axis. */
inline Motion
Tilted(const Motion & motion, itk::ReproducibleRandom & random)
{
  Vector3 half;
  for (double & h : half)
  {
    h = 0.5 * 4.0 * 3.14159265358979 / 180.0 * random.Normal();
  }
  const double norm = std::sqrt(1.0 + Dot(half, half));
  const double w = 1.0 / norm;
  const double x = half[0] / norm;
  const double y = half[1] / norm;
  const double z = half[2] / norm;
  Motion       tilt;
  tilt.rotation = { { { { 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y) } },
                      { { 2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x) } },
                      { { 2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y) } } } };
  Motion both;
  for (unsigned int r = 0; r < 3; ++r)
  {
    for (unsigned int c = 0; c < 3; ++c)
    {
      both.rotation[r][c] = 0.0;
      for (unsigned int k = 0; k < 3; ++k)
      {
        both.rotation[r][c] += tilt.rotation[r][k] * motion.rotation[k][c];
      }
    }
  }
  both.translation = tilt.Turn(motion.translation);
  return both;
}

inline ArrangedPair
Arrange(const ScannedPair & pair, Arrangement arrangement, std::uint64_t seed)
{
  itk::ReproducibleRandom random(seed, 5000 + static_cast<std::uint64_t>(arrangement));
  ArrangedPair            arranged;
  const Motion            common = RandomMotion(random);
  const unsigned int      middle = static_cast<unsigned int>(random.Uniform(0.0, 2.999));
  arranged.share = arrangement == Arrangement::Shared || arrangement == Arrangement::SharedWithGap ||
                   arrangement == Arrangement::Mirrored;
  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    itk::TriangleSurface surface = pair.jaws[jaw];
    Motion               motion = common;
    if (arrangement == Arrangement::SharedWithGap && jaw == 1)
    {
      const double gap = random.Uniform(1.0, 5.0);
      for (Vector3 & p : surface.points)
      {
        p[2] -= gap;
      }
    }
    if (arrangement == Arrangement::Mirrored)
    {
      for (Vector3 & p : surface.points)
      {
        p[1] = -p[1];
      }
    }
    if (!arranged.share)
    {
      motion = RandomMotion(random);
      // The upper one lies on its back where both occlusal sides are up; the front stays the front.
      const double up = arrangement != Arrangement::Upright && jaw == 0 ? -1.0 : 1.0;
      if (arrangement == Arrangement::CentredY)
      {
        motion.rotation = { { { { 0.0, up, 0.0 } }, { { 0.0, 0.0, up } }, { { 1.0, 0.0, 0.0 } } } };
      }
      else if (arrangement == Arrangement::CentredZ || arrangement == Arrangement::Upright)
      {
        motion.rotation = { { { { 0.0, -up, 0.0 } }, { { 1.0, 0.0, 0.0 } }, { { 0.0, 0.0, up } } } };
      }
      motion.translation = { 0, 0, 0 };
      if (arrangement != Arrangement::Random)
      {
        motion = Tilted(motion, random);
      }
      surface = Moved(surface, motion);
      const Vector3 centre = MiddleOf(surface, middle);
      motion.translation = { -centre[0], -centre[1], -centre[2] };
      Motion shift;
      shift.translation = motion.translation;
      arranged.jaws[jaw] = Moved(surface, shift);
    }
    else
    {
      arranged.jaws[jaw] = Moved(surface, motion);
    }
    arranged.motions[jaw] = motion;
  }
  return arranged;
}
} // namespace DentalFrameTest

#endif

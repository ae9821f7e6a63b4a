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
#ifndef itkCrownRegionTestSupport_h
#define itkCrownRegionTestSupport_h

#include "itkCrownRegionKernel.h"
#include "itkDentalFrameEstimator.h"
#include "itkDentalPhantomModel.h"
#include "itkReproducibleRandom.h"
#include "itkTriangleSurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

// Phantoms and overlap figures for this module's tests.
namespace CrownRegionTest
{
struct Overlap
{
  double intersection{ 0.0 };
  double unionArea{ 0.0 };

  double
  IoU() const
  {
    return intersection / unionArea;
  }
};

inline double
TriangleArea(const itk::TriangleSurface & surface, std::size_t triangle)
{
  const auto n = surface.AreaNormal(triangle);
  return std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
}

/** By area. */
inline Overlap
Compare(const itk::TriangleSurface &      surface,
        const std::vector<std::uint8_t> & found,
        const std::vector<std::uint8_t> & truth)
{
  Overlap overlap;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const double area = TriangleArea(surface, t);
    overlap.intersection += found[t] != 0 && truth[t] != 0 ? area : 0.0;
    overlap.unionArea += found[t] != 0 || truth[t] != 0 ? area : 0.0;
  }
  return overlap;
}

enum class Kind
{
  Regular,
  Stone,
  /** Two teeth missing in each jaw, rotations 9 degrees, teeth 0.8 mm off the arch and 0.4 mm off the plane. */
  Irregular,
  /** Far beyond what DentalPhantomParameters::Draw() makes; tapered and ovoid arches. */
  Wide,
  /** The same with square arches only: the family that no parameter was chosen on. */
  WideSquare
};

/** Irregularity, curves, crown heights, gingiva, missing teeth (up to three a jaw, any), resolution and noise, each
 * uniform over a wide range. */
inline itk::DentalPhantomParameters
DrawWide(std::uint64_t seed, bool square)
{
  constexpr double                        degree = 3.14159265358979323846 / 180.0;
  itk::ReproducibleRandom                 random(seed, 77);
  itk::DentalPhantomParameters::Variation variation;
  variation.rotationDegrees = random.Uniform(2.0, 12.0);
  variation.tipDegrees = random.Uniform(1.0, 5.0);
  variation.torqueDegrees = random.Uniform(1.0, 6.0);
  variation.buccalOffset = random.Uniform(0.1, 0.9);
  variation.occlusalOffset = random.Uniform(0.05, 0.5);
  variation.spacedArchProbability = 0.3;
  variation.stoneBaseProbability = 0.3;
  auto parameters = itk::DentalPhantomParameters::Draw(seed, variation);
  parameters.numberOfTriangles =
    static_cast<std::uint32_t>(std::exp(random.Uniform(std::log(8000.0), std::log(60000.0))));
  parameters.scannerNoise = random.Uniform(0.0, 0.03);
  parameters.speeDepth = random.Uniform(-0.5, 3.5);
  parameters.wilson = random.Uniform(0.0, 2.0);
  for (auto & jaw : parameters.jaws)
  {
    const double height = random.Uniform(0.85, 1.2);
    for (auto & tooth : jaw.teeth)
    {
      tooth.height *= height;
    }
    jaw.buccalFlange = random.Uniform(2.5, 11.0);
    jaw.lingualFlange = random.Uniform(2.5, 10.0);
    for (double & extension : jaw.distalExtension)
    {
      extension = random.Uniform(0.0, 9.0);
    }
    jaw.palateDepth = random.Uniform(6.0, 20.0);
    const auto missing = random.Integer(4);
    for (std::uint64_t k = 0; k < missing; ++k)
    {
      jaw.teeth[random.Integer(14)].missing = true;
    }
  }
  using Family = itk::DentalPhantomParameters::ArchFamilyEnum;
  parameters.archFamily = square ? Family::Square : random.Integer(2) == 0 ? Family::Ovoid : Family::Tapered;
  switch (parameters.archFamily)
  {
    case Family::Square:
      parameters.archExponent = random.Uniform(2.3, 2.9);
      parameters.archCoverage = random.Uniform(80.0, 87.0) * degree;
      parameters.archHalfWidth = random.Uniform(25.0, 31.0);
      break;
    case Family::Ovoid:
      parameters.archExponent = random.Uniform(2.05, 2.25);
      parameters.archCoverage = random.Uniform(76.0, 82.0) * degree;
      parameters.archHalfWidth = random.Uniform(26.0, 32.0);
      break;
    default:
      parameters.archExponent = random.Uniform(2.0, 2.1);
      parameters.archCoverage = random.Uniform(72.0, 76.0) * degree;
      parameters.archHalfWidth = random.Uniform(26.0, 32.0);
  }
  return parameters;
}

/** `triangles` is not heeded by the wide kinds. */
inline itk::DentalPhantomParameters
Draw(std::uint64_t seed, Kind kind, std::uint32_t triangles)
{
  if (kind == Kind::Wide || kind == Kind::WideSquare)
  {
    auto wide = DrawWide(seed, kind == Kind::WideSquare);
    wide.frame = itk::DentalPhantomParameters::FrameEnum::Anatomical;
    return wide;
  }
  itk::DentalPhantomParameters::Variation variation;
  if (kind == Kind::Irregular)
  {
    variation.rotationDegrees = 9.0;
    variation.buccalOffset = 0.8;
    variation.occlusalOffset = 0.4;
  }
  auto parameters = itk::DentalPhantomParameters::Draw(seed, variation);
  parameters.numberOfTriangles = triangles;
  parameters.stoneBase = kind == Kind::Stone;
  parameters.frame = itk::DentalPhantomParameters::FrameEnum::Anatomical;
  for (unsigned int jaw = 0; kind == Kind::Irregular && jaw < 2; ++jaw)
  {
    parameters.jaws[jaw].teeth[(seed * 7 + jaw * 3) % 14].missing = true;
    parameters.jaws[jaw].teeth[(seed * 5 + jaw * 6 + 2) % 14].missing = true;
  }
  return parameters;
}

/** Both jaws of a phantom with the frame that both give. */
struct Case
{
  std::array<itk::DentalPhantomModel::JawSurface, 2> jaws;
  itk::DentalFrameResult                             frame;
};

inline Case
MakeCase(std::uint64_t seed, Kind kind, std::uint32_t triangles)
{
  const itk::DentalPhantomModel model(Draw(seed, kind, triangles), 2);
  Case                          result;
  result.jaws = { model.MakeJaw(0, 2), model.MakeJaw(1, 2) };
  itk::DentalFrameOptions options;
  options.refineMidline = true;
  result.frame = itk::EstimateDentalFrame(&result.jaws[0].surface, &result.jaws[1].surface, options);
  return result;
}

inline itk::CrownRegionResult
Find(const Case & phantom, unsigned int jaw)
{
  const itk::DentalJawFrame & frame = jaw == 0 ? phantom.frame.upper : phantom.frame.lower;
  return itk::ComputeCrownRegion(phantom.jaws[jaw].surface,
                                 jaw == 0 ? itk::ToothCode::JawEnum::Upper : itk::ToothCode::JawEnum::Lower,
                                 frame.axes,
                                 frame.origin);
}

inline double
IoU(const Case & phantom, unsigned int jaw, const itk::CrownRegionResult & found)
{
  const auto & surface = phantom.jaws[jaw].surface;
  const auto   truth = itk::CrownRegionFromLabels(surface, phantom.jaws[jaw].labels);
  return Compare(surface, found.triangles, truth.triangles).IoU();
}
} // namespace CrownRegionTest

#endif

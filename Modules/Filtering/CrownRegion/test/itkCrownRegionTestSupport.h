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

#include "itkDentalPhantomModel.h"
#include "itkTriangleSurface.h"

#include <algorithm>
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
  Irregular
};

inline itk::DentalPhantomParameters
Draw(std::uint64_t seed, Kind kind, std::uint32_t triangles)
{
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
} // namespace CrownRegionTest

#endif

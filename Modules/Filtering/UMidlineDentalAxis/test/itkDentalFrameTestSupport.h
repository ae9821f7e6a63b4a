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
#ifndef itkDentalFrameTestSupport_h
#define itkDentalFrameTestSupport_h

#include "itkDentalFrameEstimator.h"
#include "itkDentalPhantomModel.h"
#include "itkReproducibleRandom.h"

#include <algorithm>
#include <array>
#include <cmath>

// Rigid motions and phantoms for this module's tests.
namespace DentalFrameTest
{
using Vector3 = std::array<double, 3>;

inline double
Dot(const Vector3 & a, const Vector3 & b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline double
Degrees(const Vector3 & a, const Vector3 & b)
{
  const Vector3 c{ a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
  return std::atan2(std::sqrt(Dot(c, c)), Dot(a, b)) * 180.0 / 3.14159265358979323846;
}

struct Motion
{
  std::array<Vector3, 3> rotation{ { { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } } };
  Vector3                translation{ { 0, 0, 0 } };

  Vector3
  Turn(const Vector3 & v) const
  {
    return { Dot(rotation[0], v), Dot(rotation[1], v), Dot(rotation[2], v) };
  }
  Vector3
  operator()(const Vector3 & p) const
  {
    const Vector3 q = this->Turn(p);
    return { q[0] + translation[0], q[1] + translation[1], q[2] + translation[2] };
  }
};

/** Uniform over the rotations. */
inline Motion
RandomMotion(itk::ReproducibleRandom & random)
{
  std::array<double, 4> q{};
  double                norm = 0.0;
  for (double & c : q)
  {
    c = random.Normal();
    norm += c * c;
  }
  norm = std::sqrt(norm);
  const double w = q[0] / norm;
  const double x = q[1] / norm;
  const double y = q[2] / norm;
  const double z = q[3] / norm;
  Motion       motion;
  motion.rotation = { { { { 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y) } },
                        { { 2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x) } },
                        { { 2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y) } } } };
  motion.translation = { random.Uniform(-80, 80), random.Uniform(-80, 80), random.Uniform(-80, 80) };
  return motion;
}

/** Coordinates as single precision, as in an STL file. */
inline itk::TriangleSurface
Moved(itk::TriangleSurface surface, const Motion & motion)
{
  for (Vector3 & p : surface.points)
  {
    p = motion(p);
    for (double & c : p)
    {
      c = static_cast<float>(c);
    }
  }
  return surface;
}

/** Triangles whose first corner fulfils the condition are cut out. */
template <typename TCondition>
void
Cut(itk::TriangleSurface & surface, TCondition && condition)
{
  std::vector<itk::TriangleSurface::TriangleType> kept;
  for (const auto & triangle : surface.triangles)
  {
    if (!condition(surface.points[triangle[0]]))
    {
      kept.push_back(triangle);
    }
  }
  surface.triangles = kept;
}

/** Upper and lower jaw in the anatomical frame: x anterior, y left, z superior. */
inline std::array<itk::TriangleSurface, 2>
MakePhantom(std::uint64_t seed, std::uint32_t triangles = 12000)
{
  itk::DentalPhantomParameters parameters = itk::DentalPhantomParameters::Draw(seed);
  parameters.frame = itk::DentalPhantomParameters::FrameEnum::Anatomical;
  parameters.numberOfTriangles = triangles;
  const itk::DentalPhantomModel model(parameters, 1);
  return { model.MakeJaw(0, 1).surface, model.MakeJaw(1, 1).surface };
}

/** Errors of x, y, z against the moved coordinate axes, degrees. */
inline Vector3
AxisErrors(const itk::DentalJawFrame & frame, const Motion & motion)
{
  Vector3 errors{};
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    Vector3 unit{ { 0, 0, 0 } };
    unit[axis] = 1.0;
    errors[axis] = frame.valid ? Degrees(frame.axes[axis], motion.Turn(unit)) : 180.0;
  }
  return errors;
}
} // namespace DentalFrameTest

#endif

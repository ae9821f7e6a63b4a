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
#ifndef itkDentalFrameMath_h
#define itkDentalFrameMath_h

#include <array>
#include <cmath>
#include <cstddef>

// Three-vectors of the frame kernels; private to this module.
namespace itk
{
namespace DentalFrameMath
{
using Vector3 = std::array<double, 3>;
using Matrix3 = std::array<std::array<double, 3>, 3>;

constexpr double Pi = 3.14159265358979323846;
constexpr double Degree = Pi / 180.0;

inline Vector3
operator+(const Vector3 & a, const Vector3 & b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

inline Vector3
operator-(const Vector3 & a, const Vector3 & b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline Vector3
operator*(double s, const Vector3 & a)
{
  return { s * a[0], s * a[1], s * a[2] };
}

inline double
Dot(const Vector3 & a, const Vector3 & b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector3
Cross(const Vector3 & a, const Vector3 & b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

inline double
Norm(const Vector3 & a)
{
  return std::sqrt(Dot(a, a));
}

/** Zero stays zero. */
inline Vector3
Unit(const Vector3 & a)
{
  const double length = Norm(a);
  return length > 0.0 ? (1.0 / length) * a : a;
}

/** The part of a that is perpendicular to the unit vector n, normalised. */
inline Vector3
UnitRejection(const Vector3 & a, const Vector3 & n)
{
  return Unit(a - Dot(a, n) * n);
}

/** Right-handed turn of v about the unit axis. */
inline Vector3
Rotate(const Vector3 & v, const Vector3 & axis, double angle)
{
  const double c = std::cos(angle);
  return c * v + std::sin(angle) * Cross(axis, v) + ((1.0 - c) * Dot(axis, v)) * axis;
}

/** Eigenvalues in ascending order with unit eigenvectors of a symmetric matrix, by Jacobi's rotations. */
inline void
SymmetricEigen(Matrix3 a, Vector3 & values, Matrix3 & vectors)
{
  Matrix3 v{ { { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } } };
  for (unsigned int sweep = 0; sweep < 60; ++sweep)
  {
    const double off = a[0][1] * a[0][1] + a[0][2] * a[0][2] + a[1][2] * a[1][2];
    const double diagonal = a[0][0] * a[0][0] + a[1][1] * a[1][1] + a[2][2] * a[2][2];
    if (!(off > 1e-30 * diagonal))
    {
      break;
    }
    for (unsigned int p = 0; p < 2; ++p)
    {
      for (unsigned int q = p + 1; q < 3; ++q)
      {
        if (a[p][q] == 0.0)
        {
          continue;
        }
        const double theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
        const double t = (theta >= 0.0 ? 1.0 : -1.0) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
        const double c = 1.0 / std::sqrt(t * t + 1.0);
        const double s = t * c;
        for (unsigned int k = 0; k < 3; ++k)
        {
          const double akp = a[k][p];
          const double akq = a[k][q];
          a[k][p] = c * akp - s * akq;
          a[k][q] = s * akp + c * akq;
        }
        for (unsigned int k = 0; k < 3; ++k)
        {
          const double apk = a[p][k];
          const double aqk = a[q][k];
          a[p][k] = c * apk - s * aqk;
          a[q][k] = s * apk + c * aqk;
        }
        for (unsigned int k = 0; k < 3; ++k)
        {
          const double vkp = v[k][p];
          const double vkq = v[k][q];
          v[k][p] = c * vkp - s * vkq;
          v[k][q] = s * vkp + c * vkq;
        }
      }
    }
  }
  std::array<unsigned int, 3> order{ { 0, 1, 2 } };
  const auto                  swapIfLess = [&](unsigned int i, unsigned int j) {
    if (a[order[j]][order[j]] < a[order[i]][order[i]])
    {
      const unsigned int keep = order[i];
      order[i] = order[j];
      order[j] = keep;
    }
  };
  swapIfLess(0, 1);
  swapIfLess(1, 2);
  swapIfLess(0, 1);
  for (unsigned int i = 0; i < 3; ++i)
  {
    values[i] = a[order[i]][order[i]];
    vectors[i] = { v[0][order[i]], v[1][order[i]], v[2][order[i]] };
  }
}

/** Solves the symmetric positive system in place by Cholesky's method; false where it is singular. Only the lower
 * triangle is read. */
template <std::size_t N>
bool
SolveSymmetric(std::array<std::array<double, N>, N> a, std::array<double, N> & b)
{
  for (std::size_t i = 0; i < N; ++i)
  {
    for (std::size_t j = 0; j <= i; ++j)
    {
      double sum = a[i][j];
      for (std::size_t k = 0; k < j; ++k)
      {
        sum -= a[i][k] * a[j][k];
      }
      if (i == j)
      {
        if (!(sum > 0.0))
        {
          return false;
        }
        a[i][i] = std::sqrt(sum);
      }
      else
      {
        a[i][j] = sum / a[j][j];
      }
    }
  }
  for (std::size_t i = 0; i < N; ++i)
  {
    for (std::size_t k = 0; k < i; ++k)
    {
      b[i] -= a[i][k] * b[k];
    }
    b[i] /= a[i][i];
  }
  for (std::size_t i = N; i-- > 0;)
  {
    for (std::size_t k = i + 1; k < N; ++k)
    {
      b[i] -= a[k][i] * b[k];
    }
    b[i] /= a[i][i];
  }
  return true;
}
} // namespace DentalFrameMath
} // namespace itk

#endif

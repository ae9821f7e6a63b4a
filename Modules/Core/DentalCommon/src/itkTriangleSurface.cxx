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
#include "itkTriangleSurface.h"

#include <cmath>

namespace itk
{
namespace
{
double
Length(const TriangleSurface::PointType & vector)
{
  return std::sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
}
} // namespace

auto
TriangleSurface::AreaNormal(std::size_t triangle) const -> PointType
{
  const PointType & a = points[triangles[triangle][0]];
  const PointType & b = points[triangles[triangle][1]];
  const PointType & c = points[triangles[triangle][2]];
  const PointType   ab{ b[0] - a[0], b[1] - a[1], b[2] - a[2] };
  const PointType   ac{ c[0] - a[0], c[1] - a[1], c[2] - a[2] };
  return { 0.5 * (ab[1] * ac[2] - ab[2] * ac[1]),
           0.5 * (ab[2] * ac[0] - ab[0] * ac[2]),
           0.5 * (ab[0] * ac[1] - ab[1] * ac[0]) };
}

std::vector<double>
TriangleSurface::VertexAreas() const
{
  std::vector<double> areas(points.size(), 0.0);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const double third = Length(AreaNormal(t)) / 3.0;
    for (const std::uint32_t corner : triangles[t])
    {
      areas[corner] += third;
    }
  }
  return areas;
}

auto
TriangleSurface::VertexNormals() const -> std::vector<PointType>
{
  std::vector<PointType> normals(points.size(), PointType{ 0.0, 0.0, 0.0 });
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const PointType normal = AreaNormal(t);
    for (const std::uint32_t corner : triangles[t])
    {
      for (unsigned int d = 0; d < 3; ++d)
      {
        normals[corner][d] += normal[d];
      }
    }
  }
  for (PointType & normal : normals)
  {
    const double length = Length(normal);
    if (length > 0.0)
    {
      for (double & component : normal)
      {
        component /= length;
      }
    }
  }
  return normals;
}

auto
TriangleSurface::AreaCentroid() const -> PointType
{
  PointType centroid{ 0.0, 0.0, 0.0 };
  double    total = 0.0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const double area = Length(AreaNormal(t));
    total += area;
    for (const std::uint32_t corner : triangles[t])
    {
      for (unsigned int d = 0; d < 3; ++d)
      {
        centroid[d] += area * points[corner][d] / 3.0;
      }
    }
  }
  if (total <= 0.0)
  {
    total = static_cast<double>(points.size());
    for (const PointType & point : points)
    {
      for (unsigned int d = 0; d < 3; ++d)
      {
        centroid[d] += point[d];
      }
    }
  }
  if (total > 0.0)
  {
    for (double & component : centroid)
    {
      component /= total;
    }
  }
  return centroid;
}

double
TriangleSurface::Area() const
{
  double total = 0.0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    total += Length(AreaNormal(t));
  }
  return total;
}
} // namespace itk

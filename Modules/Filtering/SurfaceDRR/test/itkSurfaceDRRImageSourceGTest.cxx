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
#include "itkSurfaceDRRImageSource.h"

#include "itkCommand.h"
#include "itkImageRegionConstIteratorWithIndex.h"
#include "itkMath.h"
#include "itkReproducibleRandom.h"
#include "itkStreamingImageFilter.h"
#include "itkMessageOfCall.h"
#include "itkTestingMacros.h"
#include "itkTriangleCell.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>
#include <sstream>

namespace
{
using itk::MessageOfCall;
using MeshType = itk::Mesh<float, 3>;
using ImageType = itk::Image<float, 2>;
using SourceType = itk::SurfaceDRRImageSource<MeshType, ImageType>;
using GeometryType = itk::CephalometricGeometry;
using NormalizationEnum = SourceType::NormalizationEnum;
using OutputEnum = SourceType::OutputEnum;

GeometryType::Pointer
MakeGeometry(double spacingU = 0.25, double spacingV = 0.25)
{
  auto                           geometry = GeometryType::New();
  GeometryType::PixelSpacingType spacing;
  spacing[0] = spacingU;
  spacing[1] = spacingV;
  geometry->SetPixelSpacing(spacing);
  return geometry;
}

template <typename TMesh>
void
AddTriangle(TMesh * mesh, unsigned int a, unsigned int b, unsigned int c)
{
  typename TMesh::CellAutoPointer cell;
  cell.TakeOwnership(new itk::TriangleCell<typename TMesh::CellType>);
  const typename TMesh::PointIdentifier ids[3] = { a, b, c };
  cell->SetPointIds(ids);
  mesh->SetCell(mesh->GetNumberOfCells(), cell);
}

/** A grid of n x n squares over corner + s first + t second, s and t in [0, 1]. */
template <typename TMesh = MeshType>
typename TMesh::Pointer
MakePlate(const itk::Vector<double, 3> & corner,
          const itk::Vector<double, 3> & first,
          const itk::Vector<double, 3> & second,
          unsigned int                   n)
{
  auto mesh = TMesh::New();
  for (unsigned int j = 0; j <= n; ++j)
  {
    for (unsigned int i = 0; i <= n; ++i)
    {
      const auto                p = corner + first * (double(i) / n) + second * (double(j) / n);
      typename TMesh::PointType point;
      for (unsigned int d = 0; d < 3; ++d)
      {
        point[d] = static_cast<float>(p[d]);
      }
      mesh->SetPoint(j * (n + 1) + i, point);
    }
  }
  for (unsigned int j = 0; j < n; ++j)
  {
    for (unsigned int i = 0; i < n; ++i)
    {
      const unsigned int a = j * (n + 1) + i;
      AddTriangle(mesh.GetPointer(), a, a + 1, a + n + 2);
      AddTriangle(mesh.GetPointer(), a, a + n + 2, a + n + 1);
    }
  }
  return mesh;
}

/** A plate about a centre, its normal turned by an angle from the lateral axis about z. */
MeshType::Pointer
MakeTiltedPlate(double angle, double width, const itk::Vector<double, 3> & centre, unsigned int n)
{
  itk::Vector<double, 3> first;
  first[0] = width * std::cos(angle);
  first[1] = width * std::sin(angle);
  first[2] = 0.0;
  itk::Vector<double, 3> second;
  second[0] = 0.0;
  second[1] = 0.0;
  second[2] = width;
  return MakePlate(centre - first * 0.5 - second * 0.5, first, second, n);
}

/** A sphere by subdividing an octahedron: areas of the vertices are even. */
MeshType::Pointer
MakeSphere(double radius, unsigned int levels)
{
  using Vector = itk::Vector<double, 3>;
  std::vector<Vector>                      points;
  std::vector<std::array<unsigned int, 3>> triangles;
  for (unsigned int d = 0; d < 3; ++d)
  {
    for (const double sign : { 1.0, -1.0 })
    {
      Vector p(0.0);
      p[d] = sign;
      points.push_back(p);
    }
  }
  for (unsigned int x = 0; x < 2; ++x)
  {
    for (unsigned int y = 2; y < 4; ++y)
    {
      for (unsigned int z = 4; z < 6; ++z)
      {
        triangles.push_back({ x, y, z });
      }
    }
  }
  for (unsigned int level = 0; level < levels; ++level)
  {
    std::map<std::pair<unsigned int, unsigned int>, unsigned int> middles;
    const auto                                                    middle = [&](unsigned int a, unsigned int b) {
      const auto key = std::minmax(a, b);
      const auto found = middles.find(key);
      if (found != middles.end())
      {
        return found->second;
      }
      Vector p = points[a] + points[b];
      p.Normalize();
      points.push_back(p);
      return middles[key] = static_cast<unsigned int>(points.size() - 1);
    };
    std::vector<std::array<unsigned int, 3>> finer;
    for (const auto & t : triangles)
    {
      const unsigned int ab = middle(t[0], t[1]);
      const unsigned int bc = middle(t[1], t[2]);
      const unsigned int ca = middle(t[2], t[0]);
      finer.push_back({ t[0], ab, ca });
      finer.push_back({ ab, t[1], bc });
      finer.push_back({ ca, bc, t[2] });
      finer.push_back({ ab, bc, ca });
    }
    triangles.swap(finer);
  }
  auto mesh = MeshType::New();
  for (unsigned int i = 0; i < points.size(); ++i)
  {
    MeshType::PointType point;
    for (unsigned int d = 0; d < 3; ++d)
    {
      point[d] = static_cast<float>(radius * points[i][d]);
    }
    mesh->SetPoint(i, point);
  }
  for (const auto & t : triangles)
  {
    AddTriangle(mesh.GetPointer(), t[0], t[1], t[2]);
  }
  return mesh;
}

itk::Vector<double, 3>
Position(double x, double y, double z)
{
  itk::Vector<double, 3> p;
  p[0] = x;
  p[1] = y;
  p[2] = z;
  return p;
}

SourceType::Pointer
MakeSource(const MeshType * mesh, GeometryType * geometry, double sigma)
{
  auto source = SourceType::New();
  source->SetInput(mesh);
  source->SetGeometry(geometry);
  source->SetSigma(sigma);
  source->SetSizeToCoverMeshes(4.0 * sigma);
  return source;
}

float
At(const ImageType * image, itk::IndexValueType u, itk::IndexValueType v)
{
  return image->GetPixel({ { u, v } });
}

std::vector<float>
Pixels(const ImageType * image)
{
  return { image->GetBufferPointer(), image->GetBufferPointer() + image->GetBufferedRegion().GetNumberOfPixels() };
}

int
ExerciseBasicObjectMethods()
{
  auto source = SourceType::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(source, SurfaceDRRImageSource, GenerateImageSource);
  return EXIT_SUCCESS;
}
} // namespace

TEST(SurfaceDRRImageSource, ObeysTheBasicObjectContract)
{
  EXPECT_EQ(ExerciseBasicObjectMethods(), EXIT_SUCCESS);
}

TEST(SurfaceDRRImageSource, SphereShellHasItsClosedFormThickness)
{
  // A ray at distance b from the centre crosses two shells at the angle asin(b / R): 2 rho / sqrt(1 - (b / R)^2).
  constexpr double radius = 10.0;
  constexpr double shell = 0.7;
  auto             geometry = MakeGeometry();
  // Off the central ray, so that magnification and obliquity count.
  GeometryType::RotationType identity;
  identity.SetIdentity();
  geometry->SetPose(identity, Position(60.0, 15.0, -40.0));
  const auto sphere = MakeSphere(radius, 7);
  double     errors[2] = {};
  for (unsigned int refinement = 0; refinement < 2; ++refinement)
  {
    const auto mesh = refinement == 0 ? MakeSphere(radius, 4) : sphere;
    const auto source = MakeSource(mesh, geometry, 0.3);
    source->SetDensity(shell);
    source->Update();
    const ImageType * image = source->GetOutput();
    for (itk::ImageRegionConstIteratorWithIndex<ImageType> it(image, image->GetBufferedRegion()); !it.IsAtEnd(); ++it)
    {
      GeometryType::PixelIndexType index;
      index[0] = static_cast<double>(it.GetIndex()[0]);
      index[1] = static_cast<double>(it.GetIndex()[1]);
      const auto   ray = geometry->BackProject(index);
      const auto   toCentre = itk::Point<double, 3>(0.0) - ray.origin;
      const double along = toCentre * ray.direction;
      const double b = std::sqrt(std::max(0.0, toCentre.GetSquaredNorm() - along * along)) / radius;
      if (b < 0.8)
      {
        const double expected = 2.0 * shell / std::sqrt(1.0 - b * b);
        errors[refinement] = std::max(errors[refinement], std::abs(it.Get() / expected - 1.0));
      }
      else if (b > 1.2)
      {
        EXPECT_LT(it.Get(), 1e-2 * shell);
      }
    }
  }
  // The splat's blur of the curved profile itself is below 1 % for b < 0.8.
  EXPECT_LT(errors[1], 0.012);
  EXPECT_GT(errors[0], 3.0 * errors[1]) << "a coarse mesh is worse: the sum converges as the mesh is refined";
}

TEST(SurfaceDRRImageSource, TiltedPlateIsThickerByOneOverTheCosine)
{
  for (const double angle : { 0.0, itk::Math::pi / 3.0 })
  {
    for (const double offset : { 0.0, 80.0 })
    {
      auto geometry = MakeGeometry();
      // The ray's angle counts from the principal point, not from pixel 0.
      GeometryType::PixelIndexType principal;
      principal[0] = 1500.0;
      principal[1] = -1200.0;
      geometry->SetPrincipalPoint(principal);
      const auto mesh = MakeTiltedPlate(angle, 20.0, Position(offset, 10.0, -0.5 * offset), 160);
      const auto source = MakeSource(mesh, geometry, 0.4);
      source->SetDensity(1.5);
      source->SetTolerance(1e-4);
      source->Update();
      GeometryType::PointType centre;
      centre[0] = offset;
      centre[1] = 10.0;
      centre[2] = -0.5 * offset;
      const auto                   index = geometry->ProjectPoint(centre);
      const itk::IndexValueType    u = itk::Math::Round<itk::IndexValueType>(index[0]);
      const itk::IndexValueType    v = itk::Math::Round<itk::IndexValueType>(index[1]);
      GeometryType::PixelIndexType pixel;
      pixel[0] = static_cast<double>(u);
      pixel[1] = static_cast<double>(v);
      // The plate's normal.
      const auto   normal = Position(-std::sin(angle), std::cos(angle), 0.0);
      const double cosine = std::abs(geometry->BackProject(pixel).direction * normal);
      // Vertices 0.125 mm apart under a sigma of 0.4 mm: the sum is the integral to 1e-6; the cosine varies over the
      // splat and float coordinates disturb the areas.
      EXPECT_NEAR(At(source->GetOutput(), u, v) * cosine / 1.5, 1.0, 1e-3) << angle << " at " << offset;
    }
  }
}

TEST(SurfaceDRRImageSource, WideSplatsStayWithinTheToleranceToTheirEnds)
{
  // 24 by 30 pixels wide, in an image that shows them to 5 sigma; off the central ray, pixels not square.
  constexpr double             sigma = 12.0;
  auto                         geometry = MakeGeometry(0.5, 0.4);
  GeometryType::PixelIndexType principal;
  principal[0] = -300.0;
  principal[1] = 210.0;
  geometry->SetPrincipalPoint(principal);
  const auto mesh = MakeTiltedPlate(0.7, 25.0, Position(60.0, 30.0, -40.0), 6);
  for (const auto normalization : { NormalizationEnum::Physical, NormalizationEnum::Paper })
  {
    const auto source = MakeSource(mesh, geometry, sigma);
    source->SetSizeToCoverMeshes(5.0 * sigma);
    source->SetNormalization(normalization);
    source->SetDensity(1.3);
    // The sum by its definition, in double: a third of the area of each vertex's triangles, spread over the plane.
    std::vector<double> areas(mesh->GetNumberOfPoints(), 0.0);
    for (auto it = mesh->GetCells()->Begin(); it != mesh->GetCells()->End(); ++it)
    {
      const auto * ids = it.Value()->GetPointIds();
      const auto   edge1 = mesh->GetPoint(ids[1]) - mesh->GetPoint(ids[0]);
      const auto   edge2 = mesh->GetPoint(ids[2]) - mesh->GetPoint(ids[0]);
      for (unsigned int corner = 0; corner < 3; ++corner)
      {
        areas[ids[corner]] += itk::CrossProduct(edge1, edge2).GetNorm() / 6.0;
      }
    }
    struct Splat
    {
      double u;
      double v;
      double weight;
    };
    std::vector<Splat> splats;
    for (unsigned int i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      GeometryType::PointType point;
      point.CastFrom(mesh->GetPoint(i));
      const auto   index = geometry->ProjectPoint(point);
      const double m = 1674.0 / (1524.0 + point[1]);
      const double away = std::hypot(0.5 * (index[0] - principal[0]), 0.4 * (index[1] - principal[1]));
      const double cosine = 1674.0 / std::hypot(1674.0, away);
      const double physical = m * m / (2.0 * itk::Math::pi * sigma * sigma * cosine);
      splats.push_back(
        { index[0], index[1], 1.3 * areas[i] * (normalization == NormalizationEnum::Physical ? physical : 1.0) });
    }
    for (const double tolerance : { 1e-2, 1e-4 })
    {
      source->SetTolerance(tolerance);
      source->Update();
      const ImageType * image = source->GetOutput();
      double            largest = 0.0;
      double            error = 0.0;
      for (itk::ImageRegionConstIteratorWithIndex<ImageType> it(image, image->GetBufferedRegion()); !it.IsAtEnd(); ++it)
      {
        double sum = 0.0;
        for (const Splat & splat : splats)
        {
          const double du = 0.5 * (static_cast<double>(it.GetIndex()[0]) - splat.u);
          const double dv = 0.4 * (static_cast<double>(it.GetIndex()[1]) - splat.v);
          sum += splat.weight * std::exp(-0.5 * (du * du + dv * dv) / (sigma * sigma));
        }
        largest = std::max(largest, sum);
        error = std::max(error, std::abs(it.Get() - sum));
      }
      EXPECT_LE(error, tolerance * largest) << normalization << ", tolerance " << tolerance;
      // Looser tolerances are used: else this would not show what is cut off.
      EXPECT_GE(error, 0.05 * tolerance * largest) << normalization << ", tolerance " << tolerance;
    }
  }
}

TEST(SurfaceDRRImageSource, PaperNormalizationIsTheBareSumOfAreas)
{
  auto         geometry = MakeGeometry();
  auto         mesh = MeshType::New();
  const double corners[3][3] = { { 0, 0, 0 }, { 3, 0, 0 }, { 0, 0, 4 } };
  for (unsigned int i = 0; i < 3; ++i)
  {
    MeshType::PointType p;
    p[0] = static_cast<float>(corners[i][0]);
    p[1] = static_cast<float>(corners[i][1]);
    p[2] = static_cast<float>(corners[i][2]);
    mesh->SetPoint(i, p);
  }
  AddTriangle(mesh.GetPointer(), 0, 1, 2);
  const auto source = MakeSource(mesh, geometry, 0.25);
  source->SetNormalization(NormalizationEnum::Paper);
  source->SetDensity(2.0);
  source->Update();
  // The vertex at the origin lies on pixel (0, 0); its area is a third of 6 mm^2. The other vertices are 13 sigma away.
  EXPECT_NEAR(At(source->GetOutput(), 0, 0), 2.0 * 2.0, 1e-3);
  // One pixel is one sigma off.
  EXPECT_NEAR(At(source->GetOutput(), -1, 0), 4.0 * std::exp(-0.5), 4e-3);
  EXPECT_NEAR(At(source->GetOutput(), 1, 1), 4.0 * std::exp(-1.0), 4e-3);
}

TEST(SurfaceDRRImageSource, EdgesOfPlatesAtTwoDepthsLieWhereTheyAreProjected)
{
  auto       geometry = MakeGeometry();
  const auto near = MakeTiltedPlate(0.0, 30.0, Position(0.0, -40.0, 30.0), 200);
  const auto far = MakeTiltedPlate(0.0, 30.0, Position(0.0, 40.0, -30.0), 200);
  for (const auto side : { GeometryType::SourceSideEnum::Right, GeometryType::SourceSideEnum::Left })
  {
    for (const auto facing : { GeometryType::FacingEnum::Right, GeometryType::FacingEnum::Left })
    {
      geometry->SetSourceSide(side);
      geometry->SetFacing(facing);
      auto source = SourceType::New();
      source->SetInput(0, near);
      source->SetInput(1, far);
      source->SetGeometry(geometry);
      source->SetSigma(0.5);
      source->SetSizeToCoverMeshes(3.0);
      source->Update();
      for (const double y : { -40.0, 40.0 })
      {
        // Along the row through the plate's middle the value is half the plateau's at the plate's edge. The plate's
        // border vertices carry half an area each, as the integral wants.
        GeometryType::PointType edge;
        edge[0] = 15.0;
        edge[1] = y;
        edge[2] = -0.75 * y;
        GeometryType::PointType middle = edge;
        middle[0] = 0.0;
        const auto                edgeIndex = geometry->ProjectPoint(edge);
        const auto                middleIndex = geometry->ProjectPoint(middle);
        const itk::IndexValueType row = itk::Math::Round<itk::IndexValueType>(middleIndex[1]);
        const double plateau = At(source->GetOutput(), itk::Math::Round<itk::IndexValueType>(middleIndex[0]), row);
        const int    step = edgeIndex[0] > middleIndex[0] ? 1 : -1;
        itk::IndexValueType u = itk::Math::Round<itk::IndexValueType>(middleIndex[0]);
        while (At(source->GetOutput(), u + step, row) > 0.5 * plateau)
        {
          u += step;
        }
        const double inside = At(source->GetOutput(), u, row);
        const double outside = At(source->GetOutput(), u + step, row);
        const double crossing = static_cast<double>(u) + step * (inside - 0.5 * plateau) / (inside - outside);
        // The plates' edges differ by 3.5 pixels: 1674 / (1524 -+ 40).
        EXPECT_NEAR(crossing, edgeIndex[0], 0.02) << "y = " << y << ", " << side << ", facing " << facing;
      }
    }
  }
}

TEST(SurfaceDRRImageSource, ImageIndexIsTheProjectedPixelIndex)
{
  auto                         geometry = MakeGeometry(0.25, 0.2);
  GeometryType::PixelIndexType principal;
  principal[0] = 12.5;
  principal[1] = 30.25;
  geometry->SetPrincipalPoint(principal);
  // A speck: its centroid in the image is its projection.
  const auto speck = MakeTiltedPlate(0.0, 0.01, Position(3.0, -20.0, 2.0), 1);
  auto       source = SourceType::New();
  source->SetInput(speck);
  source->SetGeometry(geometry);
  source->SetSigma(0.5);
  SourceType::SizeType size;
  size.Fill(90);
  source->SetSize(size);
  source->Update();
  GeometryType::PointType centre;
  centre[0] = 3.0;
  centre[1] = -20.0;
  centre[2] = 2.0;
  const auto expected = geometry->ProjectPoint(centre);
  const auto centroid = [](const ImageType * image) {
    itk::Point<double, 2> sum(0.0);
    double                total = 0.0;
    for (itk::ImageRegionConstIteratorWithIndex<ImageType> it(image, image->GetBufferedRegion()); !it.IsAtEnd(); ++it)
    {
      for (unsigned int d = 0; d < 2; ++d)
      {
        sum[d] += it.Get() * static_cast<double>(it.GetIndex()[d]);
      }
      total += it.Get();
    }
    sum[0] /= total;
    sum[1] /= total;
    return sum;
  };
  auto c = centroid(source->GetOutput());
  EXPECT_NEAR(c[0], expected[0], 2e-3);
  EXPECT_NEAR(c[1], expected[1], 2e-3);
  EXPECT_EQ(source->GetOutput()->GetSpacing()[0], 0.25);
  EXPECT_EQ(source->GetOutput()->GetSpacing()[1], 0.2);

  // The same through physical space: other spacing, an origin off the grid.
  source->UseGeometrySpacingOff();
  SourceType::SpacingType spacing;
  spacing[0] = 0.4;
  spacing[1] = 0.3;
  source->SetSpacing(spacing);
  SourceType::PointType origin;
  origin[0] = -1.3;
  origin[1] = 0.7;
  source->SetOrigin(origin);
  source->Update();
  c = centroid(source->GetOutput());
  EXPECT_NEAR((c[0] * 0.4 - 1.3) / 0.25, expected[0], 4e-3);
  EXPECT_NEAR((c[1] * 0.3 + 0.7) / 0.2, expected[1], 4e-3);

  // From the front what stood along the rays runs along the film.
  geometry->SetDirection(GeometryType::DirectionEnum::Frontal);
  geometry->SetPatientLeft(GeometryType::PatientLeftEnum::Left);
  source->UseGeometrySpacingOn();
  origin.Fill(0.0);
  source->SetOrigin(origin);
  size.Fill(160);
  source->SetSize(size);
  source->Update();
  c = centroid(source->GetOutput());
  const auto frontal = geometry->ProjectPoint(centre);
  EXPECT_NEAR(frontal[0], 12.5 + geometry->GetMagnification(centre) * 20.0 / 0.25, 1e-9);
  EXPECT_NEAR(c[0], frontal[0], 2e-3);
  EXPECT_NEAR(c[1], frontal[1], 2e-3);
}

TEST(SurfaceDRRImageSource, SplatIsRoundInMillimetresWherePixelsAreNotSquare)
{
  auto       geometry = MakeGeometry(0.1, 0.3);
  const auto speck = MakeTiltedPlate(0.0, 1e-3, Position(0.0, 0.0, 0.0), 1);
  const auto source = MakeSource(speck, geometry, 0.6);
  source->SetTolerance(1e-5);
  source->Update();
  const double peak = At(source->GetOutput(), 0, 0);
  ASSERT_GT(peak, 0.0);
  EXPECT_NEAR(At(source->GetOutput(), 6, 0) / peak, std::exp(-0.5), 1e-3);
  EXPECT_NEAR(At(source->GetOutput(), 0, 2) / peak, std::exp(-0.5), 1e-3);
  EXPECT_NEAR(At(source->GetOutput(), -12, -2) / peak, std::exp(-2.5), 1e-3);
}

TEST(SurfaceDRRImageSource, PhysicalSplatsIntegrateToAreaTimesSquaredMagnification)
{
  // Over the detector, in mm^2, whatever the width and the pixels.
  for (const double sigma : { 0.3, 0.8 })
  {
    auto       geometry = MakeGeometry(0.2, 0.25);
    const auto plate = MakeTiltedPlate(0.0, 10.0, Position(0.0, 50.0, 0.0), 20);
    const auto source = MakeSource(plate, geometry, sigma);
    source->Update();
    double sum = 0.0;
    for (const float value : Pixels(source->GetOutput()))
    {
      sum += value;
    }
    const double m = 1674.0 / 1574.0;
    // 1 / cos(alpha) is below 1 + 1e-5 here; the cut-off tails count for 2e-4.
    EXPECT_NEAR(sum * 0.2 * 0.25, 100.0 * m * m, 0.05) << sigma;
  }
}

TEST(SurfaceDRRImageSource, MeshesAddUpEachWithItsOwnWidth)
{
  auto       geometry = MakeGeometry();
  const auto left = MakeTiltedPlate(0.3, 8.0, Position(-2.0, 20.0, 0.0), 12);
  const auto right = MakeTiltedPlate(0.1, 8.0, Position(3.0, -20.0, 1.0), 12);
  auto       both = SourceType::New();
  both->SetInput(0, left);
  both->SetInput(1, right);
  both->SetGeometry(geometry);
  both->SetMeshSigma(0, 0.4);
  both->SetMeshSigma(1, 0.9);
  both->SetTolerance(1e-5);
  both->SetSizeToCoverMeshes(3.0);
  both->Update();
  EXPECT_EQ(both->GetNumberOfMeshes(), 2u);
  std::vector<float> sum(both->GetOutput()->GetBufferedRegion().GetNumberOfPixels(), 0.0f);
  for (unsigned int number = 0; number < 2; ++number)
  {
    auto single = SourceType::New();
    single->SetInput(number == 0 ? left : right);
    single->SetGeometry(geometry);
    single->SetSigma(number == 0 ? 0.4 : 0.9);
    single->SetTolerance(1e-5);
    single->SetStartIndex(both->GetOutput()->GetLargestPossibleRegion().GetIndex());
    single->SetSize(both->GetOutput()->GetLargestPossibleRegion().GetSize());
    single->Update();
    const auto pixels = Pixels(single->GetOutput());
    for (std::size_t i = 0; i < sum.size(); ++i)
    {
      sum[i] += pixels[i];
    }
  }
  const auto pixels = Pixels(both->GetOutput());
  for (std::size_t i = 0; i < sum.size(); ++i)
  {
    ASSERT_NEAR(pixels[i], sum[i], 2e-5) << i;
  }
}

TEST(SurfaceDRRImageSource, EqualVertexSigmasMatchOneSigma)
{
  auto       geometry = MakeGeometry();
  const auto mesh = MakeTiltedPlate(0.4, 6.0, Position(0.0, 0.0, 0.0), 10);
  const auto source = MakeSource(mesh, geometry, 0.45);
  source->Update();
  const auto  one = Pixels(source->GetOutput());
  const float peak = *std::max_element(one.begin(), one.end());
  source->SetVertexSigmas(0, std::vector<double>(mesh->GetNumberOfPoints(), 0.45));
  source->Update();
  EXPECT_EQ(source->GetSplatMethod(0), itk::SurfaceSplatKernel::MethodEnum::PerSplat);
  const auto each = Pixels(source->GetOutput());
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    ASSERT_NEAR(each[i], one[i], 2e-3 * peak);
  }
  source->SetVertexSigmas(0, {});
  source->Update();
  EXPECT_EQ(Pixels(source->GetOutput()), one);
}

TEST(SurfaceDRRImageSource, OutputsFollowBeerAndLambert)
{
  auto       geometry = MakeGeometry();
  const auto mesh = MakeTiltedPlate(0.4, 6.0, Position(0.0, 0.0, 0.0), 30);
  const auto source = MakeSource(mesh, geometry, 0.5);
  source->Update();
  const auto thickness = Pixels(source->GetOutput());
  source->SetSourceIntensity(200.0);
  source->SetAttenuation(0.7);
  source->SetOutputMode(OutputEnum::Intensity);
  source->Update();
  const auto intensity = Pixels(source->GetOutput());
  source->SetOutputMode(OutputEnum::InvertedIntensity);
  source->Update();
  const auto inverted = Pixels(source->GetOutput());
  for (std::size_t i = 0; i < thickness.size(); ++i)
  {
    const double expected = 200.0 * std::exp(-0.7 * thickness[i]);
    ASSERT_NEAR(intensity[i], expected, 1e-3);
    ASSERT_NEAR(inverted[i], 200.0 - expected, 1e-3);
  }

  using ByteSource = itk::SurfaceDRRImageSource<MeshType, itk::Image<unsigned char, 2>>;
  auto bytes = ByteSource::New();
  bytes->SetInput(mesh);
  bytes->SetGeometry(geometry);
  bytes->SetSigma(0.5);
  bytes->SetStartIndex(source->GetOutput()->GetLargestPossibleRegion().GetIndex());
  bytes->SetSize(source->GetOutput()->GetLargestPossibleRegion().GetSize());
  bytes->SetSourceIntensity(200.0);
  bytes->SetAttenuation(0.7);
  bytes->SetOutputMode(OutputEnum::InvertedIntensity);
  bytes->Update();
  for (std::size_t i = 0; i < inverted.size(); ++i)
  {
    ASSERT_NEAR(static_cast<double>(bytes->GetOutput()->GetBufferPointer()[i]), inverted[i], 0.5 + 1e-3);
  }
  bytes->SetSourceIntensity(1e6);
  bytes->Update();
  const auto * first = bytes->GetOutput()->GetBufferPointer();
  EXPECT_EQ(*std::max_element(first, first + inverted.size()), 255) << "clamped, not wrapped";
}

class SurfaceDRRStreaming : public ::testing::TestWithParam<double>
{};

TEST_P(SurfaceDRRStreaming, StripsAndThreadsGiveTheSameBitsAndMeshWorkIsDoneOnce)
{
  auto       geometry = MakeGeometry();
  const auto upper = MakeSphere(12.0, 5);
  const auto lower = MakeTiltedPlate(0.4, 20.0, Position(5.0, 10.0, -8.0), 60);
  auto       source = SourceType::New();
  source->SetInput(0, upper);
  source->SetInput(1, lower);
  source->SetGeometry(geometry);
  source->SetSigma(GetParam());
  source->SetSizeToCoverMeshes(4.0);
  source->SetNumberOfWorkUnits(1);
  source->Update();
  const auto whole = Pixels(source->GetOutput());
  ASSERT_GT(*std::max_element(whole.begin(), whole.end()), 0.0f);
  EXPECT_EQ(source->GetNumberOfFlattenings(), 2u) << "shared with the region that covers the meshes";
  for (const unsigned int units : { 2u, 5u })
  {
    source->SetNumberOfWorkUnits(units);
    source->Update();
    EXPECT_EQ(Pixels(source->GetOutput()), whole) << units << " work units";
  }
  const auto projections = source->GetNumberOfProjections();
  unsigned   executions = 0;
  auto       counter = itk::CStyleCommand::New();
  counter->SetClientData(&executions);
  counter->SetCallback([](itk::Object *, const itk::EventObject &, void * data) { ++*static_cast<unsigned *>(data); });
  source->AddObserver(itk::StartEvent(), counter);
  for (const unsigned int strips : { 1u, 7u })
  {
    executions = 0;
    source->GetOutput()->ReleaseData();
    auto streamer = itk::StreamingImageFilter<ImageType, ImageType>::New();
    streamer->SetInput(source->GetOutput());
    streamer->SetNumberOfStreamDivisions(strips);
    streamer->Update();
    EXPECT_EQ(executions, strips);
    EXPECT_EQ(Pixels(streamer->GetOutput()), whole) << strips << " strips";
  }
  EXPECT_EQ(source->GetNumberOfFlattenings(), 2u);
  EXPECT_EQ(source->GetNumberOfProjections(), projections);
}

INSTANTIATE_TEST_SUITE_P(Widths, SurfaceDRRStreaming, ::testing::Values(0.2, 0.9));

TEST(SurfaceDRRImageSource, RepeatsOnlyWhatAChangeTouches)
{
  auto       geometry = MakeGeometry();
  const auto upper = MakeTiltedPlate(0.1, 8.0, Position(0.0, 0.0, 5.0), 8);
  const auto lower = MakeTiltedPlate(0.1, 8.0, Position(0.0, 0.0, -5.0), 8);
  auto       source = SourceType::New();
  source->SetInput(0, upper);
  source->SetInput(1, lower);
  source->SetGeometry(geometry);
  source->Update();
  EXPECT_EQ(source->GetNumberOfFlattenings(), 2u);
  EXPECT_EQ(source->GetNumberOfProjections(), 1u);
  source->Update();
  EXPECT_EQ(source->GetNumberOfProjections(), 1u);
  // A new pose leaves the meshes alone.
  GeometryType::RotationType identity;
  identity.SetIdentity();
  geometry->SetPose(identity, Position(5.0, 0.0, 0.0));
  source->Update();
  EXPECT_EQ(source->GetNumberOfFlattenings(), 2u);
  EXPECT_EQ(source->GetNumberOfProjections(), 2u);
  // One changed mesh does not flatten the other.
  const auto          before = Pixels(source->GetOutput());
  MeshType::PointType point = lower->GetPoint(3);
  point[2] -= 1.0f;
  lower->SetPoint(3, point);
  lower->Modified();
  source->Update();
  EXPECT_EQ(source->GetNumberOfFlattenings(), 3u);
  EXPECT_EQ(source->GetNumberOfProjections(), 3u);
  EXPECT_NE(Pixels(source->GetOutput()), before);
}

TEST(SurfaceDRRImageSource, ReferenceImageWithoutSpacingGivesItsPixels)
{
  auto       geometry = MakeGeometry();
  const auto mesh = MakeTiltedPlate(0.1, 8.0, Position(8.0, 0.0, -8.0), 8);
  // As a PNG is read: spacing 1.
  auto                  radiograph = ImageType::New();
  ImageType::RegionType region;
  region.SetSize(0, 120);
  region.SetSize(1, 90);
  radiograph->SetRegions(region);
  radiograph->Allocate();
  auto source = SourceType::New();
  source->SetInput(mesh);
  source->SetGeometry(geometry);
  source->SetReferenceImage(radiograph);
  source->UseReferenceImageOn();
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetLargestPossibleRegion(), region);
  EXPECT_EQ(source->GetOutput()->GetSpacing()[0], 0.25);
  const auto referenced = Pixels(source->GetOutput());
  source->UseReferenceImageOff();
  source->SetSize(region.GetSize());
  source->Update();
  EXPECT_EQ(Pixels(source->GetOutput()), referenced);
}

TEST(SurfaceDRRImageSource, CoveringImageHoldsTheMeshAndItsMargin)
{
  auto       geometry = MakeGeometry();
  const auto mesh = MakeTiltedPlate(0.0, 10.0, Position(0.0, 0.0, 0.0), 2);
  auto       source = SourceType::New();
  source->SetInput(mesh);
  source->SetGeometry(geometry);
  source->SetSizeToCoverMeshes(2.0);
  source->Update();
  // Half a plate is 5 mm * 1674 / 1524 = 5.4921 mm = 21.97 pixels, the margin 8.
  const auto region = source->GetOutput()->GetLargestPossibleRegion();
  EXPECT_EQ(region.GetIndex(0), -30);
  EXPECT_EQ(region.GetIndex(1), -30);
  EXPECT_EQ(region.GetSize(0), 61u);
  EXPECT_EQ(region.GetSize(1), 61u);
  EXPECT_EQ(source->GetOutput()->GetOrigin()[0], 0.0);
  EXPECT_GT(At(source->GetOutput(), -20, -20), 0.0f);
}

TEST(SurfaceDRRImageSource, CoversItsMeshesByItselfAndFollowsThem)
{
  auto       geometry = MakeGeometry();
  const auto small = MakeTiltedPlate(0.0, 10.0, Position(0.0, 0.0, 0.0), 2);
  auto       source = SourceType::New();
  source->SetInput(small);
  source->SetGeometry(geometry);
  source->Update();
  const auto * const image = source->GetOutput();
  // Half a plate is 21.97 pixels; four sigma of 0.5 mm are 8 more.
  EXPECT_EQ(image->GetLargestPossibleRegion().GetIndex(0), -30);
  EXPECT_EQ(image->GetLargestPossibleRegion().GetSize(0), 61u);

  // A larger mesh, on the second Update() of the same source, is not clipped: half of it is 43.9 pixels.
  source->SetInput(MakeTiltedPlate(0.0, 20.0, Position(0.0, 0.0, 0.0), 4));
  source->Update();
  EXPECT_EQ(image->GetLargestPossibleRegion().GetIndex(0), -52);
  EXPECT_EQ(image->GetLargestPossibleRegion().GetSize(0), 105u);
  EXPECT_EQ(image->GetBufferedRegion(), image->GetLargestPossibleRegion());
  EXPECT_GT(At(image, -43, -43), 0.0f);

  // A wider splat, per vertex too, and a pose move the region.
  source->SetVertexSigmas(0, std::vector<double>(25, 1.0));
  source->UpdateOutputInformation();
  EXPECT_EQ(image->GetLargestPossibleRegion().GetIndex(0), -60);
  source->SetVertexSigmas(0, {});
  GeometryType::RotationType identity;
  identity.SetIdentity();
  geometry->SetPose(identity, Position(20.0, 0.0, 0.0));
  source->UpdateOutputInformation();
  // 20 mm * 1674 / 1524 = 87.87 pixels to the right.
  EXPECT_EQ(image->GetLargestPossibleRegion().GetIndex(0), 35);

  // A size of one's own ends it, until it is wanted again.
  SourceType::SizeType size;
  size.Fill(64);
  source->SetSize(size);
  EXPECT_FALSE(source->GetCoverMeshes());
  source->Update();
  EXPECT_EQ(image->GetLargestPossibleRegion().GetIndex(0), 0);
  EXPECT_EQ(image->GetLargestPossibleRegion().GetSize(), size);
  source->CoverMeshesOn();
  source->SetCoverMargin(0.0);
  source->Update();
  EXPECT_EQ(image->GetLargestPossibleRegion().GetIndex(0), 43);
}

TEST(SurfaceDRRImageSource, NoRegionIsAnError)
{
  auto       source = SourceType::New();
  const auto message = [&source]() { return MessageOfCall([&source]() { source->UpdateOutputInformation(); }); };
  source->SetGeometry(MakeGeometry());
  EXPECT_NE(message().find("SetInput()"), std::string::npos) << message();
  source->SetInput(MakeTiltedPlate(0.0, 10.0, Position(0.0, 0.0, 0.0), 2));
  source->CoverMeshesOff();
  EXPECT_NE(message().find("SetSize()"), std::string::npos) << message();
  source->UseReferenceImageOn();
  EXPECT_NE(message().find("SetReferenceImage()"), std::string::npos) << message();
  source->UseReferenceImageOff();
  // Also with the superclass's own 64 pixels, once they are somebody's wish.
  SourceType::SizeType size;
  size.Fill(64);
  source->SetSize(size);
  EXPECT_EQ(message(), "");
  source->CoverMeshesOn();
  // 1e6 mm of margin are eight million pixels on a side.
  source->SetCoverMargin(1e6);
  EXPECT_NE(message().find("too large an image"), std::string::npos) << message();
  source->SetCoverMargin(std::nan(""));
  EXPECT_NE(message().find("SetCoverMargin()"), std::string::npos) << message();
}

TEST(SurfaceDRRImageSource, OutputInformationIsNotModifiedWhereNothingChanged)
{
  auto source = SourceType::New();
  source->SetInput(MakeTiltedPlate(0.0, 10.0, Position(0.0, 0.0, 0.0), 2));
  source->SetGeometry(MakeGeometry());
  source->Update();
  const auto time = source->GetOutput()->GetMTime();
  // Something that leaves the grid alone has the information made again; what lies downstream looks at its time.
  source->SetNumberOfWorkUnits(1);
  source->Modified();
  source->UpdateOutputInformation();
  EXPECT_EQ(source->GetOutput()->GetMTime(), time);
}

TEST(SurfaceDRRImageSource, DegenerateTrianglesLeaveNoTrace)
{
  auto geometry = MakeGeometry();
  auto mesh = MeshType::New();
  for (unsigned int i = 0; i < 3; ++i)
  {
    MeshType::PointType p;
    p.Fill(2.0f);
    mesh->SetPoint(i, p);
  }
  AddTriangle(mesh.GetPointer(), 0, 1, 2);
  auto source = SourceType::New();
  source->SetInput(mesh);
  source->SetGeometry(geometry);
  source->Update();
  for (const float value : Pixels(source->GetOutput()))
  {
    EXPECT_EQ(value, 0.0f);
  }
}

TEST(SurfaceDRRImageSource, FloatAndDoubleMeshesAgree)
{
  auto       geometry = MakeGeometry();
  const auto centre = Position(0.0, 5.0, 0.0);
  const auto first = Position(10.0, 3.0, 0.0);
  const auto second = Position(0.0, 1.0, 9.0);
  auto       single = SourceType::New();
  single->SetInput(MakePlate(centre, first, second, 9));
  single->SetGeometry(geometry);
  single->Update();
  using DoubleMesh = itk::Mesh<double, 3>;
  auto twice = itk::SurfaceDRRImageSource<DoubleMesh, ImageType>::New();
  twice->SetInput(MakePlate<DoubleMesh>(centre, first, second, 9));
  twice->SetGeometry(geometry);
  twice->Update();
  EXPECT_EQ(Pixels(single->GetOutput()), Pixels(twice->GetOutput())) << "both have float coordinates";
}

TEST(SurfaceDRRImageSource, ErrorsNameTheValueAndTheRemedy)
{
  const auto mesh = MakeTiltedPlate(0.0, 10.0, Position(0.0, 0.0, 0.0), 2);
  auto       source = SourceType::New();
  const auto message = [&source]() { return MessageOfCall([&source]() { source->Update(); }); };
  EXPECT_NE(message().find("SetInput()"), std::string::npos) << message();
  source->SetInput(mesh);
  EXPECT_NE(message().find("SetGeometry()"), std::string::npos) << message();
  auto geometry = GeometryType::New();
  source->SetGeometry(geometry);
  EXPECT_NE(message().find("SetPixelSpacing()"), std::string::npos) << message();
  source->SetGeometry(MakeGeometry());
  EXPECT_EQ(message(), "");

  source->SetInput(2, mesh);
  EXPECT_NE(message().find("without a gap"), std::string::npos) << message();
  source->SetInput(2, nullptr);
  source->SetSigma(0.0);
  EXPECT_NE(message().find("SetSigma()"), std::string::npos) << message();
  source->SetSigma(0.5);
  source->SetTolerance(0.0);
  EXPECT_NE(message().find("SetTolerance()"), std::string::npos) << message();
  source->SetTolerance(1e-3);
  source->SetVertexSigmas(0, { 0.5, 0.5 });
  EXPECT_NE(message().find("9 points but 2"), std::string::npos) << message();
  source->SetVertexSigmas(0, {});

  auto empty = MeshType::New();
  source->SetInput(empty);
  EXPECT_NE(message().find("no triangle"), std::string::npos) << message();
  const auto behind = MakeTiltedPlate(0.0, 10.0, Position(0.0, -2000.0, 0.0), 2);
  source->SetInput(behind);
  EXPECT_NE(message().find("not in front of the X-ray source"), std::string::npos) << message();
  source->SetInput(mesh);

  SourceType::DirectionType direction;
  direction.SetIdentity();
  direction(0, 0) = -1.0;
  source->SetDirection(direction);
  EXPECT_NE(message().find("SetFacing()"), std::string::npos) << message();
  direction.SetIdentity();
  source->SetDirection(direction);
  EXPECT_EQ(message(), "");
  EXPECT_NE(MessageOfCall([&source]() { source->SetSizeToCoverMeshes(-1.0); }).find("-1"), std::string::npos);
}

TEST(SurfaceDRRImageSource, AbortsFromAnObserverAndRunsAgain)
{
  const auto mesh = MakeTiltedPlate(0.0, 10.0, Position(0.0, 0.0, 0.0), 20);
  auto       source = SourceType::New();
  source->SetInput(mesh);
  source->SetGeometry(MakeGeometry());
  auto abort = itk::CStyleCommand::New();
  abort->SetCallback([](itk::Object * caller, const itk::EventObject &, void *) {
    static_cast<itk::ProcessObject *>(caller)->AbortGenerateDataOn();
  });
  const auto tag = source->AddObserver(itk::ProgressEvent(), abort);
  EXPECT_THROW(source->Update(), itk::ProcessAborted);
  source->RemoveObserver(tag);
  source->AbortGenerateDataOff();
  EXPECT_NO_THROW(source->Update());
  EXPECT_GT(At(source->GetOutput(), 5, 5), 0.0f);
  EXPECT_EQ(source->GetProgress(), 1.0f);
}

TEST(SurfaceDRRImageSource, PrintsItsParameters)
{
  const auto         source = SourceType::New();
  std::ostringstream text;
  source->Print(text);
  for (const char * name : { "Sigma", "Normalization: Physical", "OutputMode: Thickness", "Tolerance", "Attenuation" })
  {
    EXPECT_NE(text.str().find(name), std::string::npos) << name;
  }
}

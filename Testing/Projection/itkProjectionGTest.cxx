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
#include "itkDentalPhantomCaseSource.h"
#include "itkMakeTriangleSurface.h"
#include "itkMeshSilhouette.h"
#include "itkSurfaceDRRImageSource.h"

#include "itkMath.h"

#include <gtest/gtest.h>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace
{
using GeometryType = itk::CephalometricGeometry;
using CaseType = itk::DentalPhantomCaseSource;
using MaskType = std::vector<bool>;
constexpr int Width = 703;
constexpr int Height = 938;

GeometryType::Pointer
MakeGeometry(GeometryType::SourceSideEnum side, GeometryType::FacingEnum facing)
{
  auto                           geometry = GeometryType::New();
  GeometryType::PixelSpacingType spacing;
  spacing.Fill(0.25);
  GeometryType::PixelIndexType principal;
  principal[0] = 301.3;
  principal[1] = 455.8;
  geometry->SetPixelSpacing(spacing);
  geometry->SetPrincipalPoint(principal);
  geometry->SetSourceSide(side);
  geometry->SetFacing(facing);
  return geometry;
}

itk::Silhouette
OuterBoundary(const itk::TriangleSurface & surface, const GeometryType * geometry)
{
  return itk::MeshSilhouette(surface).ComputeOuterBoundary(geometry->GetProjection());
}

/** An icosphere-like grid of latitudes and longitudes. */
itk::TriangleSurface
MakeSphere(const std::array<double, 3> & centre, double radius, unsigned int count)
{
  itk::TriangleSurface surface;
  for (unsigned int i = 0; i <= count; ++i)
  {
    for (unsigned int j = 0; j < 2 * count; ++j)
    {
      const double theta = itk::Math::pi * i / count;
      const double phi = itk::Math::pi * j / count;
      surface.points.push_back({ { centre[0] + radius * std::sin(theta) * std::cos(phi),
                                   centre[1] + radius * std::sin(theta) * std::sin(phi),
                                   centre[2] + radius * std::cos(theta) } });
    }
  }
  for (unsigned int i = 0; i < count; ++i)
  {
    for (unsigned int j = 0; j < 2 * count; ++j)
    {
      const std::uint32_t a = i * 2 * count + j;
      const std::uint32_t b = i * 2 * count + (j + 1) % (2 * count);
      const std::uint32_t c = a + 2 * count;
      const std::uint32_t d = b + 2 * count;
      surface.triangles.push_back({ { a, c, b } });
      surface.triangles.push_back({ { b, c, d } });
    }
  }
  return surface;
}

/** Distance of a point to a closed polygon. */
double
DistanceToLoop(double u, double v, const std::vector<std::array<double, 2>> & loop)
{
  double nearest = 1e300;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const auto & p = loop[i];
    const auto & q = loop[(i + 1) % loop.size()];
    const double du = q[0] - p[0];
    const double dv = q[1] - p[1];
    const double length = du * du + dv * dv;
    const double t = length > 0.0 ? std::clamp(((u - p[0]) * du + (v - p[1]) * dv) / length, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, std::hypot(u - p[0] - t * du, v - p[1] - t * dv));
  }
  return nearest;
}

bool
IsInside(double u, double v, const std::vector<std::array<double, 2>> & loop)
{
  bool inside = false;
  for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++)
  {
    if ((loop[i][1] > v) != (loop[j][1] > v) &&
        u < (loop[j][0] - loop[i][0]) * (v - loop[i][1]) / (loop[j][1] - loop[i][1]) + loop[i][0])
    {
      inside = !inside;
    }
  }
  return inside;
}

/** What VTK's camera sees: true where the surface covers the pixel's centre. */
MaskType
RenderWithVTK(const itk::TriangleSurface & surface, const GeometryType * geometry)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto & p : surface.points)
  {
    const auto c = geometry->TransformToCephalostat(GeometryType::PointType(p.data()));
    points->InsertNextPoint(c[0], c[1], c[2]);
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto & triangle : surface.triangles)
  {
    const vtkIdType ids[3] = { triangle[0], triangle[1], triangle[2] };
    triangles->InsertNextCell(3, ids);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(triangles);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(1.0, 1.0, 1.0);

  // The camera stands in the source and looks along the central ray. A camera can't mirror: where the picture does, the
  // mirrored one is taken.
  const bool   right = geometry->GetSourceSide() == GeometryType::SourceSideEnum::Right;
  const bool   mirrored = right != (geometry->GetFacing() == GeometryType::FacingEnum::Right);
  const double sourceY = (right ? -1.0 : 1.0) * geometry->GetSourceToMidsagittalDistance();
  const double principalU =
    mirrored ? Width - 1.0 - geometry->GetPrincipalPoint()[0] : geometry->GetPrincipalPoint()[0];
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.0, 0.0, 0.0);
  renderer->AddActor(actor);
  vtkCamera * camera = renderer->GetActiveCamera();
  camera->SetPosition(0.0, sourceY, 0.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(
    2.0 * std::atan(0.5 * Height * geometry->GetPixelSpacing()[1] / geometry->GetSourceToDetectorDistance()) * 180.0 /
    itk::Math::pi);
  // Where the central ray is off the picture's middle, in halves of the picture.
  camera->SetWindowCenter(1.0 - 2.0 * (principalU + 0.5) / Width,
                          2.0 * (geometry->GetPrincipalPoint()[1] + 0.5) / Height - 1.0);
  camera->SetClippingRange(1000.0, 2000.0);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(Width, Height);
  window->AddRenderer(renderer);
  window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, Width - 1, Height - 1, 0, pixels);
  MaskType mask(static_cast<std::size_t>(Width) * Height);
  for (int v = 0; v < Height; ++v)
  {
    for (int u = 0; u < Width; ++u)
    {
      // VTK's rows start below.
      const vtkIdType pixel = static_cast<vtkIdType>(Height - 1 - v) * Width + (mirrored ? Width - 1 - u : u);
      mask[static_cast<std::size_t>(v) * Width + u] = pixels->GetValue(3 * pixel) > 127;
    }
  }
  return mask;
}

class ProjectionPeer : public testing::TestWithParam<std::pair<GeometryType::SourceSideEnum, GeometryType::FacingEnum>>
{
protected:
  void
  SetUp() override
  {
    const char * display = std::getenv("DISPLAY");
    if (display == nullptr || *display == '\0')
    {
      GTEST_SKIP() << "VTK needs an X display: install xvfb, or run under xvfb-run";
    }
  }

  CaseType::Pointer
  MakeCase()
  {
    auto source = CaseType::New();
    source->SetSeed(5);
    source->SetSourceSide(GetParam().first);
    source->SetFacing(GetParam().second);
    source->MakeRadiographOff();
    source->Update();
    return source;
  }
};
} // namespace

TEST(Projection, SphereIsSeenAlongItsTangentRays)
{
  const std::array<double, 3> centre{ { 60.0, 25.0, -30.0 } };
  const double                radius = 20.0;
  for (const auto side : { GeometryType::SourceSideEnum::Right, GeometryType::SourceSideEnum::Left })
  {
    for (const auto facing : { GeometryType::FacingEnum::Right, GeometryType::FacingEnum::Left })
    {
      const auto geometry = MakeGeometry(side, facing);
      const auto silhouette = OuterBoundary(MakeSphere(centre, radius, 200), geometry);
      ASSERT_EQ(silhouette.loops.size(), 1u);
      for (const auto & point : silhouette.loops.front().points)
      {
        // The source is written down anew here: nothing of the geometry class but its numbers.
        const double k = side == GeometryType::SourceSideEnum::Right ? 1.0 : -1.0;
        const double f = facing == GeometryType::FacingEnum::Right ? 1.0 : -1.0;
        const double direction[3] = { f * (point[0] - 301.3) * 0.25, k * 1674.0, -(point[1] - 455.8) * 0.25 };
        const double toCentre[3] = { centre[0], centre[1] + k * 1524.0, centre[2] };
        double       along = 0.0;
        double       length = 0.0;
        double       squares = 0.0;
        for (unsigned int d = 0; d < 3; ++d)
        {
          along += direction[d] * toCentre[d];
          length += direction[d] * direction[d];
          squares += toCentre[d] * toCentre[d];
        }
        const double distance = std::sqrt(squares - along * along / length);
        // Chords of a circle in 400 parts lie within r (1 - cos(pi / 400)) = 0.6 um; seen obliquely a few times that.
        EXPECT_NEAR(distance, radius, 0.005);
      }
    }
  }
}

TEST(Projection, BoxIsTheConvexHullOfItsCorners)
{
  const auto           geometry = MakeGeometry(GeometryType::SourceSideEnum::Right, GeometryType::FacingEnum::Right);
  itk::TriangleSurface surface;
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    surface.points.push_back(
      { { (corner & 1u) != 0 ? 70.0 : 30.0, (corner & 2u) != 0 ? 28.0 : -28.0, (corner & 4u) != 0 ? -20.0 : -45.0 } });
  }
  surface.triangles = { { { 0, 2, 1 } }, { { 1, 2, 3 } }, { { 4, 5, 6 } }, { { 5, 7, 6 } },
                        { { 0, 1, 4 } }, { { 1, 5, 4 } }, { { 2, 6, 3 } }, { { 3, 6, 7 } },
                        { { 0, 4, 2 } }, { { 2, 4, 6 } }, { { 1, 3, 5 } }, { { 3, 7, 5 } } };
  const auto silhouette = OuterBoundary(surface, geometry);
  ASSERT_EQ(silhouette.loops.size(), 1u);
  // Right of and below the central ray the near face reaches farther out, the far face farther in.
  const double near = 1674.0 / (1524.0 - 28.0) / 0.25;
  const double far = 1674.0 / (1524.0 + 28.0) / 0.25;
  const double expected[6][2] = {
    { 301.3 + 30.0 * far, 455.8 + 20.0 * far },   { 301.3 + 70.0 * far, 455.8 + 20.0 * far },
    { 301.3 + 70.0 * near, 455.8 + 20.0 * near }, { 301.3 + 70.0 * near, 455.8 + 45.0 * near },
    { 301.3 + 30.0 * near, 455.8 + 45.0 * near }, { 301.3 + 30.0 * far, 455.8 + 45.0 * far }
  };
  double twice = 0.0;
  for (unsigned int i = 0; i < 6; ++i)
  {
    const auto & p = expected[i];
    const auto & q = expected[(i + 1) % 6];
    twice += (p[0] - 301.3) * (q[1] - 455.8) - (p[1] - 455.8) * (q[0] - 301.3);
    // The silhouette is exact but for its grid of 2^-12 px.
    EXPECT_LT(DistanceToLoop(p[0], p[1], silhouette.loops.front().points), 1e-3);
  }
  EXPECT_NEAR(silhouette.loops.front().Area(), 0.5 * twice, 1.0);
}

TEST_P(ProjectionPeer, SilhouetteIsWhatVTKsCameraCovers)
{
  const auto source = MakeCase();
  for (const unsigned int jaw : { 0u, 1u })
  {
    const auto * geometry = source->GetTrueGeometry(jaw);
    const auto   surface = itk::MakeTriangleSurface(source->GetMesh(jaw));
    const auto   mask = RenderWithVTK(surface, geometry);
    const auto   silhouette = OuterBoundary(surface, geometry);
    ASSERT_FALSE(silhouette.loops.empty());
    const auto & loop = silhouette.loops.front().points;
    std::size_t  covered = 0;
    for (int v = 0; v < Height; ++v)
    {
      for (int u = 0; u < Width; ++u)
      {
        const bool inside = IsInside(u, v, loop);
        covered += inside ? 1 : 0;
        if (inside != mask[static_cast<std::size_t>(v) * Width + u])
        {
          // VTK computes in single precision and rasterises centres: a difference lies on the border.
          EXPECT_LT(DistanceToLoop(u, v, loop), 0.05) << "at " << u << ", " << v;
        }
      }
    }
    EXPECT_GT(covered, 5000u);
  }
}

TEST_P(ProjectionPeer, DRRIsDenseWhereVTKsCameraSeesTheSurface)
{
  const auto source = MakeCase();
  for (const unsigned int jaw : { 0u, 1u })
  {
    auto *     geometry = source->GetTrueGeometry(jaw);
    const auto mask = RenderWithVTK(itk::MakeTriangleSurface(source->GetMesh(jaw)), geometry);
    using DRRType = itk::SurfaceDRRImageSource<CaseType::MeshType, itk::Image<float, 2>>;
    auto drr = DRRType::New();
    drr->SetInput(source->GetMesh(jaw));
    drr->SetGeometry(geometry);
    drr->SetSigma(0.25);
    DRRType::OutputImageType::SizeType size;
    size[0] = Width;
    size[1] = Height;
    drr->SetSize(size);
    drr->Update();
    const float * thickness = drr->GetOutput()->GetBufferPointer();
    std::size_t   different = 0;
    std::size_t   far = 0;
    for (int v = 3; v < Height - 3; ++v)
    {
      for (int u = 3; u < Width - 3; ++u)
      {
        const std::size_t pixel = static_cast<std::size_t>(v) * Width + u;
        if ((thickness[pixel] > 0.5F) == mask[pixel])
        {
          continue;
        }
        ++different;
        bool isBorder = false;
        for (int dv = -3; dv <= 3; ++dv)
        {
          for (int du = -3; du <= 3; ++du)
          {
            isBorder = isBorder || mask[pixel + dv * Width + du] != mask[pixel];
          }
        }
        far += isBorder ? 0 : 1;
      }
    }
    const auto covered = static_cast<std::size_t>(std::count(mask.begin(), mask.end(), true));
    EXPECT_GT(covered, 5000u);
    EXPECT_EQ(far, 0u);
    // A splat of one pixel moves the border outward by about as much.
    const auto loop = OuterBoundary(itk::MakeTriangleSurface(source->GetMesh(jaw)), geometry).loops.front().points;
    double     perimeter = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const auto & q = loop[(i + 1) % loop.size()];
      perimeter += std::hypot(q[0] - loop[i][0], q[1] - loop[i][1]);
    }
    EXPECT_LT(static_cast<double>(different), 1.5 * perimeter);
  }
}

INSTANTIATE_TEST_SUITE_P(
  SidesAndFacings,
  ProjectionPeer,
  testing::Values(std::make_pair(GeometryType::SourceSideEnum::Right, GeometryType::FacingEnum::Right),
                  std::make_pair(GeometryType::SourceSideEnum::Right, GeometryType::FacingEnum::Left),
                  std::make_pair(GeometryType::SourceSideEnum::Left, GeometryType::FacingEnum::Right),
                  std::make_pair(GeometryType::SourceSideEnum::Left, GeometryType::FacingEnum::Left)));

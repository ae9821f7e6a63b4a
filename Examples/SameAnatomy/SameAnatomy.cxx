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
// The same anatomy on both sides of the metric: one side, its crowns, the part of the outline that a tracing can lie
// on. Draws the pictures of Documentation/CrownRegion.md and Contours.md: SameAnatomy FOLDER [TRIANGLES].
#include "itkCrownRegionMeshFilter.h"
#include "itkDentalPhantomMeshSource.h"
#include "itkMakeTriangleSurface.h"
#include "itkMeshSilhouetteContourSource.h"
#include "itkMidlineSideMeshFilter.h"
#include "itkOpenSilhouetteContourSource.h"
#include "itkUMidlineDentalAxisFilter.h"

#include "itkImage.h"
#include "itkImageFileWriter.h"
#include "itkPNGImageIO.h"
#include "itkRGBPixel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <numeric>
#include <string>
#include <vector>

namespace
{
using MeshType = itk::Mesh<float, 3>;
using Colour = std::array<double, 3>;
using Mask = std::vector<std::uint8_t>;

constexpr Colour Tooth{ { 0.93, 0.90, 0.82 } };
constexpr Colour Gingiva{ { 0.85, 0.58, 0.56 } };
constexpr Colour Taken{ { 0.95, 0.55, 0.10 } };
constexpr Colour Missed{ { 0.20, 0.40, 0.85 } };
constexpr Colour Other{ { 0.45, 0.47, 0.50 } };
constexpr Colour Outline{ { 0.05, 0.45, 0.75 } };

/** A picture with a depth buffer, drawn at twice its size. */
class Canvas
{
public:
  static constexpr unsigned int Scale = 2;

  Canvas(unsigned int width, unsigned int height)
    : m_Width(width * Scale)
    , m_Height(height * Scale)
    , m_Pixels(static_cast<std::size_t>(m_Width) * m_Height, Colour{ { 1.0, 1.0, 1.0 } })
    , m_Depth(m_Pixels.size(), -1e30)
  {}

  /** Corners in pixels with their depth, nearer is larger. */
  void
  Triangle(std::array<std::array<double, 3>, 3> c, const Colour & colour)
  {
    for (auto & p : c)
    {
      p[0] *= Scale;
      p[1] *= Scale;
    }
    const double area = (c[1][0] - c[0][0]) * (c[2][1] - c[0][1]) - (c[1][1] - c[0][1]) * (c[2][0] - c[0][0]);
    if (std::abs(area) < 1e-12)
    {
      return;
    }
    const auto range = [](double a, double b, double d, unsigned int size) {
      return std::make_pair(std::max(0, static_cast<int>(std::floor(std::min({ a, b, d })))),
                            std::min(static_cast<int>(size) - 1, static_cast<int>(std::ceil(std::max({ a, b, d })))));
    };
    const auto xs = range(c[0][0], c[1][0], c[2][0], m_Width);
    const auto ys = range(c[0][1], c[1][1], c[2][1], m_Height);
    for (int y = ys.first; y <= ys.second; ++y)
    {
      for (int x = xs.first; x <= xs.second; ++x)
      {
        double w[3];
        double depth = 0.0;
        bool   inside = true;
        for (unsigned int k = 0; k < 3; ++k)
        {
          const auto & p = c[(k + 1) % 3];
          const auto & q = c[(k + 2) % 3];
          w[k] = ((q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0])) / area;
          inside = inside && w[k] >= 0.0;
          depth += w[k] * c[k][2];
        }
        const std::size_t at = static_cast<std::size_t>(y) * m_Width + static_cast<std::size_t>(x);
        if (inside && depth > m_Depth[at])
        {
          m_Depth[at] = depth;
          m_Pixels[at] = colour;
        }
      }
    }
  }

  /** Over everything. */
  void
  Line(double x0, double y0, double x1, double y1, double width, const Colour & colour)
  {
    const double radius = 0.5 * width * Scale;
    const double length = Scale * std::hypot(x1 - x0, y1 - y0);
    const int    steps = static_cast<int>(length * 2.0) + 1;
    for (int s = 0; s <= steps; ++s)
    {
      const double cx = Scale * (x0 + (x1 - x0) * s / steps);
      const double cy = Scale * (y0 + (y1 - y0) * s / steps);
      for (int y = static_cast<int>(cy - radius); y <= static_cast<int>(cy + radius) + 1; ++y)
      {
        for (int x = static_cast<int>(cx - radius); x <= static_cast<int>(cx + radius) + 1; ++x)
        {
          if (x >= 0 && y >= 0 && x < static_cast<int>(m_Width) && y < static_cast<int>(m_Height) &&
              std::hypot(x - cx, y - cy) <= radius)
          {
            m_Pixels[static_cast<std::size_t>(y) * m_Width + static_cast<std::size_t>(x)] = colour;
          }
        }
      }
    }
  }

  void
  Write(const std::string & fileName) const
  {
    using ImageType = itk::Image<itk::RGBPixel<unsigned char>, 2>;
    auto                  image = ImageType::New();
    ImageType::RegionType region;
    region.SetSize(0, m_Width / Scale);
    region.SetSize(1, m_Height / Scale);
    image->SetRegions(region);
    image->Allocate();
    for (unsigned int y = 0; y < m_Height / Scale; ++y)
    {
      for (unsigned int x = 0; x < m_Width / Scale; ++x)
      {
        Colour sum{};
        for (unsigned int i = 0; i < Scale * Scale; ++i)
        {
          const std::size_t at = static_cast<std::size_t>(y * Scale + i / Scale) * m_Width + x * Scale + i % Scale;
          for (unsigned int d = 0; d < 3; ++d)
          {
            sum[d] += m_Pixels[at][d] / (Scale * Scale);
          }
        }
        ImageType::PixelType pixel;
        for (unsigned int d = 0; d < 3; ++d)
        {
          pixel[d] = static_cast<unsigned char>(std::clamp(255.0 * sum[d] + 0.5, 0.0, 255.0));
        }
        image->SetPixel({ { static_cast<itk::IndexValueType>(x), static_cast<itk::IndexValueType>(y) } }, pixel);
      }
    }
    auto io = itk::PNGImageIO::New();
    io->SetCompressionLevel(9);
    auto writer = itk::ImageFileWriter<ImageType>::New();
    writer->SetImageIO(io);
    writer->UseCompressionOn();
    writer->SetFileName(fileName);
    writer->SetInput(image);
    writer->Update();
    std::cout << fileName << std::endl;
  }

private:
  unsigned int        m_Width;
  unsigned int        m_Height;
  std::vector<Colour> m_Pixels;
  std::vector<double> m_Depth;
};

/** Draws a surface: a point to (x, y, depth), light from where the eye is. */
void
Draw(Canvas &                                                                    canvas,
     const itk::TriangleSurface &                                                surface,
     const std::function<std::array<double, 3>(const std::array<double, 3> &)> & project,
     const std::array<double, 3> &                                               eye,
     const std::function<Colour(std::size_t)> &                                  colourOf)
{
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const auto & corner = surface.triangles[t];
    const auto   n = surface.AreaNormal(t);
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    const double light = length > 0.0 ? std::abs(n[0] * eye[0] + n[1] * eye[1] + n[2] * eye[2]) / length : 0.0;
    Colour       colour = colourOf(t);
    for (double & value : colour)
    {
      value *= 0.35 + 0.65 * light;
    }
    canvas.Triangle({ { project(surface.points[corner[0]]),
                        project(surface.points[corner[1]]),
                        project(surface.points[corner[2]]) } },
                    colour);
  }
}

/** The occlusal view of a jaw, anterior up, patient's right on the left. */
std::function<std::array<double, 3>(const std::array<double, 3> &)>
OcclusalView(unsigned int jaw, double left)
{
  return [jaw, left](const std::array<double, 3> & p) {
    return std::array<double, 3>{ { left + 5.5 * p[1] + 230.0, 320.0 - 5.5 * p[0], jaw == 0 ? -p[2] : p[2] } };
  };
}
} // namespace

int
main(int argc, char * argv[])
{
  const std::string folder = argc > 1 ? std::string(argv[1]) + '/' : "./";
  try
  {
    itk::DentalPhantomParameters parameters = itk::DentalPhantomParameters::Draw(7);
    parameters.frame = itk::DentalPhantomParameters::FrameEnum::Anatomical;
    parameters.numberOfTriangles = argc > 2 ? static_cast<std::uint32_t>(std::stoul(argv[2])) : 120000;
    parameters.stoneBase = true;
    parameters.jaws[1].teeth[4].missing = true;
    auto phantom = itk::DentalPhantomMeshSource<MeshType>::New();
    phantom->SetParameters(parameters);

    using JawEnum = itk::ToothCode::JawEnum;
    auto frame = itk::UMidlineDentalAxisFilter<MeshType>::New();
    frame->SetUpperMesh(phantom->GetUpperOutput());
    frame->SetLowerMesh(phantom->GetLowerOutput());
    frame->RefineMidlineOn();

    // The same without a base for the outline: of a base, the front would stay as well.
    parameters.stoneBase = false;
    auto scan = itk::DentalPhantomMeshSource<MeshType>::New();
    scan->SetParameters(parameters);
    auto scanFrame = itk::UMidlineDentalAxisFilter<MeshType>::New();
    scanFrame->SetUpperMesh(scan->GetUpperOutput());
    scanFrame->SetLowerMesh(scan->GetLowerOutput());
    scanFrame->RefineMidlineOn();

    // Lateral radiograph of a head that is turned up by 8 degrees.
    auto                                         geometry = itk::CephalometricGeometry::New();
    itk::CephalometricGeometry::PixelSpacingType spacing;
    spacing.Fill(0.11);
    geometry->SetPixelSpacing(spacing);
    itk::CephalometricGeometry::PixelIndexType principal;
    principal[0] = 170.0;
    principal[1] = 205.0;
    geometry->SetPrincipalPoint(principal);
    itk::CephalometricGeometry::RotationType pitch;
    pitch.SetIdentity();
    pitch(0, 0) = pitch(2, 2) = std::cos(0.14);
    pitch(0, 2) = std::sin(0.14);
    pitch(2, 0) = -std::sin(0.14);
    itk::CephalometricGeometry::VectorType none;
    none.Fill(0.0);
    geometry->SetPose(pitch, none);

    Canvas sides(920, 400);
    Canvas regions(920, 400);
    Canvas outline(700, 430);
    for (const unsigned int jaw : { 0u, 1u })
    {
      MeshType * mesh = jaw == 0 ? phantom->GetUpperOutput() : phantom->GetLowerOutput();
      auto *     transform = jaw == 0 ? frame->GetUpperTransformOutput() : frame->GetLowerTransformOutput();

      auto side = itk::MidlineSideMeshFilter<MeshType>::New();
      side->SetInput(mesh);
      side->SetFrameTransformInput(transform);
      side->SetSide(itk::MidlineSideMeshFilterEnums::Side::Right);

      using CrownType = itk::CrownRegionMeshFilter<MeshType>;
      auto byShape = CrownType::New();
      auto byLabels = CrownType::New();
      for (auto & crowns : { byShape, byLabels })
      {
        crowns->SetInput(mesh);
        crowns->SetJaw(jaw == 0 ? JawEnum::Upper : JawEnum::Lower);
        crowns->SetFrameTransformInput(transform);
      }
      byShape->UseLabelsOff();
      byShape->Update();
      byLabels->Update();
      side->Update();

      const itk::TriangleSurface surface = itk::MakeTriangleSurface<MeshType>(mesh);
      const Mask                 kept = side->GetTriangleMask();
      const Mask                 found = byShape->GetTriangleMask();
      const Mask                 truth = byLabels->GetTriangleMask();
      const std::string          name = jaw == 0 ? "upper" : "lower";
      const auto                 count = static_cast<double>(kept.size());
      std::cout << name << " share of the right side: " << std::count(kept.begin(), kept.end(), 1) / count << '\n';
      std::cout << name << " crowns as labelled: "
                << std::inner_product(found.begin(),
                                      found.end(),
                                      truth.begin(),
                                      0.0,
                                      std::plus<double>(),
                                      [](auto a, auto b) { return a == b ? 1.0 : 0.0; }) /
                     count
                << '\n';
      const double                left = 460.0 * jaw;
      const std::array<double, 3> up{ { 0.0, 0.0, 1.0 } };
      const auto                  shade = [&](std::size_t t) { return truth[t] != 0 ? Tooth : Gingiva; };
      Draw(sides, surface, OcclusalView(jaw, left), up, [&](std::size_t t) { return kept[t] != 0 ? shade(t) : Other; });
      Draw(regions, surface, OcclusalView(jaw, left), up, [&](std::size_t t) {
        return found[t] == truth[t] ? shade(t) : found[t] != 0 ? Taken : Missed;
      });

      MeshType * scanned = jaw == 0 ? scan->GetUpperOutput() : scan->GetLowerOutput();
      auto *     scanTransform = jaw == 0 ? scanFrame->GetUpperTransformOutput() : scanFrame->GetLowerTransformOutput();
      auto       scanSide = itk::MidlineSideMeshFilter<MeshType>::New();
      scanSide->SetInput(scanned);
      scanSide->SetFrameTransformInput(scanTransform);
      auto open = itk::OpenSilhouetteContourSource<MeshType>::New();
      open->SetInput(scanSide->GetOutput());
      open->SetFrameTransformInput(scanTransform);
      open->SetJaw(jaw == 0 ? itk::ToothCode::JawEnum::Upper : itk::ToothCode::JawEnum::Lower);
      open->SetGeometry(geometry);
      open->Update();
      std::cout << name << " open outline px: " << open->GetOutput()->GetLength() << '\n';
      auto closed = itk::MeshSilhouetteContourSource<MeshType>::New();
      closed->SetInput(scanSide->GetOutput());
      closed->SetGeometry(geometry);
      closed->Update();

      // The side as the X-rays see it, from the patient's right.
      const auto project = [&](const std::array<double, 3> & p) {
        const auto index = geometry->ProjectPoint(itk::CephalometricGeometry::PointType(p.data()));
        return std::array<double, 3>{ { index[0], index[1], -p[1] } };
      };
      const itk::TriangleSurface half = itk::MakeTriangleSurface<MeshType>(scanSide->GetOutput());
      const auto *               labels = scanSide->GetOutput()->GetPointData();
      Draw(outline, half, project, { { 0.0, 1.0, 0.0 } }, [&](std::size_t t) {
        return labels->ElementAt(half.triangles[t][0]) != 0.0f ? Tooth : Gingiva;
      });
      for (const auto & polyline : closed->GetOutput()->GetPolylines())
      {
        for (std::size_t i = 0; i < polyline.points.size(); ++i)
        {
          const auto & a = polyline.points[i];
          const auto & b = polyline.points[(i + 1) % polyline.points.size()];
          outline.Line(a[0], a[1], b[0], b[1], 1.0, Other);
        }
      }
      std::size_t rim = 0;
      for (const auto & polyline : open->GetOutput()->GetPolylines())
      {
        for (std::size_t i = 0; i < polyline.points.size(); ++i, ++rim)
        {
          const auto & a = polyline.points[i];
          const auto & b = polyline.points[std::min(i + 1, polyline.points.size() - 1)];
          outline.Line(a[0], a[1], b[0], b[1], 3.0, Outline);
          if (i % 24 == 12)
          {
            const auto & n = open->GetNormals()[rim];
            outline.Line(a[0], a[1], a[0] + 10.0 * n[0], a[1] + 10.0 * n[1], 1.0, Outline);
          }
        }
      }
    }
    sides.Write(folder + "midline-side.png");
    regions.Write(folder + "crown-region.png");
    outline.Write(folder + "open-silhouette.png");
  }
  catch (const std::exception & error)
  {
    std::cerr << error.what() << std::endl;
    return 1;
  }
  return 0;
}

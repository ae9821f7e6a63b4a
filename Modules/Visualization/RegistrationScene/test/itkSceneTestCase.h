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
#ifndef itkSceneTestCase_h
#define itkSceneTestCase_h

#include "itkCephalometricGeometry.h"
#include "itkRegistrationSceneSource.h"

#include "itkTriangleCell.h"

#include <array>

/** A scene that can be computed by hand: two boxes for scans, a lateral and a frontal radiograph. */
namespace SceneTestCase
{
using MeshType = itk::ScenePart::MeshType;
using JawEnum = itk::ToothCode::JawEnum;

constexpr double SourceToDetector = 1674.0;
constexpr double SourceToMiddle = 1524.0;
constexpr double Spacing = 0.25;

/** A closed box about its file's origin. */
inline MeshType::Pointer
MakeBox(double x, double y, double z)
{
  auto mesh = MeshType::New();
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    MeshType::PointType point;
    point[0] = static_cast<float>((corner & 1U) != 0 ? x : -x);
    point[1] = static_cast<float>((corner & 2U) != 0 ? y : -y);
    point[2] = static_cast<float>((corner & 4U) != 0 ? z : -z);
    mesh->SetPoint(corner, point);
  }
  const unsigned int triangles[12][3] = {
    { 0, 2, 1 }, { 1, 2, 3 }, { 4, 5, 6 }, { 5, 7, 6 }, { 0, 1, 4 }, { 1, 5, 4 },
    { 2, 6, 3 }, { 3, 6, 7 }, { 0, 4, 2 }, { 2, 4, 6 }, { 1, 3, 5 }, { 3, 7, 5 }
  };
  for (unsigned int i = 0; i < 12; ++i)
  {
    MeshType::CellAutoPointer cell;
    cell.TakeOwnership(new itk::TriangleCell<MeshType::CellType>);
    for (int corner = 0; corner < 3; ++corner)
    {
      cell->SetPointId(corner, triangles[i][corner]);
    }
    mesh->SetCell(i, cell);
  }
  return mesh;
}

/** A shift. */
inline std::array<double, 12>
MakeShift(double x, double y, double z)
{
  return { { 1.0, 0.0, 0.0, x, 0.0, 1.0, 0.0, y, 0.0, 0.0, 1.0, z } };
}

/** Source on the patient's right, who faces right in the picture; the scale is a factor on the image. */
inline itk::SceneView
MakeLateralView(double scale = 1.0)
{
  auto                                         geometry = itk::CephalometricGeometry::New();
  itk::CephalometricGeometry::PixelSpacingType spacing;
  spacing.Fill(Spacing / scale);
  geometry->SetPixelSpacing(spacing);
  itk::CephalometricGeometry::PixelIndexType principal;
  principal.Fill(200.0);
  geometry->SetPrincipalPoint(principal);
  itk::SceneView view;
  view.name = "lateral";
  view.projection = geometry->GetProjection().matrix;
  view.sourceToDetector = SourceToDetector;
  view.imageSize = { { 700, 500 } };
  return view;
}

/** Source behind the patient, whose left is on the picture's right. */
inline itk::SceneView
MakeFrontalView()
{
  constexpr double focus = SourceToDetector / Spacing;
  itk::SceneView   view;
  view.name = "frontal";
  view.projection = { { 300.0,
                        focus,
                        0.0,
                        300.0 * SourceToMiddle,
                        200.0,
                        0.0,
                        -focus,
                        200.0 * SourceToMiddle,
                        1.0,
                        0.0,
                        0.0,
                        SourceToMiddle } };
  view.sourceToDetector = SourceToDetector;
  view.imageSize = { { 600, 500 } };
  return view;
}

inline itk::DentalContour::Pointer
MakeTracing()
{
  auto                                       tracing = itk::DentalContour::New();
  std::vector<itk::DentalContour::PointType> points(3);
  for (unsigned int i = 0; i < 3; ++i)
  {
    points[i][0] = 400.0 + 20.0 * i;
    points[i][1] = 380.0 + 5.0 * i;
  }
  tracing->AddPolyline(points, itk::ToothCode(11));
  points.pop_back();
  tracing->AddPolyline(points, itk::ToothCode(12));
  return tracing;
}

/** 7 pixels high and 5 wide, brighter by row and column. */
inline itk::SceneView::ImageType::Pointer
MakeRadiograph(unsigned int width, unsigned int height)
{
  auto image = itk::SceneView::ImageType::New();
  image->SetRegions(itk::SceneView::ImageType::SizeType{ { width, height } });
  image->Allocate();
  for (unsigned int v = 0; v < height; ++v)
  {
    for (unsigned int u = 0; u < width; ++u)
    {
      image->SetPixel({ { static_cast<itk::IndexValueType>(u), static_cast<itk::IndexValueType>(v) } },
                      static_cast<float>(10 * v + u));
    }
  }
  return image;
}

/** An upper box 60 mm before the ears, traced and with a landmark, in both views; a lower box below it. */
inline itk::RegistrationSceneSource::Pointer
MakeScene(bool frontalToo = true)
{
  auto source = itk::RegistrationSceneSource::New();
  source->SetScan(JawEnum::Upper, MakeBox(20.0, 25.0, 8.0), MakeShift(60.0, 1.0, -40.0), MakeShift(0.0, 0.0, 2.0));
  source->SetScan(JawEnum::Lower, MakeBox(18.0, 22.0, 7.0), MakeShift(58.0, 1.0, -58.0), MakeShift(0.0, 0.0, 0.0));
  auto lateral = MakeLateralView();
  lateral.radiograph = MakeRadiograph(700, 500).GetPointer();
  lateral.jaws[JawEnum::Upper].tracing = MakeTracing().GetPointer();
  itk::SceneLandmark landmark;
  landmark.name = "UR1_tip";
  landmark.point[0] = 80.0;
  landmark.point[1] = -3.0;
  landmark.point[2] = -48.0;
  const auto pixel = itk::SceneDetector(lateral.projection, lateral.sourceToDetector).GetPixel(landmark.point);
  landmark.pixel = { { pixel[0], pixel[1] } };
  lateral.jaws[JawEnum::Upper].landmarks.push_back(landmark);
  source->AddView(lateral);
  if (frontalToo)
  {
    source->AddView(MakeFrontalView());
  }
  return source;
}
} // namespace SceneTestCase

#endif

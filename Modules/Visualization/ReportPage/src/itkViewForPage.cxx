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
#include "itkViewForPage.h"

#include "itkJsonMember.h"
#include "itkMillimetresPerUnit.h"
#include "itkPlaceByProjection.h"
#include "itkProjectionRows.h"
#include "itkSceneDetector.h"
#include "itkShrunkImage.h"
#include "itkSurfaceDRRImageSource.h"
#include "itkSurfaceSplatWidthCalculator.h"

#include <cmath>
#include <vector>

namespace itk
{
namespace
{
using Json = nlohmann::ordered_json;
using RowsType = std::array<double, 12>;

RowsType
ReadRows(const Json & json)
{
  RowsType rows;
  for (std::size_t i = 0; i < 12; ++i)
  {
    rows[i] = json.at(i / 4).at(i % 4).get<double>();
  }
  return rows;
}

Json
ToJson(const SceneDetector::PointType & point)
{
  // Hundredths of a millimetre: what is drawn by it is no finer.
  Json list = Json::array();
  for (const double x : point)
  {
    list.push_back(std::round(100.0 * x) / 100.0);
  }
  return list;
}
} // namespace

ViewForPage::ViewForPage(const Json & result, const Json & own, const Json & view)
{
  const double unit = MillimetresPerUnitFromString(result.value("mesh_unit", "mm"));
  for (const auto & entry : JsonMember(own, "jaws").items())
  {
    // Where the first view has put it: its scan is given there.
    const Json & placed = JsonMember(JsonMember(result, "jaws"), entry.key());
    if (entry.value().contains("projection_3x4") && placed.contains("mesh_to_cephalostat_mm"))
    {
      const RowsType projection = TimesRigidInverse(ScaleColumns(ReadRows(entry.value()["projection_3x4"]), 1.0 / unit),
                                                    ReadRows(placed["mesh_to_cephalostat_mm"]));
      // A parallel projection comes from nowhere.
      if (std::hypot(projection[8], projection[9], projection[10]) > 0.0)
      {
        m_Projections[entry.key()] = projection;
      }
    }
  }
  const Json & distance = JsonMember(JsonMember(JsonMember(own, "geometry"), "source_to_detector_mm"), "value");
  const Json & size = JsonMember(view, "image_size");
  if (!distance.is_number() || size.size() != 2 || size.at(0).get<std::size_t>() == 0 ||
      size.at(1).get<std::size_t>() == 0)
  {
    m_Projections.clear();
    return;
  }
  m_SourceToDetector = distance.get<double>();
  m_Size = { { size.at(0).get<std::size_t>(), size.at(1).get<std::size_t>() } };
}

Json
ViewForPage::GetSpace() const
{
  if (m_Projections.empty())
  {
    return {};
  }
  const double                                       right = static_cast<double>(m_Size[0]) - 0.5;
  const double                                       bottom = static_cast<double>(m_Size[1]) - 0.5;
  std::vector<std::vector<SceneDetector::PointType>> places;
  for (const auto & entry : m_Projections)
  {
    const SceneDetector detector(entry.second, m_SourceToDetector);
    places.push_back({ detector.GetSource(),
                       detector.GetCentralPoint(),
                       detector.GetPoint(-0.5, -0.5),
                       detector.GetPoint(right, -0.5),
                       detector.GetPoint(right, bottom),
                       detector.GetPoint(-0.5, bottom) });
  }
  Json mean = Json::array();
  for (std::size_t i = 0; i < places.front().size(); ++i)
  {
    SceneDetector::PointType point;
    point.Fill(0.0);
    for (const auto & own : places)
    {
      point += own[i].GetVectorFromOrigin() / static_cast<double>(places.size());
    }
    mean.push_back(ToJson(point));
  }
  return { { "source", mean[0] }, { "centre", mean[1] }, { "corners", { mean[2], mean[3], mean[4], mean[5] } } };
}

RadiographForPage
ViewForPage::MakeDRR(const ScansType & scans, unsigned int maximumSide) const
{
  using ImageType = Image<float, 2>;
  using SourceType = SurfaceDRRImageSource<MeshType, ImageType>;
  const std::size_t    factor = ShrunkImage::FindFactor(m_Size[0], m_Size[1], maximumSide);
  SourceType::SizeType size{ { (m_Size[0] + factor - 1) / factor, (m_Size[1] + factor - 1) / factor } };
  ImageType::Pointer   shells;
  float                attenuation = 0.0F;
  for (const auto & entry : m_Projections)
  {
    const auto scan = scans.find(entry.first);
    if (scan == scans.end() || scan->second == nullptr || scan->second->GetNumberOfCells() == 0)
    {
      continue;
    }
    // A pipeline of its own: views are rendered by several threads, and a filter writes into its input which part of it
    // it asks for.
    auto mesh = MeshType::New();
    mesh->Graft(scan->second);
    auto geometry = CephalometricGeometry::New();
    geometry->SetSourceToDetectorDistance(m_SourceToDetector);
    // Any plane between source and detector: the projection has the depth.
    geometry->SetSourceToMidsagittalDistance(0.9 * m_SourceToDetector);
    PlaceByProjection(entry.second, geometry);
    auto width = SurfaceSplatWidthCalculator::New();
    width->SetMesh(mesh);
    width->SetGeometry(geometry);
    width->Update();
    const auto & pixel = geometry->GetPixelSpacing();
    // Splats narrower than a pixel of the picture would flicker from one to the next.
    const double widest = static_cast<double>(factor) * 0.5 * (pixel[0] + pixel[1]);
    auto         source = SourceType::New();
    source->SetInput(mesh);
    source->SetGeometry(geometry);
    source->SetSigma(std::max(width->GetSigma(), widest));
    source->UseGeometrySpacingOff();
    SourceType::SpacingType spacing;
    SourceType::PointType   origin;
    for (unsigned int d = 0; d < 2; ++d)
    {
      spacing[d] = static_cast<double>(factor) * pixel[d];
      origin[d] = 0.5 * (static_cast<double>(factor) - 1.0) * pixel[d];
    }
    source->SetSpacing(spacing);
    source->SetOrigin(origin);
    source->SetSize(size);
    source->SetNumberOfWorkUnits(1);
    source->Update();
    attenuation = static_cast<float>(source->GetAttenuation());
    if (shells.IsNull())
    {
      shells = source->GetOutput();
      shells->DisconnectPipeline();
      continue;
    }
    const float * more = source->GetOutput()->GetBufferPointer();
    float *       sum = shells->GetBufferPointer();
    for (std::size_t i = 0; i < size[0] * size[1]; ++i)
    {
      sum[i] += more[i];
    }
  }
  if (shells.IsNull())
  {
    return {};
  }
  // Beer-Lambert on the sum of both jaws' shells.
  float * const     pixels = shells->GetBufferPointer();
  const std::size_t count = size[0] * size[1];
  for (std::size_t i = 0; i < count; ++i)
  {
    pixels[i] *= -attenuation;
  }
  SurfaceSplatExp(pixels, count);
  for (std::size_t i = 0; i < count; ++i)
  {
    pixels[i] = 1.0F - pixels[i];
  }
  RadiographForPage picture = MakeRadiographForPage(shells, maximumSide);
  picture.width *= factor;
  picture.height *= factor;
  return picture;
}
} // namespace itk

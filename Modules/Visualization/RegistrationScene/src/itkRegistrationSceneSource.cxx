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
#include "itkRegistrationSceneSource.h"

#include "itkGreyWindow.h"
#include "itkMakeTriangleSurface.h"
#include "itkMeshSilhouette.h"
#include "itkProjectionRows.h"
#include "itkShrunkImage.h"

#include "itkLineCell.h"
#include "itkTriangleCell.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

namespace itk
{
namespace
{
using JawEnum = ToothCode::JawEnum;
using MeshType = ScenePart::MeshType;
using PointType = SceneDetector::PointType;
using VectorType = SceneDetector::VectorType;
using PlacementType = RegistrationSceneSource::PlacementType;
using ColorType = std::array<double, 3>;

/** Colours that the colour-blind tell apart (Okabe and Ito); drawn lines have those that overlays have. */
constexpr ColorType UpperScanColor{ { 0.93, 0.90, 0.82 } };
constexpr ColorType LowerScanColor{ { 0.80, 0.86, 0.92 } };
constexpr ColorType TracingColor{ { 0.34, 0.71, 0.91 } };
constexpr ColorType SilhouetteColor{ { 0.90, 0.62, 0.00 } };
constexpr ColorType SourceColor{ { 0.94, 0.89, 0.26 } };
constexpr ColorType RayColor{ { 0.80, 0.47, 0.65 } };
constexpr ColorType DetectorColor{ { 1.0, 1.0, 1.0 } };
constexpr ColorType AxisColors[] = { { { 0.84, 0.37, 0.00 } }, { { 0.00, 0.62, 0.45 } }, { { 0.00, 0.45, 0.70 } } };

constexpr double AxisLength = 20.0;
/** Planes reach beyond the scan, so that they are seen. */
constexpr double PlaneMargin = 5.0;
constexpr double PlaneOpacity = 0.18;
/** A tube's focal spot is below a millimetre: the ball is only a sign that is seen from two metres. */
constexpr double SourceRadius = 8.0;
/** Lines lie this far before the detector, each point on its own ray, so that no depth buffer hides them in it; the
 * tracing before the silhouette. */
constexpr double SilhouetteLift = 0.3;
constexpr double TracingLift = 0.6;

MeshType::PointType
ToMeshPoint(const PointType & point)
{
  MeshType::PointType result;
  for (unsigned int d = 0; d < 3; ++d)
  {
    result[d] = static_cast<float>(point[d]);
  }
  return result;
}

/** Fills a mesh with points, triangles and chains of lines. */
class MeshBuilder
{
public:
  MeshType::PointIdentifier
  AddPoint(const PointType & point)
  {
    const auto id = m_Mesh->GetNumberOfPoints();
    m_Mesh->SetPoint(id, ToMeshPoint(point));
    return id;
  }

  void
  AddTriangle(MeshType::PointIdentifier a, MeshType::PointIdentifier b, MeshType::PointIdentifier c)
  {
    MeshType::CellAutoPointer cell;
    cell.TakeOwnership(new TriangleCell<MeshType::CellType>);
    cell->SetPointId(0, a);
    cell->SetPointId(1, b);
    cell->SetPointId(2, c);
    m_Mesh->SetCell(m_Mesh->GetNumberOfCells(), cell);
  }

  void
  AddChain(const std::vector<PointType> & points, bool closed = false)
  {
    const auto first = m_Mesh->GetNumberOfPoints();
    for (const PointType & point : points)
    {
      this->AddPoint(point);
    }
    for (std::size_t i = 0; i + 1 < points.size() + (closed ? 1 : 0); ++i)
    {
      MeshType::CellAutoPointer cell;
      cell.TakeOwnership(new LineCell<MeshType::CellType>);
      cell->SetPointId(0, first + i);
      cell->SetPointId(1, first + (i + 1) % points.size());
      m_Mesh->SetCell(m_Mesh->GetNumberOfCells(), cell);
    }
  }

  /** A triangulated ball. */
  void
  AddBall(const PointType & center, double radius)
  {
    constexpr unsigned int rings = 8;
    constexpr unsigned int sectors = 16;
    constexpr double       pi = 3.14159265358979323846;
    const auto             first = m_Mesh->GetNumberOfPoints();
    for (unsigned int ring = 0; ring <= rings; ++ring)
    {
      const double polar = pi * ring / rings;
      for (unsigned int sector = 0; sector < sectors; ++sector)
      {
        const double azimuth = 2.0 * pi * sector / sectors;
        PointType    point = center;
        point[0] += radius * std::sin(polar) * std::cos(azimuth);
        point[1] += radius * std::sin(polar) * std::sin(azimuth);
        point[2] += radius * std::cos(polar);
        this->AddPoint(point);
      }
    }
    for (unsigned int ring = 0; ring < rings; ++ring)
    {
      for (unsigned int sector = 0; sector < sectors; ++sector)
      {
        const auto a = first + ring * sectors + sector;
        const auto b = first + ring * sectors + (sector + 1) % sectors;
        // The poles' own triangles have no area and are left out.
        if (ring > 0)
        {
          this->AddTriangle(a, a + sectors, b);
        }
        if (ring + 1 < rings)
        {
          this->AddTriangle(b, a + sectors, b + sectors);
        }
      }
    }
  }

  MeshType::Pointer
  Get() const
  {
    return m_Mesh;
  }

private:
  MeshType::Pointer m_Mesh{ MeshType::New() };
};

ScenePart
MakePart(const std::string & name, ScenePartEnum kind, const MeshType::Pointer & mesh, const ColorType & color)
{
  ScenePart part;
  part.name = name;
  part.kind = kind;
  part.mesh = mesh;
  part.color = color;
  return part;
}

PointType
Apply(const PlacementType & matrix, const PointType & point)
{
  PointType result;
  for (unsigned int row = 0; row < 3; ++row)
  {
    result[row] = matrix[4 * row + 3];
    for (unsigned int d = 0; d < 3; ++d)
    {
      result[row] += matrix[4 * row + d] * point[d];
    }
  }
  return result;
}

bool
IsRigid(const PlacementType & matrix)
{
  constexpr double tolerance = 1e-4;
  for (unsigned int a = 0; a < 3; ++a)
  {
    for (unsigned int b = 0; b < 3; ++b)
    {
      double product = 0.0;
      for (unsigned int d = 0; d < 3; ++d)
      {
        product += matrix[4 * a + d] * matrix[4 * b + d];
      }
      if (!(std::abs(product - (a == b ? 1.0 : 0.0)) < tolerance))
      {
        return false;
      }
    }
  }
  return true;
}

/** On the ray of a pixel, `lift` mm before the detector. */
PointType
GetLiftedPoint(const SceneDetector & detector, double u, double v, double lift)
{
  const PointType  point = detector.GetPoint(u, v);
  const VectorType toSource = detector.GetSource() - point;
  return point + toSource * (lift / detector.GetSourceToDetectorDistance());
}

/** The smallest rectangle of pixels around what was added. */
struct PixelBox
{
  std::array<double, 2> lowest{ { std::numeric_limits<double>::max(), std::numeric_limits<double>::max() } };
  std::array<double, 2> highest{ { std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest() } };

  void
  Add(double u, double v)
  {
    lowest = { { std::min(lowest[0], u), std::min(lowest[1], v) } };
    highest = { { std::max(highest[0], u), std::max(highest[1], v) } };
  }
};

/** Eight bits from the darkest to the brightest half percent, in blocks of pixels where it is larger than `largest`. */
ScenePart::PictureType::Pointer
MakePicture(const SceneView::ImageType & image, unsigned int largest)
{
  const auto        size = image.GetBufferedRegion().GetSize();
  const float *     pixels = image.GetBufferPointer();
  const auto        window = GreyWindow::FromQuantiles(pixels, size[0] * size[1], 0.005);
  const ShrunkImage small = ShrunkImage::ToFit(pixels, size[0], size[1], largest);
  auto              picture = ScenePart::PictureType::New();
  picture->SetRegions(ScenePart::PictureType::SizeType{ { small.width, small.height } });
  picture->Allocate();
  std::transform(small.pixels.begin(), small.pixels.end(), picture->GetBufferPointer(), [&window](float value) {
    return window.ToByte(value);
  });
  return picture;
}

/** The detector from edge to edge, its corners from upper left clockwise in the picture. */
ScenePart
MakeDetectorPart(const std::string & name, const SceneDetector & detector, const PixelBox & box)
{
  MeshBuilder                 builder;
  const std::array<double, 2> corners[] = { { { box.lowest[0], box.lowest[1] } },
                                            { { box.highest[0], box.lowest[1] } },
                                            { { box.highest[0], box.highest[1] } },
                                            { { box.lowest[0], box.highest[1] } } };
  for (const auto & corner : corners)
  {
    builder.AddPoint(detector.GetPoint(corner[0], corner[1]));
  }
  builder.AddTriangle(0, 1, 2);
  builder.AddTriangle(0, 2, 3);
  return MakePart(name, ScenePartEnum::Detector, builder.Get(), DetectorColor);
}
} // namespace

RegistrationSceneSource::RegistrationSceneSource()
{
  this->AddOptionalInputName("UpperScan");
  this->AddOptionalInputName("LowerScan");
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
}

RegistrationSceneSource::DataObjectPointer
RegistrationSceneSource::MakeOutput(DataObjectPointerArraySizeType)
{
  return RegistrationScene::New().GetPointer();
}

RegistrationScene *
RegistrationSceneSource::GetOutput()
{
  return itkDynamicCastInDebugMode<RegistrationScene *>(this->ProcessObject::GetOutput(0));
}

const RegistrationScene *
RegistrationSceneSource::GetOutput() const
{
  return itkDynamicCastInDebugMode<const RegistrationScene *>(this->ProcessObject::GetOutput(0));
}

void
RegistrationSceneSource::SetScan(JawEnum               jaw,
                                 const MeshType *      mesh,
                                 const PlacementType & meshToCephalostat,
                                 const PlacementType & meshToUMDA)
{
  this->ProcessObject::SetInput(jaw == JawEnum::Lower ? "LowerScan" : "UpperScan", const_cast<MeshType *>(mesh));
  m_Places[jaw == JawEnum::Lower ? JawEnum::Lower : JawEnum::Upper] = { meshToCephalostat, meshToUMDA };
  this->Modified();
}

const RegistrationSceneSource::MeshType *
RegistrationSceneSource::GetScan(JawEnum jaw) const
{
  return itkDynamicCastInDebugMode<const MeshType *>(
    this->ProcessObject::GetInput(jaw == JawEnum::Lower ? "LowerScan" : "UpperScan"));
}

void
RegistrationSceneSource::AddView(const SceneView & view)
{
  m_Views.push_back(view);
  this->Modified();
}

void
RegistrationSceneSource::ClearViews()
{
  m_Views.clear();
  this->Modified();
}

void
RegistrationSceneSource::VerifyPreconditions() ITKv5_CONST
{
  Superclass::VerifyPreconditions();
  if (m_Views.empty() && this->GetScan(JawEnum::Upper) == nullptr && this->GetScan(JawEnum::Lower) == nullptr)
  {
    itkExceptionMacro("There is nothing to show. Call SetScan() or AddView() first.");
  }
  std::set<std::string> names;
  for (const SceneView & view : m_Views)
  {
    if (!names.insert(view.name).second)
    {
      itkExceptionMacro("Two views are named \"" << view.name
                                                 << "\", and parts are found by name. Name each of its own.");
    }
  }
}

void
RegistrationSceneSource::AddJaw(JawEnum jaw, RegistrationScene::PartsType & parts) const
{
  const MeshType * const mesh = this->GetScan(jaw);
  if (mesh == nullptr)
  {
    return;
  }
  const std::string name = ToString(jaw);
  const ScanPlace & place = m_Places.at(jaw);
  for (const PlacementType * matrix : { &place.meshToCephalostat, &place.meshToUMDA })
  {
    if (!IsRigid(*matrix))
    {
      itkExceptionMacro("The " << name
                               << " scan's place is no rigid map. Give rotation and shift in mm, row-major 3x4.");
    }
  }
  // How far the scan reaches in its own frame.
  std::array<double, 3> lowest{ { 0.0, 0.0, 0.0 } };
  std::array<double, 3> highest{ { 0.0, 0.0, 0.0 } };
  auto                  moved = MeshType::New();
  moved->Graft(mesh);
  auto points = MeshType::PointsContainer::New();
  points->Reserve(mesh->GetNumberOfPoints());
  if (mesh->GetPoints() != nullptr)
  {
    for (auto it = mesh->GetPoints()->Begin(); it != mesh->GetPoints()->End(); ++it)
    {
      PointType point;
      point.CastFrom(it.Value());
      points->SetElement(it.Index(), ToMeshPoint(Apply(place.meshToCephalostat, point)));
      const PointType own = Apply(place.meshToUMDA, point);
      for (unsigned int d = 0; d < 3; ++d)
      {
        lowest[d] = std::min(lowest[d], own[d] - PlaneMargin);
        highest[d] = std::max(highest[d], own[d] + PlaneMargin);
      }
    }
  }
  moved->SetPoints(points);
  parts.push_back(
    MakePart(name + " scan", ScenePartEnum::Scan, moved, jaw == JawEnum::Lower ? LowerScanColor : UpperScanColor));

  const PlacementType umdaToCephalostat = TimesRigidInverse(place.meshToCephalostat, place.meshToUMDA);
  const auto          at = [&](double x, double y, double z) {
    PointType point;
    point[0] = x;
    point[1] = y;
    point[2] = z;
    return Apply(umdaToCephalostat, point);
  };
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    MeshBuilder builder;
    builder.AddChain({ at(0.0, 0.0, 0.0),
                       at(axis == 0 ? AxisLength : 0.0, axis == 1 ? AxisLength : 0.0, axis == 2 ? AxisLength : 0.0) });
    parts.push_back(MakePart(name + " axis " + "xyz"[axis], ScenePartEnum::Axis, builder.Get(), AxisColors[axis]));
    parts.back().lineWidth = 4.0;
  }
  // The midsagittal plane has the colour of its normal's axis, as the axial one has.
  for (const unsigned int normal : { 1U, 2U })
  {
    const unsigned int second = normal == 1 ? 2 : 1;
    MeshBuilder        builder;
    const auto         corner = [&](double x, double other) {
      builder.AddPoint(normal == 1 ? at(x, 0.0, other) : at(x, other, 0.0));
    };
    corner(lowest[0], lowest[second]);
    corner(highest[0], lowest[second]);
    corner(highest[0], highest[second]);
    corner(lowest[0], highest[second]);
    builder.AddTriangle(0, 1, 2);
    builder.AddTriangle(0, 2, 3);
    parts.push_back(MakePart(name + (normal == 1 ? " midsagittal plane" : " axial plane"),
                             ScenePartEnum::Plane,
                             builder.Get(),
                             AxisColors[normal]));
    parts.back().opacity = PlaneOpacity;
  }
}

void
RegistrationSceneSource::AddViewParts(const SceneView &              view,
                                      const SceneDetector &          detector,
                                      RegistrationScene::PartsType & parts) const
{
  std::vector<ScenePart> drawn;
  PixelBox               seen;
  const auto             central = detector.GetCentralPixel();
  seen.Add(central[0], central[1]);
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    const std::string  prefix = view.name + ' ' + ToString(jaw);
    const auto         found = view.jaws.find(jaw);
    const SceneViewJaw own = found == view.jaws.end() ? SceneViewJaw() : found->second;
    if (const ScenePart * const scan = [&]() -> const ScenePart * {
          const auto place = std::find_if(parts.begin(), parts.end(), [&](const ScenePart & part) {
            return part.name == std::string(ToString(jaw)) + " scan";
          });
          return place == parts.end() ? nullptr : &*place;
        }())
    {
      const SceneDetector   through(own.projection.value_or(view.projection), view.sourceToDetector);
      PerspectiveProjection projection;
      projection.matrix = through.GetProjection();
      std::copy(through.GetSource().Begin(), through.GetSource().End(), projection.source.begin());
      const MeshSilhouette silhouette(MakeTriangleSurface(scan->mesh.GetPointer()), MeshSilhouette::PosesEnum::One);
      MeshBuilder          builder;
      for (const SilhouetteLoop & loop : silhouette.ComputeOuterBoundary(projection).loops)
      {
        std::vector<PointType> chain;
        for (const auto & pixel : loop.points)
        {
          seen.Add(pixel[0], pixel[1]);
          chain.push_back(GetLiftedPoint(detector, pixel[0], pixel[1], SilhouetteLift));
        }
        builder.AddChain(chain, true);
      }
      drawn.push_back(MakePart(prefix + " silhouette", ScenePartEnum::Silhouette, builder.Get(), SilhouetteColor));
      drawn.back().lineWidth = 2.0;
    }
    if (own.tracing.IsNotNull() && own.tracing->GetNumberOfPoints() > 0)
    {
      MeshBuilder builder;
      auto        teeth = MeshType::PointDataContainer::New();
      for (const auto & polyline : own.tracing->GetPolylines())
      {
        std::vector<PointType> chain;
        for (const auto & pixel : polyline.points)
        {
          seen.Add(pixel[0], pixel[1]);
          chain.push_back(GetLiftedPoint(detector, pixel[0], pixel[1], TracingLift));
          teeth->InsertElement(teeth->Size(), static_cast<float>(polyline.code.IsKnown() ? polyline.code.GetFDI() : 0));
        }
        builder.AddChain(chain, polyline.closed);
      }
      drawn.push_back(MakePart(prefix + " tracing", ScenePartEnum::Tracing, builder.Get(), TracingColor));
      drawn.back().mesh->SetPointData(teeth);
      drawn.back().lineWidth = 3.0;
    }
    if (!own.landmarks.empty())
    {
      MeshBuilder builder;
      for (const SceneLandmark & landmark : own.landmarks)
      {
        seen.Add(landmark.pixel[0], landmark.pixel[1]);
        builder.AddChain(
          { detector.GetSource(), landmark.point, detector.GetPoint(landmark.pixel[0], landmark.pixel[1]) });
      }
      drawn.push_back(MakePart(prefix + " rays", ScenePartEnum::Rays, builder.Get(), RayColor));
      drawn.back().opacity = 0.6;
    }
  }

  MeshBuilder source;
  source.AddBall(detector.GetSource(), SourceRadius);
  parts.push_back(MakePart(view.name + " source", ScenePartEnum::Source, source.Get(), SourceColor));
  MeshBuilder ray;
  ray.AddChain({ detector.GetSource(), detector.GetCentralPoint() });
  parts.push_back(MakePart(view.name + " central ray", ScenePartEnum::CentralRay, ray.Get(), SourceColor));
  parts.back().lineWidth = 2.0;

  PixelBox   box;
  auto       size = view.imageSize;
  const bool hasPicture = view.radiograph.IsNotNull() && view.radiograph->GetBufferPointer() != nullptr;
  if (hasPicture)
  {
    const auto own = view.radiograph->GetBufferedRegion().GetSize();
    size = { { static_cast<unsigned int>(own[0]), static_cast<unsigned int>(own[1]) } };
  }
  if (size[0] > 0 && size[1] > 0)
  {
    box.Add(-0.5, -0.5);
    box.Add(size[0] - 0.5, size[1] - 0.5);
  }
  else
  {
    constexpr double share = 0.05;
    const double margin = share * std::max(seen.highest[0] - seen.lowest[0], seen.highest[1] - seen.lowest[1]) + 1.0;
    box.Add(seen.lowest[0] - margin, seen.lowest[1] - margin);
    box.Add(seen.highest[0] + margin, seen.highest[1] + margin);
  }
  parts.push_back(MakeDetectorPart(view.name + " detector", detector, box));
  ScenePart & detectorPart = parts.back();
  if (hasPicture)
  {
    detectorPart.picture = MakePicture(*view.radiograph, m_MaximumPictureSize);
    // The last blocks may reach beyond the detector's edge.
    const auto         pictureSize = detectorPart.picture->GetBufferedRegion().GetSize();
    const unsigned int longest = std::max(size[0], size[1]);
    const unsigned int block = (longest + m_MaximumPictureSize - 1) / m_MaximumPictureSize;
    const auto         right = static_cast<float>(size[0]) / static_cast<float>(block * pictureSize[0]);
    const auto         bottom = static_cast<float>(size[1]) / static_cast<float>(block * pictureSize[1]);
    detectorPart.pictureCoordinates = {
      { { 0.0F, 0.0F } }, { { right, 0.0F } }, { { right, bottom } }, { { 0.0F, bottom } }
    };
  }
  else
  {
    detectorPart.opacity = 0.4;
  }
  parts.insert(parts.end(), drawn.begin(), drawn.end());
}

void
RegistrationSceneSource::GenerateData()
{
  RegistrationScene::PartsType     parts;
  RegistrationScene::DetectorsType detectors;
  this->AddJaw(JawEnum::Upper, parts);
  this->AddJaw(JawEnum::Lower, parts);
  std::size_t done = 0;
  for (const SceneView & view : m_Views)
  {
    try
    {
      const SceneDetector detector(view.projection, view.sourceToDetector);
      detectors.emplace_back(view.name, detector);
      this->AddViewParts(view, detector, parts);
    }
    catch (const std::logic_error & problem)
    {
      itkExceptionMacro("View \"" << view.name << "\": " << problem.what()
                                  << ". Give the projection of the registration.");
    }
    this->UpdateProgress(static_cast<float>(++done) / static_cast<float>(m_Views.size()));
  }
  this->GetOutput()->Set(std::move(parts), std::move(detectors));
}

void
RegistrationSceneSource::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Views:";
  for (const SceneView & view : m_Views)
  {
    os << ' ' << view.name;
  }
  os << std::endl;
  os << indent << "Places: " << m_Places.size() << std::endl;
  os << indent << "MaximumPictureSize: " << m_MaximumPictureSize << std::endl;
}
} // namespace itk

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
#include "itkSceneRenderer.h"

#include "itkSceneToVTK.h"

#include "itkMacro.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
constexpr double Degrees = 180.0 / 3.14159265358979323846;

/** Rows from below upward and grey as red, green and blue, as VTK and glTF take textures. */
vtkSmartPointer<vtkTexture>
MakeTexture(const ScenePart::PictureType & picture)
{
  const auto           size = picture.GetBufferedRegion().GetSize();
  vtkNew<vtkImageData> image;
  image->SetDimensions(static_cast<int>(size[0]), static_cast<int>(size[1]), 1);
  vtkNew<vtkUnsignedCharArray> pixels;
  pixels->SetName("radiograph");
  pixels->SetNumberOfComponents(3);
  pixels->SetNumberOfTuples(static_cast<vtkIdType>(size[0] * size[1]));
  unsigned char * out = pixels->GetPointer(0);
  for (std::size_t row = size[1]; row-- > 0;)
  {
    const unsigned char * in = picture.GetBufferPointer() + row * size[0];
    for (std::size_t column = 0; column < size[0]; ++column, ++in)
    {
      *out++ = *in;
      *out++ = *in;
      *out++ = *in;
    }
  }
  image->GetPointData()->SetScalars(pixels);
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOn();
  return texture;
}

vtkSmartPointer<vtkActor>
MakeActor(const ScenePart & part)
{
  vtkSmartPointer<vtkPolyData> surface = ScenePartToVTK(part);
  const bool                   isLit = IsLit(part.kind);
  if (isLit && surface->GetNumberOfPolys() > 0)
  {
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputData(surface);
    normals->SplittingOff();
    // A scan is wound as its scanner left it, and both sides are lit.
    normals->ConsistencyOff();
    normals->Update();
    surface = normals->GetOutput();
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  vtkProperty * const look = actor->GetProperty();
  look->SetColor(part.color[0], part.color[1], part.color[2]);
  look->SetOpacity(part.opacity);
  look->SetLineWidth(static_cast<float>(part.lineWidth));
  if (isLit)
  {
    look->SetSpecular(0.15);
    look->SetSpecularPower(20.0);
  }
  else
  {
    // Drawn things and a radiograph are as bright as they are, from wherever one looks.
    look->LightingOff();
  }
  if (part.picture.IsNotNull())
  {
    actor->SetTexture(MakeTexture(*part.picture));
  }
  return actor;
}
} // namespace

SceneRenderer::SceneRenderer(const RegistrationScene & scene, bool legend)
  : m_Scene(&scene)
  , m_Renderer(vtkSmartPointer<vtkRenderer>::New())
{
  m_Renderer->SetBackground(0.16, 0.17, 0.19);
  m_Renderer->SetBackground2(0.32, 0.34, 0.38);
  m_Renderer->GradientBackgroundOn();
  // Translucent things that cross one another are sorted by pixel, which VTK can only without multisampling.
  m_Renderer->SetUseDepthPeeling(1);
  m_Renderer->SetMaximumNumberOfPeels(8);
  m_Renderer->UseFXAAOn();
  for (const ScenePart & part : scene.GetParts())
  {
    m_Actors.emplace_back(part.kind, MakeActor(part));
    m_Renderer->AddActor(m_Actors.back().second);
  }
  if (legend)
  {
    this->AddLegend();
  }
}

void
SceneRenderer::AddLegend()
{
  const std::vector<std::pair<std::string, std::string>> lines = {
    { " tracing", "tracing" },        { " silhouette", "silhouette of the scan" },
    { " rays", "rays of landmarks" }, { " central ray", "central ray, source" },
    { " axis z", "z superior" },      { " axis y", "y patient's left" },
    { " axis x", "x anterior" },      { "lower scan", "lower scan" },
    { "upper scan", "upper scan" }
  };
  const auto & parts = m_Scene->GetParts();
  double       height = 12.0;
  for (const auto & line : lines)
  {
    const auto found = std::find_if(parts.begin(), parts.end(), [&](const ScenePart & part) {
      return part.name.size() >= line.first.size() &&
             part.name.compare(part.name.size() - line.first.size(), std::string::npos, line.first) == 0;
    });
    if (found == parts.end())
    {
      continue;
    }
    vtkNew<vtkTextActor> text;
    text->SetInput(line.second.c_str());
    text->SetPosition(12.0, height);
    text->GetTextProperty()->SetFontSize(16);
    // Readable before a radiograph, too.
    text->GetTextProperty()->SetBackgroundColor(0.16, 0.17, 0.19);
    text->GetTextProperty()->SetBackgroundOpacity(0.75);
    text->GetTextProperty()->SetColor(found->color[0], found->color[1], found->color[2]);
    m_Renderer->AddActor2D(text);
    height += 22.0;
  }
}

bool
IsLit(ScenePartEnum kind)
{
  return kind == ScenePartEnum::Scan || kind == ScenePartEnum::Source;
}

std::vector<std::string>
SceneRenderer::GetCameras(const RegistrationScene & scene)
{
  std::vector<std::string> names{ "overview", "front", "side", "above", "all" };
  if (!scene.GetDetectors().empty())
  {
    names.emplace_back("source");
    names.emplace_back("teeth");
  }
  for (const auto & detector : scene.GetDetectors())
  {
    names.push_back(detector.first);
  }
  return names;
}

void
SceneRenderer::LookFrom(std::array<double, 3>         direction,
                        const std::array<double, 3> & up,
                        double                        aspect,
                        bool                          withSources)
{
  // The corners of what the picture is to be filled with. The source is as far away as ten heads.
  std::vector<std::array<double, 3>> corners;
  for (const auto & actor : m_Actors)
  {
    if (!withSources && actor.first != ScenePartEnum::Scan && actor.first != ScenePartEnum::Detector)
    {
      continue;
    }
    const double * const own = actor.second->GetBounds();
    for (unsigned int corner = 0; corner < 8; ++corner)
    {
      corners.push_back({ { own[corner & 1U], own[2 + ((corner >> 1U) & 1U)], own[4 + ((corner >> 2U) & 1U)] } });
    }
  }
  const double norm =
    std::sqrt(direction[0] * direction[0] + direction[1] * direction[1] + direction[2] * direction[2]);
  for (double & element : direction)
  {
    element /= norm;
  }
  constexpr double  angle = 30.0;
  constexpr double  margin = 1.04;
  vtkCamera * const camera = m_Renderer->GetActiveCamera();
  camera->SetViewAngle(angle);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(up.data());
  camera->SetPosition(direction.data());
  camera->OrthogonalizeViewUp();
  // Axes of the picture: to the side, upward, toward the camera.
  std::array<std::array<double, 3>, 3> axes{ { {}, {}, direction } };
  camera->GetViewUp(axes[1].data());
  for (unsigned int d = 0; d < 3; ++d)
  {
    const unsigned int a = (d + 1) % 3;
    const unsigned int b = (d + 2) % 3;
    axes[0][d] = axes[1][a] * direction[b] - axes[1][b] * direction[a];
  }
  std::array<double, 3> lowest{};
  std::array<double, 3> highest{};
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    std::array<double, 3> place{};
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      for (unsigned int d = 0; d < 3; ++d)
      {
        place[axis] += axes[axis][d] * corners[i][d];
      }
      lowest[axis] = i == 0 ? place[axis] : std::min(lowest[axis], place[axis]);
      highest[axis] = i == 0 ? place[axis] : std::max(highest[axis], place[axis]);
    }
    corners[i] = place;
  }
  // As near as every corner allows, seen from before the middle.
  const double slope = std::tan(0.5 * angle / Degrees);
  double       distance = 1.0;
  for (const auto & corner : corners)
  {
    const double sideways = std::abs(corner[0] - 0.5 * (lowest[0] + highest[0]));
    const double upward = std::abs(corner[1] - 0.5 * (lowest[1] + highest[1]));
    distance = std::max(distance, corner[2] + margin * std::max(upward, sideways / aspect) / slope);
  }
  std::array<double, 3> position{};
  std::array<double, 3> focus{};
  for (unsigned int d = 0; d < 3; ++d)
  {
    const double middle = 0.5 * (lowest[0] + highest[0]) * axes[0][d] + 0.5 * (lowest[1] + highest[1]) * axes[1][d];
    position[d] = middle + distance * direction[d];
    focus[d] = middle + 0.5 * (lowest[2] + highest[2]) * direction[d];
  }
  camera->SetPosition(position.data());
  camera->SetFocalPoint(focus.data());
  m_Renderer->ResetCameraClippingRange();
}

void
SceneRenderer::LookFromSource(const std::string & view, double aspect, bool onlyTeeth)
{
  const SceneDetector &         detector = *m_Scene->FindDetector(view);
  const ScenePart &             plane = *m_Scene->FindPart(view + " detector");
  std::vector<Point<double, 3>> corners;
  for (const ScenePart & part : m_Scene->GetParts())
  {
    const bool isDrawn = part.kind == ScenePartEnum::Tracing || part.kind == ScenePartEnum::Silhouette;
    if (onlyTeeth ? isDrawn && part.name.compare(0, view.size() + 1, view + ' ') == 0 : &part == &plane)
    {
      for (auto it = part.mesh->GetPoints()->Begin(); it != part.mesh->GetPoints()->End(); ++it)
      {
        corners.emplace_back();
        corners.back().CastFrom(it.Value());
      }
    }
  }
  // Axes of the detector: to the right and upward in the picture on it.
  std::array<Point<double, 3>, 4> edge;
  for (unsigned int i = 0; i < 4; ++i)
  {
    edge[i].CastFrom(plane.mesh->GetPoint(i));
  }
  auto rightward = edge[1] - edge[0];
  auto upward = edge[0] - edge[3];
  rightward.Normalize();
  upward.Normalize();
  if (corners.empty())
  {
    corners.assign(edge.begin(), edge.end());
  }
  std::array<double, 2> lowest{ { 1e300, 1e300 } };
  std::array<double, 2> highest{ { -1e300, -1e300 } };
  for (const auto & corner : corners)
  {
    const std::array<double, 2> place{ { (corner - edge[0]) * rightward, (corner - edge[0]) * upward } };
    for (unsigned int d = 0; d < 2; ++d)
    {
      lowest[d] = std::min(lowest[d], place[d]);
      highest[d] = std::max(highest[d], place[d]);
    }
  }
  const auto middle =
    edge[0] + rightward * (0.5 * (lowest[0] + highest[0])) + upward * (0.5 * (lowest[1] + highest[1]));
  constexpr double  margin = 1.04;
  vtkCamera * const camera = m_Renderer->GetActiveCamera();
  camera->SetPosition(detector.GetSource().GetDataPointer());
  camera->SetFocalPoint(middle.GetDataPointer());
  camera->SetViewUp(upward.GetDataPointer());
  camera->SetViewAngle(2.0 * Degrees *
                       std::atan(0.5 * margin * std::max(highest[1] - lowest[1], (highest[0] - lowest[0]) / aspect) /
                                 detector.GetSource().EuclideanDistanceTo(middle)));
  m_Renderer->ResetCameraClippingRange();
}

void
SceneRenderer::SetCamera(const std::string & name, double aspect)
{
  const auto & detectors = m_Scene->GetDetectors();
  const auto   cameras = GetCameras(*m_Scene);
  if (std::find(cameras.begin(), cameras.end(), name) == cameras.end())
  {
    std::string all;
    for (const std::string & camera : cameras)
    {
      all += (all.empty() ? "" : ", ") + camera;
    }
    itkGenericExceptionMacro("There is no camera \"" << name << "\". This scene has " << all << '.');
  }
  // Away from the detectors, so that they are behind the scans.
  std::array<double, 3> away{ { 0.0, 0.0, 0.0 } };
  for (const auto & detector : detectors)
  {
    for (unsigned int d = 0; d < 3; ++d)
    {
      away[d] -= detector.second.GetAxis()[d];
    }
  }
  const std::array<double, 3> superior{ { 0.0, 0.0, 1.0 } };
  // From a source, scans hide their own images unless one sees through them, and what stands around them is in the way.
  const bool       fromSource = name == "source" || name == "teeth" || m_Scene->FindDetector(name) != nullptr;
  constexpr double translucent = 0.15;
  for (std::size_t i = 0; i < m_Actors.size(); ++i)
  {
    const ScenePartEnum kind = m_Actors[i].first;
    if (kind == ScenePartEnum::Scan)
    {
      m_Actors[i].second->GetProperty()->SetOpacity(fromSource ? translucent : m_Scene->GetParts()[i].opacity);
    }
    else if (kind == ScenePartEnum::Plane || kind == ScenePartEnum::Axis || kind == ScenePartEnum::Rays)
    {
      m_Actors[i].second->SetVisibility(!fromSource);
    }
  }
  if (name == "overview" || name == "all")
  {
    this->LookFrom({ { 0.7 + away[0], away[1], 0.4 + away[2] } }, superior, aspect, name == "all");
  }
  else if (name == "front")
  {
    this->LookFrom({ { 1.0, 0.0, 0.0 } }, superior, aspect);
  }
  else if (name == "side")
  {
    const bool fromLeft = !detectors.empty() && detectors.front().second.GetSource()[1] > 0.0;
    this->LookFrom({ { 0.0, fromLeft ? 1.0 : -1.0, 0.0 } }, superior, aspect);
  }
  else if (name == "above")
  {
    this->LookFrom(superior, { { 1.0, 0.0, 0.0 } }, aspect);
  }
  else
  {
    const bool isFirst = name == "source" || name == "teeth";
    this->LookFromSource(isFirst ? detectors.front().first : name, aspect, name == "teeth");
  }
}

void
SceneRenderer::Toggle(ScenePartEnum kind)
{
  for (auto & actor : m_Actors)
  {
    if (actor.first == kind)
    {
      actor.second->SetVisibility(actor.second->GetVisibility() == 0);
    }
  }
}
} // namespace itk

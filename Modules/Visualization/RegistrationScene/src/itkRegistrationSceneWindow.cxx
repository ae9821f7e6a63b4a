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
#include "itkRegistrationSceneWindow.h"

#include "itkLowerCase.h"
#include "itkSceneRenderer.h"
#include "itkSceneToVTK.h"
#include "itkScreenConnection.h"

#include <vtkGLTFExporter.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkVersion.h>
#include <vtkWindowToImageFilter.h>
#include <vtkXMLMultiBlockDataWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <functional>
#include <random>

namespace itk
{
namespace
{
namespace fs = std::filesystem;

std::string
GetExtension(const std::string & fileName)
{
  return LowerCase(fs::u8path(fileName).extension().string());
}

/** Whether a folder holds blocks of an earlier export of this name, and nothing else: then it may be replaced. */
bool
HoldsBlocksOnly(const fs::path & folder)
{
  const std::string prefix = folder.filename().string() + '_';
  std::error_code   error;
  for (const auto & entry : fs::directory_iterator(folder, error))
  {
    const std::string extension = GetExtension(entry.path().string());
    if (!fs::is_regular_file(entry.symlink_status(error)) || entry.path().filename().string().rfind(prefix, 0) != 0 ||
        (extension != ".vtp" && extension != ".vti"))
    {
      return false;
    }
  }
  return !error;
}

/** Has a file written, and what its writer puts beside it, in a folder beside the target, and moves it there whole.
 * `write` is given the name to write to and tells whether it succeeded. */
void
WriteWhole(const std::string & fileName, const std::function<bool(const std::string &)> & write)
{
  const fs::path target = fs::absolute(fs::u8path(fileName));
  // Blocks lie in a folder that is named as the file without its end.
  const fs::path  folder = target.parent_path() / target.stem();
  std::error_code isNoFolder;
  if (GetExtension(fileName) == ".vtm" && fs::exists(folder, isNoFolder) && !HoldsBlocksOnly(folder))
  {
    itkGenericExceptionMacro(<< fileName << " cannot be written: its blocks would replace "
                             << folder.filename().u8string() << ", which holds something else. Choose another name.");
  }
  std::random_device device;
  const fs::path     staging = target.parent_path() / (".part-" + std::to_string(device()));
  std::error_code    error;
  fs::create_directory(staging, error);
  if (error)
  {
    itkGenericExceptionMacro(<< fileName << " cannot be written: " << error.message()
                             << ". Choose a folder that is there and can be written to.");
  }
  const fs::path made = staging / target.filename();
  // What VTK has to say of a failure goes to its own window of messages; the file's absence tells enough.
  const bool succeeded = write(made.string()) && fs::file_size(made, error) > 0 && !error;
  if (succeeded)
  {
    std::error_code hasNoBlocks;
    if (fs::is_directory(staging / target.stem(), hasNoBlocks))
    {
      fs::remove_all(folder, error);
      fs::rename(staging / target.stem(), folder, error);
    }
    if (!error)
    {
      fs::rename(made, target, error);
    }
  }
  std::error_code ignored;
  fs::remove_all(staging, ignored);
  if (!succeeded || error)
  {
    itkGenericExceptionMacro(<< fileName << " cannot be written"
                             << (error ? ": " + error.message() : std::string(": VTK failed"))
                             << ". Look for space on the disk, or choose another folder.");
  }
}

/** What VTK 9.1 leaves out of a glTF file: names, translucency, both sides of a surface, what is not lit, and glTF's
 * own metres and upward y. Points stay as they are, in mm of the scene's frame: a node above them turns and scales. */
void
CompleteGLTF(const std::string & fileName, const RegistrationScene & scene)
{
  using Json = nlohmann::ordered_json;
  Json                           json = Json::parse(std::ifstream(fs::u8path(fileName), std::ios::binary));
  std::vector<const ScenePart *> written;
  for (const ScenePart & part : scene.GetParts())
  {
    if (part.mesh->GetNumberOfCells() > 0)
    {
      written.push_back(&part);
    }
  }
  if (json["meshes"].size() != written.size())
  {
    itkGenericExceptionMacro(<< fileName << ": VTK wrote " << json["meshes"].size() << " of " << written.size()
                             << " parts. Export the scene as .vtm.");
  }
  for (std::size_t i = 0; i < written.size(); ++i)
  {
    Json & mesh = json["meshes"][i];
    mesh["name"] = written[i]->name;
    for (const Json & primitive : mesh["primitives"])
    {
      Json & material = json["materials"][primitive["material"].get<std::size_t>()];
      material["name"] = written[i]->name;
      material["doubleSided"] = true;
      if (written[i]->opacity < 1.0)
      {
        material["alphaMode"] = "BLEND";
      }
      if (!IsLit(written[i]->kind))
      {
        material["extensions"]["KHR_materials_unlit"] = Json::object();
      }
    }
  }
  json["extensionsUsed"] = { "KHR_materials_unlit" };
  // The camera is in mm, too: viewers frame a scene themselves.
  json.erase("cameras");
  Json children = Json::array();
  for (std::size_t i = 0; i < json["nodes"].size(); ++i)
  {
    Json & node = json["nodes"][i];
    node.erase("camera");
    if (node.contains("mesh"))
    {
      node["name"] = written[node["mesh"].get<std::size_t>()]->name;
      children.push_back(i);
    }
  }
  const std::size_t root = json["nodes"].size();
  // Column by column: x stays, y goes backward, z upward.
  json["nodes"].push_back(
    { { "name", "DentalSCR" },
      { "children", children },
      { "matrix", { 0.001, 0.0, 0.0, 0.0, 0.0, 0.0, -0.001, 0.0, 0.0, 0.001, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0 } } });
  json["scenes"] = { { { "name", "DentalSCR" }, { "nodes", { root } } } };
  json["scene"] = 0;
  std::ofstream stream(fs::u8path(fileName), std::ios::binary);
  stream << json.dump();
  stream.close();
  if (!stream)
  {
    itkGenericExceptionMacro(<< fileName << " cannot be written. Look for space on the disk.");
  }
}

/** Turning as in VTK's viewers; keys choose cameras and what is shown. */
class SceneInteractorStyle : public vtkInteractorStyleTrackballCamera
{
public:
  static SceneInteractorStyle *
  New();
  vtkTypeMacro(SceneInteractorStyle, vtkInteractorStyleTrackballCamera);

  void
  OnChar() override
  {
    const char key = this->Interactor->GetKeyCode();
    if (key == 'q' || key == 'Q' || key == 27)
    {
      this->Interactor->ExitCallback();
      return;
    }
    if (press)
    {
      press(key);
      this->Interactor->Render();
    }
  }

  std::function<void(char)> press;

protected:
  SceneInteractorStyle() = default;
};
vtkStandardNewMacro(SceneInteractorStyle);
} // namespace

std::vector<std::string>
RegistrationSceneWindow::GetCameras() const
{
  this->VerifyScene();
  return SceneRenderer::GetCameras(*m_Scene);
}

void
RegistrationSceneWindow::VerifyScene() const
{
  if (m_Scene.IsNull())
  {
    itkExceptionMacro("There is no scene: call SetScene() with the output of a RegistrationSceneSource.");
  }
}

void
RegistrationSceneWindow::VerifyScreen(const ScreenConnection & screen) const
{
  if (!screen.IsOpen())
  {
    itkExceptionMacro(
      "There is no screen: no X server answers at DISPLAY. Write a picture on a VirtualScreen, or export "
      "the scene.");
  }
}

void
RegistrationSceneWindow::VerifyExportName(const std::string & fileName)
{
  const std::string extension = GetExtension(fileName);
  if (extension == ".glb")
  {
    itkGenericExceptionMacro(
      << fileName << ": VTK " << vtkVersion::GetVTKVersion()
      << " writes glTF as text with everything in it, and no .glb. Name it .gltf; Blender makes a "
         ".glb of it.");
  }
  if (extension != ".gltf" && extension != ".vtp" && extension != ".vtm")
  {
    itkGenericExceptionMacro(<< fileName << ": no format of scenes ends in \"" << extension
                             << "\". Name it .gltf (Blender, web), .vtm (ParaView) or .vtp (Slicer, ParaView).");
  }
}

void
RegistrationSceneWindow::WriteSnapshot(const std::string & fileName) const
{
  this->VerifyScene();
  if (GetExtension(fileName) != ".png")
  {
    itkExceptionMacro(<< fileName << ": a picture is written as PNG. Name it .png.");
  }
  SceneRenderer renderer(*m_Scene, m_ShowLegend);
  renderer.SetCamera(m_Camera, static_cast<double>(m_Size[0]) / m_Size[1]);
  const ScreenConnection screen;
  this->VerifyScreen(screen);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(static_cast<int>(m_Size[0]), static_cast<int>(m_Size[1]));
  window->SetAlphaBitPlanes(1);
  window->AddRenderer(renderer.GetRenderer());
  window->Render();
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  WriteWhole(fileName, [&](const std::string & name) {
    writer->SetFileName(name.c_str());
    writer->Write();
    return writer->GetErrorCode() == 0;
  });
}

void
RegistrationSceneWindow::WriteExport(const std::string & fileName) const
{
  this->VerifyScene();
  VerifyExportName(fileName);
  const std::string extension = GetExtension(fileName);
  WriteWhole(fileName, [&](const std::string & name) {
    if (extension == ".vtm")
    {
      vtkNew<vtkXMLMultiBlockDataWriter> writer;
      writer->SetFileName(name.c_str());
      writer->SetInputData(SceneToVTK(*m_Scene));
      return writer->Write() == 1;
    }
    if (extension == ".vtp")
    {
      vtkNew<vtkXMLPolyDataWriter> writer;
      writer->SetFileName(name.c_str());
      writer->SetInputData(SceneToOnePolyData(*m_Scene));
      return writer->Write() == 1;
    }
    SceneRenderer renderer(*m_Scene, false);
    renderer.SetCamera("overview", 1.0);
    // Never shown: the exporter only asks it for its renderers.
    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering(1);
    window->AddRenderer(renderer.GetRenderer());
    vtkNew<vtkGLTFExporter> exporter;
    exporter->SetRenderWindow(window);
    exporter->InlineDataOn();
    exporter->SaveNormalOn();
    exporter->SetFileName(name.c_str());
    exporter->Write();
    CompleteGLTF(name, *m_Scene);
    return true;
  });
}

void
RegistrationSceneWindow::Show() const
{
  this->VerifyScene();
  SceneRenderer renderer(*m_Scene, m_ShowLegend);
  const double  aspect = static_cast<double>(m_Size[0]) / m_Size[1];
  renderer.SetCamera(m_Camera, aspect);
  const ScreenConnection screen;
  this->VerifyScreen(screen);

  const auto  cameras = this->GetCameras();
  std::string help;
  for (std::size_t i = 0; i < cameras.size() && i < 9; ++i)
  {
    help += (i == 0 ? "" : ", ") + std::to_string(i + 1) + ' ' + cameras[i];
  }
  help += "\nu upper and lower scan, p planes, a axes, d detector, t tracing, o outline, r rays; q ends";
  vtkNew<vtkTextActor> text;
  text->SetInput(help.c_str());
  text->GetTextProperty()->SetFontSize(14);
  text->GetTextProperty()->SetBackgroundColor(0.16, 0.17, 0.19);
  text->GetTextProperty()->SetBackgroundOpacity(0.75);
  text->GetTextProperty()->SetVerticalJustificationToTop();
  text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  text->SetPosition(0.01, 0.99);
  renderer.GetRenderer()->AddActor2D(text);

  vtkNew<vtkRenderWindow> window;
  window->SetSize(static_cast<int>(m_Size[0]), static_cast<int>(m_Size[1]));
  window->SetMultiSamples(0);
  window->SetAlphaBitPlanes(1);
  window->AddRenderer(renderer.GetRenderer());
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  vtkNew<SceneInteractorStyle> style;
  style->press = [&](char key) {
    const std::pair<char, ScenePartEnum> kinds[] = {
      { 'u', ScenePartEnum::Scan },     { 'p', ScenePartEnum::Plane },      { 'a', ScenePartEnum::Axis },
      { 'd', ScenePartEnum::Detector }, { 't', ScenePartEnum::Tracing },    { 'o', ScenePartEnum::Silhouette },
      { 'r', ScenePartEnum::Rays },     { 'r', ScenePartEnum::CentralRay }, { 'r', ScenePartEnum::Source }
    };
    for (const auto & kind : kinds)
    {
      if (kind.first == key)
      {
        renderer.Toggle(kind.second);
      }
    }
    if (key >= '1' && static_cast<std::size_t>(key - '1') < cameras.size())
    {
      const int * const size = window->GetSize();
      renderer.SetCamera(cameras[static_cast<std::size_t>(key - '1')], static_cast<double>(size[0]) / size[1]);
    }
  };
  interactor->SetInteractorStyle(style);
  window->Render();
  window->SetWindowName(m_Title.c_str());
  interactor->Start();
}

void
RegistrationSceneWindow::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Scene: " << m_Scene.GetPointer() << std::endl;
  os << indent << "Camera: " << m_Camera << std::endl;
  os << indent << "Size: " << m_Size[0] << " x " << m_Size[1] << std::endl;
  os << indent << "Title: " << m_Title << std::endl;
  os << indent << "ShowLegend: " << (m_ShowLegend ? "On" : "Off") << std::endl;
}
} // namespace itk

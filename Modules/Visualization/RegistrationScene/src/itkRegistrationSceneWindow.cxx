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

#include "itkDentalInputError.h"
#include "itkLowerCase.h"
#include "itkOutputFile.h"
#include "itkSceneRenderer.h"
#include "itkSceneToVTK.h"
#include "itkScreenConnection.h"
#include "itkStagingFolder.h"

#include <vtkErrorCode.h>
#include <vtkGLTFExporter.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVersion.h>
#include <vtkWindowToImageFilter.h>
#include <vtkXMLMultiBlockDataWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>

namespace itk
{
namespace
{
namespace fs = std::filesystem;

std::string
GetExtension(const fs::path & file)
{
  return LowerCase(file.extension().string());
}

/** VTK's own words for what kept a writer from writing; it says the rest in its window of messages. */
std::string
GetReason(unsigned long code)
{
  return code == vtkErrorCode::NoError ? std::string("VTK failed") : vtkErrorCode::GetStringFromErrorCode(code);
}

/** VTK makes single files in memory, where there is room, and from there they get to the disk whole. */
void
WriteFile(const std::string & fileName, const void * content, std::size_t size)
{
  if (size == 0)
  {
    itkGenericExceptionMacro(<< fileName << " cannot be written: VTK made nothing of the scene. Export it as .vtm.");
  }
  OutputFile file(fileName);
  file.Write(content, size);
  file.Commit();
}

/** Whether a folder holds blocks of an earlier export of this name, and nothing else: then it may be replaced. */
bool
HoldsBlocksOnly(const fs::path & folder)
{
  const std::string prefix = folder.filename().string() + '_';
  std::error_code   error;
  for (const auto & entry : fs::directory_iterator(folder, error))
  {
    const std::string extension = GetExtension(entry.path());
    if (!fs::is_regular_file(entry.symlink_status(error)) || entry.path().filename().string().rfind(prefix, 0) != 0 ||
        (extension != ".vtp" && extension != ".vti"))
    {
      return false;
    }
  }
  return !error;
}

/** Whether a file of VTK's ends as such a file does: its writer finds out of most disks that were full, not of all. */
bool
IsWhole(const fs::path & fileName)
{
  const std::string end = "</VTKFile>";
  constexpr long    tail = 64;
  std::ifstream     file(fileName, std::ios::binary | std::ios::ate);
  const long        size = file ? static_cast<long>(file.tellg()) : 0;
  const auto        length = std::min(size, tail);
  std::string       text(static_cast<std::size_t>(std::max(0L, length)), ' ');
  file.seekg(size - length);
  file.read(text.data(), length);
  return file && text.find(end) != std::string::npos;
}

/** A file and the folder of its blocks beside it take the place of those of an earlier export. Where one of the two
 * can't, neither does, and what was there is put back. */
void
Publish(const fs::path & staging, const fs::path & target, const fs::path & folder)
{
  const fs::path  old = staging / (folder.filename().string() + ".old");
  const fs::path  made = staging / folder.filename();
  std::error_code error;
  bool            isTakenAway = false;
  bool            isPublished = false;
  try
  {
    if (fs::exists(fs::symlink_status(folder, error)))
    {
      fs::rename(folder, old);
      isTakenAway = true;
    }
    if (fs::exists(made))
    {
      fs::rename(made, folder);
      isPublished = true;
    }
    fs::rename(staging / target.filename(), target);
  }
  catch (const fs::filesystem_error & failure)
  {
    if (isPublished)
    {
      fs::rename(folder, made, error);
    }
    if (isTakenAway)
    {
      fs::rename(old, folder, error);
    }
    itkDentalInputErrorMacro(
      target.u8string(), "", "cannot be written: " + failure.code().message(), "choose another name");
  }
}

/** VTK's blocks lie in a folder that is named as the file without its end: both are made aside, and appear whole. */
void
WriteBlocks(const std::string & fileName, const RegistrationScene & scene)
{
  const fs::path  target = fs::absolute(fs::u8path(fileName));
  const fs::path  folder = target.parent_path() / target.stem();
  std::error_code error;
  if (fs::exists(folder, error) && !HoldsBlocksOnly(folder))
  {
    itkDentalInputErrorMacro(fileName,
                             "",
                             "cannot be written: its blocks would replace " + folder.filename().u8string() +
                               ", which holds something else",
                             "choose another name");
  }
  const StagingFolder                staging(target.parent_path().string());
  const fs::path                     made = fs::path(staging.GetPath()) / target.filename();
  vtkNew<vtkXMLMultiBlockDataWriter> writer;
  writer->SetFileName(made.c_str());
  writer->SetInputData(SceneToVTK(scene));
  // What its parts have to say of a failure is said once, below.
  const int warnings = vtkObject::GetGlobalWarningDisplay();
  vtkObject::GlobalWarningDisplayOff();
  bool isWritten = writer->Write() == 1 && IsWhole(made);
  vtkObject::SetGlobalWarningDisplay(warnings);
  for (const auto & block : fs::directory_iterator(fs::path(staging.GetPath()) / target.stem(), error))
  {
    isWritten = isWritten && IsWhole(block.path());
  }
  if (!isWritten)
  {
    itkDentalInputErrorMacro(fileName,
                             "",
                             "cannot be written: " + GetReason(writer->GetErrorCode()),
                             "look for space on the disk and for a limit on the size of files (ulimit -f)");
  }
  Publish(staging.GetPath(), target, folder);
}

/** What VTK 9.1 leaves out of a glTF file: names, translucency, both sides of a surface, what is not lit, and glTF's
 * own metres and upward y. Points stay as they are, in mm of the scene's frame: a node above them turns and scales. */
std::string
CompleteGLTF(const std::string & text, const std::string & fileName, const RegistrationScene & scene)
{
  using Json = nlohmann::ordered_json;
  Json                           json = Json::parse(text);
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
  return json.dump();
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
  const std::string extension = GetExtension(fs::u8path(fileName));
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
  if (GetExtension(fs::u8path(fileName)) != ".png")
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
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray * const content = writer->GetResult();
  if (content == nullptr)
  {
    itkExceptionMacro(<< fileName << " cannot be written: " << GetReason(writer->GetErrorCode()) << '.');
  }
  WriteFile(fileName, content->GetPointer(0), static_cast<std::size_t>(content->GetNumberOfValues()));
}

void
RegistrationSceneWindow::WriteExport(const std::string & fileName) const
{
  this->VerifyScene();
  VerifyExportName(fileName);
  const std::string extension = GetExtension(fs::u8path(fileName));
  if (extension == ".vtm")
  {
    WriteBlocks(fileName, *m_Scene);
    return;
  }
  std::string content;
  if (extension == ".vtp")
  {
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(SceneToOnePolyData(*m_Scene));
    writer->WriteToOutputStringOn();
    content = writer->Write() == 1 ? writer->GetOutputString() : std::string();
  }
  else
  {
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
    content = CompleteGLTF(exporter->WriteToString(), fileName, *m_Scene);
  }
  WriteFile(fileName, content.data(), content.size());
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

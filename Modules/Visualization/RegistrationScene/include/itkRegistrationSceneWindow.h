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
#ifndef itkRegistrationSceneWindow_h
#define itkRegistrationSceneWindow_h

#include "RegistrationSceneVTKExport.h"
#include "itkRegistrationScene.h"

#include "itkObject.h"

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>
#include <vector>

namespace itk
{
class ScreenConnection;

/** \class RegistrationSceneWindow
 * \brief Shows a scene with VTK: in a window, as a picture, or as a file for other programs.
 *
 * Cameras: "overview" from before and above the patient with each detector behind the scans, "front", "side" (from
 * where the first source is), "above", "all" (as "overview", but with the sources, a metre and a half away), "source"
 * (what the first source sees), "teeth" (of that, what is around the scans), and the name of each view, from its
 * source. From a source one sees through the scans: each tracing lies on the teeth that it was drawn of.
 *
 * A window and a picture need an X server: VTK ends the program without one. Show() and WriteSnapshot() throw instead;
 * VirtualScreen is an X server for pictures. WriteExport() needs none. A camera decides what it shows of scans, frames
 * and rays; keys of the window change that.
 *
 * Errors (ExceptionObject): no scene, a camera that is not there, no X server, a file that cannot be written or whose
 * format is none of those below.
 *
 * \test itkRegistrationSceneWindowGTest.cxx
 * \ingroup RegistrationScene
 */
class RegistrationSceneVTK_EXPORT RegistrationSceneWindow : public Object
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(RegistrationSceneWindow);

  using Self = RegistrationSceneWindow;
  using Superclass = Object;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(RegistrationSceneWindow, Object);

  using SizeType = std::array<unsigned int, 2>;

  /** Up to date: call Update() of its source first. */
  itkSetConstObjectMacro(Scene, RegistrationScene);
  itkGetConstObjectMacro(Scene, RegistrationScene);

  /** Default "overview". */
  itkSetStringMacro(Camera);
  itkGetStringMacro(Camera);

  /** Those that the scene has. */
  std::vector<std::string>
  GetCameras() const;

  /** Width and height, pixels. Default 1200 x 900. */
  itkSetMacro(Size, SizeType);
  itkGetConstReferenceMacro(Size, SizeType);

  /** Of the window. Default "DentalSCR". */
  itkSetStringMacro(Title);
  itkGetStringMacro(Title);

  /** A name in each colour in the lower left corner. Default on. */
  itkSetMacro(ShowLegend, bool);
  itkGetConstMacro(ShowLegend, bool);
  itkBooleanMacro(ShowLegend);

  /** The scene as seen by the camera, as a PNG file that appears whole or not at all. */
  void
  WriteSnapshot(const std::string & fileName) const;

  /** By the name's end:
   * - .gltf: one file for Blender and viewers on the web, radiograph and colours included. It is VTK's own exporter's,
   *   with names and materials added; points are in mm, and a node above them makes glTF's metres and upward y of them.
   *   The binary .glb, which VTK 9.1 has not, is refused.
   * - .vtm: VTK's blocks (SceneToVTK()) in a folder beside the file, mm, for ParaView.
   * - .vtp: one surface (SceneToOnePolyData()), mm, for Slicer and ParaView.
   *
   * The file appears whole or not at all. */
  void
  WriteExport(const std::string & fileName) const;

  /** Throws what WriteExport() would for a name, without writing: a program can say so before it computes a scene. */
  static void
  VerifyExportName(const std::string & fileName);

  /** Opens a window and returns when it is closed. */
  void
  Show() const;

protected:
  RegistrationSceneWindow() = default;
  ~RegistrationSceneWindow() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  void
  VerifyScene() const;
  /** Throws unless it is open. */
  void
  VerifyScreen(const ScreenConnection & screen) const;

  RegistrationScene::ConstPointer m_Scene;
  std::string                     m_Camera{ "overview" };
  SizeType                        m_Size{ { 1200, 900 } };
  std::string                     m_Title{ "DentalSCR" };
  bool                            m_ShowLegend{ true };
};
} // namespace itk

#endif

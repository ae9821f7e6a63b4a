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
#ifndef itkRegistrationSceneSource_h
#define itkRegistrationSceneSource_h

#include "itkRegistrationScene.h"
#include "itkSceneView.h"

#include "itkProcessObject.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace itk
{
/** \class RegistrationSceneSource
 * \brief Builds the scene of a registration: registered scans, their frames, and a list of radiographs.
 *
 * Inputs: up to two scans (mm, the frame of their files), each with its place in the cephalostat frame and its dental
 * frame, and any number of views. Parts of the output, in this order:
 * - for each scan "upper scan", the axes "upper axis x" (y, z) of its UMDA frame, 20 mm long, and the two planes that
 *   the paper names, "upper midsagittal plane" (y = 0) and "upper axial plane" (z = 0), as large as the scan;
 * - for each view "lateral source", "lateral central ray", "lateral detector" with its radiograph, and for each jaw
 *   "lateral upper tracing", "lateral upper silhouette" and "lateral upper rays".
 *
 * The silhouette is the exact outer outline of the scan by MeshSilhouette, seen through the jaw's own projection, and
 * like the tracing it lies on the detector. Rays run from the source through the landmarks of a scan to the detector.
 *
 * Radiographs become eight-bit pictures, black and white at the half percent of darkest and brightest pixels, of at
 * most MaximumPictureSize pixels in width and height (means of blocks): what every graphics card takes, and enough to
 * see a tracing's error.
 *
 * Errors (ExceptionObject): no view and no scan, two views of one name, a projection without a source, a scan whose
 * place is not a rigid map, and what MeshSilhouette does not take.
 *
 * \test itkRegistrationSceneSourceGTest.cxx
 * \ingroup RegistrationScene
 */
class RegistrationScene_EXPORT RegistrationSceneSource : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(RegistrationSceneSource);

  using Self = RegistrationSceneSource;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(RegistrationSceneSource, ProcessObject);

  using MeshType = ScenePart::MeshType;
  using JawEnum = ToothCode::JawEnum;
  /** Row-major 3x4, rigid, mm. */
  using PlacementType = std::array<double, 12>;
  using OutputType = RegistrationScene;
  using Superclass::MakeOutput;
  using DataObjectPointer = Superclass::DataObjectPointer;
  using DataObjectPointerArraySizeType = Superclass::DataObjectPointerArraySizeType;

  /** A scan of triangles (mm) and where it is. Its point data, where it has them, are taken for FDI numbers. A null
   * mesh takes the jaw out. */
  void
  SetScan(JawEnum               jaw,
          const MeshType *      mesh,
          const PlacementType & meshToCephalostat,
          const PlacementType & meshToUMDA);
  const MeshType *
  GetScan(JawEnum jaw) const;

  /** Appends a radiograph. */
  void
  AddView(const SceneView & view);
  void
  ClearViews();
  const std::vector<SceneView> &
  GetViews() const
  {
    return m_Views;
  }

  /** Largest width and height of a radiograph's picture, pixels. Default 2048. */
  itkSetClampMacro(MaximumPictureSize, unsigned int, 16, 16384);
  itkGetConstMacro(MaximumPictureSize, unsigned int);
  /** The scene. */
  OutputType *
  GetOutput();
  const OutputType *
  GetOutput() const;

  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  RegistrationSceneSource();
  ~RegistrationSceneSource() override = default;
  void
  VerifyPreconditions() ITKv5_CONST override;
  /** A mesh has no spacing or origin that another could share. */
  void
  VerifyInputInformation() ITKv5_CONST override
  {}
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  struct ScanPlace
  {
    PlacementType meshToCephalostat{};
    PlacementType meshToUMDA{};
  };

  void
  AddJaw(JawEnum jaw, RegistrationScene::PartsType & parts) const;
  void
  AddViewParts(const SceneView & view, const SceneDetector & detector, RegistrationScene::PartsType & parts) const;

  std::map<JawEnum, ScanPlace> m_Places;
  std::vector<SceneView>       m_Views;
  unsigned int                 m_MaximumPictureSize{ 2048 };
};
} // namespace itk

#endif

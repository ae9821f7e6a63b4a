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
#ifndef itkLandmarkCounterpartFilter_h
#define itkLandmarkCounterpartFilter_h

#include "PoseRegistrationExport.h"
#include "itkCephalometricGeometry.h"
#include "itkCephalometricLandmarkSet.h"
#include "itkDentalLandmarkSet.h"
#include "itkDentalContour.h"
#include "itkLandmarkCounterpartSet.h"
#include "itkPoseSolution.h"

#include "itkDataObjectDecorator.h"
#include "itkMesh.h"
#include "itkProcessObject.h"
#include "itkVersorRigid3DTransform.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace itk
{
/** \class LandmarkCounterpartFilter
 * \brief Finds on the scans what a cephalometric analysis has marked on the radiograph.
 *
 * Of each landmark the first that there is: landmarks of the scan (SetScanLandmarks()), the labels of its teeth
 * (SetLabels()), its geometry: the incisal edge at the midline, a molar by its place along the arch after textbook
 * widths. Each has an error of its own, which widens the landmark's. A mesial contact and an occlusal middle, which
 * scan landmarks have no name for, are derived from the cusps.
 *
 * After a registration with a tracing of tooth codes a premolar or molar is found by the traced tooth of its code
 * instead of a textbook's width: the cusp, among those of the traced row, that comes to lie where the line has it, and
 * of the other side, which was not traced, the one as far along the arch among the same cusps. A cusp beside it that
 * will do nearly as well widens the error.
 *
 * Where a name tells no side, both teeth are looked for; where only one is found, the other's image may lie a way from
 * it, and the error says so. On a frontal radiograph (SetDirection()) both stand beside each other: there only a
 * central incisor's may do without a side, and is the middle of both. Apices are on no scan and have no counterpart;
 * GetUnused() lists them, and whatever else was not found, with the reason.
 *
 * Inputs: the landmarks; scans (mm), their frames (mesh to dental frame, as UMidlineDentalAxisFilter gives them), scan
 * landmarks in the meshes' frames (unit: MillimetresPerUnit). A jaw without a scan has no counterparts. Output: the
 * counterparts in their meshes' frames, mm.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT LandmarkCounterpartFilter : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(LandmarkCounterpartFilter);

  using Self = LandmarkCounterpartFilter;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(LandmarkCounterpartFilter, ProcessObject);

  using JawEnum = ToothCode::JawEnum;
  using LandmarksType = CephalometricLandmarkSet;
  using ScanLandmarksType = DentalLandmarkSet<3>;
  using MeshType = Mesh<float, 3>;
  using FrameType = DataObjectDecorator<VersorRigid3DTransform<double>>;
  using OutputType = LandmarkCounterpartSet;
  using LabelsType = std::vector<std::uint8_t>;
  /** Landmarks of the radiograph must be set. Scans (mm), their landmarks and frames: what is known of them. */
  itkSetInputMacro(CephalometricLandmarks, LandmarksType);
  itkGetInputMacro(CephalometricLandmarks, LandmarksType);
  itkSetInputMacro(ScanLandmarks, ScanLandmarksType);
  itkGetInputMacro(ScanLandmarks, ScanLandmarksType);
  itkSetInputMacro(UpperMesh, MeshType);
  itkGetInputMacro(UpperMesh, MeshType);
  itkSetInputMacro(LowerMesh, MeshType);
  itkGetInputMacro(LowerMesh, MeshType);
  itkSetInputMacro(UpperFrame, FrameType);
  itkGetInputMacro(UpperFrame, FrameType);
  itkSetInputMacro(LowerFrame, FrameType);
  itkGetInputMacro(LowerFrame, FrameType);

  /** What a registration found, and the tracings that it was of, continuous pixel indices of the same radiograph: with
   * both a posterior tooth that neither scan landmarks nor labels name is found by the traced tooth of its code. */
  itkSetInputMacro(Solution, PoseSolution);
  itkGetInputMacro(Solution, PoseSolution);
  itkSetInputMacro(UpperTracing, DentalContour);
  itkGetInputMacro(UpperTracing, DentalContour);
  itkSetInputMacro(LowerTracing, DentalContour);
  itkGetInputMacro(LowerTracing, DentalContour);
  /** Whether the tracings are the middle between both sides' images; off by default. */
  itkSetMacro(Bisected, bool);
  itkGetConstMacro(Bisected, bool);
  itkBooleanMacro(Bisected);

  /** FDI number by point of the mesh, 0 gingiva; empty: none. */
  void
  SetLabels(JawEnum jaw, const LabelsType & labels);
  const LabelsType &
  GetLabels(JawEnum jaw) const;

  /** Teeth that have no counterparts: a landmark of these alone is unused, of one of two sides the other one's. */
  void
  SetExcludedTeeth(const std::vector<ToothCode> & teeth);
  const std::vector<ToothCode> &
  GetExcludedTeeth() const
  {
    return m_ExcludedTeeth;
  }

  /** Of the scan landmarks; 1 by default. */
  itkSetMacro(MillimetresPerUnit, double);
  itkGetConstMacro(MillimetresPerUnit, double);
  /** Names of scan landmarks that are used for no tooth, since they lie elsewhere than their names say
   * (ScanCheckFilter::GetUnusableLandmarks()). */
  void
  SetUnusableLandmarks(const std::vector<std::string> & names);
  const std::vector<std::string> &
  GetUnusableLandmarks() const
  {
    return m_UnusableLandmarks;
  }

  /** The side in a name is ignored, as a standard tracing's is: "UR6_MB" is the middle as well. Off by default. */
  itkSetMacro(IgnoreSides, bool);
  itkGetConstMacro(IgnoreSides, bool);
  itkBooleanMacro(IgnoreSides);

  /** Of the radiograph; lateral by default. */
  using DirectionEnum = CephalometricGeometry::DirectionEnum;
  itkSetEnumMacro(Direction, DirectionEnum);
  itkGetEnumMacro(Direction, DirectionEnum);
  /** Where the landmarks are on the scans. */
  OutputType *
  GetOutput();
  const OutputType *
  GetOutput() const;

  /** A landmark that is not used, as its file calls it, and why. Valid after Update(). */
  struct UnusedType
  {
    std::string name;   /**< As its file calls it. */
    std::string reason; /**< In words for the person who marked it. */
  };
  const std::vector<UnusedType> &
  GetUnused() const
  {
    return m_Unused;
  } /**< What has no counterpart, and why. Valid after Update(). */

  using Superclass::MakeOutput;
  DataObject::Pointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  LandmarkCounterpartFilter();
  ~LandmarkCounterpartFilter() override = default;
  void
  VerifyInputInformation() ITKv5_CONST override
  {}
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  double                    m_MillimetresPerUnit{ 1.0 };
  std::vector<std::string>  m_UnusableLandmarks;
  bool                      m_IgnoreSides{ false };
  bool                      m_Bisected{ false };
  DirectionEnum             m_Direction{ DirectionEnum::Lateral };
  std::array<LabelsType, 2> m_Labels;
  std::vector<ToothCode>    m_ExcludedTeeth;
  std::vector<UnusedType>   m_Unused;
};
} // namespace itk

#endif

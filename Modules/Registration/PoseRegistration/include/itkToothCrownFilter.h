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
#ifndef itkToothCrownFilter_h
#define itkToothCrownFilter_h

#include "PoseRegistrationExport.h"

#include "itkDentalContour.h"
#include "itkDentalLandmarkSet.h"
#include "itkToothCode.h"
#include "itkToothCrownSet.h"

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
/** \class ToothCrownFilter
 * \brief Cuts the crowns of the teeth that an analysis has outlined out of the scans.
 *
 * Of each tooth with a code in a tracing, and of its fellow of the other side, as an analysis's outline is of neither
 * alone: by the labels of the scan's teeth (SetLabels()), else about the tooth's landmarks on the scan
 * (SetScanLandmarks()) or its place along the arch after textbook widths, as wide and as high as a crown is. How far
 * the cut may be from the crown is told with it. Labels that lack a tooth say that it is not there.
 *
 * Inputs: the tracings, of which only the codes are read; scans (mm), their frames (mesh to dental frame, as
 * UMidlineDentalAxisFilter gives them), scan landmarks in the meshes' frames (unit: MillimetresPerUnit). Output: the
 * crowns in their meshes' frames, mm; GetMissing() names teeth without one.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT ToothCrownFilter : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ToothCrownFilter);

  using Self = ToothCrownFilter;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(ToothCrownFilter, ProcessObject);

  using JawEnum = ToothCode::JawEnum;
  using ContourType = DentalContour;
  using ScanLandmarksType = DentalLandmarkSet<3>;
  using MeshType = Mesh<float, 3>;
  using FrameType = DataObjectDecorator<VersorRigid3DTransform<double>>;
  using OutputType = ToothCrownSet;
  using LabelsType = std::vector<std::uint8_t>;
  /** Outlines of teeth (continuous pixel indices) and scans (mm); frames and landmarks where they are known. */
  itkSetInputMacro(UpperContour, ContourType);
  itkGetInputMacro(UpperContour, ContourType);
  itkSetInputMacro(LowerContour, ContourType);
  itkGetInputMacro(LowerContour, ContourType);
  itkSetInputMacro(UpperMesh, MeshType);
  itkGetInputMacro(UpperMesh, MeshType);
  itkSetInputMacro(LowerMesh, MeshType);
  itkGetInputMacro(LowerMesh, MeshType);
  itkSetInputMacro(UpperFrame, FrameType);
  itkGetInputMacro(UpperFrame, FrameType);
  itkSetInputMacro(LowerFrame, FrameType);
  itkGetInputMacro(LowerFrame, FrameType);
  itkSetInputMacro(ScanLandmarks, ScanLandmarksType);
  itkGetInputMacro(ScanLandmarks, ScanLandmarksType);

  /** FDI number by point of the mesh, 0 gingiva; empty: none. */
  void
  SetLabels(JawEnum jaw, const LabelsType & labels);
  const LabelsType &
  GetLabels(JawEnum jaw) const;

  /** Teeth that are not cut out: a damaged or a rebuilt one. */
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
  /** A crown for each tooth that was outlined and is on a scan. */
  OutputType *
  GetOutput();
  const OutputType *
  GetOutput() const;

  /** Teeth of the tracings whose crowns were not found, excluded ones left out. Valid after Update(). */
  const std::vector<ToothCode> &
  GetMissing() const
  {
    return m_Missing;
  }

  using Superclass::MakeOutput;
  DataObject::Pointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  ToothCrownFilter();
  ~ToothCrownFilter() override = default;
  void
  VerifyInputInformation() ITKv5_CONST override
  {}
  void
  VerifyPreconditions() ITKv5_CONST override;
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  double                    m_MillimetresPerUnit{ 1.0 };
  std::vector<std::string>  m_UnusableLandmarks;
  std::array<LabelsType, 2> m_Labels;
  std::vector<ToothCode>    m_ExcludedTeeth;
  std::vector<ToothCode>    m_Missing;
};
} // namespace itk

#endif

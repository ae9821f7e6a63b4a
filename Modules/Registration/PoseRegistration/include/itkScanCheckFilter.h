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
#ifndef itkScanCheckFilter_h
#define itkScanCheckFilter_h

#include "PoseRegistrationExport.h"
#include "itkRegistrationFinding.h"

#include "itkDentalFrameObject.h"
#include "itkDentalLandmarkSet.h"
#include "itkMesh.h"
#include "itkProcessObject.h"
#include "itkSimpleDataObjectDecorator.h"

#include <string>
#include <vector>

namespace itk
{
/** \class ScanCheckFilter
 * \brief What can be said of the scans before anything is registered: a wrong unit, two jaws in one file, a quadrant,
 * exchanged jaws, a mirrored scan, single points that stand out of it, landmarks that lie elsewhere, a dental axis that
 * is unsure.
 *
 * Inputs: one or two scans (mm), everything that UMidlineDentalAxisFilter found of them (GetFrameOutput()), and, where
 * there are some, landmarks of the scans in the meshes' frames (MillimetresPerUnit says in what unit; 1: mm). Outputs:
 * the findings of each jaw, in the order in which they were looked for; a jaw without a scan has none.
 * GetNotCheckable() lists what these data could not tell.
 *
 * Specks in the air and points that no triangle has are not the scan: nothing is measured of them. Landmarks are judged
 * one by one, since a file of which a third is wrong is right in the median. Codes: \c same-scan, \c both-jaws, \c
 * spikes, \c partial-arch, \c arch-width, \c no-arch, \c unsure-axis, \c inward-winding, \c sides-exchanged, \c
 * jaws-exchanged, \c landmarks-off-scan, \c landmarks-coincide, \c landmarks-order (Documentation/Findings.md).
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT ScanCheckFilter : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ScanCheckFilter);

  using Self = ScanCheckFilter;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(ScanCheckFilter, ProcessObject);

  using JawEnum = ToothCode::JawEnum;
  using MeshType = Mesh<float, 3>;
  using LandmarksType = DentalLandmarkSet<3>;
  using FindingsType = std::vector<RegistrationFinding>;
  using DecoratedFindingsType = SimpleDataObjectDecorator<FindingsType>;
  using Superclass::MakeOutput;
  using DataObjectPointer = Superclass::DataObjectPointer;
  using DataObjectPointerArraySizeType = Superclass::DataObjectPointerArraySizeType;

  /** A landmark belongs to a scan that passes within this distance, mm: a marked tip may lie off the surface by a
   * vertex's distance or a click, and half a tooth away is the next landmark's place. */
  static constexpr double MaximumLandmarkDistance = 3.0;
  /** Landmarks no further apart than this are at one place, in any unit: what nobody has marked is left at the same
   * numbers, and what two clicks have marked never is. */
  static constexpr double SamePlace = 1e-9;

  /** Whether no other landmark of the same jaw is at a landmark's place. What a program leaves at (0, 0, 0) may happen
   * to lie on the scan. */
  static bool
  IsAlone(const LandmarksType & landmarks, const LandmarksType::LandmarkType & landmark);
  /** Scans (mm), what UMidlineDentalAxisFilter found of them, and landmarks of the scans where there are some. */
  itkSetInputMacro(UpperMesh, MeshType);
  itkGetInputMacro(UpperMesh, MeshType);
  itkSetInputMacro(LowerMesh, MeshType);
  itkGetInputMacro(LowerMesh, MeshType);
  itkSetInputMacro(Frames, DentalFrameObject);
  itkGetInputMacro(Frames, DentalFrameObject);
  itkSetInputMacro(Landmarks, LandmarksType);
  itkGetInputMacro(Landmarks, LandmarksType);

  /** Of the landmarks, and of the files that the meshes were read from: the unit that would fit is named by it. */
  itkSetMacro(MillimetresPerUnit, double);
  itkGetConstMacro(MillimetresPerUnit, double);
  /** What is odd about a jaw's scan; empty where nothing is. */
  DecoratedFindingsType *
  GetFindingsOutput(JawEnum jaw);
  /** Valid after Update(). */
  const FindingsType &
  GetFindings(JawEnum jaw);

  /** What the data could not tell, as sentences; valid after Update(). */
  const std::vector<std::string> &
  GetNotCheckable() const
  {
    return m_NotCheckable;
  }

  /** Names of landmarks that lie off their scan, at another one's place or at another tooth's, and are used by
   * nothing; valid after Update(). */
  const std::vector<std::string> &
  GetUnusableLandmarks() const
  {
    return m_UnusableLandmarks;
  }

  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  ScanCheckFilter();
  ~ScanCheckFilter() override = default;
  void
  VerifyPreconditions() ITKv5_CONST override;
  /** Meshes and frames are no images: there is no space to compare. */
  void
  VerifyInputInformation() ITKv5_CONST override
  {}
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  double                   m_MillimetresPerUnit{ 1.0 };
  std::vector<std::string> m_NotCheckable;
  std::vector<std::string> m_UnusableLandmarks;
};
} // namespace itk

#endif

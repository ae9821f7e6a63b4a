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
#include "itkToothCrownFilter.h"

#include "itkJawIndex.h"
#include "itkToothFinder.h"

#include <algorithm>
#include <set>

namespace itk
{
ToothCrownFilter::ToothCrownFilter()
{
  this->AddOptionalInputName("UpperContour", 0);
  this->AddOptionalInputName("LowerContour", 1);
  this->AddOptionalInputName("UpperMesh", 2);
  this->AddOptionalInputName("LowerMesh", 3);
  this->AddOptionalInputName("UpperFrame", 4);
  this->AddOptionalInputName("LowerFrame", 5);
  this->AddOptionalInputName("ScanLandmarks", 6);
  this->SetNumberOfRequiredInputs(0);
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
}

DataObject::Pointer
ToothCrownFilter::MakeOutput(DataObjectPointerArraySizeType)
{
  return OutputType::New().GetPointer();
}

void
ToothCrownFilter::SetLabels(JawEnum jaw, const LabelsType & labels)
{
  LabelsType & own = m_Labels[ToIndex(jaw)];
  if (own != labels)
  {
    own = labels;
    this->Modified();
  }
}

const ToothCrownFilter::LabelsType &
ToothCrownFilter::GetLabels(JawEnum jaw) const
{
  return m_Labels[ToIndex(jaw)];
}

void
ToothCrownFilter::SetExcludedTeeth(const std::vector<ToothCode> & teeth)
{
  if (m_ExcludedTeeth != teeth)
  {
    m_ExcludedTeeth = teeth;
    this->Modified();
  }
}

ToothCrownFilter::OutputType *
ToothCrownFilter::GetOutput()
{
  return itkDynamicCastInDebugMode<OutputType *>(this->ProcessObject::GetOutput(0));
}

const ToothCrownFilter::OutputType *
ToothCrownFilter::GetOutput() const
{
  return itkDynamicCastInDebugMode<const OutputType *>(this->ProcessObject::GetOutput(0));
}

void
ToothCrownFilter::VerifyPreconditions() ITKv5_CONST
{
  Superclass::VerifyPreconditions();
  const bool upper = this->GetUpperContour() != nullptr && this->GetUpperMesh() != nullptr;
  const bool lower = this->GetLowerContour() != nullptr && this->GetLowerMesh() != nullptr;
  if (!upper && !lower)
  {
    itkExceptionMacro("No jaw has both a scan and outlines: call SetUpperMesh() and SetUpperContour(), SetLowerMesh() "
                      "and SetLowerContour(), or both pairs.");
  }
  if ((upper && this->GetUpperFrame() == nullptr) || (lower && this->GetLowerFrame() == nullptr))
  {
    itkExceptionMacro(
      "A scan without its frame: call SetUpperFrame() and SetLowerFrame() with the transform outputs of "
      "UMidlineDentalAxisFilter.");
  }
}

void
ToothCrownFilter::SetUnusableLandmarks(const std::vector<std::string> & names)
{
  if (names != m_UnusableLandmarks)
  {
    m_UnusableLandmarks = names;
    this->Modified();
  }
}

void
ToothCrownFilter::GenerateData()
{
  OutputType * output = this->GetOutput();
  output->Initialize();
  m_Missing.clear();
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    const bool          upper = jaw == JawEnum::Upper;
    const ContourType * contour = upper ? this->GetUpperContour() : this->GetLowerContour();
    const MeshType *    mesh = upper ? this->GetUpperMesh() : this->GetLowerMesh();
    const FrameType *   frame = upper ? this->GetUpperFrame() : this->GetLowerFrame();
    if (contour == nullptr || mesh == nullptr || frame->Get() == nullptr)
    {
      continue;
    }
    std::set<std::uint8_t> teeth;
    for (const auto & polyline : contour->GetPolylines())
    {
      if (polyline.code.IsKnown())
      {
        teeth.insert(polyline.code.GetFDI());
        teeth.insert(polyline.code.GetContralateral().GetFDI());
      }
    }
    ToothFinder finder(mesh, frame->Get(), m_Labels[ToIndex(jaw)], this->GetScanLandmarks(), m_MillimetresPerUnit, jaw);
    finder.SetUnusableLandmarks(m_UnusableLandmarks);
    for (const std::uint8_t fdi : teeth)
    {
      const ToothCode tooth(fdi);
      if (std::find(m_ExcludedTeeth.begin(), m_ExcludedTeeth.end(), tooth) != m_ExcludedTeeth.end())
      {
        continue;
      }
      if (const auto crown = finder.FindCrown(tooth))
      {
        output->Add(*crown);
      }
      else
      {
        m_Missing.push_back(tooth);
      }
    }
  }
}

void
ToothCrownFilter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "MillimetresPerUnit: " << m_MillimetresPerUnit << std::endl;
  os << indent << "UnusableLandmarks: " << m_UnusableLandmarks.size() << std::endl;
  os << indent << "UpperLabels: " << m_Labels[0].size() << std::endl;
  os << indent << "LowerLabels: " << m_Labels[1].size() << std::endl;
  os << indent << "ExcludedTeeth: " << m_ExcludedTeeth.size() << std::endl;
  os << indent << "Missing: " << m_Missing.size() << std::endl;
}
} // namespace itk

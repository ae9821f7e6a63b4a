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
#include "itkCaseResultFileReader.h"

#include "itkCaseResultDocument.h"
#include "itkPoseGeometryConversion.h"
#include "itkRegistrationFinding.h"
#include "itkRigidTransformRows.h"
#include "itkValueSource.h"

#include <algorithm>
#include <string>

namespace itk
{
namespace
{
using JawEnum = ToothCode::JawEnum;

/** A status in its place, of which any other word is an error. */
RegistrationStatusEnum
ReadStatus(const JsonNode & node)
{
  for (const RegistrationStatusEnum status :
       { RegistrationStatusEnum::Ok, RegistrationStatusEnum::Suspect, RegistrationStatusEnum::Failed })
  {
    if (node.AsString() == ToString(status))
    {
      return status;
    }
  }
  node.Fail("\"" + node.AsString() + "\" is no status (\"ok\", \"suspect\" or \"failed\")", "register the case again");
}
} // namespace

CaseResultFileReader::CaseResultFileReader()
{
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
}

CaseResultFileReader::DataObjectPointer
CaseResultFileReader::MakeOutput(DataObjectPointerArraySizeType)
{
  return PoseSolution::New().GetPointer();
}

PoseSolution *
CaseResultFileReader::GetOutput()
{
  return itkDynamicCastInDebugMode<PoseSolution *>(this->ProcessObject::GetOutput(0));
}

void
CaseResultFileReader::VerifyPreconditions() ITKv5_CONST
{
  Superclass::VerifyPreconditions();
  if (m_FileName.empty())
  {
    itkExceptionMacro("No file to read. Call SetFileName() first.");
  }
}

void
CaseResultFileReader::GenerateData()
{
  const CaseResultDocument document =
    m_Text.empty() ? CaseResultDocument(m_FileName) : CaseResultDocument(m_FileName, m_Text);
  const JsonNode view = document.GetView(m_ViewName);
  const JsonNode firstJaws = document.GetRoot().Get("jaws");
  m_Status.fill("");
  PoseRegistrationResult result;
  const auto             geometry = view.Get("geometry");
  result.geometry = ToPoseGeometry(*CaseResultDocument::ReadGeometry(geometry));
  const auto isKnown = [&geometry](const char * key) {
    return geometry.Get(key).Get("source").AsString() != ToString(ValueSourceEnum::Estimated);
  };
  result.geometry.pixelSpacingKnown = isKnown("pixel_spacing_mm");
  result.geometry.principalPointKnown = isKnown("principal_point_px");
  m_MillimetresPerUnit = document.GetMillimetresPerUnit();
  const auto jaws = view.Get("jaws");
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    const auto node = jaws.Find(ToString(jaw));
    if (!node)
    {
      continue;
    }
    PoseJawResult own;
    own.jaw = jaw;
    own.registered = node->Find("projection_3x4").has_value();
    // A view's status is of all that was drawn on it; a jaw has its own from the first radiograph.
    RegistrationStatusEnum status = ReadStatus(firstJaws.Get(ToString(jaw)).Get("status"));
    if (const auto ofView = view.Find("status"))
    {
      status = std::max(status, ReadStatus(*ofView));
    }
    m_Status[jaw == JawEnum::Upper ? 0 : 1] = ToString(status);
    result.groupOfJaw.push_back(result.groups.size());
    if (!own.registered)
    {
      own.failure = "see its reasons in " + document.GetFileName();
      result.jaws.push_back(own);
      continue;
    }
    if (!node->Find("pose"))
    {
      node->Fail("has no \"pose\": its preset knows none, or it is of an earlier version",
                 "register the case again with preset robust");
    }
    const auto pose = node->Get("pose");
    own.frame = ToPoseFrame(CaseResultDocument::ReadMatrix<3, 4>(pose.Get("mesh_to_dental_mm"), "[r, r, r, t]"));
    own.projection = CaseResultDocument::ReadMatrix<3, 4>(node->Get("projection_3x4"), "[p, p, p, p]");
    const auto placement = CaseResultDocument::ReadMatrix<3, 4>(node->Get("mesh_to_cephalostat_mm"), "[r, r, r, t]");
    SplitRigidTransformRows(placement, own.rotation, own.translation);
    for (unsigned int i = 0; i < 12; ++i)
    {
      own.projection[i] /= i % 4 < 3 ? m_MillimetresPerUnit : 1.0;
    }
    own.placedByOther = node->Find("placed_by").has_value();
    PoseGroupResult group;
    group.jaws = { result.jaws.size() };
    const auto parameters = pose.Get("parameters").AsNumbers(7, "[pitch, roll, yaw, x, y, z, kappa]");
    std::copy(parameters.begin(), parameters.end(), group.parameters.begin());
    group.covariance = CaseResultDocument::ReadMatrix<7, 7>(pose.Get("covariance"), "a row of seven");
    result.groups.push_back(group);
    result.jaws.push_back(own);
  }
  this->GetOutput()->SetResult(result, PoseRegistrationOptions());
}

void
CaseResultFileReader::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << m_FileName << std::endl;
  os << indent << "Text: " << m_Text.size() << " bytes" << std::endl;
  os << indent << "ViewName: " << m_ViewName << std::endl;
  os << indent << "Status: " << m_Status[0] << ' ' << m_Status[1] << std::endl;
  os << indent << "MillimetresPerUnit: " << m_MillimetresPerUnit << std::endl;
}
} // namespace itk

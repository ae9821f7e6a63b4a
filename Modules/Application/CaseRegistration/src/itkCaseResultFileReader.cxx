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

#include "itkDentalCaseFileReader.h"
#include "itkDentalInputError.h"
#include "itkJsonDocument.h"

#include <filesystem>
#include <stdexcept>

namespace itk
{
namespace
{
using JawEnum = ToothCode::JawEnum;
namespace fs = std::filesystem;

constexpr char Schema[] = "dentalscr-result/1";

template <std::size_t VRows, std::size_t VColumns>
std::array<double, VRows * VColumns>
ReadMatrix(const JsonNode & node, const char * form)
{
  std::array<double, VRows * VColumns> matrix{};
  if (node.GetSize() != VRows)
  {
    node.Fail("has " + std::to_string(node.GetSize()) + " rows, not " + std::to_string(VRows),
              "register the case again");
  }
  for (std::size_t row = 0; row < VRows; ++row)
  {
    const std::vector<double> numbers = node.At(row).AsNumbers(VColumns, form);
    std::copy(numbers.begin(), numbers.end(), matrix.begin() + static_cast<std::ptrdiff_t>(VColumns * row));
  }
  return matrix;
}

PoseGeometry
ReadGeometry(const JsonNode & node)
{
  const auto isRight = [&](const char * key) {
    const std::string word = node.Get(key).Get("value").AsString();
    if (word != "right" && word != "left")
    {
      node.Get(key).Get("value").Fail("is \"" + word + "\"", "it is right or left");
    }
    return word == "right";
  };
  PoseGeometry geometry;
  geometry.sourceToMidsagittal = node.Get("source_to_midsagittal_mm").Get("value").AsNumber();
  geometry.sourceToDetector = node.Get("source_to_detector_mm").Get("value").AsNumber();
  geometry.sourceSign = isRight("source_side") ? 1.0 : -1.0;
  geometry.facingSign = isRight("facing") ? 1.0 : -1.0;
  const auto spacing = node.Get("pixel_spacing_mm").Get("value").AsNumbers(2, "[u, v]");
  const auto principal = node.Get("principal_point_px").Get("value").AsNumbers(2, "[u, v]");
  for (unsigned int d = 0; d < 2; ++d)
  {
    if (!(spacing[d] > 0.0))
    {
      node.Get("pixel_spacing_mm").Get("value").Fail("is not above 0", "register the case again");
    }
    geometry.pixelSpacing[d] = spacing[d];
    geometry.principalPoint[d] = principal[d];
  }
  geometry.pixelSpacingKnown = node.Get("pixel_spacing_mm").Get("source").AsString() != "estimated";
  geometry.principalPointKnown = node.Get("principal_point_px").Get("source").AsString() != "estimated";
  return geometry;
}

/** q = R (p - o) from q = R p + t: o = -R' t. */
PoseFrame
ReadFrame(const JsonNode & node)
{
  const auto rows = ReadMatrix<3, 4>(node, "[r, r, r, t]");
  PoseFrame  frame;
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 3; ++column)
    {
      frame.rotation[3 * row + column] = rows[4 * row + column];
      frame.origin[column] -= rows[4 * row + column] * rows[4 * row + 3];
    }
  }
  return frame;
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
  std::error_code   error;
  const fs::path    path = fs::u8path(m_FileName);
  const std::string fileName = fs::is_directory(path, error) ? (path / "result.json").string() : m_FileName;
  const auto        root = JsonDocument::ReadFile(fileName).GetRoot();
  const auto        schema = root.Find("schema");
  if (!schema || !schema->IsString())
  {
    itkDentalInputErrorMacro(
      fileName, "schema", "missing: this is no result of dentalscr", "name a result.json, or the folder that has one");
  }
  if (schema->AsString() != Schema)
  {
    schema->Fail("is \"" + schema->AsString() + "\", and this version reads \"" + Schema + "\"",
                 "register the case again");
  }
  m_Status.fill("");
  PoseRegistrationResult result;
  result.geometry = ReadGeometry(root.Get("geometry"));
  m_MillimetresPerUnit = 1.0;
  if (const auto unit = root.Find("mesh_unit"))
  {
    try
    {
      m_MillimetresPerUnit = MillimetresPerUnitFromString(unit->AsString());
    }
    catch (const std::invalid_argument & problem)
    {
      unit->Fail(problem.what(), "register the case again");
    }
  }
  const auto jaws = root.Get("jaws");
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    const auto node = jaws.Find(jaw == JawEnum::Upper ? "upper" : "lower");
    if (!node)
    {
      continue;
    }
    PoseJawResult own;
    own.jaw = jaw;
    own.registered = node->Find("projection_3x4").has_value();
    m_Status[jaw == JawEnum::Upper ? 0 : 1] = node->Get("status").AsString();
    result.groupOfJaw.push_back(result.groups.size());
    if (!own.registered)
    {
      own.failure = "see its reasons in " + fileName;
      result.jaws.push_back(own);
      continue;
    }
    if (!node->Find("pose"))
    {
      node->Fail("has no \"pose\": its preset knows none, or it is of an earlier version",
                 "register the case again with preset robust");
    }
    const auto pose = node->Get("pose");
    own.frame = ReadFrame(pose.Get("mesh_to_dental_mm"));
    own.projection = ReadMatrix<3, 4>(node->Get("projection_3x4"), "[p, p, p, p]");
    const auto placement = ReadMatrix<3, 4>(node->Get("mesh_to_cephalostat_mm"), "[r, r, r, t]");
    for (unsigned int row = 0; row < 3; ++row)
    {
      own.translation[row] = placement[4 * row + 3];
      for (unsigned int column = 0; column < 3; ++column)
      {
        own.rotation[3 * row + column] = placement[4 * row + column];
        own.projection[4 * row + column] /= m_MillimetresPerUnit;
      }
    }
    own.placedByOther = node->Find("placed_by").has_value();
    PoseGroupResult group;
    group.jaws = { result.jaws.size() };
    const auto parameters = pose.Get("parameters").AsNumbers(7, "[pitch, roll, yaw, x, y, z, kappa]");
    std::copy(parameters.begin(), parameters.end(), group.parameters.begin());
    group.covariance = ReadMatrix<7, 7>(pose.Get("covariance"), "a row of seven");
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
  os << indent << "Status: " << m_Status[0] << ' ' << m_Status[1] << std::endl;
  os << indent << "MillimetresPerUnit: " << m_MillimetresPerUnit << std::endl;
}
} // namespace itk

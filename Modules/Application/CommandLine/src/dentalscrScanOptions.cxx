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
#include "dentalscrScanOptions.h"

#include "itkDentalCaseFileReader.h"
#include "itkDentalCaseLoader.h"
#include "itkDentalInputError.h"
#include "itkJsonDocument.h"
#include "itkMakeDentalFrameTransform.h"
#include "itkRigidTransformRows.h"

#include <iostream>

namespace dentalscr
{
namespace
{
using JawEnum = itk::ToothCode::JawEnum;
using GeometryType = itk::CephalometricGeometry;

std::array<double, 12>
ReadMatrix(const itk::JsonNode & node)
{
  std::array<double, 12> matrix{};
  for (std::size_t row = 0; row < 3; ++row)
  {
    const std::vector<double> numbers = node.At(row).AsNumbers(4, "[r, r, r, t]");
    std::copy(numbers.begin(), numbers.end(), matrix.begin() + 4 * row);
  }
  return matrix;
}
} // namespace

void
ScanOptions::AddTo(CLI::App * command, bool withGeometry)
{
  auto * caseFile = command->add_option("--case", m_CaseFile, "Take scans and geometry from a case file");
  command->add_option("--upper", m_Upper, "Upper scan (STL, PLY, OBJ, OFF)")->excludes(caseFile);
  command->add_option("--lower", m_Lower, "Lower scan")->excludes(caseFile);
  command->add_option("--mesh-unit", m_MeshUnit, "Unit of the scans: mm, cm, inch, m or um (default mm)")
    ->excludes(caseFile);
  command->add_option("--occlusion", m_Occlusion, "Jaws in one frame: true, false or check (default check)");
  if (withGeometry)
  {
    command->add_option("--spacing", m_PixelSpacing, "Pixel spacing in the detector plane, mm: u v")->expected(2);
    command->add_option("--facing", m_Facing, "Where the face looks in the image")
      ->check(CLI::IsMember({ "right", "left" }));
    command->add_option("--source-side", m_SourceSide, "The patient's side at which the source is")
      ->check(CLI::IsMember({ "right", "left" }));
    command
      ->add_option("--distances", m_Distances, "Source to midsagittal plane and to detector, mm (default 1524 1674)")
      ->expected(2);
  }
}

std::shared_ptr<itk::DentalCaseData>
ScanOptions::Load() const
{
  itk::DentalCase description;
  if (!m_CaseFile.empty())
  {
    description = itk::ReadDentalCase(m_CaseFile);
  }
  else
  {
    description.fileName = "command line";
    description.upperFile = m_Upper;
    description.lowerFile = m_Lower;
    if (m_Upper.empty() && m_Lower.empty())
    {
      itkDentalInputErrorMacro("command line", "--upper", "no scan is named", "give --case, --upper or --lower");
    }
  }
  try
  {
    if (!m_MeshUnit.empty())
    {
      description.meshUnit = m_MeshUnit;
      description.millimetresPerUnit = itk::MillimetresPerUnitFromString(m_MeshUnit);
    }
    if (!m_Occlusion.empty())
    {
      description.occlusion = itk::OcclusionFromString(m_Occlusion);
    }
  }
  catch (const std::invalid_argument & error)
  {
    itkDentalInputErrorMacro("command line", "", error.what(), "see --help");
  }
  if (m_PixelSpacing.size() == 2)
  {
    if (!(m_PixelSpacing[0] > 0.001 && m_PixelSpacing[1] > 0.001 && m_PixelSpacing[0] < 5.0 && m_PixelSpacing[1] < 5.0))
    {
      itkDentalInputErrorMacro("command line", "--spacing", "is not possible", "give mm a pixel, about 0.1 to 0.3");
    }
    description.pixelSpacing = { { m_PixelSpacing[0], m_PixelSpacing[1] } };
    description.spacingAtMidsagittalPlane = false;
  }
  if (!m_Facing.empty())
  {
    description.facing = m_Facing == "left" ? GeometryType::FacingEnum::Left : GeometryType::FacingEnum::Right;
  }
  if (!m_SourceSide.empty())
  {
    description.sourceSide =
      m_SourceSide == "left" ? GeometryType::SourceSideEnum::Left : GeometryType::SourceSideEnum::Right;
  }
  if (m_Distances.size() == 2)
  {
    description.sourceToMidsagittal = m_Distances[0];
    description.sourceToDetector = m_Distances[1];
  }
  return itk::LoadDentalCase(description);
}

ScanFrames
FindFrames(const itk::DentalCaseData & data, bool refineMidline)
{
  ScanFrames found{ ScanFrames::AxisType::New(), itk::ScanCheckFilter::New() };
  found.axis->SetUpperMesh(data.upper.mesh);
  found.axis->SetLowerMesh(data.lower.mesh);
  found.axis->SetJawsShareFrame(itk::ToJawsShareFrame(data.description.occlusion));
  found.axis->SetRefineMidline(refineMidline);
  // The checks say more of a scan without an arch than the axis can.
  found.axis->RequireArchesOff();
  found.checks->SetUpperMesh(data.upper.mesh);
  found.checks->SetLowerMesh(data.lower.mesh);
  found.checks->SetFrames(found.axis->GetFrameOutput());
  found.checks->SetLandmarks(data.landmarks3D);
  found.checks->SetMillimetresPerUnit(data.description.millimetresPerUnit);
  found.checks->Update();
  for (const std::string & warning : data.warnings)
  {
    std::cerr << "dentalscr: warning: " << warning << '\n';
  }
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    for (const itk::RegistrationFinding & finding : found.checks->GetFindings(jaw))
    {
      std::cerr << "dentalscr: " << jaw << ": " << itk::ToString(finding.severity) << ": " << finding.text << '\n';
    }
  }
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    const bool isUpper = jaw == JawEnum::Upper;
    if (data.GetJaw(jaw).mesh.IsNotNull() &&
        !(isUpper ? found.axis->GetFrame().upper : found.axis->GetFrame().lower).valid)
    {
      itkDentalInputErrorMacro(isUpper ? data.description.upperFile : data.description.lowerFile,
                               "",
                               "has no recognisable dental arch",
                               "check the file and --mesh-unit");
    }
  }
  return found;
}

GeometryType::Pointer
PlaceJaw(const itk::DentalCaseData &    data,
         JawEnum                        jaw,
         const itk::DentalFrameResult & frames,
         const std::string &            resultFile)
{
  auto geometry = GeometryType::New();
  geometry->CopyParameters(data.geometry);
  GeometryType::RotationType rotation;
  GeometryType::VectorType   translation;
  if (resultFile.empty())
  {
    // Jaws in one frame keep their relation to each other.
    const itk::DentalJawFrame & own = frames.GetJaw(jaw);
    const itk::DentalJawFrame & frame = frames.jawsShareFrame && frames.joint.valid ? frames.joint : own;
    const auto                  transform = itk::MakeDentalFrameTransform(frame.axes, frame.origin);
    rotation = transform->GetMatrix();
    translation = transform->GetTranslation();
    GeometryType::PixelIndexType principal;
    principal.Fill(0.0);
    geometry->SetPrincipalPoint(principal);
  }
  else
  {
    const auto root = itk::JsonDocument::ReadFile(resultFile).GetRoot();
    const auto node = root.Get("jaws").Get(itk::ToString(jaw));
    const auto matrix = ReadMatrix(node.Get("mesh_to_cephalostat_mm"));
    itk::SplitRigidTransformRows(matrix, rotation, translation);
    const auto spacing = root.Get("geometry").Get("pixel_spacing_mm").Get("value").AsNumbers(2, "[u, v]");
    const auto point = root.Get("geometry").Get("principal_point_px").Get("value").AsNumbers(2, "[u, v]");
    GeometryType::PixelSpacingType pixelSpacing;
    GeometryType::PixelIndexType   principal;
    for (unsigned int d = 0; d < 2; ++d)
    {
      pixelSpacing[d] = spacing[d];
      principal[d] = point[d];
    }
    geometry->SetPixelSpacing(pixelSpacing);
    geometry->SetPrincipalPoint(principal);
  }
  geometry->SetPose(rotation, translation);
  if (!geometry->HasPixelSpacing())
  {
    itkDentalInputErrorMacro(
      data.description.fileName, "--spacing", "the pixel spacing is unknown", "give mm a pixel in the detector plane");
  }
  return geometry;
}
} // namespace dentalscr

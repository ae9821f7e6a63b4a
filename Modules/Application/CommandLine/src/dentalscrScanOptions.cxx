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
#include "itkFirstViewName.h"
#include "itkMakeDentalFrameTransform.h"
#include "itkMillimetresPerUnit.h"
#include "itkReadPlacedGeometry.h"

#include <iostream>

namespace dentalscr
{
namespace
{
using JawEnum = itk::ToothCode::JawEnum;
using GeometryType = itk::CephalometricGeometry;
} // namespace

void
ScanOptions::AddTo(CLI::App * command, bool withGeometry)
{
  auto * caseFile =
    command->add_option("--case", m_CaseFile, "Take scans and geometry from a case file")->type_name("FILE");
  command->add_option("--upper", m_Upper, "Upper scan (STL, PLY, OBJ, OFF)")->type_name("FILE")->excludes(caseFile);
  command->add_option("--lower", m_Lower, "Lower scan")->type_name("FILE")->excludes(caseFile);
  command->add_option("--mesh-unit", m_MeshUnit, "Unit of the scans: mm, cm, inch, m or um (default mm)")
    ->type_name("{mm,cm,inch,m,um}")
    ->excludes(caseFile);
  command->add_option("--occlusion", m_Occlusion, "Jaws in one frame: true, false or check (default check)")
    ->type_name("{true,false,check}");
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

void
AddViewOption(CLI::App * command, std::string & view)
{
  command->add_option("--view", view, "A further view of the case, by its name, instead of the lateral one")
    ->type_name("NAME");
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

const itk::DentalRadiographData &
FindView(const itk::DentalCaseData & data, const std::string & name)
{
  if (name.empty() || name == itk::FirstViewName)
  {
    return data;
  }
  std::string names = itk::FirstViewName;
  for (const itk::DentalViewData & view : data.views)
  {
    if (view.description.name == name)
    {
      return view;
    }
    names += ", " + view.description.name;
  }
  itkDentalInputErrorMacro(
    data.description.fileName, "--view", "there is no view \"" + name + '"', "name one that is there: " + names);
}

GeometryType::Pointer
PlaceJaw(const itk::DentalCaseData &    data,
         JawEnum                        jaw,
         const itk::DentalFrameResult & frames,
         const std::string &            resultFile,
         const std::string &            view)
{
  const GeometryType & ofCase = *FindView(data, view).geometry;
  if (!resultFile.empty())
  {
    return itk::ReadPlacedGeometry(resultFile, jaw, view == itk::FirstViewName ? std::string() : view);
  }
  auto geometry = GeometryType::New();
  geometry->CopyParameters(&ofCase);
  // Jaws in one frame keep their relation to each other.
  const itk::DentalJawFrame &  own = frames.GetJaw(jaw);
  const itk::DentalJawFrame &  frame = frames.jawsShareFrame && frames.joint.valid ? frames.joint : own;
  const auto                   transform = itk::MakeDentalFrameTransform(frame.axes, frame.origin);
  GeometryType::PixelIndexType principal;
  principal.Fill(0.0);
  geometry->SetPrincipalPoint(principal);
  geometry->SetPose(transform->GetMatrix(), transform->GetTranslation());
  if (!geometry->HasPixelSpacing())
  {
    itkDentalInputErrorMacro(
      data.description.fileName, "--spacing", "the pixel spacing is unknown", "give mm a pixel in the detector plane");
  }
  return geometry;
}
} // namespace dentalscr

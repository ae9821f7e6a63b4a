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
#include "itkCaseResultDocument.h"

#include "itkDentalCaseFileReader.h"
#include "itkDentalInputError.h"
#include "itkDescribePlainly.h"
#include "itkFirstViewName.h"
#include "itkTextFile.h"

#include <stdexcept>
#include <system_error>
#include <vector>

namespace itk
{
namespace fs = std::filesystem;

namespace
{
bool
IsRight(const JsonNode & geometry, const char * key)
{
  const auto          node = geometry.Get(key).Get("value");
  const std::string & word = node.AsString();
  if (word != "right" && word != "left")
  {
    node.Fail("is \"" + word + "\"", "it is right or left");
  }
  return word == "right";
}
} // namespace

CaseResultDocument::CaseResultDocument(const std::string & name)
{
  std::error_code error;
  const fs::path  path = fs::u8path(name);
  m_FileName = fs::is_directory(path, error) ? (path / "result.json").u8string() : name;
  m_Folder = fs::absolute(fs::u8path(m_FileName)).parent_path();
  m_Text = ReadTextFile(m_FileName, "a result");
  this->Parse();
}

CaseResultDocument::CaseResultDocument(const std::string & name, const std::string & text)
  : m_FileName(name)
  , m_Folder(fs::current_path())
  , m_Text(text)
{
  this->Parse();
}

void
CaseResultDocument::Parse()
{
  m_Root = JsonDocument::Parse(m_Text, m_FileName).GetRoot();
  const auto schema = m_Root->IsObject() ? m_Root->Find("schema") : std::nullopt;
  if (!schema || !schema->IsString())
  {
    itkDentalInputErrorMacro(m_FileName,
                             "schema",
                             "missing: this is no result of dentalscr",
                             "name a result.json, or the folder that has one");
  }
  if (schema->AsString() != Schema)
  {
    schema->Fail("is \"" + schema->AsString() + "\", and this version reads \"" + Schema + "\"",
                 "register the case again");
  }
}

JsonNode
CaseResultDocument::GetView(const std::string & name) const
{
  if (name.empty() || name == FirstViewName)
  {
    return *m_Root;
  }
  const auto views = m_Root->Find("views");
  if (const auto view = views ? views->Find(name) : std::nullopt)
  {
    return *view;
  }
  std::string names = FirstViewName;
  if (views)
  {
    for (const auto & member : views->GetMembers())
    {
      names += ", " + member.first;
    }
  }
  itkDentalInputErrorMacro(m_FileName,
                           "views." + name,
                           "missing: the case was registered without this view",
                           "name one that was registered (" + names + "), or register the case again");
}

double
CaseResultDocument::GetMillimetresPerUnit() const
{
  const auto unit = m_Root->Find("mesh_unit");
  if (!unit)
  {
    return 1.0;
  }
  try
  {
    return MillimetresPerUnitFromString(unit->AsString());
  }
  catch (const std::invalid_argument & problem)
  {
    unit->Fail(problem.what(), "register the case again");
  }
}

std::string
CaseResultDocument::GetInputPath(const std::string & field) const
{
  const auto inputs = m_Root->Find("inputs");
  const auto input = inputs ? inputs->Find(field) : std::nullopt;
  // A result that is to be anonymous has no paths.
  const auto path = input ? input->Find("path") : std::nullopt;
  return path ? path->AsString() : std::string();
}

std::string
CaseResultDocument::FindInput(const std::string & field) const
{
  const std::string name = this->GetInputPath(field);
  if (name.empty())
  {
    return {};
  }
  std::vector<fs::path> places;
  const std::string     caseName = this->GetInputPath("case");
  if (field != "case" && !caseName.empty())
  {
    // As the case file names it.
    const std::string caseFile = this->FindInput("case");
    places.push_back((caseFile.empty() ? fs::u8path(caseName) : fs::path(caseFile)).parent_path());
  }
  else
  {
    // From the directory that the program was started in.
    places.emplace_back();
  }
  places.push_back(m_Folder);
  places.push_back(m_Folder.parent_path());
  for (const fs::path & place : places)
  {
    std::error_code error;
    const fs::path  file = place / fs::u8path(name);
    if (fs::is_regular_file(file, error))
    {
      return file.string();
    }
  }
  return {};
}

CephalometricGeometry::Pointer
CaseResultDocument::ReadGeometry(const JsonNode & node)
{
  using GeometryType = CephalometricGeometry;
  auto       geometry = GeometryType::New();
  const bool isFrontal = node.Find("source_to_midcoronal_mm").has_value();
  geometry->SetSourceToDetectorDistance(node.Get("source_to_detector_mm").Get("value").AsNumber());
  geometry->SetSourceToMidsagittalDistance(
    node.Get(isFrontal ? "source_to_midcoronal_mm" : "source_to_midsagittal_mm").Get("value").AsNumber());
  if (isFrontal)
  {
    geometry->SetDirection(GeometryType::DirectionEnum::Frontal);
    const auto          source = node.Get("source").Get("value");
    const std::string & word = source.AsString();
    if (word != "front" && word != "behind")
    {
      source.Fail("is \"" + word + "\"", "it is front or behind");
    }
    geometry->SetFrontalSource(word == "front" ? GeometryType::FrontalSourceEnum::InFront
                                               : GeometryType::FrontalSourceEnum::Behind);
    geometry->SetPatientLeft(IsRight(node, "patient_left") ? GeometryType::PatientLeftEnum::Right
                                                           : GeometryType::PatientLeftEnum::Left);
  }
  else
  {
    geometry->SetSourceSide(IsRight(node, "source_side") ? GeometryType::SourceSideEnum::Right
                                                         : GeometryType::SourceSideEnum::Left);
    geometry->SetFacing(IsRight(node, "facing") ? GeometryType::FacingEnum::Right : GeometryType::FacingEnum::Left);
  }
  const auto                     spacing = node.Get("pixel_spacing_mm").Get("value");
  const auto                     lengths = spacing.AsNumbers(2, "[u, v]");
  const auto                     principal = node.Get("principal_point_px").Get("value").AsNumbers(2, "[u, v]");
  GeometryType::PixelSpacingType pixelSpacing;
  GeometryType::PixelIndexType   principalPoint;
  for (unsigned int d = 0; d < 2; ++d)
  {
    if (!(lengths[d] > 0.0))
    {
      spacing.Fail("is not above 0", "register the case again");
    }
    pixelSpacing[d] = lengths[d];
    principalPoint[d] = principal[d];
  }
  geometry->SetPixelSpacing(pixelSpacing);
  geometry->SetPrincipalPoint(principalPoint);
  try
  {
    geometry->VerifyComplete();
  }
  catch (const ExceptionObject & problem)
  {
    node.Fail(DescribePlainly(problem), "register the case again");
  }
  return geometry;
}
} // namespace itk

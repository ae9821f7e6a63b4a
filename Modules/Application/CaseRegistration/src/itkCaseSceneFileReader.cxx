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
#include "itkCaseSceneFileReader.h"

#include "itkCaseScene.h"
#include "itkCaseViews.h"
#include "itkDentalCaseFileReader.h"
#include "itkDentalCaseLoader.h"
#include "itkDentalInputError.h"
#include "itkDescribePlainly.h"
#include "itkJsonDocument.h"
#include "itkReadDentalMesh.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <utility>

namespace itk
{
namespace
{
using JawEnum = ToothCode::JawEnum;
using RowsType = std::array<double, 12>;
namespace fs = std::filesystem;

constexpr char     Schema[] = "dentalscr-result/1";
constexpr RowsType Identity{ { 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0 } };

RowsType
ReadRows(const JsonNode & node)
{
  RowsType rows{};
  if (node.GetSize() != 3)
  {
    node.Fail("has " + std::to_string(node.GetSize()) + " rows, not 3", "register the case again");
  }
  for (std::size_t row = 0; row < 3; ++row)
  {
    const auto numbers = node.At(row).AsNumbers(4, "a row of four");
    std::copy(numbers.begin(), numbers.end(), rows.begin() + static_cast<std::ptrdiff_t>(4 * row));
  }
  return rows;
}

/** Product of a 3x4 matrix and the inverse of a rigid one. */
RowsType
TimesRigidInverse(const RowsType & matrix, const RowsType & rigid)
{
  RowsType product{};
  for (unsigned int row = 0; row < 3; ++row)
  {
    product[4 * row + 3] = matrix[4 * row + 3];
    for (unsigned int column = 0; column < 3; ++column)
    {
      for (unsigned int d = 0; d < 3; ++d)
      {
        product[4 * row + column] += matrix[4 * row + d] * rigid[4 * column + d];
      }
      product[4 * row + 3] -= product[4 * row + column] * rigid[4 * column + 3];
    }
  }
  return product;
}

bool
IsRight(const JsonNode & geometry, const char * key)
{
  const std::string word = geometry.Get(key).Get("value").AsString();
  if (word != "right" && word != "left")
  {
    geometry.Get(key).Get("value").Fail("is \"" + word + "\"", "it is right or left");
  }
  return word == "right";
}

CephalometricGeometry::Pointer
ReadGeometry(const JsonNode & node, bool isFrontal = false)
{
  using GeometryType = CephalometricGeometry;
  auto geometry = GeometryType::New();
  geometry->SetSourceToDetectorDistance(node.Get("source_to_detector_mm").Get("value").AsNumber());
  geometry->SetSourceToMidsagittalDistance(
    node.Get(isFrontal ? "source_to_midcoronal_mm" : "source_to_midsagittal_mm").Get("value").AsNumber());
  if (isFrontal)
  {
    geometry->SetDirection(GeometryType::DirectionEnum::Frontal);
    geometry->SetFrontalSource(node.Get("source").Get("value").AsString() == "front"
                                 ? GeometryType::FrontalSourceEnum::InFront
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
  const auto spacing = node.Get("pixel_spacing_mm").Get("value").AsNumbers(2, "[u, v]");
  const auto principal = node.Get("principal_point_px").Get("value").AsNumbers(2, "[u, v]");
  CephalometricGeometry::PixelSpacingType pixelSpacing;
  CephalometricGeometry::PixelIndexType   principalPoint;
  for (unsigned int d = 0; d < 2; ++d)
  {
    pixelSpacing[d] = spacing[d];
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

/** Where a file is that a result names from the directory that its program was started in. */
std::string
FindFile(const std::string & name, const fs::path & resultFolder)
{
  std::error_code error;
  for (const fs::path & place :
       { fs::u8path(name), resultFolder / fs::u8path(name), resultFolder.parent_path() / fs::u8path(name) })
  {
    if (fs::is_regular_file(place, error))
    {
      return place.string();
    }
  }
  return "";
}

/** The case as its file says it, else as far as the names of its files do. */
DentalCase
FindCase(const JsonNode & root, const std::string & caseFileName, const fs::path & folder)
{
  const auto inputs = root.Get("inputs");
  const auto recorded = inputs.Find("case");
  if (!caseFileName.empty())
  {
    return ReadDentalCase(caseFileName);
  }
  if (recorded)
  {
    const std::string name = recorded->Get("path").AsString();
    const std::string found = FindFile(name, folder);
    if (found.empty())
    {
      recorded->Get("path").Fail("\"" + name + "\" is not there, seen from here", "name the case file with --case");
    }
    return ReadDentalCase(found);
  }
  if (!inputs.Find("upper") && !inputs.Find("lower"))
  {
    inputs.Fail("names no scan: the case was made in memory", "show it where it was made, by the result's scene()");
  }
  DentalCase description;
  description.fileName = "the files that " + root.GetFileName() + " names";
  for (const auto & field : { std::make_pair("upper", &description.upperFile),
                              std::make_pair("lower", &description.lowerFile),
                              std::make_pair("cephalogram.image", &description.imageFile),
                              std::make_pair("contours", &description.contoursFile),
                              std::make_pair("cephalometric_landmarks", &description.cephalometricLandmarksFile),
                              std::make_pair("landmarks_3d", &description.landmarks3DFile) })
  {
    if (const auto input = inputs.Find(field.first))
    {
      *field.second = FindFile(input->Get("path").AsString(), folder);
      if (field.second->empty())
      {
        input->Get("path").Fail("\"" + input->Get("path").AsString() + "\" is not there, seen from here",
                                "start from the directory that the case was registered in");
      }
    }
  }
  if (const auto side = root.Find("traced_side"))
  {
    description.tracedSide = TracedSideFromString(side->AsString());
    description.tracedSideIsGiven = true;
  }
  description.meshUnit = root.Find("mesh_unit") ? root.Get("mesh_unit").AsString() : "mm";
  description.millimetresPerUnit = MillimetresPerUnitFromString(description.meshUnit);
  return description;
}

/** Takes out what was read of files that are not the ones that were registered, and says so of each. */
void
TakeOutChanges(const JsonNode & root, DentalCaseData & data, std::vector<std::string> & warnings)
{
  for (const CaseInputFile & input : data.inputs)
  {
    const auto recorded = root.Get("inputs").Find(input.field);
    if (input.field == "case" || !recorded || recorded->Get("sha256").AsString() == input.sha256)
    {
      continue;
    }
    const auto  startsWith = [&input](const char * words) { return input.field.rfind(words, 0) == 0; };
    std::string what = "what is of it is";
    if (input.field == "upper" || input.field == "lower")
    {
      what = "the scan of the result's folder is shown instead; landmarks are";
      data.GetJaw(input.field == "upper" ? JawEnum::Upper : JawEnum::Lower).mesh = nullptr;
    }
    else if (startsWith("contours"))
    {
      what = "the tracing is";
      data.upper.contour = nullptr;
      data.lower.contour = nullptr;
    }
    else if (input.field == "cephalogram.image")
    {
      what = "the radiograph is";
      data.image = nullptr;
    }
    else if (input.field == "landmarks_3d")
    {
      what = "the landmarks are";
      data.landmarks3D = nullptr;
    }
    else
    {
      // Landmarks of an analysis and tooth labels are not shown.
      continue;
    }
    warnings.push_back(input.path + ": has changed since it was registered; " + what + " not shown");
  }
}

/** Where a jaw and its landmarks are on a radiograph. */
void
ReadPlace(const JsonNode & node, JawResult & jaw)
{
  jaw.registered = true;
  jaw.projection = ReadRows(node.Get("projection_3x4"));
  jaw.meshToCephalostat = ReadRows(node.Get("mesh_to_cephalostat_mm"));
  if (const auto landmarks = node.Find("landmarks_px"))
  {
    for (const auto & member : landmarks->GetMembers())
    {
      const auto         place = member.second.AsNumbers(2, "[u, v]");
      LandmarkPrediction landmark;
      landmark.name = member.first;
      landmark.position = { { place[0], place[1] } };
      jaw.landmarks.push_back(landmark);
    }
  }
}

/** What a result says of its further views, of those whose drawings were read; the others are left out. */
void
ReadViews(const JsonNode & root, const DentalCaseData & data, CaseResult & result)
{
  const auto views = root.Find("views");
  if (!views)
  {
    return;
  }
  for (const auto & member : views->GetMembers())
  {
    const auto found = std::find_if(data.views.begin(), data.views.end(), [&](const DentalViewData & view) {
      return view.description.name == member.first;
    });
    if (found == data.views.end())
    {
      continue;
    }
    CaseViewResult view;
    view.name = member.first;
    view.result = std::make_shared<CaseResult>();
    view.result->viewName = view.name;
    view.result->geometry =
      ReadGeometry(member.second.Get("geometry"), member.second.Get("direction").AsString() == "frontal");
    view.result->data = MakeCaseOfView(data, *found);
    for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
    {
      if (const auto node = member.second.Get("jaws").Find(jaw == JawEnum::Upper ? "upper" : "lower"))
      {
        ReadPlace(*node, view.result->jaws[jaw]);
      }
    }
    result.views.push_back(view);
  }
}

/** The scan as the result's folder has it: in its place, in mm. */
bool
TakePlacedScan(const fs::path & fileName, JawEnum jaw, DentalCaseData & data, JawResult & result)
{
  std::error_code error;
  if (!fs::is_regular_file(fileName, error))
  {
    return false;
  }
  data.GetJaw(jaw).mesh = ReadDentalMesh<DentalCaseData::MeshType>(fileName.string());
  // The matrix stays one of the case's unit; what is rigid is in mm.
  const double unit = data.description.millimetresPerUnit;
  const auto   scaleColumns = [&result](double factor) {
    for (unsigned int i = 0; i < 12; ++i)
    {
      result.projection[i] *= i % 4 == 3 ? 1.0 : factor;
    }
  };
  scaleColumns(1.0 / unit);
  result.projection = TimesRigidInverse(result.projection, result.meshToCephalostat);
  scaleColumns(unit);
  result.meshToUMDA = TimesRigidInverse(result.meshToUMDA, result.meshToCephalostat);
  result.meshToCephalostat = Identity;
  // On the scan they are told in the frame of its own file.
  result.landmarks.clear();
  return true;
}
} // namespace

CaseSceneFileReader::CaseSceneFileReader()
{
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
}

CaseSceneFileReader::DataObjectPointer
CaseSceneFileReader::MakeOutput(DataObjectPointerArraySizeType)
{
  return RegistrationScene::New().GetPointer();
}

RegistrationScene *
CaseSceneFileReader::GetOutput()
{
  return itkDynamicCastInDebugMode<RegistrationScene *>(this->ProcessObject::GetOutput(0));
}

void
CaseSceneFileReader::VerifyPreconditions() ITKv5_CONST
{
  Superclass::VerifyPreconditions();
  if (m_FileName.empty())
  {
    itkExceptionMacro("No file to read. Call SetFileName() first.");
  }
}

void
CaseSceneFileReader::GenerateData()
{
  m_Warnings.clear();
  std::error_code   error;
  const fs::path    path = fs::u8path(m_FileName);
  const std::string fileName = fs::is_directory(path, error) ? (path / "result.json").string() : m_FileName;
  const fs::path    folder = fs::absolute(fs::u8path(fileName)).parent_path();
  const auto        document = JsonDocument::ReadFile(fileName);
  const auto        root = document.GetRoot();
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

  CaseResult result;
  const auto jaws = root.Get("jaws");
  double     unit = 1.0;
  if (const auto meshUnit = root.Find("mesh_unit"))
  {
    try
    {
      unit = MillimetresPerUnitFromString(meshUnit->AsString());
    }
    catch (const std::invalid_argument & problem)
    {
      meshUnit->Fail(problem.what(), "register the case again");
    }
  }
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    const auto node = jaws.Find(jaw == JawEnum::Upper ? "upper" : "lower");
    if (!node || !node->Find("projection_3x4"))
    {
      continue;
    }
    JawResult & own = result.jaws[jaw];
    ReadPlace(*node, own);
    own.meshToUMDA = ReadRows(node->Get("mesh_to_umda_mm"));
  }
  if (result.jaws.empty())
  {
    itkDentalInputErrorMacro(fileName,
                             "jaws",
                             "no jaw was registered, and there is nothing to show",
                             "see the reasons of each jaw in the file");
  }
  result.geometry = ReadGeometry(root.Get("geometry"));

  std::shared_ptr<DentalCaseData> data;
  try
  {
    DentalCase description = FindCase(root, m_CaseFileName, folder);
    const auto control = root.Find("control");
    if (const auto excluded = control ? control->Find("exclude") : std::nullopt)
    {
      for (std::size_t i = 0; i < excluded->GetSize(); ++i)
      {
        description.excludedTeeth.push_back(ToothCode::FromString(excluded->At(i).AsString()));
      }
    }
    data = LoadDentalCase(description);
    TakeOutChanges(root, *data, m_Warnings);
  }
  catch (const DentalInputError & problem)
  {
    m_Warnings.push_back("radiograph and tracing are not shown: " + problem.GetOneLine());
  }
  catch (const std::invalid_argument & problem)
  {
    m_Warnings.push_back("radiograph and tracing are not shown: " + fileName + ": " + problem.what());
  }
  if (data == nullptr)
  {
    data = std::make_shared<DentalCaseData>();
  }
  data->description.millimetresPerUnit = unit;
  ReadViews(root, *data, result);
  bool isAny = false;
  for (auto & entry : result.jaws)
  {
    const std::string name = entry.first == JawEnum::Upper ? "upper" : "lower";
    const fs::path    placed = folder / (name + "_ceph.stl");
    const bool        isMissing = data->GetJaw(entry.first).mesh.IsNull();
    if (isMissing)
    {
      // What a view says of this jaw is told in the frame of the scan's own file.
      for (CaseViewResult & view : result.views)
      {
        view.result->jaws.erase(entry.first);
      }
    }
    if (isMissing && !TakePlacedScan(placed, entry.first, *data, entry.second))
    {
      m_Warnings.push_back("the " + name + " scan is not shown: there is no " + placed.string() +
                           " either; register without --no-report");
      continue;
    }
    isAny = true;
  }
  if (!isAny)
  {
    itkDentalInputErrorMacro(fileName,
                             "inputs",
                             "no scan of it can be shown: " + m_Warnings.front(),
                             "name the case file with --case, or register again without --no-report");
  }
  result.data = data;
  auto scene = MakeCaseScene(result);
  scene->Update();
  this->GetOutput()->Graft(scene->GetOutput());
}

void
CaseSceneFileReader::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << m_FileName << std::endl;
  os << indent << "CaseFileName: " << m_CaseFileName << std::endl;
  os << indent << "Warnings: " << m_Warnings.size() << std::endl;
}
} // namespace itk

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

#include "itkCaseResultDocument.h"
#include "itkCaseScene.h"
#include "itkCaseViews.h"
#include "itkDentalCaseFileReader.h"
#include "itkDentalCaseLoader.h"
#include "itkDentalInputError.h"
#include "itkDescribePlainly.h"
#include "itkProjectionRows.h"
#include "itkReadDentalMesh.h"
#include "itkVisitCaseFiles.h"

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

constexpr RowsType Identity{ { 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0 } };

RowsType
ReadRows(const JsonNode & node)
{
  return CaseResultDocument::ReadMatrix<3, 4>(node, "a row of four");
}

/** Views and files a tooth of a case that has no file, as far as the result names them. */
void
NameParts(const CaseResultDocument & document, DentalCase & description)
{
  const JsonNode & root = document.GetRoot();
  if (const auto views = root.Find("views"))
  {
    for (const auto & member : views->GetMembers())
    {
      DentalView view;
      view.name = member.first;
      view.direction = member.second.Get("direction").AsString() == "lateral"
                         ? CephalometricGeometry::DirectionEnum::Lateral
                         : CephalometricGeometry::DirectionEnum::Frontal;
      description.views.push_back(view);
    }
  }
  const std::string prefix = "contours.";
  for (const auto & member : root.Get("inputs").GetMembers())
  {
    if (member.first.rfind(prefix, 0) == 0)
    {
      description.contourClassFiles.emplace_back(member.first.substr(prefix.size()), "");
    }
  }
}

/** The case as its file says it, else as far as the names of its files do. */
DentalCase
FindCase(const CaseResultDocument & document, const std::string & caseFileName)
{
  const JsonNode & root = document.GetRoot();
  const auto       inputs = root.Get("inputs");
  const auto       find = [&](const std::string & field) {
    const std::string found = document.FindInput(field);
    if (found.empty())
    {
      const auto path = inputs.Get(field).Get("path");
      path.Fail("\"" + path.AsString() + "\" is not there, seen from here",
                field == "case" ? "name the case file with --case"
                                      : "start from the directory that the case was registered in");
    }
    return found;
  };
  if (!caseFileName.empty())
  {
    return ReadDentalCase(caseFileName);
  }
  if (inputs.Find("case"))
  {
    return ReadDentalCase(find("case"));
  }
  if (!inputs.Find("upper") && !inputs.Find("lower"))
  {
    inputs.Fail("names no scan: the case was made in memory", "show it where it was made, by the result's scene()");
  }
  DentalCase description;
  description.fileName = "the files that " + root.GetFileName() + " names";
  NameParts(document, description);
  VisitCaseFiles(description, [&](const std::string & field, std::string & path) {
    if (inputs.Find(field))
    {
      path = find(field);
    }
  });
  if (const auto side = root.Find("traced_side"))
  {
    description.tracedSide = TracedSideFromString(side->AsString());
    description.tracedSideIsGiven = true;
  }
  description.meshUnit = root.Find("mesh_unit") ? root.Get("mesh_unit").AsString() : "mm";
  description.millimetresPerUnit = document.GetMillimetresPerUnit();
  return description;
}

/** Takes out what was read of a file that is not the one that was registered: what is drawn of a radiograph. Returns
 * what that was; "" where nothing of it is shown. */
std::string
TakeOutRadiograph(const std::string &      field,
                  DentalRadiographData &   radiograph,
                  DentalContour::Pointer & upperContour,
                  DentalContour::Pointer & lowerContour)
{
  if (field.rfind("contours", 0) == 0)
  {
    upperContour = nullptr;
    lowerContour = nullptr;
    return "the tracing is";
  }
  if (field == "cephalogram.image")
  {
    radiograph.image = nullptr;
    return "the radiograph is";
  }
  // Landmarks of an analysis and tooth labels are not shown.
  return {};
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
    std::string what;
    if (input.field == "upper" || input.field == "lower")
    {
      what = "the scan of the result's folder is shown instead; landmarks are";
      data.GetJaw(input.field == "upper" ? JawEnum::Upper : JawEnum::Lower).mesh = nullptr;
    }
    else if (input.field == "landmarks_3d")
    {
      what = "the landmarks are";
      data.landmarks3D = nullptr;
    }
    else
    {
      what = TakeOutRadiograph(input.field, data, data.upper.contour, data.lower.contour);
      for (DentalViewData & view : data.views)
      {
        const std::string prefix = "views." + view.description.name + '.';
        if (input.field.rfind(prefix, 0) == 0)
        {
          what = TakeOutRadiograph(input.field.substr(prefix.size()), view, view.contours[0], view.contours[1]);
        }
      }
    }
    if (!what.empty())
    {
      warnings.push_back(input.path + ": has changed since it was registered; " + what + " not shown");
    }
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
ReadViews(const JsonNode & root, const DentalCaseData & data, CaseResult & result, std::vector<std::string> & warnings)
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
      warnings.push_back("the view " + member.first + " is not shown: what was read of the case has none of that name");
      continue;
    }
    CaseViewResult view;
    view.name = member.first;
    view.result = std::make_shared<CaseResult>();
    view.result->viewName = view.name;
    view.result->geometry = CaseResultDocument::ReadGeometry(member.second.Get("geometry"));
    view.result->data = MakeCaseOfView(data, *found);
    for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
    {
      if (const auto node = member.second.Get("jaws").Find(ToString(jaw)))
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
  result.projection =
    ScaleColumns(TimesRigidInverse(ScaleColumns(result.projection, 1.0 / unit), result.meshToCephalostat), unit);
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
  const CaseResultDocument document(m_FileName);
  const JsonNode &         root = document.GetRoot();
  const std::string &      fileName = document.GetFileName();
  const fs::path &         folder = document.GetFolder();

  CaseResult   result;
  const auto   jaws = root.Get("jaws");
  const double unit = document.GetMillimetresPerUnit();
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    const auto node = jaws.Find(ToString(jaw));
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
  result.geometry = CaseResultDocument::ReadGeometry(root.Get("geometry"));

  std::shared_ptr<DentalCaseData> data;
  try
  {
    DentalCase description = FindCase(document, m_CaseFileName);
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
  ReadViews(root, *data, result, m_Warnings);
  bool isAny = false;
  for (auto & entry : result.jaws)
  {
    const std::string name = ToString(entry.first);
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
  try
  {
    auto scene = MakeCaseScene(result);
    scene->Update();
    this->GetOutput()->Graft(scene->GetOutput());
  }
  catch (const ProcessAborted &)
  {
    throw;
  }
  catch (const DentalInputError &)
  {
    throw;
  }
  catch (const ExceptionObject & problem)
  {
    // Numbers that somebody has changed, a matrix that is no rigid map for one.
    itkDentalInputErrorMacro(fileName, "", DescribePlainly(problem), "register the case again");
  }
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

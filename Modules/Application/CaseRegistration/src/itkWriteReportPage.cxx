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
#include "itkWriteReportPage.h"

#include "itkCaseInputFile.h"
#include "itkCephalogramFileReader.h"
#include "itkDentalInputError.h"
#include "itkJsonDocument.h"
#include "itkMakeAnonymous.h"
#include "itkReadDentalMesh.h"
#include "itkReportPageWriter.h"
#include "itkTextFile.h"

#include <filesystem>

namespace itk
{
namespace
{
namespace fs = std::filesystem;

/** A file that the result was made of, seen from here; "" where it says none. */
fs::path
FindInput(const JsonNode & root, const std::string & field)
{
  const auto inputs = root.Find("inputs");
  const auto path = [&](const char * name) {
    const auto input = inputs ? inputs->Find(name) : std::nullopt;
    const auto said = input ? input->Find("path") : std::nullopt;
    return said ? fs::u8path(said->AsString()) : fs::path();
  };
  const fs::path file = path(field.c_str());
  return file.empty() || file.is_absolute() ? file : path("case").parent_path() / file;
}

/** The name of the folder that the case lies in. */
std::string
FindTitle(const JsonNode & root, const fs::path & folder)
{
  std::error_code error;
  const fs::path  caseFile = FindInput(root, "case");
  const fs::path  where = fs::absolute(caseFile.empty() ? folder / "result.json" : caseFile, error).lexically_normal();
  return where.parent_path().filename().u8string();
}
} // namespace

std::vector<std::string>
WriteReportPage(const std::string & result, const ReportPageSettings & settings)
{
  std::error_code error;
  const fs::path  given = fs::u8path(result);
  const fs::path  folder = fs::is_directory(given, error) ? given : given.parent_path();
  const fs::path  file = fs::is_directory(given, error) ? given / "result.json" : given;
  std::string     text = ReadTextFile(file.u8string(), "a result");
  const JsonNode  root = JsonDocument::Parse(text, file.u8string()).GetRoot();
  const auto      schema = root.Find("schema");
  if (!schema || !schema->IsString() || schema->AsString() != "dentalscr-result/1")
  {
    itkDentalInputErrorMacro(
      file.u8string(), "schema", "is not \"dentalscr-result/1\"", "name the folder of a result of this version");
  }
  const auto said = root.Find("anonymous");
  const bool anonymous = settings.anonymous || (said && said->AsBoolean());

  std::vector<std::string> missing;
  auto                     page = ReportPageWriter::New();
  // Opened by its name where one is given: then that it cannot be read is an error.
  const fs::path image =
    settings.imageFile.empty() ? FindInput(root, "cephalogram.image") : fs::u8path(settings.imageFile);
  if (!settings.imageFile.empty() || fs::is_regular_file(image, error))
  {
    auto reader = CephalogramFileReader::New();
    reader->SetFileName(image.string());
    reader->Update();
    page->SetRadiograph(reader->GetOutput());
    const auto inputs = root.Find("inputs");
    const auto recorded = inputs ? inputs->Find("cephalogram.image") : std::nullopt;
    if (recorded && recorded->Get("sha256").AsString() != ComputeFileSHA256(image.string()))
    {
      missing.push_back("the radiograph is not the file that was registered: it has changed since");
    }
  }
  else if (root.Find("inputs") && root.Get("inputs").Find("cephalogram.image"))
  {
    missing.push_back("the radiograph is not where the result says, and left out: name it with --image");
  }
  if (const auto views = root.Find("views"))
  {
    for (const auto & view : views->GetMembers())
    {
      const std::string field = "views." + view.first + ".cephalogram.image";
      const fs::path    picture = FindInput(root, field);
      if (fs::is_regular_file(picture, error))
      {
        auto reader = CephalogramFileReader::New();
        reader->SetFileName(picture.string());
        reader->Update();
        page->SetViewRadiograph(view.first, reader->GetOutput());
        if (root.Get("inputs").Get(field).Get("sha256").AsString() != ComputeFileSHA256(picture.string()))
        {
          missing.push_back("the radiograph of the view " + view.first +
                            " is not the file that was registered: it has changed since");
        }
      }
      else if (!picture.empty())
      {
        missing.push_back("the radiograph of the view " + view.first + " is not where the result says, and left out");
      }
    }
  }
  const fs::path details = folder / "report.json";
  if (fs::is_regular_file(details, error))
  {
    const std::string content = ReadTextFile(details.u8string(), "a report's details");
    page->SetDetails(anonymous ? MakeReportDetailsAnonymous(content) : content);
  }
  else
  {
    missing.push_back("there is no report.json beside the result: nothing is drawn on the radiograph");
  }
  for (const char * jaw : { "upper", "lower" })
  {
    const fs::path scan = folder / (std::string(jaw) + "_ceph.stl");
    if (root.Get("jaws").Find(jaw) && fs::is_regular_file(scan, error))
    {
      const auto mesh = ReadDentalMesh<ReportPageWriter::MeshType>(scan.string());
      if (std::string(jaw) == "upper")
      {
        page->SetUpperScan(mesh);
      }
      else
      {
        page->SetLowerScan(mesh);
      }
    }
  }
  page->SetTitle(anonymous ? "Registration" : FindTitle(root, folder));
  page->SetResult(anonymous ? MakeResultFileAnonymous(text) : text);
  page->SetFileName(settings.fileName.empty() ? (folder / "report.html").u8string() : settings.fileName);
  page->Update();
  return missing;
}
} // namespace itk

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
#include "itkCaseResultDocument.h"
#include "itkCephalogramFileReader.h"
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

/** The name of the folder that the case lies in. */
std::string
FindTitle(const CaseResultDocument & document)
{
  std::error_code   error;
  const std::string caseName = document.GetInputPath("case");
  const fs::path    where = caseName.empty() ? fs::u8path(document.GetFileName()) : fs::u8path(caseName);
  return fs::absolute(where, error).lexically_normal().parent_path().filename().u8string();
}

/** The picture of a radiograph, and whether it is still the one that was registered. */
CephalogramFileReader::OutputImageType::Pointer
ReadRadiograph(const CaseResultDocument & document,
               const std::string &        field,
               const std::string &        fileName,
               const std::string &        what,
               std::vector<std::string> & missing)
{
  auto reader = CephalogramFileReader::New();
  reader->SetFileName(fileName);
  reader->Update();
  const auto inputs = document.GetRoot().Find("inputs");
  const auto recorded = inputs ? inputs->Find(field) : std::nullopt;
  if (recorded && recorded->Get("sha256").AsString() != ComputeFileSHA256(fileName))
  {
    missing.push_back(what + " is not the file that was registered: it has changed since");
  }
  return reader->GetOutput();
}
} // namespace

std::vector<std::string>
WriteReportPage(const std::string & result, const ReportPageSettings & settings)
{
  std::error_code          error;
  const CaseResultDocument document(result);
  const JsonNode &         root = document.GetRoot();
  const fs::path &         folder = document.GetFolder();
  const auto               said = root.Find("anonymous");
  const bool               anonymous = settings.anonymous || (said && said->AsBoolean());

  std::vector<std::string> missing;
  auto                     page = ReportPageWriter::New();
  // Opened by its name where one is given: then that it cannot be read is an error.
  const std::string field = "cephalogram.image";
  const std::string image = settings.imageFile.empty() ? document.FindInput(field) : settings.imageFile;
  if (!image.empty())
  {
    page->SetRadiograph(ReadRadiograph(document, field, image, "the radiograph", missing));
  }
  else if (root.Find("inputs") && root.Get("inputs").Find(field))
  {
    missing.emplace_back("the radiograph is not where the result says, and left out: name it with --image");
  }
  if (const auto views = root.Find("views"))
  {
    for (const auto & view : views->GetMembers())
    {
      const std::string what = "the radiograph of the view " + view.first;
      const std::string own = "views." + view.first + '.' + field;
      const std::string picture = document.FindInput(own);
      if (!picture.empty())
      {
        page->SetViewRadiograph(view.first, ReadRadiograph(document, own, picture, what, missing));
      }
      else if (root.Find("inputs") && root.Get("inputs").Find(own))
      {
        missing.push_back(what + " is not where the result says, and left out");
      }
    }
  }
  const fs::path details = folder / "report.json";
  if (fs::is_regular_file(details, error))
  {
    const std::string content = ReadTextFile(details.u8string(), "a report's details");
    JsonDocument::Verify(content, details.u8string());
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
  page->SetTitle(anonymous ? "Registration" : FindTitle(document));
  page->SetResult(anonymous ? MakeResultFileAnonymous(document.GetText()) : document.GetText());
  page->SetFileName(settings.fileName.empty() ? (folder / "report.html").u8string() : settings.fileName);
  page->Update();
  return missing;
}
} // namespace itk

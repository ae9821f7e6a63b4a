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
#include "itkCaseContinuation.h"

#include "itkCaseInputFile.h"
#include "itkCaseResultDocument.h"
#include "itkDentalCaseFileReader.h"
#include "itkDentalInputError.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>

namespace itk
{
namespace fs = std::filesystem;

namespace
{
std::vector<std::string>
ReadWords(const std::optional<JsonNode> & list)
{
  std::vector<std::string> words;
  for (std::size_t i = 0; list && i < list->GetSize(); ++i)
  {
    words.push_back(list->At(i).AsString());
  }
  return words;
}

/** The case that options made, of what the result holds of them and of the files where they are now. */
DentalCase
MakeCaseAgain(const CaseResultDocument & document)
{
  using Json = nlohmann::ordered_json;
  const JsonNode & root = document.GetRoot();
  const auto       fields = root.Find("case_fields");
  const auto       inputs = root.Find("inputs");
  if (!fields || !fields->IsObject() || !inputs)
  {
    itkDentalInputErrorMacro(document.GetFileName(),
                             "case_fields",
                             "missing: the case was made in memory, or by an earlier version without a case file",
                             "give the case, or its options, again");
  }
  Json                     json = Json::parse(document.GetText()).at("case_fields");
  std::vector<std::string> changed;
  for (const auto & member : inputs->GetMembers())
  {
    const std::string & field = member.first;
    if (!member.second.Find("path"))
    {
      member.second.Fail("does not say where it is: the result is anonymous", "give the case's options again");
    }
    const std::string found = document.FindInput(field);
    if (found.empty())
    {
      const JsonNode path = member.second.Get("path");
      path.Fail("\"" + path.AsString() + "\" is not there, seen from here",
                "put it back, run from the folder that the first run was started in, or give the case's options again");
    }
    if (ComputeFileSHA256(found) != member.second.Get("sha256").AsString())
    {
      changed.push_back(field + ": " + found + " has changed since " + document.GetFileName());
    }
    const std::size_t dot = field.find('.');
    (dot == std::string::npos ? json[field] : json[field.substr(0, dot)][field.substr(dot + 1)]) = found;
  }
  DentalCase description = ParseDentalCase(json.dump(), "command line", "");
  description.warnings.insert(description.warnings.end(), changed.begin(), changed.end());
  return description;
}

void
FindCase(const CaseResultDocument & document, bool needsCase, CaseContinuation & continuation)
{
  const auto inputs = document.GetRoot().Find("inputs");
  const auto recorded = inputs ? inputs->Find("case") : std::nullopt;
  if (!recorded)
  {
    if (needsCase)
    {
      continuation.description = MakeCaseAgain(document);
    }
    return;
  }
  if (!recorded->Find("path"))
  {
    if (needsCase)
    {
      recorded->Fail("does not say where it is: the result is anonymous", "name the case file");
    }
    return;
  }
  continuation.caseFile = document.FindInput("case");
  if (continuation.caseFile.empty())
  {
    if (needsCase)
    {
      recorded->Get("path").Fail("is not there, seen from here",
                                 "name the case file, or run from the folder that the first run was started in");
    }
    return;
  }
  continuation.caseHasChanged = ComputeFileSHA256(continuation.caseFile) != recorded->Get("sha256").AsString();
}
} // namespace

void
CaseContinuation::SetLandmarks(DentalCase & dentalCase) const
{
  std::error_code error;
  if (!cephalometricLandmarksFile.empty() &&
      !fs::equivalent(cephalometricLandmarksFile, dentalCase.cephalometricLandmarksFile, error))
  {
    dentalCase.cephalometricLandmarksFile = cephalometricLandmarksFile;
    dentalCase.cephalometricLandmarks = nullptr;
  }
}

CaseContinuation
ReadCaseContinuation(const std::string & name, bool needsCase)
{
  const CaseResultDocument document(name);
  CaseContinuation         continuation;
  continuation.resultFile = document.GetFileName();
  FindCase(document, needsCase, continuation);
  if (const auto control = document.GetRoot().Find("control"))
  {
    continuation.excludedTeeth = ReadWords(control->Find("exclude"));
    continuation.fixed = ReadWords(control->Find("fix"));
  }
  continuation.options = ReadWords(document.GetRoot().Find("options"));
  // Whoever has changed the case file may have changed what it names.
  if (!continuation.caseFile.empty() && !continuation.caseHasChanged)
  {
    continuation.cephalometricLandmarksFile = document.FindInput("cephalometric_landmarks");
  }
  return continuation;
}
} // namespace itk

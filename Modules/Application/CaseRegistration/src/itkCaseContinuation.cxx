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
#include "itkDentalInputError.h"

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

void
FindCase(const CaseResultDocument & document, bool needsCase, CaseContinuation & continuation)
{
  const auto inputs = document.GetRoot().Find("inputs");
  const auto recorded = inputs ? inputs->Find("case") : std::nullopt;
  if (!recorded)
  {
    if (needsCase)
    {
      itkDentalInputErrorMacro(document.GetFileName(),
                               "inputs.case",
                               "missing: it was made without a case file",
                               "give the case's options again");
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

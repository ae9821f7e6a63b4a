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
#include "itkRecordCaseInputs.h"

#include "itkParallelFor.h"
#include "itkVisitCaseFiles.h"

#include "itkMultiThreaderBase.h"

#include <exception>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace itk
{
void
RecordCaseInputs(DentalCaseData & data)
{
  const DentalCase & description = data.description;
  const std::string  folder = std::filesystem::path(description.fileName).parent_path().string();
  std::vector<std::pair<std::string, std::string>> files;
  const auto                                       add = [&](const std::string & field, const std::string & file) {
    if (!file.empty())
    {
      files.emplace_back(field, file);
    }
  };
  std::error_code error;
  // A case of the command line, or of memory, has no file.
  const bool hasCaseFile = std::filesystem::is_regular_file(description.fileName, error);
  if (hasCaseFile)
  {
    add("case", description.fileName);
  }
  VisitCaseFiles(description, [&](const std::string & field, const std::string & file) {
    if (!IsOnlyForEvaluation(field))
    {
      add(field, file);
    }
  });
  data.inputs.resize(files.size());
  std::vector<std::exception_ptr> errors(files.size());
  ParallelFor(files.size(), MultiThreaderBase::GetGlobalDefaultNumberOfThreads(), [&](std::size_t i) {
    try
    {
      // The case file is named as it was given.
      data.inputs[i] = MakeCaseInputFile(files[i].first, files[i].second, hasCaseFile && i == 0 ? "" : folder);
    }
    catch (...)
    {
      errors[i] = std::current_exception();
    }
  });
  for (const std::exception_ptr & problem : errors)
  {
    if (problem)
    {
      std::rethrow_exception(problem);
    }
  }
}
} // namespace itk

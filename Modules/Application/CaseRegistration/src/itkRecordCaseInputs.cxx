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

#include "itkDentalInputError.h"
#include "itkParallelFor.h"
#include "itkVisitCaseFiles.h"

#include "itkMultiThreaderBase.h"

#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include <sys/stat.h>

namespace itk
{
namespace
{
std::vector<long long>
StateOf(const std::string & fileName)
{
  struct stat found
  {};
  if (::stat(fileName.c_str(), &found) != 0)
  {
    return {};
  }
  return { static_cast<long long>(found.st_dev),
           static_cast<long long>(found.st_ino),
           static_cast<long long>(found.st_size),
           static_cast<long long>(found.st_mtim.tv_sec),
           static_cast<long long>(found.st_mtim.tv_nsec) };
}
} // namespace

std::vector<CaseInputState>
LookAtCaseInputs(const DentalCase & description)
{
  std::vector<CaseInputState> files;
  const auto                  add = [&](const std::string & field, const std::string & file) {
    if (!file.empty())
    {
      files.push_back({ field, file, StateOf(file) });
    }
  };
  std::error_code error;
  // A case of the command line, or of memory, has no file.
  if (std::filesystem::is_regular_file(description.fileName, error))
  {
    add("case", description.fileName);
  }
  VisitCaseFiles(description, [&](const std::string & field, const std::string & file) {
    if (!IsOnlyForEvaluation(field))
    {
      add(field, file);
    }
  });
  return files;
}

void
RecordCaseInputs(DentalCaseData & data, const std::vector<CaseInputState> & before)
{
  const std::string folder = std::filesystem::path(data.description.fileName).parent_path().string();
  data.inputs.resize(before.size());
  std::vector<std::exception_ptr> errors(before.size());
  ParallelFor(before.size(), MultiThreaderBase::GetGlobalDefaultNumberOfThreads(), [&](std::size_t i) {
    try
    {
      // The case file is named as it was given.
      const CaseInputState & input = before[i];
      const bool             isCase = input.field == "case";
      data.inputs[i] = MakeCaseInputFile(input.field, input.fileName, isCase ? "" : folder);
      // The case file was read before anybody looked at the files: it is known by its bytes.
      const std::string & read = data.description.fileSHA256;
      const bool          isAnother = isCase && !read.empty() && data.inputs[i].sha256 != read;
      if (isAnother || StateOf(input.fileName) != input.state)
      {
        itkDentalInputErrorMacro(
          input.fileName, "", "was changed while the case was read", "start again when it is written completely");
      }
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

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
#include "itkBatchParts.h"

#include "itkBatchSummary.h"
#include "itkDentalInputError.h"

#include <algorithm>
#include <filesystem>
#include <unordered_map>

namespace itk
{
namespace
{
namespace fs = std::filesystem;
}

std::vector<BatchRecord>
BatchParts::Collect(const std::vector<BatchCase> & cases)
{
  m_Unfinished.clear();
  m_NumberOfMissingCases = 0;
  std::vector<fs::path> parts;
  std::error_code       error;
  for (const auto & entry : fs::directory_iterator(m_Folder, error))
  {
    if (fs::is_directory(entry.path() / ".batch", error))
    {
      parts.push_back(entry.path());
    }
  }
  if (parts.empty())
  {
    itkDentalInputErrorMacro(m_Folder,
                             "",
                             "holds no batch: no folder in it was the output of one",
                             "name the folder that the outputs of batches lie in");
  }
  // A folder says nothing of the order of its names.
  std::sort(parts.begin(), parts.end());
  std::unordered_map<std::string, BatchRecord> found;
  for (const fs::path & part : parts)
  {
    const std::string name = part.filename().string();
    const std::string file = (part / "summary.json").string();
    if (!fs::exists(file, error))
    {
      m_Unfinished.push_back(name);
      continue;
    }
    const BatchSummary summary = BatchSummary::ReadFile(file);
    if (!summary.IsComplete())
    {
      m_Unfinished.push_back(name);
    }
    const std::string from = fs::absolute(part)
                               .lexically_normal()
                               .lexically_relative(fs::absolute(m_Output).lexically_normal())
                               .generic_string();
    for (BatchRecord record : summary.GetRecords())
    {
      record.folder = from + '/' + (record.folder.empty() ? record.one.id : record.folder);
      const std::string folder = record.folder;
      const auto        added = found.emplace(record.one.id, std::move(record));
      if (!added.second)
      {
        itkDentalInputErrorMacro(m_Folder,
                                 added.first->first,
                                 "is a case of two parts: " + added.first->second.folder + " and " + folder,
                                 "remove the part that is of another run, or of another size of parts");
      }
    }
  }
  std::vector<BatchRecord> records;
  records.reserve(cases.size());
  for (const BatchCase & one : cases)
  {
    const auto  there = found.find(one.id);
    BatchRecord record;
    if (there != found.end())
    {
      record = std::move(there->second);
      found.erase(there);
    }
    else
    {
      record.message = "no part of the cohort in " + m_Folder + " has come to it";
      ++m_NumberOfMissingCases;
    }
    record.one = one;
    records.push_back(std::move(record));
  }
  m_NumberOfOtherCases = found.size();
  return records;
}
} // namespace itk

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
#include "itkBatchSummary.h"

#include "itkCSVField.h"
#include "itkBatchPageParts.h"
#include "itkDentalInputError.h"
#include "itkDentalSCRVersion.h"
#include "itkEscapeForScript.h"
#include "itkJsonDocument.h"
#include "itkTextFile.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace itk
{
namespace
{
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string
ToText(const std::optional<double> & number)
{
  return number ? Json(*number).dump() : std::string();
}

Json
ToJsonNumber(const std::optional<double> & number)
{
  return number ? Json(*number) : Json();
}

/** Names of the columns that tables of cases had besides, in the order in which they come. */
std::vector<std::string>
FindColumns(const std::vector<BatchRecord> & records)
{
  std::vector<std::string> columns;
  for (const BatchRecord & record : records)
  {
    for (const auto & column : record.one.columns)
    {
      if (std::find(columns.begin(), columns.end(), column.first) == columns.end())
      {
        columns.push_back(column.first);
      }
    }
  }
  return columns;
}

/** The jaws; for a case without a result one without a name. */
std::vector<BatchRecord::JawType>
RowsOf(const BatchRecord & record)
{
  if (!record.jaws.empty())
  {
    return record.jaws;
  }
  BatchRecord::JawType row;
  row.status = "unusable";
  row.message = record.message;
  return { row };
}

/** Of the case, of its jaws, as CaseResult::GetStatus(): the worst one; a jaw that was skipped is none, and without any
 * the case has failed. */
std::string
WorstOf(const std::vector<BatchRecord::JawType> & jaws)
{
  constexpr const char * statuses[] = { "failed", "suspect", "ok" };
  for (const char * status : statuses)
  {
    if (std::any_of(jaws.begin(), jaws.end(), [&](const auto & jaw) { return jaw.status == status; }))
    {
      return status;
    }
  }
  return "failed";
}

Json
MakeJson(const std::vector<BatchRecord> & records, bool isComplete)
{
  Json json = { { "schema", "dentalscr-batch/1" },
                { "software", DentalSCRVersion },
                { "cases", records.size() },
                { "complete", isComplete } };
  json["rows"] = Json::array();
  for (const BatchRecord & record : records)
  {
    for (const auto & jaw : RowsOf(record))
    {
      Json row = { { "case", record.one.id },
                   { "jaw", jaw.jaw },
                   { "status", jaw.status },
                   { "findings", jaw.findings },
                   { "matched_px", ToJsonNumber(jaw.matched) },
                   { "expected_error_px", ToJsonNumber(jaw.expectedError) },
                   { "seconds", record.seconds },
                   { "message", jaw.message } };
      if (!record.folder.empty())
      {
        row["folder"] = record.folder;
      }
      for (const auto & column : record.one.columns)
      {
        row["columns"][column.first] = column.second;
      }
      json["rows"].push_back(row);
    }
  }
  json["notice"] = "Research software, not a medical device.";
  return json;
}
} // namespace

BatchSummary
BatchSummary::ReadFile(const std::string & fileName)
{
  const auto document = JsonDocument::ReadFile(fileName);
  const auto root = document.GetRoot();
  if (root.Get("schema").AsString() != "dentalscr-batch/1")
  {
    root.Get("schema").Fail("is not \"dentalscr-batch/1\"", "name the summary.json of a batch");
  }
  const auto numberOf = [](const JsonNode & node) {
    return node.IsNull() ? std::optional<double>() : std::optional<double>(node.AsNumber());
  };
  std::vector<BatchRecord> records;
  const auto               rows = root.Get("rows");
  for (std::size_t i = 0; i < rows.GetSize(); ++i)
  {
    const auto          row = rows.At(i);
    const std::string & id = row.Get("case").AsString();
    // Rows of a case follow each other.
    if (records.empty() || records.back().one.id != id)
    {
      BatchRecord record;
      record.one.id = id;
      record.seconds = row.Get("seconds").AsNumber();
      if (const auto folder = row.Find("folder"))
      {
        record.folder = folder->AsString();
      }
      if (const auto columns = row.Find("columns"))
      {
        for (const auto & column : columns->GetMembers())
        {
          record.one.columns.emplace_back(column.first, column.second.AsString());
        }
      }
      records.push_back(std::move(record));
    }
    BatchRecord &        record = records.back();
    BatchRecord::JawType jaw;
    jaw.jaw = row.Get("jaw").AsString();
    jaw.status = row.Get("status").AsString();
    jaw.message = row.Get("message").AsString();
    if (jaw.jaw.empty())
    {
      record.message = jaw.message;
      continue;
    }
    const auto findings = row.Get("findings");
    for (std::size_t k = 0; k < findings.GetSize(); ++k)
    {
      jaw.findings.push_back(findings.At(k).AsString());
    }
    jaw.matched = numberOf(row.Get("matched_px"));
    jaw.expectedError = numberOf(row.Get("expected_error_px"));
    record.jaws.push_back(std::move(jaw));
    record.status = WorstOf(record.jaws);
  }
  // Of a summary that an earlier version wrote there is no word: it was written at the end.
  const auto complete = root.Find("complete");
  return BatchSummary(std::move(records), !complete || complete->AsBoolean());
}

std::string
BatchSummary::ToCSV() const
{
  const auto columns = FindColumns(m_Records);
  const bool hasFolders =
    std::any_of(m_Records.begin(), m_Records.end(), [](const BatchRecord & record) { return !record.folder.empty(); });
  std::ostringstream csv;
  csv << "case,jaw,status,findings,matched_px,expected_error_px,seconds,message" << (hasFolders ? ",folder" : "");
  for (const std::string & column : columns)
  {
    csv << ',' << ToCSVField(column);
  }
  csv << "\r\n";
  for (const BatchRecord & record : m_Records)
  {
    for (const auto & jaw : RowsOf(record))
    {
      std::string findings;
      for (const std::string & code : jaw.findings)
      {
        findings += (findings.empty() ? "" : " ") + code;
      }
      csv << ToCSVField(record.one.id) << ',' << jaw.jaw << ',' << jaw.status << ',' << findings << ','
          << ToText(jaw.matched) << ',' << ToText(jaw.expectedError) << ',' << Json(record.seconds).dump() << ','
          << ToCSVField(jaw.message);
      if (hasFolders)
      {
        csv << ',' << ToCSVField(record.folder);
      }
      for (const std::string & column : columns)
      {
        const auto & own = record.one.columns;
        const auto   cell =
          std::find_if(own.begin(), own.end(), [&](const auto & entry) { return entry.first == column; });
        csv << ',' << (cell == own.end() ? std::string() : ToCSVField(cell->second));
      }
      csv << "\r\n";
    }
  }
  return csv.str();
}

std::string
BatchSummary::ToJson() const
{
  return MakeJson(m_Records, m_IsComplete).dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string
BatchSummary::ToPage(const std::string & folder) const
{
  Json            json = MakeJson(m_Records, m_IsComplete);
  std::error_code error;
  for (Json & row : json["rows"])
  {
    const fs::path result = row.value("folder", row["case"].get<std::string>());
    row["page"] = !folder.empty() && fs::exists(fs::path(folder) / result / "report.html", error);
  }
  const std::string      data = EscapeForScript(json.dump(-1, ' ', false, Json::error_handler_t::replace));
  std::string            page(BatchPageParts::Page());
  constexpr const char * word = "BATCH_DATA";
  const std::size_t      place = page.find(word);
  return page.replace(place, std::char_traits<char>::length(word), data);
}

void
BatchSummary::Write(const std::string & folder, bool page) const
{
  WriteFileAtomically((fs::path(folder) / "summary.csv").string(), this->ToCSV());
  WriteFileAtomically((fs::path(folder) / "summary.json").string(), this->ToJson());
  if (page)
  {
    WriteFileAtomically((fs::path(folder) / "index.html").string(), this->ToPage(folder));
  }
}
} // namespace itk

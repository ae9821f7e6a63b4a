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
#include "itkBatchPage.h"
#include "itkDentalSCRVersion.h"
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

Json
MakeJson(const std::vector<BatchRecord> & records)
{
  Json json = { { "schema", "dentalscr-batch/1" }, { "software", DentalSCRVersion }, { "cases", records.size() } };
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

std::string
BatchSummary::ToCSV() const
{
  const auto         columns = FindColumns(m_Records);
  std::ostringstream csv;
  csv << "case,jaw,status,findings,matched_px,expected_error_px,seconds,message";
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
  return MakeJson(m_Records).dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string
BatchSummary::ToPage(const std::string & folder) const
{
  Json            json = MakeJson(m_Records);
  std::error_code error;
  for (Json & row : json["rows"])
  {
    row["page"] =
      !folder.empty() && fs::exists(fs::path(folder) / row["case"].get<std::string>() / "report.html", error);
  }
  std::string data = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  // Nothing in it ends the script that it stands in, nor begins what would hide the end.
  for (std::size_t place = data.find('<'); place != std::string::npos; place = data.find('<', place))
  {
    data.replace(place, 1, "\\u003c");
  }
  std::string            page = BatchPage;
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

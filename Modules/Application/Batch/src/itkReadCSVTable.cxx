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
#include "itkReadCSVTable.h"

#include "itkDentalInputError.h"

#include <csv.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace itk
{
namespace
{
bool
IsUTF8(const std::string & text)
{
  try
  {
    nlohmann::json(text).dump();
    return true;
  }
  catch (const nlohmann::json::type_error &)
  {
    return false;
  }
}

/** A table as libcsv reads it. */
class Table
{
public:
  Table(const std::string & text, const std::string & fileName)
  {
    if (text.compare(0, 2, "\xff\xfe") == 0 || text.compare(0, 2, "\xfe\xff") == 0)
    {
      itkDentalInputErrorMacro(fileName, "", "is UTF-16", "save it as CSV in UTF-8");
    }
    if (text.find('\0') != std::string::npos)
    {
      itkDentalInputErrorMacro(fileName, "", "is no text: it has bytes of zero", "save it as CSV in UTF-8");
    }
    // A cell takes thirty bytes, empty or not: of 32 MiB of commas it would be gigabytes.
    constexpr std::ptrdiff_t mostRows = 200000;
    constexpr std::ptrdiff_t mostCells = 4000000;
    const auto               lines = std::count(text.begin(), text.end(), '\n');
    const auto               parts =
      std::count_if(text.begin(), text.end(), [](char letter) { return letter == ',' || letter == ';'; });
    if (lines > mostRows || lines + parts > mostCells)
    {
      itkDentalInputErrorMacro(fileName,
                               "",
                               "has " + std::to_string(lines) + " rows of " + std::to_string(lines + parts) +
                                 " cells, more than the " + std::to_string(mostRows) + " rows and " +
                                 std::to_string(mostCells) + " cells that are read",
                               "split it into several tables");
    }
    csv_parser parser;
    if (csv_init(&parser, CSV_APPEND_NULL) != 0)
    {
      itkDentalInputErrorMacro(fileName, "", "cannot be read: not enough memory", "close other programs");
    }
    // What is no comma in half of Europe.
    const std::size_t end = text.find('\n');
    const std::string header = text.substr(0, end);
    if (header.find(',') == std::string::npos && header.find(';') != std::string::npos)
    {
      csv_set_delim(&parser, ';');
    }
    const std::size_t first = text.compare(0, 3, "\xef\xbb\xbf") == 0 ? 3 : 0;
    const std::size_t count = text.size() - first;
    const std::size_t parsed = csv_parse(&parser, text.data() + first, count, &Table::OnCell, &Table::OnRow, this);
    // The end of a line ends the last row, but within quotes: what is left then has swallowed the rows that followed.
    csv_parse(&parser, "\n", 1, &Table::OnCell, &Table::OnRow, this);
    const std::size_t whole = rows.size();
    csv_fini(&parser, &Table::OnCell, &Table::OnRow, this);
    const int problem = csv_error(&parser);
    csv_free(&parser);
    if (parsed != count)
    {
      itkDentalInputErrorMacro(fileName, "", std::string("is no table: ") + csv_strerror(problem), "save it as CSV");
    }
    if (rows.size() > whole)
    {
      itkDentalInputErrorMacro(fileName,
                               "row " + std::to_string(rows.size()),
                               "has a quotation mark that is never closed: all that follows would be one cell",
                               "close it, or take it out");
    }
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
      if (!std::all_of(rows[i].begin(), rows[i].end(), IsUTF8))
      {
        itkDentalInputErrorMacro(
          fileName, "row " + std::to_string(i + 1), "has letters that are not UTF-8", "save it as CSV in UTF-8");
      }
    }
  }

  std::vector<std::vector<std::string>> rows;

private:
  static void
  OnCell(void * cell, std::size_t size, void * self)
  {
    static_cast<Table *>(self)->m_Row.emplace_back(cell == nullptr ? "" : static_cast<const char *>(cell), size);
  }
  static void
  OnRow(int, void * self)
  {
    auto * const table = static_cast<Table *>(self);
    table->rows.push_back(table->m_Row);
    table->m_Row.clear();
  }

  std::vector<std::string> m_Row;
};
} // namespace

std::vector<std::vector<std::string>>
ReadCSVTable(const std::string & text, const std::string & fileName)
{
  return Table(text, fileName).rows;
}
} // namespace itk

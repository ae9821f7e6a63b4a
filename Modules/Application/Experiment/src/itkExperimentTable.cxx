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
#include "itkExperimentTable.h"

#include "itkCSVField.h"

#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>
#include <stdexcept>

namespace itk
{
void
ExperimentTable::AddRow(const std::vector<std::string> & row)
{
  if (row.size() != m_Header.size())
  {
    throw std::logic_error("a row of " + std::to_string(row.size()) + " cells under " +
                           std::to_string(m_Header.size()) + " headings");
  }
  m_Rows.push_back(row);
}

std::string
ExperimentTable::ToCSV() const
{
  std::ostringstream text;
  const auto         write = [&](const std::vector<std::string> & cells) {
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      text << (i > 0 ? "," : "") << ToCSVField(cells[i]);
    }
    text << '\n';
  };
  write(m_Header);
  for (const auto & row : m_Rows)
  {
    write(row);
  }
  return text.str();
}

std::string
ExperimentTable::ToMarkdown() const
{
  std::ostringstream text;
  const auto         write = [&](const std::vector<std::string> & cells) {
    for (const std::string & cell : cells)
    {
      text << "| ";
      for (const char character : cell)
      {
        text << (character == '|' ? "\\|" : character == '\n' ? " " : std::string(1, character));
      }
      text << ' ';
    }
    text << "|\n";
  };
  write(m_Header);
  for (std::size_t i = 0; i < m_Header.size(); ++i)
  {
    text << (i == 0 ? "|---" : "|---:");
  }
  text << "|\n";
  for (const auto & row : m_Rows)
  {
    write(row);
  }
  return text.str();
}

std::string
ExperimentTable::Number(double value, int digits)
{
  if (!std::isfinite(value))
  {
    return std::string();
  }
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}
} // namespace itk

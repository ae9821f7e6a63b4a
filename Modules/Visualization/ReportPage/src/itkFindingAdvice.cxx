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
#include "itkFindingAdvice.h"

#include "itkReportParts.h"
#include "itkReportText.h"
#include "itkTrimText.h"

#include <sstream>
#include <vector>

namespace itk
{
namespace
{
/** Words between back quotes are code, a link is its words: what the table uses of Markdown. */
std::string
ToHTML(const std::string & markdown)
{
  std::string html;
  bool        code = false;
  for (std::size_t i = 0; i < markdown.size(); ++i)
  {
    const std::size_t middle = markdown.find("](", i);
    const std::size_t end = markdown.find(')', i);
    if (markdown[i] == '`')
    {
      html += code ? "</code>" : "<code>";
      code = !code;
    }
    else if (markdown[i] == '[' && middle != std::string::npos && end != std::string::npos && middle < end)
    {
      html += EscapeForPage(markdown.substr(i + 1, middle - i - 1));
      i = end;
    }
    else
    {
      html += EscapeForPage(markdown.substr(i, 1));
    }
  }
  return html + (code ? "</code>" : "");
}
} // namespace

std::string
GetFindingAdvice(const std::string & code)
{
  std::istringstream lines{ std::string(ReportParts::Findings()) };
  std::string        line;
  while (std::getline(lines, line))
  {
    // | `code` | severity | what was seen | what to do |
    std::vector<std::string> cells;
    std::istringstream       row(line);
    std::string              cell;
    while (std::getline(row, cell, '|'))
    {
      cells.push_back(TrimText(cell));
    }
    if (cells.size() == 5 && cells[1] == '`' + code + '`')
    {
      return ToHTML(cells[4]);
    }
  }
  return "";
}
} // namespace itk

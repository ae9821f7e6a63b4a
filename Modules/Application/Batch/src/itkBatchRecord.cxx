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
#include "itkBatchRecord.h"

#include "itkJsonDocument.h"

#include <algorithm>
#include <filesystem>

namespace itk
{
void
BatchRecord::ReadResult(const std::string & folder)
{
  const auto root = JsonDocument::ReadFile((std::filesystem::path(folder) / "result.json").string()).GetRoot();
  status = root.Get("status").AsString();
  jaws.clear();
  const auto numberOf = [](const JsonNode & node, const char * group, const char * field) {
    const auto            outer = group == nullptr ? std::optional<JsonNode>(node) : node.Find(group);
    const auto            value = outer ? outer->Find(field) : std::nullopt;
    std::optional<double> number;
    if (value && value->IsNumber())
    {
      number = value->AsNumber();
    }
    return number;
  };
  for (const auto & member : root.Get("jaws").GetMembers())
  {
    JawType jaw;
    jaw.jaw = member.first;
    jaw.status = member.second.Get("status").AsString();
    if (const auto findings = member.second.Find("findings"))
    {
      for (std::size_t i = 0; i < findings->GetSize(); ++i)
      {
        const std::string code = findings->At(i).Get("code").AsString();
        if (std::find(jaw.findings.begin(), jaw.findings.end(), code) == jaw.findings.end())
        {
          jaw.findings.push_back(code);
        }
        jaw.message += (jaw.message.empty() ? "" : "; ") + findings->At(i).Get("text").AsString();
      }
    }
    jaw.matched = numberOf(member.second, "metrics_matched", "chamfer_px");
    jaw.expectedError = numberOf(member.second, nullptr, "expected_error_px");
    jaws.push_back(jaw);
  }
  if (const auto skipped = root.Find("skipped"))
  {
    for (const auto & member : skipped->GetMembers())
    {
      JawType jaw;
      jaw.jaw = member.first;
      jaw.status = "skipped";
      jaw.message = member.second.AsString();
      jaws.push_back(jaw);
    }
  }
  // What was said of the case as a whole, as that a field is not known: each row is read alone.
  if (const auto warnings = root.Find("warnings"))
  {
    for (std::size_t i = 0; i < warnings->GetSize(); ++i)
    {
      for (JawType & jaw : jaws)
      {
        jaw.message += (jaw.message.empty() ? "" : "; ") + warnings->At(i).AsString();
      }
    }
  }
}
} // namespace itk

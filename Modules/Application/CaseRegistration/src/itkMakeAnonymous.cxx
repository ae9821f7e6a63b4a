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
#include "itkMakeAnonymous.h"

#include "itkASCIICharacter.h"
#include "itkJsonDocument.h"
#include "itkVisitCaseFiles.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>

namespace itk
{
namespace
{
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/** What is not to be said, and what is said instead. */
class Cleaner
{
public:
  /** A file of the case, however it may be named in a sentence. */
  void
  Add(const std::string & field, const std::string & path, const std::string & folder)
  {
    if (path.empty())
    {
      return;
    }
    const std::string instead = '<' + field + '>';
    const fs::path    given = fs::u8path(path);
    const fs::path    whole = given.is_absolute() || folder.empty() ? given : fs::u8path(folder) / given;
    std::error_code   error;
    for (const fs::path & form :
         { given, whole, fs::absolute(whole, error).lexically_normal(), whole.lexically_normal(), given.filename() })
    {
      m_Words.emplace_back(form.u8string(), instead);
    }
    // A name of a patient may be that of the folder, or the file's without its ending; short ones are parts of words.
    constexpr std::size_t shortest = 4;
    const fs::path        part = fs::absolute(whole, error).lexically_normal().parent_path();
    m_Words.emplace_back(part.u8string(), "<folder>");
    for (const std::string & name : { part.filename().u8string(), whole.stem().u8string() })
    {
      if (name.size() >= shortest && name != field)
      {
        m_Words.emplace_back(name, instead);
      }
    }
    m_Sorted = false;
  }

  std::string
  Clean(const std::string & text)
  {
    if (!m_Sorted)
    {
      // The longest first: a file's name is a part of its path.
      std::stable_sort(
        m_Words.begin(), m_Words.end(), [](const auto & a, const auto & b) { return a.first.size() > b.first.size(); });
      m_Sorted = true;
    }
    std::string clean;
    for (std::size_t i = 0; i < text.size();)
    {
      const auto word = std::find_if(m_Words.begin(), m_Words.end(), [&](const auto & candidate) {
        return !candidate.first.empty() && IsAt(text, i, candidate.first);
      });
      if (word == m_Words.end())
      {
        clean += text[i++];
      }
      else
      {
        clean += word->second;
        i += word->first.size();
      }
    }
    return clean;
  }

  void
  Clean(std::vector<std::string> & texts)
  {
    for (std::string & text : texts)
    {
      text = this->Clean(text);
    }
  }

  /** A sentence, a list or an object of them; nothing where it is missing. */
  void
  Clean(Json & json)
  {
    if (json.is_string())
    {
      json = this->Clean(json.get<std::string>());
    }
    else if (json.is_structured())
    {
      for (auto & item : json)
      {
        this->Clean(item);
      }
    }
  }

private:
  /** Whether a word stands there by itself, and not within another. */
  static bool
  IsAt(const std::string & text, std::size_t place, const std::string & word)
  {
    const bool begins = place == 0 || !IsASCIIAlphanumeric(text[place - 1]) || !IsASCIIAlphanumeric(word.front());
    const auto end = place + word.size();
    const bool ends = end >= text.size() || !IsASCIIAlphanumeric(text[end]) || !IsASCIIAlphanumeric(word.back());
    return text.compare(place, word.size(), word) == 0 && begins && ends;
  }

  std::vector<std::pair<std::string, std::string>> m_Words;
  bool                                             m_Sorted{ true };
};
} // namespace

CaseResult
MakeAnonymous(const CaseResult & result)
{
  CaseResult  anonymous = result;
  Cleaner     cleaner;
  std::string folder;
  if (result.data)
  {
    const DentalCase & description = result.data->description;
    folder = fs::u8path(description.fileName).parent_path().u8string();
    // What was read may be named in a sentence, recorded as an input or not.
    cleaner.Add("case", description.fileName, "");
    VisitCaseFiles(description,
                   [&](const std::string & field, const std::string & path) { cleaner.Add(field, path, ""); });
  }
  for (CaseInputFile & input : anonymous.inputs)
  {
    cleaner.Add(input.field, input.path, input.field == "case" ? "" : folder);
    input.path.clear();
  }
  cleaner.Clean(anonymous.warnings);
  cleaner.Clean(anonymous.notCheckable);
  for (auto & skipped : anonymous.skipped)
  {
    skipped.second = cleaner.Clean(skipped.second);
  }
  for (auto & jaw : anonymous.jaws)
  {
    for (RegistrationFinding & finding : jaw.second.findings)
    {
      finding.text = cleaner.Clean(finding.text);
    }
  }
  for (CaseViewResult & view : anonymous.views)
  {
    for (RegistrationFinding & finding : view.findings)
    {
      finding.text = cleaner.Clean(finding.text);
    }
    // Its own: what it came from keeps its words.
    view.result = std::make_shared<CaseResult>(*view.result);
    auto data = std::make_shared<DentalCaseData>(*view.result->data);
    data->spacingProvenance = cleaner.Clean(data->spacingProvenance);
    view.result->data = data;
  }
  if (result.data)
  {
    auto data = std::make_shared<DentalCaseData>(*result.data);
    data->spacingProvenance = cleaner.Clean(data->spacingProvenance);
    anonymous.data = data;
  }
  anonymous.commandLine.clear();
  anonymous.anonymous = true;
  return anonymous;
}

std::string
MakeReportDetailsAnonymous(const std::string & text)
{
  JsonDocument::Verify(text, "report.json");
  Json json = Json::parse(text, nullptr, false);
  if (!json.is_object())
  {
    return text;
  }
  json.erase("command_line");
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string
MakeResultFileAnonymous(const std::string & text)
{
  JsonDocument::Verify(text, "result.json");
  Json json = Json::parse(text, nullptr, false);
  if (!json.is_object())
  {
    return text;
  }
  Cleaner     cleaner;
  std::string folder;
  if (json.contains("inputs") && json["inputs"].is_object())
  {
    for (const auto & input : json["inputs"].items())
    {
      const std::string path = input.value().is_object() ? input.value().value("path", "") : std::string();
      if (input.key() == "case")
      {
        folder = fs::u8path(path).parent_path().u8string();
      }
      cleaner.Add(input.key(), path, input.key() == "case" ? "" : folder);
    }
    for (auto & input : json["inputs"])
    {
      input.erase("path");
    }
  }
  // Sentences alone: a folder may have the name of anything that a program reads here.
  for (const char * sentences : { "warnings", "not_checkable", "skipped" })
  {
    if (json.contains(sentences))
    {
      cleaner.Clean(json[sentences]);
    }
  }
  const auto cleanEach = [&](Json & list, const char * member) {
    if (list.is_structured())
    {
      for (Json & item : list)
      {
        if (item.is_object() && item.contains(member))
        {
          cleaner.Clean(item[member]);
        }
      }
    }
  };
  cleanEach(json["geometry"], "how");
  if (json.contains("views") && json["views"].is_object())
  {
    for (Json & view : json["views"])
    {
      cleanEach(view["geometry"], "how");
      cleanEach(view["findings"], "text");
    }
  }
  cleanEach(json["jaws"], "reasons");
  if (json["jaws"].is_object())
  {
    for (Json & jaw : json["jaws"])
    {
      if (jaw.is_object() && jaw.contains("findings"))
      {
        cleanEach(jaw["findings"], "text");
      }
    }
  }
  json["anonymous"] = true;
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}
} // namespace itk

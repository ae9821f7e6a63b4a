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
#include "itkBatchCaseList.h"

#include "itkDentalCaseFileReader.h"
#include "itkDentalInputError.h"
#include "itkReadCSVTable.h"
#include "itkTextFile.h"

#include <glob.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

namespace itk
{
namespace
{
namespace fs = std::filesystem;

/** A name that can be a folder's: of the way to a file, without what cannot stand in one name. */
std::string
MakeId(const fs::path & way)
{
  std::string id;
  for (const auto & part : way)
  {
    if (part != "." && part != ".." && part != "/")
    {
      id += (id.empty() ? "" : "_") + part.string();
    }
  }
  return id;
}

/** Whether it is one folder below the output, in which nothing else lies. */
bool
IsFolderName(const std::string & id)
{
  // The tables and the page lie beside the folders.
  const bool isTaken = id == "summary.csv" || id == "summary.json" || id == "index.html";
  // What ends a line of a log, or moves a terminal's cursor, is no letter of a name.
  const bool isPlain = std::none_of(id.begin(), id.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; });
  // A record of the case has a few letters more, and 255 are what file systems allow.
  return !id.empty() && id.size() <= 240 && id[0] != '.' && id.find('/') == std::string::npos && !isTaken && isPlain;
}

/** The first of them, for a sentence. */
std::string
List(const std::vector<std::string> & words)
{
  constexpr std::size_t most = 5;
  std::string           text;
  for (std::size_t i = 0; i < std::min(most, words.size()); ++i)
  {
    text += (i == 0 ? "" : ", ") + (words[i].size() <= 60 ? words[i] : std::string("..."));
  }
  return words.size() <= most ? text : text + " and " + std::to_string(words.size() - most) + " more";
}

/** A walk through a folder and all below it. Folders that are links are entered, each folder once and by its own name
 * where it has one, so that a link that leads back leads nowhere. */
class FolderWalk
{
public:
  explicit FolderWalk(const fs::path & folder)
    : m_Root(folder)
  {
    m_Links.emplace_back(folder);
    // Links that are met are appended.
    for (std::size_t i = 0; i < m_Links.size(); ++i)
    {
      const fs::path link = m_Links[i];
      if (!this->Enter(link, false) && i > 0)
      {
        this->Add(link, without);
      }
    }
  }

  /** Every case.json. */
  std::vector<fs::path> found;
  /** Relative to where it began, the topmost ones: folders with no case in them, and ones that can't be read. */
  std::vector<std::string> without;
  std::vector<std::string> unreadable;

private:
  void
  Add(const fs::path & folder, std::vector<std::string> & to) const
  {
    to.push_back(folder == m_Root ? folder.string() : folder.lexically_relative(m_Root).string());
  }

  /** False: there is nothing of a case in it. */
  bool
  Enter(const fs::path & folder, bool isInCase)
  {
    std::error_code error;
    const fs::path  real = fs::canonical(folder, error);
    if (!error && !m_Entered.insert(real.string()).second)
    {
      return true;
    }
    std::vector<fs::path>  folders;
    fs::directory_iterator it(folder, error);
    bool                   isCase = isInCase;
    while (!error && it != fs::directory_iterator())
    {
      std::error_code ignored;
      const fs::path  path = it->path();
      if (path.filename() == "case.json" && it->is_regular_file(ignored))
      {
        found.push_back(path);
        isCase = true;
      }
      else if (it->is_directory(ignored) && path.filename().string()[0] != '.')
      {
        folders.push_back(path);
      }
      // What a batch has written is no case, and none is missing there.
      isCase = isCase || (path.filename() == ".batch" && it->is_directory(ignored));
      it.increment(error);
    }
    if (error)
    {
      this->Add(folder, unreadable);
      return true;
    }
    std::sort(folders.begin(), folders.end());
    std::vector<fs::path> empty;
    bool                  isAny = isCase;
    for (const fs::path & below : folders)
    {
      if (!fs::is_symlink(below, error))
      {
        if (this->Enter(below, isCase))
        {
          isAny = true;
        }
        else
        {
          empty.push_back(below);
        }
      }
      else if (!isCase)
      {
        // Later: it may be a second name of a folder that comes by its own.
        m_Links.push_back(below);
        isAny = true;
      }
    }
    if (isAny)
    {
      for (const fs::path & below : empty)
      {
        this->Add(below, without);
      }
    }
    return isAny;
  }

  fs::path              m_Root;
  std::vector<fs::path> m_Links;
  std::set<std::string> m_Entered;
};

/** After the folder of a case.json, after any other file's own name. */
BatchCase
MakeCase(const fs::path & file, const fs::path & from)
{
  const fs::path relative = from.empty() ? file : file.lexically_relative(from);
  BatchCase      made;
  const bool     isPlain = file.filename() == "case.json";
  fs::path       way = isPlain ? relative.parent_path() : relative.parent_path() / relative.stem();
  if (from.empty())
  {
    way = isPlain ? fs::absolute(file).lexically_normal().parent_path().filename() : file.stem();
  }
  else if (way.empty())
  {
    way = fs::absolute(from).lexically_normal().filename();
  }
  made.id = MakeId(way);
  made.arguments = { file.string() };
  return made;
}

std::vector<std::string>
SplitAtBlanks(const std::string & text)
{
  std::vector<std::string> words;
  std::string              word;
  for (const char c : text + ' ')
  {
    if (c != ' ')
    {
      word += c;
    }
    else if (!word.empty())
    {
      words.push_back(word);
      word.clear();
    }
  }
  return words;
}
} // namespace

void
BatchCaseList::SetOptionNames(const std::set<std::string> & options, const std::set<std::string> & files)
{
  m_Options = options;
  m_Files = files;
}

void
BatchCaseList::AddFolder(const std::string & folder, std::vector<BatchCase> & cases)
{
  FolderWalk      walk(folder);
  auto &          found = walk.found;
  std::error_code error;
  if (!walk.unreadable.empty() && walk.unreadable.front() == folder)
  {
    itkDentalInputErrorMacro(folder, "", "can't be read", "look at whom it belongs to, or copy it");
  }
  for (const std::string & name : walk.unreadable)
  {
    m_Warnings.push_back((fs::path(folder) / name).string() + ": can't be read, and is left out");
  }
  if (!found.empty() && !walk.without.empty())
  {
    m_Warnings.push_back(folder + ": no case.json is in " + List(walk.without) + ", left out");
  }
  if (found.empty())
  {
    for (const auto & entry : fs::directory_iterator(folder, error))
    {
      if (entry.path().extension() == ".json" && entry.is_regular_file(error) &&
          IsDentalCaseFile(entry.path().string()))
      {
        found.push_back(entry.path());
      }
    }
  }
  if (found.empty())
  {
    itkDentalInputErrorMacro(folder,
                             "",
                             "holds no case: neither a case.json below it nor case files in it",
                             "make case files, as with dentalscr new, or name a table of cases");
  }
  std::sort(found.begin(), found.end());
  for (const fs::path & file : found)
  {
    cases.push_back(MakeCase(file, folder));
  }
}

void
BatchCaseList::AddTable(const std::string & fileName, std::vector<BatchCase> & cases)
{
  const auto table = ReadCSVTable(ReadTextFile(fileName, "a table of cases"), fileName);
  if (table.size() < 2)
  {
    itkDentalInputErrorMacro(fileName, "", "has no row of a case", "give a header and a row a case");
  }
  const std::vector<std::string> & header = table.front();
  const fs::path                   folder = fs::path(fileName).parent_path();
  const bool                       hasFile = std::find(header.begin(), header.end(), "case") != header.end();
  bool                             hasField = false;
  for (const std::string & column : header)
  {
    if ((column == "case" || column == "id" || m_Options.count(column) != 0) &&
        std::count(header.begin(), header.end(), column) > 1)
    {
      itkDentalInputErrorMacro(fileName, "row 1", "has two columns \"" + column + '"', "keep one of the two");
    }
    const bool isField = m_Options.count(column) != 0;
    hasField = hasField || isField;
    if (column != "case" && column != "id" && (!isField || hasFile))
    {
      m_Warnings.push_back(
        fileName + ": column \"" + column + "\" is " +
        (isField ? "not used beside \"case\", and handed through" : "not known, and handed through"));
    }
  }
  if (!hasFile && !hasField)
  {
    itkDentalInputErrorMacro(fileName,
                             "",
                             "has neither a column \"case\" nor columns of options (upper, lower, contours, ...); its "
                             "columns are: " +
                               List(header),
                             "name the columns in the first row");
  }
  for (std::size_t i = 1; i < table.size(); ++i)
  {
    const std::vector<std::string> & row = table[i];
    const std::string                place = "row " + std::to_string(i + 1);
    if (row.size() > header.size())
    {
      itkDentalInputErrorMacro(fileName,
                               place,
                               "has " + std::to_string(row.size()) + " cells under " + std::to_string(header.size()) +
                                 " names",
                               "give as many");
    }
    BatchCase   made;
    std::string file;
    for (std::size_t k = 0; k < row.size(); ++k)
    {
      const std::string & column = header[k];
      const std::string & cell = row[k];
      if (column == "id")
      {
        made.id = cell;
      }
      else if (column == "case")
      {
        file = cell;
      }
      else if (!hasFile && m_Options.count(column) != 0)
      {
        if (!cell.empty())
        {
          made.arguments.push_back("--" + column);
          if (m_Files.count(column) != 0)
          {
            made.arguments.push_back(fs::absolute(folder / cell).lexically_normal().string());
          }
          else
          {
            const auto words = SplitAtBlanks(cell);
            made.arguments.insert(made.arguments.end(), words.begin(), words.end());
          }
        }
      }
      else
      {
        made.columns.emplace_back(column, cell);
      }
    }
    if (hasFile)
    {
      if (file.empty())
      {
        itkDentalInputErrorMacro(fileName, place, "has no case", "name a case file, or take the row out");
      }
      const BatchCase named = MakeCase((folder / file).lexically_normal(), "");
      made.arguments = named.arguments;
      made.id = made.id.empty() ? named.id : made.id;
    }
    else if (made.arguments.empty())
    {
      itkDentalInputErrorMacro(fileName, place, "names nothing of a case", "name its files, or take the row out");
    }
    if (made.id.empty())
    {
      made.id = "row" + std::to_string(i + 1);
    }
    if (!IsFolderName(made.id))
    {
      itkDentalInputErrorMacro(
        fileName, place, "the id \"" + made.id + "\" can't be a folder's name", "choose another");
    }
    cases.push_back(made);
  }
}

void
BatchCaseList::AddPattern(const std::string & pattern, std::vector<BatchCase> & cases) const
{
  glob_t                found{};
  std::vector<fs::path> paths;
  if (glob(pattern.c_str(), GLOB_TILDE, nullptr, &found) == 0)
  {
    paths.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  }
  globfree(&found);
  std::size_t count = 0;
  for (const fs::path & path : paths)
  {
    std::error_code error;
    const fs::path  file = fs::is_directory(path, error) ? path / "case.json" : path;
    if (fs::is_regular_file(file, error))
    {
      cases.push_back(MakeCase(file, ""));
      ++count;
    }
  }
  if (count == 0)
  {
    itkDentalInputErrorMacro(pattern,
                             "",
                             "is no file and no folder, and as a pattern matches no case",
                             "name a folder, a table of cases, or a pattern in quotes");
  }
}

std::vector<BatchCase>
BatchCaseList::Find(const std::vector<std::string> & inputs)
{
  m_Warnings.clear();
  std::vector<BatchCase> cases;
  for (const std::string & input : inputs)
  {
    std::error_code   error;
    const std::string extension = fs::path(input).extension().string();
    if (fs::is_directory(input, error))
    {
      this->AddFolder(input, cases);
    }
    else if (fs::is_regular_file(input, error) && (extension == ".csv" || extension == ".CSV"))
    {
      this->AddTable(input, cases);
    }
    else if (fs::is_regular_file(input, error))
    {
      cases.push_back(MakeCase(input, ""));
    }
    else
    {
      this->AddPattern(input, cases);
    }
  }
  std::map<std::string, const BatchCase *> names;
  for (const BatchCase & one : cases)
  {
    if (!IsFolderName(one.id))
    {
      itkDentalInputErrorMacro("batch",
                               one.id,
                               "can't be a folder's name, as the case " + one.arguments.back() + " would need",
                               "name it by a column \"id\" of a table of cases");
    }
    const auto added = names.emplace(one.id, &one);
    if (!added.second)
    {
      itkDentalInputErrorMacro("batch",
                               one.id,
                               "is the name of two cases, " + added.first->second->arguments.back() + " and " +
                                 one.arguments.back(),
                               "name them by a column \"id\" of a table of cases");
    }
  }
  return cases;
}
} // namespace itk

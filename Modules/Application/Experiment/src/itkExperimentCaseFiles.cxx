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
#include "itkExperimentCaseFiles.h"

#include "itkDentalCaseFileReader.h"
#include "itkDentalInputError.h"
#include "itkInputFile.h"
#include "itkVisitCaseFiles.h"

#include <itksys/MD5.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>

namespace itk
{
namespace
{
namespace fs = std::filesystem;

class Digest
{
public:
  Digest() { itksysMD5_Initialize(m_MD5.get()); }

  void
  AddText(const std::string & text)
  {
    itksysMD5_Append(m_MD5.get(), reinterpret_cast<const unsigned char *>(text.data()), static_cast<int>(text.size()));
  }

  void
  AddFile(const std::string & fileName)
  {
    InputFile      file(fileName);
    std::string    buffer(1u << 16, '\0');
    std::uintmax_t size = 0;
    while (size < file.GetSize())
    {
      const std::size_t count = file.Read(&buffer[0], buffer.size());
      if (count == 0)
      {
        break;
      }
      size += count;
      this->AddText(buffer.substr(0, count));
    }
    // So that no byte can move from one file to the next.
    this->AddText('#' + std::to_string(size) + '#');
  }

  std::string
  Get()
  {
    std::string text(32, '\0');
    itksysMD5_FinalizeHex(m_MD5.get(), &text[0]);
    return text;
  }

private:
  struct DeleterType
  {
    void
    operator()(itksysMD5 * md5) const
    {
      itksysMD5_Delete(md5);
    }
  };
  std::unique_ptr<itksysMD5, DeleterType> m_MD5{ itksysMD5_New() };
};
} // namespace

std::vector<std::pair<std::string, std::string>>
FindExperimentCaseFiles(const std::string & folder)
{
  const fs::path  root = fs::u8path(folder);
  std::error_code error;
  if (!fs::is_directory(root, error))
  {
    itkDentalInputErrorMacro(folder, "", "is no folder", "name a folder whose subfolders hold a case.json each");
  }
  std::vector<std::pair<std::string, std::string>> files;
  if (fs::exists(root / "case.json", error))
  {
    const fs::path name = fs::absolute(root).lexically_normal();
    files.emplace_back((root / "case.json").string(),
                       (name.has_filename() ? name : name.parent_path()).filename().string());
  }
  std::vector<fs::path> folders;
  for (const auto & entry : fs::directory_iterator(root, error))
  {
    if (fs::exists(entry.path() / "case.json", error))
    {
      folders.push_back(entry.path());
    }
  }
  std::sort(folders.begin(), folders.end());
  for (const fs::path & path : folders)
  {
    files.emplace_back((path / "case.json").string(), path.filename().string());
  }
  if (files.empty())
  {
    itkDentalInputErrorMacro(folder,
                             "",
                             "holds no case.json, nor does any folder in it",
                             "name a folder whose subfolders hold a case.json each");
  }
  // A folder and a folder in it may share a name. Subfolders keep theirs.
  std::set<std::string> names;
  for (auto file = files.rbegin(); file != files.rend(); ++file)
  {
    const std::string name = file->second;
    for (unsigned int number = 2; !names.insert(file->second).second; ++number)
    {
      file->second = name + '-' + std::to_string(number);
    }
  }
  return files;
}

std::string
DigestExperimentCase(const std::string & fileName)
{
  Digest digest;
  digest.AddFile(fileName);
  try
  {
    const DentalCase description = ReadDentalCase(fileName);
    VisitCaseFiles(description, [&digest](const std::string &, const std::string & path) {
      if (!path.empty())
      {
        digest.AddFile(path);
      }
    });
  }
  catch (const ExceptionObject &)
  {
    // It names no files; why it is unusable is said where it is loaded.
  }
  return digest.Get();
}
} // namespace itk

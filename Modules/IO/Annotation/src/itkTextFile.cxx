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
#include "itkTextFile.h"

#include "itkDentalInputError.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

namespace itk
{
namespace
{
struct FileCloser
{
  void
  operator()(std::FILE * file) const
  {
    std::fclose(file);
  }
};
using FilePointer = std::unique_ptr<std::FILE, FileCloser>;
} // namespace

std::string
ReadTextFile(const std::string & fileName, const std::string & what, std::size_t maximumSize)
{
  if (fileName.empty())
  {
    itkDentalInputErrorMacro("(no file name)", "", "no " + what + " file was named", "call SetFileName()");
  }
  std::error_code error;
  if (std::filesystem::is_directory(fileName, error))
  {
    itkDentalInputErrorMacro(fileName, "", "is a directory, not a " + what + " file", "name the file in it");
  }
  const FilePointer file(std::fopen(fileName.c_str(), "rb"));
  if (!file)
  {
    const int reason = errno;
    itkDentalInputErrorMacro(fileName,
                             "",
                             reason == ENOENT ? "no such file"
                                              : std::string("cannot be opened: ") + std::strerror(reason),
                             "check the path; in a case file it is relative to that file");
  }
  std::string content;
  char        buffer[1 << 16];
  for (std::size_t count = 0; (count = std::fread(buffer, 1, sizeof(buffer), file.get())) > 0;)
  {
    content.append(buffer, count);
    if (content.size() > maximumSize)
    {
      itkDentalInputErrorMacro(fileName,
                               "",
                               "is longer than " + std::to_string(maximumSize) + " bytes, too long for a " + what +
                                 " file",
                               "check that this is the right file");
    }
  }
  if (std::ferror(file.get()) != 0)
  {
    itkDentalInputErrorMacro(fileName, "", "reading failed: " + std::string(std::strerror(errno)), "check the medium");
  }
  if (content.empty())
  {
    itkDentalInputErrorMacro(fileName, "", "is empty", "write the " + what + " file again");
  }
  return content;
}

void
WriteFileAtomically(const std::string & fileName, const std::string & content)
{
  const auto fail = [&fileName](const std::string & problem) {
    itkDentalInputErrorMacro(
      fileName, "", "cannot be written: " + problem, "name a file in an existing folder that may be written to");
  };
  if (fileName.empty())
  {
    itkDentalInputErrorMacro("(no file name)", "", "no output file was named", "call SetFileName()");
  }
  std::error_code status;
  if (std::filesystem::is_directory(fileName, status))
  {
    fail("is a directory");
  }
  // Exclusive creation makes the name unique among processes without a random number.
  std::string temporary;
  FilePointer file;
  for (unsigned int attempt = 0; attempt < 1000 && !file; ++attempt)
  {
    temporary = fileName + ".tmp" + std::to_string(attempt);
    file.reset(std::fopen(temporary.c_str(), "wbx"));
    if (!file && errno != EEXIST)
    {
      fail(std::strerror(errno));
    }
  }
  if (!file)
  {
    fail("too many temporary files beside it");
  }
  bool written = std::fwrite(content.data(), 1, content.size(), file.get()) == content.size();
  written = std::fclose(file.release()) == 0 && written;
  if (!written)
  {
    const int reason = errno;
    std::filesystem::remove(temporary, status);
    fail(std::strerror(reason));
  }
  std::filesystem::rename(temporary, fileName, status);
  if (status)
  {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    fail(status.message());
  }
}
} // namespace itk

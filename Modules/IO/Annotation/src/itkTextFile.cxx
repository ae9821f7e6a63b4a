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
#include "itkInputFile.h"
#include "itkOutputFile.h"

#include <cstring>

namespace itk
{
std::string
ReadTextFile(const std::string & fileName, const std::string & what, std::size_t maximumSize)
{
  if (fileName.empty())
  {
    itkDentalInputErrorMacro("(no file name)", "", "no " + what + " file was named", "call SetFileName()");
  }
  using ProblemEnum = InputFile::ProblemEnum;
  InputFile file(fileName);
  switch (file.GetProblem())
  {
    case ProblemEnum::None:
    case ProblemEnum::Empty:
      break;
    case ProblemEnum::Folder:
      itkDentalInputErrorMacro(fileName, "", "is a directory, not a " + what + " file", "name the file in it");
    case ProblemEnum::NotRegular:
      itkDentalInputErrorMacro(
        fileName, "", "is no regular file but a pipe, a socket or a device", "write what it gives to a file first");
    default:
      itkDentalInputErrorMacro(fileName,
                               "",
                               file.GetProblem() == ProblemEnum::Missing
                                 ? "no such file"
                                 : std::string("cannot be opened: ") + std::strerror(file.GetSystemError()),
                               "check the path; in a case file it is relative to that file");
  }
  if (file.GetSize() > maximumSize)
  {
    itkDentalInputErrorMacro(fileName,
                             "",
                             "is longer than " + std::to_string(maximumSize) + " bytes, too long for a " + what +
                               " file",
                             "check that this is the right file");
  }
  std::string content(file.GetSize(), '\0');
  const bool  isWhole = file.Read(&content[0], content.size()) == content.size();
  if (!isWhole && file.GetSystemError() != 0)
  {
    itkDentalInputErrorMacro(
      fileName, "", std::string("reading failed: ") + std::strerror(file.GetSystemError()), "check the medium");
  }
  if (!content.empty() && (!isWhole || file.HasChanged()))
  {
    itkDentalInputErrorMacro(
      fileName, "", "was changed while it was read", "start again when it is written completely");
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
  OutputFile file(fileName);
  file.Write(content.data(), content.size());
  file.Commit();
}
} // namespace itk

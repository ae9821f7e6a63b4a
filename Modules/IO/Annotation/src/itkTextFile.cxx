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

namespace itk
{
std::string
ReadTextFile(const std::string & fileName, const std::string & what, std::size_t maximumSize)
{
  if (fileName.empty())
  {
    itkDentalInputErrorMacro(
      "(no file name)", "", "no file was named where " + what + " is read", "call SetFileName()");
  }
  try
  {
    InputFile file(fileName);
    return ReadWhole(file, what, maximumSize);
  }
  catch (const InputFileError & error)
  {
    itkDentalInputErrorMacro(fileName, "", error.what(), error.GetRemedy());
  }
}

void
WriteFileAtomically(const std::string & fileName, const std::string & content)
{
  OutputFile file(fileName);
  file.Write(content.data(), content.size());
  file.Commit();
}
} // namespace itk

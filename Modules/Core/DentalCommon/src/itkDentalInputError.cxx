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
#include "itkDentalInputError.h"

#include "itkMakeUTF8.h"

namespace itk
{
namespace
{
std::string
JoinToOneLine(const std::string & file,
              const std::string & field,
              const std::string & problem,
              const std::string & remedy)
{
  std::string line = file;
  for (const std::string * part : { &field, &problem })
  {
    if (!part->empty())
    {
      line += line.empty() ? *part : ": " + *part;
    }
  }
  if (!remedy.empty())
  {
    line += "; " + remedy;
  }
  for (char & character : line)
  {
    if (character == '\n' || character == '\r')
    {
      character = ' ';
    }
  }
  return MakeUTF8(line);
}
} // namespace

DentalInputError::DentalInputError(const char *        sourceFile,
                                   unsigned int        sourceLine,
                                   const std::string & file,
                                   const std::string & field,
                                   const std::string & problem,
                                   const std::string & remedy)
  : ExceptionObject(sourceFile, sourceLine, JoinToOneLine(file, field, problem, remedy))
  , m_InputFile(file)
  , m_Field(MakeUTF8(field))
  , m_Problem(MakeUTF8(problem))
  , m_Remedy(MakeUTF8(remedy))
{}

DentalInputError::~DentalInputError() = default;

std::string
DentalInputError::GetOneLine() const
{
  return JoinToOneLine(m_InputFile, m_Field, m_Problem, m_Remedy);
}
} // namespace itk

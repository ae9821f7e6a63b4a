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
#ifndef itkDentalInputError_h
#define itkDentalInputError_h

#include "DentalCommonExport.h"
#include "itkMacro.h"

#include <string>

namespace itk
{
/** \class DentalInputError
 * \brief What is wrong with an input, in words for the person who made it.
 *
 * Carries the file, the field in it (may be empty) and the remedy apart, so that a program can print one line. Thrown
 * by every reader of the toolkit for unusable input; programs map it to exit code 2.
 *
 * \ingroup DentalCommon
 */
class DentalCommon_EXPORT DentalInputError : public ExceptionObject
{
public:
  /** \param file     the file as the user named it
   *  \param field    the field, record or line in it, e.g. "cephalogram.pixel_spacing_mm"; may be empty
   *  \param problem  what is wrong, with the offending value
   *  \param remedy   what to do about it; may be empty */
  DentalInputError(const char *        sourceFile,
                   unsigned int        sourceLine,
                   const std::string & file,
                   const std::string & field,
                   const std::string & problem,
                   const std::string & remedy = {});
  ~DentalInputError() override;

  itkTypeMacro(DentalInputError, ExceptionObject);
  /** File, field, what is wrong with it and what to do about it, in words; "" where there is none. */
  const std::string &
  GetInputFile() const
  {
    return m_InputFile;
  }
  const std::string &
  GetField() const
  {
    return m_Field;
  }
  const std::string &
  GetProblem() const
  {
    return m_Problem;
  }
  const std::string &
  GetRemedy() const
  {
    return m_Remedy;
  }

  /** "file: field: problem; remedy" on one line. */
  std::string
  GetOneLine() const;

private:
  std::string m_InputFile;
  std::string m_Field;
  std::string m_Problem;
  std::string m_Remedy;
};
} // namespace itk

/** Throws a DentalInputError from here. */
#define itkDentalInputErrorMacro(file, field, problem, remedy) \
  throw ::itk::DentalInputError(__FILE__, __LINE__, file, field, problem, remedy)

#endif

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
#ifndef dentalscrCaseOptions_h
#define dentalscrCaseOptions_h

#include "CommandLineExport.h"

#include "itkDentalCase.h"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace dentalscr
{
/** \class CaseOptions
 * \brief A case without a case file: an option for each of its fields, read by the same reader, so that each means what
 * it means there and a mistake is told in the same words. */
class CommandLine_EXPORT CaseOptions
{
public:
  void
  AddTo(CLI::App * command); /**< Adds the options to a verb. */
  /** How many of these options the caller has given. */
  std::size_t
  CountGiven() const;
  /** The first of the options that was given, for a message; "" where none was. */
  std::string
  GetFirstGiven() const;
  /** Of an option of one word; "" where it was not given. */
  std::string
  GetValue(const std::string & option) const;

  /** Of all options, without dashes; and of these the ones whose value is the name of a file. */
  static std::set<std::string>
  GetNames();
  static std::set<std::string>
  GetFileNames();

  /** The case that they make; the names of files are from the current directory. One that is yet to be drawn needs
   * neither tracing nor landmarks. Throws DentalInputError. */
  itk::DentalCase
  Read(bool isDrawn = true) const;

private:
  /** One field: where it stands in a case file, and what the command line gave for it. */
  struct FieldType
  {
    const char * option;
    /** "cephalogram.facing" is the field of an object. */
    const char *             field;
    const char *             help;
    std::vector<std::string> values;
    /** 0 for words, else how many numbers. */
    std::size_t numbers{ 0 };
    /** Whether the word is the name of a file. */
    bool isFile{ false };
    /** What the case file's reader takes, as --help and completion list it; it is that reader which refuses others. */
    const char * words{ "" };
  };
  static std::vector<FieldType>
  MakeFields();

  std::vector<FieldType> m_Fields{ MakeFields() };
};
} // namespace dentalscr

#endif

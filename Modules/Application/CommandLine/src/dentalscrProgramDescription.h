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
#ifndef dentalscrProgramDescription_h
#define dentalscrProgramDescription_h

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace dentalscr
{
/** Headings of --help: what every verb takes as well, and what makes the program speak of itself and end. */
constexpr char CommonGroup[] = "Options of every verb";
constexpr char SelfGroup[] = "About the program";

/** An option, or an argument by position, as the parser knows it. */
struct OptionDescription
{
  enum class ValueEnum
  {
    None,
    Number,
    Choice,
    Folder,
    File,
    List
  };

  /** With their dashes, short ones first; of an argument by position its one name without. */
  std::vector<std::string> names;
  std::string              help;
  std::string              group;
  /** As --help prints it: TEXT, UINT, ... */
  std::string type;
  ValueEnum   value{ ValueEnum::None };
  /** All that may be given, where the parser refuses anything else. */
  std::vector<std::string> choices;
  std::string              defaultValue;
  /** How many words follow it; the most that the parser can count where it takes any number. */
  int  numberOfValues{ 0 };
  bool takesAny{ false };
  bool isPositional{ false };
  bool isRequired{ false };
};

/** A verb with what it takes; or the program itself. */
struct VerbDescription
{
  std::string                    name;
  std::string                    help;
  std::vector<OptionDescription> options;
  /** What --help prints below the options: exit codes, examples. */
  std::string notes;
};

/** What the program says of itself, read from the parser and nowhere else: manual pages, completion of three shells and
 * --describe are written from it, so that none of them can lag behind --help. */
struct ProgramDescription
{
  VerbDescription program;
  /** Those of the program's options that every verb takes. */
  std::vector<OptionDescription> common;
  std::string                    version;
  std::vector<VerbDescription>   verbs;
};

ProgramDescription
DescribeProgram(const CLI::App & program);

/** What --describe prints: the description as JSON. */
std::string
ToJson(const ProgramDescription & description);
} // namespace dentalscr

#endif

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
#include "dentalscrManualPage.h"

#include "itkASCIICharacter.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace dentalscr
{
namespace
{
/** Text as roff prints it: a dash that is typed, no request at the beginning of a line. */
std::string
Escape(const std::string & text)
{
  std::string result;
  for (const char c : text)
  {
    if (c == '\\')
    {
      result += "\\e";
    }
    else if (c == '-')
    {
      result += "\\-";
    }
    else
    {
      result += c == '\n' ? ' ' : c;
    }
  }
  if (!result.empty() && (result[0] == '.' || result[0] == '\''))
  {
    result.insert(0, "\\&");
  }
  return result;
}

std::string
Capitalize(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), itk::ToASCIIUpperCase);
  return text;
}

/** What stands for an option's value: its type, in the slant of what is to be replaced, or the words to choose from. */
std::string
WriteValue(const OptionDescription & option)
{
  if (option.value == OptionDescription::ValueEnum::None)
  {
    return "";
  }
  std::string value;
  if (option.choices.empty())
  {
    value = "\\fI" + Escape(option.type.substr(0, option.type.find(':'))) + "\\fR";
  }
  else
  {
    for (const std::string & choice : option.choices)
    {
      value += (value.empty() ? "\\fB" : "|\\fB") + Escape(choice) + "\\fR";
    }
  }
  std::string result;
  for (int i = 0; i < (option.takesAny ? 1 : option.numberOfValues); ++i)
  {
    result += (i > 0 ? " " : "") + value;
  }
  return option.takesAny ? result + " ..." : result;
}

std::string
WriteNames(const OptionDescription & option)
{
  std::string result;
  for (const std::string & name : option.names)
  {
    result += result.empty() ? "" : ", ";
    result += (option.isPositional ? "\\fI" : "\\fB") + Escape(name) + "\\fR";
  }
  return result;
}

void
WriteOption(std::ostream & page, const OptionDescription & option)
{
  const std::string value = option.isPositional ? "" : WriteValue(option);
  page << ".TP\n" << WriteNames(option) << (value.empty() ? "" : " " + value) << '\n';
  // Without a help the paragraph would swallow the next one.
  page << (option.help.empty() ? "\\&" : Escape(option.help) + ".");
  // The range, which CLI11 writes behind the type: "UINT:INT in [0 - 1024]".
  const std::size_t range = option.type.find(" in [");
  if (range != std::string::npos)
  {
    page << " From " << Escape(option.type.substr(range + 5, option.type.find(']') - range - 5)) << '.';
  }
  if (!option.defaultValue.empty())
  {
    page << " Default: " << Escape(option.defaultValue) << '.';
  }
  page << (option.isRequired && !option.isPositional ? " Required.\n" : "\n");
}

void
WriteOptions(std::ostream & page, const VerbDescription & verb)
{
  const auto write = [&](const char * title, auto && isMeant) {
    std::vector<std::string> groups;
    for (const OptionDescription & option : verb.options)
    {
      if (isMeant(option) && std::find(groups.begin(), groups.end(), option.group) == groups.end())
      {
        groups.push_back(option.group);
      }
    }
    for (const std::string & group : groups)
    {
      page << ".SH " << (group == "Options" || group == "Positionals" ? title : Capitalize(Escape(group))) << '\n';
      for (const OptionDescription & option : verb.options)
      {
        if (isMeant(option) && option.group == group)
        {
          WriteOption(page, option);
        }
      }
    }
  };
  write("ARGUMENTS", [](const OptionDescription & option) { return option.isPositional; });
  write("OPTIONS", [](const OptionDescription & option) { return !option.isPositional; });
}

/** The text below the options of --help: lines that are indented are commands to type or a name with its words. */
void
WriteNotes(std::ostream & page, const std::string & notes)
{
  if (notes.empty())
  {
    return;
  }
  page << ".SH NOTES\n";
  std::istringstream lines(notes);
  std::string        line;
  bool               startsParagraph = false;
  while (std::getline(lines, line))
  {
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin == std::string::npos)
    {
      startsParagraph = true;
      continue;
    }
    const std::string words = line.substr(begin);
    const std::size_t colon = words.find(": ");
    if (begin > 0 && words.rfind("dentalscr ", 0) != 0 && colon != std::string::npos)
    {
      page << ".TP\n\\fB" << Escape(words.substr(0, colon)) << "\\fR\n" << Escape(words.substr(colon + 2)) << '\n';
      startsParagraph = true;
    }
    else if (begin > 0)
    {
      page << ".PP\n.in +2\n.nf\n" << Escape(words) << "\n.fi\n.in\n";
      startsParagraph = true;
    }
    else
    {
      page << (startsParagraph ? ".PP\n" : "") << Escape(words) << '\n';
      startsParagraph = false;
    }
  }
}

/** A line of the head's date would make each build another one. */
void
WriteHead(std::ostream & page, const ProgramDescription & description, const std::string & title)
{
  page << ".\\\" Written by dentalscr --man from what the program says of itself.\n.TH " << Capitalize(Escape(title))
       << " 1 \"\" \"DentalSCR " << description.version << "\" \"DentalSCR\"\n.nh\n.ad l\n";
}

std::string
WriteProgram(const ProgramDescription & description)
{
  std::ostringstream page;
  WriteHead(page, description, "dentalscr");
  const std::string & help = description.program.help;
  const std::size_t   end = help.find('\n');
  std::string         summary = help.substr(0, end);
  summary[0] = itk::ToASCIILowerCase(summary[0]);
  summary.erase(summary.find_last_not_of('.') + 1);
  page << ".SH NAME\ndentalscr \\- " << Escape(summary) << '\n'
       << ".SH SYNOPSIS\n\\fBdentalscr\\fR \\fIVERB\\fR [\\fIARGUMENTS\\fR] [\\fIOPTIONS\\fR]\n"
       << ".SH DESCRIPTION\n"
       << Escape(help) << "\n.SH VERBS\n";
  for (const VerbDescription & verb : description.verbs)
  {
    page << ".TP\n\\fB" << verb.name << "\\fR\n"
         << Escape(verb.help) << ".\nSee \\fBdentalscr\\-" << verb.name << "\\fR(1).\n";
  }
  WriteOptions(page, description.program);
  page << ".SH EXIT STATUS\n"
       << ".TP\n0\nAll that was asked for was done.\n"
       << ".TP\n1\nSome jaw or case could not be registered.\n"
       << ".TP\n2\nThe input can't be used; one line says which file and field, and what to do.\n";
  WriteNotes(page, description.program.notes);
  return page.str();
}

std::string
WriteVerb(const ProgramDescription & description, const VerbDescription & verb)
{
  std::ostringstream page;
  WriteHead(page, description, "dentalscr-" + verb.name);
  std::string summary = verb.help;
  summary[0] = itk::ToASCIILowerCase(summary[0]);
  page << ".SH NAME\ndentalscr\\-" << verb.name << " \\- " << Escape(summary) << '\n'
       << ".SH SYNOPSIS\n\\fBdentalscr " << verb.name << "\\fR";
  for (const OptionDescription & option : verb.options)
  {
    if (option.isPositional)
    {
      const std::string name = WriteNames(option) + (option.takesAny ? " ..." : "");
      page << ' ' << (option.isRequired ? name : "[" + name + "]");
    }
    else if (option.isRequired)
    {
      page << " \\fB" << Escape(option.names.back()) << "\\fR " << WriteValue(option);
    }
  }
  page << " [\\fIOPTIONS\\fR]\n.SH DESCRIPTION\n" << Escape(verb.help) << ".\n";
  WriteOptions(page, verb);
  page << ".SH OPTIONS OF EVERY VERB\n";
  for (const OptionDescription & option : description.common)
  {
    WriteOption(page, option);
  }
  WriteNotes(page, verb.notes);
  page << ".SH SEE ALSO\n\\fBdentalscr\\fR(1)\n";
  return page.str();
}
} // namespace

std::string
WriteManualPage(const ProgramDescription & description, const std::string & verb)
{
  if (verb.empty())
  {
    return WriteProgram(description);
  }
  for (const VerbDescription & known : description.verbs)
  {
    if (known.name == verb)
    {
      return WriteVerb(description, known);
    }
  }
  throw std::invalid_argument("there is no verb \"" + verb + "\" to write a manual page of; see dentalscr --help");
}
} // namespace dentalscr

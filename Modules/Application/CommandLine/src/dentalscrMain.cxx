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
#include "dentalscrCommands.h"
#include "dentalscrManualPage.h"
#include "dentalscrProgramDescription.h"
#include "dentalscrRunGuarded.h"
#include "dentalscrShellCompletion.h"

#include "itkDentalSCRVersion.h"

#include "itkVersion.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace dentalscr
{
namespace
{
/** The help of a verb ends with the options that every verb has: a verb has no further verbs, which would stand there.
 */
class HelpFormatter : public CLI::Formatter
{
public:
  std::string
  make_subcommands(const CLI::App * app, CLI::AppFormatMode mode) const override
  {
    if (app->get_parent() == nullptr)
    {
      return CLI::Formatter::make_subcommands(app, mode);
    }
    return this->make_group(CommonGroup, false, app->get_parent()->get_options([](const CLI::Option * option) {
      return option->get_group() == CommonGroup;
    }));
  }
};

/** What the program is asked to say of itself ends it, as --version does. */
void
AddSelfDescription(CLI::App & program)
{
  const auto print = [](const std::string & text) { throw CLI::CallForVersion(text, AllRegistered); };
  program
    .add_option_function<std::string>(
      "--completion",
      [&program, print](const std::string & shell) { print(WriteShellCompletion(DescribeProgram(program), shell)); },
      "Print a script that completes what is typed")
    ->check(CLI::IsMember(GetCompletionShells()))
    ->group(SelfGroup);
  // With the name of a verb it never comes here (Run()).
  program
    .add_option_function<std::string>(
      "--man",
      [&program, print](const std::string & verb) { print(WriteManualPage(DescribeProgram(program), verb)); },
      "Print a manual page: that of a verb, or the program's")
    ->type_name("VERB")
    ->expected(0, 1)
    ->group(SelfGroup);
  program
    .add_flag_callback(
      "--describe",
      [&program, print]() { print(ToJson(DescribeProgram(program))); },
      "Print all verbs and options as JSON")
    ->group(SelfGroup);
  program
    .add_flag_callback(
      "--xml", [print]() { print(SlicerDescription()); }, "Print the verb register as a module of 3D Slicer")
    ->group(SelfGroup);
}

/** Numbers of more digits than any that means something, given or the parser's own bounds, by their first ones. */
std::string
ShortenNumbers(const std::string & text)
{
  constexpr std::size_t longest = 24;
  constexpr std::size_t shown = 12;
  std::string           shortened;
  for (std::size_t begin = 0; begin < text.size();)
  {
    const std::size_t end = std::min(text.find_first_not_of("0123456789.", begin), text.size());
    const std::size_t count = end - begin;
    shortened += count > longest ? text.substr(begin, shown) + "... (" + std::to_string(count) + " digits)"
                                 : text.substr(begin, count);
    const std::size_t next = std::min(text.find_first_of("0123456789.", end), text.size());
    shortened += text.substr(end, next - end);
    begin = next;
  }
  return shortened;
}

/** What is wrong with the words of a call, and whose help to read. */
std::string
DescribeMistake(const CLI::App & program, const CLI::ParseError & error)
{
  const auto        chosen = program.get_subcommands();
  const std::string name = chosen.empty() ? program.get_name() : program.get_name() + ' ' + chosen.front()->get_name();
  const std::string help = "; see " + name + " --help";
  if (dynamic_cast<const CLI::RequiredError *>(&error) != nullptr)
  {
    if (chosen.empty())
    {
      return "name a verb, such as register" + help;
    }
    // The parser looks for what is missing first: of a misspelt option it would say that it is required.
    for (const std::string & word : program.remaining(true))
    {
      if (word.size() > 1 && word[0] == '-')
      {
        return "there is no option \"" + word + '"' + help;
      }
    }
  }
  // Not where it is a file that is wrong: names of DICOM files are numbers as long.
  const std::string text = error.what();
  const bool isNumber = text.find(" not in range ") != std::string::npos || text.rfind("Could not convert", 0) == 0;
  return (isNumber ? ShortenNumbers(text) : text) + help;
}

int
Run(int argc, const char * const * argv)
{
  CLI::App program{ "Aligns 3-D intraoral scans of the teeth with a lateral cephalometric radiograph.\n"
                    "Research software, not a medical device." };
  program.name("dentalscr");
  program.formatter(std::make_shared<HelpFormatter>());
  program.set_version_flag(
    "--version", std::string("dentalscr ") + itk::DentalSCRVersion + " (ITK " + itk::Version::GetITKVersion() + ")");
  program.require_subcommand(1);
  program.fallthrough();
  program.footer("Example:\n"
                 "  dentalscr phantom --output sample\n"
                 "  dentalscr register sample/case.json --output result\n"
                 "Each verb has its own --help with examples.");

  CommonOptions common;
  program.add_option("--threads", common.threads, "Number of threads (0: all); the result is the same for any")
    ->check(CLI::Range(0u, 1024u))
    ->group(CommonGroup);
  program.add_flag("--quiet", common.quiet, "No progress and no summary")->group(CommonGroup);
  AddSelfDescription(program);

  RunFunction run;
  AddRegisterCommand(program, common, run);
  AddTraceCommand(program, common, run);
  AddNewCommand(program, common, run);
  AddBatchCommand(program, common, run);
  AddAxisCommand(program, common, run);
  AddRenderCommand(program, common, run);
  AddContourCommand(program, common, run);
  AddProjectCommand(program, common, run);
  AddReportCommand(program, common, run);
  AddEvaluateCommand(program, common, run);
  AddPhantomCommand(program, common, run);
  AddExperimentCommand(program, common, run);
  AddViewCommand(program, common, run);

  // The parser would take the verb behind it for one to run.
  if (argc > 2 && std::string(argv[1]) == "--man")
  {
    try
    {
      std::cout << WriteManualPage(DescribeProgram(program), argv[2]) << std::endl;
      return AllRegistered;
    }
    catch (const std::invalid_argument & error)
    {
      return Fail(error.what());
    }
  }
  const auto isChosen = [&](CLI::App * verb) { return argc > 1 && verb->get_name() == argv[1]; };
  if (argc > 1 && argv[1][0] != '-' && program.get_subcommands(isChosen).empty())
  {
    return Fail(std::string("there is no verb \"") + argv[1] + "\"; see dentalscr --help");
  }
  // 3D Slicer puts every flag before the arguments by position, and the verb is one of these.
  std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  const auto               verb = std::find(arguments.begin(), arguments.end(), "register");
  if (std::find(arguments.begin(), arguments.end(), "--returnparameterfile") < verb && verb != arguments.end())
  {
    std::rotate(arguments.begin(), verb, verb + 1);
  }
  try
  {
    // CLI11 takes them from the back.
    program.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  }
  catch (const CLI::ParseError & error)
  {
    // --help and --version arrive as errors with exit code 0.
    if (error.get_exit_code() == 0)
    {
      return program.exit(error);
    }
    return Fail(DescribeMistake(program, error));
  }

  common.commandLine = arguments;
  common.commandLine.insert(common.commandLine.begin(), program.get_name());
  // The verb view waits for a program, which has threads of its own.
  if (!program.got_subcommand("view"))
  {
    SetNumberOfThreads(common.threads);
  }
  return run();
}
} // namespace

int
Main(int argc, const char * const * argv)
{
  return RunGuarded([&]() { return Run(argc, argv); });
}
} // namespace dentalscr

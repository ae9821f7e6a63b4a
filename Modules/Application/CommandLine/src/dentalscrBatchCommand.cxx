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
#include "dentalscrCaseOptions.h"
#include "dentalscrCommandTools.h"
#include "dentalscrCommands.h"

#include "itkBatchCaseList.h"
#include "itkBatchParts.h"
#include "itkBatchRunner.h"
#include "itkBatchSummary.h"
#include "itkCasePresetNames.h"
#include "itkCommand.h"
#include "itkDentalInputError.h"
#include "itkOutputFolder.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>

namespace dentalscr
{
namespace
{
struct BatchOptions
{
  std::vector<std::string> inputs;
  std::string              output;
  std::string              range;
  std::string              collect;
  std::string              preset{ "robust" };
  std::vector<std::string> set;
  unsigned int             jobs{ 0 };
  bool                     resume{ false };
  bool                     wait{ false };
  bool                     strict{ false };
  bool                     noReport{ false };
  bool                     noPage{ false };
  bool                     anonymous{ false };
};

std::string
ToClock(double seconds)
{
  std::ostringstream text;
  const auto         whole = static_cast<long long>(seconds + 0.5);
  if (whole >= 3600)
  {
    text << whole / 3600 << " h " << std::setw(2) << std::setfill('0') << whole % 3600 / 60 << " min";
  }
  else
  {
    text << whole / 60 << ':' << std::setw(2) << std::setfill('0') << whole % 60;
  }
  return text.str();
}

/** This program, to be started once more: also where Python has it (python3 -m dentalscr, or its script). */
std::vector<std::string>
FindProgram()
{
  std::error_code          error;
  const auto               file = std::filesystem::read_symlink("/proc/self/exe", error);
  std::vector<std::string> program{ file.string() };
  if (file.filename().string().rfind("python", 0) == 0)
  {
    std::ifstream            line("/proc/self/cmdline", std::ios::binary);
    std::vector<std::string> words;
    for (std::string word; std::getline(line, word, '\0');)
    {
      words.push_back(word);
    }
    const auto self = std::find_if(words.begin(), words.end(), [](const std::string & word) {
      return std::filesystem::path(word).filename() == "dentalscr";
    });
    if (self != words.end() && self != words.begin())
    {
      program.insert(program.end(), words.begin() + 1, self + 1);
    }
  }
  return program;
}

/** "37/100, 2 failed, 0:42 left". */
std::string
DescribeProgress(const itk::BatchRunner & runner, std::size_t failed)
{
  std::ostringstream text;
  text << runner.GetNumberOfFinishedCases() << '/' << runner.GetNumberOfCases() << " cases";
  if (failed > 0)
  {
    text << ", " << failed << " failed";
  }
  if (runner.GetSecondsLeft() >= 0.0)
  {
    text << ", " << ToClock(runner.GetSecondsLeft()) << " left";
  }
  return text.str();
}

/** "251-500": these of the cases, the first being 1. Of the last part of a list there may be less. */
std::vector<itk::BatchCase>
TakeRange(const std::vector<itk::BatchCase> & cases, const std::string & range)
{
  std::istringstream text(range);
  std::size_t        first = 0;
  std::size_t        last = 0;
  char               dash = 0;
  // A number with a sign would be read as a very large one.
  const bool isPlain = range.find_first_not_of("0123456789-") == std::string::npos && range[0] != '-' &&
                       std::count(range.begin(), range.end(), '-') == 1;
  if (!isPlain || !(text >> first >> dash >> last) || first < 1 || last < first)
  {
    itkDentalInputErrorMacro("--range", range, "is no range of cases", "give first and last, as in 251-500");
  }
  if (first > cases.size())
  {
    itkDentalInputErrorMacro("--range",
                             range,
                             "begins after the last case: there are " + std::to_string(cases.size()),
                             "give numbers up to that");
  }
  return { cases.begin() + static_cast<std::ptrdiff_t>(first - 1),
           cases.begin() + static_cast<std::ptrdiff_t>(std::min(last, cases.size())) };
}

/** What a batch comes to, said and as an exit code. */
int
Conclude(const std::vector<itk::BatchRecord> & records, const BatchOptions & options, bool isQuiet)
{
  std::size_t counts[4] = { 0, 0, 0, 0 };
  std::size_t kept = 0;
  for (const auto & record : records)
  {
    const std::string & status = record.status;
    ++counts[status == "ok" ? 0 : status == "suspect" ? 1 : status == "failed" ? 2 : 3];
    kept += record.isKept ? 1 : 0;
  }
  if (!isQuiet)
  {
    std::cout << records.size() << " cases: " << counts[0] << " ok, " << counts[1] << " suspect, " << counts[2]
              << " failed, " << counts[3] << " unusable";
    if (kept > 0)
    {
      std::cout << " (" << kept << " kept from before)";
    }
    std::cout << "\nwritten to " << options.output << std::endl;
  }
  return counts[3] > 0                                        ? UnusableInput
         : counts[2] > 0 || (options.strict && counts[1] > 0) ? SomeFailed
                                                              : AllRegistered;
}

/** The tables and the page of parts that other batches have run. */
int
Collect(const std::vector<itk::BatchCase> & cases, const BatchOptions & options, bool isQuiet)
{
  itk::BatchParts         parts(options.collect, options.output);
  const auto              records = parts.Collect(cases);
  const itk::OutputFolder owned(options.output);
  for (const std::string & name : parts.GetUnfinished())
  {
    std::cerr << "dentalscr: " << options.collect << ": part " << name << " was not run to its end\n";
  }
  if (parts.GetNumberOfMissingCases() > 0)
  {
    std::cerr << "dentalscr: " << parts.GetNumberOfMissingCases()
              << " cases have no result: no part has come to them\n";
  }
  if (parts.GetNumberOfOtherCases() > 0)
  {
    std::cerr << "dentalscr: warning: " << parts.GetNumberOfOtherCases()
              << " cases of the parts are not asked for, and left out\n";
  }
  const bool isComplete = parts.GetUnfinished().empty() && parts.GetNumberOfMissingCases() == 0;
  itk::BatchSummary(records, isComplete).Write(options.output, !options.noPage);
  return Conclude(records, options, isQuiet);
}

int
Batch(const BatchOptions & options, const CommonOptions & common)
{
  itk::BatchCaseList list;
  list.SetOptionNames(CaseOptions::GetNames(), CaseOptions::GetFileNames());
  auto cases = list.Find(options.inputs);
  for (const std::string & warning : list.GetWarnings())
  {
    std::cerr << "dentalscr: warning: " << warning << '\n';
  }
  // Of all of them: two of one name are found, also where they are of two parts.
  if (!options.range.empty())
  {
    cases = TakeRange(cases, options.range);
  }
  if (!options.collect.empty())
  {
    return Collect(cases, options, common.quiet);
  }
  std::vector<std::string> arguments{ "--preset", options.preset };
  for (const std::string & assignment : options.set)
  {
    arguments.insert(arguments.end(), { "--option", assignment });
  }
  if (options.noReport)
  {
    arguments.emplace_back("--no-report");
  }
  if (options.noPage)
  {
    arguments.emplace_back("--no-page");
  }
  if (options.anonymous)
  {
    arguments.emplace_back("--anonymous");
  }
  auto runner = itk::BatchRunner::New();
  runner->SetCases(cases);
  runner->SetArguments(arguments);
  runner->SetProgram(FindProgram());
  runner->SetOutputFolder(options.output);
  runner->SetNumberOfCores(common.threads);
  runner->SetNumberOfJobs(options.jobs);
  runner->SetResume(options.resume);
  runner->SetWaitForFolder(options.wait);

  // Tables that grow while it runs: a long batch can be looked at. Of very many cases they take a while to write, and
  // get a twentieth of the time.
  using Clock = std::chrono::steady_clock;
  constexpr auto  shortest = std::chrono::seconds(10);
  Clock::duration interval = shortest;
  auto            written = Clock::now();
  std::size_t     failed = 0;
  bool            aborted = false;
  {
    const InterruptGuard guard(runner);
    ProgressLine         progress(
      runner, [&]() { return DescribeProgress(*runner, failed); }, common.quiet);
    runner->AddObserver(itk::IterationEvent(), [&](const itk::EventObject &) {
      const std::string status = runner->GetRecord().status;
      failed += status == "failed" || status == "unusable" ? 1 : 0;
      if (status == "unusable")
      {
        progress.Say("dentalscr: " + runner->GetRecord().one.id + ": " + runner->GetRecord().message);
      }
      const auto now = Clock::now();
      if (now - written > interval)
      {
        itk::BatchSummary(runner->GetRecords(), false).Write(options.output, !options.noPage);
        written = Clock::now();
        interval = std::max<Clock::duration>(shortest, 20 * (written - now));
      }
    });
    try
    {
      runner->Update();
    }
    catch (const itk::ProcessAborted &)
    {
      aborted = true;
    }
  }
  const auto records = runner->GetRecords();
  itk::BatchSummary(records, !aborted).Write(options.output, !options.noPage);
  if (aborted)
  {
    throw itk::ProcessAborted(__FILE__, __LINE__);
  }
  return Conclude(records, options, common.quiet);
}
} // namespace

void
AddBatchCommand(CLI::App & program, const CommonOptions & common, RunFunction & run)
{
  auto   options = std::make_shared<BatchOptions>();
  auto * command = program.add_subcommand("batch", "Registers many cases, and sums them up in tables and a page");
  command
    ->add_option("cases", options->inputs, "Folders with a case.json below, a table cases.csv, case files, or patterns")
    ->type_name("FILE")
    ->required();
  command->add_option("-o,--output", options->output, "Folder: one a case, summary.csv, summary.json, index.html")
    ->type_name("FOLDER")
    ->required();
  command->add_option("--jobs", options->jobs, "Cases at a time (default: one a core)")->check(CLI::Range(1u, 1024u));
  command->add_flag("--resume", options->resume, "Keep what an earlier batch has done of cases that have not changed");
  command->add_flag("--wait", options->wait, "Where another batch is at work in the folder, wait until it has ended");
  command->add_option("--range", options->range, "Only these of the cases: first and last, as in 251-500")
    ->type_name("FIRST-LAST");
  command
    ->add_option(
      "--collect", options->collect, "Run nothing: sum up what batches of parts have left in the folders in this one")
    ->check(CLI::ExistingDirectory)
    ->excludes("--jobs")
    ->excludes("--resume")
    ->excludes("--wait");
  command->add_flag("--strict", options->strict, "End with 1 where a jaw is suspect, too");
  command->add_option("--preset", options->preset, "As of register")
    ->type_name("{" + CLI::detail::join(itk::GetCasePresetNames()) + "}")
    ->capture_default_str();
  command->add_option("--option", options->set, "As of register, any number of times")->type_name("NAME=VALUE");
  command->add_flag("--no-report", options->noReport, "Write no overlays, scans and pages of cases");
  command->add_flag("--no-page", options->noPage, "Write no index.html, and no page of a case");
  command->add_flag("--anonymous", options->anonymous, "No paths and no names of files in the cases' results");
  command->footer(
    "Exit code: 0 every jaw registered, 1 a jaw failed, 2 a case was unusable; one bad case never stops the rest.\n"
    "Examples:\n"
    "  dentalscr batch patients --output results --jobs 2\n"
    "  dentalscr batch cases.csv --output results --resume\n"
    "  dentalscr batch 'archive/*/case.json' --output results --no-report\n"
    "  dentalscr batch cases.csv --range 251-500 --output results/parts/000251-000500\n"
    "  dentalscr batch cases.csv --collect results/parts --output results\n");
  command->callback([options, &common, &run]() { run = [options, &common]() { return Batch(*options, common); }; });
}
} // namespace dentalscr

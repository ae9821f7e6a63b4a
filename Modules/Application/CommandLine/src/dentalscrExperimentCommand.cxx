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

#include "itkCohortExperiment.h"
#include "itkDentalInputError.h"
#include "itkMultiThreaderBase.h"
#include "itkTextFile.h"
#include "itkWriteExperimentPage.h"

#include "dentalscrPlotScript.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>

namespace dentalscr
{
namespace
{
using ExperimentType = itk::CohortExperiment;

struct ExperimentOptions
{
  unsigned int             cases{ 34 };
  std::uint64_t            seed{ 1 };
  std::string              level{ "typical" };
  std::string              output;
  std::vector<std::string> methods{ "default" };
  std::string              from;
  std::string              study;
  unsigned int             starts{ 100 };
  bool                     noFigures{ false };
  /** A level was named for a study that has its own. */
  bool levelIsRefused{ false };
};

/** A word for the shell, whatever it holds. */
std::string
Quote(const std::string & text)
{
  std::string quoted = "'";
  for (const char character : text)
  {
    quoted += character == '\'' ? "'\\''" : std::string(1, character);
  }
  return quoted + "'";
}

/** Draws the plots where there is a Python with matplotlib; returns whether it did. */
bool
Plot(const std::string & folder)
{
  const std::string script = (std::filesystem::path(folder) / "plot.py").string();
  itk::WriteFileAtomically(script, PlotScript);
  for (const char * python : { "python3", "/usr/bin/python3" })
  {
    const std::string command =
      std::string(python) + ' ' + Quote(script) + ' ' + Quote(folder) + " >/dev/null 2>/dev/null";
    if (std::system(command.c_str()) == 0)
    {
      return true;
    }
  }
  return false;
}

int
Experiment(const ExperimentOptions & options, const CommonOptions & common)
{
  if (options.levelIsRefused)
  {
    itkDentalInputErrorMacro(
      "--level", "", "the study " + options.study + " has levels of its own", "leave out --level");
  }
  auto experiment = ExperimentType::New();
  experiment->SetNumberOfCases(options.cases);
  experiment->SetSeed(options.seed);
  const auto & names = itk::DentalPhantomLevel::GetNames();
  experiment->SetLevel(
    static_cast<ExperimentType::CohortEnum>(std::find(names.begin(), names.end(), options.level) - names.begin()));
  experiment->SetOutputDirectory(options.output);
  experiment->SetMethods(options.methods);
  experiment->SetCaseDirectory(options.from);
  experiment->SetStudy(options.study == "capture"       ? ExperimentType::StudyEnum::Capture
                       : options.study == "sensitivity" ? ExperimentType::StudyEnum::Sensitivity
                       : options.study == "ablation"    ? ExperimentType::StudyEnum::Ablation
                       : options.study == "coverage"    ? ExperimentType::StudyEnum::Coverage
                       : options.study == "verdict"     ? ExperimentType::StudyEnum::Verdict
                       : options.study == "practice"    ? ExperimentType::StudyEnum::Practice
                       : options.study == "views"       ? ExperimentType::StudyEnum::Views
                                                        : ExperimentType::StudyEnum::Tables);
  experiment->SetNumberOfStarts(options.starts);
  experiment->SetDrawFigures(!options.noFigures);
  experiment->SetNumberOfWorkUnits(common.threads > 0 ? common.threads
                                                      : itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads());
  try
  {
    const InterruptGuard guard(experiment);
    const ProgressLine   progress(
      experiment, [&]() { return experiment->GetCurrentStage(); }, common.quiet);
    experiment->Update();
  }
  catch (const itk::ProcessAborted &)
  {
    std::cerr << "dentalscr: interrupted at " << experiment->GetCurrentStage()
              << "; what is complete is kept, the same command goes on from there" << std::endl;
    return UnusableInput;
  }
  const bool plotted = !options.noFigures && Plot(options.output);
  itk::WriteExperimentPage(options.output);
  if (!common.quiet)
  {
    if (experiment->GetNumberOfResumedCases() > 0)
    {
      std::cout << experiment->GetNumberOfResumedCases() << " cases were there already\n";
    }
    std::cout << experiment->GetWrittenFiles().size() << " files written to " << options.output << "; begin with "
              << "index.html or " << (options.study.empty() ? "tables.md" : options.study + ".md") << '\n';
    if (!plotted && !options.noFigures)
    {
      std::cout << "no plots: they need Python with matplotlib (python3-matplotlib); then run python3 "
                << (std::filesystem::path(options.output) / "plot.py").string() << '\n';
    }
    std::cout << std::flush;
  }
  return AllRegistered;
}
} // namespace

void
AddExperimentCommand(CLI::App & program, const CommonOptions & common, RunFunction & run)
{
  auto   options = std::make_shared<ExperimentOptions>();
  auto * command = program.add_subcommand(
    "experiment", "Compares methods on a simulated cohort or on annotated cases: the paper's tables and more");
  command->add_option("-o,--output", options->output, "Folder for tables and plots; a run that was interrupted goes on")
    ->type_name("FOLDER")
    ->required();
  auto * cases =
    command
      ->add_option(
        "--cases",
        options->cases,
        "Number of simulated cases. Studies: 8 (capture, sensitivity), 34 (ablation), 40 (verdict), 120 (practice), "
        "200 (coverage)")
      ->check(CLI::Range(1u, 100000u))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Of the first case; the same seed gives the same bits")
    ->capture_default_str();
  auto * level = command->add_option("--level", options->level, "of the phantom: typical, real, practice, ...")
                   ->check(CLI::IsMember(itk::DentalPhantomLevel::GetNames()))
                   ->capture_default_str();
  command
    ->add_option("--methods",
                 options->methods,
                 "Methods, separated by commas: bounding-box, single-stage, paper, robust, icp[-trimmed][-rigid], "
                 "cpd[-robust][-rigid], mutual-information, normalized-correlation, gradient-correlation, no-umda, "
                 "one-sided, no-coarse-to-fine (= single-stage), parallel; or default, intensity, all")
    ->type_name("METHOD")
    ->delimiter(',')
    ->capture_default_str();
  command
    ->add_option(
      "--from", options->from, "Folder whose subfolders hold a case.json with landmarks_2d each, instead of simulating")
    ->type_name("FOLDER")
    ->excludes(level)
    ->excludes(cases);
  command
    ->add_option(
      "--study",
      options->study,
      "Instead of the tables: capture (range and success rate), sensitivity, or of preset robust: ablation, "
      "coverage (and accuracy), verdict, practice (landmarks and standard tracings), views (a frontal radiograph)")
    ->check(CLI::IsMember({ "capture", "sensitivity", "ablation", "coverage", "verdict", "practice", "views" }));
  command->add_option("--starts", options->starts, "Starts a case and jaw in the study of the capture range")
    ->check(CLI::Range(10u, 100000u))
    ->capture_default_str();
  command->add_flag("--no-figures", options->noFigures, "Tables only: no pictures and no plots");
  command->footer("Exit code: 0 tables written (failures are listed in them), 2 unusable input or interrupted.\n"
                  "Examples:\n"
                  "  dentalscr experiment --output experiment\n"
                  "  dentalscr experiment --cases 8 --level hard --methods paper,robust --output hard\n"
                  "  dentalscr experiment --from annotated-cases --output clinic\n"
                  "  dentalscr experiment --study capture --methods all --output capture\n"
                  "  dentalscr experiment --study coverage --output coverage\n");
  command->callback([options, cases, level, &common, &run]() {
    const bool aboutRobust = options->study == "ablation" || options->study == "coverage" ||
                             options->study == "verdict" || options->study == "practice" || options->study == "views";
    options->levelIsRefused = aboutRobust && level->count() > 0;
    if (!options->study.empty() && cases->count() == 0)
    {
      options->cases = options->study == "coverage"   ? 200
                       : options->study == "practice" ? 120
                       : options->study == "verdict"  ? 40
                       : aboutRobust                  ? 34
                                                      : 8;
    }
    run = [options, &common]() { return Experiment(*options, common); };
  });
}
} // namespace dentalscr

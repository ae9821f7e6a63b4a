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
#include "dentalscrSimulation.h"

#include "itkDentalPhantomLevelNames.h"

#include <memory>

namespace dentalscr
{
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
                   ->check(CLI::IsMember(itk::GetDentalPhantomLevelNames()))
                   ->capture_default_str();
  auto * parameters =
    command
      ->add_option("--parameters",
                   options->parameters,
                   "JSON file with parameters of the phantom on top of the level's, as dentalscr phantom takes them")
      ->check(CLI::ExistingFile);
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
    ->excludes(parameters)
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
                  "  dentalscr experiment --parameters mine.json --output mine\n"
                  "  dentalscr experiment --from annotated-cases --output clinic\n"
                  "  dentalscr experiment --study capture --methods all --output capture\n"
                  "  dentalscr experiment --study coverage --output coverage\n");
  command->callback([options, cases, level, parameters, &common, &run]() {
    const bool aboutRobust = options->study == "ablation" || options->study == "coverage" ||
                             options->study == "verdict" || options->study == "practice" || options->study == "views";
    options->refused = !aboutRobust              ? ""
                       : level->count() > 0      ? "--level"
                       : parameters->count() > 0 ? "--parameters"
                                                 : "";
    if (!options->study.empty() && cases->count() == 0)
    {
      options->cases = options->study == "coverage"   ? 200
                       : options->study == "practice" ? 120
                       : options->study == "verdict"  ? 40
                       : aboutRobust                  ? 34
                                                      : 8;
    }
    run = [options, &common]() {
      return RunExperiment(
        *options, common, [&common](itk::ProcessObject * process, const std::function<std::string()> & stage) {
          const InterruptGuard guard(process);
          const ProgressLine   progress(process, stage, common.quiet);
          process->Update();
        });
    };
  });
}
} // namespace dentalscr

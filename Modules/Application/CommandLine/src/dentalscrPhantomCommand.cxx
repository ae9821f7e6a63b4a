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
AddPhantomCommand(CLI::App & program, const CommonOptions & common, RunFunction & run)
{
  auto   options = std::make_shared<PhantomOptions>();
  auto * command = program.add_subcommand("phantom", "Makes simulated cases with a known answer");
  command->add_option("-o,--output", options->output, "Folder of the case, or of the cases")->type_name("FOLDER");
  command
    ->add_option("--level",
                 options->level,
                 "How bad: ideal, typical, hard; real, real-hard (traits of real arches); standard, practice (whole "
                 "teeth and landmarks, as a cephalometric analysis draws them)")
    ->check(CLI::IsMember(itk::GetDentalPhantomLevelNames()))
    ->capture_default_str();
  command->add_option("--parameters", options->parameters, "JSON file with parameters on top of the level's")
    ->check(CLI::ExistingFile);
  command->add_flag(
    "--show-parameters", options->showParameters, "Print every parameter as such a file and make nothing");
  command
    ->add_option("--traced-side",
                 options->tracedSide,
                 "right, left, mean (bisected), both or standard (whole teeth) instead of the level's")
    ->check(CLI::IsMember({ "right", "left", "mean", "both", "standard" }));
  command
    ->add_option(
      "--preview", options->preview, "Also preview.png, four shaded views of the jaws, each so many pixels wide")
    ->check(CLI::Range(50u, 2000u));
  command->add_option("--seed", options->seed, "Of the first case; the same seed gives the same bits")
    ->capture_default_str();
  command->add_option("--count", options->count, "Number of cases, a folder each")
    ->check(CLI::Range(1u, 100000u))
    ->capture_default_str();
  command->add_option("--triangles", options->triangles, "Of each scan as made (60000)")
    ->check(CLI::Range(2000u, 4000000u));
  command->add_flag("--buccal", options->buccal, "Trace the buccal cusps, inside the silhouette");
  command->add_flag("--stone-base", options->stoneBase, "Closed casts with bases instead of open shells");
  command->add_flag(
    "--no-radiograph", options->noRadiograph, "Make no picture, which takes most of the time: the tracing alone");
  command
    ->add_option(
      "--tooth-bias", options->toothBias, "Each tooth drawn with an error of its own (1: 1.2 px, 2 degrees, 3 %)")
    ->check(CLI::Range(0.0, 10.0));
  command->add_option("--drop-out", options->dropOut, "Part of each tooth's border that is not drawn")
    ->check(CLI::Range(0.0, 0.9));
  command->add_option("--facing", options->facing, "Where the face looks")->check(CLI::IsMember({ "right", "left" }));
  command->add_option("--source-side", options->sourceSide, "The patient's side at which the source is")
    ->check(CLI::IsMember({ "right", "left" }));
  command
    ->add_option(
      "--frame",
      options->frame,
      "Scans in one frame or each in its own: shared, separate, centred (both occlusal sides alike), upright, "
      "anatomical, mixed (drawn)")
    ->check(CLI::IsMember({ "shared", "separate", "centred", "upright", "anatomical", "mixed" }));
  command->footer("Examples:\n"
                  "  dentalscr phantom --level hard --seed 3 --output sample\n"
                  "  dentalscr phantom --count 34 --output cohort\n"
                  "  dentalscr phantom --level practice --show-parameters > mine.json\n"
                  "  dentalscr phantom --parameters mine.json --output sample\n");
  command->callback(
    [options, &common, &run]() { run = [options, &common]() { return MakePhantoms(*options, common); }; });
}
} // namespace dentalscr

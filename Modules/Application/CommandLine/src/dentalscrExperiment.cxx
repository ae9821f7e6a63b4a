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
#include "dentalscrSimulation.h"

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

namespace dentalscr
{
namespace
{
using ExperimentType = itk::CohortExperiment;

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

} // namespace
} // namespace dentalscr

int
DentalSCRRunExperiment(const dentalscr::ExperimentOptions & options,
                       const dentalscr::CommonOptions &     common,
                       const dentalscr::UpdateFunction &    update)
{
  using namespace dentalscr;
  if (!options.refused.empty())
  {
    itkDentalInputErrorMacro(
      options.refused, "", "the study " + options.study + " has levels of its own", "leave out " + options.refused);
  }
  auto experiment = ExperimentType::New();
  experiment->SetNumberOfCases(options.cases);
  experiment->SetSeed(options.seed);
  auto level = itk::DentalPhantomLevel::Named(options.level);
  if (!options.parameters.empty())
  {
    level.ReadJson(options.parameters);
  }
  experiment->SetPhantomLevel(level);
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
    update(experiment, [&]() { return experiment->GetCurrentStage(); });
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

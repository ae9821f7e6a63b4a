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

#include "itkCaseLandmarkErrorFilter.h"
#include "itkCaseRegistration.h"
#include "itkCaseResultFolderWriter.h"
#include "itkDentalCaseFileReader.h"
#include "itkDentalCaseReader.h"
#include "itkDentalInputError.h"
#include "itkMultiThreaderBase.h"
#include "itkTextFile.h"

#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace dentalscr
{
namespace
{
struct RegisterOptions
{
  std::string              caseFile;
  std::string              output;
  std::string              preset{ "robust" };
  std::string              init;
  std::string              cephalometricLandmarks;
  std::vector<std::string> exclude;
  std::vector<std::string> fix;
  std::string              silhouette{ "drr" };
  bool                     noReport{ false };
  std::vector<std::string> set;
  std::string              returnParameterFile;
  std::string              ignored;
};

/** The words of an option; what they throw names the option. */
template <typename TFunction>
void
Apply(const char * option, TFunction && function)
{
  try
  {
    function();
  }
  catch (const std::invalid_argument & error)
  {
    itkDentalInputErrorMacro(option, "", error.what(), "see dentalscr register --help");
  }
}

/** For --help: a line an option. */
std::string
DescribeOptions()
{
  std::ostringstream text;
  text << "Options of preset robust, with their defaults (Documentation/Robust.md):\n";
  for (const auto & option : itk::CaseRegistration::GetOptions())
  {
    text << "  " << option.name << '=' << option.defaultValue << ": " << option.description << '\n';
  }
  return text.str();
}

void
PrintSummary(const itk::CaseResult & result, const std::string & output)
{
  std::cout << std::fixed << std::setprecision(1);
  for (const auto & entry : result.jaws)
  {
    const itk::JawResult & jaw = entry.second;
    std::cout << entry.first << ": " << itk::ToString(jaw.status);
    if (jaw.registered && !jaw.metrics.empty())
    {
      std::cout << ", Chamfer " << jaw.metrics.front().second.chamfer << " px";
    }
    if (jaw.error)
    {
      std::cout << ", landmark error " << jaw.error->mean << " px (mean of " << jaw.error->count << ")";
    }
    std::cout << '\n';
  }
  for (const auto & entry : result.skipped)
  {
    std::cout << entry.first << ": skipped, " << entry.second << '\n';
  }
  std::cout << "written to " << output << std::endl;
}

void
PrintReasons(const itk::CaseResult & result)
{
  for (const std::string & warning : result.warnings)
  {
    std::cerr << "dentalscr: warning: " << warning << '\n';
  }
  for (const auto & entry : result.jaws)
  {
    for (const std::string & reason : entry.second.reasons)
    {
      std::cerr << "dentalscr: " << entry.first << ": " << itk::ToString(entry.second.status) << ": " << reason << '\n';
    }
  }
}

int
Register(const RegisterOptions & options, const CommonOptions & common)
{
  itk::DentalCase description = itk::ReadDentalCase(options.caseFile);
  if (!options.init.empty())
  {
    itk::ReadInitialAlignment(options.init, description);
  }
  if (!options.cephalometricLandmarks.empty())
  {
    description.cephalometricLandmarksFile = options.cephalometricLandmarks;
    description.cephalometricLandmarks = nullptr;
  }
  Apply("--exclude", [&]() {
    for (const std::string & code : options.exclude)
    {
      itk::ExcludeTooth(description, code);
    }
  });
  Apply("--fix", [&]() {
    for (const std::string & what : options.fix)
    {
      itk::FixParameter(description, what);
    }
  });
  auto registration = itk::CaseRegistration::New();
  Apply("--preset", [&]() { registration->SetPreset(itk::CasePresetFromString(options.preset)); });
  if (!options.set.empty() && registration->GetPreset() != itk::CasePresetEnum::Robust)
  {
    itkDentalInputErrorMacro("--option", "", "preset " + options.preset + " has no options", "leave out --preset");
  }
  Apply("--option", [&]() {
    for (const std::string & assignment : options.set)
    {
      registration->SetOption(assignment);
    }
  });
  if (description.contoursFile.empty() && description.contourClassFiles.empty() &&
      registration->GetPreset() != itk::CasePresetEnum::Robust)
  {
    itkDentalInputErrorMacro(options.caseFile,
                             "contours",
                             "missing: preset " + options.preset + " registers tracings, not landmarks",
                             "name the file with the tracing, or leave out --preset");
  }
  registration->SetUseSurfaceDRR(options.silhouette == "drr");
  registration->SetNumberOfWorkUnits(common.threads > 0 ? common.threads
                                                        : itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads());
  auto reader = itk::DentalCaseReader::New();
  reader->SetDescription(description);
  registration->SetInput(reader->GetOutput());
  auto errors = itk::CaseLandmarkErrorFilter::New();
  errors->SetInput(registration->GetOutput());
  auto writer = itk::CaseResultFolderWriter::New();
  writer->SetInput(errors->GetOutput());
  writer->SetFolderName(options.output);
  writer->SetWriteReport(!options.noReport);

  // The pipeline is pulled in three parts for the sake of signals: while the case is read one ends the program, then it
  // ends the registration, and while files are moved it waits.
  reader->Update();
  // Kept to the end: the system takes memory back at once, cell by cell it would take a twentieth of the whole time.
  static auto * const data = new std::shared_ptr<const itk::DentalCaseData>;
  *data = reader->GetOutput()->Get();
  const InterruptGuard guard(registration);
  {
    const ProgressLine progress(
      registration, [&]() { return registration->GetCurrentStage(); }, common.quiet);
    registration->Update();
  }
  writer->Update();
  const itk::CaseResult & result = errors->GetOutput()->Get();
  if (!options.returnParameterFile.empty())
  {
    itk::WriteFileAtomically(options.returnParameterFile,
                             std::string("status = ") + itk::ToString(result.GetStatus()) + "\n");
  }
  PrintReasons(result);
  if (!common.quiet)
  {
    PrintSummary(result, options.output);
  }
  return result.GetStatus() == itk::CaseStatusEnum::Failed ? SomeFailed : AllRegistered;
}
} // namespace

void
AddRegisterCommand(CLI::App & program, const CommonOptions & common, RunFunction & run)
{
  auto   options = std::make_shared<RegisterOptions>();
  auto * command = program.add_subcommand("register", "Registers a case: scans and tracing in, aligned case out");
  command->add_option("case", options->caseFile, "Case file (JSON)")->required();
  command->add_option("-o,--output", options->output, "Folder for the result")->required();
  command->add_option("--preset", options->preset, "robust, paper, bounding-box or single-stage")
    ->capture_default_str();
  command->add_option("--init", options->init, "JSON file with the alignment to start from, as the case's \"init\"");
  command->add_option("--cephalometric-landmarks",
                      options->cephalometricLandmarks,
                      "File of landmarks to register with, in place of the case's");
  command->add_option("--exclude", options->exclude, "Teeth to leave out of the tracing, e.g. UR3,UR4")->delimiter(',');
  command->add_option("--fix", options->fix, "What to hold at its start: scale, rotation, translation")->delimiter(',');
  command
    ->add_option(
      "--silhouette", options->silhouette, "Where the paper's silhouette comes from: drr, or the mesh exactly")
    ->check(CLI::IsMember({ "drr", "mesh" }))
    ->capture_default_str();
  command->add_flag(
    "--no-report", options->noReport, "Write no overlays and no scans: result.json and transforms only");
  command->add_option(
    "--option", options->set, "Ingredient of preset robust, NAME=VALUE (listed below), any number of times");
  // What 3D Slicer adds to every call; the empty group keeps them out of --help.
  command->add_option("--returnparameterfile", options->returnParameterFile)->group("");
  command->add_option("--processinformationaddress", options->ignored)->group("");
  command->footer(
    std::string("Exit code: 0 every jaw registered, 1 a jaw failed, 2 unusable input.\n") +
    "Examples:\n"
    "  dentalscr register case.json --output result\n"
    "  dentalscr register case.json --output result --preset bounding-box --exclude UR8\n"
    "  dentalscr register case.json --output result --option useRobustKernel=off --option yawStarts=-0.1,0.1\n" +
    DescribeOptions());
  command->callback([options, &common, &run]() { run = [options, &common]() { return Register(*options, common); }; });
}
} // namespace dentalscr

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
#include "dentalscrCommands.h"

#include "itkCaseContinuation.h"
#include "itkCaseLandmarkErrorFilter.h"
#include "itkCasePresetNames.h"
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
#include <optional>
#include <sstream>
#include <stdexcept>

namespace dentalscr
{
namespace
{
struct RegisterOptions
{
  std::string              caseFile;
  CaseOptions              fields;
  std::string              output;
  std::string              preset{ "robust" };
  std::string              init;
  std::string              from;
  std::vector<std::string> exclude;
  std::vector<std::string> fix;
  std::string              silhouette{ "drr" };
  bool                     noReport{ false };
  bool                     noPage{ false };
  bool                     anonymous{ false };
  bool                     strict{ false };
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
    // What the paper's distance is of, the whole silhouette, has parts that nobody traced: it grows where the fit is
    // right, and is said only where there is no other figure.
    if (const auto * matched = jaw.FindMetrics("matched"))
    {
      std::cout << ", fit " << matched->chamfer << " px";
    }
    else if (jaw.registered && !jaw.metrics.empty() && !jaw.expectedError)
    {
      std::cout << ", Chamfer " << jaw.metrics.front().second.chamfer << " px";
    }
    // Of a jaw that is not to be used nothing is expected.
    if (jaw.expectedError && jaw.status != itk::RegistrationStatusEnum::Failed)
    {
      std::cout << ", expected error " << *jaw.expectedError << " px";
    }
    if (jaw.error)
    {
      std::cout << ", landmark error " << jaw.error->mean << " px (mean of " << jaw.error->count << ")";
    }
    std::cout << '\n';
  }
  for (const itk::CaseViewResult & view : result.views)
  {
    std::cout << "view " << view.name << ": " << itk::ToString(view.status) << '\n';
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
    for (const itk::RegistrationFinding & finding : entry.second.findings)
    {
      std::cerr << "dentalscr: " << entry.first << ": " << itk::ToString(finding.severity) << ": " << finding.text
                << '\n';
    }
  }
}

/** A case file, or the options that take its place; `known`: the case of an earlier run, which lies in no file. */
itk::DentalCase
ReadCase(const RegisterOptions & options, const std::optional<itk::DentalCase> & known)
{
  const std::string given = options.fields.GetFirstGiven();
  if (options.caseFile.empty() && !known)
  {
    if (given.empty())
    {
      itkDentalInputErrorMacro("command line",
                               "case",
                               "neither a case file nor options that make a case",
                               "name a case file, or give at least --upper or --lower and --contours");
    }
    return options.fields.Read();
  }
  itk::DentalCase description = known ? *known : itk::ReadDentalCase(options.caseFile);
  if (given == "--cephalometric-landmarks" && options.fields.CountGiven() == 1)
  {
    description.cephalometricLandmarksFile = options.fields.GetValue(given);
    description.cephalometricLandmarks = nullptr;
  }
  else if (!given.empty())
  {
    itkDentalInputErrorMacro("command line",
                             given,
                             "stands beside a case file, which has a field for it",
                             "change the case file, or leave it out and give all that it says as options");
  }
  return description;
}

/** Another run of an earlier result's case, from where that one ended. What is given here replaces what it had. */
RegisterOptions
ContinueFrom(const RegisterOptions & options, itk::CaseContinuation & continuation)
{
  if (!options.init.empty())
  {
    itkDentalInputErrorMacro(
      "command line", "--init", "stands beside --from, which is a start", "leave one of them out");
  }
  const std::string given = options.fields.GetFirstGiven();
  const bool        isOtherCase = !options.caseFile.empty() || (!given.empty() && given != "--cephalometric-landmarks");
  continuation = itk::ReadCaseContinuation(options.from, !isOtherCase);
  RegisterOptions continued = options;
  continued.init = continuation.resultFile;
  if (isOtherCase || !given.empty())
  {
    continuation.cephalometricLandmarksFile.clear();
  }
  if (!isOtherCase)
  {
    continued.caseFile = continuation.caseFile;
    if (continuation.caseHasChanged)
    {
      std::cerr << "dentalscr: warning: " << continuation.caseFile << " has changed since " << continuation.resultFile
                << '\n';
    }
  }
  // The case file says its own again; what the first run was given beside it stands in its result alone.
  continued.exclude = options.exclude.empty() ? continuation.excludedTeeth : options.exclude;
  continued.fix = options.fix.empty() ? continuation.fixed : options.fix;
  // In this order: the later of two assignments counts.
  continued.set = continuation.options;
  continued.set.insert(continued.set.end(), options.set.begin(), options.set.end());
  return continued;
}

int
Register(const RegisterOptions & givenOptions, const CommonOptions & common)
{
  itk::CaseContinuation continuation;
  const RegisterOptions options = givenOptions.from.empty() ? givenOptions : ContinueFrom(givenOptions, continuation);
  itk::DentalCase       description = ReadCase(options, continuation.description);
  continuation.SetLandmarks(description);
  if (!options.init.empty())
  {
    itk::ReadInitialAlignment(options.init, description);
  }
  Apply("--exclude", [&]() {
    for (const std::string & code : options.exclude)
    {
      if (code == "none")
      {
        description.excludedTeeth.clear();
        continue;
      }
      itk::ExcludeTooth(description, code);
    }
  });
  Apply("--fix", [&]() {
    for (const std::string & what : options.fix)
    {
      if (what == "none")
      {
        description.fixScale = description.fixRotation = description.fixTranslation = false;
        continue;
      }
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
    itkDentalInputErrorMacro(description.fileName,
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
  writer->SetWritePage(!options.noPage);
  writer->SetAnonymous(options.anonymous);
  writer->SetCommandLine(common.commandLine);

  // The pipeline is pulled in three parts for the sake of signals: while the case is read one ends the program, then it
  // ends the registration, and while files are moved it waits.
  reader->Update();
  // Kept to the end: the system takes memory back at once, cell by cell it would take a twentieth of the whole time.
  static auto * const data = new std::shared_ptr<const itk::DentalCaseData>;
  *data = reader->GetOutput()->Get();
  // An output folder that nothing can be written to is told now and not after the registration.
  writer->ClaimFolder();
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
  const auto worstThatPasses = options.strict ? itk::RegistrationStatusEnum::Ok : itk::RegistrationStatusEnum::Suspect;
  return result.GetStatus() > worstThatPasses ? SomeFailed : AllRegistered;
}
} // namespace

void
AddRegisterCommand(CLI::App & program, const CommonOptions & common, RunFunction & run)
{
  auto   options = std::make_shared<RegisterOptions>();
  auto * command = program.add_subcommand("register", "Registers a case: scans and tracing in, aligned case out");
  command->add_option("case", options->caseFile, "Case file (JSON); or give its fields as options (below)")
    ->type_name("FILE");
  command->add_option("-o,--output", options->output, "Folder for the result")->type_name("FOLDER")->required();
  command
    ->add_option("--preset", options->preset, "How to register: " + CLI::detail::join(itk::GetCasePresetNames(), ", "))
    ->type_name("{" + CLI::detail::join(itk::GetCasePresetNames()) + "}")
    ->capture_default_str();
  command->add_option("--init", options->init, "JSON file with the alignment to start from, as the case's \"init\"")
    ->type_name("FILE");
  options->fields.AddTo(command);
  command
    ->add_option("--from",
                 options->from,
                 "An earlier result (result.json or its folder): its case again, in the place where it ended, with its "
                 "--exclude, --fix and --option unless they are given here")
    ->type_name("FILE");
  command->add_option("--exclude", options->exclude, "Teeth to leave out of the tracing, e.g. UR3,UR4; none: nobody")
    ->type_name("TOOTH")
    ->delimiter(',');
  command->add_option("--fix", options->fix, "What to hold at its start: scale, rotation, translation; none: nothing")
    ->type_name("WHAT")
    ->delimiter(',');
  command
    ->add_option(
      "--silhouette", options->silhouette, "Where the paper's silhouette comes from: drr, or the mesh exactly")
    ->check(CLI::IsMember({ "drr", "mesh" }))
    ->capture_default_str();
  command->add_flag("--strict", options->strict, "End with 1 where a jaw is suspect, too");
  command->add_flag(
    "--no-report", options->noReport, "Write no overlays, scans and page: result.json and transforms only");
  command->add_flag("--no-page", options->noPage, "Write no report.html");
  command->add_flag("--anonymous", options->anonymous, "No paths and no names of files in what is written");
  command
    ->add_option(
      "--option", options->set, "Ingredient of preset robust, NAME=VALUE (listed below), any number of times")
    ->type_name("NAME=VALUE");
  // What 3D Slicer adds to every call; the empty group keeps them out of --help.
  command->add_option("--returnparameterfile", options->returnParameterFile)->group("");
  command->add_option("--processinformationaddress", options->ignored)->group("");
  command->footer(
    std::string(
      "Exit code: 0 every jaw registered, 1 a jaw failed (with --strict: or is suspect), 2 unusable input.\n") +
    "Examples:\n"
    "  dentalscr register case.json --output result\n"
    "  dentalscr register --upper upper.stl --lower lower.stl --contours tracing.json --spacing 0.1 0.1 --output "
    "result\n"
    "  dentalscr register --from result --exclude UR6 --output result2\n"
    "  dentalscr register case.json --output result --preset bounding-box --exclude UR8\n"
    "  dentalscr register case.json --output result --option useRobustKernel=off --option yawStarts=-0.1,0.1\n" +
    DescribeOptions());
  command->callback([options, &common, &run]() { run = [options, &common]() { return Register(*options, common); }; });
}
} // namespace dentalscr

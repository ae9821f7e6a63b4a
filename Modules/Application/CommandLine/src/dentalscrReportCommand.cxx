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

#include "itkWriteReportPage.h"

#include <filesystem>
#include <iostream>
#include <memory>

namespace dentalscr
{
namespace
{
struct ReportOptions
{
  std::string             result;
  itk::ReportPageSettings page;
};

int
Report(const ReportOptions & options, const CommonOptions & common)
{
  for (const std::string & sentence : itk::WriteReportPage(options.result, options.page))
  {
    std::cerr << "dentalscr: warning: " << sentence << '\n';
  }
  if (!common.quiet)
  {
    namespace fs = std::filesystem;
    const fs::path given(options.result);
    std::cout << "written to "
              << (!options.page.fileName.empty()
                    ? options.page.fileName
                    : ((fs::is_directory(given) ? given : given.parent_path()) / "report.html").string())
              << std::endl;
  }
  return AllRegistered;
}
} // namespace

void
AddReportCommand(CLI::App & program, const CommonOptions & common, RunFunction & run)
{
  auto   options = std::make_shared<ReportOptions>();
  auto * command = program.add_subcommand("report", "Writes the page of a result again: one file to judge it by");
  command->add_option("result", options->result, "result.json, or its folder")->type_name("FILE")->required();
  command->add_option("-o,--output", options->page.fileName, "The page (default: report.html beside the result)")
    ->type_name("FILE");
  command->add_option("--image", options->page.imageFile, "The radiograph, where it is not where the result says")
    ->type_name("FILE");
  command->add_flag("--anonymous", options->page.anonymous, "No paths and no names of files in it");
  command->footer("The page asks nothing of the network; every number on it is in result.json and report.json.\n"
                  "Example:\n"
                  "  dentalscr report result --anonymous --output for-a-colleague.html\n");
  command->callback([options, &common, &run]() { run = [options, &common]() { return Report(*options, common); }; });
}
} // namespace dentalscr

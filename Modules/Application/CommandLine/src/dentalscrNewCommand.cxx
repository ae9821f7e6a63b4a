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

#include "itkDentalInputError.h"
#include "itkRecogniseCaseFolder.h"
#include "itkRequireJsonName.h"
#include "itkTextFile.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

namespace dentalscr
{
namespace
{
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct NewOptions
{
  std::string folder;
  std::string output;
  bool        force{ false };
};

int
New(const NewOptions & options, const CommonOptions & common)
{
  itk::RequireJsonName(options.output, "cases");
  const fs::path  output = options.output.empty() ? fs::path(options.folder) / "case.json" : fs::path(options.output);
  std::error_code error;
  if (fs::exists(output, error) && !options.force)
  {
    itkDentalInputErrorMacro(
      output.string(), "", "is there already", "name another file with --output, or replace it with --force");
  }
  const itk::RecognisedCase found = itk::RecogniseCaseFolder(options.folder);
  const auto                has = [&](const char * field) { return !found.Find(field).empty(); };
  if (!has("upper") && !has("lower"))
  {
    std::string notes;
    for (const std::string & note : found.notes)
    {
      notes += "; " + note;
    }
    itkDentalInputErrorMacro(
      options.folder, "", "has no scan whose jaw is known" + notes, "name a scan after its jaw, as upper.stl");
  }
  Json           json = Json::object();
  const fs::path beside = fs::absolute(output).parent_path();
  for (const auto & file : found.files)
  {
    const std::string path = fs::absolute(file.second).lexically_proximate(beside).string();
    std::string       pointer = '/' + file.first;
    std::replace(pointer.begin(), pointer.end(), '.', '/');
    json[Json::json_pointer(pointer)] = path;
  }
  if (json.contains("views"))
  {
    Json views = Json::array();
    for (const auto & view : json["views"].items())
    {
      Json own = { { "name", view.key() }, { "direction", "frontal" } };
      own.update(view.value());
      views.push_back(own);
    }
    json["views"] = views;
  }
  json["_notes"] = found.notes;
  itk::WriteFileAtomically(output.string(), json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n');
  if (!common.quiet)
  {
    for (const std::string & note : found.notes)
    {
      std::cout << note << '\n';
    }
    std::cout << "written to " << output.string() << std::endl;
  }
  return AllRegistered;
}
} // namespace

void
AddNewCommand(CLI::App & program, const CommonOptions & common, RunFunction & run)
{
  auto   options = std::make_shared<NewOptions>();
  auto * command = program.add_subcommand("new", "Writes a case file from what it recognises in a folder");
  command->add_option("folder", options->folder, "Folder with scans, radiograph, tracing, landmarks")
    ->type_name("FOLDER")
    ->required();
  command->add_option("-o,--output", options->output, "The case file (default: case.json in the folder)")
    ->type_name("FILE");
  command->add_flag("--force", options->force, "Replace a case file that is there");
  command->footer(
    "Scans are told by whole words of their names (upper, maxilla, UpperJawScan, shell_occlusion_u), drawings by\n"
    "what is in them; a frontal radiograph, and what was drawn on it, by a word of its name (frontal, pa). Why each\n"
    "file was taken or left stands in the case's \"_notes\".\n"
    "Example:\n"
    "  dentalscr new patient17\n"
    "  dentalscr register patient17/case.json --output patient17/result\n");
  command->callback([options, &common, &run]() { run = [options, &common]() { return New(*options, common); }; });
}
} // namespace dentalscr

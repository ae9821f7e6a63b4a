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
#include "dentalscrProgramDescription.h"

#include "itkDentalSCRVersion.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>

namespace dentalscr
{
namespace
{
using Json = nlohmann::ordered_json;
using ValueEnum = OptionDescription::ValueEnum;

/** The words of CLI::IsMember, which describes itself as {right,left}. */
std::vector<std::string>
GetChoices(const std::string & type)
{
  std::vector<std::string> choices;
  const std::size_t        begin = type.find('{');
  const std::size_t        end = type.find('}', begin);
  if (begin != std::string::npos && end != std::string::npos)
  {
    for (const std::string & word : CLI::detail::split(type.substr(begin + 1, end - begin - 1), ','))
    {
      choices.push_back(CLI::detail::trim_copy(word));
    }
  }
  return choices;
}

/** What may follow, by the name of its type that --help prints: every option says there whether it is a file. */
ValueEnum
GetValue(const CLI::Option & option, const OptionDescription & description)
{
  const auto has = [&](const char * word) { return description.type.find(word) != std::string::npos; };
  if (option.get_items_expected_max() == 0)
  {
    return ValueEnum::None;
  }
  if (!description.choices.empty())
  {
    return ValueEnum::Choice;
  }
  if (has("INT") || has("FLOAT"))
  {
    return ValueEnum::Number;
  }
  if (has("FOLDER") || has("DIR"))
  {
    return ValueEnum::Folder;
  }
  return has("FILE") ? ValueEnum::File : ValueEnum::List;
}

VerbDescription
DescribeVerb(const CLI::App & app)
{
  VerbDescription verb;
  verb.name = app.get_name();
  verb.help = app.get_description();
  verb.notes = app.get_footer();
  for (const CLI::Option * option : app.get_options())
  {
    // Those of the empty group are not printed by --help either.
    if (option->get_group().empty())
    {
      continue;
    }
    OptionDescription description;
    description.isPositional = !option->nonpositional();
    if (description.isPositional)
    {
      description.names.push_back(option->get_name(true));
    }
    for (const std::string & name : option->get_snames())
    {
      description.names.push_back("-" + name);
    }
    for (const std::string & name : option->get_lnames())
    {
      description.names.push_back("--" + name);
    }
    description.help = option->get_description();
    description.group = option->get_group();
    description.type = option->get_items_expected_max() == 0 ? "" : option->get_type_name();
    description.choices = GetChoices(description.type);
    description.value = GetValue(*option, description);
    description.defaultValue = option->get_default_str();
    description.numberOfValues = option->get_items_expected_max();
    description.takesAny = option->get_items_expected_max() >= CLI::detail::expected_max_vector_size;
    description.isRequired = option->get_required();
    verb.options.push_back(description);
  }
  return verb;
}

Json
VerbToJson(const VerbDescription & verb)
{
  Json options = Json::array();
  for (const OptionDescription & option : verb.options)
  {
    const char * const values[] = { "none", "number", "choice", "folder", "file", "list" };
    options.push_back({ { "names", option.names },
                        { "help", option.help },
                        { "group", option.group },
                        { "value", values[static_cast<int>(option.value)] },
                        { "type", option.type },
                        { "choices", option.choices },
                        { "default", option.defaultValue },
                        { "number_of_values", option.takesAny ? Json("any") : Json(option.numberOfValues) },
                        { "positional", option.isPositional },
                        { "required", option.isRequired } });
  }
  return { { "name", verb.name }, { "help", verb.help }, { "options", options }, { "notes", verb.notes } };
}
} // namespace

ProgramDescription
DescribeProgram(const CLI::App & program)
{
  ProgramDescription description;
  description.program = DescribeVerb(program);
  std::copy_if(description.program.options.begin(),
               description.program.options.end(),
               std::back_inserter(description.common),
               [](const OptionDescription & option) { return option.group == CommonGroup; });
  description.version = itk::DentalSCRVersion;
  for (const CLI::App * verb : program.get_subcommands([](const CLI::App *) { return true; }))
  {
    description.verbs.push_back(DescribeVerb(*verb));
  }
  return description;
}

std::string
ToJson(const ProgramDescription & description)
{
  Json json = VerbToJson(description.program);
  json["version"] = description.version;
  json["verbs"] = Json::array();
  for (const VerbDescription & verb : description.verbs)
  {
    json["verbs"].push_back(VerbToJson(verb));
  }
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}
} // namespace dentalscr

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
#include "dentalscrShellCompletion.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace dentalscr
{
namespace
{
using ValueEnum = OptionDescription::ValueEnum;

std::string
Join(const std::vector<std::string> & words, const std::string & between)
{
  std::string text;
  for (const std::string & word : words)
  {
    text += (text.empty() ? "" : between) + word;
  }
  return text;
}

/** Within single quotes, as every one of the shells reads them but for the quote itself. */
std::string
Quote(const std::string & text, const std::string & quote)
{
  std::string result = "'";
  for (const char c : text)
  {
    if (c == '\'')
    {
      result += quote;
    }
    else
    {
      result += c;
    }
  }
  return result + "'";
}

std::vector<std::string>
GetNames(const std::vector<OptionDescription> & options)
{
  std::vector<std::string> names;
  for (const OptionDescription & option : options)
  {
    if (!option.isPositional)
    {
      names.insert(names.end(), option.names.begin(), option.names.end());
    }
  }
  return names;
}

/** Patterns of "case" for the options of a verb whose value is of a kind. */
std::vector<std::string>
FindOptions(const VerbDescription & verb, ValueEnum value)
{
  std::vector<std::string> patterns;
  for (const OptionDescription & option : verb.options)
  {
    if (!option.isPositional && option.value == value)
    {
      patterns.insert(patterns.end(), option.names.begin(), option.names.end());
    }
  }
  return patterns;
}

void
WriteBashValues(std::ostream & script, const VerbDescription & verb)
{
  for (const OptionDescription & option : verb.options)
  {
    if (!option.isPositional && option.value == ValueEnum::Choice)
    {
      script << "        " << Join(option.names, "|") << ") words='" << Join(option.choices, " ") << "' ;;\n";
    }
  }
  const auto write = [&](ValueEnum value, const char * kind) {
    const auto names = FindOptions(verb, value);
    if (!names.empty())
    {
      script << "        " << Join(names, "|") << ") kind=" << kind << " ;;\n";
    }
  };
  write(ValueEnum::Folder, "folder");
  write(ValueEnum::File, "file");
  write(ValueEnum::Number, "nothing");
  write(ValueEnum::List, "nothing");
}

std::string
WriteBash(const ProgramDescription & description)
{
  std::vector<std::string> verbs;
  for (const VerbDescription & verb : description.verbs)
  {
    verbs.push_back(verb.name);
  }
  std::ostringstream script;
  script << "# Completion of dentalscr " << description.version << " for bash, written by dentalscr --completion bash\n"
         << R"(_dentalscr()
{
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} verb= words= kind= i
  COMPREPLY=()
  # "--option=value" arrives as three words.
  if [ "$current" = = ]; then
    current=
  elif [ "$previous" = = ]; then
    previous=${COMP_WORDS[COMP_CWORD-2]}
  fi
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case ${COMP_WORDS[i]} in
      )" << Join(verbs, "|")
         << R"() verb=${COMP_WORDS[i]}; break ;;
    esac
  done
  case $verb in
)";
  for (const VerbDescription & verb : description.verbs)
  {
    script << "    " << verb.name << ")\n      case $previous in\n";
    WriteBashValues(script, verb);
    script << "        *) words='" << Join(GetNames(verb.options), " ") << "'; kind=other ;;\n      esac\n      ;;\n";
  }
  script << "    *)\n      words='" << Join(verbs, " ") << ' ' << Join(GetNames(description.program.options), " ")
         << "'\n      ;;\n  esac\n  case $previous in\n";
  WriteBashValues(script, description.program);
  script << "  esac\n";
  script << R"(  if [ "$kind" = other ]; then
    # The options of every verb; a word without dashes is a file.
    words="$words )"
         << Join(GetNames(description.common), " ") << R"("
    case $current in
      -*) kind= ;;
      *) words=; kind=file ;;
    esac
  fi
  case $kind in
    folder) compopt -o filenames; mapfile -t COMPREPLY < <(compgen -d -- "$current") ;;
    file) compopt -o filenames; mapfile -t COMPREPLY < <(compgen -f -- "$current") ;;
    nothing) ;;
    *) mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current") ;;
  esac
}
complete -F _dentalscr dentalscr
)";
  return script.str();
}

/** Of _arguments: colons part its fields, and brackets hold the words of an option. */
std::string
EscapeForZsh(const std::string & text)
{
  std::string result;
  for (const char c : text)
  {
    if (c == '[' || c == ']' || c == ':' || c == '\\')
    {
      result += '\\';
    }
    result += c;
  }
  return result;
}

std::string
GetZshAction(const OptionDescription & option)
{
  switch (option.value)
  {
    case ValueEnum::Choice:
      return "(" + Join(option.choices, " ") + ")";
    case ValueEnum::Folder:
      return "_files -/";
    case ValueEnum::File:
      return "_files";
    default:
      // A space: nothing is offered.
      return " ";
  }
}

void
WriteZshOptions(std::ostream & script, const VerbDescription & verb)
{
  for (const OptionDescription & option : verb.options)
  {
    const std::string action = GetZshAction(option);
    if (option.isPositional)
    {
      script << " \\\n    "
             << Quote((option.takesAny ? "*:" : ":") + EscapeForZsh(option.names[0]) + ":" + action, "'\\''");
      continue;
    }
    std::string values;
    for (int i = 0; i < (option.takesAny ? 1 : option.numberOfValues); ++i)
    {
      values += ":" + EscapeForZsh(option.type.substr(0, option.type.find(':'))) + ":" + action;
    }
    // A name excludes the option's others, but not itself where it may be given again.
    for (const std::string & name : option.names)
    {
      const std::string before = option.takesAny ? "*" : "(" + Join(option.names, " ") + ")";
      script << " \\\n    " << Quote(before + name + "[" + EscapeForZsh(option.help) + "]" + values, "'\\''");
    }
  }
}

std::string
WriteZsh(const ProgramDescription & description)
{
  std::ostringstream script;
  script << "#compdef dentalscr\n# Completion of dentalscr " << description.version
         << " for zsh, written by dentalscr --completion zsh\n"
         << "_dentalscr()\n{\n  local context state state_descr line\n  typeset -A opt_args\n  local -a verbs=(";
  for (const VerbDescription & verb : description.verbs)
  {
    script << "\n    " << Quote(verb.name + ":" + EscapeForZsh(verb.help), "'\\''");
  }
  script << "\n  )\n  _arguments -C";
  WriteZshOptions(script, description.program);
  script << " \\\n    ':verb:->verb' \\\n    '*::argument:->argument' && return\n"
         << "  case $state in\n    verb) _describe -t verbs verb verbs ;;\n    argument)\n      case $line[1] in\n";
  for (const VerbDescription & verb : description.verbs)
  {
    script << "        " << verb.name << ") _dentalscr_" << verb.name << " ;;\n";
  }
  script << "      esac\n      ;;\n  esac\n}\n";
  for (const VerbDescription & verb : description.verbs)
  {
    script << "_dentalscr_" << verb.name << "()\n{\n  _arguments";
    WriteZshOptions(script, verb);
    VerbDescription common;
    common.options = description.common;
    WriteZshOptions(script, common);
    script << "\n}\n";
  }
  // Read by the shell's own loader the file is the body of the function that it defines.
  script
    << "if [ \"$funcstack[1]\" = _dentalscr ]; then\n  _dentalscr \"$@\"\nelse\n  compdef _dentalscr dentalscr\nfi\n";
  return script.str();
}

void
WriteFishOptions(std::ostream & script, const VerbDescription & verb, const std::string & condition)
{
  for (const OptionDescription & option : verb.options)
  {
    if (option.isPositional)
    {
      continue;
    }
    script << "complete -c dentalscr";
    if (!condition.empty())
    {
      script << " -n " << Quote(condition, "\\'");
    }
    for (const std::string & name : option.names)
    {
      script << (name[1] == '-' ? " -l " + name.substr(2) : " -s " + name.substr(1));
    }
    switch (option.value)
    {
      case ValueEnum::None:
        break;
      case ValueEnum::Choice:
        script << " -x -a " << Quote(Join(option.choices, " "), "\\'");
        break;
      case ValueEnum::Folder:
        script << " -x -a '(__fish_complete_directories)'";
        break;
      case ValueEnum::File:
        script << " -r -F";
        break;
      default:
        script << " -x";
    }
    script << " -d " << Quote(option.help, "\\'") << '\n';
  }
}

std::string
WriteFish(const ProgramDescription & description)
{
  std::ostringstream script;
  script << "# Completion of dentalscr " << description.version
         << " for fish, written by dentalscr --completion fish\n";
  for (const VerbDescription & verb : description.verbs)
  {
    script << "complete -c dentalscr -n __fish_use_subcommand -f -a " << verb.name << " -d " << Quote(verb.help, "\\'")
           << '\n';
  }
  // Those of every verb anywhere, the others before a verb.
  VerbDescription common;
  common.options = description.common;
  VerbDescription others = description.program;
  others.options.erase(std::remove_if(others.options.begin(),
                                      others.options.end(),
                                      [](const OptionDescription & option) { return option.group == CommonGroup; }),
                       others.options.end());
  WriteFishOptions(script, common, "");
  WriteFishOptions(script, others, "__fish_use_subcommand");
  for (const VerbDescription & verb : description.verbs)
  {
    WriteFishOptions(script, verb, "__fish_seen_subcommand_from " + verb.name);
  }
  return script.str();
}
} // namespace

const std::vector<std::string> &
GetCompletionShells()
{
  static const std::vector<std::string> shells{ "bash", "zsh", "fish" };
  return shells;
}

std::string
WriteShellCompletion(const ProgramDescription & description, const std::string & shell)
{
  if (shell == "bash")
  {
    return WriteBash(description);
  }
  if (shell == "zsh")
  {
    return WriteZsh(description);
  }
  if (shell == "fish")
  {
    return WriteFish(description);
  }
  throw std::invalid_argument("there is no completion for \"" + shell + "\"; give " +
                              Join(GetCompletionShells(), ", "));
}
} // namespace dentalscr

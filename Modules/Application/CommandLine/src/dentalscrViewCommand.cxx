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
#include "dentalscrViewOptions.h"

#include "itkDentalInputError.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char ** environ;

namespace dentalscr
{
namespace
{
constexpr char Viewer[] = "dentalscr-view";

/** Beside this program, else on the PATH: the program may be Python. */
std::string
FindViewer()
{
  namespace fs = std::filesystem;
  std::error_code       error;
  std::vector<fs::path> folders{ fs::read_symlink("/proc/self/exe", error).parent_path() };
  const char * const    path = std::getenv("PATH");
  std::istringstream    list(path == nullptr ? "" : path);
  std::string           folder;
  while (std::getline(list, folder, ':'))
  {
    folders.emplace_back(folder);
  }
  for (const fs::path & place : folders)
  {
    const fs::path program = place / Viewer;
    if (!place.empty() && fs::is_regular_file(program, error) && access(program.c_str(), X_OK) == 0)
    {
      return program.string();
    }
  }
  return "";
}

int
View(const ViewOptions & options, const CommonOptions & common)
{
  const std::string viewer = FindViewer();
  if (viewer.empty())
  {
    itkDentalInputErrorMacro(
      "view",
      "",
      std::string("the program ") + Viewer +
        " is not beside this one and not on the PATH: DentalSCR was built without VTK",
      "install VTK 9.1 (apt-get install libvtk9-dev) and build DentalSCR again, or use scene() of "
      "a result in Python");
  }
  std::vector<std::string> arguments = options.ToArguments();
  if (common.quiet)
  {
    arguments.insert(arguments.begin(), "--quiet");
  }
  arguments.insert(arguments.begin(), "--threads=" + std::to_string(common.threads));
  arguments.insert(arguments.begin(), viewer);
  std::vector<char *> pointers;
  for (std::string & argument : arguments)
  {
    pointers.push_back(argument.data());
  }
  pointers.push_back(nullptr);
  std::cout << std::flush;
  pid_t     child = -1;
  const int problem = posix_spawn(&child, viewer.c_str(), nullptr, nullptr, pointers.data(), environ);
  if (problem != 0)
  {
    itkDentalInputErrorMacro(
      viewer, "", std::string("cannot be started: ") + std::strerror(problem), "install it again");
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
  {
    if (errno != EINTR)
    {
      itkDentalInputErrorMacro(viewer, "", std::string("is lost: ") + std::strerror(errno), "start it again");
    }
  }
  if (WIFSIGNALED(status))
  {
    itkDentalInputErrorMacro(
      viewer,
      "",
      std::string("ended with \"") + strsignal(WTERMSIG(status)) + '"',
      "if it was not you who ended it, look at its messages above, and try --snapshot or --export");
  }
  return WEXITSTATUS(status);
}
} // namespace

void
AddViewCommand(CLI::App & program, const CommonOptions & common, RunFunction & run)
{
  auto   options = std::make_shared<ViewOptions>();
  auto * command =
    program.add_subcommand("view", "Shows a registered case in space: window, picture, or file for other programs");
  options->AddTo(command);
  command->footer(
    "Scans, their frames, source, central ray, and the radiograph on its detector with tracing and outline.\n"
    "Keys in the window stand in it; the left button turns, the right or the wheel zooms, the middle moves.\n"
    "A picture needs no screen where Xvfb is installed (apt-get install xvfb).\n"
    "Examples:\n"
    "  dentalscr view result\n"
    "  dentalscr view result --snapshot source.png --camera source\n"
    "  dentalscr view result --export scene.gltf\n");
  command->callback([options, &common, &run]() { run = [options, &common]() { return View(*options, common); }; });
}
} // namespace dentalscr

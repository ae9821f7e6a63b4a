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
#ifndef dentalscrCommands_h
#define dentalscrCommands_h

#include "CommandLineExport.h"
#include "dentalscrCommandTools.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <string>

namespace dentalscr
{
/** The program: what main() does, also for the Python package. Returns the exit code. */
CommandLine_EXPORT int
Main(int argc, const char * const * argv);

/** What --xml prints: the verb register as a module of 3D Slicer (Slicer Execution Model). */
CommandLine_EXPORT std::string
                   SlicerDescription();

/** Each adds its verb to the program and sets `run` when the user chose it; run returns the exit code. */
using RunFunction = std::function<int()>;

CommandLine_EXPORT void
AddRegisterCommand(CLI::App & program, const CommonOptions & common, RunFunction & run);
CommandLine_EXPORT void
AddTraceCommand(CLI::App & program, const CommonOptions & common, RunFunction & run);
CommandLine_EXPORT void
AddNewCommand(CLI::App & program, const CommonOptions & common, RunFunction & run);
CommandLine_EXPORT void
AddBatchCommand(CLI::App & program, const CommonOptions & common, RunFunction & run);
CommandLine_EXPORT void
AddAxisCommand(CLI::App & program, const CommonOptions & common, RunFunction & run);
CommandLine_EXPORT void
AddRenderCommand(CLI::App & program, const CommonOptions & common, RunFunction & run);
CommandLine_EXPORT void
AddContourCommand(CLI::App & program, const CommonOptions & common, RunFunction & run);
CommandLine_EXPORT void
AddProjectCommand(CLI::App & program, const CommonOptions & common, RunFunction & run);
CommandLine_EXPORT void
AddReportCommand(CLI::App & program, const CommonOptions & common, RunFunction & run);
CommandLine_EXPORT void
AddEvaluateCommand(CLI::App & program, const CommonOptions & common, RunFunction & run);
CommandLine_EXPORT void
AddPhantomCommand(CLI::App & program, const CommonOptions & common, RunFunction & run);
CommandLine_EXPORT void
AddExperimentCommand(CLI::App & program, const CommonOptions & common, RunFunction & run);
CommandLine_EXPORT void
AddViewCommand(CLI::App & program, const CommonOptions & common, RunFunction & run);
} // namespace dentalscr

#endif

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
#ifndef dentalscrViewOptions_h
#define dentalscrViewOptions_h

#include "CommandLineExport.h"

#include <CLI/CLI.hpp>

#include <array>
#include <string>
#include <vector>

namespace dentalscr
{
/** \class ViewOptions
 * \brief What the verb view is told. The verb only passes it on: what shows a scene is a program of its own,
 * dentalscr-view, because VTK takes longer to load than a case to register. */
class CommandLine_EXPORT ViewOptions
{
public:
  std::string                 result;                /**< Folder or file of the result to show. */
  std::string                 caseFile;              /**< Case of that result; "": as the result names it. */
  std::string                 snapshot;              /**< Picture to write instead of a window; "": none. */
  std::string                 exportFile;            /**< File for another program to write; "": none. */
  std::string                 camera{ "overview" };  /**< From where the scene is seen first. */
  std::array<unsigned int, 2> size{ { 1200, 900 } }; /**< Window or picture, width and height in pixels. */

  /** Adds each to a command that lives as long as this. */
  void
  AddTo(CLI::App * command);

  /** What AddTo() reads back. */
  std::vector<std::string>
  ToArguments() const;
};
} // namespace dentalscr

#endif

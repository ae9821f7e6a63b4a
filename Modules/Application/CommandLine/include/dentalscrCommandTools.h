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
#ifndef dentalscrCommandTools_h
#define dentalscrCommandTools_h

#include "CommandLineExport.h"

#include "itkProcessObject.h"

#include <functional>
#include <string>
#include <vector>

namespace dentalscr
{
/** What the program ends with: Documentation/FileFormats.md. */
enum ExitCode : int
{
  AllRegistered = 0,
  SomeFailed = 1,
  UnusableInput = 2
};

/** Options that every verb has. */
struct CommonOptions
{
  unsigned int threads{ 0 };   /**< Threads to compute with; 0: as many as the machine has. */
  bool         quiet{ false }; /**< No progress is shown. */
  /** The words that the program was called with, its own name first. */
  std::vector<std::string> commandLine;
};

/** \class ProgressLine
 * \brief Shows on a terminal what a process object does, on one line that is rewritten; shows nothing in a pipe or when
 * quiet. Where DENTALSCR_PROGRESS is "slicer" it writes the tags of the Slicer Execution Model to standard output
 * instead. */
class CommandLine_EXPORT ProgressLine
{
public:
  ProgressLine(itk::ProcessObject * process, std::function<std::string()> stage, bool quiet);
  ~ProgressLine();
  ProgressLine(const ProgressLine &) = delete;
  ProgressLine &
  operator=(const ProgressLine &) = delete;

  /** Says a line on standard error that stays there: not behind the line that is rewritten, but in its place. */
  void
  Say(const std::string & line);

private:
  void
  Show();

  itk::ProcessObject *         m_Process;
  std::function<std::string()> m_Stage;
  bool                         m_IsForSlicer;
  bool                         m_Active;
  unsigned long                m_Tags[2]{ 0, 0 };
  std::string                  m_Last;
};

/** Ends the process object that runs when the user presses Ctrl-C, or a signal asks for it (TERM, HUP, PIPE), so that
 * nothing is left half-written. One at a time. */
class CommandLine_EXPORT InterruptGuard
{
public:
  explicit InterruptGuard(itk::ProcessObject * process); /**< Asks the process to end at Ctrl-C. */
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard &) = delete;
  InterruptGuard &
  operator=(const InterruptGuard &) = delete;
};
} // namespace dentalscr

#endif

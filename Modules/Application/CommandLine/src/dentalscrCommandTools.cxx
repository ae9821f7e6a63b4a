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
#include "dentalscrCommandTools.h"

#include "itkCommand.h"

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <sstream>

#include <unistd.h>

namespace dentalscr
{
namespace
{
// All that a signal handler may touch.
volatile std::sig_atomic_t interruptRequested = 0;

void
HandleInterrupt(int)
{
  interruptRequested = 1;
}

/** What asks a program to end: the user, the system, a terminal that is closed, a reader that has gone. */
constexpr int Signals[] = { SIGINT, SIGTERM, SIGHUP, SIGPIPE };
/** What was done at each before. */
struct sigaction previousActions[std::size(Signals)];

unsigned long        interruptTag = 0;
itk::ProcessObject * guardedProcess = nullptr;

/** The modules of 3D Slicer set it (Slicer/): their own reader of standard output is not a terminal. */
bool
IsStartedBySlicer()
{
  const char * const kind = std::getenv("DENTALSCR_PROGRESS");
  return kind != nullptr && std::string(kind) == "slicer";
}

/** Past std::cerr, which lets no control bytes through. */
void
EraseLine()
{
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
}
} // namespace

ProgressLine::ProgressLine(itk::ProcessObject * process, std::function<std::string()> stage, bool quiet)
  : m_Process(process)
  , m_Stage(std::move(stage))
  , m_IsForSlicer(IsStartedBySlicer())
  , m_Active(m_IsForSlicer || (!quiet && isatty(STDERR_FILENO) != 0))
{
  if (m_Active)
  {
    m_Tags[0] = m_Process->AddObserver(itk::ProgressEvent(), [this](const itk::EventObject &) { this->Show(); });
    m_Tags[1] =
      m_Process->AddObserver(itk::MultiResolutionIterationEvent(), [this](const itk::EventObject &) { this->Show(); });
  }
}

ProgressLine::~ProgressLine()
{
  if (m_Active)
  {
    m_Process->RemoveObserver(m_Tags[0]);
    m_Process->RemoveObserver(m_Tags[1]);
    if (!m_IsForSlicer)
    {
      EraseLine();
    }
  }
}

void
ProgressLine::Show()
{
  std::ostringstream line;
  if (m_IsForSlicer)
  {
    line << "<filter-progress>" << std::fixed << std::setprecision(2) << m_Process->GetProgress()
         << "</filter-progress>\n<filter-comment>" << m_Stage() << "</filter-comment>\n";
    if (line.str() != m_Last)
    {
      m_Last = line.str();
      std::cout << m_Last << std::flush;
    }
    return;
  }
  line << std::setw(3) << static_cast<int>(100.0F * m_Process->GetProgress() + 0.5F) << " %  " << m_Stage();
  if (line.str() != m_Last)
  {
    m_Last = line.str();
    EraseLine();
    std::cerr << m_Last << std::flush;
  }
}

void
ProgressLine::Say(const std::string & line)
{
  if (m_Active)
  {
    EraseLine();
    m_Last.clear();
  }
  std::cerr << line << std::endl;
}

InterruptGuard::InterruptGuard(itk::ProcessObject * process)
{
  interruptRequested = 0;
  guardedProcess = process;
  const auto poll = [process](const itk::EventObject &) {
    if (interruptRequested != 0)
    {
      process->AbortGenerateDataOn();
    }
  };
  interruptTag = process->AddObserver(itk::AnyEvent(), poll);
  for (std::size_t i = 0; i < std::size(Signals); ++i)
  {
    struct sigaction action
    {};
    action.sa_handler = HandleInterrupt;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    sigaction(Signals[i], nullptr, &previousActions[i]);
    // Who starts a program with nohup wants it to go on without a terminal. (A broken pipe is ignored by this program
    // itself, which finds it when it writes, and by Python.)
    if (previousActions[i].sa_handler != SIG_IGN || Signals[i] == SIGPIPE)
    {
      sigaction(Signals[i], &action, nullptr);
    }
  }
}

InterruptGuard::~InterruptGuard()
{
  for (std::size_t i = 0; i < std::size(Signals); ++i)
  {
    sigaction(Signals[i], &previousActions[i], nullptr);
  }
  guardedProcess->RemoveObserver(interruptTag);
  guardedProcess = nullptr;
}
} // namespace dentalscr

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
#include <iomanip>
#include <iostream>
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

unsigned long        interruptTag = 0;
itk::ProcessObject * guardedProcess = nullptr;
} // namespace

ProgressLine::ProgressLine(itk::ProcessObject * process, std::function<std::string()> stage, bool quiet)
  : m_Process(process)
  , m_Stage(std::move(stage))
  , m_Active(!quiet && isatty(STDERR_FILENO) != 0)
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
    std::cerr << "\r\033[K" << std::flush;
  }
}

void
ProgressLine::Show()
{
  std::ostringstream line;
  line << std::setw(3) << static_cast<int>(100.0F * m_Process->GetProgress() + 0.5F) << " %  " << m_Stage();
  if (line.str() != m_Last)
  {
    m_Last = line.str();
    std::cerr << "\r\033[K" << m_Last << std::flush;
  }
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
  std::signal(SIGINT, HandleInterrupt);
  std::signal(SIGTERM, HandleInterrupt);
}

InterruptGuard::~InterruptGuard()
{
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  guardedProcess->RemoveObserver(interruptTag);
  guardedProcess = nullptr;
}
} // namespace dentalscr

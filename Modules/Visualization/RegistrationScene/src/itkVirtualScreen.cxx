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
#include "itkVirtualScreen.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace itk
{
namespace
{
/** Xvfb is ready in a tenth of a second; a machine that swaps may need longer. */
constexpr int StartTimeoutMilliseconds = 20000;
} // namespace

std::string
VirtualScreen::FindProgram()
{
  const char * const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "/usr/bin" : path);
  std::string        folder;
  while (std::getline(folders, folder, ':'))
  {
    const std::string program = folder + "/Xvfb";
    if (!folder.empty() && access(program.c_str(), X_OK) == 0)
    {
      return program;
    }
  }
  return "";
}

VirtualScreen::VirtualScreen(unsigned int width, unsigned int height)
{
  const std::string program = FindProgram();
  if (program.empty())
  {
    itkGenericExceptionMacro(
      "Xvfb, which draws without a screen, is not on the PATH. Install it (apt-get install xvfb).");
  }
  const char * const old = std::getenv("DISPLAY");
  m_HadDisplay = old != nullptr;
  m_OldDisplay = m_HadDisplay ? old : "";

  int numberPipe[2];
  if (pipe2(numberPipe, O_CLOEXEC) != 0)
  {
    itkGenericExceptionMacro("Xvfb cannot be started: " << std::strerror(errno) << '.');
  }
  // All that needs memory is made before the fork: after it, other threads' locks may be held for ever.
  const std::string descriptor = std::to_string(numberPipe[1]);
  const std::string screen = std::to_string(width) + "x" + std::to_string(height) + "x24";
  // Without -noreset the server begins anew when its last client goes, and turns others away meanwhile.
  const char * const arguments[] = { program.c_str(), "-displayfd", descriptor.c_str(), "-screen", "0", screen.c_str(),
                                     "-nolisten",     "tcp",        "-noreset",         nullptr };
  const pid_t        parent = getpid();
  const pid_t        child = fork();
  if (child == 0)
  {
    // It ends with its parent, however that ends: the signal must reach it whatever the parent heeds.
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    std::signal(SIGTERM, SIG_DFL);
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent)
    {
      _exit(127);
    }
    // Ctrl-C is for the program, which stops its screen itself.
    setpgid(0, 0);
    fcntl(numberPipe[1], F_SETFD, 0);
    const int nothing = open("/dev/null", O_RDWR);
    dup2(nothing, STDIN_FILENO);
    dup2(nothing, STDOUT_FILENO);
    dup2(nothing, STDERR_FILENO);
    execv(program.c_str(), const_cast<char * const *>(arguments));
    _exit(127);
  }
  close(numberPipe[1]);
  m_ProcessId = child;
  std::string number;
  pollfd      wait{ numberPipe[0], POLLIN, 0 };
  while (child > 0 && number.find('\n') == std::string::npos)
  {
    const int ready = poll(&wait, 1, StartTimeoutMilliseconds);
    if (ready < 0 && errno == EINTR)
    {
      continue;
    }
    if (ready <= 0)
    {
      break;
    }
    char          buffer[16];
    const ssize_t count = read(numberPipe[0], buffer, sizeof(buffer));
    if (count <= 0)
    {
      break;
    }
    number.append(buffer, static_cast<std::size_t>(count));
  }
  close(numberPipe[0]);
  if (number.empty() || number.find('\n') == std::string::npos)
  {
    this->Stop();
    itkGenericExceptionMacro(<< program << " did not start. Run it by hand to see why: Xvfb :99 -screen 0 640x480x24");
  }
  m_Display = ':' + number.substr(0, number.find('\n'));
  setenv("DISPLAY", m_Display.c_str(), 1);
}

VirtualScreen::~VirtualScreen()
{
  this->Stop();
  if (m_HadDisplay)
  {
    setenv("DISPLAY", m_OldDisplay.c_str(), 1);
  }
  else
  {
    unsetenv("DISPLAY");
  }
}

void
VirtualScreen::Stop()
{
  if (m_ProcessId > 0)
  {
    kill(static_cast<pid_t>(m_ProcessId), SIGTERM);
    int status = 0;
    while (waitpid(static_cast<pid_t>(m_ProcessId), &status, 0) < 0 && errno == EINTR)
    {}
    m_ProcessId = -1;
  }
}
} // namespace itk

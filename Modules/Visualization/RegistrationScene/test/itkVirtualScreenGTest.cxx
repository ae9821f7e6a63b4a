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

#include "itkScreenConnection.h"

#include "gtest/gtest.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <string>
#include <thread>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{
/** An environment variable for the time of a test. */
class Variable
{
public:
  Variable(const char * name, const char * value)
    : m_Name(name)
  {
    const char * const old = std::getenv(name);
    m_Had = old != nullptr;
    m_Old = m_Had ? old : "";
    setenv(name, value, 1);
  }
  ~Variable() { m_Had ? setenv(m_Name, m_Old.c_str(), 1) : unsetenv(m_Name); }

private:
  const char * m_Name;
  std::string  m_Old;
  bool         m_Had;
};
} // namespace

TEST(VirtualScreen, AnswersWhileItLivesAndIsGoneAfterwards)
{
  if (itk::VirtualScreen::FindProgram().empty())
  {
    GTEST_SKIP() << "Xvfb is not installed";
  }
  const Variable display("DISPLAY", ":no-such-display");
  EXPECT_FALSE(itk::ScreenConnection().IsOpen());
  long process = 0;
  {
    const itk::VirtualScreen screen(320, 200);
    process = screen.GetProcessId();
    EXPECT_EQ(screen.GetDisplay(), std::getenv("DISPLAY"));
    // Again and again: the server does not turn away who comes after its last client has gone.
    for (unsigned int i = 0; i < 20; ++i)
    {
      EXPECT_TRUE(itk::ScreenConnection().IsOpen());
    }
    EXPECT_EQ(kill(static_cast<pid_t>(process), 0), 0);
  }
  EXPECT_STREQ(std::getenv("DISPLAY"), ":no-such-display");
  // Reaped, not only told to end.
  EXPECT_EQ(kill(static_cast<pid_t>(process), 0), -1);
  EXPECT_EQ(errno, ESRCH);
}

TEST(VirtualScreen, EndsWithAProcessThatIsKilled)
{
  if (itk::VirtualScreen::FindProgram().empty())
  {
    GTEST_SKIP() << "Xvfb is not installed";
  }
  // Whose parent has died becomes this process's child, and can be waited for.
  ASSERT_EQ(prctl(PR_SET_CHILD_SUBREAPER, 1), 0);
  int pipeOfNumbers[2];
  ASSERT_EQ(pipe(pipeOfNumbers), 0);
  const pid_t program = fork();
  if (program == 0)
  {
    // As where a supervisor has blocked or ignored what asks to end: it is no reason to leave a server behind.
    sigset_t blocked;
    sigemptyset(&blocked);
    sigaddset(&blocked, SIGTERM);
    sigprocmask(SIG_BLOCK, &blocked, nullptr);
    std::signal(SIGTERM, SIG_IGN);
    const itk::VirtualScreen screen(320, 200);
    const long               server = screen.GetProcessId();
    if (write(pipeOfNumbers[1], &server, sizeof(server)) == static_cast<ssize_t>(sizeof(server)))
    {
      pause();
    }
    _exit(1);
  }
  long server = 0;
  ASSERT_EQ(read(pipeOfNumbers[0], &server, sizeof(server)), static_cast<ssize_t>(sizeof(server)));
  close(pipeOfNumbers[0]);
  close(pipeOfNumbers[1]);
  ASSERT_EQ(kill(static_cast<pid_t>(server), 0), 0);
  ASSERT_EQ(kill(program, SIGKILL), 0);
  int status = 0;
  ASSERT_EQ(waitpid(program, &status, 0), program);
  ASSERT_TRUE(WIFSIGNALED(status));
  pid_t      ended = 0;
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (ended == 0 && std::chrono::steady_clock::now() < deadline)
  {
    ended = waitpid(static_cast<pid_t>(server), &status, WNOHANG);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_EQ(ended, server);
  if (ended == 0)
  {
    kill(static_cast<pid_t>(server), SIGKILL);
    waitpid(static_cast<pid_t>(server), &status, 0);
  }
  prctl(PR_SET_CHILD_SUBREAPER, 0);
}

TEST(VirtualScreen, SaysWhatToInstallWhereItIsNot)
{
  const Variable path("PATH", "/nowhere");
  EXPECT_EQ(itk::VirtualScreen::FindProgram(), "");
  try
  {
    const itk::VirtualScreen screen(320, 200);
    FAIL() << "it started";
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_NE(std::string(error.GetDescription()).find("apt-get install xvfb"), std::string::npos);
  }
}

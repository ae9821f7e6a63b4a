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
#include "dentalscrManualPage.h"
#include "dentalscrPrintableBuffer.h"
#include "dentalscrProgramDescription.h"
#include "dentalscrShellCompletion.h"

#include "itkDentalInputError.h"
#include "itkDentalSCRVersion.h"
#include "itkDescribePlainly.h"
#include "itkParallelFor.h"

#include "itkBMPImageIOFactory.h"
#include "itkJPEGImageIOFactory.h"
#include "itkMetaImageIOFactory.h"
#include "itkMultiThreaderBase.h"
#include "itkNrrdImageIOFactory.h"
#include "itkPNGImageIOFactory.h"
#include "itkTIFFImageIOFactory.h"
#include "itkThreadPool.h"
#include "itkVersion.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <mutex>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

namespace dentalscr
{
namespace
{
/** Errors are one line; more would hide in a log which case it was. */
int
Fail(std::string message)
{
  for (char & character : message)
  {
    if (character == '\n' || character == '\r')
    {
      character = ' ';
    }
  }
  std::cerr << "dentalscr: " << message << std::endl;
  return UnusableInput;
}

/** A standard stream that was closed gets a place holder that can't be used: the next file that is opened would take
 * its number, and what is said would be written into it. */
void
HoldStandardStreams()
{
  for (const int stream : { STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO })
  {
    if (fcntl(stream, F_GETFD) < 0)
    {
      // The lowest number that is free: this one.
      open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
  }
}

/** Waits until this process has no thread but this one. A thread that was joined is counted among the user's processes
 * for a moment longer, in which the system may give no new one. */
void
WaitUntilAlone()
{
#if defined(__linux__)
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(1);
  const auto isAlone = []() {
    std::error_code error;
    const auto      threads = std::filesystem::directory_iterator("/proc/self/task", error);
    return error || std::distance(begin(threads), std::filesystem::directory_iterator()) <= 1;
  };
  while (!isAlone() && std::chrono::steady_clock::now() < end)
  {
    std::this_thread::yield();
  }
#endif
}

/** Starts ITK's pool with as many threads as there are to be had. The pool would start all of them at once, and end the
 * process where the system gives fewer. So threads that do nothing are tried before; what is missing is said once. Then
 * the pool gets them one by one, as others of the user's processes may have taken some meanwhile. */
void
SetNumberOfThreads(unsigned int wanted)
{
  std::mutex               mutex;
  std::condition_variable  changed;
  bool                     isOver = false;
  std::vector<std::thread> threads;
  itk::StartThreads(
    wanted,
    [&]() {
      std::unique_lock<std::mutex> lock(mutex);
      changed.wait(lock, [&]() { return isOver; });
    },
    threads);
  {
    const std::lock_guard<std::mutex> lock(mutex);
    isOver = true;
  }
  changed.notify_all();
  for (std::thread & thread : threads)
  {
    thread.join();
  }
  auto number = static_cast<itk::ThreadIdType>(threads.size());
  if (number == 0)
  {
    // Its pool has at least one thread beside this; the other kind works without.
    itk::MultiThreaderBase::SetGlobalDefaultThreader(itk::MultiThreaderBase::ThreaderEnum::Platform);
    number = 1;
  }
  else
  {
    WaitUntilAlone();
    itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(1);
    const itk::ThreadPool::Pointer pool = itk::ThreadPool::GetInstance();
    try
    {
      while (pool->GetMaximumNumberOfThreads() < number)
      {
        pool->AddThreads(1);
      }
    }
    catch (const std::system_error &)
    {
      number = pool->GetMaximumNumberOfThreads();
    }
  }
  itk::MultiThreaderBase::SetGlobalMaximumNumberOfThreads(number);
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(number);
}

/** What the program is asked to say of itself: --describe, --completion SHELL, --man [VERB]; else nothing. */
std::string
Describe(const CLI::App & program, int argc, const char * const * argv)
{
  const std::string first = argc > 1 ? argv[1] : "";
  const std::string second = argc > 2 ? argv[2] : "";
  if (first == "--describe")
  {
    return ToJson(DescribeProgram(program));
  }
  if (first == "--completion")
  {
    return WriteShellCompletion(DescribeProgram(program), second);
  }
  return first == "--man" ? WriteManualPage(DescribeProgram(program), second) : "";
}

int
Run(int argc, const char * const * argv)
{
  // Explicitly: a static registration would need every format that ITK has.
  itk::PNGImageIOFactory::RegisterOneFactory();
  itk::TIFFImageIOFactory::RegisterOneFactory();
  itk::MetaImageIOFactory::RegisterOneFactory();
  itk::NrrdImageIOFactory::RegisterOneFactory();
  itk::BMPImageIOFactory::RegisterOneFactory();
  itk::JPEGImageIOFactory::RegisterOneFactory();

  CLI::App program{ "Aligns 3-D intraoral scans of the teeth with a lateral cephalometric radiograph.\n"
                    "Research software, not a medical device." };
  program.name("dentalscr");
  program.set_version_flag(
    "--version", std::string("dentalscr ") + itk::DentalSCRVersion + " (ITK " + itk::Version::GetITKVersion() + ")");
  program.require_subcommand(1);
  program.fallthrough();
  program.footer("Example:\n"
                 "  dentalscr phantom --output sample\n"
                 "  dentalscr register sample/case.json --output result\n"
                 "Each verb has its own --help with examples. --xml describes the verb register to 3D Slicer,\n"
                 "--completion SHELL prints a script for bash, zsh or fish, --man [VERB] a manual page.");

  CommonOptions common;
  program.add_option("--threads", common.threads, "Number of threads (0: all); the result is the same for any")
    ->check(CLI::Range(0u, 1024u));
  program.add_flag("--quiet", common.quiet, "No progress and no summary");

  RunFunction run;
  AddRegisterCommand(program, common, run);
  AddTraceCommand(program, common, run);
  AddNewCommand(program, common, run);
  AddBatchCommand(program, common, run);
  AddAxisCommand(program, common, run);
  AddRenderCommand(program, common, run);
  AddContourCommand(program, common, run);
  AddProjectCommand(program, common, run);
  AddReportCommand(program, common, run);
  AddEvaluateCommand(program, common, run);
  AddPhantomCommand(program, common, run);
  AddExperimentCommand(program, common, run);
  AddViewCommand(program, common, run);

  if (argc > 1 && std::string(argv[1]) == "--xml")
  {
    std::cout << SlicerDescription() << std::flush;
    return AllRegistered;
  }
  try
  {
    const std::string text = Describe(program, argc, argv);
    if (!text.empty())
    {
      std::cout << text << std::flush;
      return AllRegistered;
    }
  }
  catch (const std::invalid_argument & error)
  {
    return Fail(error.what());
  }
  const auto isChosen = [&](CLI::App * verb) { return argc > 1 && verb->get_name() == argv[1]; };
  if (argc > 1 && argv[1][0] != '-' && program.get_subcommands(isChosen).empty())
  {
    return Fail(std::string("there is no verb \"") + argv[1] + "\"; see dentalscr --help");
  }
  // 3D Slicer puts every flag before the arguments by position, and the verb is one of these.
  std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  const auto               verb = std::find(arguments.begin(), arguments.end(), "register");
  if (std::find(arguments.begin(), arguments.end(), "--returnparameterfile") < verb && verb != arguments.end())
  {
    std::rotate(arguments.begin(), verb, verb + 1);
  }
  try
  {
    // CLI11 takes them from the back.
    program.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  }
  catch (const CLI::ParseError & error)
  {
    // --help and --version arrive as errors with exit code 0.
    if (error.get_exit_code() == 0)
    {
      return program.exit(error);
    }
    return Fail(std::string(error.what()) + "; see dentalscr --help");
  }

  common.commandLine = arguments;
  common.commandLine.insert(common.commandLine.begin(), program.get_name());
  try
  {
    SetNumberOfThreads(common.threads > 0 ? common.threads : itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads());
    return run();
  }
  catch (const itk::DentalInputError & error)
  {
    return Fail(error.GetOneLine());
  }
  catch (const itk::ProcessAborted &)
  {
    return Fail("interrupted; nothing was written");
  }
  catch (const itk::ExceptionObject & error)
  {
    return Fail(itk::DescribePlainly(error));
  }
  catch (const std::bad_alloc &)
  {
    return Fail("out of memory");
  }
  catch (const std::exception & error)
  {
    return Fail(error.what());
  }
}
} // namespace

int
Main(int argc, const char * const * argv)
{
  // A reader that has gone is found when something is written to it, and said.
  std::signal(SIGPIPE, SIG_IGN);
  // So is a limit on the size of files.
  std::signal(SIGXFSZ, SIG_IGN);
  HoldStandardStreams();
  const PrintableBuffer output(std::cout);
  const PrintableBuffer errors(std::cerr);
  const int             status = Run(argc, argv);
  if (!std::cout.flush())
  {
    return Fail(
      "standard output can't be written: the disk is full, or what reads it has ended; what was said is lost");
  }
  return status;
}
} // namespace dentalscr

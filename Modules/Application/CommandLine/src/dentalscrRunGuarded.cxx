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
#include "dentalscrRunGuarded.h"

#include "dentalscrCommandTools.h"
#include "dentalscrPrintableBuffer.h"

#include "itkDentalInputError.h"
#include "itkDescribePlainly.h"
#include "itkParallelFor.h"

#include "itkMultiThreaderBase.h"
#include "itkThreadPool.h"

#include <chrono>
#include <condition_variable>
#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

namespace dentalscr
{
namespace
{
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

/** The threads of this process as the system counts them; 0 where it does not tell. */
std::ptrdiff_t
CountThreads()
{
  std::error_code error;
  const auto      threads = std::filesystem::directory_iterator("/proc/self/task", error);
  return error ? 0 : std::distance(begin(threads), std::filesystem::directory_iterator());
}

/** Waits until the system counts no more threads than before some were started and joined. A joined one is counted
 * among the user's processes for a moment longer, in which it may give no new one. Others there may be: those of a
 * host. */
void
WaitForThreadsToLeave(std::ptrdiff_t before)
{
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(100);
  while (CountThreads() > before && std::chrono::steady_clock::now() < end)
  {
    std::this_thread::yield();
  }
}

int
Try(const std::function<int()> & program)
{
  try
  {
    return program();
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

/** The pool would start all threads at once, and end the process where the system gives fewer. So threads that do
 * nothing are tried before; what is missing is said once. Then the pool gets them one by one, as others of the user's
 * processes may have taken some meanwhile. */
void
SetNumberOfThreads(unsigned int wanted)
{
  wanted = wanted > 0 ? wanted : itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads();
  std::mutex               mutex;
  std::condition_variable  changed;
  bool                     isOver = false;
  std::vector<std::thread> threads;
  const std::ptrdiff_t     before = CountThreads();
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
    changed.notify_all();
  }
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
    WaitForThreadsToLeave(before);
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

int
RunGuarded(const std::function<int()> & program)
{
  // A reader that has gone is found when something is written to it, and said.
  std::signal(SIGPIPE, SIG_IGN);
  // So is a limit on the size of files.
  std::signal(SIGXFSZ, SIG_IGN);
  HoldStandardStreams();
  const PrintableBuffer output(std::cout);
  const PrintableBuffer errors(std::cerr);
  const int             status = Try(program);
  if (!std::cout.flush())
  {
    return Fail(
      "standard output can't be written: the disk is full, or what reads it has ended; what was said is lost");
  }
  return status;
}
} // namespace dentalscr

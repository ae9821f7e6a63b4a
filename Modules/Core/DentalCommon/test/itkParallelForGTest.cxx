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
#include "itkParallelFor.h"

#include "itkOutputWindow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <mutex>
#include <set>
#include <stdexcept>

#if defined(__linux__)
#  include <sys/resource.h>
#  include <sys/wait.h>
#  include <unistd.h>

#  include <fstream>
#endif

namespace
{
/** Threads that take part in a call; each index holds its thread until enough have come, or a second has passed. */
std::set<std::thread::id>
Participants(unsigned int threads)
{
  std::mutex                mutex;
  std::set<std::thread::id> ids;
  const auto                end = std::chrono::steady_clock::now() + std::chrono::seconds(1);
  itk::ParallelFor(threads, threads, [&](std::size_t) {
    for (;;)
    {
      {
        const std::lock_guard<std::mutex> lock(mutex);
        ids.insert(std::this_thread::get_id());
        if (ids.size() >= threads || std::chrono::steady_clock::now() > end)
        {
          return;
        }
      }
      std::this_thread::yield();
    }
  });
  return ids;
}
} // namespace

TEST(ParallelFor, VisitsEachIndexOnce)
{
  for (const unsigned int threads : { 0u, 1u, 2u, 7u })
  {
    std::vector<int> visits(1000, 0);
    itk::ParallelFor(visits.size(), threads, [&](std::size_t i) { ++visits[i]; });
    EXPECT_EQ(visits, std::vector<int>(1000, 1)) << threads << " threads";
  }
}

TEST(ParallelFor, RethrowsTheBodysException)
{
  for (const unsigned int threads : { 1u, 4u })
  {
    const auto body = [](std::size_t i) {
      if (i == 17)
      {
        throw std::runtime_error("seventeen");
      }
    };
    EXPECT_THROW(itk::ParallelFor(100, threads, body), std::runtime_error) << threads << " threads";
  }
}

TEST(ParallelFor, ThreadsStayAlive)
{
  EXPECT_EQ(Participants(3).count(std::this_thread::get_id()), 1u) << "the caller works too";
  std::atomic<unsigned int> newcomers{ 0 };
  for (unsigned int call = 0; call < 50; ++call)
  {
    EXPECT_EQ(Participants(3).size(), 3u);
    itk::ParallelFor(100, 3, [&newcomers](std::size_t) {
      thread_local bool known = false;
      newcomers += known ? 0 : 1;
      known = true;
    });
  }
  // The caller and the pool, which is as large as the largest call of these tests or of the machine has made it.
  // Threads of each call's own would be up to 101.
  EXPECT_LE(newcomers, 1 + std::max(6u, std::thread::hardware_concurrency()));
}

TEST(ParallelFor, MayBeNestedAndCalledBySeveralThreads)
{
  constexpr std::size_t    callers = 4;
  std::vector<std::size_t> sums(callers, 0);
  std::vector<std::thread> threads;
  for (std::size_t caller = 0; caller < callers; ++caller)
  {
    threads.emplace_back([&sums, caller]() {
      for (unsigned int repetition = 0; repetition < 200; ++repetition)
      {
        std::vector<std::size_t> parts(5, 0);
        itk::ParallelFor(parts.size(), 3, [&parts](std::size_t i) {
          std::vector<std::size_t> values(7, 0);
          itk::ParallelFor(values.size(), 2, [&values, i](std::size_t j) { values[j] = i * j; });
          for (const std::size_t value : values)
          {
            parts[i] += value;
          }
        });
        for (const std::size_t part : parts)
        {
          sums[caller] += part;
        }
      }
    });
  }
  for (std::thread & thread : threads)
  {
    thread.join();
  }
  // The sum of i j over 5 and 7.
  EXPECT_EQ(sums, std::vector<std::size_t>(callers, 200 * 10 * 21));
}

TEST(ParallelFor, LeavesOutWhatWasNotBegunAtAnException)
{
  std::atomic<unsigned int> begun{ 0 };
  EXPECT_THROW(itk::ParallelFor(1000000,
                                2,
                                [&begun](std::size_t) {
                                  ++begun;
                                  throw std::runtime_error("the first");
                                }),
               std::runtime_error);
  EXPECT_LE(begun, 2u);
}

#if defined(__linux__)
TEST(ParallelFor, AForkedProcessHasThreadsOfItsOwn)
{
  EXPECT_EQ(Participants(2).size(), 2u);
  const pid_t child = fork();
  if (child == 0)
  {
    // 2 where it worked; a child that waited for its parent's threads would never end.
    alarm(20);
    _exit(static_cast<int>(Participants(2).size()));
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 2);
}

#  if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
namespace
{
class CountingWindow : public itk::OutputWindow
{
public:
  using Self = CountingWindow;
  using Superclass = itk::OutputWindow;
  using Pointer = itk::SmartPointer<Self>;
  itkFactorylessNewMacro(Self);

  void
  DisplayWarningText(const char * text) override
  {
    ++count;
    message = text;
  }

  unsigned int count{ 0 };
  std::string  message;
};
} // namespace

TEST(ParallelFor, WhereThreadsCannotBeStartedFewerDoTheWorkAndItIsSaidOnce)
{
  // In a process of its own, whose memory has no room for another stack.
  const auto child = []() {
    const auto window = CountingWindow::New();
    itk::OutputWindow::SetInstance(window);
    std::ifstream pages("/proc/self/statm");
    rlim_t        size = 0;
    pages >> size;
    const rlim_t bytes = size * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + (1u << 20);
    const rlimit limit{ bytes, bytes };
    setrlimit(RLIMIT_AS, &limit);
    std::vector<int> visits(1000, 0);
    for (unsigned int call = 0; call < 3; ++call)
    {
      itk::ParallelFor(visits.size(), 16, [&visits](std::size_t i) { ++visits[i]; });
    }
    std::vector<std::thread> threads;
    const std::size_t        started = itk::StartThreads(
      16, []() {}, threads);
    for (std::thread & thread : threads)
    {
      thread.join();
    }
    std::cerr << window->count << " warning: " << window->message << std::endl;
    _exit(visits == std::vector<int>(1000, 3) && started == threads.size() && started < 16 ? 0 : 1);
  };
  EXPECT_EXIT(child(), ::testing::ExitedWithCode(0), "1 warning: .*the system gave .* of 15 threads");
}
#  endif
#endif

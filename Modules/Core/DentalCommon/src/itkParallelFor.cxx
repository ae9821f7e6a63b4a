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

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <list>
#include <mutex>
#include <sstream>
#include <string>

#if defined(__unix__) || defined(__APPLE__)
#  include <unistd.h>
#endif

namespace itk
{
namespace
{
/** How long a thread looks for more before it sleeps: longer than what lies between the steps of one kernel, and
 * shorter than anybody could miss it. */
constexpr std::chrono::microseconds Patience{ 100 };

/** Waits politely for what another thread is about to do. \return whether it did */
template <typename TCondition>
bool
SpinUntil(const TCondition & condition)
{
  const auto end = std::chrono::steady_clock::now() + Patience;
  for (unsigned int round = 0;; ++round)
  {
    if (condition())
    {
      return true;
    }
    // The clock is dearer than the look, and on a busy machine the others have to get on.
    if (round % 16 == 15)
    {
      if (std::chrono::steady_clock::now() > end)
      {
        return false;
      }
      std::this_thread::yield();
    }
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
  }
}

/** Starts threads as long as the system gives them. \return why it gave no more; empty where it gave all */
std::string
TryToStartThreads(std::size_t count, const std::function<void()> & work, std::vector<std::thread> & threads)
{
  std::size_t started = 0;
  try
  {
    threads.reserve(threads.size() + count);
    for (; started < count; ++started)
    {
      threads.emplace_back(work);
    }
  }
  catch (const std::exception & error)
  {
    std::ostringstream text;
    text << "the system gave " << started << " of " << count << " threads (" << error.what() << ")";
    return text.str();
  }
  return "";
}

/** Without a lock that work could want: a window of the user's may do anything. */
void
SayThatThreadsAreMissing(const std::string & why)
{
  static std::once_flag once;
  if (!why.empty())
  {
    std::call_once(once, [&why]() {
      const std::string text = "DentalSCR: " + why +
                               ". The work goes on with fewer, and the results are the same. Ask for fewer threads, or "
                               "raise the limits of processes and memory (ulimit -u, -v).\n";
      OutputWindowDisplayWarningText(text.c_str());
    });
  }
}

std::size_t
ProcessNumber()
{
#if defined(__unix__) || defined(__APPLE__)
  return static_cast<std::size_t>(::getpid());
#else
  return 0;
#endif
}

/** One call of RunInParallel(), on the stack of its caller. */
struct Job
{
  std::size_t count;
  void (*call)(void *, std::size_t);
  void *                   body;
  std::atomic<std::size_t> next{ 0 };
  std::mutex               mutex;
  std::exception_ptr       failure;
  /** Threads that may still join, and those that have and are not done; guarded by the pool, the second readable. */
  std::size_t              places{ 0 };
  std::atomic<std::size_t> inside{ 0 };

  void
  Work()
  {
    for (std::size_t i = next++; i < count; i = next++)
    {
      try
      {
        call(body, i);
      }
      catch (...)
      {
        const std::lock_guard<std::mutex> lock(mutex);
        if (!failure)
        {
          failure = std::current_exception();
        }
        next = count;
      }
    }
  }
};

class Pool
{
public:
  /** The process's. It is never destroyed: its threads may sleep until the process ends. A process that was forked has
   * none of its parent's threads and gets a pool of its own. */
  static Pool &
  Get()
  {
    static std::atomic<Pool *> current{ nullptr };
    Pool *                     pool = current.load();
    while (pool == nullptr || pool->m_Process != ProcessNumber())
    {
      auto fresh = std::make_unique<Pool>();
      if (current.compare_exchange_strong(pool, fresh.get()))
      {
        pool = fresh.release();
      }
    }
    return *pool;
  }

  void
  Run(Job & job, std::size_t helpers)
  {
    std::string missing;
    {
      const std::lock_guard<std::mutex> lock(m_Mutex);
      if (m_Threads.size() < helpers && !m_Exhausted)
      {
        missing = TryToStartThreads(
          helpers - m_Threads.size(), [this]() { this->Serve(); }, m_Threads);
        m_Exhausted = !missing.empty();
      }
      helpers = std::min(helpers, m_Threads.size());
      job.places = helpers;
      m_Jobs.push_back(&job);
      m_Places += helpers;
    }
    SayThatThreadsAreMissing(missing);
    if (helpers == 1)
    {
      m_Offered.notify_one();
    }
    else
    {
      m_Offered.notify_all();
    }
    job.Work();
    {
      // Nobody joins any more.
      const std::lock_guard<std::mutex> lock(m_Mutex);
      m_Places -= job.places;
      m_Jobs.remove(&job);
    }
    if (!SpinUntil([&job]() { return job.inside == 0; }))
    {
      std::unique_lock<std::mutex> lock(m_Mutex);
      m_Left.wait(lock, [&job]() { return job.inside == 0; });
    }
    // The last one out may still hold the lock under which it said so.
    const std::lock_guard<std::mutex> lock(m_Mutex);
  }

private:
  [[noreturn]] void
  Serve()
  {
    for (;;)
    {
      SpinUntil([this]() { return m_Places > 0; });
      std::unique_lock<std::mutex> lock(m_Mutex);
      m_Offered.wait(lock, [this]() { return m_Places > 0; });
      const auto found = std::find_if(m_Jobs.begin(), m_Jobs.end(), [](const Job * job) { return job->places > 0; });
      Job &      job = **found;
      --job.places;
      --m_Places;
      ++job.inside;
      lock.unlock();
      job.Work();
      lock.lock();
      // Afterwards the job may be gone.
      if (--job.inside == 0)
      {
        m_Left.notify_all();
      }
    }
  }

  const std::size_t        m_Process{ ProcessNumber() };
  std::mutex               m_Mutex;
  std::condition_variable  m_Offered;
  std::condition_variable  m_Left;
  std::list<Job *>         m_Jobs;
  std::vector<std::thread> m_Threads;
  /** The system gave fewer than were asked for once; it is not asked again, so that this is said once. */
  bool m_Exhausted{ false };
  /** Of all jobs; guarded, but readable. */
  std::atomic<std::size_t> m_Places{ 0 };
};
} // namespace

void
RunInParallel(std::size_t count, unsigned int threads, void (*call)(void * body, std::size_t i), void * body)
{
  if (threads == 0)
  {
    threads = std::max(1u, std::thread::hardware_concurrency());
  }
  Job job;
  job.count = count;
  job.call = call;
  job.body = body;
  const std::size_t helpers = std::min<std::size_t>(threads, count) - (count > 0 ? 1 : 0);
  if (helpers == 0)
  {
    job.Work();
  }
  else
  {
    Pool::Get().Run(job, helpers);
  }
  if (job.failure)
  {
    std::rethrow_exception(job.failure);
  }
}

std::size_t
StartThreads(std::size_t count, const std::function<void()> & work, std::vector<std::thread> & threads)
{
  const std::size_t before = threads.size();
  SayThatThreadsAreMissing(TryToStartThreads(count, work, threads));
  return threads.size() - before;
}
} // namespace itk

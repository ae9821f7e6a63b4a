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
#include "itkPoseIterationMonitor.h"

#include "itkParallelFor.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>
#include <vector>

namespace itk
{
PoseIterationMonitor::PoseIterationMonitor(HandlerType handler, AbortType abort)
  : m_Handler(std::move(handler))
  , m_Abort(std::move(abort))
  , m_Owner(std::this_thread::get_id())
{}

bool
PoseIterationMonitor::IsAborted()
{
  if (!m_Aborted && m_Abort && std::this_thread::get_id() == m_Owner && m_Abort())
  {
    m_Aborted = true;
  }
  return m_Aborted;
}

void
PoseIterationMonitor::Post(const PoseRegistrationIteration & iteration)
{
  const bool isOwner = std::this_thread::get_id() == m_Owner;
  if (m_Handler)
  {
    const std::lock_guard<std::mutex> lock(m_Mutex);
    m_Queue.push_back(iteration);
    if (!isOwner)
    {
      m_Arrived.notify_one();
    }
  }
  if (isOwner)
  {
    this->Drain();
  }
}

void
PoseIterationMonitor::Drain()
{
  for (;;)
  {
    PoseRegistrationIteration iteration;
    {
      const std::lock_guard<std::mutex> lock(m_Mutex);
      if (m_Queue.empty() || m_Aborted)
      {
        m_Queue.clear();
        break;
      }
      iteration = m_Queue.front();
      m_Queue.pop_front();
    }
    m_Handler(iteration);
    this->IsAborted();
  }
}

void
PoseIterationMonitor::ForEach(std::size_t count, unsigned int threads, const std::function<void(std::size_t)> & body)
{
  if (threads == 0)
  {
    threads = std::max(1U, std::thread::hardware_concurrency());
  }
  std::atomic<std::size_t> next{ 0 };
  std::size_t              running = 0;
  std::exception_ptr       failure;
  const auto               fail = [&]() {
    const std::lock_guard<std::mutex> lock(m_Mutex);
    if (!failure)
    {
      failure = std::current_exception();
    }
    // Nobody needs what the others would still find.
    m_Aborted = true;
  };
  const auto work = [&]() {
    for (std::size_t i = next++; i < count && !this->IsAborted(); i = next++)
    {
      try
      {
        body(i);
      }
      catch (...)
      {
        fail();
      }
    }
  };
  std::vector<std::thread> pool;
  const std::size_t        extra = std::min<std::size_t>(count, threads) - (count > 0 ? 1 : 0);
  {
    // None of them is done before all are counted.
    const std::lock_guard<std::mutex> lock(m_Mutex);
    running = StartThreads(
      extra,
      [&]() {
        work();
        const std::lock_guard<std::mutex> done(m_Mutex);
        --running;
        m_Arrived.notify_one();
      },
      pool);
  }
  work();
  for (bool waiting = !pool.empty(); waiting;)
  {
    {
      std::unique_lock<std::mutex> lock(m_Mutex);
      // Now and then, since an abort may come from a thread that tells nobody.
      m_Arrived.wait_for(lock, std::chrono::milliseconds(10), [&]() { return running == 0 || !m_Queue.empty(); });
      waiting = running > 0;
    }
    this->IsAborted();
    try
    {
      this->Drain();
    }
    catch (...)
    {
      fail();
    }
  }
  for (std::thread & thread : pool)
  {
    thread.join();
  }
  if (failure)
  {
    std::rethrow_exception(failure);
  }
  this->Drain();
}
} // namespace itk

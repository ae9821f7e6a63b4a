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
#ifndef itkParallelFor_h
#define itkParallelFor_h

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace itk
{
/** Calls body(i) for i in [0, count) on up to the given number of threads (0: all of the machine's). Which thread takes
 * which i is not determined: a body that writes only its own slot gives the same bits for any number of threads. The
 * first exception of a body is rethrown here after all threads have ended. For kernels free of ITK headers; filters use
 * their MultiThreader. */
template <typename TBody>
void
ParallelFor(std::size_t count, unsigned int threads, TBody && body)
{
  if (threads == 0)
  {
    threads = std::thread::hardware_concurrency();
  }
  if (threads <= 1 || count <= 1)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      body(i);
    }
    return;
  }
  std::atomic<std::size_t> next{ 0 };
  std::exception_ptr       failure;
  std::mutex               failureMutex;
  const auto               work = [&]() {
    for (std::size_t i = next++; i < count; i = next++)
    {
      try
      {
        body(i);
      }
      catch (...)
      {
        const std::lock_guard<std::mutex> lock(failureMutex);
        if (!failure)
        {
          failure = std::current_exception();
        }
        next = count;
      }
    }
  };
  std::vector<std::thread> pool;
  const std::size_t        extra = (count < threads ? count : threads) - 1;
  pool.reserve(extra);
  for (std::size_t t = 0; t < extra; ++t)
  {
    pool.emplace_back(work);
  }
  work();
  for (std::thread & thread : pool)
  {
    thread.join();
  }
  if (failure)
  {
    std::rethrow_exception(failure);
  }
}
} // namespace itk

#endif

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

#include "DentalCommonExport.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <thread>
#include <type_traits>
#include <vector>

namespace itk
{
/** ParallelFor() without its template. */
DentalCommon_EXPORT void
RunInParallel(std::size_t count, unsigned int threads, void (*call)(void * body, std::size_t i), void * body);

/** Calls body(i) for i in [0, count) on up to the given number of threads (0: all of the machine's), of which the
 * caller's is one. Which thread takes which i is not determined: a body that writes only its own slot gives the same
 * bits for any number of threads. The first exception of a body is rethrown here after all threads have left; what was
 * not begun by then is left out. Calls may be nested, and may come from several threads at once.
 *
 * The other threads are those of one pool of the process. They are started when they are first needed, stay alive, and
 * go on looking for work for a moment before they sleep, so that one call soon after another costs about a microsecond.
 * The caller never waits for a thread to begin: where threads are busy or cannot be started it does more of the work
 * itself. That a thread cannot be started is said once, through itk::OutputWindow. For kernels; filters that split an
 * image use their MultiThreader. */
template <typename TBody>
void
ParallelFor(std::size_t count, unsigned int threads, TBody && body)
{
  if (threads == 1 || count <= 1)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      body(i);
    }
    return;
  }
  using BodyType = std::remove_reference_t<TBody>;
  RunInParallel(
    count,
    threads,
    [](void * erased, std::size_t i) { (*static_cast<BodyType *>(erased))(i); },
    const_cast<void *>(static_cast<const void *>(std::addressof(body))));
}

/** Starts so many threads of their own, for work that lasts and waits for events; a pool's threads are for what does
 * not. Where the system gives no more, there are fewer, which is said once, through itk::OutputWindow. \return how many
 * were started, appended to threads */
DentalCommon_EXPORT std::size_t
StartThreads(std::size_t count, const std::function<void()> & work, std::vector<std::thread> & threads);
} // namespace itk

#endif

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
#ifndef itkPoseIterationMonitor_h
#define itkPoseIterationMonitor_h

#include "itkPoseRegistrationIteration.h"

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace itk
{
/** Brings the iterations of candidates that run in several threads to observers in the thread of the caller, one after
 * the other, and the caller's wish to abort to the candidates.
 *
 * Observers are thus never called in a thread that the user does not know, and yet at once: the calling thread hands on
 * what has arrived at each of its own steps and while it waits for the others. */
class PoseIterationMonitor
{
public:
  using HandlerType = std::function<void(const PoseRegistrationIteration &)>;
  using AbortType = std::function<bool()>;

  /** Both are called in the constructing thread only. */
  PoseIterationMonitor(HandlerType handler, AbortType abort);

  /** From any thread. */
  void
  Post(const PoseRegistrationIteration & iteration);

  /** From any thread; in the constructing one it asks anew. */
  bool
  IsAborted();

  /** Calls body(i) for i in [0, count) on up to so many threads (0: all of the machine's), the calling one among them;
   * what bodies post is handed on meanwhile. Returns when all have ended; the first exception is rethrown. */
  void
  ForEach(std::size_t count, unsigned int threads, const std::function<void(std::size_t)> & body);

private:
  void
  Drain();

  HandlerType                           m_Handler;
  AbortType                             m_Abort;
  std::thread::id                       m_Owner;
  std::atomic<bool>                     m_Aborted{ false };
  std::mutex                            m_Mutex;
  std::condition_variable               m_Arrived;
  std::deque<PoseRegistrationIteration> m_Queue;
};
} // namespace itk

#endif

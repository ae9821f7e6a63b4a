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
#ifndef itkJobQueue_h
#define itkJobQueue_h

#include "BatchExport.h"

#include <chrono>
#include <cstddef>
#include <functional>

namespace itk
{
/** \class JobQueue
 * \brief The schedule of everything here that takes long and comes in many: so many jobs at a time, in their order,
 * watched by the thread that asks.
 *
 * A job is whatever goes on by itself once it was begun: a process (BatchRunner), a thread (CohortExperiment). All
 * functions are called by the thread that calls Run(), so what they share needs no lock, and an observer that they
 * notify runs where it was added.
 *
 * \ingroup Batch
 */
class Batch_EXPORT JobQueue
{
public:
  /** How often it looks whether a job has ended: short against a job, long against a look. */
  static constexpr std::chrono::milliseconds PollInterval{ 10 };

  /** Begins a job. False: there was nothing to do, and it has ended. */
  std::function<bool(std::size_t)> begin;
  /** Whether a job has ended; what it has left is taken then. Called until it says so. */
  std::function<bool(std::size_t)> hasEnded;
  /** Called before every look. Stops all by an exception. */
  std::function<void()> watch;
  /** What to do with what still runs when an exception stops the queue; none runs on afterwards. */
  std::function<void()> end;

  /** Returns when all have ended. The first exception of a function ends what runs, and leaves. */
  void
  Run(std::size_t count, std::size_t atATime) const;
};
} // namespace itk

#endif

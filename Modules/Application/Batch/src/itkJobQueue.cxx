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
#include "itkJobQueue.h"

#include <algorithm>
#include <thread>
#include <vector>

namespace itk
{
void
JobQueue::Run(std::size_t count, std::size_t atATime) const
{
  std::size_t              next = 0;
  std::vector<std::size_t> running;
  try
  {
    while (next < count || !running.empty())
    {
      this->watch();
      bool waits = true;
      while (waits && next < count && running.size() < std::max<std::size_t>(1, atATime))
      {
        const std::size_t job = next++;
        if (this->begin(job))
        {
          running.push_back(job);
        }
        else
        {
          // One at a time: to find that there is nothing to do may take as long as a look at all the others.
          waits = false;
        }
      }
      for (auto job = running.begin(); job != running.end();)
      {
        job = this->hasEnded(*job) ? running.erase(job) : job + 1;
      }
      if (waits && !running.empty())
      {
        std::this_thread::sleep_for(PollInterval);
      }
    }
  }
  catch (...)
  {
    this->end();
    throw;
  }
}
} // namespace itk

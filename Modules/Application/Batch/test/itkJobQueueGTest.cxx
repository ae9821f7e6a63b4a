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

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace
{
/** Jobs that end at their second look; odd ones of them have nothing to do. */
struct Recorder
{
  std::vector<std::size_t> begun;
  std::vector<std::size_t> ended;
  std::vector<std::size_t> running;
  std::vector<int>         looks = std::vector<int>(10, 0);
  std::size_t              most{ 0 };
  std::size_t              watched{ 0 };
  std::size_t              stopped{ 0 };
  itk::JobQueue            queue;

  Recorder()
  {
    queue.watch = [this]() { ++watched; };
    queue.begin = [this](std::size_t job) {
      begun.push_back(job);
      if (job % 2 == 1)
      {
        return false;
      }
      running.push_back(job);
      most = std::max(most, running.size());
      return true;
    };
    queue.hasEnded = [this](std::size_t job) {
      EXPECT_EQ(std::count(running.begin(), running.end(), job), 1) << job;
      if (++looks[job] < 2)
      {
        return false;
      }
      running.erase(std::find(running.begin(), running.end(), job));
      ended.push_back(job);
      return true;
    };
    queue.end = [this]() { stopped += 1 + running.size(); };
  }
};
} // namespace

TEST(JobQueue, BeginsEachJobOnceInOrderAndSoManyAtATime)
{
  for (const std::size_t atATime : { 0u, 1u, 2u, 20u })
  {
    Recorder record;
    record.queue.Run(10, atATime);
    EXPECT_EQ(record.begun, (std::vector<std::size_t>{ 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 }));
    std::sort(record.ended.begin(), record.ended.end());
    EXPECT_EQ(record.ended, (std::vector<std::size_t>{ 0, 2, 4, 6, 8 }));
    EXPECT_LE(record.most, std::max<std::size_t>(1, atATime));
    EXPECT_GT(record.watched, 0u);
    EXPECT_EQ(record.stopped, 0u);
  }
  Recorder two;
  two.queue.Run(10, 2);
  EXPECT_EQ(two.most, 2u) << "as many as may";
  Recorder none;
  none.queue.Run(0, 2);
  EXPECT_TRUE(none.begun.empty());
}

TEST(JobQueue, IsWatchedBeforeEachJobThatHasNothingToDo)
{
  Recorder record;
  record.queue.begin = [&](std::size_t job) {
    record.begun.push_back(job);
    return false;
  };
  record.queue.Run(10, 4);
  EXPECT_EQ(record.begun.size(), 10u);
  EXPECT_GE(record.watched, 10u) << "an abort is heard while an earlier batch is looked through";
}

TEST(JobQueue, AnExceptionEndsWhatRunsAndLeaves)
{
  Recorder watched;
  watched.queue.watch = [&]() {
    if (++watched.watched > 1)
    {
      throw std::runtime_error("aborted");
    }
  };
  EXPECT_THROW(watched.queue.Run(10, 3), std::runtime_error);
  EXPECT_EQ(watched.stopped, 1u + watched.running.size());
  EXPECT_FALSE(watched.running.empty());
  EXPECT_LT(watched.begun.size(), 10u);

  Recorder begun;
  begun.queue.begin = [](std::size_t) -> bool { throw std::runtime_error("no process"); };
  EXPECT_THROW(begun.queue.Run(10, 3), std::runtime_error);
  EXPECT_EQ(begun.stopped, 1u);

  Recorder ended;
  ended.queue.hasEnded = [](std::size_t) -> bool { throw std::runtime_error("a full disk"); };
  EXPECT_THROW(ended.queue.Run(10, 3), std::runtime_error);
  EXPECT_EQ(ended.stopped, 1u + ended.running.size());
}

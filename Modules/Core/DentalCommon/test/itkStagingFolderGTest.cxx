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
#include "itkStagingFolder.h"

#include "itkTestFile.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include <sys/wait.h>
#include <unistd.h>

namespace
{
std::size_t
CountNamesIn(const std::string & folder)
{
  return static_cast<std::size_t>(
    std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()));
}
} // namespace

TEST(StagingFolder, GoesWithAllThatIsInIt)
{
  const std::string around = itk::TestFolder();
  std::string       path;
  {
    const itk::StagingFolder folder(around);
    const itk::StagingFolder other(around);
    path = folder.GetPath();
    EXPECT_NE(path, other.GetPath());
    EXPECT_EQ(std::filesystem::path(path).parent_path(), around);
    std::filesystem::create_directory(path + "/blocks");
    std::ofstream(path + "/blocks/file") << "half";
    EXPECT_EQ(CountNamesIn(around), 2u);
  }
  EXPECT_EQ(CountNamesIn(around), 0u);
}

TEST(StagingFolder, WhatAKilledProcessHasLeftIsRemovedByTheNext)
{
  // Each process sweeps a folder once: so the one that sweeps is a process of its own, too.
  const std::string around = itk::TestFolder();
  const auto        inAProcess = [&](const std::function<void()> & work) {
    const pid_t process = fork();
    if (process == 0)
    {
      work();
      _exit(0);
    }
    int status = 0;
    EXPECT_EQ(waitpid(process, &status, 0), process);
    return status;
  };
  const int killed = inAProcess([&] {
    const itk::StagingFolder folder(around);
    std::ofstream(folder.GetPath() + "/file") << "half";
    raise(SIGKILL);
  });
  ASSERT_TRUE(WIFSIGNALED(killed));
  ASSERT_EQ(CountNamesIn(around), 1u);
  // One that is in use stays.
  const itk::StagingFolder used(around);
  const int                swept = inAProcess([&] {
    // Not of the parent's memory of what was swept: another name of the same folder.
    const itk::StagingFolder folder(around + "/.");
    _exit(CountNamesIn(around) == 2u ? 0 : 1);
  });
  EXPECT_TRUE(WIFEXITED(swept));
  EXPECT_EQ(WEXITSTATUS(swept), 0);
  EXPECT_TRUE(std::filesystem::is_directory(used.GetPath()));
}

TEST(StagingFolder, SaysWhichFolderIsNotThere)
{
  const std::string nowhere = itk::TestFolder() + "/nowhere";
  const auto        error = itk::ExpectInputError([&] { const itk::StagingFolder folder(nowhere); });
  EXPECT_EQ(error.GetInputFile(), nowhere);
  EXPECT_TRUE(itk::Contains(error.GetProblem(), "No such file")) << error.GetProblem();
}

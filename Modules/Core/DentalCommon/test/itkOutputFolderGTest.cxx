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
#include "itkOutputFolder.h"

#include "itkTestFile.h"

#include <gtest/gtest.h>

#include <csignal>
#include <memory>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{
namespace fs = std::filesystem;

void
Stage(itk::OutputFolder & folder, const std::string & name, const std::string & content)
{
  std::ofstream(folder.GetStagingFolder() + '/' + name) << content;
}
} // namespace

TEST(OutputFolder, HasOneOwnerAtATimeAndSaysSo)
{
  const std::string name = itk::TestFolder() + "/out";
  auto              first = std::make_unique<itk::OutputFolder>(name);
  const auto        error = itk::ExpectInputError([&] { const itk::OutputFolder second(name); });
  EXPECT_TRUE(itk::Contains(error.GetProblem(), "another run is at work")) << error.GetProblem();
  EXPECT_EQ(error.GetInputFile(), name);
  // By another name it is the same folder.
  fs::create_directory_symlink("out", itk::TestFolder() + "/link");
  itk::ExpectInputError([&] { const itk::OutputFolder second(itk::TestFolder() + "/link/"); });
  first = nullptr;
  const itk::OutputFolder next(name);
}

TEST(OutputFolder, IsRemovedAgainWhereNothingWasWritten)
{
  const std::string name = itk::TestFolder() + "/a/out";
  {
    itk::OutputFolder folder(name);
    Stage(folder, "half.txt", "half");
    EXPECT_TRUE(fs::exists(name));
  }
  EXPECT_FALSE(fs::exists(name));
  fs::create_directories(name);
  {
    const itk::OutputFolder folder(name);
  }
  EXPECT_TRUE(fs::exists(name)) << "it was there before";
}

TEST(OutputFolder, PublishesAllFilesAndRemovesStaleOnes)
{
  const std::string name = itk::TestFolder() + "/out";
  fs::create_directory(name);
  for (const char * file : { "last.json", "stale.txt", "notes.txt" })
  {
    std::ofstream(name + '/' + file) << "old";
  }
  {
    itk::OutputFolder folder(name);
    Stage(folder, "first.txt", "new");
    Stage(folder, "last.json", "new");
    EXPECT_EQ(itk::ReadTestFile(name + "/last.json"), "old");
    folder.Publish("last.json", { "first.txt", "stale.txt", "last.json" });
  }
  EXPECT_EQ(itk::ReadTestFile(name + "/first.txt"), "new");
  EXPECT_EQ(itk::ReadTestFile(name + "/last.json"), "new");
  EXPECT_EQ(itk::ReadTestFile(name + "/notes.txt"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(name), fs::directory_iterator()), 3);
}

TEST(OutputFolder, ReplacesNothingThatIsNoFile)
{
  const std::string name = itk::TestFolder() + "/out";
  fs::create_directory(name);
  std::ofstream(name + "/last.json") << "old";
  ASSERT_EQ(mkfifo((name + "/first.txt").c_str(), 0600), 0);
  itk::OutputFolder folder(name);
  Stage(folder, "first.txt", "new");
  Stage(folder, "last.json", "new");
  const auto error = itk::ExpectInputError([&] { folder.Publish("last.json"); });
  EXPECT_TRUE(itk::Contains(error.GetProblem(), "first.txt")) << error.GetProblem();
  EXPECT_TRUE(fs::is_fifo(name + "/first.txt"));
  EXPECT_EQ(itk::ReadTestFile(name + "/last.json"), "old") << "what was complete stays complete";
}

TEST(OutputFolder, SweepsWhatAKilledOwnerHasLeftAndIsFree)
{
  const std::string name = itk::TestFolder() + "/out";
  const pid_t       process = fork();
  if (process == 0)
  {
    itk::OutputFolder folder(name);
    Stage(folder, "half.txt", "half");
    raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(waitpid(process, &status, 0), process);
  ASSERT_TRUE(WIFSIGNALED(status));
  ASSERT_EQ(std::distance(fs::directory_iterator(name), fs::directory_iterator()), 1);
  itk::OutputFolder folder(name);
  EXPECT_EQ(std::distance(fs::directory_iterator(name), fs::directory_iterator()), 0);
}

TEST(OutputFolder, TakesTheLongestNameThatThereIs)
{
  const std::string name = itk::TestFolder() + '/' + std::string(255, 'n');
  itk::OutputFolder folder(name + '/');
  Stage(folder, "last.json", "new");
  folder.Publish("last.json");
  EXPECT_EQ(itk::ReadTestFile(name + "/last.json"), "new");
}

TEST(OutputFolder, AFileAndAnEmptyNameAreErrors)
{
  const std::string file = itk::WriteTestFile("file.txt", "text");
  EXPECT_TRUE(
    itk::Contains(itk::ExpectInputError([&] { const itk::OutputFolder folder(file); }).GetProblem(), "it is a file"));
  itk::ExpectInputError([] { const itk::OutputFolder folder(""); });
  EXPECT_EQ(itk::ReadTestFile(file), "text");
}

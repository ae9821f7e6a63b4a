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
#include <stdexcept>

#include <fcntl.h>
#include <sys/file.h>
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

TEST(OutputFolder, IsWaitedForAsLongAsIsAskedFor)
{
  const std::string name = itk::TestFolder() + "/out";
  auto              first = std::make_unique<itk::OutputFolder>(name);
  int               calls = 0;
  const auto        error =
    itk::ExpectInputError([&] { const itk::OutputFolder second(name, {}, [&] { return ++calls < 3; }); });
  EXPECT_TRUE(itk::Contains(error.GetProblem(), "another run is at work")) << error.GetProblem();
  EXPECT_EQ(calls, 3);
  EXPECT_THROW(const itk::OutputFolder second(name, {}, []() -> bool { throw std::runtime_error("enough"); }),
               std::runtime_error);
  // Its last owner removes the folder that it had made: who waits makes it anew.
  const itk::OutputFolder second(name, {}, [&] {
    first = nullptr;
    return true;
  });
  EXPECT_EQ(first, nullptr);
  EXPECT_TRUE(fs::is_directory(name));
  itk::ExpectInputError([&] { const itk::OutputFolder third(name); });
}

TEST(OutputFolder, IsLockedByAFileWhereOtherMachinesSeeNoLockOfAFolder)
{
  const std::string name = itk::TestFolder() + "/out";
  const std::string file = name + "/.batch/lock";
  {
    const itk::OutputFolder folder(name, ".batch/lock");
    // NFS locks for one owner alone what is open for writing.
    bool isFound = false;
    for (const auto & entry : fs::directory_iterator("/proc/self/fd"))
    {
      std::error_code error;
      if (fs::read_symlink(entry.path(), error) == file)
      {
        isFound = true;
        EXPECT_EQ(::fcntl(std::stoi(entry.path().filename().string()), F_GETFL) & O_ACCMODE, O_RDWR);
      }
    }
    EXPECT_TRUE(isFound);
  }
  EXPECT_TRUE(fs::exists(file)) << "it stays: a file that comes and goes is another one on another machine";
  // A machine that doesn't see the folder's own lock.
  const int other = ::open(file.c_str(), O_RDWR);
  ASSERT_EQ(::flock(other, LOCK_EX | LOCK_NB), 0);
  const std::string part = name + "/.dentalscr-1.part";
  std::ofstream(part) << "half";
  const auto error = itk::ExpectInputError([&] { const itk::OutputFolder folder(name, ".batch/lock"); });
  EXPECT_TRUE(itk::Contains(error.GetProblem(), "another run is at work")) << error.GetProblem();
  EXPECT_TRUE(fs::exists(part)) << "the other machine's";
  const itk::OutputFolder folder(name, ".batch/lock", [&] {
    ::flock(other, LOCK_UN);
    return true;
  });
  EXPECT_FALSE(fs::exists(part));
  ::close(other);
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

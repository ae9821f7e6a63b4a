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
#include "itkTextFile.h"

#include "itkTestFile.h"

#include <gtest/gtest.h>

#include <csignal>
#include <sys/resource.h>

namespace
{
std::size_t
CountFiles(const std::string & folder)
{
  std::size_t count = 0;
  for (const auto & entry : std::filesystem::directory_iterator(folder))
  {
    static_cast<void>(entry);
    ++count;
  }
  return count;
}
} // namespace

TEST(TextFile, ReadsBackWhatWasWritten)
{
  const std::string path = itk::TestFolder() + "/file.txt";
  const std::string content("a\r\n\0b\n", 6);
  itk::WriteFileAtomically(path, content);
  EXPECT_EQ(itk::ReadTextFile(path, "text"), content);
}

TEST(TextFile, ReplacesAFileAndLeavesNoTemporary)
{
  const std::string path = itk::WriteTestFile("file.txt", "a long text that was there before");
  itk::WriteFileAtomically(path, "new");
  EXPECT_EQ(itk::ReadTestFile(path), "new");
  EXPECT_EQ(CountFiles(itk::TestFolder()), 1u);
}

TEST(TextFile, IsNotStoppedByAnotherWritersTemporary)
{
  const std::string other = itk::WriteTestFile("file.txt.tmp0", "of another process");
  const std::string path = itk::TestFolder() + "/file.txt";
  itk::WriteFileAtomically(path, "mine");
  EXPECT_EQ(itk::ReadTestFile(path), "mine");
  EXPECT_EQ(itk::ReadTestFile(other), "of another process");
}

TEST(TextFile, WritingFailsNamingTheFile)
{
  const std::string folder = itk::TestFolder();
  for (const std::string & path : { folder, folder + "/missing/file.txt" })
  {
    const auto error = itk::ExpectInputError([&] { itk::WriteFileAtomically(path, "text"); });
    EXPECT_EQ(error.GetInputFile(), path);
    EXPECT_FALSE(error.GetRemedy().empty());
  }
  itk::ExpectInputError([] { itk::WriteFileAtomically("", "text"); });
  EXPECT_EQ(CountFiles(folder), 0u);
}

TEST(TextFile, WritesThroughNoLinkThatStandsInItsWay)
{
  const std::string victim = itk::WriteTestFile("victim.txt", "untouched");
  const std::string path = itk::TestFolder() + "/file.txt";
  std::error_code   ignored;
  std::filesystem::create_symlink(victim, path + ".tmp0", ignored);
  itk::WriteFileAtomically(path, "new");
  EXPECT_EQ(itk::ReadTestFile(path), "new");
  EXPECT_EQ(itk::ReadTestFile(victim), "untouched");
}

TEST(TextFile, AFileThatCannotBeFinishedLeavesTheOldOne)
{
  const std::string path = itk::WriteTestFile("file.txt", "old");
  // A limit on the length of files stands in for a full disk.
  const auto    previousHandler = std::signal(SIGXFSZ, SIG_IGN);
  struct rlimit limit = {};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
  struct rlimit small = limit;
  small.rlim_cur = 1000;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  bool        thrown = false;
  std::string problem;
  try
  {
    itk::WriteFileAtomically(path, std::string(100000, 'x'));
  }
  catch (const itk::DentalInputError & error)
  {
    thrown = true;
    problem = error.GetProblem();
  }
  setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, previousHandler);
  EXPECT_TRUE(thrown);
  EXPECT_TRUE(itk::Contains(problem, "cannot be written")) << problem;
  EXPECT_EQ(itk::ReadTestFile(path), "old");
  EXPECT_EQ(CountFiles(itk::TestFolder()), 1u);
}

TEST(TextFile, ReadingFailsInWordsForTheUser)
{
  const std::string folder = itk::TestFolder();
  EXPECT_TRUE(itk::Contains(
    itk::ExpectInputError([&] { itk::ReadTextFile(folder + "/none.txt", "text"); }).GetProblem(), "no such file"));
  EXPECT_TRUE(
    itk::Contains(itk::ExpectInputError([&] { itk::ReadTextFile(folder, "text"); }).GetProblem(), "directory"));
  const std::string empty = itk::WriteTestFile("empty.txt", "");
  EXPECT_TRUE(itk::Contains(itk::ExpectInputError([&] { itk::ReadTextFile(empty, "text"); }).GetProblem(), "empty"));
  const std::string longFile = itk::WriteTestFile("long.txt", std::string(1001, 'x'));
  EXPECT_TRUE(
    itk::Contains(itk::ExpectInputError([&] { itk::ReadTextFile(longFile, "text", 1000); }).GetProblem(), "1000"));
  EXPECT_EQ(itk::ReadTextFile(longFile, "text", 1001).size(), 1001u);
}

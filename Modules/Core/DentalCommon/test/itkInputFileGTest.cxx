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
#include "itkInputFile.h"
#include "itkMemoryFile.h"
#include "itkVerifyScanSize.h"

#include "itkTestFile.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include <sys/stat.h>
#include <unistd.h>

using Problem = itk::InputFile::ProblemEnum;

TEST(InputFile, OpensNothingButRegularFilesAndNeverWaits)
{
  const std::string pipe = itk::TestFolder() + "/pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(itk::InputFile(pipe).GetProblem(), Problem::NotRegular);
  EXPECT_EQ(itk::InputFile("/dev/zero").GetProblem(), Problem::NotRegular);
  EXPECT_EQ(itk::InputFile(itk::TestFolder()).GetProblem(), Problem::Folder);
  EXPECT_EQ(itk::InputFile(itk::TestFolder() + "/none").GetProblem(), Problem::Missing);
  EXPECT_EQ(itk::InputFile(itk::WriteTestFile("empty", "")).GetProblem(), Problem::Empty);
  // Of no length, though there is something to be read.
  EXPECT_EQ(itk::InputFile("/proc/self/status").GetProblem(), Problem::Empty);
  EXPECT_EQ(itk::ReadFileHead(pipe, 10), "");
}

namespace
{
/** What ReadWhole() throws. */
itk::InputFileError
ErrorOf(const std::string & path, std::size_t maximumSize = 100)
{
  try
  {
    itk::InputFile file(path);
    itk::ReadWhole(file, "a scan", maximumSize);
  }
  catch (const itk::InputFileError & error)
  {
    return error;
  }
  ADD_FAILURE() << "no InputFileError for " << path;
  return itk::InputFileError("none", "none");
}
} // namespace

TEST(InputFile, SaysWhyNothingIsRead)
{
  const std::string pipe = itk::TestFolder() + "/pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string whole = itk::WriteTestFile("whole", "0123456789");
  const std::string ring = itk::TestFolder() + "/ring";
  ASSERT_EQ(symlink("ring", ring.c_str()), 0);
  for (const auto & [path, words] :
       { std::pair<std::string, std::string>{ pipe, "this is not a regular file but a pipe" },
         { ring, "it is a link that leads back to itself" },
         { itk::TestFolder(), "this is a directory, not a scan" },
         { itk::TestFolder() + "/none", "there is no such file" },
         { whole + "/none", "there is no such file" },
         { itk::WriteTestFile("empty", ""), "the file is empty (0 bytes)" },
         { itk::TestFolder() + '/' + std::string(300, 'x'), "it cannot be opened (system error 36)" } })
  {
    const itk::InputFileError error = ErrorOf(path);
    EXPECT_TRUE(itk::Contains(error.what(), words)) << error.what();
    EXPECT_FALSE(error.GetRemedy().empty()) << path;
  }
  EXPECT_TRUE(itk::Contains(ErrorOf(whole, 9).what(), "longer than 9 bytes, too long for a scan"));
  itk::InputFile file(whole);
  EXPECT_FALSE(itk::DescribeProblem(file, "a scan"));
  EXPECT_EQ(itk::ReadWhole(file, "a scan", 10), "0123456789");
}

TEST(InputFile, IsReadWholeOrIsAnError)
{
  const std::string path = itk::WriteTestFile("file", "0123456789");
  itk::InputFile    cut(path);
  ASSERT_EQ(truncate(path.c_str(), 5), 0);
  itk::InputFile longer(path);
  ASSERT_EQ(truncate(path.c_str(), 8), 0);
  for (itk::InputFile * file : { &cut, &longer })
  {
    try
    {
      itk::ReadWhole(*file, "a scan", 100);
      FAIL();
    }
    catch (const itk::InputFileError & error)
    {
      EXPECT_TRUE(itk::Contains(error.what(), "was changed while it was read")) << error.what();
    }
  }
}

TEST(InputFile, ReadsItsBytesAndNoMore)
{
  const std::string path = itk::WriteTestFile("file", "0123456789");
  itk::InputFile    file(path);
  ASSERT_EQ(file.GetProblem(), Problem::None);
  EXPECT_EQ(file.GetSize(), 10u);
  char bytes[20] = {};
  EXPECT_EQ(file.Read(bytes, 4), 4u);
  EXPECT_EQ(file.Read(bytes + 4, 16), 6u);
  EXPECT_EQ(std::string(bytes), "0123456789");
  EXPECT_FALSE(file.HasChanged());
  EXPECT_EQ(itk::ReadFileHead(path, 4), "0123");
  EXPECT_EQ(itk::ReadFileHead(path, 100), "0123456789");
}

TEST(InputFile, NoticesThatAFileIsCutShortOrWrittenOver)
{
  const std::string path = itk::WriteTestFile("file", "0123456789");
  itk::InputFile    file(path);
  ASSERT_EQ(truncate(path.c_str(), 5), 0);
  char bytes[20] = {};
  EXPECT_EQ(file.Read(bytes, 10), 5u);
  EXPECT_EQ(file.GetSystemError(), 0);
  EXPECT_TRUE(file.HasChanged());
}

TEST(VerifyScanSize, HasABoundThatCanBeMoved)
{
  const char * const variable = "DENTALSCR_LARGEST_SCAN_MIB";
  ::unsetenv(variable);
  // Holes take no space on the disk.
  const std::string path = itk::WriteTestFile("large", "solid");
  const auto        verify = [&](off_t size) {
    ASSERT_EQ(::truncate(path.c_str(), size), 0);
    itk::VerifyScanSize(itk::InputFile(path));
  };
  constexpr off_t gibibyte = off_t{ 1 } << 30;
  EXPECT_NO_THROW(verify(gibibyte));
  EXPECT_THROW(verify(gibibyte + 1), itk::InputFileError);
  ::setenv(variable, "1025", 1);
  EXPECT_NO_THROW(verify(gibibyte + 1));
  ::setenv(variable, "2", 1);
  EXPECT_NO_THROW(verify(2 << 20));
  try
  {
    verify((2 << 20) + 1);
    ADD_FAILURE() << "was not refused";
  }
  catch (const itk::InputFileError & error)
  {
    EXPECT_STREQ(error.what(), "has 2097153 bytes, more than the 2 MiB that a scan may have");
    EXPECT_NE(error.GetRemedy().find(variable), std::string::npos) << error.GetRemedy();
  }
  for (const char * const wrong : { "", "many", "-1", "1e3", "9999999" })
  {
    ::setenv(variable, wrong, 1);
    EXPECT_THROW(verify(1), itk::InputFileError) << wrong;
  }
  ::unsetenv(variable);
}

TEST(MemoryFile, IsReadByItsNameAgainAndAgain)
{
  itk::MemoryFile file;
  for (const std::string content : { "content", "less", "" })
  {
    file.SetContent(content);
    EXPECT_EQ(itk::ReadTestFile(file.GetName()), content);
    EXPECT_EQ(itk::ReadTestFile(file.GetName()), content);
    EXPECT_EQ(file.GetContent(), content);
  }
}

TEST(MemoryFile, HoldsWhatIsWrittenToItsName)
{
  for (const char * extension : { "", ".mha" })
  {
    std::string name;
    {
      const itk::MemoryFile file(extension);
      name = file.GetName();
      std::ofstream(name, std::ios::binary) << "content";
      EXPECT_EQ(file.GetContent(), "content");
      // Again, as writers do that put a header before what they have written.
      std::ofstream(name, std::ios::binary) << "less";
      EXPECT_EQ(file.GetContent(), "less");
      EXPECT_EQ(std::filesystem::path(name).extension(), extension);
    }
    EXPECT_FALSE(std::filesystem::exists(name));
  }
}

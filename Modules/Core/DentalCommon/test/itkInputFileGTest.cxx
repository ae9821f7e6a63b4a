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

#include "itkTestFile.h"

#include <gtest/gtest.h>

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

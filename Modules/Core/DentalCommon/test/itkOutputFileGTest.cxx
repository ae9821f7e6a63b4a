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
#include "itkOutputFile.h"

#include "itkTestFile.h"

#include <gtest/gtest.h>

#include <csignal>
#include <thread>
#include <vector>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{
void
WriteThrough(const std::string & path, const std::string & content)
{
  itk::OutputFile file(path);
  file.Write(content.data(), content.size());
  file.Commit();
}

std::vector<std::string>
NamesIn(const std::string & folder)
{
  std::vector<std::string> names;
  for (const auto & entry : std::filesystem::directory_iterator(folder))
  {
    names.push_back(entry.path().filename().string());
  }
  return names;
}

/** Begins a file in a process of its own and kills it, as the system does when memory runs out. */
void
WriteAndBeKilled(const std::string & path)
{
  const pid_t process = fork();
  if (process == 0)
  {
    itk::OutputFile file(path);
    file.Write("half", 4);
    raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(waitpid(process, &status, 0), process);
  ASSERT_TRUE(WIFSIGNALED(status));
}
} // namespace

TEST(OutputFile, WithoutACommitWhatWasThereIsUntouched)
{
  const std::string path = itk::WriteTestFile("file.txt", "old");
  {
    itk::OutputFile file(path);
    file.Write("new", 3);
    EXPECT_EQ(itk::ReadTestFile(path), "old");
    EXPECT_EQ(NamesIn(itk::TestFolder()).size(), 2u);
  }
  EXPECT_EQ(itk::ReadTestFile(path), "old");
  EXPECT_EQ(NamesIn(itk::TestFolder()), std::vector<std::string>{ "file.txt" });
}

TEST(OutputFile, TakesTheLongestNameThatThereIs)
{
  const std::string path = itk::TestFolder() + '/' + std::string(255, 'n');
  WriteThrough(path, "text");
  EXPECT_EQ(itk::ReadTestFile(path), "text");
}

TEST(OutputFile, ADeviceAndAPipeAreWrittenToAndStay)
{
  WriteThrough("/dev/null", "text");
  struct stat status = {};
  ASSERT_EQ(stat("/dev/null", &status), 0);
  EXPECT_TRUE(S_ISCHR(status.st_mode));

  const std::string pipe = itk::TestFolder() + "/pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::string read;
  std::thread reader([&] { read = itk::ReadTestFile(pipe); });
  WriteThrough(pipe, "through it");
  reader.join();
  EXPECT_EQ(read, "through it");
  ASSERT_EQ(stat(pipe.c_str(), &status), 0);
  EXPECT_TRUE(S_ISFIFO(status.st_mode));
}

TEST(OutputFile, AFullDeviceIsAnErrorInWords)
{
  const auto error = itk::ExpectInputError([] { WriteThrough("/dev/full", "text"); });
  EXPECT_EQ(error.GetInputFile(), "/dev/full");
  EXPECT_TRUE(itk::Contains(error.GetProblem(), "No space left")) << error.GetProblem();
  EXPECT_TRUE(itk::Contains(error.GetRemedy(), "space")) << error.GetRemedy();
}

TEST(OutputFile, NeitherAFolderNorASocketIsReplaced)
{
  const std::string folder = itk::TestFolder() + "/folder";
  std::filesystem::create_directory(folder);
  EXPECT_TRUE(itk::Contains(itk::ExpectInputError([&] { WriteThrough(folder, "x"); }).GetProblem(), "directory"));
  // Of a relative name: the one of a socket has 107 letters at most.
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(itk::TestFolder());
  const int   socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  std::string("socket").copy(address.sun_path, sizeof(address.sun_path) - 1);
  ASSERT_EQ(bind(socket, reinterpret_cast<sockaddr *>(&address), sizeof(address)), 0);
  EXPECT_TRUE(itk::Contains(itk::ExpectInputError([&] { WriteThrough("socket", "x"); }).GetProblem(), "socket"));
  EXPECT_TRUE(std::filesystem::is_socket("socket"));
  close(socket);
  std::filesystem::current_path(before);
}

TEST(OutputFile, WhatAKilledProcessHasLeftIsRemovedByTheNext)
{
  // The first file of this process in the folder: it looks for leftovers once.
  const std::string folder = itk::TestFolder();
  WriteAndBeKilled(folder + "/killed.txt");
  ASSERT_EQ(NamesIn(folder).size(), 1u);
  WriteThrough(folder + "/file.txt", "whole");
  EXPECT_EQ(NamesIn(folder), std::vector<std::string>{ "file.txt" });
}

TEST(OutputFile, WhatAnotherProcessIsWritingIsNotRemoved)
{
  const std::string folder = itk::TestFolder();
  int               ready[2];
  int               go[2];
  ASSERT_EQ(pipe(ready), 0);
  ASSERT_EQ(pipe(go), 0);
  const pid_t process = fork();
  if (process == 0)
  {
    itk::OutputFile file(folder + "/theirs.txt");
    file.Write("theirs", 6);
    char byte = 0;
    if (write(ready[1], &byte, 1) != 1 || read(go[0], &byte, 1) != 1)
    {
      _exit(1);
    }
    file.Commit();
    _exit(0);
  }
  char byte = 0;
  ASSERT_EQ(read(ready[0], &byte, 1), 1);
  WriteThrough(folder + "/ours.txt", "ours");
  ASSERT_EQ(write(go[1], &byte, 1), 1);
  int status = 1;
  ASSERT_EQ(waitpid(process, &status, 0), process);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(itk::ReadTestFile(folder + "/theirs.txt"), "theirs");
  EXPECT_EQ(itk::ReadTestFile(folder + "/ours.txt"), "ours");
}

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
// The process that decodes an image, seen from the one that has started it.
#include "itkCephalogramFileReader.h"

#include "itkTestFile.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <sys/resource.h>
#include <unistd.h>

namespace
{
namespace fs = std::filesystem;

constexpr unsigned int Width = 20;
constexpr unsigned int Height = 12;

/** A NRRD of so many pixels a row, as text, which takes its decoder the longest of all that it reads. */
std::string
WriteText(unsigned int width, unsigned int height)
{
  std::string content = "NRRD0004\ntype: uint8\ndimension: 2\nsizes: " + std::to_string(width) + ' ' +
                        std::to_string(height) + "\nencoding: ascii\n\n";
  content.reserve(content.size() + std::size_t{ 4 } * width * height);
  for (unsigned int i = 0; i < width * height; ++i)
  {
    content += std::to_string(i % 251) + '\n';
  }
  return itk::WriteTestFile("text.nrrd", content);
}

itk::CephalogramFileReader::Pointer
MakeReader(const std::string & fileName)
{
  const auto reader = itk::CephalogramFileReader::New();
  reader->SetFileName(fileName);
  return reader;
}

/** Those that this process has started and that run. */
std::vector<::pid_t>
FindDecoders()
{
  std::vector<::pid_t> found;
  for (const auto & entry : fs::directory_iterator("/proc"))
  {
    std::ifstream file(entry.path() / "stat");
    std::string   text;
    std::getline(file, text);
    // "pid (name of at most 15 letters) state parent ..."
    const std::size_t close = text.rfind(')');
    if (close != std::string::npos && itk::Contains(text, "(dentalscr-decod") &&
        std::stoi(text.substr(close + 4)) == ::getpid() && text[close + 2] != 'Z')
    {
      found.push_back(std::stoi(text));
    }
  }
  return found;
}
} // namespace

TEST(DecoderProcess, OutlivesTheThreadThatHasStartedIt)
{
  const auto  reader = MakeReader(WriteText(Width, Height));
  std::thread thread([&reader] { reader->UpdateOutputInformation(); });
  thread.join();
  ASSERT_EQ(FindDecoders().size(), 1u) << "it waits for the pixels to be asked for";
  ASSERT_NO_THROW(reader->Update());
  EXPECT_EQ(reader->GetOutput()->GetPixel({ { 3, 2 } }), 43.0f);
  EXPECT_TRUE(FindDecoders().empty());
}

TEST(DecoderProcess, SaysThatItTakesTooLong)
{
  const auto reader = MakeReader(WriteText(5000, 4000));
  // As a host may have it.
  const auto before = std::signal(SIGXCPU, SIG_IGN);
  ::sigset_t blocked;
  ::sigset_t mask;
  ::sigemptyset(&blocked);
  ::sigaddset(&blocked, SIGXCPU);
  ::pthread_sigmask(SIG_BLOCK, &blocked, &mask);
  reader->UpdateOutputInformation();
  ::pthread_sigmask(SIG_SETMASK, &mask, nullptr);
  std::signal(SIGXCPU, before);

  const auto decoders = FindDecoders();
  ASSERT_EQ(decoders.size(), 1u);
  ::rlimit limit{};
  ASSERT_EQ(::prlimit(decoders[0], RLIMIT_CPU, nullptr, &limit), 0);
  EXPECT_EQ(limit.rlim_cur, 10u);
  EXPECT_GT(limit.rlim_max, limit.rlim_cur) << "SIGKILL, which says nothing, would come before SIGXCPU";
  // Nobody waits for ten seconds here: it has used less than one, and what it is about to do takes longer.
  limit.rlim_cur = 1;
  ASSERT_EQ(::prlimit(decoders[0], RLIMIT_CPU, &limit, nullptr), 0);
  const auto error = itk::ExpectInputError([&] { reader->Update(); });
  EXPECT_TRUE(itk::Contains(error.GetProblem(), "decoding it takes more than 10 seconds")) << error.GetProblem();
}

TEST(DecoderProcess, KeepsALowerLimitOfItsHost)
{
  const std::string  file = WriteText(Width, Height);
  constexpr ::rlim_t low = 24;
  ::rlimit           before{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
  for (const ::rlim_t own : { before.rlim_cur, low })
  {
    const ::rlimit host{ own, before.rlim_max };
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &host), 0);
    const auto reader = MakeReader(file);
    reader->UpdateOutputInformation();
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
    const auto decoders = FindDecoders();
    ASSERT_EQ(decoders.size(), 1u);
    ::rlimit limit{};
    ASSERT_EQ(::prlimit(decoders[0], RLIMIT_NOFILE, nullptr, &limit), 0);
    EXPECT_EQ(limit.rlim_cur, own == low ? low : 32u);
  }
}

TEST(DecoderProcess, DiesAloneAndIsToldByItsSignal)
{
  const auto reader = MakeReader(WriteText(Width, Height));
  reader->UpdateOutputInformation();
  const auto decoders = FindDecoders();
  ASSERT_EQ(decoders.size(), 1u);
  ASSERT_EQ(::kill(decoders[0], SIGSEGV), 0);
  const auto error = itk::ExpectInputError([&] { reader->Update(); });
  EXPECT_TRUE(itk::Contains(error.GetProblem(), "was ended by signal 11")) << error.GetProblem();
  EXPECT_TRUE(FindDecoders().empty());
}

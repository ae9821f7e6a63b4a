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
#ifndef itkTestFile_h
#define itkTestFile_h

#include "itkDentalInputError.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace itk
{
/** A folder of its own for each test, as tests run in parallel; empty when the test starts. */
inline std::string
TestFolder()
{
  static const void * current = nullptr;
  const auto * const  info = ::testing::UnitTest::GetInstance()->current_test_info();
  const std::string   folder =
    std::string(DENTALSCR_TEST_OUTPUT_DIR) + '/' + info->test_suite_name() + '.' + info->name();
  if (current != info)
  {
    std::filesystem::remove_all(folder);
    current = info;
  }
  std::filesystem::create_directories(folder);
  return folder;
}

inline std::string
WriteTestFile(const std::string & name, const std::string & content)
{
  const std::string path = TestFolder() + '/' + name;
  // A file that is truncated is flushed to the disk by some file systems, a new one is not.
  std::filesystem::remove(path);
  std::ofstream(path, std::ios::binary) << content;
  return path;
}

inline std::string
ReadTestFile(const std::string & path)
{
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

/** Runs what has to throw a DentalInputError and returns it. */
template <typename TFunction>
DentalInputError
ExpectInputError(const TFunction & function)
{
  try
  {
    function();
  }
  catch (const DentalInputError & error)
  {
    return error;
  }
  ADD_FAILURE() << "no DentalInputError";
  return DentalInputError("", 0, "none", "none", "none");
}

inline bool
Contains(const std::string & text, const std::string & part)
{
  return text.find(part) != std::string::npos;
}
} // namespace itk

#endif

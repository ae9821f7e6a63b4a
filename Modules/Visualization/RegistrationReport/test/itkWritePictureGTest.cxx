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
#include "itkWritePicture.h"

#include "itkDentalInputError.h"
#include "itkImageFileReader.h"
#include "itkPNGImageIO.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <sys/resource.h>

namespace
{
using PictureType = itk::Image<itk::RGBPixel<unsigned char>, 2>;

PictureType::Pointer
MakePicture(unsigned char red)
{
  auto                    picture = PictureType::New();
  PictureType::RegionType region;
  region.SetSize(0, 5);
  region.SetSize(1, 3);
  picture->SetRegions(region);
  picture->Allocate();
  PictureType::PixelType pixel;
  for (int v = 0; v < 3; ++v)
  {
    for (int u = 0; u < 5; ++u)
    {
      pixel.Set(red, static_cast<unsigned char>(10 * u), static_cast<unsigned char>(20 * v));
      picture->SetPixel({ { u, v } }, pixel);
    }
  }
  return picture;
}

/** An empty folder of its own. */
std::filesystem::path
MakeFolder(const std::string & name)
{
  const std::filesystem::path folder = std::filesystem::path(DENTALSCR_TEST_OUTPUT_DIR) / "WritePicture" / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

std::size_t
CountFiles(const std::filesystem::path & folder)
{
  std::size_t count = 0;
  for (const auto & entry : std::filesystem::directory_iterator(folder))
  {
    static_cast<void>(entry);
    ++count;
  }
  return count;
}

PictureType::Pointer
Read(const std::filesystem::path & file)
{
  auto reader = itk::ImageFileReader<PictureType>::New();
  reader->SetImageIO(itk::PNGImageIO::New());
  reader->SetFileName(file.string());
  reader->Update();
  return reader->GetOutput();
}
} // namespace

TEST(WritePicture, ReadsBackAsWrittenAndLeavesNothingElse)
{
  const auto folder = MakeFolder("RoundTrip");
  const auto file = folder / "overlay.png";
  for (const unsigned char red : { 200, 77 })
  {
    // The second time over the first.
    const auto picture = MakePicture(red);
    itk::WritePicture(picture, file.string());
    const auto back = Read(file);
    ASSERT_EQ(back->GetLargestPossibleRegion(), picture->GetLargestPossibleRegion());
    for (int v = 0; v < 3; ++v)
    {
      for (int u = 0; u < 5; ++u)
      {
        EXPECT_EQ(back->GetPixel({ { u, v } }), picture->GetPixel({ { u, v } }));
      }
    }
    EXPECT_EQ(CountFiles(folder), 1u);
  }
}

TEST(WritePicture, FailsWithTheFilesNameAndLeavesNothing)
{
  const auto folder = MakeFolder("Failure");
  // A folder stands where the file should go: writing works, renaming does not.
  const auto taken = folder / "taken.png";
  std::filesystem::create_directories(taken / "inside");
  for (const std::string & name : { (folder / "missing" / "overlay.png").string(), taken.string() })
  {
    try
    {
      itk::WritePicture(MakePicture(1), name);
      FAIL() << name << " was written";
    }
    catch (const itk::ExceptionObject & error)
    {
      EXPECT_NE(std::string(error.GetDescription()).find(name), std::string::npos) << error.GetDescription();
    }
  }
  EXPECT_EQ(CountFiles(folder), 1u);
}

TEST(WritePicture, FailureKeepsTheFormerFile)
{
  const auto folder = MakeFolder("Former");
  const auto file = folder / "overlay.png";
  itk::WritePicture(MakePicture(9), file.string());
  EXPECT_THROW(itk::WritePicture(nullptr, file.string()), itk::ExceptionObject);
  auto empty = PictureType::New();
  EXPECT_THROW(itk::WritePicture(empty, file.string()), itk::ExceptionObject);
  EXPECT_EQ(Read(file)->GetPixel({ { 0, 0 } })[0], 9);
  EXPECT_EQ(CountFiles(folder), 1u);
}

TEST(WritePicture, RefusesAnEmptyName)
{
  EXPECT_THROW(itk::WritePicture(MakePicture(1), ""), itk::ExceptionObject);
}

TEST(WritePicture, IsRefusedWhereFilesMayNotBeAsLarge)
{
  const auto folder = MakeFolder("Limit");
  const auto file = folder / "overlay.png";
  itk::WritePicture(MakePicture(9), file.string());
  // No handler of SIGXFSZ: nobody asks a user of the library for one, and libpng must not come to the limit at all.
  ::rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  ::rlimit small = before;
  small.rlim_cur = 100;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  std::string said;
  try
  {
    itk::WritePicture(MakePicture(1), file.string());
  }
  catch (const itk::DentalInputError & error)
  {
    said = error.GetDescription();
  }
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  EXPECT_NE(said.find(file.string()), std::string::npos) << said;
  EXPECT_NE(said.find("ulimit -f"), std::string::npos) << said;
  EXPECT_EQ(Read(file)->GetPixel({ { 0, 0 } })[0], 9);
  EXPECT_EQ(CountFiles(folder), 1u);
}

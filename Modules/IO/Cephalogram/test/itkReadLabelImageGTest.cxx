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
#include "itkReadLabelImage.h"

#include "itkCephalogramFileReader.h"

#include "itkTestFile.h"

#include <gtest/gtest.h>

#include <cstdint>

using itk::Contains;

namespace
{
void
Append(std::string & bytes, std::uint64_t value, unsigned int count)
{
  for (unsigned int i = 0; i < count; ++i)
  {
    bytes += static_cast<char>((value >> (8 * i)) & 255u);
  }
}

/** A TIFF of 3 x 2 whole numbers 0 .. 5 times ten, less one in the first pixel where asked. */
std::string
IntegerTIFF(unsigned int bits, bool isSigned, bool negative = false)
{
  std::string pixels;
  for (int i = 0; i < 6; ++i)
  {
    Append(pixels, static_cast<std::uint64_t>(std::int64_t{ 10 } * i - (negative && i == 0 ? 1 : 0)), bits / 8);
  }
  std::string file("II*\0", 4);
  Append(file, 8 + pixels.size(), 4);
  file += pixels;
  const std::uint64_t tags[][3] = { { 256, 3, 3 },
                                    { 257, 3, 2 },
                                    { 258, 3, bits },
                                    { 259, 3, 1 },
                                    { 262, 3, 1 },
                                    { 273, 4, 8 },
                                    { 277, 3, 1 },
                                    { 278, 3, 2 },
                                    { 279, 4, pixels.size() },
                                    { 339, 3, isSigned ? 2u : 1u } };
  Append(file, std::size(tags), 2);
  for (const auto & tag : tags)
  {
    Append(file, tag[0], 2);
    Append(file, tag[1], 2);
    Append(file, 1, 4);
    Append(file, tag[2], 4);
  }
  Append(file, 0, 4);
  return file;
}
} // namespace

TEST(ReadLabelImage, WholeNumbersOfEveryWidthInTIFF)
{
  for (const unsigned int bits : { 8u, 16u, 32u })
  {
    for (const bool isSigned : { false, true })
    {
      const auto image = itk::ReadLabelImage(itk::WriteTestFile("l.tif", IntegerTIFF(bits, isSigned)));
      const auto size = image->GetLargestPossibleRegion().GetSize();
      ASSERT_EQ(size[0], 3u) << bits;
      ASSERT_EQ(size[1], 2u) << bits;
      for (unsigned int i = 0; i < 6; ++i)
      {
        EXPECT_EQ(image->GetBufferPointer()[i], 10u * i) << bits << " bits, pixel " << i;
      }
    }
  }
  const std::string negative = itk::WriteTestFile("n.tif", IntegerTIFF(32, true, true));
  EXPECT_TRUE(Contains(itk::ExpectInputError([&] { itk::ReadLabelImage(negative); }).GetProblem(), "value -1"));
}

TEST(ReadLabelImage, ARadiographOfWholeNumbersIsNotBlack)
{
  const auto reader = itk::CephalogramFileReader::New();
  reader->SetFileName(itk::WriteTestFile("ceph.tif", IntegerTIFF(32, true)));
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetBufferPointer()[5], 50.0f);
}

TEST(ReadLabelImage, BytesThatAreCutOrChangedAreRefusedOrReadButNeverCrash)
{
  const std::string whole = IntegerTIFF(32, false);
  unsigned int      refused = 0;
  for (std::size_t size = 0; size < whole.size(); ++size)
  {
    const std::string file = itk::WriteTestFile("cut.tif", whole.substr(0, size));
    try
    {
      itk::ReadLabelImage(file);
    }
    catch (const itk::DentalInputError &)
    {
      ++refused;
    }
  }
  // Only the offset of a second directory, which is not there, may be missing.
  EXPECT_GE(refused, whole.size() - 4);
  for (std::size_t at = 0; at < whole.size(); ++at)
  {
    for (const char flip : { '\x01', '\x80', '\xff' })
    {
      std::string changed = whole;
      changed[at] = static_cast<char>(changed[at] ^ flip);
      const std::string file = itk::WriteTestFile("changed.tif", changed);
      try
      {
        itk::ReadLabelImage(file);
      }
      catch (const itk::DentalInputError &)
      {}
    }
  }
}

TEST(ReadMaskImage, TheRarerToneIsWhatIsDrawn)
{
  const std::string head = "NRRD0004\ntype: uchar\ndimension: 2\nsizes: 4 2\nencoding: ascii\n\n";
  for (const char * pixels : { "0 255 0 0\n0 0 0 0\n",
                               "255 0 255 255\n255 255 255 255\n",
                               "0 1 0 0\n0 0 0 0\n",
                               "200 90 180 200\n200 200 199 200\n" })
  {
    const auto image = itk::ReadMaskImage(itk::WriteTestFile("m.nrrd", head + pixels));
    for (unsigned int i = 0; i < 8; ++i)
    {
      EXPECT_EQ(image->GetBufferPointer()[i], i == 1 ? 1 : 0) << pixels;
    }
  }
  const std::string blank = itk::WriteTestFile("blank.nrrd", head + "7 7 7 7\n7 7 7 7\n");
  EXPECT_TRUE(Contains(itk::ExpectInputError([&] { itk::ReadMaskImage(blank); }).GetProblem(), "nothing drawn"));
}

TEST(ReadLabelImage, HeaderSpacingIsWhatOtherProgramsGiveThePicture)
{
  const auto read = [](const std::string & name, const std::string & fields) {
    const auto reader = itk::CephalogramFileReader::New();
    reader->SetFileName(itk::WriteTestFile(
      name, "NRRD0004\ntype: uchar\ndimension: 2\nsizes: 2 1\n" + fields + "encoding: ascii\n\n1 2\n"));
    reader->UpdateOutputInformation();
    return reader;
  };
  const auto spaced = read("a.nrrd", "spacings: 0.2 0.3\n");
  ASSERT_TRUE(spaced->HasHeaderSpacing());
  EXPECT_NEAR(spaced->GetHeaderSpacing()[1], 0.3, 1e-12);
  // Without a spacing other programs take 1 mm, and so have markups that were made there.
  const auto none = read("b.nrrd", "");
  ASSERT_TRUE(none->HasHeaderSpacing());
  EXPECT_EQ(none->GetHeaderSpacing()[0], 1.0);
  EXPECT_FALSE(none->HasPixelSpacing());
  const auto tiff = itk::CephalogramFileReader::New();
  tiff->SetFileName(itk::WriteTestFile("c.tif", IntegerTIFF(16, false)));
  tiff->UpdateOutputInformation();
  EXPECT_FALSE(tiff->HasHeaderSpacing());
  EXPECT_THROW(tiff->GetHeaderSpacing(), itk::ExceptionObject);
}

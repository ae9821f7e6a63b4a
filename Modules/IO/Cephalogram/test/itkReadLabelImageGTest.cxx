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

#include "itkTIFFTestFile.h"
#include "itkTestFile.h"

#include "itkImageFileWriter.h"
#include "itkJPEGImageIO.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

using itk::Contains;

namespace
{
/** A TIFF of 3 x 2 whole numbers 0 .. 5 times ten, less one in the first pixel where asked. */
std::string
IntegerTIFF(unsigned int bits, bool isSigned, bool negative = false)
{
  itk::TIFFTestFile file;
  file.bits = bits;
  file.sampleFormat = isSigned ? 2 : 1;
  return file.Make([negative](unsigned int u, unsigned int v) {
    return std::int64_t{ 10 } * (3 * v + u) - (negative && u == 0 && v == 0 ? 1 : 0);
  });
}

std::string
BigEndian32(std::uint32_t value)
{
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8)
  {
    bytes += static_cast<char>((value >> shift) & 0xffu);
  }
  return bytes;
}

std::string
PNGChunk(const std::string & content)
{
  std::uint32_t check = 0xffffffffu;
  for (const char byte : content)
  {
    check ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit)
    {
      check = (check & 1u) != 0 ? 0xedb88320u ^ (check >> 1) : check >> 1;
    }
  }
  return BigEndian32(static_cast<std::uint32_t>(content.size() - 4)) + content + BigEndian32(~check);
}

/** A PNG of 8 x 2 pixels with a palette, whose numbers are 0 .. 7 and then `first` and on, as far as the bits go. Red
 * is the number times two, green 10, blue 0.
 *
 * \param transparency Opacities of the palette's first entries. */
std::string
PalettePNG(unsigned int bits, unsigned int first, const std::string & transparency)
{
  std::string palette;
  for (unsigned int i = 0; i < (1u << bits); ++i)
  {
    palette += std::string{ static_cast<char>(std::min(2 * i, 255u)), '\x0a', '\0' };
  }
  std::string rows;
  for (const unsigned int begin : { 0u, first })
  {
    rows += '\0';
    unsigned int byte = 0;
    for (unsigned int u = 0; u < 8; ++u)
    {
      byte = (byte << bits) | ((begin + u) % (1u << bits));
      if ((u + 1) * bits % 8 == 0)
      {
        rows += static_cast<char>(byte & 0xffu);
      }
    }
  }
  // Deflate's form of bytes that are not compressed, and Adler's sum.
  std::uint32_t low = 1;
  std::uint32_t high = 0;
  for (const char byte : rows)
  {
    low = (low + static_cast<unsigned char>(byte)) % 65521u;
    high = (high + low) % 65521u;
  }
  const auto        size = static_cast<char>(rows.size());
  const std::string stored = std::string("\x78\x01\x01") + size + '\0' + static_cast<char>(~size) + '\xff' + rows +
                             BigEndian32((high << 16) | low);
  return "\x89PNG\r\n\x1a\n" +
         PNGChunk("IHDR" + BigEndian32(8) + BigEndian32(2) + static_cast<char>(bits) + std::string("\x03\0\0\0", 4)) +
         PNGChunk("PLTE" + palette) + (transparency.empty() ? std::string() : PNGChunk("tRNS" + transparency)) +
         PNGChunk("IDAT" + stored) + PNGChunk("IEND");
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

/** A radiograph is turned as its file says, and so is what is drawn on it: each pixel stays on its tooth. */
TEST(ReadLabelImage, LabelsAndMasksAreTurnedAsTheirRadiographIs)
{
  itk::TIFFTestFile file;
  for (const unsigned int bits : { 8u, 16u, 32u })
  {
    for (const bool tiled : { false, true })
    {
      for (file.orientation = 1; file.orientation <= 8; ++file.orientation)
      {
        SCOPED_TRACE(std::to_string(bits) + " bits, orientation " + std::to_string(file.orientation) +
                     (tiled ? ", tiled" : ""));
        file.bits = bits;
        file.tiled = tiled;
        const std::string labels = itk::WriteTestFile("labels.tif", file.Make([bits](unsigned int u, unsigned int v) {
          return 11 + (bits > 8 ? 700 : 1) * (3 * v + u);
        }));
        const auto        reader = itk::CephalogramFileReader::New();
        reader->SetFileName(labels);
        reader->Update();
        const auto image = itk::ReadLabelImage(labels);
        ASSERT_EQ(image->GetLargestPossibleRegion(), reader->GetOutput()->GetLargestPossibleRegion());
        const auto mask = itk::ReadMaskImage(itk::WriteTestFile(
          "mask.tif", file.Make([](unsigned int u, unsigned int v) { return u == 2 && v == 0 ? 200 : 0; })));
        ASSERT_EQ(mask->GetLargestPossibleRegion(), image->GetLargestPossibleRegion());
        const std::uint16_t masked = bits > 8 ? 1411 : 13;
        for (unsigned int i = 0; i < 6; ++i)
        {
          EXPECT_EQ(image->GetBufferPointer()[i], reader->GetOutput()->GetBufferPointer()[i]) << i;
          EXPECT_EQ(mask->GetBufferPointer()[i], image->GetBufferPointer()[i] == masked ? 1 : 0) << i;
        }
      }
    }
  }
}

TEST(ReadLabelImage, APalettesNumbersAreLabelsAndItsColoursARadiograph)
{
  itk::TIFFTestFile file;
  file.photometric = 3;
  for (file.orientation = 1; file.orientation <= 8; ++file.orientation)
  {
    SCOPED_TRACE("orientation " + std::to_string(file.orientation));
    const auto        number = [](unsigned int u, unsigned int v) { return 30 + 3 * v + u; };
    const std::string path = itk::WriteTestFile("palette.tif", file.Make(number));
    const auto        labels = itk::ReadLabelImage(path);
    const auto        reader = itk::CephalogramFileReader::New();
    reader->SetFileName(path);
    reader->Update();
    ASSERT_EQ(labels->GetLargestPossibleRegion(), reader->GetOutput()->GetLargestPossibleRegion());
    // A palette is of 16 bits; of what ITK leaves to libtiff it makes 8.
    const float unit = file.orientation == 1 || file.orientation == 4 ? 257.0f : 1.0f;
    for (unsigned int i = 0; i < 6; ++i)
    {
      const unsigned int label = labels->GetBufferPointer()[i];
      EXPECT_EQ(label, file.orientation == 1 ? 30 + i : label);
      // Of the test file's palette red is the number, green and blue are further on in a ramp of 200.
      EXPECT_NEAR(reader->GetOutput()->GetBufferPointer()[i] / unit,
                  0.2126 * label + 0.7152 * ((256 + label) % 200) + 0.0722 * ((512 + label) % 200),
                  1.0)
        << i;
    }
  }
}

/** Programs of labels write the background of a palette as transparent. */
TEST(ReadLabelImage, APalettesNumbersAreLabelsWhereEntriesAreTransparent)
{
  for (const unsigned int bits : { 8u, 4u, 2u, 1u })
  {
    for (const std::string & transparency : { std::string(), std::string(1, '\0'), std::string("\x80\0", 2) })
    {
      SCOPED_TRACE(std::to_string(bits) + " bits, transparent " + std::to_string(transparency.size()));
      const std::string path = itk::WriteTestFile("palette.png", PalettePNG(bits, 41, transparency));
      const auto        labels = itk::ReadLabelImage(path);
      ASSERT_EQ(labels->GetLargestPossibleRegion().GetSize(), (itk::Size<2>{ { 8, 2 } }));
      for (unsigned int i = 0; i < 16; ++i)
      {
        EXPECT_EQ(labels->GetBufferPointer()[i], (i < 8 ? i : 41 + i - 8) % (1u << bits)) << i;
      }
      const auto mask = itk::ReadMaskImage(path);
      EXPECT_EQ(mask->GetLargestPossibleRegion().GetSize(), (itk::Size<2>{ { 8, 2 } }));
      // A radiograph shows its colours, and black where it is transparent.
      const auto reader = itk::CephalogramFileReader::New();
      reader->SetFileName(path);
      reader->Update();
      const float * const grey = reader->GetOutput()->GetBufferPointer();
      EXPECT_NEAR(grey[0], transparency.empty() ? 7.2 : transparency.size() == 1 ? 0.0 : 3.6, 0.1);
      EXPECT_NEAR(grey[1], transparency.size() == 2 ? 0.0 : 7.6, 0.1);
    }
  }
}

TEST(ReadMaskImage, AJPEGThatExifTurnsLiesOnItsRadiograph)
{
  const auto image = itk::Image<unsigned char, 2>::New();
  image->SetRegions(itk::Size<2>{ { 32, 16 } });
  image->Allocate(true);
  for (itk::IndexValueType v = 0; v < 8; ++v)
  {
    for (itk::IndexValueType u = 0; u < 8; ++u)
    {
      image->SetPixel({ { u, v } }, 255);
    }
  }
  const std::string path = itk::TestFolder() + "/stored.jpg";
  const auto        writer = itk::ImageFileWriter<itk::Image<unsigned char, 2>>::New();
  writer->SetImageIO(itk::JPEGImageIO::New());
  writer->SetFileName(path);
  writer->SetInput(image);
  writer->Update();
  const std::string stored = itk::ReadTestFile(path);
  // Orientation 6: the stored top is on the right.
  const std::string segment("\xff\xe1\0\x22"
                            "Exif\0\0"
                            "II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0\0\0\0\0",
                            36);
  const auto mask = itk::ReadMaskImage(itk::WriteTestFile("m.jpg", stored.substr(0, 2) + segment + stored.substr(2)));
  ASSERT_EQ(mask->GetLargestPossibleRegion().GetSize(), (itk::Size<2>{ { 16, 32 } }));
  EXPECT_EQ(mask->GetPixel({ { 12, 3 } }), 1);
  EXPECT_EQ(mask->GetPixel({ { 3, 3 } }), 0);
  EXPECT_EQ(mask->GetPixel({ { 3, 28 } }), 0);
  EXPECT_EQ(mask->GetPixel({ { 12, 28 } }), 0);
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

TEST(ReadLabelImage, ABorderOfBothJawsIsOfNeitherAndOneOfNeighboursStays)
{
  const auto                               labels = itk::Image<std::uint16_t, 2>::New();
  itk::Image<std::uint16_t, 2>::RegionType region;
  region.SetSize(0, 30);
  region.SetSize(1, 20);
  labels->SetRegions(region);
  labels->Allocate(true);
  // 11 above 41 and beside 12; 85, a primary tooth, is of the lower jaw, too.
  const auto paint = [&](long left, long right, long top, long bottom, std::uint16_t value) {
    for (long y = top; y < bottom; ++y)
    {
      for (long x = left; x < right; ++x)
      {
        labels->SetPixel({ { x, y } }, value);
      }
    }
  };
  paint(15, 25, 2, 10, 11);
  paint(5, 15, 2, 10, 12);
  paint(15, 25, 10, 18, 41);
  paint(5, 10, 10, 18, 85);
  const std::vector<std::array<double, 2>> points = { { { 20.0, 1.5 } }, { { 14.5, 5.0 } }, { { 20.0, 9.5 } },
                                                      { { 7.0, 9.5 } },  { { 12.0, 9.5 } }, { { 29.5, 19.5 } } };
  EXPECT_EQ(itk::ComputeLabelBorderWeights(labels, points, true), (std::vector<double>{ 1, 1, 0, 0, 1, 1 }));
  // Seen from the lower jaw it is the upper teeth that are strangers.
  EXPECT_EQ(itk::ComputeLabelBorderWeights(labels, { { { 20.0, 9.5 } }, { { 20.0, 17.5 } } }, false),
            (std::vector<double>{ 0, 1 }));
  EXPECT_TRUE(itk::ComputeLabelBorderWeights(labels, { { { 20.0, 1.5 } } }, true).empty());
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

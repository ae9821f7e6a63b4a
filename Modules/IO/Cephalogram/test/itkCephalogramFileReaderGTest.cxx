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
#include "itkCephalogramFileReader.h"

#include "itkTIFFTestFile.h"
#include "itkTestFile.h"

#include "itkBMPImageIO.h"
#include "itkImageFileWriter.h"
#include "itkJPEGImageIO.h"
#include "itkMetaDataObject.h"
#include "itkMetaImageIO.h"
#include "itkNrrdImageIO.h"
#include "itkPNGImageIO.h"
#include "itkRGBAPixel.h"
#include "itkRGBPixel.h"
#include "itkTIFFImageIO.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>

using itk::CephalogramFileReader;
using Verdict = itk::PixelSpacingVerdictEnum;
using Plane = itk::SpacingPlaneEnum;

namespace
{
/** 20 x 12, pixel (u, v) made by the function. */
template <typename TPixel, unsigned int VDimension = 2, typename TFunction>
typename itk::Image<TPixel, VDimension>::Pointer
MakeImage(const TFunction & function, itk::SizeValueType slices = 1)
{
  using ImageType = itk::Image<TPixel, VDimension>;
  typename ImageType::SizeType size;
  size.Fill(slices);
  size[0] = 20;
  size[1] = 12;
  const auto image = ImageType::New();
  image->SetRegions(size);
  image->Allocate();
  for (itk::SizeValueType i = 0; i < image->GetLargestPossibleRegion().GetNumberOfPixels(); ++i)
  {
    image->GetBufferPointer()[i] = function(i % 20, i / 20 % 12);
  }
  return image;
}

template <typename TImageIO, typename TImage>
std::string
WriteImage(const std::string & name, const TImage * image)
{
  const std::string path = itk::TestFolder() + '/' + name;
  const auto        writer = itk::ImageFileWriter<TImage>::New();
  writer->SetFileName(path);
  writer->SetInput(image);
  writer->SetImageIO(TImageIO::New());
  writer->Update();
  return path;
}

CephalogramFileReader::Pointer
Read(const std::string & path)
{
  const auto reader = CephalogramFileReader::New();
  reader->SetFileName(path);
  reader->Update();
  return reader;
}

float
GetPixel(const CephalogramFileReader * reader, itk::IndexValueType u, itk::IndexValueType v)
{
  return reader->GetOutput()->GetPixel({ { u, v } });
}

const auto Ramp = [](auto u, auto v) { return static_cast<unsigned char>(10 * u + v); };

template <typename TImage>
void
SetSpacing(TImage * image, double u, double v)
{
  auto spacing = image->GetSpacing();
  spacing[0] = u;
  spacing[1] = v;
  image->SetSpacing(spacing);
}

std::string
ReadProblem(const std::string & path)
{
  const auto error = itk::ExpectInputError([&] { Read(path); });
  EXPECT_EQ(error.GetInputFile(), path);
  EXPECT_FALSE(error.GetRemedy().empty());
  return error.GetProblem();
}

/** Of the picture whose place tells how it was turned: the first rows are grey, the corner at their beginning bright.
 */
unsigned int
Oriented(itk::IndexValueType u, itk::IndexValueType v)
{
  return v >= 6 ? 0 : u < 6 ? 240 : 120;
}

itk::Image<unsigned char, 2>::Pointer
MakeOriented()
{
  return MakeImage<unsigned char>(
    [](auto u, auto v) { return static_cast<unsigned char>(Oriented(static_cast<long>(u), static_cast<long>(v))); });
}

/** That the picture above, which a file says to be turned by TIFF's and Exif's number, is seen upright. */
void
ExpectUpright(const std::string & path, unsigned int orientation, unsigned int unit = 1)
{
  struct Seen
  {
    bool transposed;
    bool cornerRight;
    bool cornerBottom;
  };
  // Where the file's first row and column are to be seen.
  const std::array<Seen, 8> seen{ { { false, false, false },
                                    { false, true, false },
                                    { false, true, true },
                                    { false, false, true },
                                    { true, false, false },
                                    { true, true, false },
                                    { true, true, true },
                                    { true, false, true } } };
  // What is no orientation is as good as none.
  const bool isOrientation = orientation >= 1 && orientation <= 8;
  const Seen expected = seen[isOrientation ? orientation - 1u : 0u];
  const auto reader = Read(path);
  const auto size = reader->GetOutput()->GetLargestPossibleRegion().GetSize();
  ASSERT_EQ(size[0], expected.transposed ? 12u : 20u);
  ASSERT_EQ(size[1], expected.transposed ? 20u : 12u);
  const auto right = static_cast<itk::IndexValueType>(size[0]) - 2;
  const auto bottom = static_cast<itk::IndexValueType>(size[1]) - 2;
  const auto u = expected.cornerRight ? right : 1;
  const auto v = expected.cornerBottom ? bottom : 1;
  const auto scale = static_cast<float>(unit);
  EXPECT_NEAR(GetPixel(reader, u, v) / scale, 240.0f, 30.0f);
  // The rest of the file's first row, and what lies opposite.
  EXPECT_NEAR(GetPixel(reader, expected.transposed ? u : right + 1 - u, expected.transposed ? bottom + 1 - v : v) /
                scale,
              120.0f,
              30.0f);
  EXPECT_NEAR(GetPixel(reader, expected.transposed ? right + 1 - u : u, expected.transposed ? v : bottom + 1 - v) /
                scale,
              0.0f,
              30.0f);
  EXPECT_EQ(reader->GetWarnings().size(), isOrientation && orientation > 1 ? 1u : 0u);
}
} // namespace

TEST(CephalogramFileReader, ReadsPicturesWithoutFactoriesAndWithoutASpacing)
{
  const auto image = MakeImage<unsigned char>(Ramp);
  // The writers turn this into dots per inch, which is what many exports have.
  SetSpacing(image.GetPointer(), 0.1, 0.1);
  for (const auto & [path, format] :
       { std::make_pair(WriteImage<itk::PNGImageIO>("a.png", image.GetPointer()), "PNG"),
         std::make_pair(WriteImage<itk::BMPImageIO>("a.bmp", image.GetPointer()), "BMP"),
         std::make_pair(WriteImage<itk::TIFFImageIO>("a.tif", image.GetPointer()), "TIFF") })
  {
    const auto reader = Read(path);
    EXPECT_EQ(reader->GetFileFormat(), format);
    EXPECT_EQ(reader->GetPixelSpacingVerdict(), Verdict::Unknown) << format;
    EXPECT_FALSE(reader->HasPixelSpacing()) << format;
    EXPECT_THROW(reader->GetPixelSpacing(), itk::ExceptionObject) << format;
    EXPECT_EQ(reader->GetOutput()->GetSpacing()[0], 1.0) << format;
    EXPECT_EQ(reader->GetOutput()->GetLargestPossibleRegion().GetSize()[0], 20u) << format;
    EXPECT_EQ(GetPixel(reader, 7, 5), 75.0f) << format;
    EXPECT_EQ(GetPixel(reader, 0, 11), 11.0f) << format;
  }
}

TEST(CephalogramFileReader, ReadsJPEGAndTakesNoDotsPerInch)
{
  const auto flat = MakeImage<unsigned char>([](auto, auto) { return static_cast<unsigned char>(77); });
  SetSpacing(flat.GetPointer(), 0.1, 0.1);
  const auto reader = Read(WriteImage<itk::JPEGImageIO>("a.jpg", flat.GetPointer()));
  EXPECT_EQ(reader->GetFileFormat(), "JPEG");
  EXPECT_EQ(reader->GetPixelSpacingVerdict(), Verdict::Unknown);
  EXPECT_EQ(reader->GetOutput()->GetSpacing()[0], 1.0);
  // A flat block is coded within one grey level.
  EXPECT_NEAR(GetPixel(reader, 7, 5), 77.0f, 1.0f);
}

TEST(CephalogramFileReader, RecognisesAFileByItsContent)
{
  const auto        image = MakeImage<unsigned char>(Ramp);
  const std::string path = WriteImage<itk::PNGImageIO>("a.png", image.GetPointer());
  const std::string renamed = itk::TestFolder() + "/ceph";
  std::filesystem::copy_file(path, renamed);
  EXPECT_EQ(GetPixel(Read(renamed), 7, 5), 75.0f);
  const std::string wrong = itk::TestFolder() + "/ceph.jpg";
  std::filesystem::copy_file(path, wrong);
  EXPECT_EQ(Read(wrong)->GetFileFormat(), "PNG");
}

TEST(CephalogramFileReader, ExifTurnsAPictureAsViewersDo)
{
  const std::string stored = itk::ReadTestFile(WriteImage<itk::JPEGImageIO>("stored.jpg", MakeOriented().GetPointer()));
  for (const bool bigEndian : { false, true })
  {
    for (unsigned char orientation = 0; orientation <= 9; ++orientation)
    {
      // A TIFF of one tag (274, SHORT, one value) in an APP1 segment behind the picture's first two bytes.
      const std::string tiff = bigEndian ? std::string("MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0", 19) +
                                             static_cast<char>(orientation) + std::string(6, '\0')
                                         : std::string("II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0", 18) +
                                             static_cast<char>(orientation) + std::string(7, '\0');
      const std::string block = std::string("Exif\0\0", 6) + tiff;
      const std::string segment = std::string("\xff\xe1\0", 3) + static_cast<char>(block.size() + 2) + block;
      SCOPED_TRACE(int{ orientation });
      ExpectUpright(itk::WriteTestFile("turned.jpg", stored.substr(0, 2) + segment + stored.substr(2)), orientation);
    }
  }
}

/** ITK's reader turns some of these itself, by half: libtiff mirrors rows and columns but does not exchange them. */
TEST(CephalogramFileReader, TIFFIsTurnedAsViewersDo)
{
  itk::TIFFTestFile file;
  file.width = 20;
  file.height = 12;
  for (const unsigned int bits : { 8u, 16u, 32u })
  {
    for (const unsigned int samples : { 1u, 3u })
    {
      for (const bool tiled : { false, true })
      {
        for (const bool big : { false, true })
        {
          if (bits == 32 && samples == 3)
          {
            continue;
          }
          for (file.orientation = 1; file.orientation <= 8; ++file.orientation)
          {
            file.bits = bits;
            file.samples = samples;
            file.photometric = samples == 1 ? 1 : 2;
            file.tiled = tiled;
            file.big = big;
            // ITK leaves what is tiled or mirrored across to libtiff, which makes 8 bits of colours of 16.
            const bool         rows = file.orientation == 1 || file.orientation == 4;
            const bool         eighth = samples == 3 && bits == 16 && (tiled || !rows);
            const unsigned int unit = bits == 16 && samples == 3 ? 257 : 1;
            const auto         oriented = [&](unsigned int u, unsigned int v) { return unit * Oriented(u, v); };
            SCOPED_TRACE(std::to_string(bits) + " bits, " + std::to_string(samples) + " samples, orientation " +
                         std::to_string(file.orientation) + (tiled ? ", tiled" : "") + (big ? ", big" : ""));
            ExpectUpright(itk::WriteTestFile("turned.tif", file.Make(oriented)), file.orientation, eighth ? 1 : unit);
          }
        }
      }
    }
  }
}

TEST(CephalogramFileReader, SixteenBitsAreKept)
{
  const auto image =
    MakeImage<unsigned short>([](auto u, auto v) { return static_cast<unsigned short>(3000 * u + v); });
  EXPECT_EQ(GetPixel(Read(WriteImage<itk::PNGImageIO>("a.png", image.GetPointer())), 19, 5), 57005.0f);
  EXPECT_EQ(GetPixel(Read(WriteImage<itk::TIFFImageIO>("a.tif", image.GetPointer())), 19, 5), 57005.0f);
}

TEST(CephalogramFileReader, ColourBecomesLuminanceAndTransparencyBlack)
{
  const auto colour = MakeImage<itk::RGBPixel<unsigned char>>([](auto, auto) {
    itk::RGBPixel<unsigned char> pixel;
    pixel.Set(200, 100, 50);
    return pixel;
  });
  EXPECT_NEAR(GetPixel(Read(WriteImage<itk::PNGImageIO>("a.png", colour.GetPointer())), 3, 3),
              0.2126 * 200 + 0.7152 * 100 + 0.0722 * 50,
              1e-4);
  const auto transparent = MakeImage<itk::RGBAPixel<unsigned char>>([](auto u, auto) {
    itk::RGBAPixel<unsigned char> pixel;
    pixel.Set(100, 100, 100, u < 10 ? 255 : 0);
    return pixel;
  });
  const auto reader = Read(WriteImage<itk::PNGImageIO>("b.png", transparent.GetPointer()));
  EXPECT_NEAR(GetPixel(reader, 9, 0), 100.0f, 1e-4);
  EXPECT_EQ(GetPixel(reader, 10, 0), 0.0f);
}

TEST(CephalogramFileReader, ExplicitSpacingOfNrrdAndMetaImageIsTheDetectors)
{
  const auto image = MakeImage<unsigned char>(Ramp);
  SetSpacing(image.GetPointer(), 0.2, 0.1);
  auto origin = image->GetOrigin();
  origin.Fill(30.0);
  image->SetOrigin(origin);
  for (const std::string & path : { WriteImage<itk::NrrdImageIO>("a.nrrd", image.GetPointer()),
                                    WriteImage<itk::MetaImageIO>("a.mha", image.GetPointer()),
                                    WriteImage<itk::MetaImageIO>("a.mhd", image.GetPointer()) })
  {
    const auto reader = Read(path);
    EXPECT_EQ(reader->GetPixelSpacingVerdict(), Verdict::Detector) << path;
    EXPECT_NEAR(reader->GetPixelSpacing()[0], 0.2, 1e-12) << path;
    EXPECT_NEAR(reader->GetPixelSpacing()[1], 0.1, 1e-12) << path;
    EXPECT_EQ(reader->GetOutput()->GetOrigin()[0], 0.0) << path;
    EXPECT_EQ(GetPixel(reader, 7, 5), 75.0f) << path;
  }
}

TEST(CephalogramFileReader, DefaultAndScreenSpacingsOfNrrdAndMetaImageAreUnknown)
{
  for (const double spacing : { 1.0, 25.4 / 72.0, 25.4 / 96.0 })
  {
    const auto image = MakeImage<unsigned char>(Ramp);
    SetSpacing(image.GetPointer(), spacing, spacing);
    for (const std::string & path : { WriteImage<itk::NrrdImageIO>("a.nrrd", image.GetPointer()),
                                      WriteImage<itk::MetaImageIO>("a.mha", image.GetPointer()) })
    {
      const auto reader = Read(path);
      EXPECT_EQ(reader->GetPixelSpacingVerdict(), Verdict::Unknown) << path << spacing;
      EXPECT_EQ(reader->GetOutput()->GetSpacing()[0], 1.0) << path;
    }
  }
  const std::string header = "NRRD0004\ntype: unsigned char\ndimension: 2\nsizes: 2 2\nencoding: raw\n";
  EXPECT_EQ(Read(itk::WriteTestFile("none.nrrd", header + "\nabcd"))->GetPixelSpacingVerdict(), Verdict::Unknown);
  const std::string inches = itk::WriteTestFile("in.nrrd", header + "spacings: 2 2\nunits: \"um\" \"um\"\n\nabcd");
  EXPECT_EQ(Read(inches)->GetPixelSpacingVerdict(), Verdict::Unknown);
  const std::string millimetres = itk::WriteTestFile("mm.nrrd", header + "spacings: 2 3\nunits: \"mm\" \"mm\"\n\nabcd");
  EXPECT_EQ(Read(millimetres)->GetPixelSpacing()[1], 3.0);
}

TEST(CephalogramFileReader, OneSliceIsAPictureAndSeveralAreAnError)
{
  const auto one = MakeImage<short, 3>(Ramp);
  EXPECT_EQ(GetPixel(Read(WriteImage<itk::NrrdImageIO>("one.nrrd", one.GetPointer())), 7, 5), 75.0f);
  EXPECT_EQ(GetPixel(Read(WriteImage<itk::MetaImageIO>("one.mha", one.GetPointer())), 7, 5), 75.0f);
  const auto two = MakeImage<unsigned char, 3>(Ramp, 2);
  EXPECT_TRUE(itk::Contains(ReadProblem(WriteImage<itk::NrrdImageIO>("two.nrrd", two.GetPointer())), "2 frames"));
  EXPECT_TRUE(itk::Contains(ReadProblem(WriteImage<itk::MetaImageIO>("two.mha", two.GetPointer())), "2 frames"));
  EXPECT_TRUE(itk::Contains(ReadProblem(WriteImage<itk::TIFFImageIO>("two.tif", two.GetPointer())), "2 frames"));
}

TEST(CephalogramFileReader, NotFiniteIsRefused)
{
  const auto image = MakeImage<float>(
    [](auto u, auto) { return u == 3 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(u); });
  EXPECT_TRUE(itk::Contains(ReadProblem(WriteImage<itk::NrrdImageIO>("a.nrrd", image.GetPointer())), "not finite"));
}

TEST(CephalogramFileReader, TruncatedFilesAreRefusedSilently)
{
  const auto image =
    MakeImage<unsigned char>([](auto u, auto v) { return static_cast<unsigned char>(u * 37 + v * v * 11); });
  SetSpacing(image.GetPointer(), 0.1, 0.1);
  for (const std::string & path : { WriteImage<itk::PNGImageIO>("a.png", image.GetPointer()),
                                    WriteImage<itk::JPEGImageIO>("a.jpg", image.GetPointer()),
                                    WriteImage<itk::BMPImageIO>("a.bmp", image.GetPointer()),
                                    WriteImage<itk::TIFFImageIO>("a.tif", image.GetPointer()),
                                    WriteImage<itk::NrrdImageIO>("a.nrrd", image.GetPointer()),
                                    WriteImage<itk::MetaImageIO>("a.mha", image.GetPointer()) })
  {
    const std::string bytes = itk::ReadTestFile(path);
    const std::string name = std::filesystem::path(path).filename().string();
    for (const double part : { 0.0, 0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0 })
    {
      const auto length = static_cast<std::size_t>(part * static_cast<double>(bytes.size() - 1));
      const auto cut = itk::WriteTestFile("cut_" + name, bytes.substr(0, length));
      testing::internal::CaptureStderr();
      testing::internal::CaptureStdout();
      bool refused = false;
      try
      {
        Read(cut);
      }
      catch (const itk::DentalInputError &)
      {
        refused = true;
      }
      EXPECT_EQ(testing::internal::GetCapturedStdout(), "") << name << ' ' << length;
      EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << name << ' ' << length;
      EXPECT_TRUE(refused) << name << ' ' << length << " of " << bytes.size();
    }
    EXPECT_NO_THROW(Read(path)) << name;
  }
}

TEST(CephalogramFileReader, DamagedBytesNeverCrash)
{
  const auto image =
    MakeImage<unsigned char>([](auto u, auto v) { return static_cast<unsigned char>(u * 37 + v * v * 11); });
  for (const std::string & path : { WriteImage<itk::PNGImageIO>("a.png", image.GetPointer()),
                                    WriteImage<itk::JPEGImageIO>("a.jpg", image.GetPointer()),
                                    WriteImage<itk::BMPImageIO>("a.bmp", image.GetPointer()),
                                    WriteImage<itk::TIFFImageIO>("a.tif", image.GetPointer()),
                                    WriteImage<itk::NrrdImageIO>("a.nrrd", image.GetPointer()),
                                    WriteImage<itk::MetaImageIO>("a.mha", image.GetPointer()) })
  {
    const std::string bytes = itk::ReadTestFile(path);
    unsigned int      refused = 0;
    testing::internal::CaptureStderr();
    // Of most formats a process each: all of the header, and samples of what follows.
    for (std::size_t position = 0; position < bytes.size(); position += position < 128 ? 1 : 9)
    {
      std::string damaged = bytes;
      damaged[position] = static_cast<char>(damaged[position] ^ 0x5a);
      try
      {
        Read(itk::WriteTestFile("damaged", damaged));
      }
      catch (const itk::DentalInputError &)
      {
        ++refused;
      }
    }
    testing::internal::GetCapturedStderr();
    EXPECT_GT(refused, 0u) << path;
  }
}

TEST(CephalogramFileReader, WhatIsNoImageIsNamed)
{
  EXPECT_TRUE(itk::Contains(ReadProblem(itk::TestFolder() + "/none.png"), "no such file"));
  EXPECT_TRUE(itk::Contains(ReadProblem(itk::TestFolder()), "directory"));
  EXPECT_TRUE(itk::Contains(ReadProblem(itk::WriteTestFile("empty.png", "")), "empty"));
  EXPECT_TRUE(itk::Contains(ReadProblem(itk::WriteTestFile("text.png", "this is no picture")), "no image"));
  EXPECT_TRUE(itk::Contains(ReadProblem(itk::WriteTestFile("scan.stl", std::string(84, '\0'))), "no image"));
  for (const char * signature : { "\x89PNG\r\n\x1a\n", "\xff\xd8\xff", "BM", "NRRD0004\n", "ObjectType = Image\n" })
  {
    ReadProblem(itk::WriteTestFile("head", signature));
    ReadProblem(itk::WriteTestFile("junk", signature + std::string(500, 'x')));
  }
  ReadProblem(itk::WriteTestFile("head.tif", std::string("II*\0", 4)));
  ReadProblem(itk::WriteTestFile("junk.tif", std::string("II*\0", 4) + std::string(500, 'x')));
  ReadProblem(itk::WriteTestFile("head.dcm", std::string(128, '\0') + "DICM"));
  ReadProblem(itk::WriteTestFile("junk.dcm", std::string(128, '\0') + "DICM" + std::string(500, 'x')));
}

TEST(CephalogramFileReader, AbsurdSizesAreRefusedBeforeMemoryIsTaken)
{
  const auto header = [](const std::string & sizes) {
    return "NRRD0004\ntype: unsigned char\ndimension: 2\nsizes: " + sizes + "\nencoding: raw\n\nabcd";
  };
  EXPECT_TRUE(itk::Contains(ReadProblem(itk::WriteTestFile("a.nrrd", header("200000 200000"))), "200000 x 200000"));
  ReadProblem(itk::WriteTestFile("b.nrrd", header("4000000000 4000000000")));
  ReadProblem(itk::WriteTestFile("c.nrrd", header("0 4")));
  ReadProblem(itk::WriteTestFile("d.nrrd", header("-1 4")));
  ReadProblem(itk::WriteTestFile(
    "a.mha",
    "ObjectType = Image\nNDims = 2\nDimSize = 200000 200000\nElementType = MET_UCHAR\nElementDataFile = LOCAL\nab"));
  // A PNG's own size stands behind its signature.
  const auto  image = MakeImage<unsigned char>(Ramp);
  std::string png = itk::ReadTestFile(WriteImage<itk::PNGImageIO>("a.png", image.GetPointer()));
  png[16] = 0x10;
  ReadProblem(itk::WriteTestFile("wide.png", png));
}

TEST(CephalogramFileReader, WhiteIsZeroTiffIsNotShownAsANegative)
{
  itk::TIFFTestFile file;
  file.width = 2;
  file.height = 1;
  for (const unsigned int bits : { 8u, 16u, 32u })
  {
    for (const bool isSigned : { false, true })
    {
      for (const unsigned int photometric : { 0u, 1u })
      {
        SCOPED_TRACE(std::to_string(bits) + (isSigned ? " bits, signed, " : " bits, ") + std::to_string(photometric));
        file.bits = bits;
        file.sampleFormat = isSigned ? 2 : 1;
        file.photometric = photometric;
        const auto reader =
          Read(itk::WriteTestFile("a.tif", file.Make([](unsigned int u, unsigned int) { return 100 * u; })));
        EXPECT_EQ(reader->GetProvenance().count("photometric"), photometric == 0 ? 1u : 0u);
        // Of 32 bits no picture has the largest value.
        const float largest = bits == 32 ? 100.0f : static_cast<float>((1u << (isSigned ? bits - 1 : bits)) - 1);
        EXPECT_EQ(GetPixel(reader, 0, 0), photometric == 0 ? largest : 0.0f);
        EXPECT_EQ(GetPixel(reader, 1, 0), photometric == 0 ? largest - 100.0f : 100.0f);
      }
    }
  }
}

TEST(CephalogramFileReader, OpacityOfAGreyTIFFIsNoPixel)
{
  itk::TIFFTestFile file;
  file.samples = 2;
  for (const unsigned int bits : { 8u, 16u })
  {
    for (const unsigned int photometric : { 0u, 1u })
    {
      for (const bool tiled : { false, true })
      {
        SCOPED_TRACE(std::to_string(bits) + " bits, " + std::to_string(photometric) + (tiled ? ", tiled" : ""));
        file.bits = bits;
        file.photometric = photometric;
        file.tiled = tiled;
        const float full = bits == 8 ? 255.0f : 65535.0f;
        // The file has the same number for grey and opacity: a fifth of it, and all in the last pixel.
        const auto reader = Read(itk::WriteTestFile("a.tif", file.Make([full](unsigned int u, unsigned int v) {
          return static_cast<unsigned int>(full / (u == 2 && v == 1 ? 1.0f : 5.0f));
        })));
        EXPECT_NEAR(GetPixel(reader, 0, 0) / full, (photometric == 0 ? 0.8f : 0.2f) * 0.2f, 1e-4f);
        EXPECT_NEAR(GetPixel(reader, 1, 1) / full, (photometric == 0 ? 0.8f : 0.2f) * 0.2f, 1e-4f);
        EXPECT_NEAR(GetPixel(reader, 2, 1) / full, photometric == 0 ? 0.0f : 1.0f, 1e-4f);
      }
    }
  }
  // Others are refused: ITK's reader would take opacities for pixels.
  file.bits = 32;
  file.sampleFormat = 3;
  EXPECT_TRUE(itk::Contains(
    ReadProblem(itk::WriteTestFile("float.tif", file.Make([](unsigned int, unsigned int) { return 0u; }))),
    "2 values a pixel"));
}

/** A decoder skips them; the search for Exif once read the file anew at each of them, seconds a megabyte. */
TEST(CephalogramFileReader, FillBytesBeforeAMarkerCostNothing)
{
  const std::string stored = itk::ReadTestFile(WriteImage<itk::JPEGImageIO>("stored.jpg", MakeOriented().GetPointer()));
  const std::string filled = itk::WriteTestFile(
    "filled.jpg", stored.substr(0, 2) + std::string(std::size_t{ 1 } << 23, '\xff') + stored.substr(2));
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_NEAR(GetPixel(Read(filled), 1, 1), 240.0f, 30.0f);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
}

TEST(CephalogramFileReader, InformationComesWithoutPixelsAndOnce)
{
  const auto reader = CephalogramFileReader::New();
  reader->SetFileName(WriteImage<itk::PNGImageIO>("a.png", MakeImage<unsigned char>(Ramp).GetPointer()));
  unsigned int runs = 0;
  reader->AddObserver(itk::StartEvent(), [&runs](const itk::EventObject &) { ++runs; });
  reader->UpdateOutputInformation();
  EXPECT_EQ(runs, 0u);
  EXPECT_EQ(reader->GetOutput()->GetLargestPossibleRegion().GetSize()[1], 12u);
  EXPECT_EQ(reader->GetFileFormat(), "PNG");
  reader->Update();
  reader->Update();
  EXPECT_EQ(runs, 1u);
  CephalogramFileReader::PixelSpacingType spacing;
  spacing.Fill(0.25);
  reader->SetUserPixelSpacing(spacing);
  reader->Update();
  EXPECT_EQ(runs, 2u);
  EXPECT_EQ(reader->GetOutput()->GetSpacing()[0], 0.25);
  reader->SetUserPixelSpacing(spacing);
  reader->Update();
  EXPECT_EQ(runs, 2u);
  std::string verdict;
  itk::ExposeMetaData<std::string>(
    reader->GetOutput()->GetMetaDataDictionary(), CephalogramFileReader::VerdictKey, verdict);
  EXPECT_EQ(verdict, "UserGiven");
}

TEST(CephalogramFileReader, DecodesTheBytesThatWereCheckedWhateverBecomesOfTheFile)
{
  const auto image = MakeImage<unsigned char>(Ramp);
  // Of the formats that are decoded here, and of those that have a process.
  const std::vector<std::string> files = { WriteImage<itk::PNGImageIO>("a.png", image.GetPointer()),
                                           WriteImage<itk::TIFFImageIO>("a.tif", image.GetPointer()),
                                           WriteImage<itk::BMPImageIO>("a.bmp", image.GetPointer()),
                                           WriteImage<itk::NrrdImageIO>("a.nrrd", image.GetPointer()),
                                           WriteImage<itk::NrrdImageIO>("b.nhdr", image.GetPointer()),
                                           WriteImage<itk::MetaImageIO>("a.mha", image.GetPointer()),
                                           WriteImage<itk::MetaImageIO>("c.mhd", image.GetPointer()) };
  for (const std::string & file : files)
  {
    const auto reader = CephalogramFileReader::New();
    reader->SetFileName(file);
    reader->UpdateOutputInformation();
    // The file, and the pixels beside a header.
    const std::filesystem::path path(file);
    for (const auto & entry : std::filesystem::directory_iterator(path.parent_path()))
    {
      if (entry.path().stem() == path.stem() && (path.stem() != "a" || entry.path() == path))
      {
        std::ofstream(entry.path(), std::ios::binary) << "another file";
      }
    }
    ASSERT_NO_THROW(reader->Update()) << file;
    EXPECT_EQ(GetPixel(reader, 7, 5), 75.0f) << file;
    EXPECT_EQ(GetPixel(reader, 19, 11), 201.0f) << file;
    // And a second time it is read anew.
    reader->Modified();
    EXPECT_THROW(reader->Update(), itk::DentalInputError) << file;
  }
}

TEST(CephalogramFileReader, ReadsItsPixelsAgainWhereTheyWereReleased)
{
  const std::string file = WriteImage<itk::PNGImageIO>("a.png", MakeImage<unsigned char>(Ramp).GetPointer());
  const auto        reader = Read(file);
  reader->GetOutput()->ReleaseData();
  reader->Update();
  EXPECT_EQ(GetPixel(reader, 7, 5), 75.0f);
  // Another picture is no answer to what its header has said.
  const auto small = itk::Image<unsigned char, 2>::New();
  small->SetRegions(itk::Size<2>{ { 3, 3 } });
  small->Allocate(true);
  WriteImage<itk::PNGImageIO>("a.png", small.GetPointer());
  reader->GetOutput()->ReleaseData();
  const auto error = itk::ExpectInputError([&] { reader->Update(); });
  EXPECT_TRUE(itk::Contains(error.GetProblem(), "was changed since its header was read")) << error.GetProblem();
}

TEST(CephalogramFileReader, PixelsBesideAHeaderBeginWhereItSays)
{
  std::string pixels;
  for (unsigned int i = 0; i < 12; ++i)
  {
    pixels += static_cast<char>(i);
  }
  itk::WriteTestFile("a.raw", "four" + pixels);
  const std::string meta = "ObjectType = Image\nNDims = 2\nBinaryData = True\nDimSize = 4 3\nElementType = MET_UCHAR\n";
  const std::string nrrd = "NRRD0004\ntype: uint8\ndimension: 2\nsizes: 4 3\nencoding: raw\n";
  for (const auto & [name, header] :
       { std::pair<std::string, std::string>{ "a.mhd", meta + "HeaderSize = 4\nElementDataFile = a.raw\n" },
         { "b.mhd", meta + "HeaderSize = -1\nElementDataFile = a.raw\n" },
         { "a.nhdr", nrrd + "byte skip: 4\ndata file: a.raw\n" },
         { "b.nhdr", nrrd + "data file: a.raw\nbyte skip: -1\n\n" } })
  {
    const auto reader = Read(itk::WriteTestFile(name, header));
    EXPECT_EQ(GetPixel(reader, 0, 0), 0.0f) << name;
    EXPECT_EQ(GetPixel(reader, 3, 2), 11.0f) << name;
  }
}

TEST(CephalogramFileReader, NoFileIsReadThatIsLongerThanAnyRadiograph)
{
  for (const char * head : { "\x89PNG\r\n\x1a\n", "\xff\xd8\xff", "NRRD0004\n", "BM" })
  {
    const std::string file = itk::WriteTestFile("long", head);
    // Of which the disk holds nothing.
    std::filesystem::resize_file(file, (std::uintmax_t{ 1 } << 30) + 1);
    EXPECT_TRUE(itk::Contains(ReadProblem(file), "longer than 1073741824 bytes, too long for an image")) << head;
  }
  const std::string dicom = itk::WriteTestFile("long", std::string(128, '\0') + "DICM");
  std::filesystem::resize_file(dicom, (std::uintmax_t{ 1 } << 30) + 1);
  EXPECT_TRUE(itk::Contains(ReadProblem(dicom), "longer than 1073741824 bytes"));
}

TEST(CephalogramFileReader, NoMessageNamesAFileInMemory)
{
  // Whole as far as is checked, and nothing that its decoder would make a picture of.
  const std::string file = itk::WriteTestFile("a.bmp", "BM" + std::string(100, '\0'));
  const std::string problem = ReadProblem(file);
  EXPECT_FALSE(itk::Contains(problem, "/proc/")) << problem;
  const std::string nrrd = itk::WriteTestFile("a.nrrd", "NRRD0004\ntype: wrong\n\n");
  EXPECT_FALSE(itk::Contains(ReadProblem(nrrd), "/proc/")) << ReadProblem(nrrd);
}

TEST(CephalogramFileReader, SaysWhatToCall)
{
  const auto reader = CephalogramFileReader::New();
  try
  {
    reader->Update();
    FAIL();
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_TRUE(itk::Contains(error.GetDescription(), "SetFileName()")) << error.GetDescription();
  }
  EXPECT_THROW(reader->GetPixelSpacing(), itk::ExceptionObject);
  std::ostringstream os;
  reader->Print(os);
  EXPECT_TRUE(itk::Contains(os.str(), "PixelSpacingVerdict: Unknown"));
}

TEST(CephalogramFileReader, ReadsTheSharedCephalograms)
{
  const std::string folder = std::string(DENTALSCR_SHARED_DIR) + "/cephalograms";
  if (!std::filesystem::exists(folder))
  {
    GTEST_SKIP() << "no folder " << folder;
  }
  const auto jpeg = Read(folder + "/webceph-ceph1.jpg");
  EXPECT_EQ(jpeg->GetOutput()->GetLargestPossibleRegion().GetSize()[0], 1578u);
  EXPECT_EQ(jpeg->GetOutput()->GetLargestPossibleRegion().GetSize()[1], 2089u);
  EXPECT_EQ(jpeg->GetPixelSpacingVerdict(), Verdict::Unknown);
  const auto png = Read(folder + "/cephalometric-sample-traced.png");
  EXPECT_EQ(png->GetOutput()->GetLargestPossibleRegion().GetSize()[0], 1398u);
  EXPECT_EQ(png->GetOutput()->GetLargestPossibleRegion().GetSize()[1], 1702u);
  EXPECT_EQ(png->GetPixelSpacingVerdict(), Verdict::Unknown);
  EXPECT_EQ(png->GetOutput()->GetSpacing()[0], 1.0);
}

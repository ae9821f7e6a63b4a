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
// First the functions by which a NIfTI is read: its own class is not installed.
#include "itkReadLabelImage.h"

#include "itkCephalogramFileReader.h"

#include "itkTestFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <zlib.h>

using itk::Contains;

namespace
{
using Rows = std::array<std::array<float, 4>, 3>;

/** As ITK writes a picture whose first pixel is at nought. */
constexpr Rows Picture{
  { { { -1.0f, 0.0f, 0.0f, 0.0f } }, { { 0.0f, -1.0f, 0.0f, 0.0f } }, { { 0.0f, 0.0f, 1.0f, 0.0f } } }
};

/** A file of 3 x 2 pixels, which are the tenfold of 0 .. 5 in the order in which they are stored. */
struct NiftiTestFile
{
  short                dataType{ 2 };
  bool                 isBigEndian{ false };
  short                dimensions{ 3 };
  float                slope{ 0.0f };
  float                intercept{ 0.0f };
  std::array<float, 2> spacing{ { 1.0f, 1.0f } };
  char                 units{ 10 };
  short                qform{ 0 };
  short                sform{ 1 };
  std::array<float, 6> quaternion{};
  Rows                 matrix{ Picture };

  template <typename TValue>
  std::string
  Bytes(TValue value) const
  {
    std::string bytes(sizeof(value), '\0');
    std::memcpy(&bytes[0], &value, sizeof(value));
    if (isBigEndian)
    {
      std::reverse(bytes.begin(), bytes.end());
    }
    return bytes;
  }

  template <typename TPixel>
  std::string
  Make() const
  {
    std::string file(352, '\0');
    const auto  put = [&](std::size_t place, auto value) { file.replace(place, sizeof(value), this->Bytes(value)); };
    put(0, 348);
    const short size[] = { dimensions, 3, 2, 1, 1, 1, 1, 1 };
    for (std::size_t i = 0; i < 8; ++i)
    {
      put(40 + 2 * i, size[i]);
    }
    put(70, dataType);
    put(72, static_cast<short>(8 * sizeof(TPixel)));
    put(76, 1.0f);
    put(80, spacing[0]);
    put(84, spacing[1]);
    put(108, 352.0f);
    put(112, slope);
    put(116, intercept);
    file[123] = units;
    put(252, qform);
    put(254, sform);
    for (std::size_t i = 0; i < 6; ++i)
    {
      put(256 + 4 * i, quaternion[i]);
    }
    for (std::size_t i = 0; i < 12; ++i)
    {
      put(280 + 4 * i, matrix[i / 4][i % 4]);
    }
    file.replace(344, 3, "n+1");
    for (int i = 0; i < 6; ++i)
    {
      file += this->Bytes(static_cast<TPixel>(10 * i));
    }
    return file;
  }
};

std::string
Compress(const std::string & content)
{
  std::string packed(content.size() + 1000, '\0');
  z_stream    stream{};
  EXPECT_EQ(deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 9, Z_DEFAULT_STRATEGY), Z_OK);
  stream.next_in = reinterpret_cast<Bytef *>(const_cast<char *>(content.data()));
  stream.avail_in = static_cast<uInt>(content.size());
  stream.next_out = reinterpret_cast<Bytef *>(&packed[0]);
  stream.avail_out = static_cast<uInt>(packed.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

std::vector<int>
ReadLabels(const std::string & content)
{
  const auto image = itk::ReadLabelImage(itk::WriteTestFile("a.nii", content));
  EXPECT_EQ(image->GetLargestPossibleRegion().GetSize(), (itk::Size<2>{ { 3, 2 } }));
  return std::vector<int>(image->GetBufferPointer(), image->GetBufferPointer() + 6);
}

std::string
ReadProblem(const std::string & content)
{
  const std::string path = itk::WriteTestFile("a.nii", content);
  const auto        error = itk::ExpectInputError([&] { itk::ReadLabelImage(path); });
  EXPECT_EQ(error.GetInputFile(), path);
  EXPECT_FALSE(error.GetRemedy().empty());
  return error.GetField() + ": " + error.GetProblem();
}

itk::CephalogramFileReader::Pointer
ReadInformation(const NiftiTestFile & file)
{
  const auto reader = itk::CephalogramFileReader::New();
  reader->SetFileName(itk::WriteTestFile("ceph.nii", file.Make<unsigned char>()));
  reader->UpdateOutputInformation();
  return reader;
}

const std::vector<int> Stored{ 0, 10, 20, 30, 40, 50 };
} // namespace

TEST(NiftiPicture, LabelsAreNumbersOfEveryTypeInBothByteOrders)
{
  NiftiTestFile file;
  for (const bool isBigEndian : { false, true })
  {
    file.isBigEndian = isBigEndian;
    const auto make = [&file](short dataType, auto pixel) {
      file.dataType = dataType;
      return file.Make<decltype(pixel)>();
    };
    for (const std::string & content : { make(2, std::uint8_t{}),
                                         make(4, std::int16_t{}),
                                         make(8, std::int32_t{}),
                                         make(16, float{}),
                                         make(64, double{}),
                                         make(256, std::int8_t{}),
                                         make(512, std::uint16_t{}),
                                         make(768, std::uint32_t{}),
                                         make(1024, std::int64_t{}),
                                         make(1280, std::uint64_t{}) })
    {
      EXPECT_EQ(ReadLabels(content), Stored);
      EXPECT_EQ(ReadLabels(Compress(content)), Stored);
    }
  }
  // Of two dimensions, as ITK writes an image of two.
  file.dimensions = 2;
  EXPECT_EQ(ReadLabels(file.Make<std::uint64_t>()), Stored);
}

TEST(NiftiPicture, LabelsThatWereSqueezedIntoFewBitsAreWholeNumbersAgain)
{
  NiftiTestFile file;
  file.dataType = 4;
  file.slope = 0.5f;
  file.intercept = 1.0f;
  EXPECT_EQ(ReadLabels(file.Make<short>()), (std::vector<int>{ 1, 6, 11, 16, 21, 26 }));
  // nibabel spreads real numbers over all 65536 steps. 10 * 0.10001 is 11 ten-thousandths from 1, within half a step.
  file.slope = 0.10001f;
  file.intercept = 0.0f;
  EXPECT_EQ(ReadLabels(file.Make<short>()), (std::vector<int>{ 0, 1, 2, 3, 4, 5 }));
  file.slope = 0.11f;
  EXPECT_TRUE(Contains(ReadProblem(file.Make<short>()), "value 1.1, which is no label"));
  // Real numbers are what they are.
  file.dataType = 16;
  file.slope = 0.10001f;
  EXPECT_TRUE(Contains(ReadProblem(file.Make<float>()), "which is no label"));
  // What stands for none.
  file.slope = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(ReadLabels(file.Make<float>()), Stored);
  file.slope = 0.0f;
  file.intercept = 3.0f;
  EXPECT_EQ(ReadLabels(file.Make<float>()), Stored);
}

TEST(NiftiPicture, RowsRunDownwardsOrTheFileIsRefused)
{
  NiftiTestFile file;
  EXPECT_EQ(ReadLabels(file.Make<unsigned char>()), Stored);
  // Wherever the first pixel is.
  file.matrix[0][3] = 40.0f;
  file.matrix[1][3] = -7.0f;
  EXPECT_EQ(ReadLabels(file.Make<unsigned char>()), Stored);
  // By the quaternion (0, 0, 0, 1), half a turn about the long axis of the body.
  file.sform = 0;
  file.qform = 1;
  file.quaternion = { { 0.0f, 0.0f, 1.0f, 12.0f, -4.0f, 0.0f } };
  EXPECT_EQ(ReadLabels(file.Make<unsigned char>()), Stored);
  // Without any orientation.
  file.qform = 0;
  EXPECT_EQ(ReadLabels(file.Make<unsigned char>()), Stored);

  // Turned over, by columns or rows or both: the last pixel lies where the first one of a picture does.
  NiftiTestFile turned;
  turned.matrix[0] = { { 1.0f, 0.0f, 0.0f, -2.0f } };
  EXPECT_EQ(ReadLabels(turned.Make<unsigned char>()), (std::vector<int>{ 20, 10, 0, 50, 40, 30 }));
  turned.matrix[1] = { { 0.0f, 1.0f, 0.0f, -1.0f } };
  EXPECT_EQ(ReadLabels(turned.Make<unsigned char>()), (std::vector<int>{ 50, 40, 30, 20, 10, 0 }));
  turned.matrix[0] = Picture[0];
  EXPECT_EQ(ReadLabels(turned.Make<unsigned char>()), (std::vector<int>{ 30, 40, 50, 0, 10, 20 }));
  // The same by the quaternion of no rotation.
  turned.sform = 0;
  turned.qform = 1;
  turned.spacing = { { 0.5f, 0.25f } };
  turned.quaternion = { { 0.0f, 0.0f, 0.0f, -1.0f, -0.25f, 0.0f } };
  EXPECT_EQ(ReadLabels(turned.Make<unsigned char>()), (std::vector<int>{ 50, 40, 30, 20, 10, 0 }));

  // Axes to the right and the front from a first pixel that is elsewhere: turned over about something else, nobody
  // knows what.
  turned.sform = 1;
  turned.matrix = {
    { { { 1.0f, 0.0f, 0.0f, 40.0f } }, { { 0.0f, 1.0f, 0.0f, 0.0f } }, { { 0.0f, 0.0f, 1.0f, 0.0f } } }
  };
  EXPECT_TRUE(Contains(ReadProblem(turned.Make<unsigned char>()), "srow_x, srow_y: columns run to R and rows to A"));
  // Seen from the side: columns to the back, rows downward.
  turned.matrix = {
    { { { 0.0f, 0.0f, 1.0f, 0.0f } }, { { -1.0f, 0.0f, 0.0f, 0.0f } }, { { 0.0f, -1.0f, 0.0f, 0.0f } } }
  };
  EXPECT_TRUE(
    Contains(ReadProblem(turned.Make<unsigned char>()), "columns run to P and rows to I, which is no picture"));
  // Rows and columns exchanged.
  turned.matrix = {
    { { { 0.0f, -1.0f, 0.0f, 0.0f } }, { { -1.0f, 0.0f, 0.0f, 0.0f } }, { { 0.0f, 0.0f, 1.0f, 0.0f } } }
  };
  EXPECT_TRUE(
    Contains(ReadProblem(turned.Make<unsigned char>()), "columns run to P and rows to L, which is no picture"));
  // Oblique by two degrees.
  turned.matrix = Picture;
  turned.matrix[1][0] = 0.035f;
  EXPECT_TRUE(Contains(ReadProblem(turned.Make<unsigned char>()), "which is no picture"));
  turned.sform = 0;
  turned.quaternion = { { 0.0f, 0.0f, 0.0f, 0.0f, 40.0f, 0.0f } };
  EXPECT_TRUE(Contains(ReadProblem(turned.Make<unsigned char>()), "quatern: columns run to R and rows to A"));
}

TEST(NiftiPicture, SpacingOfARadiographIsMillimetresOfTheDetector)
{
  NiftiTestFile file;
  file.spacing = { { 0.25f, 0.5f } };
  file.matrix[0] = { { -0.25f, 0.0f, 0.0f, -3.0f } };
  file.matrix[1] = { { 0.0f, -0.5f, 0.0f, 8.0f } };
  const auto millimetres = ReadInformation(file);
  EXPECT_EQ(millimetres->GetFileFormat(), "NIfTI");
  ASSERT_TRUE(millimetres->HasPixelSpacing());
  EXPECT_EQ(millimetres->GetPixelSpacing()[0], 0.25);
  EXPECT_EQ(millimetres->GetPixelSpacing()[1], 0.5);
  ASSERT_TRUE(millimetres->HasHeaderSpacing());
  // To the left and to the back, as 3D Slicer has the markups in its files.
  EXPECT_EQ(millimetres->GetHeaderOrigin()[0], 3.0);
  EXPECT_EQ(millimetres->GetHeaderOrigin()[1], -8.0);

  file.units = 3;
  file.spacing = { { 250.0f, 500.0f } };
  EXPECT_NEAR(ReadInformation(file)->GetPixelSpacing()[0], 0.25, 1e-9);
  file.units = 1;
  file.spacing = { { 0.00025f, 0.0005f } };
  EXPECT_NEAR(ReadInformation(file)->GetPixelSpacing()[1], 0.5, 1e-6);

  // 1 is what no spacing turns into, and a negative one is none.
  file.units = 2;
  file.spacing = { { 1.0f, 1.0f } };
  EXPECT_FALSE(ReadInformation(file)->HasPixelSpacing());
  file.spacing = { { -0.25f, 0.25f } };
  EXPECT_FALSE(ReadInformation(file)->HasPixelSpacing());

  const auto reader = ReadInformation(NiftiTestFile());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetBufferPointer()[4], 40.0f);
}

TEST(NiftiPicture, AnArrayWhoseDirectionsNobodyKnewIsTakenAsItIsStored)
{
  // numpy.eye(4), with a spacing or without: no program of pictures writes it, and none that turns volumes over.
  for (const float spacing : { 1.0f, 0.25f })
  {
    NiftiTestFile file;
    file.sform = 1;
    file.matrix = {
      { { { spacing, 0.0f, 0.0f, 0.0f } }, { { 0.0f, spacing, 0.0f, 0.0f } }, { { 0.0f, 0.0f, 1.0f, 0.0f } } }
    };
    for (const std::string & content : { file.Make<unsigned char>(), Compress(file.Make<unsigned char>()) })
    {
      EXPECT_EQ(ReadLabels(content), Stored);
      const std::string    path = itk::WriteTestFile("a.nii", content);
      itk::LabelImageNotes notes;
      itk::ReadLabelImage(path, notes);
      EXPECT_TRUE(notes.isOfPlainArray);
      EXPECT_TRUE(itk::IsImageOfPlainArray(path));
    }
    const auto reader = ReadInformation(file);
    ASSERT_EQ(reader->GetWarnings().size(), 1u);
    EXPECT_TRUE(Contains(reader->GetWarnings()[0], "say nothing of how the picture lies"));
  }
  // The same by the quaternion of no rotation.
  NiftiTestFile file;
  file.sform = 0;
  file.qform = 1;
  file.quaternion = { { 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f } };
  EXPECT_EQ(ReadLabels(file.Make<unsigned char>()), Stored);
  // One that says something, and one that says nothing at all.
  itk::LabelImageNotes notes;
  itk::ReadLabelImage(itk::WriteTestFile("a.nii", NiftiTestFile().Make<unsigned char>()), notes);
  EXPECT_FALSE(notes.isOfPlainArray);
  EXPECT_FALSE(itk::IsImageOfPlainArray(itk::WriteTestFile("b.nii", "no image")));
}

TEST(NiftiPicture, BytesThatAreCutOrChangedAreRefusedOrReadButNeverCrash)
{
  const std::string plain = NiftiTestFile().Make<unsigned char>();
  for (const std::string & whole : { plain, Compress(plain) })
  {
    for (std::size_t size = 0; size < whole.size(); ++size)
    {
      const std::string path = itk::WriteTestFile("cut.nii.gz", whole.substr(0, size));
      EXPECT_THROW(itk::ReadLabelImage(path), itk::DentalInputError) << size;
    }
    unsigned int read = 0;
    for (std::size_t at = 0; at < whole.size(); ++at)
    {
      for (const char flip : { '\x01', '\x80', '\xff' })
      {
        std::string changed = whole;
        changed[at] = static_cast<char>(changed[at] ^ flip);
        const std::string path = itk::WriteTestFile("changed.nii.gz", changed);
        try
        {
          EXPECT_EQ(itk::ReadLabelImage(path)->GetLargestPossibleRegion().GetNumberOfPixels() > 0, true);
          ++read;
        }
        catch (const itk::DentalInputError &)
        {}
      }
    }
    // Most of a header is for volumes and for text, and means nothing here; of gzip's head alone a few bytes do not.
    EXPECT_GT(read, 0u);
  }
}

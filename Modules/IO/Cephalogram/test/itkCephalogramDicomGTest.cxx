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

#include "itkTestFile.h"
#include "itkDicomTestFile.h"

#include "itkGDCMImageIO.h"
#include "itkImageFileWriter.h"

#include <gtest/gtest.h>

#include <sstream>

using itk::CephalogramFileReader;
using itk::DicomTestFile;
using Verdict = itk::PixelSpacingVerdictEnum;
using Plane = itk::SpacingPlaneEnum;

namespace
{
CephalogramFileReader::Pointer
Read(const DicomTestFile & file)
{
  const auto reader = CephalogramFileReader::New();
  reader->SetFileName(itk::WriteTestFile("ceph.dcm", file.GetBytes()));
  reader->Update();
  EXPECT_EQ(reader->GetFileFormat(), "DICOM");
  return reader;
}

float
GetPixel(const CephalogramFileReader * reader, itk::IndexValueType column, itk::IndexValueType row)
{
  return reader->GetOutput()->GetPixel({ { column, row } });
}
} // namespace

/** Rows of the measured table: what the plain reader makes of them stands there. */
TEST(CephalogramDicom, ImagerPixelSpacingAloneIsTheDetectors)
{
  const auto reader = Read(DicomTestFile().SetImagerPixelSpacing("0.1\\0.2"));
  EXPECT_EQ(reader->GetPixelSpacingVerdict(), Verdict::Detector);
  EXPECT_EQ(reader->GetSpacingPlane(), Plane::Detector);
  EXPECT_EQ(reader->GetPixelSpacing()[0], 0.2);
  EXPECT_EQ(reader->GetPixelSpacing()[1], 0.1);
  EXPECT_EQ(reader->GetOutput()->GetSpacing()[0], 0.2);
  // No distance is needed for what is the detector's already.
  EXPECT_EQ(reader->GetDetectorPixelSpacing(0.0, 0.0)[0], 0.2);
  EXPECT_TRUE(itk::Contains(reader->GetProvenance().at("pixel_spacing"), "(0018,1164) 0.1\\0.2"));
  EXPECT_TRUE(reader->GetWarnings().empty());
}

TEST(CephalogramDicom, CalibratedPixelSpacingWinsOverTheImagers)
{
  const auto reader = Read(DicomTestFile()
                             .SetImagerPixelSpacing("0.1\\0.2")
                             .SetPixelSpacing("0.09\\0.18")
                             .SetMagnificationFactor("1.11")
                             .Set(0x0028, 0x0a02, "CS", "FIDUCIAL")
                             .Set(0x0028, 0x0a04, "LO", "ruler at the nose"));
  EXPECT_EQ(reader->GetPixelSpacingVerdict(), Verdict::Calibrated);
  EXPECT_EQ(reader->GetSpacingPlane(), Plane::Midsagittal);
  EXPECT_EQ(reader->GetPixelSpacing()[0], 0.18);
  EXPECT_EQ(reader->GetPixelSpacing()[1], 0.09);
  EXPECT_TRUE(itk::Contains(reader->GetProvenance().at("pixel_spacing"), "ruler at the nose"));
}

TEST(CephalogramDicom, DifferentSpacingsWithoutAStatementAreUnknown)
{
  const auto reader = Read(
    DicomTestFile().SetImagerPixelSpacing("0.1\\0.2").SetPixelSpacing("0.09\\0.18").SetMagnificationFactor("1.11"));
  EXPECT_EQ(reader->GetPixelSpacingVerdict(), Verdict::Unknown);
  EXPECT_FALSE(reader->HasPixelSpacing());
  EXPECT_THROW(reader->GetPixelSpacing(), itk::ExceptionObject);
}

TEST(CephalogramDicom, PixelSpacingAloneIsUnknownAndNever1)
{
  for (const auto & [sopClass, modality] :
       { std::make_pair(DicomTestFile::DX, "DX"), std::make_pair(DicomTestFile::SC, "OT") })
  {
    const auto reader = Read(DicomTestFile(sopClass, modality).SetPixelSpacing("0.09\\0.18"));
    EXPECT_EQ(reader->GetPixelSpacingVerdict(), Verdict::Unknown);
    EXPECT_EQ(reader->GetSpacingPlane(), Plane::Unknown);
    EXPECT_FALSE(reader->HasPixelSpacing());
    EXPECT_THROW(reader->GetPixelSpacing(), itk::ExceptionObject);
    EXPECT_THROW(reader->GetDetectorPixelSpacing(1674.0, 1524.0), itk::ExceptionObject);
    // The picture's own spacing is then a pixel.
    EXPECT_EQ(reader->GetOutput()->GetSpacing()[0], 1.0);
    EXPECT_TRUE(itk::Contains(reader->GetProvenance().at("pixel_spacing"), "0.09\\0.18"));
  }
}

TEST(CephalogramDicom, NoSpacingIsUnknown)
{
  const auto reader = Read(DicomTestFile(DicomTestFile::CR, "CR"));
  EXPECT_EQ(reader->GetPixelSpacingVerdict(), Verdict::Unknown);
  try
  {
    reader->GetPixelSpacing();
    FAIL();
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_TRUE(itk::Contains(error.GetDescription(), "SetUserPixelSpacing()"));
  }
}

TEST(CephalogramDicom, MagnificationFactorDividesTheImagers)
{
  const auto reader =
    Read(DicomTestFile().SetImagerPixelSpacing("0.11\\0.22").SetMagnificationFactor("1.1").SetSourceToDetector("1650"));
  EXPECT_EQ(reader->GetPixelSpacingVerdict(), Verdict::EstimatedMagnification);
  EXPECT_EQ(reader->GetSpacingPlane(), Plane::Midsagittal);
  EXPECT_DOUBLE_EQ(reader->GetPixelSpacing()[0], 0.2);
  EXPECT_DOUBLE_EQ(reader->GetPixelSpacing()[1], 0.1);
  // With the file's own distances the detector's spacing comes back.
  ASSERT_TRUE(reader->HasSourceToMidsagittalDistance());
  EXPECT_DOUBLE_EQ(reader->GetSourceToMidsagittalDistance(), 1500.0);
  const auto spacing =
    reader->GetDetectorPixelSpacing(reader->GetSourceToDetectorDistance(), reader->GetSourceToMidsagittalDistance());
  EXPECT_DOUBLE_EQ(spacing[0], 0.22);
  EXPECT_DOUBLE_EQ(spacing[1], 0.11);
  // The detector's pixels do not change with what is known of the distances.
  EXPECT_EQ(reader->GetDetectorPixelSpacing(1674.0, 1524.0)[0], 0.22);
  EXPECT_EQ(reader->GetDetectorPixelSpacing(1800.0, 1500.0)[1], 0.11);
  EXPECT_THROW(reader->GetDetectorPixelSpacing(1500.0, 1650.0), itk::ExceptionObject);
  EXPECT_THROW(reader->GetDetectorPixelSpacing(0.0, 0.0), itk::ExceptionObject);
}

TEST(CephalogramDicom, EqualSpacingsAreTheDetectors)
{
  const auto reader = Read(DicomTestFile().SetImagerPixelSpacing("0.10\\0.10").SetPixelSpacing("0.1\\1.0E-1"));
  EXPECT_EQ(reader->GetPixelSpacingVerdict(), Verdict::Detector);
  EXPECT_EQ(reader->GetPixelSpacing()[0], 0.1);
}

TEST(CephalogramDicom, TheUserOverridesTheFile)
{
  const auto reader = CephalogramFileReader::New();
  reader->SetFileName(itk::WriteTestFile("ceph.dcm", DicomTestFile().SetPixelSpacing("0.09\\0.18").GetBytes()));
  CephalogramFileReader::PixelSpacingType spacing;
  spacing[0] = 0.3;
  spacing[1] = 0.4;
  reader->SetUserPixelSpacing(spacing, Plane::Midsagittal);
  reader->UpdateOutputInformation();
  EXPECT_EQ(reader->GetPixelSpacingVerdict(), Verdict::UserGiven);
  EXPECT_EQ(reader->GetPixelSpacing(), spacing);
  EXPECT_EQ(reader->GetOutput()->GetSpacing()[1], 0.4);
  EXPECT_DOUBLE_EQ(reader->GetDetectorPixelSpacing(1650.0, 1500.0)[0], 0.33);
  EXPECT_TRUE(itk::Contains(reader->GetProvenance().at("pixel_spacing"), "given by the user"));
  reader->ClearUserPixelSpacing();
  reader->UpdateOutputInformation();
  EXPECT_EQ(reader->GetPixelSpacingVerdict(), Verdict::Unknown);

  EXPECT_THROW(reader->SetUserPixelSpacing(spacing, Plane::Unknown), itk::ExceptionObject);
  spacing[1] = 0.0;
  EXPECT_THROW(reader->SetUserPixelSpacing(spacing), itk::ExceptionObject);
}

TEST(CephalogramDicom, UnusableSpacingsAreWarnedOfAndNotUsed)
{
  for (const char * text : { "0\\0", "-0.1\\0.1", "0.1", "abc\\0.1", "0.1\\0.1\\0.1", "0,1\\0,1", "NaN\\NaN" })
  {
    const auto reader = Read(DicomTestFile().SetImagerPixelSpacing(text));
    EXPECT_EQ(reader->GetPixelSpacingVerdict(), Verdict::Unknown) << text;
    ASSERT_EQ(reader->GetWarnings().size(), 1u) << text;
    EXPECT_TRUE(itk::Contains(reader->GetWarnings()[0], "(0018,1164)"));
  }
  // A placeholder of 1 mm is taken at its word, but not silently.
  EXPECT_EQ(Read(DicomTestFile().SetImagerPixelSpacing("2\\2"))->GetWarnings().size(), 1u);
}

TEST(CephalogramDicom, DistancesNeedBothTags)
{
  const auto both = Read(DicomTestFile().SetSourceToDetector("1674").SetMagnificationFactor("1.1"));
  EXPECT_EQ(both->GetSourceToDetectorDistance(), 1674.0);
  EXPECT_DOUBLE_EQ(both->GetSourceToMidsagittalDistance(), 1674.0 / 1.1);
  EXPECT_EQ(both->GetMagnificationFactor(), 1.1);
  EXPECT_TRUE(itk::Contains(both->GetProvenance().at("source_to_midsagittal"), "(0018,1114) 1.1"));

  const auto detectorOnly = Read(DicomTestFile().SetSourceToDetector("1674"));
  EXPECT_TRUE(detectorOnly->HasSourceToDetectorDistance());
  EXPECT_FALSE(detectorOnly->HasSourceToMidsagittalDistance());
  EXPECT_THROW(detectorOnly->GetSourceToMidsagittalDistance(), itk::ExceptionObject);

  const auto factorOnly = Read(DicomTestFile().SetMagnificationFactor("1.1"));
  EXPECT_FALSE(factorOnly->HasSourceToDetectorDistance());
  EXPECT_FALSE(factorOnly->HasSourceToMidsagittalDistance());
  EXPECT_THROW(factorOnly->GetSourceToDetectorDistance(), itk::ExceptionObject);
}

TEST(CephalogramDicom, DistanceToThePatientIsReportedAndNeverUsed)
{
  const auto reader = Read(DicomTestFile().SetSourceToDetector("1674").Set(0x0018, 0x1111, "DS", "1500"));
  EXPECT_FALSE(reader->HasSourceToMidsagittalDistance());
  EXPECT_FALSE(reader->HasMagnificationFactor());
  EXPECT_TRUE(itk::Contains(reader->GetProvenance().at("distance_source_to_patient"), "1500"));
}

/** 113 per cent is a factor of 1.13; a factor of 3 is no cephalostat's. */
TEST(CephalogramDicom, AFactorInPerCentIsReadAsOne)
{
  const auto reader = Read(
    DicomTestFile().SetImagerPixelSpacing("0.113\\0.113").SetSourceToDetector("1695").SetMagnificationFactor("113"));
  EXPECT_DOUBLE_EQ(reader->GetMagnificationFactor(), 1.13);
  EXPECT_DOUBLE_EQ(reader->GetSourceToMidsagittalDistance(), 1500.0);
  EXPECT_NEAR(reader->GetPixelSpacing()[0], 0.1, 1e-12);
  ASSERT_EQ(reader->GetWarnings().size(), 1u);
  EXPECT_TRUE(itk::Contains(reader->GetWarnings().front(), "per cent"));
  for (const char * factor : { "3", "99", "151" })
  {
    const auto other = Read(DicomTestFile().SetImagerPixelSpacing("0.1\\0.1").SetMagnificationFactor(factor));
    EXPECT_FALSE(other->HasMagnificationFactor()) << factor;
    ASSERT_EQ(other->GetWarnings().size(), 1u) << factor;
    EXPECT_TRUE(itk::Contains(other->GetWarnings().front(), "ignored")) << factor;
  }
}

TEST(CephalogramDicom, ImpossibleFactorsAndDistancesAreWarnedOf)
{
  for (const char * factor : { "1", "0.943", "0", "-1" })
  {
    const auto reader = Read(
      DicomTestFile().SetImagerPixelSpacing("0.1\\0.1").SetSourceToDetector("1674").SetMagnificationFactor(factor));
    EXPECT_FALSE(reader->HasMagnificationFactor()) << factor;
    EXPECT_FALSE(reader->HasSourceToMidsagittalDistance()) << factor;
    EXPECT_EQ(reader->GetPixelSpacingVerdict(), Verdict::Detector) << factor;
    EXPECT_EQ(reader->GetWarnings().size(), 1u) << factor;
  }
  EXPECT_EQ(Read(DicomTestFile().SetMagnificationFactor("1.5"))->GetWarnings().size(), 1u);
  EXPECT_FALSE(Read(DicomTestFile().SetSourceToDetector("0"))->HasSourceToDetectorDistance());
  EXPECT_EQ(Read(DicomTestFile().SetSourceToDetector("167.4"))->GetWarnings().size(), 1u);
}

TEST(CephalogramDicom, FacingComesFromThePatientOrientation)
{
  using Facing = CephalogramFileReader::FacingEnum;
  const auto right = Read(DicomTestFile().Set(0x0020, 0x0020, "CS", "A\\F"));
  ASSERT_TRUE(right->HasFacing());
  EXPECT_EQ(right->GetFacing(), Facing::Right);
  EXPECT_TRUE(itk::Contains(right->GetProvenance().at("facing"), "(0020,0020)"));
  const auto left = Read(DicomTestFile().Set(0x0020, 0x0020, "CS", "P\\F"));
  ASSERT_TRUE(left->HasFacing());
  EXPECT_EQ(left->GetFacing(), Facing::Left);
  EXPECT_TRUE(left->GetWarnings().empty());
  for (const char * orientation : { "L\\H", "A\\H", "A", "F\\A", "\\F" })
  {
    const auto reader = Read(DicomTestFile().Set(0x0020, 0x0020, "CS", orientation));
    EXPECT_FALSE(reader->HasFacing()) << orientation;
    EXPECT_THROW(reader->GetFacing(), itk::ExceptionObject);
    EXPECT_EQ(reader->GetWarnings().size(), 1u) << orientation;
  }
  EXPECT_FALSE(Read(DicomTestFile())->HasFacing());
}

TEST(CephalogramDicom, AFrontalRadiographSaysSoInItsTags)
{
  using Direction = CephalogramFileReader::DirectionEnum;
  using Left = CephalogramFileReader::PatientLeftEnum;
  using FrontalSource = CephalogramFileReader::FrontalSourceEnum;
  // Postero-anterior as one faces the patient, and antero-posterior seen from behind.
  const auto pa = Read(DicomTestFile().Set(0x0018, 0x5101, "CS", "PA").Set(0x0020, 0x0020, "CS", "L\\F"));
  ASSERT_TRUE(pa->HasRadiographDirection() && pa->HasPatientLeft() && pa->HasFrontalSource());
  EXPECT_EQ(pa->GetRadiographDirection(), Direction::Frontal);
  EXPECT_EQ(pa->GetPatientLeft(), Left::Right);
  EXPECT_EQ(pa->GetFrontalSource(), FrontalSource::Behind);
  EXPECT_FALSE(pa->HasFacing());
  EXPECT_TRUE(itk::Contains(pa->GetProvenance().at("direction"), "(0018,5101) PA"));
  EXPECT_TRUE(itk::Contains(pa->GetProvenance().at("patient_left"), "(0020,0020)"));
  EXPECT_TRUE(pa->GetWarnings().empty());
  const auto ap = Read(DicomTestFile().Set(0x0018, 0x5101, "CS", "AP").Set(0x0020, 0x0020, "CS", "R\\F"));
  EXPECT_EQ(ap->GetPatientLeft(), Left::Left);
  EXPECT_EQ(ap->GetFrontalSource(), FrontalSource::InFront);
  // The orientation alone tells the direction, and so does a lateral position.
  EXPECT_EQ(Read(DicomTestFile().Set(0x0020, 0x0020, "CS", "R\\F"))->GetRadiographDirection(), Direction::Frontal);
  EXPECT_EQ(Read(DicomTestFile().Set(0x0020, 0x0020, "CS", "A\\F"))->GetRadiographDirection(), Direction::Lateral);
  EXPECT_EQ(Read(DicomTestFile().Set(0x0018, 0x5101, "CS", "LL"))->GetRadiographDirection(), Direction::Lateral);
  const auto silent = Read(DicomTestFile());
  EXPECT_FALSE(silent->HasRadiographDirection());
  EXPECT_THROW(silent->GetRadiographDirection(), itk::ExceptionObject);
  EXPECT_THROW(silent->GetPatientLeft(), itk::ExceptionObject);
  EXPECT_THROW(silent->GetFrontalSource(), itk::ExceptionObject);
}

TEST(CephalogramDicom, PixelsAreWhereTheyBelong)
{
  const auto reader = Read(DicomTestFile());
  EXPECT_EQ(reader->GetOutput()->GetLargestPossibleRegion().GetSize()[0], DicomTestFile::Columns + 0u);
  EXPECT_EQ(reader->GetOutput()->GetLargestPossibleRegion().GetSize()[1], DicomTestFile::Rows + 0u);
  EXPECT_EQ(GetPixel(reader, 0, 0), 0.0f);
  EXPECT_EQ(GetPixel(reader, 3, 0), 30.0f);
  EXPECT_EQ(GetPixel(reader, 7, 9), 970.0f);
}

TEST(CephalogramDicom, MONOCHROME1IsInvertedOnceAndSilently)
{
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  const auto  reader = Read(DicomTestFile().Set(0x0028, 0x0004, "CS", "MONOCHROME1"));
  const auto  output = testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr();
  const float darkest = GetPixel(reader, 0, 0);
  // Dense is bright: the ramp falls where it rose.
  EXPECT_EQ(darkest - GetPixel(reader, 7, 9), 970.0f);
  EXPECT_GE(GetPixel(reader, 7, 9), 0.0f);
  EXPECT_TRUE(itk::Contains(reader->GetProvenance().at("photometric"), "inverted"));
  EXPECT_EQ(output, "");
  EXPECT_TRUE(itk::Object::GetGlobalWarningDisplay());
}

TEST(CephalogramDicom, RescaleIsApplied)
{
  const auto reader = Read(DicomTestFile().Set(0x0028, 0x1052, "DS", "-100").Set(0x0028, 0x1053, "DS", "0.5"));
  EXPECT_EQ(GetPixel(reader, 7, 9), 385.0f);
}

TEST(CephalogramDicom, ReadsWhatITKWritesCompressedOrNot)
{
  using ImageType = itk::Image<unsigned short, 2>;
  const auto image = ImageType::New();
  image->SetRegions(ImageType::SizeType{ { 32, 24 } });
  image->Allocate();
  for (unsigned int i = 0; i < 32 * 24; ++i)
  {
    image->GetBufferPointer()[i] = static_cast<unsigned short>(5 * i);
  }
  for (const auto compression :
       { itk::GDCMImageIO::CompressionEnum::JPEG, itk::GDCMImageIO::CompressionEnum::JPEG2000 })
  {
    for (const bool compress : { false, true })
    {
      const auto io = itk::GDCMImageIO::New();
      io->SetCompressionType(compression);
      const auto writer = itk::ImageFileWriter<ImageType>::New();
      writer->SetFileName(itk::TestFolder() + "/written.dcm");
      writer->SetInput(image);
      writer->SetImageIO(io);
      writer->SetUseCompression(compress);
      writer->Update();
      const auto reader = CephalogramFileReader::New();
      reader->SetFileName(writer->GetFileName());
      reader->Update();
      // Both compressions are lossless.
      EXPECT_EQ(GetPixel(reader, 31, 23), 5.0f * (32 * 24 - 1));
      EXPECT_EQ(GetPixel(reader, 3, 7), 5.0f * (7 * 32 + 3));
      EXPECT_EQ(reader->GetPixelSpacingVerdict(), Verdict::Unknown);
    }
  }
}

TEST(CephalogramDicom, SequencesAreWalkedAndWithoutAPreambleItIsStillDicom)
{
  // A referenced image in a sequence: item and sequence with and without a length.
  const std::string inner("\x08\0\x50\x11UI\x04\0"
                          "1.2\0",
                          12);
  const std::string defined = std::string("\xfe\xff\x00\xe0\x0c\0\0\0", 8) + inner;
  const auto        reader = CephalogramFileReader::New();
  reader->SetFileName(itk::WriteTestFile(
    "sequence.dcm", DicomTestFile().SetImagerPixelSpacing("0.1\\0.1").Set(0x0008, 0x1140, "SQ", defined).GetBytes()));
  reader->Update();
  EXPECT_EQ(reader->GetPixelSpacing()[0], 0.1);
  const auto broken = CephalogramFileReader::New();
  broken->SetFileName(
    itk::WriteTestFile("broken.dcm", DicomTestFile().Set(0x0008, 0x1140, "SQ", defined.substr(0, 16)).GetBytes()));
  EXPECT_EQ(itk::ExpectInputError([&] { broken->Update(); }).GetField(), "(0008,1140)");

  const auto bare = CephalogramFileReader::New();
  bare->SetFileName(itk::WriteTestFile("bare.dcm", DicomTestFile().GetBytes(false)));
  bare->UpdateOutputInformation();
  EXPECT_EQ(bare->GetFileFormat(), "DICOM");
}

TEST(CephalogramDicom, SeveralFramesAreAnError)
{
  const auto reader = CephalogramFileReader::New();
  reader->SetFileName(
    itk::WriteTestFile("ceph.dcm", DicomTestFile().SetFrames(3).Set(0x0028, 0x0008, "IS", "3").GetBytes()));
  EXPECT_TRUE(itk::Contains(itk::ExpectInputError([&] { reader->Update(); }).GetProblem(), "3 frames"));
}

TEST(CephalogramDicom, NothingOfThePatientTravelsOn)
{
  std::ostringstream os;
  Read(DicomTestFile())->GetOutput()->GetMetaDataDictionary().Print(os);
  EXPECT_FALSE(itk::Contains(os.str(), "Test^Patient"));
  EXPECT_TRUE(itk::Contains(os.str(), CephalogramFileReader::VerdictKey));
}

TEST(CephalogramDicom, OddModalityIsWarnedOf)
{
  EXPECT_EQ(Read(DicomTestFile(DicomTestFile::DX, "CT"))->GetWarnings().size(), 1u);
}

TEST(CephalogramDicom, TruncationAnywhereIsAnInputError)
{
  const std::string bytes = DicomTestFile().SetImagerPixelSpacing("0.1\\0.1").GetBytes();
  testing::internal::CaptureStderr();
  for (std::size_t length = 0; length < bytes.size(); length += length + 40 < bytes.size() ? 7 : 1)
  {
    const auto reader = CephalogramFileReader::New();
    reader->SetFileName(itk::WriteTestFile("ceph.dcm", bytes.substr(0, length)));
    EXPECT_THROW(reader->Update(), itk::DentalInputError) << length << " of " << bytes.size();
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(CephalogramDicom, DamagedBytesNeverCrash)
{
  const std::string bytes = DicomTestFile().SetImagerPixelSpacing("0.1\\0.1").GetBytes();
  unsigned int      refused = 0;
  for (std::size_t position = 132; position < bytes.size() - 160; ++position)
  {
    std::string damaged = bytes;
    damaged[position] = static_cast<char>(damaged[position] ^ 0x5a);
    const auto reader = CephalogramFileReader::New();
    reader->SetFileName(itk::WriteTestFile("ceph.dcm", damaged));
    try
    {
      reader->Update();
    }
    catch (const itk::DentalInputError &)
    {
      ++refused;
    }
  }
  EXPECT_GT(refused, 50u);
}

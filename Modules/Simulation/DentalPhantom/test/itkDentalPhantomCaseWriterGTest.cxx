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
#include "itkDentalPhantomCaseWriter.h"

#include "itkDentalContourFileReader.h"
#include "itkDentalInputError.h"
#include "itkDentalLandmarkFileReader.h"
#include "itkJsonDocument.h"

#include "itkImageFileReader.h"
#include "itkPNGImageIO.h"
#include "itkTestingMacros.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

namespace
{
using CaseType = itk::DentalPhantomCaseSource;
using WriterType = itk::DentalPhantomCaseWriter;
namespace fs = std::filesystem;

int
ExerciseBasics(WriterType * writer)
{
  ITK_EXERCISE_BASIC_OBJECT_METHODS(writer, DentalPhantomCaseWriter, Object);
  return EXIT_SUCCESS;
}

CaseType::Pointer
SmallCase()
{
  auto source = CaseType::New();
  source->SetSeed(5);
  source->SetNumberOfTriangles(4000);
  source->MakeRadiographOff();
  return source;
}

std::string
Folder(const char * name)
{
  const std::string path = std::string(DENTALSCR_TEST_OUTPUT_DIR) + "/" + name;
  fs::remove_all(path);
  return path;
}

std::set<std::string>
Files(const std::string & folder)
{
  std::set<std::string> names;
  for (const auto & entry : fs::directory_iterator(folder))
  {
    names.insert(entry.path().filename().string());
  }
  return names;
}
} // namespace

TEST(DentalPhantomCaseWriter, HasTheBasicMethods)
{
  EXPECT_EQ(ExerciseBasics(WriterType::New()), EXIT_SUCCESS);
}

TEST(DentalPhantomCaseWriter, WritesAFolderThatReadsBackAsTheCase)
{
  const auto source = SmallCase();
  source->MakeRadiographOn();
  source->SetTracedSide(CaseType::TracedSideEnum::Left);
  const auto writer = WriterType::New();
  writer->SetCaseSource(source);
  const std::string folder = Folder("phantom-whole") + "/";
  writer->SetDirectoryName(folder);
  writer->Write();
  EXPECT_EQ(Files(folder),
            (std::set<std::string>{ "case.json",
                                    "ceph.png",
                                    "contours.json",
                                    "landmarks2d.json",
                                    "landmarks3d.json",
                                    "lower.stl",
                                    "truth.json",
                                    "upper.stl" }));
  // Binary STL: 84 + 50 n.
  EXPECT_EQ(fs::file_size(folder + "upper.stl"), 84u + 50u * source->GetMesh(0)->GetNumberOfCells());

  const auto document = itk::JsonDocument::ReadFile(folder + "case.json");
  const auto root = document.GetRoot();
  EXPECT_EQ(root.Get("traced_side").AsString(), "left");
  EXPECT_EQ(root.Get("upper").AsString(), "upper.stl");
  EXPECT_EQ(root.Get("mesh_unit").AsString(), "mm");
  EXPECT_EQ(root.Get("cephalogram").Get("facing").AsString(), "right");
  EXPECT_EQ(root.Get("cephalogram").Get("pixel_spacing_mm").AsNumbers(2, "[u, v]")[0],
            source->GetNominalGeometry()->GetPixelSpacing()[0]);
  EXPECT_EQ(root.Get("geometry").Get("source_to_detector_mm").AsNumber(), 1674.0);
  EXPECT_EQ(root.Get("geometry").Get("principal_point_px").AsNumbers(2, "[u, v]")[1],
            source->GetNominalGeometry()->GetPrincipalPoint()[1]);

  auto contours = itk::DentalContourFileReader::New();
  contours->SetFileName(folder + "contours.json");
  contours->Update();
  EXPECT_EQ(contours->GetReadImageSize(), source->GetImageSize());
  ASSERT_EQ(contours->GetUpperOutput()->GetNumberOfPoints(), 79u);
  for (itk::IdentifierType i = 0; i < 79; ++i)
  {
    EXPECT_EQ(contours->GetUpperOutput()->GetPoint(i), source->GetTracing(0)->GetPoint(i));
    EXPECT_EQ(contours->GetUpperOutput()->GetToothCode(i), source->GetTracing(0)->GetToothCode(i));
  }

  // The truth: its matrices take the 3-D landmarks of the file to the 2-D ones.
  auto solid = itk::DentalLandmarkFileReader<3>::New();
  solid->SetFileName(folder + "landmarks3d.json");
  solid->Update();
  auto flat = itk::DentalLandmarkFileReader<2>::New();
  flat->SetFileName(folder + "landmarks2d.json");
  flat->Update();
  EXPECT_EQ(solid->GetOutput()->GetNumberOfLandmarks(), 32u);
  ASSERT_EQ(flat->GetOutput()->GetNumberOfLandmarks(), 16u);
  const auto truth = itk::JsonDocument::ReadFile(folder + "truth.json");
  for (const auto & landmark : flat->GetOutput()->GetLandmarks())
  {
    EXPECT_TRUE(landmark.tooth.IsLeft());
    const auto   rows = truth.GetRoot().Get("projection_3x4").Get(landmark.name[0] == 'U' ? "upper" : "lower");
    const auto & p = solid->GetOutput()->Find(landmark.name)->point;
    double       h[3];
    for (std::size_t row = 0; row < 3; ++row)
    {
      const auto m = rows.At(row).AsNumbers(4, "a row");
      h[row] = m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3];
    }
    EXPECT_NEAR(h[0] / h[2], landmark.point[0], 1e-8);
    EXPECT_NEAR(h[1] / h[2], landmark.point[1], 1e-8);
  }

  auto image = itk::ImageFileReader<CaseType::ImageType>::New();
  image->SetImageIO(itk::PNGImageIO::New());
  image->SetFileName(folder + "ceph.png");
  image->Update();
  const auto pixels = image->GetOutput()->GetBufferedRegion();
  ASSERT_EQ(pixels.GetSize(), source->GetImageSize());
  EXPECT_TRUE(std::equal(image->GetOutput()->GetBufferPointer(),
                         image->GetOutput()->GetBufferPointer() + pixels.GetNumberOfPixels(),
                         source->GetRadiograph()->GetBufferPointer()));
}

TEST(DentalPhantomCaseWriter, TruthSaysWhatWasUsed)
{
  // The level asks for one thing and the setters for another: the parameters are those that the case was made with.
  const auto source = CaseType::New();
  source->SetLevel(itk::DentalPhantomLevel::Named("standard"));
  source->SetTracedSide(CaseType::TracedSideEnum::Left);
  source->SetFrame(CaseType::FrameEnum::CentredScanner);
  source->SetNumberOfTriangles(4000);
  source->MakeRadiographOff();
  const auto writer = WriterType::New();
  writer->SetCaseSource(source);
  const std::string folder = Folder("phantom-truth");
  writer->SetDirectoryName(folder);
  writer->Write();
  {
    const auto document = itk::JsonDocument::ReadFile(folder + "/truth.json");
    const auto root = document.GetRoot();
    const auto parameters = root.Get("parameters");
    EXPECT_EQ(parameters.Get("level").AsString(), "standard");
    EXPECT_EQ(parameters.Get("tracing").Get("side").AsString(), "left");
    EXPECT_EQ(parameters.Get("scan").Get("frame").AsString(), "centred");
    EXPECT_EQ(parameters.Get("scan").Get("triangles").AsInteger(0, 1000000), 4000);
    EXPECT_EQ(itk::JsonDocument::ReadFile(folder + "/case.json").GetRoot().Get("traced_side").AsString(), "left");
    // Crowns of one side drift by the length that the seed drew, from 10 to 20 px.
    EXPECT_EQ(root.Get("noise_px").Get("correlation_length").AsNumber(),
              itk::DentalPhantomAcquisition::Draw(source->GetSeed(), source->GetLevel()).correlationLength);
  }
  // Whole teeth drift by a length that no seed changes.
  source->SetTracedSide(CaseType::TracedSideEnum::Standard);
  writer->Write();
  const auto document = itk::JsonDocument::ReadFile(folder + "/truth.json");
  EXPECT_EQ(document.GetRoot().Get("parameters").Get("tracing").Get("side").AsString(), "standard");
  EXPECT_EQ(document.GetRoot().Get("noise_px").Get("correlation_length").AsNumber(),
            itk::DentalPhantomStandardTracing::CorrelationLength);
  EXPECT_EQ(source->GetAcquisition().correlationLength, itk::DentalPhantomStandardTracing::CorrelationLength);
}

TEST(DentalPhantomCaseWriter, TruthTellsWhatTheSourceWasToldBesideItsLevel)
{
  const auto source = SmallCase();
  const auto writer = WriterType::New();
  writer->SetCaseSource(source);
  const std::string folder = Folder("phantom-settings");
  writer->SetDirectoryName(folder);
  writer->Write();
  EXPECT_FALSE(itk::JsonDocument::ReadFile(folder + "/truth.json").GetRoot().Find("settings"))
    << "nothing but level and seed";
  source->SetToothBias(0.5);
  source->SetDropOutFraction(0.25);
  source->SetAdditionalYaw(0.01);
  source->SetAdditionalRoll(-0.02);
  source->SetMissingTeeth({ 26, 36 });
  source->SetUpperNumberOfPoints(60);
  source->SetLowerNumberOfPoints(50);
  source->StoneBaseOn();
  auto level = source->GetLevel();
  level.frontalView = true;
  source->SetLevel(level);
  writer->Write();
  const auto document = itk::JsonDocument::ReadFile(folder + "/truth.json");
  const auto settings = document.GetRoot().Get("settings");
  EXPECT_EQ(settings.Get("tooth_bias").AsNumber(), 0.5);
  EXPECT_EQ(settings.Get("drop_out_fraction").AsNumber(), 0.25);
  EXPECT_EQ(settings.Get("additional_yaw_rad").AsNumber(), 0.01);
  EXPECT_EQ(settings.Get("additional_roll_rad").AsNumber(), -0.02);
  EXPECT_EQ(settings.Get("missing_teeth").At(1).AsInteger(0, 100), 36);
  EXPECT_EQ(settings.Get("upper_number_of_points").AsInteger(0, 100), 60);
  EXPECT_EQ(settings.Get("lower_number_of_points").AsInteger(0, 100), 50);
  EXPECT_TRUE(settings.Get("stone_base").AsBoolean());
  // The frontal tracing drifts by the tracer's length whatever the lateral one's is.
  const auto noise = document.GetRoot().Get("views").Get("frontal").Get("noise_px");
  EXPECT_EQ(noise.Get("correlation_length").AsNumber(), 15.0);
  EXPECT_EQ(noise.Get("correlated").AsNumber(), source->GetLevel().correlatedNoise);
  EXPECT_NE(document.GetRoot().Get("noise_px").Get("correlation_length").AsNumber(), 15.0);
}

TEST(DentalPhantomCaseWriter, ReplacesAnEarlierCaseAndLeavesOtherFilesAlone)
{
  const std::string folder = Folder("phantom-again");
  fs::create_directory(folder);
  std::ofstream(folder + "/notes.txt") << "mine";
  std::ofstream(folder + "/case.json") << "old";
  const auto writer = WriterType::New();
  writer->SetCaseSource(SmallCase());
  writer->SetDirectoryName(folder);
  writer->SetMeshExtension("ply");
  writer->Write();
  EXPECT_EQ(Files(folder).count("notes.txt"), 1u);
  EXPECT_EQ(Files(folder).count("upper.ply"), 1u);
  EXPECT_EQ(Files(folder).count("ceph.png"), 0u);
  EXPECT_EQ(itk::JsonDocument::ReadFile(folder + "/case.json").GetRoot().Get("lower").AsString(), "lower.ply");
  for (const auto & entry : fs::directory_iterator(DENTALSCR_TEST_OUTPUT_DIR))
  {
    EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
  }
}

TEST(DentalPhantomCaseWriter, SaysWhatIsMissing)
{
  const auto writer = WriterType::New();
  EXPECT_THROW(writer->Write(), itk::ExceptionObject);
  writer->SetCaseSource(SmallCase());
  EXPECT_THROW(writer->Write(), itk::ExceptionObject);
  writer->SetDirectoryName(Folder("nowhere") + "/deeper/case");
  try
  {
    writer->Write();
    FAIL() << "no exception";
  }
  catch (const itk::DentalInputError & error)
  {
    EXPECT_NE(error.GetOneLine().find("nowhere/deeper/case"), std::string::npos) << error.GetOneLine();
  }
  EXPECT_FALSE(fs::exists(std::string(DENTALSCR_TEST_OUTPUT_DIR) + "/nowhere"));
  writer->SetMeshExtension("vtk");
  EXPECT_THROW(writer->Write(), itk::ExceptionObject);
}

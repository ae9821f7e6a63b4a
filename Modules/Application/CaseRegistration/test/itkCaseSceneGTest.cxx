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
#include "itkCaseScene.h"

#include "itkCaseRegistrationTestCase.h"
#include "itkCaseSceneFileReader.h"
#include "itkDentalInputError.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

namespace
{
namespace fs = std::filesystem;
using JawEnum = itk::ToothCode::JawEnum;
using PointType = itk::SceneDetector::PointType;

PointType
GetPoint(const itk::ScenePart & part, itk::IdentifierType id)
{
  PointType point;
  point.CastFrom(part.mesh->GetPoint(id));
  return point;
}

/** Lowest and highest pixel of what lies on a detector. */
std::array<double, 4>
ComputePixelBounds(const itk::SceneDetector & detector, const itk::ScenePart & part)
{
  std::array<double, 4> bounds{ { 1e9, 1e9, -1e9, -1e9 } };
  for (itk::IdentifierType i = 0; i < part.mesh->GetNumberOfPoints(); ++i)
  {
    const auto pixel = detector.GetPixel(GetPoint(part, i));
    bounds = { { std::min(bounds[0], pixel[0]),
                 std::min(bounds[1], pixel[1]),
                 std::max(bounds[2], pixel[0]),
                 std::max(bounds[3], pixel[1]) } };
  }
  return bounds;
}

std::array<double, 4>
ComputeBounds(const itk::DentalContour & contour)
{
  std::array<double, 4> bounds{ { 1e9, 1e9, -1e9, -1e9 } };
  for (auto it = contour.GetPoints()->Begin(); it != contour.GetPoints()->End(); ++it)
  {
    bounds = { { std::min(bounds[0], it.Value()[0]),
                 std::min(bounds[1], it.Value()[1]),
                 std::max(bounds[2], it.Value()[0]),
                 std::max(bounds[3], it.Value()[1]) } };
  }
  return bounds;
}

itk::RegistrationScene::Pointer
MakeScene(const itk::CaseResult & result)
{
  const auto source = itk::MakeCaseScene(result);
  source->Update();
  return source->GetOutput();
}

fs::path
MakeFolder(const char * name)
{
  const fs::path folder = fs::path(DENTALSCR_TEST_OUTPUT_DIR) / "scene" / name;
  fs::remove_all(folder);
  fs::create_directories(folder.parent_path());
  return folder;
}

/** One registration for all of them: they only look at it. */
const itk::CaseResult &
GetRobust()
{
  static const PhantomCase     phantom(5, PhantomCase::SideEnum::Right, 16000);
  static const itk::CaseResult result = Register(phantom);
  return result;
}
} // namespace

TEST(CaseScene, RaysOfAPoseAreStraightAndEndWhereItsLandmarksAreSeen)
{
  const auto & result = GetRobust();
  const auto   scene = MakeScene(result);
  const auto & detector = *scene->FindDetector("lateral");
  for (const auto & jaw : result.jaws)
  {
    const std::string name = ToString(jaw.first);
    const auto *      rays = scene->FindPart("lateral " + name + " rays");
    ASSERT_NE(rays, nullptr);
    ASSERT_EQ(rays->mesh->GetNumberOfPoints(), 3 * jaw.second.landmarks.size());
    for (std::size_t i = 0; i < jaw.second.landmarks.size(); ++i)
    {
      const auto source = GetPoint(*rays, 3 * i);
      const auto onScan = GetPoint(*rays, 3 * i + 1);
      const auto end = GetPoint(*rays, 3 * i + 2);
      const auto along = end - source;
      // A coordinate of a metre and a half has 1e-4 mm as a float.
      EXPECT_LT(itk::CrossProduct(onScan - source, along).GetNorm() / along.GetNorm(), 1e-3);
      const auto pixel = detector.GetPixel(end);
      EXPECT_NEAR(pixel[0], jaw.second.landmarks[i].position[0], 1e-2);
      EXPECT_NEAR(pixel[1], jaw.second.landmarks[i].position[1], 1e-2);
    }
  }
}

TEST(CaseScene, SilhouettesAreWhereTheRegistrationSawThem)
{
  for (const auto preset : { itk::CasePresetEnum::Robust, itk::CasePresetEnum::Paper })
  {
    static const PhantomCase phantom(5, PhantomCase::SideEnum::Right, 16000);
    const auto               result =
      preset == itk::CasePresetEnum::Robust ? GetRobust() : Register(phantom, itk::CasePresetEnum::Paper);
    const auto   scene = MakeScene(result);
    const auto & detector = *scene->FindDetector("lateral");
    for (const auto & jaw : result.jaws)
    {
      const std::string name = ToString(jaw.first);
      const auto        found = ComputePixelBounds(detector, *scene->FindPart("lateral " + name + " silhouette"));
      const auto        expected = ComputeBounds(*jaw.second.contours.front().second);
      for (unsigned int i = 0; i < 4; ++i)
      {
        // The paper's is of a radiograph simulated in pixels.
        EXPECT_NEAR(found[i], expected[i], preset == itk::CasePresetEnum::Robust ? 0.5 : 3.0) << name << ' ' << i;
      }
    }
  }
}

TEST(CaseScene, ReadsAFolderWhoseCaseWasInMemoryFromItsScans)
{
  const auto     made = MakeScene(GetRobust());
  const fs::path folder = MakeFolder("memory");
  itk::WriteCaseResult(GetRobust(), folder.string());
  auto reader = itk::CaseSceneFileReader::New();
  reader->SetFileName(folder.string());
  reader->Update();
  ASSERT_FALSE(reader->GetWarnings().empty());
  EXPECT_NE(reader->GetWarnings().front().find("radiograph and tracing are not shown"), std::string::npos);
  const auto * read = reader->GetOutput();
  EXPECT_EQ(read->FindPart("lateral upper tracing"), nullptr);
  for (const char * name : { "upper scan", "lower scan", "upper axis x", "lower midsagittal plane" })
  {
    const auto * one = made->FindPart(name);
    const auto * two = read->FindPart(name);
    ASSERT_NE(two, nullptr) << name;
    double bounds[2][6];
    std::copy_n(one->mesh->GetBoundingBox()->GetBounds().Begin(), 6, bounds[0]);
    std::copy_n(two->mesh->GetBoundingBox()->GetBounds().Begin(), 6, bounds[1]);
    for (unsigned int i = 0; i < 6; ++i)
    {
      EXPECT_NEAR(bounds[0][i], bounds[1][i], 2e-4) << name;
    }
  }
  // Through the same matrices, though those of the file are of the scan's own frame.
  const auto one = ComputePixelBounds(*made->FindDetector("lateral"), *made->FindPart("lateral lower silhouette"));
  const auto two = ComputePixelBounds(*read->FindDetector("lateral"), *read->FindPart("lateral lower silhouette"));
  for (unsigned int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(one[i], two[i], 0.01);
  }
}

TEST(CaseScene, SaysWhyNothingCanBeShown)
{
  const auto message = [](const fs::path & file) {
    auto reader = itk::CaseSceneFileReader::New();
    reader->SetFileName(file.string());
    try
    {
      reader->Update();
    }
    catch (const itk::DentalInputError & error)
    {
      return error.GetOneLine();
    }
    return std::string();
  };
  const fs::path         folder = MakeFolder("bare");
  itk::CaseOutputOptions options;
  options.report = false;
  itk::WriteCaseResult(GetRobust(), folder.string(), options);
  EXPECT_NE(message(folder).find("no scan of it can be shown"), std::string::npos) << message(folder);
  std::ofstream(folder / "none.json") << R"({"schema": "dentalscr-result/1", "jaws": {"upper": {"status": "failed"}}})";
  EXPECT_NE(message(folder / "none.json").find("no jaw was registered"), std::string::npos);
  std::ofstream(folder / "old.json") << R"({"schema": "dentalscr-result/0"})";
  EXPECT_NE(message(folder / "old.json").find("dentalscr-result/0"), std::string::npos);
  std::ofstream(folder / "case.json") << R"({"upper": "upper.stl"})";
  EXPECT_NE(message(folder / "case.json").find("no result of dentalscr"), std::string::npos);
  EXPECT_THROW(itk::CaseSceneFileReader::New()->Update(), itk::ExceptionObject);
}

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
#include "itkRegistrationSceneSource.h"
#include "itkMessageOfCall.h"

#include "itkSceneTestCase.h"

#include "gtest/gtest.h"

#include <cmath>
#include <set>
#include <string>

using namespace SceneTestCase;

namespace
{
using PointType = itk::SceneDetector::PointType;

PointType
GetPoint(const itk::ScenePart & part, unsigned int id)
{
  PointType point;
  point.CastFrom(part.mesh->GetPoint(id));
  return point;
}

double
DistanceFromRay(const itk::SceneDetector & detector, const PointType & through, const PointType & point)
{
  auto direction = through - detector.GetSource();
  direction.Normalize();
  return itk::CrossProduct(direction, point - detector.GetSource()).GetNorm();
}
} // namespace

TEST(RegistrationSceneSource, HasEveryPartOfEveryViewOnce)
{
  const auto source = MakeScene();
  source->Update();
  std::set<std::string> names;
  for (const auto & part : source->GetOutput()->GetParts())
  {
    EXPECT_TRUE(names.insert(part.name).second) << part.name;
    EXPECT_GT(part.mesh->GetNumberOfCells(), 0u) << part.name;
  }
  const std::set<std::string> expected{ "upper scan",
                                        "upper axis x",
                                        "upper axis y",
                                        "upper axis z",
                                        "upper axial plane",
                                        "upper midsagittal plane",
                                        "lower scan",
                                        "lower axis x",
                                        "lower axis y",
                                        "lower axis z",
                                        "lower axial plane",
                                        "lower midsagittal plane",
                                        "lateral source",
                                        "lateral central ray",
                                        "lateral detector",
                                        "lateral upper tracing",
                                        "lateral upper silhouette",
                                        "lateral upper rays",
                                        "lateral lower silhouette",
                                        "frontal source",
                                        "frontal central ray",
                                        "frontal detector",
                                        "frontal upper silhouette",
                                        "frontal lower silhouette" };
  EXPECT_EQ(names, expected);
  ASSERT_EQ(source->GetOutput()->GetDetectors().size(), 2u);
  EXPECT_EQ(source->GetOutput()->GetDetectors()[1].first, "frontal");
}

TEST(RegistrationSceneSource, PutsScansAndFramesWhereTheRegistrationDoes)
{
  const auto source = MakeScene();
  source->Update();
  const auto & scene = *source->GetOutput();
  EXPECT_EQ(GetPoint(*scene.FindPart("upper scan"), 0)[0], 40.0);
  EXPECT_EQ(GetPoint(*scene.FindPart("upper scan"), 0)[2], -48.0);
  // UMDA's origin is 2 mm below the box's own.
  const auto origin = GetPoint(*scene.FindPart("upper axis z"), 0);
  EXPECT_NEAR(origin[0], 60.0, 1e-5);
  EXPECT_NEAR(origin[1], 1.0, 1e-5);
  EXPECT_NEAR(origin[2], -42.0, 1e-5);
  EXPECT_NEAR(GetPoint(*scene.FindPart("upper axis z"), 1)[2], -22.0, 1e-5);
  EXPECT_NEAR(GetPoint(*scene.FindPart("upper axis y"), 1)[1], 21.0, 1e-5);
  for (unsigned int corner = 0; corner < 4; ++corner)
  {
    EXPECT_NEAR(GetPoint(*scene.FindPart("upper midsagittal plane"), corner)[1], 1.0, 1e-5);
    EXPECT_NEAR(GetPoint(*scene.FindPart("upper axial plane"), corner)[2], -42.0, 1e-5);
  }
}

TEST(RegistrationSceneSource, DrawsEachSilhouetteOnTheRaysThatGrazeItsScan)
{
  const auto source = MakeScene();
  source->Update();
  const auto & scene = *source->GetOutput();
  for (const char * view : { "lateral", "frontal" })
  {
    const auto & detector = *scene.FindDetector(view);
    for (const char * jaw : { "upper", "lower" })
    {
      const auto & scan = *scene.FindPart(std::string(jaw) + " scan");
      const auto & outline = *scene.FindPart(std::string(view) + ' ' + jaw + " silhouette");
      // A box's outline goes through its corners, hence each point of it is on the ray of one of them, or of an edge
      // between two whose rays it lies between.
      unsigned int corners = 0;
      for (unsigned int i = 0; i < outline.mesh->GetNumberOfPoints(); ++i)
      {
        const auto point = GetPoint(outline, i);
        // 0.3 mm before the detector.
        const double depth = (point - detector.GetSource()) * detector.GetAxis();
        EXPECT_NEAR(depth, SourceToDetector - 0.3, 1e-3);
        for (unsigned int corner = 0; corner < 8; ++corner)
        {
          // 2^-12 px is the grid of MeshSilhouette; a float has 1e-4 mm at the detector.
          corners += DistanceFromRay(detector, point, GetPoint(scan, corner)) < 1e-3 ? 1 : 0;
        }
      }
      EXPECT_GE(corners, 4u) << view << ' ' << jaw;
    }
  }
}

TEST(RegistrationSceneSource, DrawsTheTracingOnTheRaysOfItsPixels)
{
  const auto source = MakeScene();
  source->Update();
  const auto & scene = *source->GetOutput();
  const auto & detector = *scene.FindDetector("lateral");
  const auto & part = *scene.FindPart("lateral upper tracing");
  ASSERT_EQ(part.mesh->GetNumberOfPoints(), 5u);
  EXPECT_EQ(part.mesh->GetNumberOfCells(), 3u);
  const auto pixel = detector.GetPixel(GetPoint(part, 1));
  EXPECT_NEAR(pixel[0], 420.0, 1e-3);
  EXPECT_NEAR(pixel[1], 385.0, 1e-3);
  float tooth = 0.0F;
  ASSERT_TRUE(part.mesh->GetPointData(4, &tooth));
  EXPECT_EQ(tooth, 12.0F);
}

TEST(RegistrationSceneSource, RunsRaysFromTheSourceThroughLandmarksToTheirImages)
{
  const auto source = MakeScene();
  source->Update();
  const auto & scene = *source->GetOutput();
  const auto & detector = *scene.FindDetector("lateral");
  const auto & rays = *scene.FindPart("lateral upper rays");
  ASSERT_EQ(rays.mesh->GetNumberOfPoints(), 3u);
  EXPECT_LT((GetPoint(rays, 0) - detector.GetSource()).GetNorm(), 1e-3);
  EXPECT_LT(DistanceFromRay(detector, GetPoint(rays, 2), GetPoint(rays, 1)), 1e-3);
  EXPECT_NEAR(GetPoint(rays, 2)[1], SourceToDetector - SourceToMiddle, 1e-3);
  const auto & central = *scene.FindPart("lateral central ray");
  EXPECT_NEAR(GetPoint(central, 1)[0], 0.0, 1e-3);
  EXPECT_NEAR(GetPoint(central, 1)[2], 0.0, 1e-3);
}

TEST(RegistrationSceneSource, MakesTheDetectorAsLargeAsTheScaleThatWasFound)
{
  auto source = itk::RegistrationSceneSource::New();
  source->AddView(MakeLateralView(1.25));
  source->Update();
  const auto & part = *source->GetOutput()->FindPart("lateral detector");
  // 700 pixels from edge to edge; larger images of the same things are smaller pixels.
  EXPECT_NEAR((GetPoint(part, 1) - GetPoint(part, 0)).GetNorm(), 700 * Spacing / 1.25, 1e-3);
  EXPECT_NEAR((GetPoint(part, 3) - GetPoint(part, 0)).GetNorm(), 500 * Spacing / 1.25, 1e-3);
  EXPECT_LT(part.opacity, 1.0);
}

TEST(RegistrationSceneSource, KeepsARadiographsPixelsInTheirPlaces)
{
  auto source = itk::RegistrationSceneSource::New();
  auto view = MakeLateralView();
  view.radiograph = MakeRadiograph(50, 70).GetPointer();
  source->AddView(view);
  // Blocks of 5 x 5, and of the width's 50 pixels all are used; the height's last block too.
  source->SetMaximumPictureSize(16);
  source->Update();
  const auto & part = *source->GetOutput()->FindPart("lateral detector");
  ASSERT_TRUE(part.picture.IsNotNull());
  EXPECT_EQ(part.picture->GetBufferedRegion().GetSize()[0], 10u);
  EXPECT_EQ(part.picture->GetBufferedRegion().GetSize()[1], 14u);
  // The picture's own size goes before the stated one.
  EXPECT_NEAR((GetPoint(part, 1) - GetPoint(part, 0)).GetNorm(), 50 * Spacing, 1e-3);
  EXPECT_FLOAT_EQ(part.pictureCoordinates[2][0], 1.0F);
  EXPECT_FLOAT_EQ(part.pictureCoordinates[2][1], 1.0F);
  EXPECT_LT(part.picture->GetPixel({ { 0, 0 } }), 10);
  EXPECT_GT(part.picture->GetPixel({ { 9, 13 } }), 245);
  // Rows count ten times what columns do.
  EXPECT_GT(part.picture->GetPixel({ { 0, 13 } }), part.picture->GetPixel({ { 9, 0 } }) + 100);

  view.radiograph = MakeRadiograph(50, 68).GetPointer();
  source->ClearViews();
  source->AddView(view);
  source->Update();
  const auto & cut = *source->GetOutput()->FindPart("lateral detector");
  EXPECT_EQ(cut.picture->GetBufferedRegion().GetSize()[1], 14u);
  // 68 of the 70 rows that fourteen blocks hold.
  EXPECT_FLOAT_EQ(cut.pictureCoordinates[2][1], 68.0F / 70.0F);
}

TEST(RegistrationSceneSource, CoversWhatIsSeenWhereNobodyKnowsTheImagesSize)
{
  auto source = itk::RegistrationSceneSource::New();
  auto view = MakeLateralView();
  view.imageSize = { { 0, 0 } };
  view.jaws[JawEnum::Upper].tracing = MakeTracing().GetPointer();
  source->AddView(view);
  source->Update();
  const auto & detector = *source->GetOutput()->FindDetector("lateral");
  const auto & part = *source->GetOutput()->FindPart("lateral detector");
  const auto   first = detector.GetPixel(GetPoint(part, 0));
  const auto   last = detector.GetPixel(GetPoint(part, 2));
  // From the principal point at (200, 200) to the tracing's end at (440, 390).
  EXPECT_LT(first[0], 200.0);
  EXPECT_LT(first[1], 200.0);
  EXPECT_GT(last[0], 440.0);
  EXPECT_GT(last[1], 390.0);
  EXPECT_LT(last[0], 500.0);
}

TEST(RegistrationSceneSource, RunsOnceAndAgainWhenSomethingChanges)
{
  const auto   source = MakeScene();
  unsigned int runs = 0;
  source->AddObserver(itk::StartEvent(), [&runs](const itk::EventObject &) { ++runs; });
  source->Update();
  source->Update();
  EXPECT_EQ(runs, 1u);
  source->SetMaximumPictureSize(64);
  source->Update();
  EXPECT_EQ(runs, 2u);
  // A scan is an input of the pipeline.
  const_cast<MeshType *>(source->GetScan(JawEnum::Lower))->Modified();
  source->Update();
  EXPECT_EQ(runs, 3u);
}

TEST(RegistrationSceneSource, NamesWhatIsMissingOrWrong)
{
  const auto message = [](itk::RegistrationSceneSource * source) {
    return itk::MessageOfCall([&] { source->Update(); });
  };
  EXPECT_NE(message(itk::RegistrationSceneSource::New()).find("SetScan()"), std::string::npos);
  auto two = itk::RegistrationSceneSource::New();
  two->AddView(MakeLateralView());
  two->AddView(MakeLateralView());
  EXPECT_NE(message(two).find("\"lateral\""), std::string::npos);
  auto none = itk::RegistrationSceneSource::New();
  auto view = MakeLateralView();
  view.sourceToDetector = 0.0;
  none->AddView(view);
  EXPECT_NE(message(none).find("source-to-detector"), std::string::npos);
  auto stretched = itk::RegistrationSceneSource::New();
  auto twice = MakeShift(0.0, 0.0, 0.0);
  twice[0] = 2.0;
  stretched->SetScan(JawEnum::Upper, MakeBox(1.0, 1.0, 1.0), twice, MakeShift(0.0, 0.0, 0.0));
  EXPECT_NE(message(stretched).find("rigid"), std::string::npos);
}

TEST(RegistrationSceneSource, DefaultsAreThoseOfTheDocumentation)
{
  const auto source = itk::RegistrationSceneSource::New();
  EXPECT_EQ(source->GetMaximumPictureSize(), 2048u);
  EXPECT_TRUE(source->GetViews().empty());
}

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
#include "itkToothCrownFilter.h"
#include "itkMessageOfCall.h"

#include "itkDentalPhantomCaseSource.h"
#include "itkUMidlineDentalAxisFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{
using FilterType = itk::ToothCrownFilter;
using JawEnum = itk::ToothCode::JawEnum;

/** Crowns of incisors and first molars of a phantom, whose teeth are labelled. */
struct Phantom
{
  explicit Phantom(std::uint64_t seed)
    : source(itk::DentalPhantomCaseSource::New())
    , axis(itk::UMidlineDentalAxisFilter<FilterType::MeshType>::New())
    , filter(FilterType::New())
    , landmarks(itk::DentalLandmarkSet<3>::New())
  {
    source->SetSeed(seed);
    source->SetLevel(itk::DentalPhantomLevel::Named("standard"));
    source->SetNumberOfTriangles(12000);
    source->SetMakeRadiograph(false);
    source->Update();
    axis->SetUpperMesh(source->GetMesh(0));
    axis->SetLowerMesh(source->GetMesh(1));
    axis->RefineMidlineOn();
    axis->TransformMeshesOff();
    axis->Update();
    for (unsigned int jaw = 0; jaw < 2; ++jaw)
    {
      for (auto it = source->GetMesh(jaw)->GetPointData()->Begin(); it != source->GetMesh(jaw)->GetPointData()->End();
           ++it)
      {
        labels[jaw].push_back(static_cast<std::uint8_t>(it.Value()));
      }
      for (const auto & landmark : source->GetLandmarks3D(jaw)->GetLandmarks())
      {
        landmarks->AddLandmark(landmark.name, landmark.point);
      }
    }
    filter->SetUpperMesh(source->GetMesh(0));
    filter->SetLowerMesh(source->GetMesh(1));
    filter->SetUpperFrame(axis->GetUpperTransformOutput());
    filter->SetLowerFrame(axis->GetLowerTransformOutput());
    filter->SetUpperContour(MakeTracing(11, 16));
    filter->SetLowerContour(MakeTracing(41, 36));
  }

  static itk::DentalContour::Pointer
  MakeTracing(std::uint8_t incisor, std::uint8_t molar)
  {
    auto tracing = itk::DentalContour::New();
    for (const std::uint8_t fdi : { incisor, molar })
    {
      const double place[2] = { static_cast<double>(fdi), 0.0 };
      tracing->AddPolyline({ itk::DentalContour::PointType(place) }, itk::ToothCode(fdi));
    }
    return tracing;
  }

  /** Middle and half width along x in the jaw's dental frame. */
  std::pair<double, double>
  Extent(const itk::ToothCrownSet::CrownType & crown) const
  {
    const auto * frame =
      (crown.tooth.GetJaw() == JawEnum::Upper ? axis->GetUpperTransformOutput() : axis->GetLowerTransformOutput())
        ->Get();
    double low = 1e300, high = -1e300;
    for (const auto & p : crown.surface->points)
    {
      const auto q = frame->TransformPoint(itk::Point<double, 3>(p.data()));
      low = std::min(low, q[0]);
      high = std::max(high, q[0]);
    }
    return { 0.5 * (low + high), 0.5 * (high - low) };
  }

  itk::DentalPhantomCaseSource::Pointer                        source;
  itk::UMidlineDentalAxisFilter<FilterType::MeshType>::Pointer axis;
  FilterType::Pointer                                          filter;
  itk::DentalLandmarkSet<3>::Pointer                           landmarks;
  std::vector<std::uint8_t>                                    labels[2];
};
} // namespace

TEST(ToothCrownFilter, CutsOutBothSidesTeethByLabels)
{
  const Phantom phantom(9001);
  phantom.filter->SetLabels(JawEnum::Upper, phantom.labels[0]);
  phantom.filter->SetLabels(JawEnum::Lower, phantom.labels[1]);
  phantom.filter->Update();
  std::vector<unsigned int> teeth;
  for (const auto & crown : phantom.filter->GetOutput()->GetCrowns())
  {
    teeth.push_back(crown.tooth.GetFDI());
    EXPECT_EQ(crown.source, "tooth labels");
    // A first molar is 10 to 11 mm long, an incisor 5 to 8 mm thick at the gingiva.
    const double half = phantom.Extent(crown).second;
    EXPECT_GT(half, 2.0) << crown.tooth.GetName();
    EXPECT_LT(half, 6.5) << crown.tooth.GetName();
  }
  EXPECT_EQ(teeth, (std::vector<unsigned int>{ 11, 16, 21, 26, 31, 36, 41, 46 }));
  EXPECT_TRUE(phantom.filter->GetMissing().empty());
}

TEST(ToothCrownFilter, LandmarksAndPlacesAlongTheArchCutWhereLabelsDo)
{
  double worst[2] = { 0.0, 0.0 };
  for (std::uint64_t seed = 9001; seed < 9005; ++seed)
  {
    const Phantom labelled(seed);
    labelled.filter->SetLabels(JawEnum::Upper, labelled.labels[0]);
    labelled.filter->SetLabels(JawEnum::Lower, labelled.labels[1]);
    labelled.filter->Update();
    for (const bool byLandmarks : { false, true })
    {
      const Phantom phantom(seed);
      if (byLandmarks)
      {
        phantom.filter->SetScanLandmarks(phantom.landmarks);
      }
      phantom.filter->Update();
      for (const auto & crown : phantom.filter->GetOutput()->GetCrowns())
      {
        EXPECT_EQ(crown.source, byLandmarks ? "landmarks_3d" : "its place along the arch");
        const auto * truth = labelled.filter->GetOutput()->Find(crown.tooth);
        ASSERT_NE(truth, nullptr);
        const double error = phantom.Extent(crown).first - labelled.Extent(*truth).first;
        // Within three of the standard deviations that it says.
        EXPECT_LT(std::abs(error), 3.0 * crown.sigmaAlong) << seed << ' ' << crown.tooth.GetName();
        worst[byLandmarks ? 1 : 0] = std::max(worst[byLandmarks ? 1 : 0], std::abs(error));
      }
      EXPECT_EQ(phantom.filter->GetOutput()->GetCrowns().size(), 8u);
    }
  }
  // A textbook fits regular arches; cusps that somebody clicked fit any.
  EXPECT_LT(worst[0], 1.5);
  EXPECT_LT(worst[1], 1.5);
}

TEST(ToothCrownFilter, LabelsThatLackAToothSayThatItIsNotThere)
{
  Phantom phantom(9002);
  std::replace(phantom.labels[0].begin(), phantom.labels[0].end(), std::uint8_t{ 26 }, std::uint8_t{ 0 });
  phantom.filter->SetLabels(JawEnum::Upper, phantom.labels[0]);
  phantom.filter->SetExcludedTeeth({ itk::ToothCode(11) });
  phantom.filter->Update();
  EXPECT_EQ(phantom.filter->GetOutput()->Find(itk::ToothCode(26)), nullptr);
  EXPECT_EQ(phantom.filter->GetOutput()->Find(itk::ToothCode(11)), nullptr);
  EXPECT_NE(phantom.filter->GetOutput()->Find(itk::ToothCode(16)), nullptr);
  ASSERT_EQ(phantom.filter->GetMissing().size(), 1u);
  EXPECT_EQ(phantom.filter->GetMissing()[0].GetName(), "UL6");
}

TEST(ToothCrownFilter, LandmarksOfBothNeighboursSayThatAToothIsNotThere)
{
  // UL6 was lost, UL5 and UL7 have landmarks: at its place another tooth stands, whatever a textbook says.
  for (const bool secondMolar : { true, false })
  {
    Phantom phantom(9002);
    auto    some = itk::DentalLandmarkSet<3>::New();
    for (const auto & landmark : phantom.landmarks->GetLandmarks())
    {
      const unsigned int fdi = landmark.tooth.GetFDI();
      if (fdi != 26 && (fdi != 27 || secondMolar))
      {
        some->AddLandmark(landmark.name, landmark.point);
      }
    }
    phantom.filter->SetScanLandmarks(some);
    phantom.filter->Update();
    // Where the teeth behind have no landmarks either, nobody looked there.
    EXPECT_EQ(phantom.filter->GetOutput()->Find(itk::ToothCode(26)) == nullptr, secondMolar);
    EXPECT_EQ(phantom.filter->GetMissing().size(), secondMolar ? 1u : 0u);
    EXPECT_NE(phantom.filter->GetOutput()->Find(itk::ToothCode(16)), nullptr);
  }
}

TEST(ToothCrownFilter, AnIncisorThatWasCutHasItsMiddleForAProfile)
{
  const Phantom labelled(9003);
  labelled.filter->SetLabels(JawEnum::Upper, labelled.labels[0]);
  labelled.filter->SetLabels(JawEnum::Lower, labelled.labels[1]);
  labelled.filter->Update();
  const Phantom cut(9003);
  cut.filter->SetScanLandmarks(cut.landmarks);
  cut.filter->Update();
  const auto area = [](const itk::TriangleSurface & surface) { return static_cast<double>(surface.triangles.size()); };
  for (const auto & crown : cut.filter->GetOutput()->GetCrowns())
  {
    EXPECT_EQ(crown.profile != nullptr, crown.tooth.GetPosition() == 1) << crown.tooth.GetName();
    if (crown.profile != nullptr)
    {
      // Six tenths of its width.
      EXPECT_LT(area(*crown.profile), 0.75 * area(*crown.surface)) << crown.tooth.GetName();
      EXPECT_GT(area(*crown.profile), 0.3 * area(*crown.surface)) << crown.tooth.GetName();
    }
    EXPECT_EQ(labelled.filter->GetOutput()->Find(crown.tooth)->profile, nullptr) << crown.tooth.GetName();
  }
}

TEST(ToothCrownFilter, MissingInputsNameTheCallToMake)
{
  const auto message = [](FilterType * filter) -> std::string { return itk::MessageOfCall([&] { filter->Update(); }); };
  auto       filter = FilterType::New();
  EXPECT_NE(message(filter).find("SetUpperMesh()"), std::string::npos);
  filter->SetUpperContour(Phantom::MakeTracing(11, 16));
  filter->SetUpperMesh(FilterType::MeshType::New());
  EXPECT_NE(message(filter).find("SetUpperFrame()"), std::string::npos);
}

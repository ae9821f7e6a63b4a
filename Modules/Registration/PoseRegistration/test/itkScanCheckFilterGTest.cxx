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
#include "itkScanCheckFilter.h"

#include "itkDentalPhantomCaseSource.h"
#include "itkTriangleCell.h"
#include "itkUMidlineDentalAxisFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace
{
using FilterType = itk::ScanCheckFilter;
using MeshType = FilterType::MeshType;
using PointType = MeshType::PointType;
using JawEnum = itk::ToothCode::JawEnum;

MeshType::Pointer
Copy(const MeshType * mesh, const std::function<PointType(const PointType &)> & move)
{
  auto copy = MeshType::New();
  for (auto it = mesh->GetPoints()->Begin(); it != mesh->GetPoints()->End(); ++it)
  {
    copy->SetPoint(it.Index(), move(it.Value()));
  }
  itk::IdentifierType id = 0;
  for (auto it = mesh->GetCells()->Begin(); it != mesh->GetCells()->End(); ++it)
  {
    MeshType::CellAutoPointer cell;
    it.Value()->MakeCopy(cell);
    copy->SetCell(id++, cell);
  }
  return copy;
}

MeshType::Pointer
Copy(const MeshType * mesh)
{
  return Copy(mesh, [](const PointType & point) { return point; });
}

MeshType::Pointer
Scale(const MeshType * mesh, float factor)
{
  return Copy(mesh, [factor](PointType point) {
    for (unsigned int d = 0; d < 3; ++d)
    {
      point[d] *= factor;
    }
    return point;
  });
}

/** What lies to one side of a plane of constant y, with its points but no triangle of the rest. */
MeshType::Pointer
KeepRight(const MeshType * mesh, float y)
{
  auto kept = MeshType::New();
  kept->SetPoints(const_cast<MeshType *>(mesh)->GetPoints());
  itk::IdentifierType id = 0;
  for (auto it = mesh->GetCells()->Begin(); it != mesh->GetCells()->End(); ++it)
  {
    if (mesh->GetPoint(it.Value()->GetPointIds()[0])[1] < y)
    {
      MeshType::CellAutoPointer cell;
      it.Value()->MakeCopy(cell);
      kept->SetCell(id++, cell);
    }
  }
  return kept;
}

/** Both in one mesh. */
MeshType::Pointer
Append(const MeshType * first, const MeshType * second)
{
  auto both = Copy(first);
  auto offset = first->GetNumberOfPoints();
  for (auto it = second->GetPoints()->Begin(); it != second->GetPoints()->End(); ++it)
  {
    both->SetPoint(offset + it.Index(), it.Value());
  }
  auto id = first->GetNumberOfCells();
  for (auto it = second->GetCells()->Begin(); it != second->GetCells()->End(); ++it)
  {
    MeshType::CellAutoPointer cell;
    cell.TakeOwnership(new itk::TriangleCell<MeshType::CellType>);
    for (unsigned int corner = 0; corner < 3; ++corner)
    {
      cell->SetPointId(static_cast<int>(corner), offset + it.Value()->GetPointIds()[corner]);
    }
    both->SetCell(id++, cell);
  }
  return both;
}

/** A pair of scans as they should be: nothing is found, and each test changes one thing. */
struct Scans
{
  explicit Scans(std::uint64_t seed = 3)
  {
    auto source = itk::DentalPhantomCaseSource::New();
    source->SetSeed(seed);
    source->SetNumberOfTriangles(8000);
    source->SetMakeRadiograph(false);
    source->Update();
    for (unsigned int jaw = 0; jaw < 2; ++jaw)
    {
      meshes[jaw] = Copy(source->GetMesh(jaw));
      for (const auto & landmark : source->GetLandmarks3D(jaw)->GetLandmarks())
      {
        landmarks->AddLandmark(landmark.name, landmark.point);
      }
    }
  }

  FilterType::Pointer
  Check(double millimetresPerUnit = 1.0) const
  {
    auto axis = itk::UMidlineDentalAxisFilter<MeshType>::New();
    axis->SetUpperMesh(meshes[0]);
    axis->SetLowerMesh(meshes[1]);
    axis->RequireArchesOff();
    axis->TransformMeshesOff();
    auto filter = FilterType::New();
    filter->SetUpperMesh(meshes[0]);
    filter->SetLowerMesh(meshes[1]);
    filter->SetFrames(axis->GetFrameOutput());
    filter->SetLandmarks(landmarks);
    filter->SetMillimetresPerUnit(millimetresPerUnit);
    filter->Update();
    return filter;
  }

  MeshType::Pointer                  meshes[2];
  itk::DentalLandmarkSet<3>::Pointer landmarks = itk::DentalLandmarkSet<3>::New();
};

std::vector<std::string>
CodesOf(FilterType * filter, JawEnum jaw)
{
  std::vector<std::string> codes;
  for (const auto & finding : filter->GetFindings(jaw))
  {
    codes.push_back(finding.code);
  }
  return codes;
}

using Codes = std::vector<std::string>;
} // namespace

TEST(ScanCheckFilter, FindsNothingOnScansAsTheyShouldBe)
{
  for (const std::uint64_t seed : { 3, 4, 5 })
  {
    const auto filter = Scans(seed).Check();
    EXPECT_EQ(CodesOf(filter, JawEnum::Upper), Codes()) << seed;
    EXPECT_EQ(CodesOf(filter, JawEnum::Lower), Codes()) << seed;
    EXPECT_TRUE(filter->GetNotCheckable().empty()) << seed;
  }
}

/** The figure, its limit and its unit are the finding's, and the text names the unit that would fit. */
TEST(ScanCheckFilter, NamesTheUnitThatWouldFit)
{
  const std::pair<float, const char *> units[] = { { 0.1F, "\"cm\"" },
                                                   { 1.0F / 25.4F, "\"inch\"" },
                                                   { 1000.0F, "\"um\"" } };
  for (const auto & unit : units)
  {
    Scans scans;
    scans.landmarks = itk::DentalLandmarkSet<3>::New();
    scans.meshes[1] = nullptr;
    scans.meshes[0] = Scale(scans.meshes[0], unit.first);
    const auto filter = scans.Check();
    bool       found = false;
    for (const auto & finding : filter->GetFindings(JawEnum::Upper))
    {
      if (finding.code == "arch-width")
      {
        found = true;
        EXPECT_NE(finding.text.find("\"mesh_unit\": " + std::string(unit.second) + " would fit"), std::string::npos)
          << finding.text;
        EXPECT_EQ(finding.unit, "mm");
        EXPECT_EQ(*finding.limit, unit.first < 1.0F ? 30.0 : 120.0);
        EXPECT_EQ(*finding.value < *finding.limit, unit.first < 1.0F);
      }
    }
    EXPECT_TRUE(found) << unit.second;
    // Before what comes of it; and what seems to stand out by millimetres does so in another unit.
    EXPECT_EQ(filter->GetFindings(JawEnum::Upper).front().code, "arch-width") << unit.second;
    const auto codes = CodesOf(filter, JawEnum::Upper);
    EXPECT_EQ(std::count(codes.begin(), codes.end(), "spikes"), 0) << unit.second;
  }
}

/** What a scanner leaves in the air, and points that no triangle has, made an arch of "1600 mm". */
TEST(ScanCheckFilter, SpecksAndPointsThatNobodyHasAreNotTheScan)
{
  Scans scans;
  scans.meshes[0]->SetPoint(scans.meshes[0]->GetNumberOfPoints(), PointType(1600.0F));
  const auto first = scans.meshes[1]->GetNumberOfPoints();
  for (unsigned int corner = 0; corner < 3; ++corner)
  {
    PointType point(200.0F);
    point[corner] += 1.0F;
    scans.meshes[1]->SetPoint(first + corner, point);
  }
  MeshType::CellAutoPointer cell;
  cell.TakeOwnership(new itk::TriangleCell<MeshType::CellType>);
  for (unsigned int corner = 0; corner < 3; ++corner)
  {
    cell->SetPointId(static_cast<int>(corner), first + corner);
  }
  scans.meshes[1]->SetCell(scans.meshes[1]->GetNumberOfCells(), cell);
  const auto filter = scans.Check();
  EXPECT_EQ(CodesOf(filter, JawEnum::Upper), Codes());
  EXPECT_EQ(CodesOf(filter, JawEnum::Lower), Codes());
}

/** A file of which some are wrong is right in the median. */
TEST(ScanCheckFilter, JudgesLandmarksOneByOne)
{
  Scans scans;
  auto  landmarks = itk::DentalLandmarkSet<3>::New();
  for (const auto & landmark : scans.landmarks->GetLandmarks())
  {
    auto point = landmark.point;
    point[2] += landmark.name == "UR1_tip" ? 40.0 : landmark.name == "UL6_MB" ? -60.0 : 0.0;
    landmarks->AddLandmark(landmark.name, point);
  }
  scans.landmarks = landmarks;
  const auto filter = scans.Check();
  ASSERT_EQ(CodesOf(filter, JawEnum::Upper), Codes{ "landmarks-off-scan" });
  const auto & finding = filter->GetFindings(JawEnum::Upper).front();
  EXPECT_NE(finding.text.find("UR1_tip"), std::string::npos) << finding.text;
  EXPECT_NE(finding.text.find("UL6_MB"), std::string::npos) << finding.text;
  EXPECT_EQ(*finding.limit, FilterType::MaximumLandmarkDistance);
  EXPECT_EQ(CodesOf(filter, JawEnum::Lower), Codes());
}

/** It lies on the scan, and the side's landmarks are on their side on average. */
TEST(ScanCheckFilter, TellsALandmarkOfTheOtherSidesTooth)
{
  Scans        scans;
  auto         landmarks = itk::DentalLandmarkSet<3>::New();
  const auto * distal = scans.landmarks->Find("UL6_DB");
  const auto * mesial = scans.landmarks->Find("UL6_MB");
  ASSERT_TRUE(distal != nullptr && mesial != nullptr);
  for (const auto & landmark : scans.landmarks->GetLandmarks())
  {
    auto point = landmark.point;
    if (landmark.name == "UR6_MB")
    {
      point.SetToMidPoint(distal->point, mesial->point);
    }
    landmarks->AddLandmark(landmark.name, point);
  }
  scans.landmarks = landmarks;
  const auto filter = scans.Check();
  ASSERT_EQ(CodesOf(filter, JawEnum::Upper), Codes{ "sides-exchanged" });
  EXPECT_NE(filter->GetFindings(JawEnum::Upper).front().text.find("UR6_MB lies on the other side"), std::string::npos)
    << filter->GetFindings(JawEnum::Upper).front().text;
  EXPECT_EQ(CodesOf(filter, JawEnum::Lower), Codes());
  EXPECT_EQ(filter->GetUnusableLandmarks(), std::vector<std::string>{ "UR6_MB" });
}

/** Two names exchanged within a side, adjacent or not: each is said, none of the others, and none of them is used. */
TEST(ScanCheckFilter, TellsExchangedNamesOfOneSide)
{
  using PairType = std::pair<std::string, std::string>;
  for (const PairType & pair : { PairType{ "UR6_MB", "UR4_B" },
                                 PairType{ "UR6_MB", "UR1_tip" },
                                 PairType{ "UL4_B", "UL5_B" },
                                 PairType{ "UL1_tip", "UL2_tip" } })
  {
    Scans        scans;
    auto         landmarks = itk::DentalLandmarkSet<3>::New();
    const auto * first = scans.landmarks->Find(pair.first);
    const auto * second = scans.landmarks->Find(pair.second);
    ASSERT_TRUE(first != nullptr && second != nullptr);
    for (const auto & landmark : scans.landmarks->GetLandmarks())
    {
      landmarks->AddLandmark(landmark.name,
                             landmark.name == pair.first    ? second->point
                             : landmark.name == pair.second ? first->point
                                                            : landmark.point);
    }
    scans.landmarks = landmarks;
    const auto filter = scans.Check();
    ASSERT_EQ(CodesOf(filter, JawEnum::Upper), Codes{ "landmarks-order" }) << pair.first;
    const std::string text = filter->GetFindings(JawEnum::Upper).front().text;
    EXPECT_NE(text.find(pair.first), std::string::npos) << text;
    EXPECT_NE(text.find(pair.second), std::string::npos) << text;
    auto unusable = filter->GetUnusableLandmarks();
    std::sort(unusable.begin(), unusable.end());
    EXPECT_EQ(unusable, (Codes{ std::min(pair.first, pair.second), std::max(pair.first, pair.second) }));
    EXPECT_EQ(CodesOf(filter, JawEnum::Lower), Codes());
  }
}

/** A molar's mark on the molar behind it, whose own is not there: where the tooth's other cusps are marked they are
 * passed, and where they are not the step from the premolar is that of two teeth, unlike the other side's. */
TEST(ScanCheckFilter, TellsAMolarMarkedAToothBack)
{
  for (const bool hasOtherCusps : { true, false })
  {
    Scans        scans;
    auto         landmarks = itk::DentalLandmarkSet<3>::New();
    const auto * behind = scans.landmarks->Find("LR7_MB");
    ASSERT_NE(behind, nullptr);
    for (const auto & landmark : scans.landmarks->GetLandmarks())
    {
      const bool isOther = landmark.name != "LR6_MB" && landmark.name.rfind("LR6_", 0) == 0;
      if (landmark.name.rfind("LR7_", 0) != 0 && (hasOtherCusps || !isOther))
      {
        landmarks->AddLandmark(landmark.name, landmark.name == "LR6_MB" ? behind->point : landmark.point);
      }
    }
    scans.landmarks = landmarks;
    const auto filter = scans.Check();
    ASSERT_EQ(CodesOf(filter, JawEnum::Lower), Codes{ "landmarks-order" }) << hasOtherCusps;
    EXPECT_EQ(filter->GetUnusableLandmarks(), Codes{ "LR6_MB" }) << hasOtherCusps;
    EXPECT_EQ(CodesOf(filter, JawEnum::Upper), Codes());
  }
}

/** A tooth that was lost on one side, and its neighbours closed up or not, are no marks of other teeth. */
TEST(ScanCheckFilter, ALostToothIsNoMarkOfAnother)
{
  for (const char * lost : { "UR4", "UR6", "LL5", "LL1" })
  {
    Scans scans;
    auto  landmarks = itk::DentalLandmarkSet<3>::New();
    for (const auto & landmark : scans.landmarks->GetLandmarks())
    {
      if (landmark.name.rfind(lost, 0) != 0)
      {
        landmarks->AddLandmark(landmark.name, landmark.point);
      }
    }
    scans.landmarks = landmarks;
    const auto filter = scans.Check();
    EXPECT_TRUE(filter->GetUnusableLandmarks().empty()) << lost;
  }
}

/** What was left where all begin may happen to lie on the scan; two teeth have no place in common. */
TEST(ScanCheckFilter, LandmarksAtOneAndTheSamePlaceAreNone)
{
  Scans        scans;
  auto         landmarks = itk::DentalLandmarkSet<3>::New();
  const auto & all = scans.landmarks->GetLandmarks();
  for (const auto & landmark : all)
  {
    const bool wrong = landmark.name == "LR6_MB" || landmark.name == "LL4_B";
    landmarks->AddLandmark(landmark.name, wrong ? scans.landmarks->Find("LL1_tip")->point : landmark.point);
  }
  scans.landmarks = landmarks;
  const auto filter = scans.Check();
  EXPECT_EQ(CodesOf(filter, JawEnum::Upper), Codes());
  ASSERT_EQ(CodesOf(filter, JawEnum::Lower), Codes{ "landmarks-coincide" });
  for (const char * name : { "LR6_MB", "LL4_B", "LL1_tip" })
  {
    EXPECT_NE(filter->GetFindings(JawEnum::Lower).front().text.find(name), std::string::npos) << name;
    EXPECT_FALSE(FilterType::IsAlone(*landmarks, *landmarks->Find(name)));
  }
  EXPECT_TRUE(FilterType::IsAlone(*landmarks, *landmarks->Find("LR1_tip")));
}

TEST(ScanCheckFilter, LandmarksOfAnotherFrameAreSaidToBe)
{
  Scans scans;
  auto  moved = itk::DentalLandmarkSet<3>::New();
  for (const auto & landmark : scans.landmarks->GetLandmarks())
  {
    auto point = landmark.point;
    point[2] += 200.0;
    moved->AddLandmark(landmark.name, point);
  }
  scans.landmarks = moved;
  const auto filter = scans.Check();
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    ASSERT_EQ(CodesOf(filter, jaw), Codes{ "landmarks-off-scan" });
    EXPECT_NE(filter->GetFindings(jaw).front().text.find("unit and frame"), std::string::npos);
  }
}

TEST(ScanCheckFilter, FindsBothJawsInOneScan)
{
  Scans scans;
  scans.landmarks = itk::DentalLandmarkSet<3>::New();
  scans.meshes[0] = Append(scans.meshes[0], scans.meshes[1]);
  scans.meshes[1] = nullptr;
  const auto codes = CodesOf(scans.Check(), JawEnum::Upper);
  EXPECT_EQ(std::count(codes.begin(), codes.end(), "both-jaws"), 1);
}

TEST(ScanCheckFilter, FindsAPointThatStandsOut)
{
  Scans scans;
  // In the file of the lower scan one number lost its sign.
  const auto last = scans.meshes[1]->GetNumberOfPoints() / 2;
  scans.meshes[1] = Copy(scans.meshes[1], [&, id = itk::IdentifierType{ 0 }](PointType point) mutable {
    point[2] += id++ == last ? 30.0F : 0.0F;
    return point;
  });
  const auto check = scans.Check();
  const auto codes = CodesOf(check, JawEnum::Lower);
  EXPECT_EQ(std::count(codes.begin(), codes.end(), "spikes"), 1);
  const auto others = CodesOf(check, JawEnum::Upper);
  EXPECT_EQ(std::count(others.begin(), others.end(), "spikes"), 0);
}

TEST(ScanCheckFilter, FindsAQuadrant)
{
  Scans scans;
  scans.landmarks = itk::DentalLandmarkSet<3>::New();
  auto axis = itk::UMidlineDentalAxisFilter<MeshType>::New();
  axis->SetUpperMesh(scans.meshes[0]);
  axis->Update();
  scans.meshes[0] = KeepRight(axis->GetUpperOutput(), -4.0F);
  scans.meshes[1] = nullptr;
  const auto codes = CodesOf(scans.Check(), JawEnum::Upper);
  EXPECT_EQ(std::count(codes.begin(), codes.end(), "partial-arch"), 1);
  EXPECT_EQ(std::count(codes.begin(), codes.end(), "arch-width"), 0);
}

TEST(ScanCheckFilter, FindsExchangedAndRepeatedScans)
{
  Scans scans;
  std::swap(scans.meshes[0], scans.meshes[1]);
  // Each jaw's landmarks tell, and so do the shapes: it is said once, and of the sides nothing is.
  auto codes = CodesOf(scans.Check(), JawEnum::Lower);
  EXPECT_EQ(std::count(codes.begin(), codes.end(), "jaws-exchanged"), 1);
  EXPECT_EQ(std::count(codes.begin(), codes.end(), "sides-exchanged"), 0);
  scans.landmarks = itk::DentalLandmarkSet<3>::New();
  codes = CodesOf(scans.Check(), JawEnum::Lower);
  EXPECT_EQ(std::count(codes.begin(), codes.end(), "jaws-exchanged"), 1) << "by their shapes alone";
  scans.meshes[1] = Copy(scans.meshes[0]);
  codes = CodesOf(scans.Check(), JawEnum::Upper);
  EXPECT_EQ(std::count(codes.begin(), codes.end(), "same-scan"), 1);
}

TEST(ScanCheckFilter, FindsAMirroredScan)
{
  Scans scans;
  for (auto & mesh : scans.meshes)
  {
    mesh = Copy(mesh, [](PointType point) {
      point[0] = -point[0];
      return point;
    });
  }
  auto mirrored = itk::DentalLandmarkSet<3>::New();
  for (const auto & landmark : scans.landmarks->GetLandmarks())
  {
    auto point = landmark.point;
    point[0] = -point[0];
    mirrored->AddLandmark(landmark.name, point);
  }
  scans.landmarks = mirrored;
  const auto codes = CodesOf(scans.Check(), JawEnum::Upper);
  EXPECT_EQ(std::count(codes.begin(), codes.end(), "inward-winding"), 1);
}

TEST(ScanCheckFilter, WithoutLandmarksAndWithOneJawExchangeCannotBeTold)
{
  Scans scans;
  scans.landmarks = itk::DentalLandmarkSet<3>::New();
  scans.meshes[1] = nullptr;
  const auto filter = scans.Check();
  ASSERT_EQ(filter->GetNotCheckable().size(), 1u);
  EXPECT_NE(filter->GetNotCheckable().front().find("exchanged"), std::string::npos);
  EXPECT_TRUE(filter->GetFindings(JawEnum::Lower).empty());
}

/** Apart there is no overjet: the widths at the molars and of the incisors are left. They tell some exchanged pairs, a
 * third of arches with the traits of real ones; of the others it is said that they leave it open. */
TEST(ScanCheckFilter, JawsApartAreToldByMolarsAndIncisorsTogetherOrLeftOpen)
{
  constexpr unsigned int count = 5;
  unsigned int           told = 0;
  unsigned int           open = 0;
  for (std::uint64_t seed = 3; seed < 3 + count; ++seed)
  {
    Scans scans(seed);
    scans.landmarks = itk::DentalLandmarkSet<3>::New();
    scans.meshes[1] = Copy(scans.meshes[1], [](PointType point) {
      point[0] += 300.0F;
      return point;
    });
    const auto named = CodesOf(scans.Check(), JawEnum::Upper);
    EXPECT_EQ(std::count(named.begin(), named.end(), "jaws-exchanged"), 0) << seed;
    std::swap(scans.meshes[0], scans.meshes[1]);
    const auto filter = scans.Check();
    const auto codes = CodesOf(filter, JawEnum::Upper);
    const bool isTold = std::count(codes.begin(), codes.end(), "jaws-exchanged") == 1;
    EXPECT_EQ(codes, CodesOf(filter, JawEnum::Lower)) << seed;
    const auto & lines = filter->GetNotCheckable();
    const bool   isOpen = std::any_of(lines.begin(), lines.end(), [](const std::string & line) {
      return line.find("the shapes of the jaws leave it open") != std::string::npos;
    });
    EXPECT_FALSE(isTold && isOpen) << seed;
    told += isTold ? 1 : 0;
    open += isOpen ? 1 : 0;
    if (isTold)
    {
      const std::string text = filter->GetFindings(JawEnum::Upper).front().text;
      EXPECT_NE(text.find("narrower than the lower at the first molars and has the narrower incisors"),
                std::string::npos)
        << text;
      EXPECT_EQ(text.find("behind it"), std::string::npos) << text;
    }
  }
  EXPECT_GE(told, 1u);
  EXPECT_GE(open, 1u);
  EXPECT_GE(told + open, count - 1);
}

/** One Update() on the checks runs the axis filter; a second runs nothing. */
TEST(ScanCheckFilter, PullsTheFramesItself)
{
  const Scans scans;
  auto        axis = itk::UMidlineDentalAxisFilter<MeshType>::New();
  axis->SetUpperMesh(scans.meshes[0]);
  axis->TransformMeshesOff();
  unsigned int executions = 0;
  axis->AddObserver(itk::StartEvent(), [&](const itk::EventObject &) { ++executions; });
  auto filter = FilterType::New();
  filter->SetUpperMesh(scans.meshes[0]);
  filter->SetFrames(axis->GetFrameOutput());
  filter->Update();
  filter->Update();
  EXPECT_EQ(executions, 1u);
}

TEST(ScanCheckFilter, NamesTheCallThatIsMissing)
{
  auto filter = FilterType::New();
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
  filter->SetFrames(itk::DentalFrameObject::New());
  try
  {
    filter->Update();
    FAIL();
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_NE(std::string(error.GetDescription()).find("SetUpperMesh()"), std::string::npos);
  }
}

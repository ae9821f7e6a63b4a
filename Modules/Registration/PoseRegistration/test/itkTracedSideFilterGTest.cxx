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
#include "itkTracedSideFilter.h"

#include "itkTestingMacros.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace
{
using FilterType = itk::TracedSideFilter;
using ContourType = itk::DentalContour;
using SideEnum = itk::TracedSideEnum;
using ReasonEnum = FilterType::ReasonEnum;
using JawEnum = FilterType::JawEnum;

ContourType::PointType
MakePoint(double u, double v)
{
  ContourType::PointType point;
  point[0] = u;
  point[1] = v;
  return point;
}

/** Open stretches, a code each. */
ContourType::Pointer
MakeStretches(const std::vector<unsigned int> & teeth)
{
  auto contour = ContourType::New();
  for (const unsigned int fdi : teeth)
  {
    contour->AddPolyline({ MakePoint(fdi, 0), MakePoint(fdi, 5), MakePoint(fdi + 2, 7) },
                         fdi == 0 ? itk::ToothCode() : itk::ToothCode(fdi));
  }
  return contour;
}

/** Closed outlines as wide as 4, a code and a length each. */
ContourType::Pointer
MakeOutlines(const std::vector<std::pair<unsigned int, double>> & teeth)
{
  auto contour = ContourType::New();
  for (const auto & tooth : teeth)
  {
    contour->AddPolyline({ MakePoint(0, 0), MakePoint(4, 0), MakePoint(4, tooth.second), MakePoint(0, tooth.second) },
                         itk::ToothCode(tooth.first),
                         true);
  }
  return contour;
}

FilterType::LandmarksType::Pointer
MakeLandmarks(const std::vector<std::string> & names)
{
  auto landmarks = FilterType::LandmarksType::New();
  for (const std::string & name : names)
  {
    landmarks->AddLandmark(name, MakePoint(10, 20));
  }
  return landmarks;
}

FilterType::Pointer
Settle(const ContourType * upper, const ContourType * lower, const FilterType::LandmarksType * landmarks = nullptr)
{
  auto filter = FilterType::New();
  filter->SetUpperContour(upper);
  filter->SetLowerContour(lower);
  filter->SetCephalometricLandmarks(landmarks);
  filter->Update();
  return filter;
}

std::vector<std::string>
CodesOf(const ContourType * contour)
{
  std::vector<std::string> codes;
  for (const auto & polyline : contour->GetPolylines())
  {
    codes.push_back(polyline.code.GetName());
  }
  return codes;
}

int
ExerciseBasicObjectMethods()
{
  auto filter = FilterType::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(filter, TracedSideFilter, ProcessObject);
  return EXIT_SUCCESS;
}
} // namespace

TEST(TracedSideFilter, BasicObjectMethodsAndDefaults)
{
  EXPECT_EQ(ExerciseBasicObjectMethods(), EXIT_SUCCESS);
  const auto filter = FilterType::New();
  EXPECT_EQ(filter->GetTracedSide(), SideEnum::Right);
  EXPECT_FALSE(filter->GetTracedSideIsGiven());
  EXPECT_TRUE(filter->GetCodesHaveSides());
  filter->Update();
  EXPECT_EQ(filter->GetSettledSide(), SideEnum::Right);
  EXPECT_EQ(filter->GetReason(), ReasonEnum::Nothing);
  EXPECT_EQ(filter->GetUpperOutput()->GetNumberOfPoints(), 0u);
  EXPECT_THROW(filter->GetOutput(JawEnum::Unknown), itk::ExceptionObject);
}

TEST(TracedSideFilter, ASideThatNothingTellsStaysAndSoDoesTheDrawing)
{
  const auto upper = MakeStretches({ 11, 13, 16, 0 });
  const auto filter = Settle(upper, nullptr);
  EXPECT_EQ(filter->GetSettledSide(), SideEnum::Right);
  EXPECT_EQ(filter->GetReason(), ReasonEnum::Nothing);
  EXPECT_EQ(CodesOf(filter->GetUpperOutput()), CodesOf(upper));
  EXPECT_EQ(filter->GetUpperOutput()->GetNumberOfCells(), upper->GetNumberOfCells());
  EXPECT_EQ(filter->GetLowerOutput()->GetNumberOfPoints(), 0u);
  filter->SetTracedSide(SideEnum::Mean);
  filter->Update();
  EXPECT_EQ(filter->GetSettledSide(), SideEnum::Mean);
}

TEST(TracedSideFilter, LandmarksWithoutATracingAreOfTheSidesThatTheyName)
{
  EXPECT_EQ(Settle(nullptr, nullptr, MakeLandmarks({ "UR1 tip", "LR6 occlusal" }))->GetSettledSide(), SideEnum::Right);
  EXPECT_EQ(Settle(nullptr, nullptr, MakeLandmarks({ "UL1 tip", "LL1 tip" }))->GetSettledSide(), SideEnum::Left);
  const auto both = Settle(nullptr, nullptr, MakeLandmarks({ "UR1 tip", "LL1 tip" }));
  EXPECT_EQ(both->GetSettledSide(), SideEnum::Both);
  EXPECT_EQ(both->GetReason(), ReasonEnum::SidesOfLandmarks);
  // One that says no side makes the set an analysis's.
  const auto analysis = Settle(nullptr, nullptr, MakeLandmarks({ "UR1 tip", "L1 tip" }));
  EXPECT_EQ(analysis->GetSettledSide(), SideEnum::Standard);
  EXPECT_EQ(analysis->GetReason(), ReasonEnum::LandmarksAlone);
  // Beside a tracing the tracing tells, and an empty contour is none.
  EXPECT_EQ(Settle(MakeStretches({ 11, 13 }), nullptr, MakeLandmarks({ "U1 tip" }))->GetReason(), ReasonEnum::Nothing);
  EXPECT_EQ(Settle(ContourType::New(), nullptr, MakeLandmarks({ "U1 tip" }))->GetReason(), ReasonEnum::LandmarksAlone);
}

TEST(TracedSideFilter, WholeIncisorsAndMolarsOfOneSideEachAreAStandardTracing)
{
  // An incisor more than twice as long as wide has its root: outlines are 4 wide.
  const auto standard = Settle(MakeOutlines({ { 11, 8.1 }, { 16, 4.0 } }), MakeOutlines({ { 41, 12.0 } }));
  EXPECT_EQ(standard->GetSettledSide(), SideEnum::Standard);
  EXPECT_EQ(standard->GetReason(), ReasonEnum::WholeTeeth);
  EXPECT_TRUE(standard->GetLeftOutTeeth().empty());
  EXPECT_EQ(Settle(MakeOutlines({ { 11, 7.9 }, { 16, 4.0 } }), nullptr)->GetReason(), ReasonEnum::Nothing)
    << "a crown alone";
  EXPECT_EQ(Settle(MakeOutlines({ { 11, 12.0 } }), nullptr)->GetReason(), ReasonEnum::Nothing) << "no molar";
  EXPECT_EQ(Settle(MakeOutlines({ { 11, 12.0 }, { 14, 8.0 }, { 16, 4.0 } }), nullptr)->GetReason(), ReasonEnum::Nothing)
    << "an analysis draws no premolars";
  EXPECT_EQ(Settle(MakeOutlines({ { 11, 12.0 }, { 21, 12.0 }, { 16, 4.0 } }), nullptr)->GetReason(),
            ReasonEnum::Nothing)
    << "it draws one side";
  // What is said of an outline goes before its shape.
  auto crown = MakeOutlines({ { 16, 4.0 } });
  auto polyline = MakeOutlines({ { 11, 5.0 } })->GetPolylines().front();
  polyline.outline = ContourType::OutlineEnum::Tooth;
  crown->AddPolyline(polyline);
  EXPECT_EQ(Settle(crown, nullptr)->GetReason(), ReasonEnum::WholeTeeth);
}

TEST(TracedSideFilter, CodesWithoutASideAreAnAnalysiss)
{
  auto       filter = FilterType::New();
  const auto upper = MakeStretches({ 11, 16 });
  filter->SetUpperContour(upper);
  filter->CodesHaveSidesOff();
  filter->Update();
  EXPECT_EQ(filter->GetSettledSide(), SideEnum::Standard);
  EXPECT_EQ(filter->GetReason(), ReasonEnum::SidelessCodes);
  // What is given is not asked for.
  filter->TracedSideIsGivenOn();
  filter->Update();
  EXPECT_EQ(filter->GetSettledSide(), SideEnum::Right);
  EXPECT_EQ(filter->GetReason(), ReasonEnum::Given);
}

TEST(TracedSideFilter, TwoTeethOfBothSidesBehindTheIncisorsMakeItBoth)
{
  const auto both = Settle(MakeStretches({ 13, 23 }), MakeStretches({ 46, 36 }));
  EXPECT_EQ(both->GetSettledSide(), SideEnum::Both);
  EXPECT_EQ(both->GetReason(), ReasonEnum::TeethOfBothSides);
  EXPECT_TRUE(both->GetLeftOutTeeth().empty());
  EXPECT_EQ(both->GetUpperOutput()->GetNumberOfPoints(), 6u);
  // One pair, and incisors however many, are drawn by chance.
  EXPECT_EQ(Settle(MakeStretches({ 11, 21, 12, 22, 13, 23 }), nullptr)->GetReason(), ReasonEnum::Nothing);
}

TEST(TracedSideFilter, ATeethsFellowOfTheOtherSideIsLeftOutUnderOneSide)
{
  // UL1 and UL2 have fellows that are drawn; UL5 has none and stays, whatever its side.
  const auto upper = MakeStretches({ 11, 21, 12, 22, 25, 0, 21 });
  const auto lower = MakeStretches({ 31, 33 });
  auto       filter = Settle(upper, lower);
  EXPECT_EQ(filter->GetSettledSide(), SideEnum::Right);
  EXPECT_EQ(CodesOf(filter->GetUpperOutput()), (std::vector<std::string>{ "UR1", "UR2", "UL5", "" }));
  EXPECT_EQ(CodesOf(filter->GetLowerOutput()), CodesOf(lower));
  EXPECT_EQ(filter->GetLeftOutTeeth(),
            (std::vector<itk::ToothCode>{ itk::ToothCode(21), itk::ToothCode(22), itk::ToothCode(21) }));
  filter->SetTracedSide(SideEnum::Left);
  filter->TracedSideIsGivenOn();
  filter->Update();
  EXPECT_EQ(CodesOf(filter->GetUpperOutput()), (std::vector<std::string>{ "UL1", "UL2", "UL5", "", "UL1" }));
  EXPECT_EQ(filter->GetLeftOutTeeth().size(), 2u) << "not appended to what was there";
  filter->SetTracedSide(SideEnum::Mean);
  filter->Update();
  EXPECT_TRUE(filter->GetLeftOutTeeth().empty());
}

TEST(TracedSideFilter, RunsOnlyWhenSomethingChanged)
{
  const auto upper = MakeStretches({ 11, 13 });
  const auto filter = Settle(upper, nullptr);
  const auto time = filter->GetUpperOutput()->GetMTime();
  filter->Update();
  EXPECT_EQ(filter->GetUpperOutput()->GetMTime(), time);
  upper->AddPolyline({ MakePoint(1, 2), MakePoint(3, 4) }, itk::ToothCode(21));
  filter->Update();
  EXPECT_EQ(filter->GetLeftOutTeeth().size(), 1u);
}

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
#include "itkCrownRegionMeshFilter.h"
#include "itkMessageOfCall.h"
#include "itkCrownRegionTestSupport.h"
#include "itkDentalPhantomMeshSource.h"
#include "itkMakeTriangleSurface.h"
#include "itkMidlineSideMeshFilter.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace
{
using MeshType = itk::Mesh<float, 3>;
using PhantomType = itk::DentalPhantomMeshSource<MeshType>;
using CrownType = itk::CrownRegionMeshFilter<MeshType>;
using SideType = itk::MidlineSideMeshFilter<MeshType>;
using FrameType = itk::UMidlineDentalAxisFilter<MeshType>;

PhantomType::Pointer
MakePhantom()
{
  auto phantom = PhantomType::New();
  phantom->SetParameters(CrownRegionTest::Draw(101, CrownRegionTest::Kind::Regular, 12000));
  phantom->Update();
  return phantom;
}

FrameType::Pointer
MakeFrame(PhantomType * phantom)
{
  auto frame = FrameType::New();
  frame->SetUpperMesh(phantom->GetUpperOutput());
  frame->SetLowerMesh(phantom->GetLowerOutput());
  frame->RefineMidlineOn();
  return frame;
}

template <typename TFilter>
std::string
ErrorOf(TFilter * filter)
{
  return itk::MessageOfCall([&] { filter->Update(); });
}

TEST(CrownRegionMeshFilter, TakesTheLabelsWhereTheMeshHasThem)
{
  const auto phantom = MakePhantom();
  auto       crowns = CrownType::New();
  crowns->SetInput(phantom->GetUpperOutput());
  crowns->Update();
  EXPECT_TRUE(crowns->GetLabelsWereUsed());
  const auto * labels = phantom->GetUpperOutput()->GetPointData();
  std::size_t  rank = 0;
  for (auto it = labels->Begin(); it != labels->End(); ++it, ++rank)
  {
    ASSERT_EQ(crowns->GetPointMask()[rank] != 0, it.Value() != 0.0f) << "point " << it.Index();
  }
  // Labels go with their points.
  MeshType * output = crowns->GetOutput();
  ASSERT_LT(output->GetNumberOfPoints(), phantom->GetUpperOutput()->GetNumberOfPoints());
  ASSERT_EQ(output->GetPointData()->Size(), output->GetNumberOfPoints());
  std::map<std::array<float, 3>, float> label;
  const MeshType *                      input = phantom->GetUpperOutput();
  for (auto it = input->GetPoints()->Begin(); it != input->GetPoints()->End(); ++it)
  {
    label[{ { it.Value()[0], it.Value()[1], it.Value()[2] } }] = labels->ElementAt(it.Index());
  }
  for (auto it = output->GetPoints()->Begin(); it != output->GetPoints()->End(); ++it)
  {
    const std::array<float, 3> key{ { it.Value()[0], it.Value()[1], it.Value()[2] } };
    ASSERT_EQ(label.at(key), output->GetPointData()->ElementAt(it.Index()));
  }
}

TEST(CrownRegionMeshFilter, FindsCrownsFromShapeWithTheFrameOfBothJaws)
{
  const auto phantom = MakePhantom();
  const auto frame = MakeFrame(phantom);
  auto       byLabels = CrownType::New();
  byLabels->SetJaw(CrownType::JawEnum::Lower);
  byLabels->SetInput(phantom->GetLowerOutput());
  byLabels->Update();
  auto byShape = CrownType::New();
  byShape->SetJaw(CrownType::JawEnum::Lower);
  byShape->SetInput(phantom->GetLowerOutput());
  byShape->SetFrameTransformInput(frame->GetLowerTransformOutput());
  byShape->UseLabelsOff();
  byShape->Update();
  EXPECT_FALSE(byShape->GetLabelsWereUsed());
  const itk::TriangleSurface surface = itk::MakeTriangleSurface<MeshType>(phantom->GetLowerOutput());
  EXPECT_GT(CrownRegionTest::Compare(surface, byShape->GetTriangleMask(), byLabels->GetTriangleMask()).IoU(), 0.85);
  // And with its own.
  auto alone = CrownType::New();
  alone->SetJaw(CrownType::JawEnum::Lower);
  alone->SetInput(phantom->GetLowerOutput());
  alone->UseLabelsOff();
  alone->Update();
  EXPECT_GT(CrownRegionTest::Compare(surface, alone->GetTriangleMask(), byLabels->GetTriangleMask()).IoU(), 0.85);
}

TEST(CrownRegionMeshFilter, GivesTheSameForAnyNumberOfWorkUnits)
{
  const auto                             phantom = MakePhantom();
  std::vector<std::vector<std::uint8_t>> masks;
  for (const unsigned int units : { 1u, 2u, 7u })
  {
    auto crowns = CrownType::New();
    crowns->SetInput(phantom->GetUpperOutput());
    crowns->UseLabelsOff();
    crowns->SetNumberOfWorkUnits(units);
    crowns->Update();
    masks.push_back(crowns->GetTriangleMask());
  }
  EXPECT_EQ(masks[0], masks[1]);
  EXPECT_EQ(masks[0], masks[2]);
}

TEST(CrownRegionMeshFilter, KeepsTheWholeMeshWithAMaskAsPointData)
{
  const auto phantom = MakePhantom();
  auto       crowns = CrownType::New();
  crowns->SetInput(phantom->GetUpperOutput());
  crowns->KeepWholeMeshOn();
  crowns->Update();
  const MeshType * output = crowns->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), phantom->GetUpperOutput()->GetNumberOfPoints());
  ASSERT_EQ(output->GetNumberOfCells(), phantom->GetUpperOutput()->GetNumberOfCells());
  for (std::size_t i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    ASSERT_EQ(output->GetPointData()->ElementAt(i), static_cast<float>(crowns->GetPointMask()[i]));
  }
}

TEST(CrownRegionMeshFilter, SaysWhatToCall)
{
  const auto phantom = MakePhantom();
  auto       crowns = CrownType::New();
  EXPECT_NE(ErrorOf(crowns.GetPointer()).find("SetInput()"), std::string::npos);
  crowns->SetInput(phantom->GetUpperOutput());
  crowns->SetJaw(CrownType::JawEnum::Lower);
  EXPECT_NE(ErrorOf(crowns.GetPointer()).find("SetJaw()"), std::string::npos);
  crowns->SetJaw(CrownType::JawEnum::Unknown);
  EXPECT_NE(ErrorOf(crowns.GetPointer()).find("unknown. Call SetJaw()"), std::string::npos);
  crowns->SetJaw(CrownType::JawEnum::Upper);
  // FDI numbers of the upper jaw hold 11 to 27; 17 to 27 are in universal numbers the lower jaw's too.
  crowns->SetLabelNumbering(CrownType::NumberingEnum::Quadrant);
  EXPECT_NE(ErrorOf(crowns.GetPointer()).find("SetLabelNumbering()"), std::string::npos);
  crowns->SetLabelNumbering(CrownType::NumberingEnum::FDI);
  phantom->GetUpperOutput()->GetPointData()->SetElement(0, 19.0f);
  phantom->GetUpperOutput()->Modified();
  EXPECT_NE(ErrorOf(crowns.GetPointer()).find("UseLabelsOff()"), std::string::npos);
  crowns->SetMinimumCrownHeight(20.0);
  EXPECT_NE(ErrorOf(crowns.GetPointer()).find("SetMinimumCrownHeight()"), std::string::npos);
}

TEST(CrownRegionMeshFilter, ReadsUniversalNumbersWith33AsGingiva)
{
  const auto phantom = MakePhantom();
  auto       fdi = CrownType::New();
  fdi->SetInput(phantom->GetUpperOutput());
  fdi->Update();
  const auto expected = fdi->GetTriangleMask();
  auto *     data = phantom->GetUpperOutput()->GetPointData();
  for (auto it = data->Begin(); it != data->End(); ++it)
  {
    const auto code = static_cast<unsigned int>(it.Value());
    it.Value() = code == 0 ? 33.0f : static_cast<float>(itk::ToothCode(code).GetUniversal());
  }
  phantom->GetUpperOutput()->Modified();
  auto universal = CrownType::New();
  universal->SetInput(phantom->GetUpperOutput());
  universal->SetLabelNumbering(CrownType::NumberingEnum::Universal);
  universal->Update();
  EXPECT_EQ(universal->GetTriangleMask(), expected);
}

TEST(CrownRegionMeshFilter, PrintsItsParameters)
{
  std::ostringstream os;
  CrownType::New()->Print(os);
  SideType::New()->Print(os);
  for (const char * word : { "KeepWholeMesh: 0", "LabelNumbering: FDI", "Jaw: upper", "Side: Right", "Margin: -0.5" })
  {
    EXPECT_NE(os.str().find(word), std::string::npos) << word;
  }
}

TEST(MidlineSideMeshFilter, KeepsTheTeethOfThePatientsRight)
{
  const auto phantom = MakePhantom();
  const auto frame = MakeFrame(phantom);
  auto       side = SideType::New();
  side->SetInput(phantom->GetUpperOutput());
  side->SetFrameTransformInput(frame->GetUpperTransformOutput());
  for (const bool right : { true, false })
  {
    side->SetSide(right ? SideType::SideEnum::Right : SideType::SideEnum::Left);
    side->Update();
    std::map<int, std::size_t> count;
    const auto *               data = side->GetOutput()->GetPointData();
    for (auto it = data->Begin(); it != data->End(); ++it)
    {
      ++count[static_cast<int>(it.Value())];
    }
    // Central incisors lie at the plane: the others are whole on their side and absent from the other.
    for (int position = 2; position <= 7; ++position)
    {
      EXPECT_GT(count[(right ? 10 : 20) + position], 0u);
      EXPECT_EQ(count[(right ? 20 : 10) + position], 0u);
    }
    std::size_t marks = 0;
    for (const std::uint8_t mark : side->GetTriangleMask())
    {
      marks += mark;
    }
    EXPECT_EQ(marks, side->GetOutput()->GetNumberOfCells());
    for (auto it = side->GetOutput()->GetCells()->Begin(); it != side->GetOutput()->GetCells()->End(); ++it)
    {
      for (auto id = it.Value()->PointIdsBegin(); id != it.Value()->PointIdsEnd(); ++id)
      {
        ASSERT_LT(*id, side->GetOutput()->GetNumberOfPoints());
      }
    }
  }
}

TEST(MidlineSideMeshFilter, SaysWhatToCall)
{
  const auto phantom = MakePhantom();
  auto       side = SideType::New();
  EXPECT_NE(ErrorOf(side.GetPointer()).find("SetInput()"), std::string::npos);
  side->SetInput(phantom->GetUpperOutput());
  EXPECT_NE(ErrorOf(side.GetPointer()).find("SetFrameTransformInput()"), std::string::npos);
  const auto frame = MakeFrame(phantom);
  side->SetFrameTransformInput(frame->GetUpperTransformOutput());
  side->SetMargin(-100.0);
  EXPECT_NE(ErrorOf(side.GetPointer()).find("SetMargin()"), std::string::npos);
}
} // namespace

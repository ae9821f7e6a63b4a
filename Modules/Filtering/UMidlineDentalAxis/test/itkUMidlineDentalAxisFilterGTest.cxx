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
#include "itkUMidlineDentalAxisFilter.h"

#include "itkDentalFrameTestSupport.h"

#include "itkCommand.h"
#include "itkDentalPhantomMeshSource.h"
#include "itkMessageOfCall.h"
#include "itkTestingMacros.h"
#include "itkTriangleCell.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace
{
using MeshType = itk::Mesh<float, 3>;
using FilterType = itk::UMidlineDentalAxisFilter<MeshType>;
using SourceType = itk::DentalPhantomMeshSource<MeshType>;
using JawEnum = FilterType::JawEnum;

SourceType::Pointer
MakeSource(std::uint64_t seed)
{
  auto source = SourceType::New();
  auto parameters = itk::DentalPhantomParameters::Draw(seed);
  parameters.numberOfTriangles = 12000;
  source->SetParameters(parameters);
  return source;
}

// ITK's macro returns from its function.
int
ExerciseBasicObjectMethods()
{
  auto filter = FilterType::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(filter, UMidlineDentalAxisFilter, MeshSource);
  ITK_TEST_SET_GET_BOOLEAN(filter, RefineMidline, true);
  ITK_TEST_SET_GET_BOOLEAN(filter, EmbedAxes, false);
  EXPECT_TRUE(filter->GetTransformMeshes());
  EXPECT_TRUE(filter->GetRequireArches());
  ITK_TEST_SET_GET_BOOLEAN(filter, TransformMeshes, false);
  ITK_TEST_SET_GET_BOOLEAN(filter, RequireArches, false);
  return EXIT_SUCCESS;
}
} // namespace

TEST(UMidlineDentalAxisFilter, ObeysTheBasicObjectContract)
{
  EXPECT_EQ(ExerciseBasicObjectMethods(), EXIT_SUCCESS);
}

TEST(UMidlineDentalAxisFilter, TransformLeadsFromTheMeshToTheFrameAndIsThatOfTheOutputMesh)
{
  auto source = MakeSource(2);
  auto filter = FilterType::New();
  filter->SetUpperMesh(source->GetUpperOutput());
  filter->SetLowerMesh(source->GetLowerOutput());
  filter->Update();
  const FilterType::TransformType * transform = filter->GetUpperTransformOutput()->Get();
  ASSERT_NE(transform, nullptr);
  const MeshType * input = source->GetUpperOutput();
  const MeshType * output = filter->GetUpperOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), input->GetNumberOfPoints());
  ASSERT_EQ(output->GetNumberOfCells(), input->GetNumberOfCells());
  for (unsigned int id = 0; id < input->GetNumberOfPoints(); id += 97)
  {
    FilterType::PointType p;
    p.CastFrom(input->GetPoint(id));
    const auto q = transform->TransformPoint(p);
    for (unsigned int d = 0; d < 3; ++d)
    {
      // Single precision at 50 mm.
      EXPECT_NEAR(output->GetPoint(id)[d], q[d], 1e-5);
    }
    EXPECT_EQ(output->GetPointData()->ElementAt(id), input->GetPointData()->ElementAt(id)) << "labels are kept";
  }
  // The incisal edge is in front, the molars behind it to the right and the left, in both jaws.
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    const auto * toFrame = jaw == JawEnum::Upper ? transform : filter->GetLowerTransformOutput()->Get();
    const auto   edge = toFrame->TransformPoint(filter->GetIncisalEdge(jaw));
    const auto   right = toFrame->TransformPoint(filter->GetBaselineRight(jaw));
    const auto   left = toFrame->TransformPoint(filter->GetBaselineLeft(jaw));
    const auto   middle = toFrame->TransformPoint(filter->GetBaselineMidpoint(jaw));
    EXPECT_GT(edge[0], 10.0) << jaw;
    EXPECT_LT(right[1], -15.0) << jaw;
    EXPECT_GT(left[1], 15.0) << jaw;
    EXPECT_NEAR(edge[0] - middle[0], filter->GetArchDepth(jaw), 1e-6) << jaw;
    EXPECT_NEAR((left - right).GetNorm(), filter->GetArchWidth(jaw), 1e-6) << jaw;
    // Occlusal is -z in the upper and +z in the lower jaw.
    EXPECT_GT((jaw == JawEnum::Upper ? -1.0 : 1.0) * edge[2], 0.0) << jaw;
    EXPECT_GT(filter->GetConfidence(jaw), 0.5) << jaw;
  }
  EXPECT_TRUE(filter->GetJawsAreInOneFrame());
}

TEST(UMidlineDentalAxisFilter, PlanesStandOnTheAxes)
{
  auto source = MakeSource(3);
  auto filter = FilterType::New();
  filter->SetLowerMesh(source->GetLowerOutput());
  filter->RefineMidlineOn();
  filter->Update();
  const auto & frame = filter->GetJawFrame(JawEnum::Lower);
  const auto   occlusal = filter->GetOcclusalPlane(JawEnum::Lower);
  const auto   midline = filter->GetMidlinePlane(JawEnum::Lower);
  const auto   coronal = filter->GetCoronalPlane(JawEnum::Lower);
  for (unsigned int d = 0; d < 3; ++d)
  {
    EXPECT_EQ(coronal.normal[d], frame.axes[0][d]);
    EXPECT_EQ(midline.normal[d], frame.axes[1][d]);
    EXPECT_EQ(occlusal.normal[d], frame.axes[2][d]);
    EXPECT_EQ(occlusal.point[d], frame.origin[d]);
  }
  // Refined: the origin lies on the mirror plane.
  const auto & plane = filter->GetFrame().midsagittalLower;
  EXPECT_NEAR(DentalFrameTest::Dot(plane.normal, frame.origin), plane.offset, 1e-9);
}

TEST(UMidlineDentalAxisFilter, OneJawAloneLeavesTheOtherOutputsEmpty)
{
  auto source = MakeSource(4);
  auto filter = FilterType::New();
  filter->SetUpperMesh(source->GetUpperOutput());
  filter->Update();
  EXPECT_GT(filter->GetUpperOutput()->GetNumberOfPoints(), 0u);
  EXPECT_EQ(filter->GetLowerOutput()->GetNumberOfPoints(), 0u);
  EXPECT_EQ(filter->GetLowerTransformOutput()->Get(), nullptr);
  EXPECT_FALSE(filter->GetJawsAreInOneFrame());
}

TEST(UMidlineDentalAxisFilter, JointTransformIsThatOfTheFrameThatBothJawsShare)
{
  auto source = MakeSource(6);
  auto filter = FilterType::New();
  filter->SetUpperMesh(source->GetUpperOutput());
  filter->SetLowerMesh(source->GetLowerOutput());
  filter->RefineMidlineOn();
  filter->Update();
  ASSERT_TRUE(filter->GetJawsAreInOneFrame());
  const auto & frame = filter->GetFrame().joint;
  ASSERT_TRUE(frame.valid);
  const FilterType::TransformType * joint = filter->GetJointTransformOutput()->Get();
  ASSERT_NE(joint, nullptr);
  // q = R (p - o), as the jaws' own transforms.
  FilterType::PointType p;
  p[0] = 11.0;
  p[1] = -7.0;
  p[2] = 5.0;
  const auto q = joint->TransformPoint(p);
  for (unsigned int row = 0; row < 3; ++row)
  {
    double expected = 0.0;
    for (unsigned int d = 0; d < 3; ++d)
    {
      expected += frame.axes[row][d] * (p[d] - frame.origin[d]);
    }
    EXPECT_NEAR(q[row], expected, 1e-9);
  }
  // In it the crowns of the upper jaw are above those of the lower one, and both arches face forward.
  const auto upper = joint->TransformPoint(filter->GetBaselineMidpoint(JawEnum::Upper));
  const auto lower = joint->TransformPoint(filter->GetBaselineMidpoint(JawEnum::Lower));
  EXPECT_GT(upper[2], lower[2]);
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    EXPECT_GT(joint->TransformPoint(filter->GetIncisalEdge(jaw))[0],
              joint->TransformPoint(filter->GetBaselineMidpoint(jaw))[0] + 10.0);
  }
  // Jaws apart, or one alone, share none.
  filter->SetJawsShareFrame(FilterType::JawsShareFrameEnum::Off);
  filter->Update();
  EXPECT_EQ(filter->GetJointTransformOutput()->Get(), nullptr);
  auto alone = FilterType::New();
  alone->SetUpperMesh(source->GetUpperOutput());
  alone->Update();
  EXPECT_EQ(alone->GetJointTransformOutput()->Get(), nullptr);
}

TEST(UMidlineDentalAxisFilter, WithoutTransformedMeshesTheFramesAreTheSame)
{
  auto source = MakeSource(4);
  auto filter = FilterType::New();
  filter->SetUpperMesh(source->GetUpperOutput());
  filter->SetLowerMesh(source->GetLowerOutput());
  filter->Update();
  const auto upper = filter->GetUpperTransformOutput()->Get()->GetMatrix();
  const auto lower = filter->GetLowerTransformOutput()->Get()->GetOffset();
  const auto joint = filter->GetJointTransformOutput()->Get()->GetMatrix();
  filter->TransformMeshesOff();
  filter->EmbedAxesOn();
  filter->Update();
  EXPECT_EQ(filter->GetUpperOutput()->GetNumberOfPoints(), 0u);
  EXPECT_EQ(filter->GetLowerOutput()->GetNumberOfPoints(), 0u);
  EXPECT_EQ(filter->GetUpperTransformOutput()->Get()->GetMatrix(), upper);
  EXPECT_EQ(filter->GetLowerTransformOutput()->Get()->GetOffset(), lower);
  EXPECT_EQ(filter->GetJointTransformOutput()->Get()->GetMatrix(), joint);
  filter->TransformMeshesOn();
  filter->Update();
  EXPECT_GT(filter->GetUpperOutput()->GetNumberOfPoints(), 0u) << "back again";
}

TEST(UMidlineDentalAxisFilter, AMeshWithoutAnArchIsAnErrorOnlyWhereArchesAreRequired)
{
  auto source = MakeSource(4);
  source->Update();
  // A triangle without an area has no arch.
  auto                speck = MeshType::New();
  MeshType::PointType point;
  for (unsigned int i = 0; i < 3; ++i)
  {
    point.Fill(0.0f);
    point[0] = static_cast<float>(i);
    speck->SetPoint(i, point);
  }
  MeshType::CellAutoPointer cell;
  cell.TakeOwnership(new itk::TriangleCell<MeshType::CellType>);
  for (unsigned int i = 0; i < 3; ++i)
  {
    cell->SetPointId(static_cast<int>(i), i);
  }
  speck->SetCell(0, cell);
  auto filter = FilterType::New();
  filter->SetUpperMesh(source->GetUpperOutput());
  filter->SetLowerMesh(speck);
  try
  {
    filter->Update();
    FAIL() << "no exception";
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_NE(std::string(error.GetDescription()).find("No dental arch was found in the lower mesh"),
              std::string::npos);
  }
  filter->RequireArchesOff();
  filter->Update();
  EXPECT_FALSE(filter->GetJawFrame(JawEnum::Lower).valid);
  EXPECT_EQ(filter->GetLowerTransformOutput()->Get(), nullptr);
  EXPECT_EQ(filter->GetLowerOutput()->GetNumberOfPoints(), 0u);
  EXPECT_EQ(filter->GetJointTransformOutput()->Get(), nullptr);
  // The other jaw is none the worse for it.
  auto alone = FilterType::New();
  alone->SetUpperMesh(source->GetUpperOutput());
  alone->Update();
  ASSERT_NE(filter->GetUpperTransformOutput()->Get(), nullptr);
  EXPECT_EQ(filter->GetUpperTransformOutput()->Get()->GetMatrix(),
            alone->GetUpperTransformOutput()->Get()->GetMatrix());
}

TEST(UMidlineDentalAxisFilter, JawsShareFrameOffGivesEachJawTheFrameThatItHasAlone)
{
  auto source = MakeSource(6);
  auto pair = FilterType::New();
  pair->SetUpperMesh(source->GetUpperOutput());
  pair->SetLowerMesh(source->GetLowerOutput());
  pair->SetJawsShareFrame(FilterType::JawsShareFrameEnum::Off);
  pair->Update();
  EXPECT_FALSE(pair->GetJawsAreInOneFrame());
  EXPECT_TRUE(pair->GetFrame().occlusionPlausible) << "tested all the same";
  auto alone = FilterType::New();
  alone->SetUpperMesh(source->GetUpperOutput());
  alone->Update();
  EXPECT_EQ(pair->GetJawFrame(JawEnum::Upper).axes, alone->GetJawFrame(JawEnum::Upper).axes);
  // Back on: one lateral axis for both.
  pair->SetJawsShareFrame(FilterType::JawsShareFrameEnum::On);
  pair->Update();
  EXPECT_EQ(pair->GetJawFrame(JawEnum::Upper).axes[1], pair->GetJawFrame(JawEnum::Lower).axes[1]);
}

TEST(UMidlineDentalAxisFilter, EmbeddedAxesAreClosedArrowsOfTheStatedLengths)
{
  auto source = MakeSource(8);
  auto filter = FilterType::New();
  filter->SetUpperMesh(source->GetUpperOutput());
  filter->Update();
  const auto points = filter->GetUpperOutput()->GetNumberOfPoints();
  const auto cells = filter->GetUpperOutput()->GetNumberOfCells();
  filter->EmbedAxesOn();
  filter->SetAxesLength(30.0);
  filter->Update();
  const MeshType * mesh = filter->GetUpperOutput();
  EXPECT_EQ(mesh->GetNumberOfPoints(), points + 3 * 60);
  EXPECT_EQ(mesh->GetNumberOfCells(), cells + 3 * 72);
  EXPECT_EQ(mesh->GetPointData()->Size(), mesh->GetNumberOfPoints());
  double tips[3] = { 0.0, 0.0, 0.0 };
  for (auto id = points; id < mesh->GetNumberOfPoints(); ++id)
  {
    for (unsigned int d = 0; d < 3; ++d)
    {
      tips[d] = std::max(tips[d], static_cast<double>(mesh->GetPoint(id)[d]));
    }
  }
  EXPECT_NEAR(tips[0], 30.0, 1e-4);
  EXPECT_NEAR(tips[1], 24.0, 1e-4);
  EXPECT_NEAR(tips[2], 18.0, 1e-4);
  // Closed, and wound outward: the volume is positive for each arrow (divergence theorem).
  double volume = 0.0;
  for (auto id = cells; id < mesh->GetNumberOfCells(); ++id)
  {
    MeshType::CellAutoPointer cell;
    ASSERT_TRUE(mesh->GetCell(id, cell));
    const auto * ids = cell->GetPointIds();
    const auto   a = mesh->GetPoint(ids[0]);
    const auto   b = mesh->GetPoint(ids[1]);
    const auto   c = mesh->GetPoint(ids[2]);
    volume +=
      (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) /
      6.0;
  }
  // Shafts of twelve sides and cones, to a tenth.
  const double area = 3.0 * 0.36 * 0.36;
  const double headArea = 3.0 * 0.9 * 0.9;
  EXPECT_NEAR(volume, area * (27.0 + 21.0 + 15.0) + 3.0 * headArea * 3.0 / 3.0, 1.0);
}

TEST(UMidlineDentalAxisFilter, SameBitsForAnyNumberOfWorkUnitsAndOnARerun)
{
  auto source = MakeSource(9);
  auto filter = FilterType::New();
  filter->SetUpperMesh(source->GetUpperOutput());
  filter->SetLowerMesh(source->GetLowerOutput());
  filter->SetNumberOfWorkUnits(1);
  filter->Update();
  const auto first = filter->GetUpperTransformOutput()->Get()->GetMatrix();
  filter->SetNumberOfWorkUnits(7);
  filter->Update();
  EXPECT_EQ(first, filter->GetUpperTransformOutput()->Get()->GetMatrix());
  const auto executed = filter->GetUpperOutput()->GetMTime();
  filter->Update();
  EXPECT_EQ(executed, filter->GetUpperOutput()->GetMTime()) << "nothing changed, nothing runs";
}

TEST(UMidlineDentalAxisFilter, ErrorsNameWhatToDo)
{
  auto       filter = FilterType::New();
  const auto message = [&]() { return itk::MessageOfCall([&] { filter->Update(); }); };
  EXPECT_NE(message().find("SetUpperMesh() or SetLowerMesh()"), std::string::npos);
  filter->SetUpperMesh(MeshType::New());
  EXPECT_NE(message().find("no triangles"), std::string::npos);
  filter->SetCrownFraction(0.0);
  EXPECT_NE(message().find("CrownFraction is 0"), std::string::npos);
  EXPECT_THROW(filter->GetJawFrame(JawEnum::Unknown), std::invalid_argument) << "one of two frames would be a guess";
}

TEST(UMidlineDentalAxisFilter, AbortEndsTheExecutionWithProcessAborted)
{
  auto source = MakeSource(10);
  auto filter = FilterType::New();
  filter->SetUpperMesh(source->GetUpperOutput());
  source->Update();
  auto command = itk::CStyleCommand::New();
  command->SetCallback([](itk::Object * caller, const itk::EventObject &, void *) {
    static_cast<itk::ProcessObject *>(caller)->AbortGenerateDataOn();
  });
  filter->AddObserver(itk::ProgressEvent(), command);
  EXPECT_THROW(filter->Update(), itk::ProcessAborted);
}

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
#include "itkMidsagittalPlaneFilter.h"

#include "itkDentalFrameTestSupport.h"

#include "itkDentalPhantomMeshSource.h"
#include "itkTestingMacros.h"

#include <gtest/gtest.h>

namespace
{
using namespace DentalFrameTest;
using MeshType = itk::Mesh<float, 3>;
using FilterType = itk::MidsagittalPlaneFilter<MeshType>;

// ITK's macro returns from its function.
int
ExerciseBasicObjectMethods()
{
  auto filter = FilterType::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(filter, MidsagittalPlaneFilter, ProcessObject);
  return EXIT_SUCCESS;
}
} // namespace

TEST(MidsagittalPlaneFilter, ObeysTheBasicObjectContract)
{
  EXPECT_EQ(ExerciseBasicObjectMethods(), EXIT_SUCCESS);
}

TEST(MidsagittalPlaneFilter, FindsTheMidlineOfTurnedPairs)
{
  constexpr unsigned int seeds = 10;
  double                 meanYaw = 0.0;
  double                 meanMidline = 0.0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed)
  {
    auto source = itk::DentalPhantomMeshSource<MeshType>::New();
    auto parameters = itk::DentalPhantomParameters::Draw(seed);
    parameters.numberOfTriangles = 12000;
    source->SetParameters(parameters);
    auto filter = FilterType::New();
    filter->SetUpperMesh(source->GetUpperOutput());
    filter->SetLowerMesh(source->GetLowerOutput());
    filter->Update();
    const auto             rotation = source->GetFrameRotation(0);
    FilterType::VectorType left;
    FilterType::VectorType front;
    for (unsigned int d = 0; d < 3; ++d)
    {
      front[d] = rotation(d, 0);
      left[d] = rotation(d, 1);
    }
    EXPECT_GT(filter->GetNormal() * left, 0.99);
    FilterType::PointType origin;
    origin.Fill(0.0);
    origin += source->GetFrameTranslation(0);
    const double yaw = std::abs(std::asin(filter->GetNormal() * front)) * 180.0 / itk::Math::pi;
    const double midline = std::abs(filter->SignedDistance(origin));
    // The teeth of the two sides are turned and displaced independently: the arches' own asymmetry.
    EXPECT_LT(yaw, 1.5) << "degrees, seed " << seed;
    EXPECT_LT(midline, 0.5) << "mm, seed " << seed;
    meanYaw += yaw / seeds;
    meanMidline += midline / seeds;
    EXPECT_GT(filter->GetPlaneOutput()->Get().inlierFraction, 0.8);
  }
  EXPECT_LT(meanYaw, 0.6);
  EXPECT_LT(meanMidline, 0.2);
}

TEST(MidsagittalPlaneFilter, KernelRecoversTheExactPlaneOfAMirroredSet)
{
  // One half at random and its mirror image: the plane is known to rounding.
  itk::ReproducibleRandom random(8);
  const Motion            motion = RandomMotion(random);
  itk::OrientedPointSet   set;
  const auto              jaws = MakePhantom(60, 8000);
  const auto              normals = jaws[0].VertexNormals();
  for (std::size_t i = 0; i < jaws[0].points.size(); i += 2)
  {
    for (const double side : { -1.0, 1.0 })
    {
      const Vector3 p = jaws[0].points[i];
      const Vector3 n = normals[i];
      if (p[1] > 0.5)
      {
        set.points.push_back(motion({ p[0], side * p[1], p[2] }));
        set.normals.push_back(motion.Turn({ n[0], side * n[1], n[2] }));
      }
    }
  }
  itk::MidsagittalPlaneOptions options;
  // All samples, so that each has its mirror image among them.
  options.finalSamples = static_cast<unsigned int>(set.points.size());
  const auto    plane = itk::EstimateMidsagittalPlane({ set }, motion.Turn({ 0, 0, 1 }), { { 0, 0, 0 } }, options);
  const Vector3 truth = motion.Turn({ 0, 1, 0 });
  ASSERT_TRUE(plane.valid);
  const double sign = Dot(plane.normal, truth) < 0.0 ? -1.0 : 1.0;
  for (unsigned int d = 0; d < 3; ++d)
  {
    EXPECT_NEAR(sign * plane.normal[d], truth[d], 1e-9);
  }
  EXPECT_NEAR(sign * plane.offset, Dot(truth, motion.translation), 1e-7);
  EXPECT_LT(plane.residual, 1e-6);
  EXPECT_DOUBLE_EQ(plane.inlierFraction, 1.0);
}

TEST(MidsagittalPlaneFilter, TooFewSamplesGiveNoPlaneAndNoMeshIsAnErrorThatSaysWhatToCall)
{
  EXPECT_FALSE(itk::EstimateMidsagittalPlane({}, { { 0, 0, 1 } }, { { 0, 0, 0 } }, {}).valid);
  auto filter = FilterType::New();
  try
  {
    filter->Update();
    FAIL() << "no exception";
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_NE(std::string(error.GetDescription()).find("SetUpperMesh()"), std::string::npos);
  }
}

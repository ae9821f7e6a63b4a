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
#include "itkProjectionSimilarityFilter.h"

#include "itkMessageOfCall.h"
#include "itkPoseSolutionTestCase.h"

#include "itkTestingMacros.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using itk::MessageOfCall;
using namespace PoseSolutionTestCase;
using FilterType = itk::ProjectionSimilarityFilter;
using MeshType = FilterType::MeshType;

/** Points of a scan: an arch of some depth. */
MeshType::Pointer
MakeScan(double depth)
{
  auto                    mesh = MeshType::New();
  itk::ReproducibleRandom random(11);
  for (unsigned int i = 0; i < 200; ++i)
  {
    MeshType::PointType point;
    point[0] = static_cast<float>(random.Uniform(-20.0, 25.0));
    point[1] = static_cast<float>(random.Uniform(-depth, depth));
    point[2] = static_cast<float>(random.Uniform(-8.0, 8.0));
    mesh->SetPoint(i, point);
  }
  return mesh;
}

FilterType::FrameType::Pointer
MakeFrame(const itk::PoseFrame & frame)
{
  auto                                            transform = itk::VersorRigid3DTransform<double>::New();
  itk::VersorRigid3DTransform<double>::MatrixType matrix;
  itk::VersorRigid3DTransform<double>::OffsetType offset;
  for (unsigned int a = 0; a < 3; ++a)
  {
    offset[a] = 0.0;
    for (unsigned int b = 0; b < 3; ++b)
    {
      matrix(a, b) = frame.rotation[3 * a + b];
      offset[a] -= frame.rotation[3 * a + b] * frame.origin[b];
    }
  }
  transform->SetMatrix(matrix);
  transform->SetOffset(offset);
  auto decorated = FilterType::FrameType::New();
  decorated->Set(transform);
  return decorated;
}

FilterType::Pointer
Fit(const itk::PoseRegistrationResult & result, const MeshType * mesh, JawEnum jaw)
{
  auto filter = FilterType::New();
  filter->SetSolution(MakeSolution(result));
  filter->SetMesh(mesh);
  filter->SetFrame(MakeFrame(result.jaws[jaw == JawEnum::Upper ? 0 : 1].frame));
  filter->SetJaw(jaw);
  filter->Update();
  return filter;
}

/** Projection of the frame as it is documented, q = (f m x / sp_u, -m z / sp_v), and the place on the radiograph. */
void
Places(const itk::PoseRegistrationResult & result,
       unsigned int                        jaw,
       const MeshType::PointType &         point,
       double                              q[2],
       double                              p[2])
{
  const auto & frame = result.jaws[jaw].frame;
  const auto & g = result.geometry;
  double       d[3];
  for (unsigned int k = 0; k < 3; ++k)
  {
    d[k] = 0.0;
    for (unsigned int c = 0; c < 3; ++c)
    {
      d[k] += frame.rotation[3 * k + c] * (point[c] - frame.origin[c]);
    }
  }
  const double m = g.sourceToDetector / (g.sourceToMidsagittal + g.sourceSign * d[1]);
  q[0] = g.facingSign * m * d[0] / g.pixelSpacing[0];
  q[1] = -m * d[2] / g.pixelSpacing[1];
  const auto & a = result.jaws[jaw].projection;
  const double w = a[8] * point[0] + a[9] * point[1] + a[10] * point[2] + a[11];
  for (unsigned int k = 0; k < 2; ++k)
  {
    p[k] = (a[4 * k] * point[0] + a[4 * k + 1] * point[1] + a[4 * k + 2] * point[2] + a[4 * k + 3]) / w;
  }
}

/** What a similarity leaves, px. */
double
RMSOf(const itk::PoseRegistrationResult &               result,
      unsigned int                                      jaw,
      const MeshType *                                  mesh,
      const FilterType::TransformType::ParametersType & s)
{
  double sum = 0.0;
  for (auto it = mesh->GetPoints()->Begin(); it != mesh->GetPoints()->End(); ++it)
  {
    double q[2], p[2];
    Places(result, jaw, it.Value(), q, p);
    const double u = s[0] * (std::cos(s[1]) * q[0] - std::sin(s[1]) * q[1]) + s[2] - p[0];
    const double v = s[0] * (std::sin(s[1]) * q[0] + std::cos(s[1]) * q[1]) + s[3] - p[1];
    sum += u * u + v * v;
  }
  return std::sqrt(sum / static_cast<double>(mesh->GetNumberOfPoints()));
}

int
ExerciseBasicObjectMethods()
{
  const auto filter = FilterType::New();
  ITK_EXERCISE_BASIC_OBJECT_METHODS(filter, ProjectionSimilarityFilter, ProcessObject);
  return EXIT_SUCCESS;
}
} // namespace

TEST(ProjectionSimilarityFilter, BasicObjectMethodsAndDefaults)
{
  EXPECT_EQ(ExerciseBasicObjectMethods(), EXIT_SUCCESS);
  EXPECT_EQ(FilterType::New()->GetJaw(), JawEnum::Upper);
}

TEST(ProjectionSimilarityFilter, RMSIsThatOfTheSimilarityBesideItAndNoOtherIsNearer)
{
  const auto mesh = MakeScan(25.0);
  for (const double facing : { 1.0, -1.0 })
  {
    const auto result = MakeResult(facing, facing);
    for (const JawEnum jaw : Jaws)
    {
      const unsigned int j = jaw == JawEnum::Upper ? 0 : 1;
      const auto         filter = Fit(result, mesh, jaw);
      const auto         parameters = filter->GetTransform()->GetParameters();
      const double       rms = filter->GetRMS();
      // The parallax of 25 mm under roll and yaw of some degrees: pixels.
      EXPECT_GT(rms, 1.0);
      EXPECT_NEAR(rms, RMSOf(result, j, mesh, parameters), 1e-9);
      for (unsigned int k = 0; k < 4; ++k)
      {
        for (const double step : { -1.0, 1.0 })
        {
          auto other = parameters;
          other[k] += step * (k < 2 ? 1e-3 : 0.05);
          EXPECT_GT(RMSOf(result, j, mesh, other), rms) << k;
        }
      }
    }
  }
}

TEST(ProjectionSimilarityFilter, APoseInTheFilmsPlaneOfAFlatScanIsASimilarity)
{
  auto result = MakeResult();
  // Square pixels, or a rotation is none. Pitch, shift and scale are a similarity of what lies in the frame's plane.
  result.geometry.pixelSpacing = { { 0.25, 0.25 } };
  result.jaws[0].frame = itk::PoseFrame();
  result.groups[0].parameters = { { 0.2, 0.0, 0.0, 5.0, 0.0, -3.0, 0.05 } };
  const itk::PoseModel model(result.geometry, result.groups[0].parameters);
  result.jaws[0].projection = model.GetPixelProjection(result.jaws[0].frame);
  const auto filter = Fit(result, MakeScan(0.0), JawEnum::Upper);
  EXPECT_NEAR(filter->GetTransform()->GetParameters()[0], std::exp(0.05), 1e-9);
  EXPECT_NEAR(std::abs(filter->GetTransform()->GetParameters()[1]), 0.2, 1e-9);
  // A difference of squares of some 100 px leaves their rounding's root.
  EXPECT_LT(filter->GetRMS(), 1e-4);
}

TEST(ProjectionSimilarityFilter, ErrorsSayWhatToGive)
{
  auto       result = MakeResult();
  const auto mesh = MakeScan(25.0);
  result.jaws[0].registered = false;
  EXPECT_TRUE(Contains(MessageOfCall([&] { Fit(result, mesh, JawEnum::Upper); }), "The upper jaw was not registered"));
  auto filter = FilterType::New();
  filter->SetSolution(MakeSolution(MakeResult()));
  filter->SetMesh(mesh);
  EXPECT_TRUE(Contains(MessageOfCall([&] { filter->Update(); }), "Frame"));
  filter->SetFrame(FilterType::FrameType::New());
  EXPECT_TRUE(Contains(MessageOfCall([&] { filter->Update(); }), "The frame is empty: give SetFrame()"));
  EXPECT_TRUE(Contains(MessageOfCall([&] { Fit(MakeResult(), MeshType::New(), JawEnum::Lower); }), "SetMesh()"));
  const auto point = MeshType::New();
  point->SetPoint(0, mesh->GetPoint(0));
  EXPECT_TRUE(Contains(MessageOfCall([&] { Fit(MakeResult(), point, JawEnum::Lower); }), "no extent"));
}

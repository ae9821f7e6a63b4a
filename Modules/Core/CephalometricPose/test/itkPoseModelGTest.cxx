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
#include "itkPoseModel.h"

#include "itkPoseFrameOperations.h"
#include "itkRigidTransformRows.h"

#include "itkAffineTransform.h"
#include "itkVersorRigid3DTransform.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace
{
const itk::PoseParameters pose{ { 0.2, -0.05, 0.08, 55.0, 1.5, -40.0, 0.01 } };

itk::PoseGeometry
Geometry(double source, double facing, bool isFrontal = false)
{
  itk::PoseGeometry geometry;
  geometry.direction = isFrontal ? itk::CephalometricDirectionEnum::Frontal : itk::CephalometricDirectionEnum::Lateral;
  geometry.sourceSign = source;
  geometry.facingSign = facing;
  geometry.pixelSpacing = { { 0.2, 0.3 } };
  geometry.principalPoint = { { 100.0, 200.0 } };
  return geometry;
}
} // namespace

TEST(PoseModel, JacobianMatchesDifferences)
{
  const double p[3] = { 12.0, -21.0, 7.0 };
  for (double source : { 1.0, -1.0 })
  {
    for (const bool isFrontal : { false, true })
    {
      const itk::PoseGeometry geometry = Geometry(source, 1.0, isFrontal);
      double                  w[2], jacobian[14];
      ASSERT_TRUE(itk::PoseModel(geometry, pose).ProjectWithJacobian(p, w, jacobian));
      for (unsigned int k = 0; k < 7; ++k)
      {
        const double        h = 1e-5;
        itk::PoseParameters a = pose, b = pose;
        a[k] -= h;
        b[k] += h;
        double wa[2], wb[2];
        itk::PoseModel(geometry, a).Project(p, wa);
        itk::PoseModel(geometry, b).Project(p, wb);
        // Central differences: error h^2 times third derivatives of a few hundred, and 1e-13 * 300 / h of rounding.
        EXPECT_NEAR(jacobian[k], (wb[0] - wa[0]) / (2 * h), 2e-6) << k;
        EXPECT_NEAR(jacobian[7 + k], (wb[1] - wa[1]) / (2 * h), 2e-6) << k;
      }
    }
  }
}

TEST(PoseModel, ProjectionsForKernelsAndForPixelsAgreeInAllGeometries)
{
  itk::PoseFrame frame;
  frame.rotation = { { 0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0 } };
  frame.origin = { { 3.0, -4.0, 5.0 } };
  const double mesh[3] = { 10.0, 20.0, 30.0 };
  const double p[3] = { 24.0, -7.0, 25.0 };
  for (double source : { 1.0, -1.0 })
  {
    for (double facing : { 1.0, -1.0 })
    {
      for (const bool isFrontal : { false, true })
      {
        const itk::PoseGeometry geometry = Geometry(source, facing, isFrontal);
        const itk::PoseModel    model(geometry, pose);
        double                  w[2], u, v;
        model.Project(p, w);
        model.GetProjection().Project(p, u, v);
        EXPECT_NEAR(u, w[0], 1e-9);
        EXPECT_NEAR(v, w[1], 1e-9);
        itk::PerspectiveProjection pixel;
        pixel.matrix = model.GetPixelProjection(frame);
        pixel.Project(mesh, u, v);
        const auto expected = itk::PoseModel::ToPixel(geometry, { { w[0], w[1] } });
        EXPECT_NEAR(u, expected[0], 1e-9);
        EXPECT_NEAR(v, expected[1], 1e-9);
        const auto back = itk::PoseModel::ToWorkingPlane(geometry, expected);
        EXPECT_NEAR(back[0], w[0], 1e-9);
        EXPECT_NEAR(back[1], w[1], 1e-9);

        // The formula of the contract, written out.
        const auto & r = model.GetRotation();
        double       c[3];
        for (int k = 0; k < 3; ++k)
        {
          c[k] = r[3 * k] * p[0] + r[3 * k + 1] * p[1] + r[3 * k + 2] * p[2] + pose[3 + k];
        }
        const double m = std::exp(pose[6]) * 1674.0 / (1524.0 + source * c[isFrontal ? 0 : 1]);
        EXPECT_NEAR(expected[0], 100.0 + facing * m * c[isFrontal ? 1 : 0] / 0.2, 1e-9);
        EXPECT_NEAR(expected[1], 200.0 - m * c[2] / 0.3, 1e-9);
      }
    }
  }
}

TEST(PoseModel, ANormalStaysAcrossItsLineInPixelsThatAreNoSquares)
{
  for (const double facing : { 1.0, -1.0 })
  {
    itk::PoseGeometry geometry = Geometry(1.0, facing, false);
    geometry.pixelSpacing = { { 0.1, 0.3 } };
    // A line along (4, 3), its normal (0.6, -0.8).
    const auto   normal = itk::PoseModel::ToPixelNormal(geometry, { { 0.6, -0.8 } });
    const auto   from = itk::PoseModel::ToPixel(geometry, { { 0.0, 0.0 } });
    const auto   to = itk::PoseModel::ToPixel(geometry, { { 4.0, 3.0 } });
    const auto   outside = itk::PoseModel::ToPixel(geometry, { { 0.6, -0.8 } });
    const double along = normal[0] * (to[0] - from[0]) + normal[1] * (to[1] - from[1]);
    EXPECT_NEAR(along, 0.0, 1e-12);
    EXPECT_NEAR(std::hypot(normal[0], normal[1]), 1.0, 1e-12);
    EXPECT_GT(normal[0] * (outside[0] - from[0]) + normal[1] * (outside[1] - from[1]), 0.0);
  }
}

/** Of parameters that move together: J (A A') J' is (J A) (J A)'. A diagonal covariance would not tell rows from
 * columns. */
TEST(PoseModel, CovarianceIsPropagatedWithItsCorrelations)
{
  double                 jacobian[14];
  double                 factor[7][2];
  std::array<double, 49> covariance{};
  for (int i = 0; i < 7; ++i)
  {
    jacobian[i] = 1.0 + 0.5 * i;
    jacobian[7 + i] = 2.0 - 0.75 * i;
    factor[i][0] = 0.25 * (i - 3);
    factor[i][1] = 1.0 / (i + 1);
  }
  double moved[2][2] = {};
  for (int i = 0; i < 7; ++i)
  {
    for (int k = 0; k < 7; ++k)
    {
      covariance[7 * i + k] = factor[i][0] * factor[k][0] + factor[i][1] * factor[k][1];
    }
    for (int a = 0; a < 2; ++a)
    {
      moved[a][0] += jacobian[7 * a + i] * factor[i][0];
      moved[a][1] += jacobian[7 * a + i] * factor[i][1];
    }
  }
  const auto result = itk::PoseModel::PropagateCovariance(jacobian, covariance);
  for (int a = 0; a < 2; ++a)
  {
    for (int b = 0; b < 2; ++b)
    {
      EXPECT_NEAR(result[2 * a + b], moved[a][0] * moved[b][0] + moved[a][1] * moved[b][1], 1e-12);
    }
  }
}

TEST(PoseModel, SourceProjectsNowhere)
{
  for (const bool isFrontal : { false, true })
  {
    const auto projection = itk::PoseModel(Geometry(-1.0, 1.0, isFrontal), pose).GetProjection();
    EXPECT_NEAR(projection.Depth(projection.source.data()), 0.0, 1e-12);
  }
}

TEST(PoseModel, SolvedTranslationBringsThePointThere)
{
  const double        p[3] = { 12.0, -21.0, 7.0 };
  const double        target[2] = { 321.0, -55.0 };
  itk::PoseParameters moved = pose;
  itk::PoseModel(Geometry(1.0, 1.0), pose).SolveTranslation(p, target, moved[itk::PoseTx], moved[itk::PoseTz]);
  double w[2];
  itk::PoseModel(Geometry(1.0, 1.0), moved).Project(p, w);
  EXPECT_NEAR(w[0], target[0], 1e-9);
  EXPECT_NEAR(w[1], target[1], 1e-9);
  moved = pose;
  itk::PoseModel(Geometry(1.0, 1.0, true), pose).SolveTranslation(p, target, moved[itk::PoseTy], moved[itk::PoseTz]);
  itk::PoseModel(Geometry(1.0, 1.0, true), moved).Project(p, w);
  EXPECT_NEAR(w[0], target[0], 1e-9);
  EXPECT_NEAR(w[1], target[1], 1e-9);
}

TEST(PoseModel, APoseOfAnotherGeometryKeepsPlaceAndSizeOnTheRadiograph)
{
  const itk::PoseGeometry then = Geometry(1.0, 1.0, false);
  const double            middle[3] = { 10.0, 2.0, -5.0 };
  EXPECT_EQ(itk::PoseModel::ConvertPose(then, pose, then, middle), pose);
  for (const bool frontal : { false, true })
  {
    const itk::PoseGeometry from = Geometry(1.0, 1.0, frontal);
    itk::PoseGeometry       to = from;
    to.pixelSpacing = { { 0.6 * from.pixelSpacing[0], 0.6 * from.pixelSpacing[1] } };
    to.principalPoint = { { from.principalPoint[0] + 40.0, from.principalPoint[1] - 25.0 } };
    to.sourceToMidsagittal = from.sourceToMidsagittal - 100.0;
    const auto converted = itk::PoseModel::ConvertPose(from, pose, to, middle);
    for (const auto angle : { itk::PosePitch, itk::PoseRoll, itk::PoseYaw })
    {
      EXPECT_EQ(converted[angle], pose[angle]);
    }
    const auto pixel =
      [](const itk::PoseGeometry & geometry, const itk::PoseParameters & parameters, const double p[3]) {
        double w[2];
        EXPECT_TRUE(itk::PoseModel(geometry, parameters).Project(p, w));
        return itk::PoseModel::ToPixel(geometry, { { w[0], w[1] } });
      };
    for (const double ahead : { 0.0, 20.0 })
    {
      const double place[3] = { middle[0] + (frontal ? 0.0 : ahead), middle[1] + (frontal ? ahead : 0.0), middle[2] };
      const auto   before = pixel(from, pose, place);
      const auto   behind = pixel(to, converted, place);
      for (unsigned int d = 0; d < 2; ++d)
      {
        // Exact in the middle; farther out the rays of a source that is 100 mm nearer spread otherwise.
        EXPECT_NEAR(behind[d], before[d], ahead == 0.0 ? 1e-9 : 1.0) << frontal << ' ' << ahead;
      }
    }
  }
}

TEST(PoseModel, AFrameGoesToTheMeshAndBackForPointsAndForMotions)
{
  auto                transform = itk::VersorRigid3DTransform<double>::New();
  itk::Versor<double> versor;
  versor.Set(0.1, -0.3, 0.2, 0.8);
  transform->SetRotation(versor);
  const double shiftOfFrame[3] = { 4.0, -7.0, 2.5 };
  transform->SetTranslation(itk::Vector<double, 3>(shiftOfFrame));
  const auto                  frame = itk::ToPoseFrame(*transform);
  const std::array<double, 3> mesh{ { 12.0, -5.0, 31.0 } };
  const auto                  dental = itk::ToDentalFrame(frame, mesh);
  const auto                  expected = transform->TransformPoint(itk::Point<double, 3>(mesh.data()));
  const auto                  back = itk::ToMeshFrame(frame, dental);
  for (unsigned int d = 0; d < 3; ++d)
  {
    // Rounding of sums of three products of numbers up to 40.
    EXPECT_NEAR(dental[d], expected[d], 1e-12);
    EXPECT_NEAR(back[d], mesh[d], 1e-12);
  }

  // A motion of dental points is one of mesh points: the same place at the end, and the way back gives the motion
  // again.
  std::array<double, 9>       rotation;
  const itk::PoseModel        model(itk::PoseGeometry(), pose);
  const std::array<double, 3> shift{ { pose[itk::PoseTx], pose[itk::PoseTx + 1], pose[itk::PoseTx + 2] } };
  std::array<double, 3>       translation;
  itk::ToMeshMotion(frame, model.GetRotation(), shift, rotation, translation);
  auto ofMesh = itk::AffineTransform<double, 3>::New();
  auto matrix = ofMesh->GetMatrix();
  for (unsigned int i = 0; i < 3; ++i)
  {
    double ofDental = shift[i];
    double placed = translation[i];
    for (unsigned int j = 0; j < 3; ++j)
    {
      ofDental += model.GetRotation()[3 * i + j] * dental[j];
      placed += rotation[3 * i + j] * mesh[j];
      matrix(i, j) = rotation[3 * i + j];
    }
    EXPECT_NEAR(placed, ofDental, 1e-12);
  }
  ofMesh->SetMatrix(matrix);
  ofMesh->SetOffset(itk::Vector<double, 3>(translation.data()));
  std::array<double, 9> again;
  std::array<double, 3> shiftAgain;
  itk::ToDentalMotion(frame, *ofMesh, again, shiftAgain);
  for (unsigned int i = 0; i < 9; ++i)
  {
    EXPECT_NEAR(again[i], model.GetRotation()[i], 1e-14);
  }
  for (unsigned int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(shiftAgain[i], shift[i], 1e-12);
  }
}

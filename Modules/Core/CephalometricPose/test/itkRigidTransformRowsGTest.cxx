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
#include "itkRigidTransformRows.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
/** A turn about z by the angle of (3, 4) / 5, and a shift. */
const itk::RigidTransformRows Rows{ { 0.6, -0.8, 0.0, 10.0, 0.8, 0.6, 0.0, -20.0, 0.0, 0.0, 1.0, 30.0 } };
} // namespace

TEST(RigidTransformRows, LeadToATransformAndBack)
{
  const auto                                          transform = itk::ToRigidTransform(Rows, 1e-10);
  itk::VersorRigid3DTransform<double>::InputPointType point;
  point[0] = 5.0;
  point[1] = 10.0;
  point[2] = 1.0;
  const auto moved = transform->TransformPoint(point);
  EXPECT_NEAR(moved[0], 0.6 * 5.0 - 0.8 * 10.0 + 10.0, 1e-12);
  EXPECT_NEAR(moved[1], 0.8 * 5.0 + 0.6 * 10.0 - 20.0, 1e-12);
  EXPECT_NEAR(moved[2], 31.0, 1e-12);
  const itk::RigidTransformRows back = itk::ToRows(*transform);
  for (unsigned int i = 0; i < 12; ++i)
  {
    EXPECT_NEAR(back[i], Rows[i], 1e-12) << i;
  }
  itk::RigidTransformRows stretched = Rows;
  stretched[10] = 1.01;
  EXPECT_THROW(itk::ToRigidTransform(stretched, 1e-3), itk::ExceptionObject);
}

TEST(RigidTransformRows, SplitAndJoinWithTheSameBits)
{
  std::array<double, 9> rotation;
  std::array<double, 3> translation;
  itk::SplitRigidTransformRows(Rows, rotation, translation);
  EXPECT_EQ(rotation[1], -0.8);
  EXPECT_EQ(rotation[3], 0.8);
  EXPECT_EQ(translation[2], 30.0);
  EXPECT_EQ(itk::MakeRigidTransformRows(rotation, translation), Rows);
  itk::Matrix<double, 3, 3> matrix;
  itk::Vector<double, 3>    vector;
  itk::SplitRigidTransformRows(Rows, matrix, vector);
  EXPECT_EQ(matrix(0, 1), -0.8);
  EXPECT_EQ(itk::MakeRigidTransformRows(matrix, vector), Rows);
}

TEST(RigidTransformRows, OfAFrameHaveItsOriginAtNought)
{
  itk::PoseFrame frame;
  frame.rotation = { { 0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0 } };
  frame.origin = { { 5.0, 10.0, -2.0 } };
  const auto rows = itk::ToRows(frame);
  // q = R (p - o) = R p - R o, R o = (-5, 10, -2).
  EXPECT_NEAR(rows[3], 5.0, 1e-12);
  EXPECT_NEAR(rows[7], -10.0, 1e-12);
  EXPECT_NEAR(rows[11], 2.0, 1e-12);
  const itk::PoseFrame back = itk::ToPoseFrame(rows);
  EXPECT_EQ(back.rotation, frame.rotation);
  for (unsigned int d = 0; d < 3; ++d)
  {
    EXPECT_NEAR(back.origin[d], frame.origin[d], 1e-12) << d;
  }
}

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
#include "itkPoseComposition.h"

#include "itkPoseModel.h"

#include <gtest/gtest.h>

namespace
{
using SixType = itk::PoseComposition::SixType;

const SixType pose{ { 0.2, -0.05, 0.08, 55.0, 1.5, -40.0 } };
const SixType head{ { -0.06, 0.03, 0.4, 1.2, -2.0, 0.7 } };

itk::PoseModel
MakeModel(const SixType & six)
{
  itk::PoseParameters parameters{};
  std::copy(six.begin(), six.end(), parameters.begin());
  return { itk::PoseGeometry(), parameters };
}

std::array<double, 3>
Move(const SixType & six, const std::array<double, 3> & p)
{
  const auto            r = MakeModel(six).GetRotation();
  std::array<double, 3> c;
  for (unsigned int k = 0; k < 3; ++k)
  {
    c[k] = r[3 * k] * p[0] + r[3 * k + 1] * p[1] + r[3 * k + 2] * p[2] + six[3 + k];
  }
  return c;
}
} // namespace

TEST(PoseComposition, IsThePoseAndThenTheMove)
{
  const itk::PoseComposition composition(pose, head);
  for (const std::array<double, 3> & p :
       { std::array<double, 3>{ { 12.0, -21.0, 7.0 } }, std::array<double, 3>{ { -30.0, 4.0, 2.0 } } })
  {
    const auto expected = Move(head, Move(pose, p));
    const auto composed = Move(composition.GetPose(), p);
    for (unsigned int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(composed[k], expected[k], 1e-12);
    }
  }
}

TEST(PoseComposition, WithoutAMoveNothingChanges)
{
  const itk::PoseComposition composition(pose, SixType{});
  for (unsigned int k = 0; k < 6; ++k)
  {
    EXPECT_NEAR(composition.GetPose()[k], pose[k], 1e-15);
    for (unsigned int j = 0; j < 6; ++j)
    {
      EXPECT_NEAR(composition.GetJacobian()[12 * k + j], k == j ? 1.0 : 0.0, 1e-14);
    }
  }
}

TEST(PoseComposition, JacobianMatchesDifferences)
{
  const itk::PoseComposition composition(pose, head);
  for (unsigned int k = 0; k < 12; ++k)
  {
    const double h = 1e-6;
    SixType      body[2] = { pose, pose };
    SixType      move[2] = { head, head };
    (k < 6 ? body[0][k] : move[0][k - 6]) -= h;
    (k < 6 ? body[1][k] : move[1][k - 6]) += h;
    const itk::PoseComposition less(body[0], move[0]);
    const itk::PoseComposition more(body[1], move[1]);
    for (unsigned int i = 0; i < 6; ++i)
    {
      // Rounding of up to 55 mm over the step.
      EXPECT_NEAR(composition.GetJacobian()[12 * i + k], (more.GetPose()[i] - less.GetPose()[i]) / (2.0 * h), 2e-8)
        << i << ", " << k;
    }
  }
}

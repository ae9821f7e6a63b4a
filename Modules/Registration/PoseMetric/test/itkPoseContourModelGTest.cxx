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
#include "itkPoseMeshContourModel.h"
#include "itkMessageOfCall.h"

#include "itkMacro.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>

namespace
{
/** A roof over the midline plane, open below. */
itk::TriangleSurface
MakeRoof()
{
  itk::TriangleSurface surface;
  surface.points = { { { 0.0F, -20.0F, 0.0F } },
                     { { 0.0F, -5.0F, 0.0F } },
                     { { 40.0F, -20.0F, 0.0F } },
                     { { 40.0F, -5.0F, 0.0F } },
                     { { 20.0F, -12.0F, -8.0F } } };
  surface.triangles = { { { 0, 1, 4 } }, { { 1, 3, 4 } }, { { 3, 2, 4 } }, { { 2, 0, 4 } } };
  return surface;
}

itk::PoseGeometry
MakeGeometry()
{
  itk::PoseGeometry geometry;
  geometry.sourceToMidsagittal = 1524.0;
  geometry.sourceToDetector = 1674.0;
  geometry.pixelSpacing = { { 0.25, 0.25 } };
  return geometry;
}

/** Empty where there is an outline. */
std::string
MessageAt(unsigned int parameter, double value)
{
  const itk::PoseMeshContourModel model(MakeRoof(), itk::ToothCode::JawEnum::Upper, false);
  itk::PoseParameters             pose{ {} };
  pose[parameter] = value;
  return itk::MessageOfCall([&] { EXPECT_GT(model.Compute(itk::PoseModel(MakeGeometry(), pose)).Size(), 10u); });
}

bool
Contains(const std::string & text, const char * part)
{
  return text.find(part) != std::string::npos;
}
} // namespace

TEST(PoseContourModel, TakesEveryPoseOfAScanBeforeTheSource)
{
  EXPECT_EQ(MessageAt(itk::PosePitch, 0.0), "");
  // Far beyond what is searched, and what LBFGSB's bounds leave: a factor e, 64 mm, a radian.
  EXPECT_EQ(MessageAt(itk::PoseKappa, 1.0), "");
  EXPECT_EQ(MessageAt(itk::PoseTy, -500.0), "");
  EXPECT_EQ(MessageAt(itk::PoseTx, 500.0), "");
  EXPECT_EQ(MessageAt(itk::PosePitch, 3.0), "");
}

TEST(PoseContourModel, ASampleIsNotMovedToAnAbsurdPoseEither)
{
  const itk::PoseMeshContourModel model(MakeRoof(), itk::ToothCode::JawEnum::Upper, false);
  const itk::PoseModel            from(MakeGeometry(), itk::PoseParameters{ {} });
  const itk::PoseContour          contour = model.Compute(from);
  for (const auto & move : { std::make_pair(itk::PoseTy, -2000.0), std::make_pair(itk::PoseKappa, 10.0) })
  {
    itk::PoseParameters pose{ {} };
    pose[move.first] = move.second;
    auto moved = contour;
    EXPECT_THROW(itk::PoseContourModel::Reproject(moved, from, itk::PoseModel(MakeGeometry(), pose)),
                 itk::ExceptionObject);
  }
  itk::PoseParameters pose{ {} };
  pose[itk::PoseTx] = 5.0;
  auto moved = contour;
  EXPECT_NO_THROW(itk::PoseContourModel::Reproject(moved, from, itk::PoseModel(MakeGeometry(), pose)));
}

TEST(PoseContourModel, SaysWhatIsWrongWithAnAbsurdPose)
{
  const std::string behind = MessageAt(itk::PoseTy, -2000.0);
  EXPECT_TRUE(Contains(behind, "does not lie in front of the X-ray source")) << behind;
  EXPECT_TRUE(Contains(behind, "ty -2000")) << behind;
  EXPECT_TRUE(Contains(behind, "learning rate")) << behind;
  EXPECT_TRUE(Contains(MessageAt(itk::PoseKappa, 10.0), "more than 5 m large"));
  EXPECT_TRUE(Contains(MessageAt(itk::PoseTx, std::numeric_limits<double>::quiet_NaN()), "not finite"));
  EXPECT_TRUE(Contains(MessageAt(itk::PoseKappa, 1000.0), "not finite"));
}

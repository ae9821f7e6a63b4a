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
#include "itkDentalLandmarkSet.h"

#include <gtest/gtest.h>

#include <stdexcept>

TEST(DentalLandmarkSet, KeepsOrderAndFindsByName)
{
  const auto                           landmarks = itk::DentalLandmarkSet<2>::New();
  itk::DentalLandmarkSet<2>::PointType point;
  point[0] = 3.5;
  point[1] = -1.0;
  landmarks->AddLandmark("UR6_MB", point);
  landmarks->AddLandmark("LR1_tip", point);
  ASSERT_EQ(landmarks->GetNumberOfLandmarks(), 2u);
  EXPECT_EQ(landmarks->GetLandmarks()[0].tooth.GetName(), "UR6");
  ASSERT_NE(landmarks->Find("LR1_tip"), nullptr);
  EXPECT_EQ(landmarks->Find("LR1_tip")->point, point);
  EXPECT_EQ(landmarks->Find("LR2_tip"), nullptr);
}

TEST(DentalLandmarkSet, RefusesOtherNamesAndRepetition)
{
  const auto                           landmarks = itk::DentalLandmarkSet<3>::New();
  itk::DentalLandmarkSet<3>::PointType point;
  point.Fill(0.0);
  for (const char * name : { "", "UR6", "UR6_", "UR6_X", "UR9_MB", "_MB", "UR6_mb" })
  {
    EXPECT_THROW(landmarks->AddLandmark(name, point), std::invalid_argument) << name;
  }
  landmarks->AddLandmark("UR6_MB", point);
  EXPECT_THROW(landmarks->AddLandmark("UR6_MB", point), std::invalid_argument);
}

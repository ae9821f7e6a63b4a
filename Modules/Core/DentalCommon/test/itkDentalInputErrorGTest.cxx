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
#include "itkDentalInputError.h"
#include "itkShortNumber.h"

#include <gtest/gtest.h>

#include <limits>

TEST(DentalInputError, IsOneLineThatNamesFileFieldAndRemedy)
{
  const itk::DentalInputError error(
    __FILE__, __LINE__, "case.json", "contours", "missing\nfield", "add the path of the tracing");
  EXPECT_EQ(error.GetOneLine(), "case.json: contours: missing field; add the path of the tracing");
  EXPECT_EQ(error.GetDescription(), error.GetOneLine());
}

TEST(DentalInputError, LeavesOutWhatIsEmpty)
{
  EXPECT_EQ(itk::DentalInputError(__FILE__, __LINE__, "a.stl", "", "is empty").GetOneLine(), "a.stl: is empty");
}

TEST(DentalInputError, IsCaughtAsAnItkException)
{
  EXPECT_THROW(itkDentalInputErrorMacro("a", "b", "c", "d"), itk::ExceptionObject);
}

TEST(ShortNumber, HasFewDigitsWhateverItIs)
{
  EXPECT_EQ(itk::ShortNumber(0.25), "0.25");
  EXPECT_EQ(itk::ShortNumber(-1.0), "-1");
  EXPECT_EQ(itk::ShortNumber(1674.123456), "1674.12");
  EXPECT_EQ(itk::ShortNumber(1e300), "1e+300");
  EXPECT_EQ(itk::ShortNumber(-4.9e-324), "-4.94066e-324");
  EXPECT_EQ(itk::ShortNumber(std::numeric_limits<double>::infinity()), "inf");
}

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
#include "itkRequireJsonName.h"

#include "itkDentalInputError.h"

#include "gtest/gtest.h"

TEST(RequireJsonName, TakesJsonAndNamesWithoutAnExtension)
{
  for (const char * name : { "a.json", "a.JSON", "folder.csv/a.json", "a.b.json", "/dev/stdout", "a", "" })
  {
    EXPECT_NO_THROW(itk::RequireJsonName(name, "contours")) << name;
  }
}

TEST(RequireJsonName, RefusesNamesOfOtherFormats)
{
  for (const char * name : { "a.csv", "a.txt", "a.png", "a.json.gz", "a.mrk.json", "a.mrk.JSON" })
  {
    try
    {
      itk::RequireJsonName(name, "contours");
      ADD_FAILURE() << name << " was taken";
    }
    catch (const itk::DentalInputError & error)
    {
      EXPECT_EQ(error.GetInputFile(), name);
      EXPECT_NE(error.GetRemedy().find(".json"), std::string::npos);
      EXPECT_NE(error.GetProblem().find("contours"), std::string::npos);
    }
  }
}

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
#include "itkMakeUTF8.h"

#include "itkDentalInputError.h"

#include <gtest/gtest.h>

TEST(MakeUTF8, WhatIsInUTF8StaysAsItIs)
{
  for (const char * text : { "",
                             "UR1",
                             "H\xc3\xb6"
                             "cker",
                             "\xe4\xb8\xad\xe6\x96\x87",
                             "\xf0\x9f\xa6\xb7",
                             "\xef\xbf\xbd" })
  {
    EXPECT_EQ(itk::MakeUTF8(text), text);
  }
}

TEST(MakeUTF8, OtherBytesAreLettersOfWesternEurope)
{
  EXPECT_EQ(itk::MakeUTF8("H\xf6"
                          "cker"),
            "H\xc3\xb6"
            "cker");
  EXPECT_EQ(itk::MakeUTF8("\xff"), "\xc3\xbf");
  // A character that was cut off, a spelling longer than needed, half of a pair, one beyond the last.
  EXPECT_EQ(itk::MakeUTF8("a\xe4\xb8"), "a\xc3\xa4\xc2\xb8");
  EXPECT_EQ(itk::MakeUTF8("\xc0\x80"), "\xc3\x80\xc2\x80");
  EXPECT_EQ(itk::MakeUTF8("\xed\xa0\x80"), "\xc3\xad\xc2\xa0\xc2\x80");
  EXPECT_EQ(itk::MakeUTF8("\xf4\x90\x80\x80"), "\xc3\xb4\xc2\x90\xc2\x80\xc2\x80");
}

TEST(MakeUTF8, MessagesAboutFilesAreInIt)
{
  try
  {
    itkDentalInputErrorMacro("t.csv", "l\xf6", "\"H\xf6\" is no tooth", "label it");
    FAIL();
  }
  catch (const itk::DentalInputError & error)
  {
    EXPECT_EQ(error.GetOneLine(), "t.csv: l\xc3\xb6: \"H\xc3\xb6\" is no tooth; label it");
    EXPECT_EQ(error.GetField(), "l\xc3\xb6");
    EXPECT_EQ(std::string(error.GetDescription()), error.GetOneLine());
  }
}

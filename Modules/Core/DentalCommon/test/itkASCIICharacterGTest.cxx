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
#include "itkASCIICharacter.h"
#include "itkLowerCase.h"
#include "itkTrimText.h"

#include "itkGTest.h"

#include <cctype>
#include <clocale>
#include <string>

TEST(ASCIICharacter, IsWhatTheClassicLocaleSays)
{
  ASSERT_STREQ(std::setlocale(LC_CTYPE, nullptr), "C");
  for (int code = 0; code < 256; ++code)
  {
    const auto character = static_cast<char>(code);
    EXPECT_EQ(itk::IsASCIIBlank(character), std::isspace(code) != 0) << code;
    EXPECT_EQ(itk::IsASCIIDigit(character), std::isdigit(code) != 0) << code;
    EXPECT_EQ(itk::IsASCIIUpperCase(character), std::isupper(code) != 0) << code;
    EXPECT_EQ(itk::IsASCIILowerCase(character), std::islower(code) != 0) << code;
    EXPECT_EQ(itk::ToASCIIUpperCase(character), static_cast<char>(std::toupper(code))) << code;
    EXPECT_EQ(itk::IsASCIIAlphanumeric(character), std::isalnum(code) != 0) << code;
    EXPECT_EQ(itk::LowerCase(std::string(1, character))[0], static_cast<char>(std::tolower(code))) << code;
  }
}

TEST(TrimText, TakesTheEndsAlone)
{
  EXPECT_EQ(itk::TrimText(" \t a b\r\n"), "a b");
  EXPECT_EQ(itk::TrimText("_-11- ", " _-"), "11");
  EXPECT_EQ(itk::TrimText(" \n"), "");
  EXPECT_EQ(itk::TrimText(std::string_view("\0 x \0", 5), std::string_view("\0 ", 2)), "x");
}

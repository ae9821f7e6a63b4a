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
#include "itkJsonDocument.h"
#include "itkJsonNumber.h"

#include "itkTestFile.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>
#include <locale>
#include <stdexcept>

using itk::JsonDocument;
using itk::JsonNode;

namespace
{
itk::DentalInputError
ParseError(const std::string & text)
{
  return itk::ExpectInputError([&] { JsonDocument::Parse(text, "case.json"); });
}
} // namespace

TEST(JsonDocument, GivesValuesInTheOrderOfTheFile)
{
  const JsonNode root =
    JsonDocument::Parse(R"({"b": [1, -2.5e3], "a": {"t": true, "s": "text", "n": null}})", "f").GetRoot();
  ASSERT_EQ(root.GetMembers().size(), 2u);
  EXPECT_EQ(root.GetMembers()[0].first, "b");
  EXPECT_EQ(root.Get("b").AsNumbers(2, ""), (std::vector<double>{ 1.0, -2500.0 }));
  EXPECT_TRUE(root.Get("a").Get("t").AsBoolean());
  EXPECT_EQ(root.Get("a").Get("s").AsString(), "text");
  EXPECT_TRUE(root.Get("a").Get("n").IsNull());
  EXPECT_FALSE(root.Find("c"));
  EXPECT_EQ(root.Get("b").At(1).GetPath(), "b[1]");
  EXPECT_EQ(root.Get("a").Get("t").GetPath(), "a.t");
}

TEST(JsonDocument, ANodeOutlivesItsDocument)
{
  std::unique_ptr<JsonDocument> document = std::make_unique<JsonDocument>(JsonDocument::Parse(R"({"a": [7]})", "f"));
  const JsonNode                node = document->GetRoot().Get("a").At(0);
  document.reset();
  EXPECT_EQ(node.AsNumber(), 7.0);
}

TEST(JsonDocument, SyntaxErrorHasLineAndColumn)
{
  struct Example
  {
    const char * text;
    const char * place;
  };
  // The place is that of the first character that cannot stand there.
  for (const Example & example : { Example{ "{\n  \"a\": 1,\n  \"b\" 2\n}", "line 3, column 7" },
                                   Example{ "{\"a\": 1", "line 1, column 8" },
                                   Example{ "{\"a\": [1, 2,]}", "line 1, column 13" },
                                   Example{ "{\"a\": NaN}", "line 1, column 7" },
                                   Example{ "\n\n  x", "line 3, column 3" },
                                   Example{ "{} {}", "line 1, column 4" } })
  {
    const auto error = ParseError(example.text);
    EXPECT_EQ(error.GetInputFile(), "case.json");
    EXPECT_EQ(error.GetField(), example.place) << example.text << ": " << error.GetOneLine();
    EXPECT_TRUE(itk::Contains(error.GetProblem(), "JSON syntax error")) << error.GetOneLine();
    EXPECT_FALSE(itk::Contains(error.GetProblem(), "json.exception")) << error.GetOneLine();
  }
}

TEST(JsonDocument, RefusesWhatIsNoProperText)
{
  EXPECT_TRUE(itk::Contains(ParseError("{\"a\": \"\xc3\x28\"}").GetProblem(), "UTF-8"));
  EXPECT_TRUE(itk::Contains(ParseError(std::string("\xff\xfe{\0}\0", 6)).GetProblem(), "UTF-16"));
  EXPECT_EQ(ParseError(std::string("\0\0\0\0", 4)).GetField(), "line 1, column 1");
  ParseError(" \n ");
  ParseError("{\"a\": 1e999}");
  // Messages go to a terminal: nothing unprintable may reach it.
  for (const char character : ParseError("{\"a\": \"\x1b[31m\xff").GetOneLine())
  {
    EXPECT_TRUE(character >= 0x20 && character < 0x7f);
  }
}

TEST(JsonDocument, AcceptsAByteOrderMark)
{
  EXPECT_EQ(JsonDocument::Parse("\xef\xbb\xbf{\"a\": 1}", "f").GetRoot().Get("a").AsNumber(), 1.0);
}

TEST(JsonDocument, RefusesAMemberThatIsThereTwice)
{
  EXPECT_EQ(ParseError(R"({"a": 1, "b": 2, "a": 1})").GetField(), "a");
  EXPECT_EQ(ParseError(R"({"x": [{}, {"y": {"a": 1, "a": 1}}]})").GetField(), "x[1].y.a");
  EXPECT_NO_THROW(JsonDocument::Parse(R"({"a": {"b": 1}, "b": {"b": 1}})", "f"));
}

TEST(JsonDocument, DeepNestingIsAnErrorAndNoStackOverflow)
{
  EXPECT_TRUE(itk::Contains(ParseError(std::string(1000000, '[')).GetProblem(), "nested"));
  std::string objects;
  for (int i = 0; i < 100000; ++i)
  {
    objects += "{\"a\":";
  }
  EXPECT_TRUE(itk::Contains(ParseError(objects).GetProblem(), "nested"));
  EXPECT_NO_THROW(JsonDocument::Parse(std::string(64, '[') + std::string(64, ']'), "f"));
}

TEST(JsonDocument, WrongTypeAndMissingFieldAreNamed)
{
  const JsonNode root =
    JsonDocument::Parse(R"({"a": {"b": ["x", 1.5, [1, 2, 3], [1, "q"]]}, "n": null})", "case.json").GetRoot();
  const JsonNode b = root.Get("a").Get("b");
  const auto     field = [](const auto & function) { return itk::ExpectInputError(function).GetField(); };
  EXPECT_EQ(field([&] { root.Get("a").Get("missing"); }), "a.missing");
  EXPECT_EQ(field([&] { b.At(0).AsNumber(); }), "a.b[0]");
  EXPECT_EQ(field([&] { b.At(1).AsInteger(0, 10); }), "a.b[1]");
  EXPECT_EQ(field([&] { b.At(1).AsString(); }), "a.b[1]");
  EXPECT_EQ(field([&] { b.At(1).AsBoolean(); }), "a.b[1]");
  EXPECT_EQ(field([&] { b.At(2).AsNumbers(2, "[u, v]"); }), "a.b[2]");
  EXPECT_EQ(field([&] { b.At(3).AsNumbers(2, "[u, v]"); }), "a.b[3][1]");
  EXPECT_EQ(field([&] { b.At(4); }), "a.b");
  EXPECT_EQ(field([&] { b.Get("key"); }), "a.b");
  EXPECT_EQ(field([&] { root.At(0); }), "");
  EXPECT_EQ(field([&] { root.Get("n").AsNumber(); }), "n");
  EXPECT_EQ(itk::ExpectInputError([&] { b.At(0).AsNumber(); }).GetProblem(), "is \"x\", expected a number");
}

TEST(JsonDocument, IntegersHaveLimits)
{
  const JsonNode root = JsonDocument::Parse("[3, -1, 1e300, 18446744073709551615, 2.0]", "f").GetRoot();
  EXPECT_EQ(root.At(0).AsInteger(1, 3), 3);
  EXPECT_EQ(root.At(4).AsInteger(1, 3), 2);
  for (std::size_t i = 1; i < 4; ++i)
  {
    itk::ExpectInputError([&] { root.At(i).AsInteger(0, 1000); });
  }
}

TEST(JsonDocument, UnknownFieldsAreWarnings)
{
  const JsonDocument document = JsonDocument::Parse(R"({"known": 1, "a": {"pixl": 2}, "extra": []})", "case.json");
  document.GetRoot().WarnAboutUnknownFields({ "known", "a" });
  document.GetRoot().Get("a").WarnAboutUnknownFields({ "pixel" });
  EXPECT_EQ(document.GetWarnings(),
            (std::vector<std::string>{ "case.json: extra: unknown field, ignored",
                                       "case.json: a.pixl: unknown field, ignored" }));
}

TEST(JsonDocument, LocaleChangesNoNumber)
{
  const std::string text = "[1.25, 0.1]";
  // Names of systems differ; where none is installed, the test holds in the classic locale alone.
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char * name : { "de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8" })
  {
    if (std::setlocale(LC_ALL, name) != nullptr)
    {
      break;
    }
  }
  const auto        numbers = JsonDocument::Parse(text, "f").GetRoot().AsNumbers(2, "");
  const std::string written = itk::JsonNumber(1.25);
  std::setlocale(LC_ALL, before.c_str());
  EXPECT_EQ(numbers, (std::vector<double>{ 1.25, 0.1 }));
  EXPECT_EQ(written, "1.25");
}

TEST(JsonNumber, ReadsBackToTheSameBits)
{
  for (const double value :
       { 0.0, 1.0 / 3.0, -123456.789, 1e-300, 5e-324, std::numeric_limits<double>::max(), 0.1 + 0.2 })
  {
    EXPECT_EQ(JsonDocument::Parse(itk::JsonNumber(value), "f").GetRoot().AsNumber(), value);
  }
  EXPECT_EQ(itk::JsonNumber(0.1), "0.1");
  EXPECT_THROW(itk::JsonNumber(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW(itk::JsonNumber(std::numeric_limits<double>::infinity()), std::invalid_argument);
}

TEST(JsonNumber, TextReadsBack)
{
  const std::string text = "quote \" backslash \\ line\n tab\t bell\x07 \xc3\xa4";
  EXPECT_EQ(JsonDocument::Parse(itk::JsonString(text), "f").GetRoot().AsString(), text);
}

TEST(JsonDocument, VerifiesWhatAParserThatFollowsByRecursionIsGiven)
{
  EXPECT_NO_THROW(JsonDocument::Verify(std::string(64, '[') + std::string(64, ']'), "f"));
  EXPECT_THROW(JsonDocument::Verify(std::string(65, '[') + std::string(65, ']'), "f"), itk::DentalInputError);
  // As deep as no stack is.
  EXPECT_THROW(JsonDocument::Verify(std::string(2000000, '[') + std::string(2000000, ']'), "f"), itk::DentalInputError);
  EXPECT_THROW(JsonDocument::Verify("{", "f"), itk::DentalInputError);
}

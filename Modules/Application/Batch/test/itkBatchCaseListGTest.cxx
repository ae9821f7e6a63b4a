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
#include "itkBatchCaseList.h"

#include "itkTestFile.h"

#include <gtest/gtest.h>

namespace
{
namespace fs = std::filesystem;

constexpr char CaseText[] = R"({"upper": "upper.stl", "contours": "contours.json"})";

std::string
WriteIn(const std::string & folder, const std::string & name, const std::string & text = CaseText)
{
  fs::create_directories(fs::path(itk::TestFolder()) / folder);
  return itk::WriteTestFile(folder + '/' + name, text);
}

std::vector<std::string>
NamesOf(const std::vector<itk::BatchCase> & cases)
{
  std::vector<std::string> names;
  for (const auto & one : cases)
  {
    names.push_back(one.id);
  }
  return names;
}

std::string
Refusal(const std::vector<std::string> & inputs)
{
  return itk::ExpectInputError([&] { itk::BatchCaseList().Find(inputs); }).GetOneLine();
}
} // namespace

TEST(BatchCaseList, AFolderHasItsCaseFilesWhereverTheyLieButInHiddenFolders)
{
  const std::string first = WriteIn("patients/north/p1", "case.json");
  WriteIn("patients/south/p1", "case.json");
  WriteIn("patients/.old/p1", "case.json");
  WriteIn("patients", "loose.json");
  const auto cases = itk::BatchCaseList().Find({ itk::TestFolder() + "/patients" });
  EXPECT_EQ(NamesOf(cases), (std::vector<std::string>{ "north_p1", "south_p1" }));
  EXPECT_EQ(cases.front().arguments, std::vector<std::string>{ first });
  // A hidden folder above, or the way to it, hides nothing.
  EXPECT_EQ(NamesOf(itk::BatchCaseList().Find({ itk::TestFolder() + "/patients/.old" })),
            std::vector<std::string>{ "p1" });
  // A case's own folder is a folder of one case, and bears its name.
  EXPECT_EQ(NamesOf(itk::BatchCaseList().Find({ itk::TestFolder() + "/patients/north/p1" })),
            std::vector<std::string>{ "p1" });
}

TEST(BatchCaseList, CaseFilesOfOneFolderAreToldFromOtherJSON)
{
  WriteIn("archive", "a.json");
  WriteIn("archive", "b.json", R"({"lower": "l.stl", "cephalometric_landmarks": "marks.csv"})");
  WriteIn("archive", "classes.json", R"({"lower": "l.stl", "contours": {"upper_whole": "u.png"}})");
  WriteIn("archive", "contours.json", R"({"contours": {"upper": [], "lower": []}})");
  WriteIn("archive", "landmarks.json", R"({"upper": {"UR1_tip": [1, 2]}, "contours": []})");
  WriteIn("archive", "result.json", R"({"schema": "dentalscr-result/1", "upper": "u.stl", "contours": "c.json"})");
  WriteIn("archive", "broken.json", R"({"upper": )");
  EXPECT_EQ(NamesOf(itk::BatchCaseList().Find({ itk::TestFolder() + "/archive" })),
            (std::vector<std::string>{ "a", "b", "classes" }));
  WriteIn("nothing", "contours.json", R"({"contours": {"upper": [], "lower": []}})");
  EXPECT_PRED2(itk::Contains, Refusal({ itk::TestFolder() + "/nothing" }), "holds no case");
}

TEST(BatchCaseList, ATableNamesFilesOrOptionsAndHandsTheRestThrough)
{
  WriteIn("t", "case.json");
  itk::BatchCaseList list;
  list.SetOptionNames({ "upper", "contours", "spacing" }, { "upper", "contours" });
  const std::string files =
    itk::WriteTestFile("files.csv", "\xef\xbb\xbfid;case;age\r\none;t/case.json;\"12;5\"\r\n;t/case.json;\r\n");
  auto cases = list.Find({ files });
  EXPECT_EQ(NamesOf(cases), (std::vector<std::string>{ "one", "t" }));
  EXPECT_EQ(cases[0].columns, (std::vector<std::pair<std::string, std::string>>{ { "age", "12;5" } }));
  EXPECT_EQ(cases[0].arguments, std::vector<std::string>{ itk::TestFolder() + "/t/case.json" });
  ASSERT_EQ(list.GetWarnings().size(), 1u);
  EXPECT_PRED2(itk::Contains, list.GetWarnings()[0], "\"age\" is not known");

  const std::string options =
    itk::WriteTestFile("options.csv", "upper,contours,spacing\n../u.stl,c.json,0.1  0.2\nu.stl,,\n");
  cases = list.Find({ options });
  EXPECT_EQ(NamesOf(cases), (std::vector<std::string>{ "row2", "row3" }));
  const std::string above = fs::path(itk::TestFolder()).parent_path().string();
  EXPECT_EQ(cases[0].arguments,
            (std::vector<std::string>{
              "--upper", above + "/u.stl", "--contours", itk::TestFolder() + "/c.json", "--spacing", "0.1", "0.2" }));
  EXPECT_EQ(cases[1].arguments, (std::vector<std::string>{ "--upper", itk::TestFolder() + "/u.stl" }));
  EXPECT_TRUE(list.GetWarnings().empty());
}

TEST(BatchCaseList, APatternFindsFilesAndFolders)
{
  WriteIn("north/p1", "case.json");
  WriteIn("north/p2", "case.json");
  WriteIn("north/p3", "other.json");
  EXPECT_EQ(NamesOf(itk::BatchCaseList().Find({ itk::TestFolder() + "/north/*" })),
            (std::vector<std::string>{ "p1", "p2" }));
  EXPECT_EQ(NamesOf(itk::BatchCaseList().Find({ itk::TestFolder() + "/north/p3/*.json" })),
            std::vector<std::string>{ "other" });
  EXPECT_PRED2(itk::Contains, Refusal({ itk::TestFolder() + "/south*" }), "matches no case");
}

TEST(BatchCaseList, ANameIsAFolderOfItsOwn)
{
  const std::string north = WriteIn("north/p1", "case.json");
  const std::string south = WriteIn("south/p1", "case.json");
  EXPECT_PRED2(itk::Contains, Refusal({ north, south }), "name of two cases");
  EXPECT_EQ(itk::BatchCaseList().Find({ itk::TestFolder() }).size(), 2u);
  // Where the batch keeps its records nothing is registered, however the case is named.
  const std::string hidden = WriteIn("north", ".batch.json");
  EXPECT_PRED2(itk::Contains, Refusal({ hidden }), "can't be a folder's name");
  const std::string table = itk::WriteTestFile("cases.csv", "id,case\n..,north/p1/case.json\n");
  EXPECT_PRED2(itk::Contains, Refusal({ table }), "cases.csv: row 2: the id \"..\" can't be a folder's name");
}

TEST(BatchCaseList, FoldersThatAreLinksAreEnteredOnceAndByTheirOwnNames)
{
  WriteIn("patients/p2", "case.json");
  WriteIn("archive/p1", "case.json");
  const fs::path folder = itk::TestFolder();
  fs::create_directory_symlink(folder / "archive/p1", folder / "patients/linked");
  // Neither a second name of a folder nor a way back is a second case.
  fs::create_directory_symlink("p2", folder / "patients/another");
  fs::create_directory_symlink("..", folder / "patients/p2/back");
  fs::create_directory_symlink(".", folder / "patients/here");
  itk::BatchCaseList list;
  EXPECT_EQ(NamesOf(list.Find({ (folder / "patients").string() })), (std::vector<std::string>{ "linked", "p2" }));
  EXPECT_TRUE(list.GetWarnings().empty());
}

TEST(BatchCaseList, FoldersWithoutACaseAreNamed)
{
  WriteIn("patients/north/p1", "case.json");
  WriteIn("patients/north/p1/scans/old", "upper.stl");
  WriteIn("patients/north/p2", "upper.stl");
  WriteIn("patients/south/p3/scans", "upper.stl");
  // What a batch has written into the folder of its cases is none that lacks one.
  WriteIn("patients/results/.batch", "p1.json");
  WriteIn("patients/results/north_p1", "result.json");
  itk::BatchCaseList list;
  EXPECT_EQ(NamesOf(list.Find({ itk::TestFolder() + "/patients" })), std::vector<std::string>{ "north_p1" });
  ASSERT_EQ(list.GetWarnings().size(), 1u);
  const std::string said = list.GetWarnings().front();
  EXPECT_PRED2(itk::Contains, said, "north/p2");
  EXPECT_PRED2(itk::Contains, said, "south");
  EXPECT_FALSE(itk::Contains(said, "south/p3")) << said;
  EXPECT_FALSE(itk::Contains(said, "results") || itk::Contains(said, "p1")) << said;
  for (int i = 0; i < 9; ++i)
  {
    WriteIn("patients/empty" + std::to_string(i), "note.txt");
  }
  list.Find({ itk::TestFolder() + "/patients" });
  EXPECT_PRED2(itk::Contains, list.GetWarnings().front(), "and 6 more");
}

TEST(BatchCaseList, NamesOfTheTablesAndLettersOfATerminalAreNoCases)
{
  WriteIn("t", "case.json");
  for (const std::string name : { "summary.csv", "summary.json", "index.html", "a\x1b[2J", "\"a\nb\"" })
  {
    const std::string table = itk::WriteTestFile("cases.csv", "id,case\n" + name + ",t/case.json\n");
    EXPECT_PRED2(itk::Contains, Refusal({ table }), "row 2: the id") << name;
  }
}

TEST(BatchCaseList, ATableThatWouldLoseRowsOrLettersIsRefused)
{
  using namespace std::string_literals;
  const std::pair<std::string, std::string> tables[] = {
    { "\xff\xfei\0d\0"s, "is UTF-16" },
    { "id,case\na\0b,t/case.json\n"s, "bytes of zero" },
    { "id,case\na,t/case.json\nM\xfcller,t/case.json\n", "row 3: has letters that are not UTF-8" },
    { "id,case,note\na,t/case.json,\"tall\nb,t/case.json,\nc,t/case.json,\n", "row 2: has a quotation mark" },
    { "ID,Case\na,t/case.json\n", "its columns are: ID, Case" },
  };
  for (const auto & table : tables)
  {
    EXPECT_PRED2(itk::Contains, Refusal({ itk::WriteTestFile("cases.csv", table.first) }), table.second);
  }
  // A cell that is closed may hold lines and quotation marks, and the last row needs no end.
  WriteIn("t", "case.json");
  const std::string good = "id,case,note\na,t/case.json,\"5\"\" tall,\r\nthin\"\nb,t/case.json,7\" tall";
  EXPECT_EQ(NamesOf(itk::BatchCaseList().Find({ itk::WriteTestFile("cases.csv", good) })),
            (std::vector<std::string>{ "a", "b" }));
}

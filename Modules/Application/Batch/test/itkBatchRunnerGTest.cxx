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
#include "itkBatchRunner.h"

#include "itkTestFile.h"

#include "itkCommand.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <thread>

namespace
{
namespace fs = std::filesystem;

/** What stands in for the program: a case file holds the word that says how it ends. */
constexpr char Program[] = R"(
case_file=$2
while [ $# -gt 0 ]; do
  [ "$1" = --output ] && output=$2
  shift
done
echo $$ >> "$case_file.runs"
word=$(cat "$case_file")
code=0
case $word in
  refuse) echo 'dentalscr: upper.stl: is no scan' >&2; exit 2 ;;
  die) kill -KILL $$ ;;
  mute) echo 'ModuleNotFoundError' >&2; exit 1 ;;
  half) mkdir -p "$output"; echo '{"status": "ok"}' > "$output/result.json"; exit 0 ;;
  wait) exec sleep 600 ;;
  failed) code=1 ;;
esac
mkdir -p "$output"
sum=$(sha256sum "$case_file" | cut -c1-64)
cat > "$output/result.json" <<END
{"status": "$word", "jaws": {"upper": {"status": "$word", "expected_error_px": 1.5}},
 "inputs": {"case": {"path": "x", "sha256": "$sum"}}}
END
exit $code
)";

itk::BatchRunner::Pointer
MakeRunner(const std::vector<std::pair<std::string, std::string>> & words)
{
  auto                        runner = itk::BatchRunner::New();
  std::vector<itk::BatchCase> cases;
  for (const auto & word : words)
  {
    itk::BatchCase one;
    one.id = word.first;
    one.arguments = { itk::WriteTestFile(word.first + ".case", word.second) };
    cases.push_back(one);
  }
  runner->SetCases(cases);
  runner->SetProgram({ "/bin/sh", itk::WriteTestFile("program.sh", Program) });
  runner->SetOutputFolder(itk::TestFolder() + "/out");
  return runner;
}

/** How often a case was run. */
std::size_t
CountRuns(const std::string & id)
{
  const std::string runs = itk::ReadTestFile(itk::TestFolder() + '/' + id + ".case.runs");
  return static_cast<std::size_t>(std::count(runs.begin(), runs.end(), '\n'));
}

std::string
ResultOf(const std::string & id)
{
  return itk::TestFolder() + "/out/" + id + "/result.json";
}
} // namespace

TEST(BatchRunner, TellsHowEachCaseEndedAndOneEndsNoOther)
{
  auto runner = MakeRunner({ { "a", "ok" },
                             { "b", "failed" },
                             { "c", "refuse" },
                             { "d", "die" },
                             { "e", "mute" },
                             { "f", "half" },
                             { "g", "suspect" } });
  // What an earlier run has left is no case's that has none now.
  for (const char * id : { "c", "d", "e", "f" })
  {
    fs::create_directories(itk::TestFolder() + "/out/" + id);
    itk::WriteTestFile(std::string("out/") + id + "/result.json",
                       R"({"status": "ok", "jaws": {"upper": {"status": "ok"}}})");
  }
  std::vector<std::string> told;
  runner->AddObserver(itk::IterationEvent(),
                      [&](const itk::EventObject &) { told.push_back(runner->GetRecord().one.id); });
  runner->SetNumberOfJobs(3);
  runner->Update();
  const auto records = runner->GetRecords();
  ASSERT_EQ(records.size(), 7u);
  EXPECT_EQ(told.size(), 7u);
  EXPECT_EQ(runner->GetNumberOfFinishedCases(), 7u);
  const char * const status[] = { "ok", "failed", "unusable", "unusable", "unusable", "unusable", "suspect" };
  const char * const message[] = { "",
                                   "",
                                   "upper.stl: is no scan",
                                   "was ended by signal 9",
                                   "ended with 1 and left no result: ModuleNotFoundError",
                                   "ended with 0 and left no result",
                                   "" };
  for (std::size_t i = 0; i < records.size(); ++i)
  {
    EXPECT_EQ(records[i].status, status[i]) << records[i].one.id;
    EXPECT_PRED2(itk::Contains, records[i].message, message[i]);
    EXPECT_EQ(fs::exists(ResultOf(records[i].one.id)), std::string(status[i]) != "unusable") << records[i].one.id;
  }
  EXPECT_EQ(records[0].jaws.at(0).expectedError, 1.5);
  EXPECT_FALSE(records[0].jaws.at(0).matched);
}

TEST(BatchRunner, ResumedItRunsNothingButWhatIsOpenOrHasChanged)
{
  const auto words =
    std::vector<std::pair<std::string, std::string>>{ { "a", "ok" }, { "b", "failed" }, { "c", "refuse" } };
  auto runner = MakeRunner(words);
  runner->SetArguments({ "--preset", "robust" });
  runner->Update();
  const auto again = [&](std::vector<std::size_t> runs, std::size_t kept) {
    runner->ResumeOn();
    runner->Update();
    std::size_t count = 0;
    for (const auto & record : runner->GetRecords())
    {
      count += record.isKept ? 1 : 0;
    }
    EXPECT_EQ(count, kept);
    EXPECT_EQ((std::vector<std::size_t>{ CountRuns("a"), CountRuns("b"), CountRuns("c") }), runs);
  };
  // Failed is a result; unusable is none.
  again({ 1, 1, 2 }, 2);
  EXPECT_EQ(runner->GetRecords()[1].status, "failed");
  // How many run at once is not what a result is made of.
  runner->SetNumberOfJobs(1);
  again({ 1, 1, 3 }, 2);
  itk::WriteTestFile("a.case", "suspect");
  again({ 2, 1, 4 }, 1);
  EXPECT_EQ(runner->GetRecords()[0].status, "suspect");
  // Another version may come to another result.
  const std::string file = itk::TestFolder() + "/out/.batch/b.json";
  std::string       record = itk::ReadTestFile(file);
  const auto        place = record.find("\"software\": \"");
  ASSERT_NE(place, std::string::npos);
  itk::WriteTestFile("out/.batch/b.json", record.insert(place + 13, "0."));
  again({ 2, 2, 5 }, 1);
  // What was cut off while it was written is as good as not there.
  itk::WriteTestFile("out/.batch/b.json", "{\"arg");
  again({ 2, 3, 6 }, 1);
  runner->SetArguments({ "--preset", "paper" });
  again({ 3, 4, 7 }, 0);
}

TEST(BatchRunner, AbortedItEndsItsProcessesAndKeepsWhatIsComplete)
{
  auto runner = MakeRunner({ { "a", "wait" }, { "b", "ok" }, { "c", "wait" }, { "d", "ok" } });
  runner->SetNumberOfJobs(2);
  runner->AddObserver(itk::IterationEvent(), [&](const itk::EventObject &) { runner->AbortGenerateDataOn(); });
  // The other process has begun to wait before it is ended.
  const std::string begun = itk::TestFolder() + "/a.case.runs";
  fs::remove(begun);
  EXPECT_THROW(runner->Update(), itk::ProcessAborted);
  const auto records = runner->GetRecords();
  ASSERT_EQ(records.size(), 1u);
  EXPECT_EQ(records[0].one.id, "b");
  EXPECT_TRUE(fs::exists(ResultOf("b")));
  EXPECT_FALSE(fs::exists(ResultOf("d")));
  const std::string text = itk::ReadTestFile(begun);
  if (!text.empty())
  {
    EXPECT_EQ(kill(static_cast<pid_t>(std::stoi(text)), 0), -1);
    EXPECT_EQ(errno, ESRCH);
  }
  // It can be asked again.
  itk::WriteTestFile("a.case", "ok");
  itk::WriteTestFile("c.case", "ok");
  runner->RemoveAllObservers();
  runner->ResumeOn();
  runner->Update();
  EXPECT_EQ(runner->GetRecords().size(), 4u);
  EXPECT_EQ(CountRuns("b"), 1u);
}

TEST(BatchRunner, AFolderHasOneOwnerAtATime)
{
  auto runner = MakeRunner({ { "a", "ok" } });
  auto other = MakeRunner({ { "a", "ok" } });
  bool refused = false;
  runner->AddObserver(itk::IterationEvent(), [&](const itk::EventObject &) {
    refused = itk::Contains(itk::ExpectInputError([&] { other->Update(); }).GetOneLine(), "another run is at work");
  });
  runner->Update();
  EXPECT_TRUE(refused);
  // It is owned until tables and page are written, too.
  runner = nullptr;
  EXPECT_NO_THROW(other->Update());
}

TEST(BatchRunner, AsksForWhatItNeeds)
{
  auto runner = MakeRunner({ { "a", "ok" } });
  runner->SetProgram({ "/nowhere/dentalscr" });
  runner->Update();
  EXPECT_EQ(runner->GetRecords().at(0).status, "unusable");
  EXPECT_PRED2(itk::Contains, runner->GetRecords().at(0).message, "/nowhere/dentalscr can't be started");
  runner->SetProgram({});
  EXPECT_THROW(runner->Update(), itk::ExceptionObject);
  EXPECT_THROW(itk::BatchRunner::New()->Update(), itk::ExceptionObject);
  auto nowhere = MakeRunner({ { "a", "ok" } });
  nowhere->SetOutputFolder(itk::WriteTestFile("file", "") + "/below");
  EXPECT_PRED2(itk::Contains, itk::ExpectInputError([&] { nowhere->Update(); }).GetOneLine(), "can't be written");
}

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
#include "dentalscrCommands.h"

#include "itkCSVField.h"
#include "itkDentalInputError.h"
#include "itkDentalLandmarkFileReader.h"
#include "itkJsonDocument.h"
#include "itkLandmarkErrorFilter.h"
#include "itkLandmarkErrorStatistics.h"
#include "itkLeaveOutUsedLandmarks.h"
#include "itkTextFile.h"

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>

namespace dentalscr
{
namespace
{
namespace fs = std::filesystem;
using JawEnum = itk::ToothCode::JawEnum;
using GroupEnum = itk::ToothCode::GroupEnum;

struct EvaluateOptions
{
  std::vector<std::string> results;
  std::vector<std::string> landmarks;
  std::string              csv;
};

itk::DentalLandmarkSet<2>::PointType
ReadPlace(const itk::JsonNode & node)
{
  const std::vector<double> numbers = node.AsNumbers(2, "[u, v]");
  return itk::DentalLandmarkSet<2>::PointType(numbers.data());
}

/** Marks that were not registered with: a landmark that was never scores. */
itk::DentalLandmarkSet<2>::Pointer
LeaveOutUsed(const itk::DentalLandmarkSet<2> & marked, const itk::JsonNode & jaw, bool ignoreSides)
{
  std::vector<itk::CephalometricLandmarkSet::MeaningType> used;
  if (const auto node = jaw.Find("landmarks_used"))
  {
    for (const auto & member : node->GetMembers())
    {
      used.push_back(itk::CephalometricLandmarkSet::ParseName(member.first));
    }
  }
  return itk::LeaveOutUsedLandmarks(marked, used, ignoreSides);
}

/** Middles of a jaw without landmarks on its scan, as if both sides lay there, where both are marked. */
void
AddFoundMiddles(const itk::JsonNode &             jaw,
                const itk::DentalLandmarkSet<2> & marked,
                itk::DentalLandmarkSet<2> &       predicted)
{
  if (const auto node = jaw.Find("middles"))
  {
    for (const auto & member : node->GetMembers())
    {
      const auto names = itk::NamesOfSides(member.first);
      if (marked.Find(names[0]) != nullptr && marked.Find(names[1]) != nullptr)
      {
        const auto place = ReadPlace(member.second.Get("position"));
        predicted.AddLandmark(names[0], place);
        predicted.AddLandmark(names[1], place);
      }
    }
  }
}

itk::DentalLandmarkSet<2>::Pointer
ReadPredictions(const itk::JsonNode & jaw)
{
  auto landmarks = itk::DentalLandmarkSet<2>::New();
  if (const auto node = jaw.Find("landmarks_px"))
  {
    for (const auto & member : node->GetMembers())
    {
      const itk::DentalLandmarkSet<2>::PointType point = ReadPlace(member.second);
      try
      {
        landmarks->AddLandmark(member.first, point);
      }
      catch (const std::invalid_argument & error)
      {
        member.second.Fail(error.what(), "");
      }
    }
  }
  return landmarks;
}

/** One row: a jaw of a case, or of the cohort. A group without landmarks is empty, not 0. */
void
WriteRow(
  std::ostream & os, const std::string & name, JawEnum jaw, const itk::LandmarkErrorStatistics & statistics, bool csv)
{
  std::ostringstream row;
  row << std::fixed << std::setprecision(csv ? 6 : 2);
  const auto cell = [&](const std::string & text, int width) {
    if (csv)
    {
      row << ',' << text;
    }
    else
    {
      row << std::setw(width) << text;
    }
  };
  const auto number = [&](bool there, double value) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(csv ? 6 : 2) << value;
    return there ? text.str() : std::string(csv ? "" : "-");
  };
  if (csv)
  {
    row << itk::ToCSVField(name);
  }
  else
  {
    row << std::left << std::setw(40) << name << std::right;
  }
  cell(itk::ToString(jaw), 7);
  cell(std::to_string(statistics.GetCount()), 5);
  const bool any = statistics.GetCount() > 0;
  cell(number(any, any ? statistics.GetMean() : 0.0), 10);
  cell(number(any, any ? statistics.GetRMSE() : 0.0), 10);
  cell(number(any, any ? statistics.GetStandardDeviation() : 0.0), 10);
  for (const GroupEnum group : { GroupEnum::IncisorsAndCanines, GroupEnum::Premolars, GroupEnum::Molars })
  {
    const bool there = statistics.GetCount(group) > 0;
    cell(number(there, there ? statistics.GetMean(group) : 0.0), 10);
  }
  os << row.str() << '\n';
}

/** The results of a folder: its own, or those of all folders below it, by name. */
std::vector<std::string>
FindResults(const std::string & name)
{
  std::error_code error;
  if (!fs::is_directory(name, error))
  {
    return { name };
  }
  const fs::path own = fs::path(name) / "result.json";
  if (fs::exists(own, error))
  {
    return { own.string() };
  }
  std::vector<std::string> results;
  for (auto entry = fs::recursive_directory_iterator(name, fs::directory_options::skip_permission_denied, error);
       !error && entry != fs::recursive_directory_iterator();
       entry.increment(error))
  {
    if (entry->path().filename() == "result.json")
    {
      results.push_back(entry->path().string());
    }
  }
  if (results.empty())
  {
    itkDentalInputErrorMacro(
      name, "", "there is no result.json in it or below", "name the output of register or batch");
  }
  std::sort(results.begin(), results.end());
  return results;
}

/** The landmarks that were marked on the radiograph of a result, as its case names them; "" where it names none. */
std::string
FindLandmarks(const std::string & result, const itk::JsonNode & root)
{
  const auto inputs = root.Find("inputs");
  const auto marked = inputs ? inputs->Find("landmarks_2d") : std::nullopt;
  const auto path = marked ? marked->Find("path") : std::nullopt;
  if (!path)
  {
    return "";
  }
  const auto      given = inputs->Find("case");
  const auto      caseFile = given ? given->Find("path") : std::nullopt;
  const fs::path  file = (caseFile ? fs::path(caseFile->AsString()).parent_path() : fs::path()) / path->AsString();
  std::error_code error;
  if (!fs::exists(file, error))
  {
    path->Fail("there is no file \"" + file.string() + "\", seen from here",
               "give it by --landmarks, or run from the folder that " + result + " was made from");
  }
  return file.string();
}

int
Evaluate(const EvaluateOptions & options, const CommonOptions & common)
{
  std::vector<std::string> results;
  for (const std::string & name : options.results)
  {
    const auto found = FindResults(name);
    results.insert(results.end(), found.begin(), found.end());
  }
  if (!options.landmarks.empty() && results.size() != options.landmarks.size())
  {
    itkDentalInputErrorMacro("command line",
                             "--landmarks",
                             std::to_string(results.size()) + " results but " +
                               std::to_string(options.landmarks.size()) + " landmark files",
                             "give one landmark file a result, in the same order, or none: then the case names them");
  }
  itk::LandmarkErrorStatistics cohort[2];
  std::ostringstream           table;
  std::ostringstream           csv;
  csv << "case,jaw,landmarks,mean_px,rmse_px,std_px,incisors_canines_px,premolars_px,molars_px\n";
  table << std::left << std::setw(40) << "case" << std::right << std::setw(7) << "jaw" << std::setw(5) << "n"
        << std::setw(10) << "mean" << std::setw(10) << "RMSE" << std::setw(10) << "std" << std::setw(10) << "Inc.&Can."
        << std::setw(10) << "PreM" << std::setw(10) << "Molars" << '\n';
  std::size_t measured = 0;
  for (std::size_t i = 0; i < results.size(); ++i)
  {
    const auto root = itk::JsonDocument::ReadFile(results[i]).GetRoot();
    const auto schema = root.IsObject() ? root.Find("schema") : std::nullopt;
    if (!schema)
    {
      itkDentalInputErrorMacro(results[i], "schema", "missing: this is no result of dentalscr", "name a result.json");
    }
    // Figures of another version's fields would be figures of something else.
    if (schema->AsString() != "dentalscr-result/1")
    {
      schema->Fail("is \"" + schema->AsString() + "\", and this version reads \"dentalscr-result/1\"",
                   "register the case again");
    }
    const std::string marked = options.landmarks.empty() ? FindLandmarks(results[i], root) : options.landmarks[i];
    if (marked.empty())
    {
      std::cerr << "dentalscr: warning: " << results[i] << " is left out: its case names no landmarks_2d\n";
      continue;
    }
    ++measured;
    auto reader = itk::DentalLandmarkFileReader<2>::New();
    reader->SetFileName(marked);
    reader->Update();
    const auto        sideNode = root.Find("traced_side");
    const std::string side = sideNode ? sideNode->AsString() : "";
    for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
    {
      const auto node = root.Get("jaws").Find(itk::ToString(jaw));
      if (!node)
      {
        continue;
      }
      // As the result's own "error" is made.
      const auto reference = LeaveOutUsed(*reader->GetOutput(), *node, side == "standard");
      const auto predicted = ReadPredictions(*node);
      const bool isFound = predicted->GetLandmarks().empty();
      if (isFound)
      {
        AddFoundMiddles(*node, *reference, *predicted);
      }
      auto filter = itk::LandmarkErrorFilter::New();
      filter->SetPredictedLandmarks(predicted);
      filter->SetReferenceLandmarks(reference);
      filter->SetJaw(jaw);
      filter->SetBisectSides(isFound || side == "mean" || side == "standard");
      filter->Update();
      WriteRow(table, results[i], jaw, filter->GetStatistics(), false);
      WriteRow(csv, results[i], jaw, filter->GetStatistics(), true);
      cohort[jaw == JawEnum::Upper ? 0 : 1].Add(filter->GetStatistics());
    }
  }
  if (measured == 0)
  {
    itkDentalInputErrorMacro(
      options.results[0], "", "no case of it names landmarks that were marked", "give them by --landmarks");
  }
  if (measured > 1)
  {
    for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
    {
      WriteRow(table, "all, landmarks pooled", jaw, cohort[jaw == JawEnum::Upper ? 0 : 1], false);
      WriteRow(csv, "all", jaw, cohort[jaw == JawEnum::Upper ? 0 : 1], true);
    }
  }
  if (!options.csv.empty())
  {
    itk::WriteFileAtomically(options.csv, csv.str());
  }
  if (!common.quiet)
  {
    std::cout << table.str() << std::flush;
  }
  return AllRegistered;
}
} // namespace

void
AddEvaluateCommand(CLI::App & program, const CommonOptions & common, RunFunction & run)
{
  auto   options = std::make_shared<EvaluateOptions>();
  auto * command = program.add_subcommand("evaluate", "Landmark errors of results against marked landmarks, in pixels");
  command
    ->add_option("results", options->results, "Results: result.json, its folder, or a folder with results below it")
    ->type_name("FILE")
    ->required();
  command
    ->add_option("--landmarks",
                 options->landmarks,
                 "2-D landmark file of each result, in the same order (default: what its case names)")
    ->type_name("FILE");
  command->add_option("--csv", options->csv, "Write the table to a file too")->type_name("FILE");
  command->footer("With several results the last rows pool all landmarks, as the paper's tables do.\n"
                  "Examples:\n"
                  "  dentalscr evaluate result\n"
                  "  dentalscr evaluate results --csv errors.csv      # all cases of a batch\n"
                  "  dentalscr evaluate result/result.json --landmarks case/landmarks2d.json\n");
  command->callback([options, &common, &run]() { run = [options, &common]() { return Evaluate(*options, common); }; });
}
} // namespace dentalscr

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
#include "itkWriteExperimentPage.h"

#include "itkBase64.h"
#include "itkDentalSCRVersion.h"
#include "itkEscapeForScript.h"
#include "itkExperimentPageParts.h"
#include "itkJsonDocument.h"
#include "itkReadCSVTable.h"
#include "itkTextFile.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

namespace itk
{
namespace
{
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using NameType = std::pair<const char *, const char *>;

/** In the order of the page. What curves are drawn of (calibration.csv, landmarks.csv) is in the figures. */
constexpr NameType Tables[] = { { "table1_landmarks.csv", "Landmark errors" },
                                { "sdr.csv", "Landmarks within a limit" },
                                { "table2_contours.csv", "Contour distances" },
                                { "table3_ablation.csv", "Parts of the method" },
                                { "tests.csv", "Differences between methods" },
                                { "ablation.csv", "Ablation" },
                                { "capture_range.csv", "Capture range" },
                                { "capture.csv", "Success by displacement of the start" },
                                { "sensitivity.csv", "Sensitivity" },
                                { "cohorts.csv", "Cohorts" },
                                { "coverage.csv", "Coverage of 95 % regions" },
                                { "verdict.csv", "Verdicts and errors" },
                                { "verdict_inputs.csv", "Verdicts of mistaken inputs" },
                                { "practice.csv", "Standard tracings and landmarks" },
                                { "views.csv", "Views" },
                                { "failures.csv", "Failures" },
                                { "cases.csv", "Cases" } };

constexpr NameType Figures[] = { { "plots/landmark_errors.png", "Mean landmark error of each case, by method" },
                                 { "plots/success_rate.png", "Landmarks within each limit, by method" },
                                 { "plots/capture_accurate.png", "Starts that end within 2 mm of the truth" },
                                 { "plots/capture_converged.png", "Starts that end where the best one ends" },
                                 { "plots/sensitivity.png", "Mean landmark error by the level of each factor" },
                                 { "plots/ablation.png", "Mean and worst case of each variant" },
                                 { "plots/calibration.png", "How often landmarks lie in the regions they are given" },
                                 { "plots/verdict.png", "Verdicts by the error that there was" },
                                 { "figure_median_upper.png", "The median case, upper jaw" },
                                 { "figure_median_lower.png", "The median case, lower jaw" },
                                 { "figure_worst_upper.png", "The worst case, upper jaw" },
                                 { "figure_worst_lower.png", "The worst case, lower jaw" } };

bool
IsThere(const fs::path & file)
{
  std::error_code error;
  return fs::is_regular_file(file, error);
}

Json
MakeTable(const fs::path & folder, const NameType & name)
{
  const std::string file = (folder / name.first).u8string();
  auto              rows = ReadCSVTable(ReadTextFile(file, "a table"), file);
  Json              table = { { "title", name.second },
                              { "file", name.first },
                              { "header", rows.empty() ? std::vector<std::string>() : rows.front() },
                              { "rows", Json::array() } };
  for (std::size_t i = 1; i < rows.size(); ++i)
  {
    // Rows are as long as the heading, whatever a table that was edited has.
    rows[i].resize(rows.front().size());
    table["rows"].push_back(rows[i]);
  }
  return table;
}

Json
MakeFigure(const fs::path & folder, const NameType & name)
{
  std::ifstream     file(folder / name.first, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(file), {});
  return { { "title", name.second }, { "uri", "data:image/png;base64," + EncodeBase64(bytes.data(), bytes.size()) } };
}
} // namespace

void
WriteExperimentPage(const std::string & folderName)
{
  const fs::path    folder = fs::u8path(folderName);
  const auto        document = JsonDocument::ReadFile((folder / "experiment.json").u8string());
  const auto        root = document.GetRoot();
  const std::string study = root.Get("study").AsString();
  const std::string text = study + ".md";
  Json              data = { { "title", "Experiment: " + study }, { "software", DentalSCRVersion },
                             { "settings", Json::array() },       { "tables", Json::array() },
                             { "figures", Json::array() },        { "text", IsThere(folder / text) ? text : std::string() } };
  const auto        set = [&data](const char * name, const std::string & value) {
    if (!value.empty())
    {
      data["settings"].push_back({ name, value });
    }
  };
  const std::string from = root.Get("from").AsString();
  set("study", study);
  // A folder's whole name may tell of persons.
  set("cases of", from.empty() ? std::string("the phantom") : fs::u8path(from).filename().u8string());
  set("level", from.empty() ? root.Get("level").AsString() : std::string());
  set("first seed", std::to_string(static_cast<std::uint64_t>(root.Get("seed").AsNumber())));
  std::string methods;
  const auto  names = root.Get("methods");
  for (std::size_t i = 0; i < names.GetSize(); ++i)
  {
    methods += (i == 0 ? "" : ", ") + names.At(i).AsString();
  }
  set("methods", methods);
  for (const NameType & table : Tables)
  {
    if (IsThere(folder / table.first))
    {
      data["tables"].push_back(MakeTable(folder, table));
    }
  }
  for (const NameType & figure : Figures)
  {
    if (IsThere(folder / figure.first))
    {
      data["figures"].push_back(MakeFigure(folder, figure));
    }
  }
  std::string            page(ExperimentPageParts::Page());
  constexpr const char * word = "EXPERIMENT_DATA";
  page.replace(page.find(word),
               std::char_traits<char>::length(word),
               EscapeForScript(data.dump(-1, ' ', false, Json::error_handler_t::replace)));
  WriteFileAtomically((folder / "index.html").string(), page);
}
} // namespace itk

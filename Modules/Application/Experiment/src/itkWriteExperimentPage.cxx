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
#include "itkExperimentPictures.h"
#include "itkJsonDocument.h"
#include "itkReadCSVTable.h"
#include "itkTextFile.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
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

/** Larger tables are linked, not shown: no browser sorts them in a moment, nor does anybody read them on a page. */
constexpr std::uintmax_t MaximumTableSize = 2u << 20;
/** Of plots and drawings, which have a tenth of a megabyte. */
constexpr std::size_t MaximumPictureSize = 32u << 20;

bool
IsThere(const fs::path & file)
{
  std::error_code error;
  return fs::is_regular_file(file, error);
}

Json
MakeTable(const fs::path & folder, const NameType & name)
{
  const fs::path    path = folder / name.first;
  const std::string file = path.u8string();
  std::error_code   error;
  if (fs::file_size(path, error) > MaximumTableSize && !error)
  {
    return { { "title", name.second }, { "file", name.first }, { "rows", nullptr } };
  }
  auto rows = ReadCSVTable(ReadTextFile(file, "a table"), file);
  Json table = { { "title", name.second },
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
MakeFigure(const fs::path & folder, const ExperimentPicture & picture)
{
  const std::string bytes = ReadTextFile((folder / picture.fileName).u8string(), "a picture", MaximumPictureSize);
  return { { "title", picture.title }, { "uri", "data:image/png;base64," + EncodeBase64(bytes.data(), bytes.size()) } };
}

/** As it stands there: a seed has more digits than the numbers of a JsonNode. */
std::string
ReadSeed(const JsonNode & node, const std::string & text)
{
  const Json seed = Json::parse(text).at("seed");
  if (!seed.is_number_unsigned())
  {
    node.Fail("is no seed, which is a whole number from 0", "run the experiment again into a new folder");
  }
  return seed.dump();
}
} // namespace

void
WriteExperimentPage(const std::string & folderName)
{
  const fs::path    folder = fs::u8path(folderName);
  const std::string manifestName = (folder / "experiment.json").u8string();
  const std::string manifest = ReadTextFile(manifestName, "an experiment");
  const auto        document = JsonDocument::Parse(manifest, manifestName);
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
  set("first seed", ReadSeed(root.Get("seed"), manifest));
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
  for (const ExperimentPicture & picture : ExperimentPictures)
  {
    if (IsThere(folder / picture.fileName))
    {
      data["figures"].push_back(MakeFigure(folder, picture));
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

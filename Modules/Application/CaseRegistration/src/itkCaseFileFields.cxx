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
#include "itkCaseFileFields.h"

#include "itkCephalometricLandmarkFileReader.h"
#include "itkShortNumber.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace itk
{
namespace fs = std::filesystem;

std::string
FindFile(const JsonNode & root, const std::string & key, const fs::path & directory)
{
  const auto node = root.Find(key);
  if (!node)
  {
    return {};
  }
  const std::string & text = node->AsString();
  if (text.empty())
  {
    node->Fail("empty path", "name the file or leave the field out");
  }
  fs::path        path = directory / fs::u8path(text);
  std::error_code ignored;
  if (!fs::exists(path, ignored) && text.find('\\') != std::string::npos)
  {
    // A case that was written on Windows parts folders so; elsewhere the sign is a letter like any other.
    std::string slashed = text;
    std::replace(slashed.begin(), slashed.end(), '\\', '/');
    const fs::path other = directory / fs::u8path(slashed);
    path = fs::exists(other, ignored) ? other : path;
  }
  if (fs::is_directory(path, ignored))
  {
    node->Fail("\"" + text + "\" is a folder", "name a file");
  }
  if (!fs::exists(path, ignored))
  {
    node->Fail("there is no file \"" + text + "\"", "paths are relative to the case file");
  }
  return path.string();
}

double
MachineDistance(const JsonNode & node)
{
  const double value = node.AsNumber();
  if (!(value >= 200.0 && value <= 20000.0))
  {
    std::ostringstream problem;
    problem << value << " mm is not possible";
    node.Fail(problem.str(), "give mm, about 1500 to the midsagittal plane and 1650 to the detector");
  }
  return value;
}

bool
IsLeft(const JsonNode & node)
{
  const std::string & text = node.AsString();
  if (text != "right" && text != "left")
  {
    node.Fail("\"" + text + "\" is neither \"right\" nor \"left\"", "write one of them");
  }
  return text == "left";
}

std::optional<std::array<unsigned int, 2>>
ReadImageSize(const JsonNode & node)
{
  const auto size = node.Find("image_size");
  if (!size)
  {
    return std::nullopt;
  }
  // No radiograph has a tenth of the limit.
  constexpr int64_t limit = 1000000;
  size->AsNumbers(2, "[width, height]");
  return { { static_cast<unsigned int>(size->At(0).AsInteger(1, limit)),
             static_cast<unsigned int>(size->At(1).AsInteger(1, limit)) } };
}

namespace
{
/** mm a pixel, [u, v]; nothing where absent. */
std::optional<std::array<double, 2>>
ReadSpacing(const JsonNode & node, const char * key, const char * remedy)
{
  const auto spacing = node.Find(key);
  if (!spacing)
  {
    return std::nullopt;
  }
  const std::vector<double> numbers = spacing->AsNumbers(2, "[u, v]");
  for (const double number : numbers)
  {
    // A cephalogram's pixels are 0.05 to 0.5 mm, and 1 mm is what Slicer gives a picture without a spacing; 5 mm is no
    // radiograph.
    if (!(number > 0.001 && number < 5.0))
    {
      spacing->Fail(ShortNumber(number) + " mm a pixel is not possible", remedy);
    }
  }
  return { { numbers[0], numbers[1] } };
}
} // namespace

std::optional<std::array<double, 2>>
ReadPixelSpacing(const JsonNode & node)
{
  return ReadSpacing(
    node, "pixel_spacing_mm", "give mm a pixel, about 0.1 to 0.3, or leave the field out where it is unknown");
}

std::optional<std::array<double, 2>>
ReadPrincipalPoint(const JsonNode & node)
{
  const auto point = node.Find("principal_point_px");
  if (!point)
  {
    return std::nullopt;
  }
  const std::vector<double> numbers = point->AsNumbers(2, "[u, v]");
  for (const double number : numbers)
  {
    if (!(std::abs(number) < 20000.0))
    {
      point->Fail("lies far outside any radiograph",
                  "give the pixel where the central ray meets the detector: the ear-rod ring");
    }
  }
  return { { numbers[0], numbers[1] } };
}

std::optional<std::array<double, 2>>
ReadMarkupsSpacing(const JsonNode & node)
{
  return ReadSpacing(
    node, "markups_spacing_mm", "give the spacing that the radiograph had in Slicer (its Volumes module shows it)");
}

CaseLandmarkField
ReadCephalometricLandmarks(const JsonNode &                                root,
                           const fs::path &                                directory,
                           const std::optional<ToothCode::NumberingEnum> & numbering)
{
  constexpr char    key[] = "cephalometric_landmarks";
  CaseLandmarkField field;
  const auto        node = root.Find(key);
  if (!node)
  {
    return field;
  }
  if (!node->IsObject())
  {
    if (!node->IsString())
    {
      node->Fail("is neither a file's name nor an object", R"(name the file, or write {"U1_tip": [u, v]})");
    }
    field.fileName = FindFile(root, key, directory);
    return field;
  }
  auto reader = CephalometricLandmarkFileReader::New();
  reader->SetJsonNode(*node);
  reader->SetNumbering(numbering.value_or(ToothCode::NumberingEnum::Quadrant));
  reader->Update();
  field.warnings = reader->GetWarnings();
  const CephalometricLandmarkSet::Pointer landmarks = reader->GetOutput();
  landmarks->DisconnectPipeline();
  field.landmarks = landmarks.GetPointer();
  return field;
}
} // namespace itk

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
#include "dentalscrCaseOptions.h"

#include "itkDentalCaseFileReader.h"
#include "itkDentalInputError.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

namespace dentalscr
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr char Source[] = "command line";

double
ToNumber(const std::string & text, const char * option)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double value = 0.0;
  if (!(stream >> value) || !stream.eof() || !std::isfinite(value))
  {
    itkDentalInputErrorMacro(Source, option, "\"" + text + "\" is no number", "give a number");
  }
  return value;
}
} // namespace

std::vector<CaseOptions::FieldType>
CaseOptions::MakeFields()
{
  return {
    { "--upper", "upper", "Upper scan (STL, PLY, OBJ, OFF, VTK, VTP)", {}, 0, true },
    { "--lower", "lower", "Lower scan", {}, 0, true },
    { "--upper-labels", "upper_labels", "Tooth labels of the upper scan", {}, 0, true },
    { "--lower-labels", "lower_labels", "Tooth labels of the lower scan", {}, 0, true },
    { "--crowns", "crowns", "How crowns are found: off, labels or shape", {}, 0, false, "{off,labels,shape}" },
    { "--mesh-unit", "mesh_unit", "Unit of the scans: mm, cm, inch, m or um", {}, 0, false, "{mm,cm,inch,m,um}" },
    { "--occlusion", "occlusion", "Jaws in one frame: true, false or check", {}, 0, false, "{true,false,check}" },
    { "--contours", "contours", "The tracing", {}, 0, true },
    { "--cephalometric-landmarks",
      "cephalometric_landmarks",
      "Landmarks to register with; beside a case file in place of the case's",
      {},
      0,
      true },
    { "--landmarks-3d", "landmarks_3d", "Landmarks of the scans", {}, 0, true },
    { "--stock-outlines",
      "stock_outlines",
      "Outlines that the reader's software offers, as another patient's tracing has them, to tell templates by",
      {},
      0,
      true },
    { "--landmarks-2d", "landmarks_2d", "Landmarks marked on the radiograph, to measure errors by", {}, 0, true },
    { "--markups-spacing", "markups_spacing_mm", "Of tracings and landmarks in mm: mm a pixel, u v", {}, 2, false },
    { "--traced-side",
      "traced_side",
      "right, left, mean, both or standard",
      {},
      0,
      false,
      "{right,left,mean,both,standard}" },
    { "--numbering", "numbering", "Of the teeth: UR, FDI or universal", {}, 0, false, "{UR,FDI,universal}" },
    { "--image",
      "cephalogram.image",
      "The radiograph (PNG, JPEG, TIFF, BMP, NRRD, MetaImage, NIfTI, DICOM)",
      {},
      0,
      true },
    { "--image-size", "cephalogram.image_size", "Its width and height where there is no image, pixels", {}, 2, false },
    { "--spacing", "cephalogram.pixel_spacing_mm", "Pixel spacing, mm: u v", {}, 2, false },
    { "--spacing-plane",
      "cephalogram.spacing_plane",
      "Where it holds: detector or midsagittal",
      {},
      0,
      false,
      "{detector,midsagittal}" },
    { "--facing",
      "cephalogram.facing",
      "Where the face looks in the image: right or left",
      {},
      0,
      false,
      "{right,left}" },
    { "--source-side",
      "geometry.source_side",
      "The patient's side at which the source is: right or left",
      {},
      0,
      false,
      "{right,left}" },
    { "--distances", "", "Source to midsagittal plane and to detector, mm (default 1524 1674)", {}, 2, false },
    { "--principal-point",
      "geometry.principal_point_px",
      "Where the central ray meets the detector, pixels: u v",
      {},
      2,
      false }
  };
}

std::set<std::string>
CaseOptions::GetNames()
{
  std::set<std::string> names;
  for (const FieldType & field : MakeFields())
  {
    names.insert(std::string(field.option).substr(2));
  }
  return names;
}

std::set<std::string>
CaseOptions::GetFileNames()
{
  std::set<std::string> names;
  for (const FieldType & field : MakeFields())
  {
    if (field.isFile)
    {
      names.insert(std::string(field.option).substr(2));
    }
  }
  return names;
}

void
CaseOptions::AddTo(CLI::App * command)
{
  for (FieldType & field : m_Fields)
  {
    auto * option = command->add_option(field.option, field.values, field.help)->group("Case without a case file");
    option->expected(field.numbers > 0 ? static_cast<int>(field.numbers) : 1);
    option->type_name(field.numbers > 0 ? "FLOAT" : field.isFile ? "FILE" : field.words);
  }
}

std::size_t
CaseOptions::CountGiven() const
{
  return static_cast<std::size_t>(
    std::count_if(m_Fields.begin(), m_Fields.end(), [](const FieldType & field) { return !field.values.empty(); }));
}

std::string
CaseOptions::GetValue(const std::string & option) const
{
  for (const FieldType & field : m_Fields)
  {
    if (field.option == option && !field.values.empty())
    {
      return field.values[0];
    }
  }
  return "";
}

std::string
CaseOptions::GetFirstGiven() const
{
  for (const FieldType & field : m_Fields)
  {
    if (!field.values.empty())
    {
      return field.option;
    }
  }
  return "";
}

itk::DentalCase
CaseOptions::Read(bool isDrawn) const
{
  Json json = Json::object();
  for (const FieldType & field : m_Fields)
  {
    if (field.values.empty())
    {
      continue;
    }
    std::vector<double> numbers;
    for (std::size_t i = 0; i < field.numbers; ++i)
    {
      numbers.push_back(ToNumber(field.values[i], field.option));
    }
    const std::string name = field.field;
    if (name.empty())
    {
      json["geometry"]["source_to_midsagittal_mm"] = numbers[0];
      json["geometry"]["source_to_detector_mm"] = numbers[1];
      continue;
    }
    const std::size_t dot = name.find('.');
    Json &            value = dot == std::string::npos ? json[name] : json[name.substr(0, dot)][name.substr(dot + 1)];
    const auto        isWhole = [](double number) { return number == std::floor(number) && std::abs(number) < 1e9; };
    if (name == "cephalogram.image_size" && isWhole(numbers[0]) && isWhole(numbers[1]))
    {
      // As the field has them: 703.0 is none, in JSON.
      value = { static_cast<long long>(numbers[0]), static_cast<long long>(numbers[1]) };
    }
    else if (field.numbers > 0)
    {
      value = numbers;
    }
    else
    {
      value = field.values[0];
    }
  }
  return isDrawn ? itk::ParseDentalCase(json.dump(), Source, "") : itk::ParseDentalCaseToDraw(json.dump(), Source, "");
}
} // namespace dentalscr

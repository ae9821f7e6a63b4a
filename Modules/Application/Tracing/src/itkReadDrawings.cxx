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
#include "itkReadDrawings.h"

#include "itkCephalometricLandmarkFileReader.h"
#include "itkDentalCaseLoader.h"
#include "itkDentalContourFileReader.h"
#include "itkDentalInputError.h"
#include "itkJsonDocument.h"
#include "itkTextFile.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

namespace itk
{
namespace
{
using Json = nlohmann::ordered_json;
using JawEnum = ToothCode::JawEnum;

/** A point as files have it. */
Json
ToJson(const Point<double, 2> & point)
{
  return { point[0], point[1] };
}

/** A JSON object, or null where the file is something else. */
Json
ReadObject(const std::string & fileName)
{
  const std::string text = ReadTextFile(fileName, "drawing");
  try
  {
    JsonDocument::Verify(text, fileName);
  }
  catch (const DentalInputError &)
  {
    // It may have another format; where it has not, its reader says what is wrong.
    return Json();
  }
  const Json json = Json::parse(text, nullptr, false);
  return json.is_object() ? json : Json();
}

Json
ToJson(const DentalContour::PolylineType & polyline)
{
  Json contour = { { "code", polyline.code.GetName() }, { "points", Json::array() } };
  for (const auto & point : polyline.points)
  {
    contour["points"].push_back(ToJson(point));
  }
  if (polyline.closed)
  {
    contour["closed"] = true;
  }
  if (!polyline.weights.empty())
  {
    contour["weights"] = polyline.weights;
  }
  if (!polyline.sigmas.empty())
  {
    contour["sigma_px"] = Json::array();
    for (const double sigma : polyline.sigmas)
    {
      contour["sigma_px"].push_back(sigma > 0.0 ? Json(sigma) : Json());
    }
  }
  if (polyline.outline != DentalContour::OutlineEnum::Unspecified)
  {
    std::ostringstream outline;
    outline << polyline.outline;
    contour["outline"] = outline.str();
  }
  if (polyline.drafted)
  {
    contour["drafted"] = true;
  }
  return contour;
}

std::string
ReadContours(const DentalCaseData & data, const DentalCase & description, bool & isForeign)
{
  if (description.contoursFile.empty() && description.contourClassFiles.empty())
  {
    return "";
  }
  if (description.contourClassFiles.empty())
  {
    const Json own = ReadObject(description.contoursFile);
    if (own.contains("contours") && own["contours"].is_object())
    {
      return own.dump();
    }
  }
  isForeign = true;
  auto reader = DentalContourFileReader::New();
  reader->SetFileName(description.contourClassFiles.empty() ? description.contoursFile : description.fileName);
  reader->SetClassFiles(description.contourClassFiles);
  PrepareReader(description, data, *reader);
  if (description.numbering)
  {
    reader->SetNumbering(*description.numbering);
  }
  reader->SetImageSize({ { data.imageSize[0], data.imageSize[1] } });
  reader->Update();
  Json contours = { { "upper", Json::array() }, { "lower", Json::array() } };
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    for (const auto & polyline : reader->GetOutput(jaw)->GetPolylines())
    {
      contours[ToString(jaw)].push_back(ToJson(polyline));
    }
  }
  return Json{ { "image_size", data.imageSize }, { "contours", contours } }.dump();
}

std::string
ReadLandmarks(const DentalCaseData & data, const DentalCase & description, bool & isForeign)
{
  CephalometricLandmarkSet::ConstPointer landmarks = description.cephalometricLandmarks;
  if (!description.cephalometricLandmarksFile.empty())
  {
    const Json own = ReadObject(description.cephalometricLandmarksFile);
    if (own.is_object() && own.empty())
    {
      // All of them were deleted on the page before.
      return "";
    }
    const auto isPlace = [](const Json & value) {
      return value.is_array() || (value.is_object() && value.contains("position")) || value.is_null();
    };
    // Other programs' files are objects too, of lists: {"landmarks": [...]}, {"markups": [...]}.
    if (own.is_object() && !own.contains("landmarks") && !own.contains("markups") && !own.contains("shapes") &&
        std::any_of(own.begin(), own.end(), isPlace))
    {
      return own.dump();
    }
    isForeign = true;
    auto reader = CephalometricLandmarkFileReader::New();
    reader->SetFileName(description.cephalometricLandmarksFile);
    reader->SetNumbering(description.numbering.value_or(ToothCode::NumberingEnum::Quadrant));
    PrepareReader(description, data, *reader);
    reader->Update();
    landmarks = reader->GetOutput();
  }
  if (landmarks.IsNull())
  {
    return "";
  }
  Json json = Json::object();
  for (const auto & landmark : landmarks->GetLandmarks())
  {
    Json place = { { "position", ToJson(landmark.point) } };
    if (landmark.sigma > 0.0)
    {
      place["sigma_px"] = landmark.sigma;
    }
    if (landmark.confidence >= 0.0)
    {
      place["confidence"] = landmark.confidence;
    }
    json[landmark.name] = place.size() == 1 ? place["position"] : place;
  }
  return json.dump();
}
} // namespace

DrawingTexts
ReadDrawings(const DentalCaseData & data, const DentalCase & description)
{
  DrawingTexts texts;
  texts.contours = ReadContours(data, description, texts.contoursAreForeign);
  texts.landmarks = ReadLandmarks(data, description, texts.landmarksAreForeign);
  return texts;
}
} // namespace itk

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
#include "itkExperimentRecord.h"

#include <nlohmann/json.hpp>

#include <stdexcept>

namespace itk
{
namespace
{
using Json = nlohmann::ordered_json;
constexpr const char * Schema = "dentalscr-experiment-case/1";
} // namespace

std::optional<double>
ExperimentRecord::JawType::GetMean(bool inMillimetres) const
{
  if (!registered || landmarks.empty())
  {
    return std::nullopt;
  }
  double sum = 0.0;
  for (const LandmarkType & landmark : landmarks)
  {
    sum += inMillimetres ? landmark.millimetres : landmark.pixels;
  }
  return sum / static_cast<double>(landmarks.size());
}

void
ExperimentRecord::Add(const std::string & method, const CaseResult & result)
{
  const double spacing = result.geometry->HasPixelSpacing()
                           ? 0.5 * (result.geometry->GetPixelSpacing()[0] + result.geometry->GetPixelSpacing()[1])
                           : 0.0;
  for (const auto & entry : result.jaws)
  {
    const JawResult & jaw = entry.second;
    JawType           record;
    record.registered = jaw.registered;
    record.status = ToString(jaw.status);
    record.reasons = jaw.GetReasons();
    for (const auto & stage : jaw.seconds)
    {
      record.seconds += stage.first == "registration" ? stage.second : 0.0;
    }
    for (const auto & detail : jaw.details)
    {
      if (detail.first == "middle_sigma_px")
      {
        record.middleSigma = detail.second;
      }
    }
    if (jaw.registered)
    {
      record.similarity = {
        { jaw.similarity.scale, jaw.similarity.rotation, jaw.similarity.translation[0], jaw.similarity.translation[1] }
      };
      if (!jaw.metrics.empty())
      {
        record.whole = jaw.metrics.front().second;
      }
      if (jaw.error)
      {
        for (const auto & error : jaw.error->landmarks)
        {
          LandmarkType landmark;
          landmark.name = error.first;
          landmark.group = DentalLandmarkSet<2>::ParseName(error.first.substr(0, error.first.find('+'))).GetGroup();
          landmark.pixels = error.second;
          landmark.millimetres = error.second * spacing;
          for (const LandmarkPrediction & prediction : jaw.landmarks)
          {
            if (prediction.name == error.first && prediction.covariance)
            {
              landmark.sigma = prediction.GetSigma();
            }
            // Of a bisected tracing: the middle of two landmarks, "UR1_tip+UL1_tip".
            else if (prediction.middleCovariance && error.first.find(prediction.name + '+') == 0)
            {
              landmark.sigma = prediction.GetMiddleSigma();
            }
          }
          record.landmarks.push_back(landmark);
        }
      }
    }
    methods[method][ToString(entry.first)] = record;
  }
}

auto
ExperimentRecord::Find(const std::string & method, const std::string & jaw) const -> const JawType *
{
  const auto found = methods.find(method);
  if (found == methods.end())
  {
    return nullptr;
  }
  const auto entry = found->second.find(jaw);
  return entry == found->second.end() ? nullptr : &entry->second;
}

std::string
ExperimentRecord::ToJson(const std::string & key) const
{
  Json json;
  json["schema"] = Schema;
  json["key"] = key;
  json["id"] = id;
  json["seed"] = seed;
  json["failure"] = failure;
  json["marked"] = marked;
  json["methods"] = Json::object();
  for (const auto & method : methods)
  {
    for (const auto & entry : method.second)
    {
      const JawType & jaw = entry.second;
      Json            landmarks = Json::array();
      for (const LandmarkType & landmark : jaw.landmarks)
      {
        Json item = { { "name", landmark.name },
                      { "group", static_cast<int>(landmark.group) },
                      { "px", landmark.pixels },
                      { "mm", landmark.millimetres } };
        if (landmark.sigma)
        {
          item["sigma_px"] = *landmark.sigma;
        }
        landmarks.push_back(item);
      }
      json["methods"][method.first][entry.first] = {
        { "registered", jaw.registered },
        { "status", jaw.status },
        { "reasons", jaw.reasons },
        { "similarity", jaw.similarity },
        { "contour_px", { jaw.whole.chamfer, jaw.whole.hausdorff, jaw.whole.movingToFixed, jaw.whole.fixedToMoving } },
        { "landmarks", landmarks },
        { "seconds", jaw.seconds }
      };
      if (jaw.middleSigma)
      {
        json["methods"][method.first][entry.first]["middle_sigma_px"] = *jaw.middleSigma;
      }
    }
  }
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

ExperimentRecord
ExperimentRecord::FromJson(const std::string & text, const std::string & key)
{
  const Json json = Json::parse(text);
  if (json.at("schema") != Schema || json.at("key") != key)
  {
    throw std::invalid_argument("the record is of another experiment");
  }
  ExperimentRecord record;
  record.id = json.at("id").get<std::string>();
  record.seed = json.at("seed").get<std::uint64_t>();
  record.failure = json.at("failure").get<std::string>();
  record.marked = json.at("marked").get<std::map<std::string, std::size_t>>();
  for (const auto & method : json.at("methods").items())
  {
    for (const auto & entry : method.value().items())
    {
      const Json & item = entry.value();
      JawType      jaw;
      jaw.registered = item.at("registered").get<bool>();
      jaw.status = item.at("status").get<std::string>();
      jaw.reasons = item.at("reasons").get<std::vector<std::string>>();
      jaw.similarity = item.at("similarity").get<std::array<double, 4>>();
      const auto contour = item.at("contour_px").get<std::array<double, 4>>();
      jaw.whole = { contour[0], contour[1], contour[2], contour[3] };
      jaw.seconds = item.at("seconds").get<double>();
      if (item.contains("middle_sigma_px"))
      {
        jaw.middleSigma = item.at("middle_sigma_px").get<double>();
      }
      for (const Json & each : item.at("landmarks"))
      {
        LandmarkType landmark;
        landmark.name = each.at("name").get<std::string>();
        landmark.group = static_cast<ToothCode::GroupEnum>(each.at("group").get<int>());
        landmark.pixels = each.at("px").get<double>();
        landmark.millimetres = each.at("mm").get<double>();
        if (each.contains("sigma_px"))
        {
          landmark.sigma = each.at("sigma_px").get<double>();
        }
        jaw.landmarks.push_back(landmark);
      }
      record.methods[method.key()][entry.key()] = jaw;
    }
  }
  return record;
}
} // namespace itk

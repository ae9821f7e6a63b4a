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
#include "itkTracingSession.h"

#include "itkCaseRegistration.h"
#include "itkCephalometricLandmarkFileReader.h"
#include "itkCrownDraftSource.h"
#include "itkDentalCaseLoader.h"
#include "itkDentalContourFileReader.h"
#include "itkDentalInputError.h"
#include "itkJsonDocument.h"
#include "itkMemoryFile.h"

#include "itkCommand.h"
#include "itkMultiThreaderBase.h"
#include "itkTimeProbe.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <utility>

namespace itk
{
namespace
{
using Json = nlohmann::ordered_json;
using JawEnum = ToothCode::JawEnum;

/** Drawings as the two files that they are saved as, in memory: the readers read files, and are to judge the same
 * bytes.
 */
class DrawingFiles
{
public:
  explicit DrawingFiles(const std::string & drawings)
  {
    JsonDocument::Verify(drawings, "drawing");
    const Json json = Json::parse(drawings, nullptr, false);
    if (!json.is_object())
    {
      itkDentalInputErrorMacro("drawing", "", "is no JSON object", "load the page again");
    }
    if (HasContours(json))
    {
      m_Contours = Write(json["contours"], m_Files[0]);
    }
    if (json.contains("landmarks") && json["landmarks"].is_object() && !json["landmarks"].empty())
    {
      m_Landmarks = Write(json["landmarks"], m_Files[1]);
    }
  }

  /** "" where nothing is drawn. */
  const std::string &
  GetContours() const
  {
    return m_Contours;
  }
  const std::string &
  GetLandmarks() const
  {
    return m_Landmarks;
  }

  /** A sentence with the names that the page has for them: what they are called in memory tells nobody anything. */
  std::string
  Clean(std::string text) const
  {
    const std::string folder = "/proc/self/fd/";
    for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder, at))
    {
      // The whole number: the name of one file may be the beginning of the other one's.
      const std::size_t end = std::min(text.find_first_not_of("0123456789", at + folder.size()), text.size());
      const std::string file = text.substr(at, end - at);
      const std::string name = file == m_Contours ? "contours" : file == m_Landmarks ? "landmarks" : file;
      text.replace(at, file.size(), name);
      at += name.size();
    }
    return text;
  }

  /** The same of an error. */
  [[noreturn]] void
  Throw(const DentalInputError & error) const
  {
    itkDentalInputErrorMacro(
      this->Clean(error.GetInputFile()), error.GetField(), this->Clean(error.GetProblem()), error.GetRemedy());
  }

private:
  static std::string
  Write(const Json & json, std::optional<MemoryFile> & file)
  {
    file.emplace();
    std::ofstream stream(file->GetName(), std::ios::binary);
    stream << json.dump();
    if (!stream.flush())
    {
      itkGenericExceptionMacro("There is no memory for what is drawn.");
    }
    return file->GetName();
  }

  static bool
  HasContours(const Json & json)
  {
    if (!json.contains("contours") || !json["contours"].is_object() || !json["contours"].contains("contours"))
    {
      return false;
    }
    for (const auto & jaw : json["contours"]["contours"])
    {
      for (const auto & contour : jaw)
      {
        if (contour.is_object() && contour.contains("points") && !contour["points"].empty())
        {
          return true;
        }
      }
    }
    return false;
  }

  std::array<std::optional<MemoryFile>, 2> m_Files;
  std::string                              m_Contours;
  std::string                              m_Landmarks;
};

/** Thousandths of a pixel. */
Json
Round(double value)
{
  return std::isfinite(value) ? Json(std::round(1000.0 * value) / 1000.0) : Json();
}

Json
DescribePolyline(const DentalContour::PolylineType & polyline)
{
  Json points = Json::array();
  for (const auto & point : polyline.points)
  {
    points.push_back({ Round(point[0]), Round(point[1]) });
  }
  return { { "code", polyline.code.GetName() }, { "closed", polyline.closed }, { "points", points } };
}

Json
DescribeJaw(const JawResult & jaw)
{
  Json json = { { "status", ToString(jaw.status) }, { "registered", jaw.registered }, { "findings", Json::array() } };
  for (const RegistrationFinding & finding : jaw.findings)
  {
    json["findings"].push_back(
      { { "severity", ToString(finding.severity) }, { "code", finding.code }, { "text", finding.text } });
  }
  if (!jaw.registered)
  {
    return json;
  }
  if (const auto * matched = jaw.FindMetrics("matched"))
  {
    json["fit_px"] = Round(matched->chamfer);
  }
  if (jaw.expectedError)
  {
    json["expected_error_px"] = Round(*jaw.expectedError);
  }
  if (!jaw.placedBy.empty())
  {
    json["placed_by"] = jaw.placedBy;
  }
  json["projection_3x4"] = jaw.projection;
  json["landmarks_used"] = Json::array();
  for (const UsedLandmark & landmark : jaw.usedLandmarks)
  {
    json["landmarks_used"].push_back({ { "name", landmark.name },
                                       { "found_by", landmark.source },
                                       { "residual_px", { Round(landmark.residual[0]), Round(landmark.residual[1]) } },
                                       { "residual_sd", Round(landmark.distance) },
                                       { "weight", Round(landmark.weight) } });
  }
  json["teeth"] = Json::array();
  for (const ToothResidual & tooth : jaw.residuals)
  {
    json["teeth"].push_back({ { "tooth", tooth.code },
                              { "points", tooth.count },
                              { "mean_px", Round(tooth.mean) },
                              { "max_px", Round(tooth.maximum) } });
  }
  json["predicted"] = Json::array();
  for (const LandmarkPrediction & landmark : jaw.landmarks)
  {
    json["predicted"].push_back({ { "name", landmark.name },
                                  { "position", { Round(landmark.position[0]), Round(landmark.position[1]) } },
                                  { "sigma_px", landmark.covariance ? Round(landmark.GetSigma()) : Json() } });
  }
  json["outline"] = Json::array();
  if (!jaw.contours.empty())
  {
    for (const auto & polyline : jaw.contours.front().second->GetPolylines())
    {
      json["outline"].push_back(DescribePolyline(polyline));
    }
  }
  return json;
}
} // namespace

TracingSession::TracingSession(std::shared_ptr<const DentalCaseData> data, unsigned int numberOfThreads)
  : m_Data(std::move(data))
  , m_Registration(CaseRegistration::New())
  , m_Drafts(std::make_unique<CrownDraftSource>(*m_Data))
{
  m_Registration->SetNumberOfWorkUnits(numberOfThreads > 0 ? numberOfThreads
                                                           : MultiThreaderBase::GetGlobalDefaultNumberOfThreads());
  // An abort reaches the registration between two of its steps, in its own thread.
  m_Registration->AddObserver(AnyEvent(), [this](const EventObject &) {
    if (m_IsAborted)
    {
      m_Registration->AbortGenerateDataOn();
    }
  });
}

TracingSession::~TracingSession() = default;

void
TracingSession::Abort()
{
  m_IsAborted = true;
}

std::string
TracingSession::Register(const std::string & drawings)
{
  const std::lock_guard<std::mutex> lock(m_Mutex);
  TimeProbe                         probe;
  probe.Start();
  const DrawingFiles files(drawings);
  try
  {
    auto data = std::make_shared<DentalCaseData>(*m_Data);
    // A ruler that is drawn sets the spacing: of this drawing, not of the next one.
    data->geometry = CephalometricGeometry::New();
    data->geometry->CopyParameters(m_Data->geometry);
    data->description.contoursFile = files.GetContours();
    data->description.cephalometricLandmarksFile = files.GetLandmarks();
    if (files.GetContours().empty() && files.GetLandmarks().empty())
    {
      itkDentalInputErrorMacro(
        "drawing",
        "",
        "nothing is drawn yet",
        "click the incisal tips and the mesiobuccal cusps of the first molars, or outline crowns");
    }
    LoadCaseDrawings(*data);
    m_Registration->SetData(data);
    m_Registration->Update();
    const CaseResult & result = m_Registration->GetResult();

    std::ostringstream side;
    side << data->description.tracedSide;
    Json json = { { "status", ToString(result.GetStatus()) },
                  { "traced_side", side.str() },
                  { "traced_side_is_given", data->description.tracedSideIsGiven },
                  { "jaws", Json::object() },
                  { "skipped", Json::object() },
                  { "drafts", { { "upper", Json::array() }, { "lower", Json::array() } } },
                  { "warnings", Json::array() } };
    for (const auto & entry : result.jaws)
    {
      json["jaws"][ToString(entry.first)] = DescribeJaw(entry.second);
    }
    for (const auto & entry : result.skipped)
    {
      json["skipped"][ToString(entry.first)] = entry.second;
    }
    for (const auto & [jaw, polylines] : m_Drafts->Compute(result))
    {
      for (const auto & polyline : polylines)
      {
        json["drafts"][ToString(jaw)].push_back(DescribePolyline(polyline));
      }
    }
    for (const std::string & warning : result.warnings)
    {
      json["warnings"].push_back(files.Clean(warning));
    }
    probe.Stop();
    json["seconds"] = Round(probe.GetTotal());
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  catch (const DentalInputError & error)
  {
    files.Throw(error);
  }
}

void
TracingSession::Verify(const std::string & drawings, const std::array<unsigned int, 2> & imageSize)
{
  const DrawingFiles files(drawings);
  try
  {
    if (!files.GetContours().empty())
    {
      auto reader = DentalContourFileReader::New();
      reader->SetFileName(files.GetContours());
      reader->SetImageSize({ { imageSize[0], imageSize[1] } });
      reader->Update();
    }
    if (!files.GetLandmarks().empty())
    {
      auto reader = CephalometricLandmarkFileReader::New();
      reader->SetFileName(files.GetLandmarks());
      reader->Update();
      CheckLandmarksInImage(*reader->GetOutput(), imageSize, "landmarks", "");
    }
  }
  catch (const DentalInputError & error)
  {
    files.Throw(error);
  }
}
} // namespace itk

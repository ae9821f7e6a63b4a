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
#include "dentalscrScanOptions.h"

#include "itkCaseResultFileReader.h"
#include "itkDentalInputError.h"
#include "itkDentalLandmarkFileReader.h"
#include "itkJsonDocument.h"
#include "itkLandmarkProjectionFilter.h"
#include "itkRequireJsonName.h"
#include "itkTextFile.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace dentalscr
{
namespace
{
using Json = nlohmann::ordered_json;
using JawEnum = itk::ToothCode::JawEnum;

struct ProjectOptions
{
  std::string result;
  std::string points;
  std::string jaw;
  std::string view;
  std::string output;
};

/** A point of a scan, in its file's unit. */
struct NamedPoint
{
  std::string                  name;
  JawEnum                      jaw{ JawEnum::Unknown };
  itk::PoseSolution::PointType point;
};

/** The jaw that a name tells, as landmarks' do; Unknown where it is any other name. */
JawEnum
JawOf(const std::string & name)
{
  try
  {
    return itk::DentalLandmarkSet<3>::ParseName(name).GetJaw();
  }
  catch (const std::invalid_argument &)
  {
    return JawEnum::Unknown;
  }
}

/** {"name": [x, y, z]}, with names of any kind; else a file of landmarks. */
std::vector<NamedPoint>
ReadPoints(const ProjectOptions & options)
{
  std::vector<NamedPoint> points;
  const std::string       text = itk::ReadTextFile(options.points, "a table of points");
  const std::size_t       first = text.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  const bool              isOwn = first != std::string::npos && text[first] == '{' &&
                     text.find("\"markups\"") == std::string::npos && text.find("\"shapes\"") == std::string::npos;
  if (isOwn)
  {
    for (const auto & member : itk::JsonDocument::Parse(text, options.points).GetRoot().GetMembers())
    {
      const auto numbers = member.second.AsNumbers(3, "[x, y, z]");
      NamedPoint point{ member.first, JawOf(member.first), {} };
      std::copy(numbers.begin(), numbers.end(), point.point.Begin());
      points.push_back(point);
    }
  }
  else
  {
    auto reader = itk::DentalLandmarkFileReader<3>::New();
    reader->SetFileName(options.points);
    reader->Update();
    for (const auto & landmark : reader->GetOutput()->GetLandmarks())
    {
      points.push_back({ landmark.name, landmark.tooth.GetJaw(), landmark.point });
    }
  }
  if (points.empty())
  {
    itkDentalInputErrorMacro(options.points, "", "holds no points", "give {\"name\": [x, y, z]}");
  }
  for (NamedPoint & point : points)
  {
    if (!options.jaw.empty())
    {
      point.jaw = options.jaw == "upper" ? JawEnum::Upper : JawEnum::Lower;
    }
    else if (point.jaw == JawEnum::Unknown)
    {
      itkDentalInputErrorMacro(options.points,
                               point.name,
                               "does not say of which jaw it is",
                               "give --jaw upper or lower, or a name such as UR1_tip");
    }
  }
  return points;
}

int
Project(const ProjectOptions & options)
{
  itk::RequireJsonName(options.output, "points");
  auto reader = itk::CaseResultFileReader::New();
  reader->SetFileName(options.result);
  reader->SetViewName(options.view);
  reader->Update();
  const itk::PoseSolution * solution = reader->GetOutput();
  Json                      json = Json::object();
  for (const NamedPoint & named : ReadPoints(options))
  {
    if (!solution->IsRegistered(named.jaw))
    {
      itkDentalInputErrorMacro(options.result,
                               named.jaw == JawEnum::Upper ? "jaws.upper" : "jaws.lower",
                               "was not registered, and " + named.name + " is of it",
                               "leave its points out, or name the other jaw with --jaw");
    }
    itk::PoseSolution::PointType point = named.point;
    for (unsigned int d = 0; d < 3; ++d)
    {
      point[d] *= reader->GetMillimetresPerUnit();
    }
    const auto pixel = solution->ProjectPoint(named.jaw, point);
    if (!std::isfinite(pixel[0]) || !std::isfinite(pixel[1]))
    {
      itkDentalInputErrorMacro(
        options.points, named.name, "is not projected to any place", "give a point of the scan, in its unit and frame");
    }
    json[named.name] = { { "jaw", itk::ToString(named.jaw) },
                         { "status", reader->GetStatus(named.jaw) },
                         { "position", { pixel[0], pixel[1] } },
                         { "sigma_px",
                           itk::LandmarkProjectionFilter::ToSigma(solution->ComputeCovariance(named.jaw, point)) } };
  }
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    const std::string & status = reader->GetStatus(jaw);
    if (status == "failed" || status == "suspect")
    {
      std::cerr << "dentalscr: warning: the " << jaw << " jaw is " << status << ": "
                << (status == "failed" ? "its points are not to be used" : "look at its overlay first") << '\n';
    }
  }
  const std::string text = json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
  if (options.output.empty())
  {
    std::cout << text << std::flush;
  }
  else
  {
    itk::WriteFileAtomically(options.output, text);
  }
  return AllRegistered;
}
} // namespace

void
AddProjectCommand(CLI::App & program, const CommonOptions &, RunFunction & run)
{
  auto   options = std::make_shared<ProjectOptions>();
  auto * command = program.add_subcommand("project", "Where points of a registered scan are on the radiograph");
  command->add_option("result", options->result, "result.json, or its folder")->type_name("FILE")->required();
  command
    ->add_option("--points", options->points, "JSON {\"name\": [x, y, z]} or landmarks, in the scan's frame and unit")
    ->type_name("FILE")
    ->required();
  command->add_option("--jaw", options->jaw, "The jaw of points whose names do not tell it")
    ->check(CLI::IsMember({ "upper", "lower" }));
  AddViewOption(command, options->view);
  command->add_option("-o,--output", options->output, "JSON file (default: standard output)")->type_name("FILE");
  command->footer("Gives position (continuous pixel index) and sigma_px (standard deviation an axis) of each.\n"
                  "Example:\n"
                  "  dentalscr project result --points landmarks3d.json\n"
                  "  dentalscr project result --points landmarks3d.json --view frontal\n");
  command->callback([options, &run]() { run = [options]() { return Project(*options); }; });
}
} // namespace dentalscr

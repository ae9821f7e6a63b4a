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

#include "itkCaseResultToJson.h"
#include "itkCaseResultWriter.h"
#include "itkMakeDentalFrameTransform.h"
#include "itkOutputFolder.h"
#include "itkReadDentalMesh.h"
#include "itkRigidTransformRows.h"
#include "itkTextFile.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <string>

namespace dentalscr
{
namespace
{
using JawEnum = itk::ToothCode::JawEnum;
using Json = nlohmann::ordered_json;

struct AxisOptions
{
  ScanOptions scans;
  std::string output;
  bool        embedAxes{ false };
  bool        refineMidline{ false };
};

int
Axis(const AxisOptions & options, const CommonOptions & common)
{
  const auto data = options.scans.Load();
  auto       scans = FindFrames(*data, options.refineMidline);
  auto       filter = scans.axis;
  filter->SetEmbedAxes(options.embedAxes);
  filter->Update();

  itk::OutputFolder           output(options.output);
  const std::filesystem::path folder(output.GetStagingFolder());
  const auto &                frames = filter->GetFrame();
  Json                        json;
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    if (data->GetJaw(jaw).mesh.IsNull())
    {
      continue;
    }
    const std::string name = itk::ToString(jaw);
    const auto &      frame = frames.GetJaw(jaw);
    itk::WriteDentalMesh(jaw == JawEnum::Upper ? filter->GetUpperOutput() : filter->GetLowerOutput(),
                         (folder / (name + "_umda.stl")).string());
    const auto matrix = itk::ToRows(*itk::MakeDentalFrameTransform(frame.axes, frame.origin));
    itk::WriteUMDATransform(matrix, (folder / (name + "_umda.tfm")).string());
    json[name] = { { "x_anterior", frame.axes[0] },
                   { "y_left", frame.axes[1] },
                   { "z_superior", frame.axes[2] },
                   { "origin_mm", frame.origin },
                   { "arch_width_mm", frame.archWidth },
                   { "arch_depth_mm", frame.archDepth },
                   { "confidence", frame.confidence },
                   { "findings", Json::parse(itk::FindingsToJson(scans.checks->GetFindings(jaw))) } };
    if (!common.quiet)
    {
      std::cout << name << ": arch " << std::fixed << std::setprecision(1) << frame.archWidth << " mm wide, "
                << frame.archDepth << " mm deep, confidence " << std::setprecision(2) << frame.confidence << '\n';
    }
  }
  json["jaws_share_frame"] = frames.jawsShareFrame;
  if (frames.occlusionFinding != itk::DentalFrameEnums::OcclusionFinding::NotTested)
  {
    json["occlusion_found"] = itk::DescribeOcclusion(frames);
    if (!common.quiet)
    {
      std::cout << itk::DescribeOcclusion(frames) << '\n';
    }
  }
  if (frames.jawsShareFrame)
  {
    json["overjet_mm"] = frames.overjet;
    json["overbite_mm"] = frames.overbite;
    if (!common.quiet)
    {
      std::cout << "overjet " << std::fixed << std::setprecision(1) << frames.overjet << " mm, overbite "
                << frames.overbite << " mm\n";
    }
  }
  json["warnings"] = data->warnings;
  json["not_checkable"] = scans.checks->GetNotCheckable();
  itk::WriteFileAtomically((folder / "axis.json").string(),
                           json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n');
  output.Publish("axis.json", { "upper_umda.stl", "lower_umda.stl", "upper_umda.tfm", "lower_umda.tfm" });
  if (!common.quiet)
  {
    std::cout << "written to " << options.output << std::endl;
  }
  return AllRegistered;
}
} // namespace

void
AddAxisCommand(CLI::App & program, const CommonOptions & common, RunFunction & run)
{
  auto   options = std::make_shared<AxisOptions>();
  auto * command = program.add_subcommand("axis", "The U-midline dental axis: scans in their anatomical frame");
  options->scans.AddTo(command, false);
  command->add_option("-o,--output", options->output, "Folder: *_umda.stl, *_umda.tfm, axis.json")
    ->type_name("FOLDER")
    ->required();
  command->add_flag("--embed-axes", options->embedAxes, "Add the axes to the meshes as arrows");
  command->add_flag("--refine-midline", options->refineMidline, "Find the midline by mirror symmetry");
  command->footer("x anterior, y to the patient's left, z superior; origin the area-weighted centroid.\n"
                  "Example:\n"
                  "  dentalscr axis --upper upper.stl --lower lower.stl --embed-axes --output axes\n");
  command->callback([options, &common, &run]() { run = [options, &common]() { return Axis(*options, common); }; });
}
} // namespace dentalscr

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

#include "itkCaseResultWriter.h"
#include "itkDentalInputError.h"
#include "itkReadDentalMesh.h"
#include "itkTextFile.h"
#include "itkUMidlineDentalAxisFilter.h"

#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>

namespace dentalscr
{
namespace
{
using JawEnum = itk::ToothCode::JawEnum;
using MeshType = itk::DentalCaseData::MeshType;
using FilterType = itk::UMidlineDentalAxisFilter<MeshType>;

struct AxisOptions
{
  ScanOptions scans;
  std::string output;
  bool        embedAxes{ false };
  bool        refineMidline{ false };
};

std::string
Row(double a, double b, double c)
{
  std::ostringstream text;
  text << std::setprecision(17) << '[' << a << ", " << b << ", " << c << ']';
  return text.str();
}

int
Axis(const AxisOptions & options, const CommonOptions & common)
{
  const auto data = options.scans.Load();
  auto       filter = FilterType::New();
  if (data->upper.mesh.IsNotNull())
  {
    filter->SetUpperMesh(data->upper.mesh);
  }
  if (data->lower.mesh.IsNotNull())
  {
    filter->SetLowerMesh(data->lower.mesh);
  }
  filter->SetEmbedAxes(options.embedAxes);
  filter->SetRefineMidline(options.refineMidline);
  filter->Update();

  std::error_code error;
  std::filesystem::create_directories(options.output, error);
  if (error)
  {
    itkDentalInputErrorMacro(
      options.output, "", "can't be written: " + error.message(), "choose another output folder");
  }
  const std::filesystem::path folder(options.output);
  std::ostringstream          json;
  json << std::setprecision(17) << "{\n";
  bool first = true;
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    if (data->GetJaw(jaw).mesh.IsNull())
    {
      continue;
    }
    const bool        upper = jaw == JawEnum::Upper;
    const std::string name = upper ? "upper" : "lower";
    const auto &      frame = upper ? filter->GetFrame().upper : filter->GetFrame().lower;
    itk::WriteDentalMesh(upper ? filter->GetUpperOutput() : filter->GetLowerOutput(),
                         (folder / (name + "_umda.stl")).string());
    std::array<double, 12> matrix{};
    for (unsigned int row = 0; row < 3; ++row)
    {
      for (unsigned int column = 0; column < 3; ++column)
      {
        matrix[4 * row + column] = frame.axes[row][column];
        matrix[4 * row + 3] -= frame.axes[row][column] * frame.origin[column];
      }
    }
    itk::WriteUMDATransform(matrix, (folder / (name + "_umda.tfm")).string());
    json << (first ? "" : ",\n") << " \"" << name
         << "\": {\n  \"x_anterior\": " << Row(frame.axes[0][0], frame.axes[0][1], frame.axes[0][2])
         << ",\n  \"y_left\": " << Row(frame.axes[1][0], frame.axes[1][1], frame.axes[1][2])
         << ",\n  \"z_superior\": " << Row(frame.axes[2][0], frame.axes[2][1], frame.axes[2][2])
         << ",\n  \"origin_mm\": " << Row(frame.origin[0], frame.origin[1], frame.origin[2])
         << ",\n  \"arch_width_mm\": " << frame.archWidth << ",\n  \"arch_depth_mm\": " << frame.archDepth
         << ",\n  \"confidence\": " << frame.confidence << "\n }";
    first = false;
    if (!common.quiet)
    {
      std::cout << name << ": arch " << std::fixed << std::setprecision(1) << frame.archWidth << " mm wide, "
                << frame.archDepth << " mm deep, confidence " << std::setprecision(2) << frame.confidence << '\n';
    }
  }
  const auto & frames = filter->GetFrame();
  json << ",\n \"jaws_share_frame\": " << (frames.jawsShareFrame ? "true" : "false");
  if (frames.occlusionFinding != itk::DentalFrameEnums::OcclusionFinding::NotTested)
  {
    json << ",\n \"occlusion_found\": \"" << itk::DescribeOcclusion(frames) << '"';
    if (!common.quiet)
    {
      std::cout << itk::DescribeOcclusion(frames) << '\n';
    }
  }
  if (frames.jawsShareFrame)
  {
    json << ",\n \"overjet_mm\": " << frames.overjet << ",\n \"overbite_mm\": " << frames.overbite;
    if (!common.quiet)
    {
      std::cout << "overjet " << std::fixed << std::setprecision(1) << frames.overjet << " mm, overbite "
                << frames.overbite << " mm\n";
    }
  }
  json << "\n}\n";
  itk::WriteFileAtomically((folder / "axis.json").string(), json.str());
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
  command->add_option("-o,--output", options->output, "Folder: *_umda.stl, *_umda.tfm, axis.json")->required();
  command->add_flag("--embed-axes", options->embedAxes, "Add the axes to the meshes as arrows");
  command->add_flag("--refine-midline", options->refineMidline, "Find the midline by mirror symmetry");
  command->footer("x anterior, y to the patient's left, z superior; origin the area-weighted centroid.\n"
                  "Example:\n"
                  "  dentalscr axis --upper upper.stl --lower lower.stl --embed-axes --output axes\n");
  command->callback([options, &common, &run]() { run = [options, &common]() { return Axis(*options, common); }; });
}
} // namespace dentalscr

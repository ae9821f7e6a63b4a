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
#include "dentalscrViewOptions.h"

namespace dentalscr
{
void
ViewOptions::AddTo(CLI::App * command)
{
  command->add_option("result", result, "result.json, or its folder")->type_name("FILE")->required();
  command->add_option("--snapshot", snapshot, "PNG file with a picture of the scene, instead of a window")
    ->type_name("FILE");
  command
    ->add_option("--export",
                 exportFile,
                 "File for other programs, instead of a window: .gltf (Blender, web), .vtm (ParaView), "
                 ".vtp (Slicer, ParaView)")
    ->type_name("FILE");
  command
    ->add_option(
      "--camera", camera, "overview, front, side, above, all, source, teeth, or the name of a view, as lateral")
    ->type_name("NAME")
    ->capture_default_str();
  command->add_option("--size", size, "Width and height of window or picture, pixels")
    ->check(CLI::Range(64u, 8192u))
    ->capture_default_str();
  command->add_option("--case", caseFile, "The case file, where it is no longer where the result says")
    ->type_name("FILE");
}

std::vector<std::string>
ViewOptions::ToArguments() const
{
  std::vector<std::string> arguments{
    "--camera=" + camera, "--size", std::to_string(size[0]), std::to_string(size[1])
  };
  for (const auto & option : { std::make_pair("--case=", &caseFile),
                               std::make_pair("--snapshot=", &snapshot),
                               std::make_pair("--export=", &exportFile) })
  {
    if (!option.second->empty())
    {
      arguments.push_back(option.first + *option.second);
    }
  }
  // A name that begins with a dash is no option behind these two.
  arguments.emplace_back("--");
  arguments.push_back(result);
  return arguments;
}
} // namespace dentalscr

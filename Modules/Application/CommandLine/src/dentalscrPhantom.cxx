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
#include "dentalscrSimulation.h"

#include "itkDentalInputError.h"
#include "itkDentalPhantomCaseSource.h"
#include "itkDentalPhantomCaseWriter.h"

#include <filesystem>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace dentalscr
{
namespace
{
using SourceType = itk::DentalPhantomCaseSource;

/** The level's table, a file on top of it, options on top of that. */
itk::DentalPhantomLevel
MakeLevel(const PhantomOptions & options)
{
  auto level = itk::DentalPhantomLevel::Named(options.level);
  if (!options.parameters.empty())
  {
    level.ReadJson(options.parameters);
  }
  if (!options.tracedSide.empty())
  {
    level.tracedSide = options.tracedSide;
  }
  if (!options.frame.empty())
  {
    level.frame = options.frame;
  }
  if (options.triangles > 0)
  {
    level.numberOfTriangles = options.triangles;
  }
  return level;
}

} // namespace
} // namespace dentalscr

int
DentalSCRMakePhantoms(const dentalscr::PhantomOptions & options, const dentalscr::CommonOptions & common)
{
  using namespace dentalscr;
  const auto level = MakeLevel(options);
  if (options.showParameters)
  {
    std::cout << level.ToJson() << std::flush;
    return AllRegistered;
  }
  if (options.output.empty())
  {
    itkDentalInputErrorMacro("--output", "", "missing", "name the folder of the case, or of the cases");
  }
  for (unsigned int i = 0; i < options.count; ++i)
  {
    std::string folder = options.output;
    if (options.count > 1)
    {
      std::ostringstream name;
      name << level.name << '-' << std::setw(4) << std::setfill('0') << options.seed + i;
      folder = (std::filesystem::path(options.output) / name.str()).string();
    }
    if (std::filesystem::exists(folder) &&
        (!std::filesystem::is_directory(folder) || !std::filesystem::is_empty(folder)))
    {
      itkDentalInputErrorMacro(folder, "", "is there already", "name a new or an empty folder");
    }
    auto source = SourceType::New();
    source->SetSeed(options.seed + i);
    source->SetLevel(level);
    source->SetBuccalOutline(options.buccal);
    source->SetStoneBase(options.stoneBase);
    source->SetMakeRadiograph(!options.noRadiograph);
    source->SetToothBias(options.toothBias);
    source->SetDropOutFraction(options.dropOut);
    source->SetFacing(options.facing == "left" ? itk::CephalometricGeometry::FacingEnum::Left
                                               : itk::CephalometricGeometry::FacingEnum::Right);
    source->SetSourceSide(options.sourceSide == "left" ? itk::CephalometricGeometry::SourceSideEnum::Left
                                                       : itk::CephalometricGeometry::SourceSideEnum::Right);
    std::error_code error;
    std::filesystem::create_directories(std::filesystem::absolute(folder).parent_path(), error);
    if (error)
    {
      itkDentalInputErrorMacro(folder, "", "can't be written: " + error.message(), "choose another output folder");
    }
    auto writer = itk::DentalPhantomCaseWriter::New();
    writer->SetCaseSource(source);
    writer->SetDirectoryName(folder);
    writer->SetPreviewSize(options.preview);
    writer->Update();
    if (!common.quiet)
    {
      std::cout << "written to " << folder << std::endl;
    }
  }
  return AllRegistered;
}

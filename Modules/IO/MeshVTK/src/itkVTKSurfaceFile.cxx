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
#include "itkVTKSurfaceFile.h"

#include "itkDentalInputError.h"
#include "itkInputFile.h"
#include "itkLowerCase.h"
#include "itkVTKSurfaceParts.h"
#include "itkVerifyScanSize.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <new>

namespace itk
{
namespace
{
constexpr const char * LabelNames[] = { "Universal_ID", "UniversalID", "PredictedID" };

std::string
ReadAll(const std::string & fileName)
{
  try
  {
    InputFile file(fileName);
    VerifyScanSize(file);
    return ReadWhole(file, "a scan", file.GetSize());
  }
  catch (const InputFileError & error)
  {
    throw VTKFileError("", error.what(), error.GetRemedy());
  }
}

void
AddFaces(const VTKSurfaceParts::CellsType & cells, bool strips, VTKSurfaceFile & surface)
{
  const auto   points = static_cast<std::int64_t>(surface.points.size());
  const auto   numbers = static_cast<std::int64_t>(cells.connectivity.size());
  const char * kind = strips ? "strip " : "polygon ";
  for (std::size_t c = 0; c + 1 < cells.offsets.size(); ++c)
  {
    const std::int64_t begin = cells.offsets[c];
    const std::int64_t end = cells.offsets[c + 1];
    const std::string  field = kind + std::to_string(c + 1);
    if (begin < 0 || end < begin || end > numbers)
    {
      throw VTKFileError(field, "its corners are not within the list of corners");
    }
    ++surface.numberOfFacesInFile;
    const std::int64_t * const ids = cells.connectivity.data() + begin;
    const std::int64_t         count = end - begin;
    if (count < 3)
    {
      throw VTKFileError(field, "has " + std::to_string(count) + " corners, at least 3 are needed");
    }
    for (std::int64_t k = 0; k < count; ++k)
    {
      if (ids[k] < 0 || ids[k] >= points)
      {
        throw VTKFileError(field,
                           "names a point that is not there; there are " + std::to_string(points) + ", counted from 0");
      }
    }
    for (std::int64_t k = 2; k < count; ++k)
    {
      // Strips turn at every other triangle.
      const std::int64_t                 a = strips ? (k % 2 == 0 ? k - 2 : k - 1) : 0;
      const std::int64_t                 b = strips ? (k % 2 == 0 ? k - 1 : k - 2) : k - 1;
      const std::array<std::uint32_t, 3> triangle{
        { static_cast<std::uint32_t>(ids[a]), static_cast<std::uint32_t>(ids[b]), static_cast<std::uint32_t>(ids[k]) }
      };
      if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
      {
        ++surface.numberOfDegenerateFaces;
      }
      else
      {
        surface.triangles.push_back(triangle);
      }
    }
  }
  if (!cells.connectivity.empty() && cells.offsets.back() != numbers)
  {
    throw VTKFileError(strips ? "TRIANGLE_STRIPS" : "POLYGONS", "has corners that belong to no face");
  }
}

VTKSurfaceFile
Assemble(VTKSurfaceParts && parts)
{
  VTKSurfaceFile surface;
  if (parts.points.empty())
  {
    throw VTKFileError("", "has no points");
  }
  if (parts.points.size() > std::numeric_limits<std::uint32_t>::max() - 1u)
  {
    throw VTKFileError("", "has more points than can be numbered", "thin the scan out");
  }
  for (std::size_t i = 0; i < parts.points.size(); ++i)
  {
    for (const double value : parts.points[i])
    {
      if (!(std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max())))
      {
        throw VTKFileError("point " + std::to_string(i + 1), "a coordinate is not finite");
      }
    }
  }
  surface.points = std::move(parts.points);
  AddFaces(parts.polygons, false, surface);
  AddFaces(parts.strips, true, surface);
  if (surface.triangles.empty())
  {
    throw VTKFileError("",
                       surface.numberOfFacesInFile == 0 ? "has no triangles" : "all of its faces name a point twice");
  }
  for (const char * name : LabelNames)
  {
    for (auto & labels : parts.labels)
    {
      if (labels.name != name || !surface.labelName.empty())
      {
        continue;
      }
      if (labels.ofCells)
      {
        surface.labelsOfCells = true;
        continue;
      }
      if (labels.values.size() != surface.points.size())
      {
        throw VTKFileError(name,
                           "has " + std::to_string(labels.values.size()) + " values for " +
                             std::to_string(surface.points.size()) + " points",
                           "give one number a point");
      }
      surface.labelName = name;
      surface.labels = std::move(labels.values);
    }
  }
  surface.labelsOfCells = surface.labelsOfCells && surface.labelName.empty();
  return surface;
}
} // namespace

bool
IsVTKLabelName(const std::string & name)
{
  return std::find(std::begin(LabelNames), std::end(LabelNames), name) != std::end(LabelNames);
}

double
ParseVTKNumber(const char * begin, const char * end, const std::string & field)
{
  // from_chars knows no plus sign.
  begin += begin + 1 < end && *begin == '+' && begin[1] != '-' ? 1 : 0;
  double     value = 0.0;
  const auto result = std::from_chars(begin, end, value);
  // A number too small for a double is 0, one too large is none.
  const bool tiny = result.ec == std::errc::result_out_of_range && std::search(begin, end, "e-", "e-" + 2) != end;
  if (result.ptr != end || (result.ec != std::errc() && !tiny))
  {
    throw VTKFileError(field, "has something that is no number where one should be");
  }
  return tiny ? 0.0 : value;
}

std::int64_t
ToVTKInteger(double value, const std::string & field)
{
  if (!(std::abs(value) < 9007199254740992.0) || value != std::floor(value))
  {
    throw VTKFileError(field, "has a number that is no index or count");
  }
  return static_cast<std::int64_t>(value);
}

bool
IsVTKSurfaceFileName(const std::string & fileName)
{
  const std::string end = LowerCase(fileName.substr(fileName.size() - std::min<std::size_t>(fileName.size(), 4)));
  return end == ".vtk" || end == ".vtp";
}

VTKSurfaceFile
ReadVTKSurfaceFile(const std::string & fileName)
{
  try
  {
    const std::string bytes = ReadAll(fileName);
    if (bytes.compare(0, 5, "# vtk") == 0)
    {
      return Assemble(ParseLegacyVTK(bytes));
    }
    if (bytes.substr(0, 4096).find("<VTKFile") != std::string::npos)
    {
      return Assemble(ParseXMLVTK(bytes));
    }
    throw VTKFileError("",
                       "its content is neither a legacy nor an XML file of VTK",
                       "give a .vtk or .vtp file, or the scan as STL, PLY, OBJ or OFF");
  }
  catch (const VTKFileError & error)
  {
    itkDentalInputErrorMacro(fileName, error.field, error.what(), error.remedy);
  }
  catch (const std::bad_alloc &)
  {
    itkDentalInputErrorMacro(fileName, "", "is too large for the memory", "thin the scan out");
  }
}
} // namespace itk

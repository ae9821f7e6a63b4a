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
#ifndef itkVTKSurfaceParts_h
#define itkVTKSurfaceParts_h

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace itk
{
/** What is wrong with a VTK file, without its name. */
struct VTKFileError : std::runtime_error
{
  VTKFileError(const std::string & inField, const std::string & problem, const std::string & inRemedy = {})
    : std::runtime_error(problem)
    , field(inField)
    , remedy(inRemedy.empty() ? "export or copy the file again" : inRemedy)
  {}
  std::string field;
  std::string remedy;
};

/** What the parsers find, before anything is checked but counts. */
struct VTKSurfaceParts
{
  /** Cell c is connectivity[offsets[c]] to connectivity[offsets[c + 1] - 1]. */
  struct CellsType
  {
    std::vector<std::int64_t> offsets{ 0 };
    std::vector<std::int64_t> connectivity;
  };
  struct LabelsType
  {
    std::string         name;
    std::vector<double> values;
    bool                ofCells;
  };
  std::vector<std::array<double, 3>> points;
  CellsType                          polygons;
  CellsType                          strips;
  /** Of the names in IsVTKLabelName(). */
  std::vector<LabelsType> labels;
};

/** Universal_ID, UniversalID, PredictedID. */
bool
IsVTKLabelName(const std::string & name);

/** Throw VTKFileError, and take no more memory than the file's size justifies. */
VTKSurfaceParts
ParseLegacyVTK(const std::string & bytes);
VTKSurfaceParts
ParseXMLVTK(const std::string & bytes);

/** A number of a text in full, in any locale; throws VTKFileError. */
double
ParseVTKNumber(const char * begin, const char * end, const std::string & field);

/** A whole number that is an index or a count; throws VTKFileError. */
std::int64_t
ToVTKInteger(double value, const std::string & field);
} // namespace itk

#endif

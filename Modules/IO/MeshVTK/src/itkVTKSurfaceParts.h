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
#include <cstddef>
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

/** \class VTKMemoryBudget
 * \brief Not installed. What the numbers of one file may take, whatever they are written as.
 *
 * A small file may hold many: zlib makes 2 GB of 2 MB, and a bit becomes a double. Parsers spend before they allocate.
 */
class VTKMemoryBudget
{
public:
  /** Those of the largest scans, of 3 million triangles, take a third. */
  static constexpr std::size_t Largest = std::size_t{ 1 } << 29;

  /** Every number is read as a double. Throws VTKFileError where less is left. */
  void
  SpendNumbers(std::size_t count, const std::string & field)
  {
    if (count > m_Left / sizeof(double))
    {
      throw VTKFileError(field,
                         "and what stands before it take more than " + std::to_string(Largest >> 20) +
                           " MiB as numbers, which no scan of teeth does",
                         "thin the scan out, or export it again");
    }
    m_Left -= count * sizeof(double);
  }

private:
  std::size_t m_Left{ Largest };
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

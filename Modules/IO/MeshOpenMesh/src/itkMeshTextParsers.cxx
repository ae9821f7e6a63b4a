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
#include "itkMeshTextParsers.h"

#include "itkASCIICharacter.h"
#include "itkBinarySTLKernel.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

namespace itk
{
namespace
{
constexpr std::size_t MaximumNumberOfPoints = 0xfffffffeu;

/** A line's end parts records, blanks part words. */
bool
IsBlank(char character)
{
  return IsASCIIBlank(character) && character != '\n';
}

bool
EqualsIgnoringCase(std::string_view word, std::string_view lowerCase)
{
  return word.size() == lowerCase.size() && std::equal(word.begin(), word.end(), lowerCase.begin(), [](char a, char b) {
           return ToASCIILowerCase(a) == b;
         });
}

std::string_view
WithoutPlus(std::string_view word)
{
  return word.size() > 1 && word.front() == '+' && word[1] != '-' ? word.substr(1) : word;
}
} // namespace

MeshTextCursor::MeshTextCursor(const char * bytes, std::size_t size, bool numberSignIsComment)
  : m_Position(bytes)
  , m_End(bytes + size)
  , m_NumberSignIsComment(numberSignIsComment)
{
  if (std::string_view(bytes, size).substr(0, 3) == "\xEF\xBB\xBF")
  {
    m_Position += 3;
  }
}

void
MeshTextCursor::SkipBlanks()
{
  while (m_Position != m_End)
  {
    if (IsBlank(*m_Position))
    {
      ++m_Position;
    }
    else if (*m_Position == '\\' && m_End - m_Position >= 2 && m_Position[1] == '\n')
    {
      // A continued line, as OBJ has them.
      m_Position += 2;
      ++m_Line;
    }
    else if (*m_Position == '\\' && m_End - m_Position >= 3 && m_Position[1] == '\r' && m_Position[2] == '\n')
    {
      m_Position += 3;
      ++m_Line;
    }
    else if (*m_Position == '#' && m_NumberSignIsComment)
    {
      m_Position = std::find(m_Position, m_End, '\n');
    }
    else
    {
      break;
    }
  }
}

std::string_view
MeshTextCursor::NextWordOfLine()
{
  this->SkipBlanks();
  const char * const begin = m_Position;
  while (m_Position != m_End && !IsBlank(*m_Position) && *m_Position != '\n' &&
         !(*m_Position == '#' && m_NumberSignIsComment))
  {
    ++m_Position;
  }
  return std::string_view(begin, static_cast<std::size_t>(m_Position - begin));
}

bool
MeshTextCursor::NextRecord()
{
  this->SkipBlanks();
  while (m_Position != m_End && *m_Position == '\n')
  {
    ++m_Position;
    ++m_Line;
    this->SkipBlanks();
  }
  return m_Position != m_End;
}

std::string_view
MeshTextCursor::NextWord()
{
  return this->NextRecord() ? this->NextWordOfLine() : std::string_view();
}

std::string_view
MeshTextCursor::SkipLine()
{
  const char * const begin = m_Position;
  m_Position = std::find(m_Position, m_End, '\n');
  const std::string_view rest(begin, static_cast<std::size_t>(m_Position - begin));
  if (m_Position != m_End)
  {
    ++m_Position;
    ++m_Line;
  }
  return rest;
}

double
MeshTextCursor::ParseNumber(std::string_view word, const char * what) const
{
  if (word.empty())
  {
    this->Fail(std::string("lacks ") + what);
  }
  const std::string_view text = WithoutPlus(word);
  double                 value = 0.0;
  const auto             result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ptr != text.data() + text.size() || result.ec == std::errc::invalid_argument)
  {
    this->Fail(QuoteForMessage(word) + " is no number for " + what,
               word.find(',') != std::string_view::npos ? "export it with a decimal point"
                                                        : "repair it or export it again");
  }
  if (result.ec == std::errc::result_out_of_range)
  {
    // Too small is zero, too large is not a coordinate.
    const bool small = text.find("e-") != std::string_view::npos || text.find("E-") != std::string_view::npos;
    value = small ? 0.0 : std::numeric_limits<double>::infinity();
  }
  if (std::isnan(value))
  {
    this->Fail(std::string(what) + " is not a number", "repair the mesh in the scanner's software");
  }
  if (!(std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max())))
  {
    this->Fail(std::string(what) + ' ' + QuoteForMessage(word) + " is infinite in single precision",
               "repair the mesh in the scanner's software");
  }
  return value;
}

std::int64_t
MeshTextCursor::ParseInteger(std::string_view word, const char * what) const
{
  if (word.empty())
  {
    this->Fail(std::string("lacks ") + what);
  }
  const std::string_view text = WithoutPlus(word);
  std::int64_t           value = 0;
  const auto             result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size())
  {
    this->Fail(QuoteForMessage(word) + " is no whole number for " + what);
  }
  return value;
}

void
MeshTextCursor::Fail(const std::string & problem, const std::string & remedy) const
{
  throw SurfaceMeshFileError("line " + std::to_string(m_Line), problem, remedy);
}

std::string
QuoteForMessage(std::string_view word)
{
  constexpr std::size_t longest = 32;
  std::string           quoted = "\"";
  for (const char character : word.substr(0, longest))
  {
    quoted += character >= ' ' && character <= '~' ? character : '?';
  }
  return quoted + (word.size() > longest ? "...\"" : "\"");
}

void
AddPolygon(SurfaceMeshFile & surface, const std::uint32_t * corners, std::size_t count)
{
  for (std::size_t i = 2; i < count; ++i)
  {
    const SurfaceMeshFile::TriangleType triangle{ corners[0], corners[i - 1], corners[i] };
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

SurfaceMeshFile
ParseAsciiSTL(const char * bytes, std::size_t size)
{
  MeshTextCursor cursor(bytes, size, false);
  const auto     expect = [&cursor](const char * keyword) {
    const std::string_view word = cursor.NextWord();
    if (word.empty())
    {
      cursor.Fail(std::string("the file ends where \"") + keyword + "\" is expected: it is truncated",
                  "export or copy the scan again");
    }
    if (!EqualsIgnoringCase(word, keyword))
    {
      cursor.Fail(QuoteForMessage(word) + " where \"" + keyword + "\" is expected");
    }
  };
  // The welding is the binary reader's: gather what such a file would hold.
  std::string   binary(84, '\0');
  std::uint32_t facets = 0;
  expect("solid");
  cursor.SkipLine();
  for (bool inSolid = true; inSolid;)
  {
    std::string_view word = cursor.NextWord();
    if (EqualsIgnoringCase(word, "endsolid"))
    {
      cursor.SkipLine();
      word = cursor.NextWord();
      if (word.empty())
      {
        inSolid = false;
      }
      else if (EqualsIgnoringCase(word, "solid"))
      {
        cursor.SkipLine();
      }
      else
      {
        cursor.Fail(QuoteForMessage(word) + " after the end of the solid");
      }
      continue;
    }
    if (!EqualsIgnoringCase(word, "facet"))
    {
      cursor.Fail(word.empty() ? "the file ends before \"endsolid\": it is truncated"
                               : QuoteForMessage(word) + " where \"facet\" or \"endsolid\" is expected",
                  word.empty() ? "export or copy the scan again" : "repair it or export it again");
    }
    expect("normal");
    for (int i = 0; i < 3; ++i)
    {
      // Not used, and some exporters write "nan" for needles.
      if (cursor.NextWord().empty())
      {
        expect("a normal");
      }
    }
    expect("outer");
    expect("loop");
    char facet[50] = {};
    for (int corner = 0; corner < 3; ++corner)
    {
      expect("vertex");
      for (int d = 0; d < 3; ++d)
      {
        const auto value = static_cast<float>(cursor.ParseNumber(cursor.NextWord(), "a coordinate"));
        // Little endian.
        std::uint32_t bits;
        std::memcpy(&bits, &value, 4);
        for (int byte = 0; byte < 4; ++byte)
        {
          facet[12 + 12 * corner + 4 * d + byte] = static_cast<char>(bits >> (8 * byte) & 0xffu);
        }
      }
    }
    expect("endloop");
    expect("endfacet");
    binary.append(facet, sizeof(facet));
    ++facets;
  }
  for (int byte = 0; byte < 4; ++byte)
  {
    binary[80 + byte] = static_cast<char>(facets >> (8 * byte) & 0xffu);
  }
  WeldedTriangles welded = ParseBinarySTL(binary.data(), binary.size());
  SurfaceMeshFile surface;
  surface.floatPoints = std::move(welded.points);
  surface.triangles = std::move(welded.triangles);
  surface.numberOfFacesInFile = welded.numberOfFacets;
  surface.numberOfDegenerateFaces = welded.numberOfDegenerateFacets;
  return surface;
}

SurfaceMeshFile
ParseOBJ(const char * bytes, std::size_t size)
{
  MeshTextCursor             cursor(bytes, size, true);
  SurfaceMeshFile            surface;
  std::vector<std::uint32_t> corners;
  // Faces may name points that come later: the largest index is checked at the end.
  std::int64_t largest = 0;
  std::size_t  largestLine = 0;
  while (cursor.NextRecord())
  {
    const std::string_view keyword = cursor.NextWordOfLine();
    if (keyword == "v")
    {
      std::array<double, 3> point;
      for (double & coordinate : point)
      {
        coordinate = cursor.ParseNumber(cursor.NextWordOfLine(), "a coordinate");
      }
      if (surface.doublePoints.size() == MaximumNumberOfPoints)
      {
        cursor.Fail("there are more points than can be numbered", "decimate the mesh");
      }
      surface.doublePoints.push_back(point);
    }
    else if (keyword == "f")
    {
      corners.clear();
      const auto points = static_cast<std::int64_t>(surface.doublePoints.size());
      for (std::string_view word = cursor.NextWordOfLine(); !word.empty(); word = cursor.NextWordOfLine())
      {
        const std::size_t  slash = std::min(word.find('/'), word.size());
        const std::int64_t index = cursor.ParseInteger(word.substr(0, slash), "a point's index");
        if (word.find_first_not_of("0123456789/-+", slash) != std::string_view::npos ||
            std::count(word.begin(), word.end(), '/') > 2)
        {
          cursor.Fail(QuoteForMessage(word) + " is no corner of a face (i, i/j, i//k or i/j/k)");
        }
        // Negative indices count back from the last point so far.
        const std::int64_t number = index < 0 ? points + index : index - 1;
        if (number < 0 || number >= static_cast<std::int64_t>(MaximumNumberOfPoints))
        {
          cursor.Fail("a face names point " + std::to_string(index) + " of " + std::to_string(points) +
                      " (counted from 1, or backwards from -1)");
        }
        if (number > largest)
        {
          largest = number;
          largestLine = cursor.GetLine();
        }
        corners.push_back(static_cast<std::uint32_t>(number));
      }
      if (corners.size() < 3)
      {
        cursor.Fail("a face has " + std::to_string(corners.size()) + " corners, at least 3 are needed");
      }
      ++surface.numberOfFacesInFile;
      AddPolygon(surface, corners.data(), corners.size());
    }
    else if (!std::all_of(keyword.begin(), keyword.end(), [](char c) { return IsASCIIAlphanumeric(c) || c == '_'; }))
    {
      cursor.Fail(QuoteForMessage(keyword) + " is no OBJ record");
    }
    // Normals, texture, groups, materials and what vendors add are of no use here.
    while (!cursor.NextWordOfLine().empty())
    {}
  }
  if (surface.numberOfFacesInFile > 0 && largest >= static_cast<std::int64_t>(surface.doublePoints.size()))
  {
    throw SurfaceMeshFileError("line " + std::to_string(largestLine),
                               "a face names point " + std::to_string(largest + 1) + ", the file has " +
                                 std::to_string(surface.doublePoints.size()),
                               "export or copy the scan again");
  }
  return surface;
}

SurfaceMeshFile
ParseOFF(const char * bytes, std::size_t size)
{
  MeshTextCursor         cursor(bytes, size, true);
  const std::string_view header = cursor.NextWord();
  if (header.find_first_of("4n") != std::string_view::npos)
  {
    cursor.Fail(QuoteForMessage(header) + " has points that are not three-dimensional", "save it as plain OFF");
  }
  if (header.size() < 3 || header.substr(header.size() - 3) != "OFF")
  {
    cursor.Fail(QuoteForMessage(header) + " where \"OFF\" is expected");
  }
  std::string_view word = cursor.NextWord();
  if (word == "BINARY")
  {
    cursor.Fail("binary OFF is not supported", "save it as text OFF or as binary PLY");
  }
  const std::int64_t points = cursor.ParseInteger(word, "the number of points");
  const std::int64_t faces = cursor.ParseInteger(cursor.NextWord(), "the number of faces");
  // "0 0 0\n" and "3 0 0 0\n" are the shortest records.
  const auto remaining = static_cast<std::int64_t>(cursor.GetRemaining()) + 1;
  if (points < 0 || faces < 0 || points > remaining / 6 || faces > remaining / 8)
  {
    cursor.Fail("the header promises " + std::to_string(points) + " points and " + std::to_string(faces) +
                  " faces, more than " + std::to_string(remaining - 1) + " bytes can hold",
                "export or copy the scan again");
  }
  // The number of edges is of no use, and some leave it out.
  cursor.SkipLine();
  SurfaceMeshFile surface;
  surface.doublePoints.reserve(static_cast<std::size_t>(points));
  surface.triangles.reserve(static_cast<std::size_t>(faces));
  surface.numberOfFacesInFile = static_cast<std::size_t>(faces);
  const auto nextRecord = [&cursor](const char * what, std::int64_t number, std::int64_t count) {
    if (!cursor.NextRecord())
    {
      cursor.Fail(std::string("the file ends before ") + what + ' ' + std::to_string(number + 1) + " of " +
                    std::to_string(count),
                  "export or copy the scan again");
    }
  };
  for (std::int64_t i = 0; i < points; ++i)
  {
    nextRecord("point", i, points);
    std::array<double, 3> point;
    for (double & coordinate : point)
    {
      coordinate = cursor.ParseNumber(cursor.NextWordOfLine(), "a coordinate");
    }
    surface.doublePoints.push_back(point);
    // Normals, colours, texture.
    cursor.SkipLine();
  }
  std::vector<std::uint32_t> corners;
  for (std::int64_t i = 0; i < faces; ++i)
  {
    nextRecord("face", i, faces);
    const std::int64_t count = cursor.ParseInteger(cursor.NextWordOfLine(), "a face's number of corners");
    if (count < 3)
    {
      cursor.Fail("a face has " + std::to_string(count) + " corners, at least 3 are needed");
    }
    corners.clear();
    for (std::int64_t c = 0; c < count; ++c)
    {
      const std::int64_t index = cursor.ParseInteger(cursor.NextWordOfLine(), "a point's index");
      if (index < 0 || index >= points)
      {
        cursor.Fail("a face names point " + std::to_string(index) + " of " + std::to_string(points) +
                    " (counted from 0)");
      }
      corners.push_back(static_cast<std::uint32_t>(index));
    }
    AddPolygon(surface, corners.data(), corners.size());
    // A colour.
    cursor.SkipLine();
  }
  if (cursor.NextRecord())
  {
    cursor.Fail("there is more after the " + std::to_string(points) + " points and " + std::to_string(faces) +
                " faces that the header promises");
  }
  return surface;
}
} // namespace itk

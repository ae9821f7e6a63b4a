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
#include "itkVTKSurfaceParts.h"

#include "itkASCIICharacter.h"
#include "itkLowerCase.h"

#include <algorithm>
#include <cstring>

namespace itk
{
namespace
{
/** Size in a binary file, whether a floating-point number, whether signed. */
struct TypeInfo
{
  const char * name;
  unsigned int size;
  bool         real;
  bool         isSigned;
};

constexpr TypeInfo Types[] = { { "bit", 0, false, false },
                               { "char", 1, false, true },
                               { "signed_char", 1, false, true },
                               { "unsigned_char", 1, false, false },
                               { "short", 2, false, true },
                               { "unsigned_short", 2, false, false },
                               { "int", 4, false, true },
                               { "unsigned_int", 4, false, false },
                               // As an int, whatever the identifiers of the writer were.
                               { "vtkidtype", 4, false, true },
                               { "long", 8, false, true },
                               { "unsigned_long", 8, false, false },
                               { "vtktypeint64", 8, false, true },
                               { "vtktypeuint64", 8, false, false },
                               { "float", 4, true, true },
                               { "double", 8, true, true } };

class LegacyParser
{
public:
  explicit LegacyParser(const std::string & bytes)
    : m_Position(bytes.data())
    , m_End(bytes.data() + bytes.size())
  {}

  VTKSurfaceParts
  Parse()
  {
    const std::string version = this->Line();
    const std::size_t number = version.find("Version");
    if (version.compare(0, 5, "# vtk") != 0 || number == std::string::npos)
    {
      throw VTKFileError("line 1", "does not name the version of a legacy VTK file");
    }
    m_OffsetsAndConnectivity = version.size() > number + 8 && version[number + 8] >= '5';
    this->Line();
    const std::string encoding = LowerCase(this->Word());
    if (encoding != "ascii" && encoding != "binary")
    {
      throw VTKFileError("line 3", "says neither ASCII nor BINARY");
    }
    m_Binary = encoding == "binary";
    if (LowerCase(this->Word()) != "dataset" || LowerCase(this->Word()) != "polydata")
    {
      throw VTKFileError("DATASET", "is not POLYDATA", "write the surface as PolyData");
    }
    for (std::string word = LowerCase(this->Word()); !word.empty(); word = LowerCase(this->Word()))
    {
      this->ParseSection(word);
    }
    return std::move(m_Parts);
  }

private:
  void
  ParseSection(const std::string & word)
  {
    m_Field = word;
    std::transform(m_Field.begin(), m_Field.end(), m_Field.begin(), ToASCIIUpperCase);
    if (word == "points")
    {
      const std::size_t         count = this->Count();
      const std::vector<double> values = this->Values(this->Type(), 3, count);
      m_Parts.points.resize(count);
      for (std::size_t i = 0; i < count; ++i)
      {
        m_Parts.points[i] = { { values[3 * i], values[3 * i + 1], values[3 * i + 2] } };
      }
    }
    else if (word == "polygons" || word == "triangle_strips" || word == "vertices" || word == "lines")
    {
      VTKSurfaceParts::CellsType cells = this->Cells();
      if (word == "polygons" || word == "triangle_strips")
      {
        (word == "polygons" ? m_Parts.polygons : m_Parts.strips) = std::move(cells);
      }
    }
    else if (word == "point_data" || word == "cell_data")
    {
      m_Attributes = word == "point_data" ? Attributes::Points : Attributes::Cells;
      m_Tuples = this->Count();
    }
    else if (word == "field")
    {
      this->Word();
      for (std::size_t arrays = this->Count(); arrays > 0; --arrays)
      {
        std::string name = this->Word();
        // Between two arrays there may be what is known of the first one.
        while (LowerCase(name) == "metadata")
        {
          this->SkipMetadata();
          name = this->Word();
        }
        const std::size_t components = this->Count();
        const std::size_t tuples = this->Count();
        const std::string type = LowerCase(this->Word());
        this->Take(name,
                   components,
                   type == "string" ? this->Strings(components, tuples) : this->Values(type, components, tuples));
      }
    }
    else if (word == "scalars")
    {
      const std::string name = this->Word();
      const std::string type = this->Type();
      std::size_t       components = 1;
      if (const std::string rest = this->Line(); rest.find_first_not_of(" \t\r") != std::string::npos)
      {
        components = this->ToCount(rest);
      }
      if (LowerCase(this->Word()) != "lookup_table")
      {
        this->Fail("has no LOOKUP_TABLE");
      }
      this->Word();
      this->Take(name, components, this->Values(type, components, m_Tuples));
    }
    else if (word == "color_scalars")
    {
      this->Word();
      this->Values(m_Binary ? "unsigned_char" : "float", this->Count(), m_Tuples);
    }
    else if (word == "lookup_table")
    {
      this->Word();
      this->Values(m_Binary ? "unsigned_char" : "float", 4, this->Count());
    }
    else if (word == "texture_coordinates")
    {
      this->Word();
      const std::size_t components = this->Count();
      this->Values(this->Type(), components, m_Tuples);
    }
    else if (word == "vectors" || word == "normals" || word == "tensors" || word == "tensors6" ||
             word == "global_ids" || word == "pedigree_ids" || word == "edge_flags")
    {
      const std::string name = this->Word();
      const std::size_t components = word == "tensors"                        ? 9
                                     : word == "tensors6"                     ? 6
                                     : word == "vectors" || word == "normals" ? 3
                                                                              : 1;
      this->Take(name, components, this->Values(this->Type(), components, m_Tuples));
    }
    else if (word == "metadata")
    {
      this->SkipMetadata();
    }
    else
    {
      m_Field.clear();
      this->Fail("holds something that is no section of a PolyData file where one should begin");
    }
  }

  VTKSurfaceParts::CellsType
  Cells()
  {
    VTKSurfaceParts::CellsType cells;
    const std::size_t          first = this->Count();
    const std::size_t          second = this->Count();
    if (!m_OffsetsAndConnectivity)
    {
      // Per cell its number of corners and the corners.
      const std::vector<double> values = this->Values("int", 1, second);
      std::size_t               at = 0;
      for (std::size_t c = 0; c < first; ++c)
      {
        const std::int64_t corners = at < second ? ToVTKInteger(values[at], m_Field) : -1;
        if (corners < 0 || static_cast<std::size_t>(corners) >= second - at)
        {
          this->Fail("has fewer numbers than its cells need");
        }
        for (std::int64_t k = 1; k <= corners; ++k)
        {
          cells.connectivity.push_back(ToVTKInteger(values[at + static_cast<std::size_t>(k)], m_Field));
        }
        at += 1 + static_cast<std::size_t>(corners);
        cells.offsets.push_back(static_cast<std::int64_t>(cells.connectivity.size()));
      }
      if (at != second)
      {
        this->Fail("has more numbers than its cells need");
      }
      return cells;
    }
    for (const bool offsets : { true, false })
    {
      if (LowerCase(this->Word()) != (offsets ? "offsets" : "connectivity"))
      {
        this->Fail(offsets ? "has no OFFSETS" : "has no CONNECTIVITY");
      }
      auto & target = offsets ? cells.offsets : cells.connectivity;
      target.clear();
      for (const double value : this->Values(this->Type(), 1, offsets ? first : second))
      {
        target.push_back(ToVTKInteger(value, m_Field));
      }
    }
    if (cells.offsets.empty())
    {
      cells.offsets.push_back(0);
    }
    return cells;
  }

  void
  Take(const std::string & name, std::size_t components, std::vector<double> && values)
  {
    if (m_Attributes == Attributes::None || !IsVTKLabelName(name))
    {
      return;
    }
    if (components != 1)
    {
      throw VTKFileError(name, "has " + std::to_string(components) + " components", "give one number a point");
    }
    m_Parts.labels.push_back({ name, std::move(values), m_Attributes == Attributes::Cells });
  }

  std::vector<double>
  Values(const std::string & type, std::size_t components, std::size_t tuples)
  {
    const auto info =
      std::find_if(std::begin(Types), std::end(Types), [&](const TypeInfo & t) { return type == t.name; });
    if (info == std::end(Types))
    {
      this->Fail("is of an unknown type");
    }
    const auto room = static_cast<std::size_t>(m_End - m_Position);
    // A bit takes an eighth of a byte, whatever else at least one.
    if (components > room + 1 || tuples > (8 * room + 8) / std::max<std::size_t>(components, 1))
    {
      this->FailTooMany(components, tuples);
    }
    const std::size_t   count = components * tuples;
    std::vector<double> values;
    if (!m_Binary)
    {
      if (count > room / 2 + 1)
      {
        this->FailTooMany(components, tuples);
      }
      m_Budget.SpendNumbers(count, m_Field);
      values.resize(count);
      for (double & value : values)
      {
        const char * begin = this->SkipSpace();
        while (m_Position < m_End && !IsASCIIBlank(*m_Position))
        {
          ++m_Position;
        }
        if (begin == m_Position)
        {
          this->Fail("ends too early: the file is truncated");
        }
        value = ParseVTKNumber(begin, m_Position, m_Field);
      }
      return values;
    }
    // Binary data begin behind the line.
    while (m_Position < m_End && *m_Position != '\n')
    {
      if (!IsASCIIBlank(*m_Position++))
      {
        this->Fail("has more words in its head than expected");
      }
    }
    m_Position += m_Position < m_End ? 1 : 0;
    const auto        left = static_cast<std::size_t>(m_End - m_Position);
    const std::size_t needed = info->size == 0 ? (count + 7) / 8 : count * info->size;
    if (needed > left)
    {
      this->FailTooMany(components, tuples);
    }
    m_Budget.SpendNumbers(count, m_Field);
    values.resize(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      if (info->size == 0)
      {
        values[i] = static_cast<unsigned char>(m_Position[i / 8]) >> (7 - i % 8) & 1;
        continue;
      }
      std::uint64_t bits = 0;
      for (unsigned int b = 0; b < info->size; ++b)
      {
        bits = bits << 8 | static_cast<unsigned char>(m_Position[i * info->size + b]);
      }
      values[i] = Interpret(bits, *info);
    }
    m_Position += needed;
    return values;
  }

  static double
  Interpret(std::uint64_t bits, const TypeInfo & info)
  {
    if (info.real && info.size == 4)
    {
      const auto low = static_cast<std::uint32_t>(bits);
      float      value = 0.0f;
      std::memcpy(&value, &low, 4);
      return value;
    }
    if (info.real)
    {
      double value = 0.0;
      std::memcpy(&value, &bits, 8);
      return value;
    }
    if (info.isSigned && info.size < 8 && (bits >> (8 * info.size - 1) & 1) != 0)
    {
      bits |= ~std::uint64_t{ 0 } << (8 * info.size);
    }
    return info.isSigned ? static_cast<double>(static_cast<std::int64_t>(bits)) : static_cast<double>(bits);
  }

  /** Strings are no labels: passed over, with their number. */
  std::vector<double>
  Strings(std::size_t components, std::size_t tuples)
  {
    this->Line();
    if (components > 16 || tuples > static_cast<std::size_t>(m_End - m_Position) / std::max<std::size_t>(components, 1))
    {
      this->FailTooMany(components, tuples);
    }
    for (std::size_t i = 0; i < components * tuples; ++i)
    {
      if (!m_Binary)
      {
        this->Line();
        continue;
      }
      // Two bits tell how many bytes the length has.
      std::uint64_t length = 0;
      if (m_Position < m_End)
      {
        const auto        head = static_cast<unsigned char>(*m_Position);
        const std::size_t bytes = std::size_t{ 1 } << (3 - (head >> 6));
        length = head & 0x3fu;
        for (std::size_t b = 1; b < bytes && m_Position + b < m_End; ++b)
        {
          length = length << 8 | static_cast<unsigned char>(m_Position[b]);
        }
        m_Position += std::min<std::size_t>(bytes, static_cast<std::size_t>(m_End - m_Position));
      }
      if (length > static_cast<std::uint64_t>(m_End - m_Position))
      {
        this->Fail("ends too early: the file is truncated");
      }
      m_Position += length;
    }
    return {};
  }

  /** To the next empty line. */
  void
  SkipMetadata()
  {
    this->Line();
    while (m_Position < m_End && this->Line().find_first_not_of(" \t\r") != std::string::npos)
    {}
  }

  const char *
  SkipSpace()
  {
    while (m_Position < m_End && IsASCIIBlank(*m_Position))
    {
      ++m_Position;
    }
    return m_Position;
  }

  /** "" at the end. */
  std::string
  Word()
  {
    const char * begin = this->SkipSpace();
    while (m_Position < m_End && !IsASCIIBlank(*m_Position))
    {
      ++m_Position;
    }
    return std::string(begin, m_Position);
  }

  std::string
  Type()
  {
    return LowerCase(this->Word());
  }

  std::string
  Line()
  {
    const char * begin = m_Position;
    m_Position = std::find(m_Position, m_End, '\n');
    std::string line(begin, std::min<const char *>(m_Position, begin + 1000));
    m_Position += m_Position < m_End ? 1 : 0;
    return line;
  }

  std::size_t
  ToCount(const std::string & text)
  {
    const std::size_t  begin = text.find_first_not_of(" \t\r");
    const std::size_t  end = text.find_last_not_of(" \t\r");
    const char *       data = text.data();
    const std::int64_t count =
      ToVTKInteger(begin == std::string::npos ? -1.0 : ParseVTKNumber(data + begin, data + end + 1, m_Field), m_Field);
    if (count < 0)
    {
      this->Fail("has no count where one should be");
    }
    return static_cast<std::size_t>(count);
  }

  std::size_t
  Count()
  {
    return this->ToCount(this->Word());
  }

  [[noreturn]] void
  Fail(const std::string & problem) const
  {
    throw VTKFileError(m_Field, problem);
  }
  [[noreturn]] void
  FailTooMany(std::size_t components, std::size_t tuples) const
  {
    this->Fail("promises " + std::to_string(tuples) + " x " + std::to_string(components) +
               " values, more than the file holds");
  }

  enum class Attributes
  {
    None,
    Points,
    Cells
  };

  const char *    m_Position;
  const char *    m_End;
  std::string     m_Field;
  bool            m_Binary{ false };
  bool            m_OffsetsAndConnectivity{ false };
  Attributes      m_Attributes{ Attributes::None };
  std::size_t     m_Tuples{ 0 };
  VTKMemoryBudget m_Budget;
  VTKSurfaceParts m_Parts;
};
} // namespace

VTKSurfaceParts
ParseLegacyVTK(const std::string & bytes)
{
  return LegacyParser(bytes).Parse();
}
} // namespace itk

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
#include "itkPLYParser.h"

#include "itkMeshTextParsers.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace itk
{
namespace
{
enum class TypeEnum : uint8_t
{
  None,
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Float32,
  Float64
};

constexpr std::size_t TypeSizes[] = { 0, 1, 1, 2, 2, 4, 4, 4, 8 };

struct PropertyType
{
  std::string name;
  TypeEnum    type{ TypeEnum::None };
  /** None unless it is a list. */
  TypeEnum countType{ TypeEnum::None };

  bool
  IsList() const
  {
    return countType != TypeEnum::None;
  }
};

struct ElementType
{
  std::string               name;
  std::uint64_t             count{ 0 };
  std::vector<PropertyType> properties;
};

enum class EncodingEnum : uint8_t
{
  Text,
  LittleEndian,
  BigEndian
};

TypeEnum
TypeFromName(std::string_view name)
{
  static constexpr struct
  {
    const char * name;
    TypeEnum     type;
  } names[] = { { "char", TypeEnum::Int8 },      { "int8", TypeEnum::Int8 },       { "uchar", TypeEnum::UInt8 },
                { "uint8", TypeEnum::UInt8 },    { "short", TypeEnum::Int16 },     { "int16", TypeEnum::Int16 },
                { "ushort", TypeEnum::UInt16 },  { "uint16", TypeEnum::UInt16 },   { "int", TypeEnum::Int32 },
                { "int32", TypeEnum::Int32 },    { "uint", TypeEnum::UInt32 },     { "uint32", TypeEnum::UInt32 },
                { "float", TypeEnum::Float32 },  { "float32", TypeEnum::Float32 }, { "double", TypeEnum::Float64 },
                { "float64", TypeEnum::Float64 } };
  for (const auto & entry : names)
  {
    if (name == entry.name)
    {
      return entry.type;
    }
  }
  return TypeEnum::None;
}

bool
IsInteger(TypeEnum type)
{
  return type != TypeEnum::None && type != TypeEnum::Float32 && type != TypeEnum::Float64;
}

const char * const CopyAgain = "export or copy the scan again";

std::vector<ElementType>
ParseHeader(MeshTextCursor & cursor, EncodingEnum & encoding)
{
  std::vector<ElementType> elements;
  bool                     hasFormat = false;
  if (cursor.NextWord() != "ply")
  {
    cursor.Fail("does not begin with \"ply\"", CopyAgain);
  }
  cursor.SkipLine();
  for (;;)
  {
    if (!cursor.NextRecord())
    {
      cursor.Fail("the file ends before \"end_header\"", CopyAgain);
    }
    const std::string_view keyword = cursor.NextWordOfLine();
    if (keyword == "end_header")
    {
      break;
    }
    if (keyword == "format")
    {
      const std::string_view name = cursor.NextWordOfLine();
      hasFormat = name == "ascii" || name == "binary_little_endian" || name == "binary_big_endian";
      if (!hasFormat)
      {
        cursor.Fail(QuoteForMessage(name) + " is no PLY format (ascii, binary_little_endian, binary_big_endian)");
      }
      encoding = name == "ascii"                  ? EncodingEnum::Text
                 : name == "binary_little_endian" ? EncodingEnum::LittleEndian
                                                  : EncodingEnum::BigEndian;
    }
    else if (keyword == "element")
    {
      ElementType element;
      element.name = std::string(cursor.NextWordOfLine());
      const std::int64_t count = cursor.ParseInteger(cursor.NextWordOfLine(), "the element's count");
      if (count < 0)
      {
        cursor.Fail("the count " + std::to_string(count) + " is negative");
      }
      element.count = static_cast<std::uint64_t>(count);
      elements.push_back(element);
    }
    else if (keyword == "property")
    {
      if (elements.empty())
      {
        cursor.Fail("a property stands before the first element");
      }
      PropertyType     property;
      std::string_view type = cursor.NextWordOfLine();
      if (type == "list")
      {
        property.countType = TypeFromName(cursor.NextWordOfLine());
        if (!IsInteger(property.countType))
        {
          cursor.Fail("a list is counted by no integer type");
        }
        type = cursor.NextWordOfLine();
      }
      property.type = TypeFromName(type);
      if (property.type == TypeEnum::None)
      {
        cursor.Fail(QuoteForMessage(type) + " is no PLY type");
      }
      property.name = std::string(cursor.NextWordOfLine());
      elements.back().properties.push_back(property);
    }
    else if (keyword != "comment" && keyword != "obj_info")
    {
      cursor.Fail(QuoteForMessage(keyword) + " is no word of a PLY header");
    }
    cursor.SkipLine();
  }
  if (!hasFormat)
  {
    cursor.Fail("the header has no \"format\" line");
  }
  // The bytes of a binary file begin after this line.
  cursor.SkipLine();
  return elements;
}

/** Values one after another from text. */
class TextValues
{
public:
  explicit TextValues(const MeshTextCursor & cursor)
    : m_Cursor(cursor)
  {}

  void
  SetRecord(const std::string &, std::uint64_t)
  {}
  std::uint64_t
  GetSmallestSize(TypeEnum) const
  {
    return 2;
  }
  std::uint64_t
  GetRemaining() const
  {
    // The last value needs no blank after it.
    return m_Cursor.GetRemaining() + 1;
  }
  double
  NextCoordinate(TypeEnum)
  {
    return m_Cursor.ParseNumber(this->NextWord(), "a coordinate");
  }
  std::int64_t
  NextInteger(TypeEnum type, const char * what)
  {
    const std::int64_t value = m_Cursor.ParseInteger(this->NextWord(), what);
    // Negative where the type has no sign: other readers would wrap it.
    if (value < 0 && (type == TypeEnum::UInt8 || type == TypeEnum::UInt16 || type == TypeEnum::UInt32))
    {
      this->Fail(std::string(what) + " is negative: " + std::to_string(value));
    }
    return value;
  }
  void
  Skip(TypeEnum, std::uint64_t count)
  {
    for (std::uint64_t i = 0; i < count; ++i)
    {
      this->NextWord();
    }
  }
  [[noreturn]] void
  Fail(const std::string & problem) const
  {
    m_Cursor.Fail(problem, CopyAgain);
  }
  void
  CheckEnd()
  {
    if (m_Cursor.NextRecord())
    {
      this->Fail("there is more than the header promises");
    }
  }

private:
  std::string_view
  NextWord()
  {
    const std::string_view word = m_Cursor.NextWord();
    if (word.empty())
    {
      this->Fail("the file is truncated: it has fewer values than the header promises");
    }
    return word;
  }

  MeshTextCursor m_Cursor;
};

class BinaryValues
{
public:
  BinaryValues(const char * bytes, std::size_t size, bool bigEndian)
    : m_Position(bytes)
    , m_Remaining(size)
    , m_BigEndian(bigEndian)
  {}

  void
  SetRecord(const std::string & element, std::uint64_t number)
  {
    m_Element = &element;
    m_Number = number;
  }
  std::uint64_t
  GetSmallestSize(TypeEnum type) const
  {
    return TypeSizes[static_cast<std::size_t>(type)];
  }
  std::uint64_t
  GetRemaining() const
  {
    return m_Remaining;
  }
  double
  NextCoordinate(TypeEnum type)
  {
    double value;
    if (type == TypeEnum::Float32)
    {
      const auto bits = static_cast<std::uint32_t>(this->NextBits(4));
      float      single;
      std::memcpy(&single, &bits, 4);
      value = static_cast<double>(single);
    }
    else if (type == TypeEnum::Float64)
    {
      const std::uint64_t bits = this->NextBits(8);
      std::memcpy(&value, &bits, 8);
    }
    else
    {
      return static_cast<double>(this->NextInteger(type, "a coordinate"));
    }
    if (!(std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max())))
    {
      this->Fail(std::isnan(value) ? "a coordinate is not a number" : "a coordinate is infinite in single precision");
    }
    return value;
  }
  std::int64_t
  NextInteger(TypeEnum type, const char * what)
  {
    const std::uint64_t bits = this->NextBits(TypeSizes[static_cast<std::size_t>(type)]);
    switch (type)
    {
      case TypeEnum::Int8:
        return static_cast<std::int8_t>(bits);
      case TypeEnum::Int16:
        return static_cast<std::int16_t>(bits);
      case TypeEnum::Int32:
        return static_cast<std::int32_t>(bits);
      case TypeEnum::UInt8:
      case TypeEnum::UInt16:
      case TypeEnum::UInt32:
        return static_cast<std::int64_t>(bits);
      default:
        this->Fail(std::string(what) + " is of no integer type");
    }
  }
  void
  Skip(TypeEnum type, std::uint64_t count)
  {
    const std::uint64_t size = TypeSizes[static_cast<std::size_t>(type)];
    if (count > m_Remaining / size)
    {
      this->FailTruncated();
    }
    m_Position += count * size;
    m_Remaining -= count * size;
  }
  [[noreturn]] void
  Fail(const std::string & problem) const
  {
    throw SurfaceMeshFileError(
      m_Element == nullptr ? "" : *m_Element + ' ' + std::to_string(m_Number + 1), problem, CopyAgain);
  }
  void
  CheckEnd()
  {
    if (m_Remaining != 0)
    {
      m_Element = nullptr;
      this->Fail("has " + std::to_string(m_Remaining) + " bytes more than the header promises");
    }
  }

private:
  std::uint64_t
  NextBits(std::size_t size)
  {
    if (m_Remaining < size)
    {
      this->FailTruncated();
    }
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < size; ++i)
    {
      const auto byte = static_cast<unsigned char>(m_Position[m_BigEndian ? size - 1 - i : i]);
      bits |= static_cast<std::uint64_t>(byte) << (8 * i);
    }
    m_Position += size;
    m_Remaining -= size;
    return bits;
  }
  [[noreturn]] void
  FailTruncated() const
  {
    this->Fail("the file is truncated: it has fewer bytes than the header promises");
  }

  const char *        m_Position;
  std::uint64_t       m_Remaining;
  bool                m_BigEndian;
  const std::string * m_Element{ nullptr };
  std::uint64_t       m_Number{ 0 };
};

template <typename TValues>
void
SkipProperty(TValues & values, const PropertyType & property)
{
  std::uint64_t count = 1;
  if (property.IsList())
  {
    const std::int64_t length = values.NextInteger(property.countType, "a list's length");
    if (length < 0)
    {
      values.Fail("a list has the length " + std::to_string(length));
    }
    count = static_cast<std::uint64_t>(length);
  }
  values.Skip(property.type, count);
}

template <typename TValues>
void
ParseVertices(TValues & values, const ElementType & element, SurfaceMeshFile & surface)
{
  const std::size_t        none = element.properties.size();
  std::vector<std::size_t> axis(none, 3);
  for (std::size_t d = 0; d < 3; ++d)
  {
    const std::string name(1, "xyz"[d]);
    std::size_t       found = none;
    for (std::size_t p = 0; p < none; ++p)
    {
      if (element.properties[p].name == name && !element.properties[p].IsList())
      {
        found = p;
      }
    }
    if (found == none)
    {
      throw SurfaceMeshFileError("element vertex", "has no property \"" + name + '"', CopyAgain);
    }
    axis[found] = d;
  }
  std::size_t label = none;
  for (const char * name : { "PredictedID", "UniversalID", "Universal_ID" })
  {
    for (std::size_t p = 0; p < none; ++p)
    {
      label = element.properties[p].name == name && !element.properties[p].IsList() ? p : label;
    }
  }
  if (label < none)
  {
    surface.vertexLabelName = element.properties[label].name;
    surface.vertexLabels.resize(element.count);
  }
  surface.doublePoints.resize(element.count);
  for (std::uint64_t v = 0; v < element.count; ++v)
  {
    values.SetRecord(element.name, v);
    for (std::size_t p = 0; p < none; ++p)
    {
      if (axis[p] < 3)
      {
        surface.doublePoints[v][axis[p]] = values.NextCoordinate(element.properties[p].type);
      }
      else if (p == label)
      {
        surface.vertexLabels[v] = values.NextCoordinate(element.properties[p].type);
      }
      else
      {
        SkipProperty(values, element.properties[p]);
      }
    }
  }
}

template <typename TValues>
void
ParseFaces(TValues & values, const ElementType & element, std::uint64_t points, SurfaceMeshFile & surface)
{
  const auto list =
    std::find_if(element.properties.begin(), element.properties.end(), [](const PropertyType & property) {
      return (property.name == "vertex_indices" || property.name == "vertex_index") && property.IsList() &&
             IsInteger(property.type);
    });
  if (list == element.properties.end())
  {
    throw SurfaceMeshFileError("element face", "has no list of integers \"vertex_indices\"", CopyAgain);
  }
  surface.triangles.reserve(element.count);
  surface.numberOfFacesInFile += element.count;
  std::vector<std::uint32_t> corners;
  for (std::uint64_t f = 0; f < element.count; ++f)
  {
    values.SetRecord(element.name, f);
    for (auto property = element.properties.begin(); property != element.properties.end(); ++property)
    {
      if (property != list)
      {
        SkipProperty(values, *property);
        continue;
      }
      const std::int64_t count = values.NextInteger(property->countType, "a face's number of corners");
      if (count < 3)
      {
        values.Fail("a face has " + std::to_string(count) + " corners, at least 3 are needed");
      }
      corners.clear();
      for (std::int64_t c = 0; c < count; ++c)
      {
        const std::int64_t index = values.NextInteger(property->type, "a point's index");
        if (index < 0 || static_cast<std::uint64_t>(index) >= points)
        {
          values.Fail("a face names point " + std::to_string(index) + " of " + std::to_string(points) +
                      " (counted from 0)");
        }
        corners.push_back(static_cast<std::uint32_t>(index));
      }
      AddPolygon(surface, corners.data(), corners.size());
    }
  }
}

template <typename TValues>
SurfaceMeshFile
ParseElements(TValues & values, const std::vector<ElementType> & elements)
{
  const auto isNamed = [](const char * name) { return [name](const ElementType & e) { return e.name == name; }; };
  for (const char * name : { "vertex", "face" })
  {
    const auto found = std::count_if(elements.begin(), elements.end(), isNamed(name));
    if (found != 1)
    {
      const bool strips = std::any_of(elements.begin(), elements.end(), isNamed("tristrips"));
      throw SurfaceMeshFileError("header",
                                 std::string(found == 0 ? "there is no element \"" : "there are several elements \"") +
                                   name + '"',
                                 strips ? "convert the triangle strips to faces" : CopyAgain);
    }
  }
  const std::uint64_t points = std::find_if(elements.begin(), elements.end(), isNamed("vertex"))->count;
  SurfaceMeshFile     surface;
  for (const ElementType & element : elements)
  {
    std::uint64_t smallest = 0;
    for (const PropertyType & property : element.properties)
    {
      smallest += values.GetSmallestSize(property.IsList() ? property.countType : property.type);
    }
    // Nothing is stored of an element without properties.
    if (smallest == 0)
    {
      if (element.count > 0 && (element.name == "vertex" || element.name == "face"))
      {
        throw SurfaceMeshFileError("element " + element.name, "has no properties", CopyAgain);
      }
      continue;
    }
    if (element.count > values.GetRemaining() / smallest || element.count > 0xfffffffeu)
    {
      throw SurfaceMeshFileError("header",
                                 "promises " + std::to_string(element.count) + " records of " +
                                   QuoteForMessage(element.name) + ", more than the file can hold",
                                 CopyAgain);
    }
    if (element.name == "vertex")
    {
      ParseVertices(values, element, surface);
    }
    else if (element.name == "face")
    {
      ParseFaces(values, element, points, surface);
    }
    else
    {
      for (std::uint64_t i = 0; i < element.count; ++i)
      {
        values.SetRecord(element.name, i);
        for (const PropertyType & property : element.properties)
        {
          SkipProperty(values, property);
        }
      }
    }
  }
  values.CheckEnd();
  return surface;
}
} // namespace

SurfaceMeshFile
ParsePLY(const char * bytes, std::size_t size)
{
  MeshTextCursor                 cursor(bytes, size, false);
  EncodingEnum                   encoding{ EncodingEnum::Text };
  const std::vector<ElementType> elements = ParseHeader(cursor, encoding);
  if (encoding == EncodingEnum::Text)
  {
    TextValues values(cursor);
    return ParseElements(values, elements);
  }
  BinaryValues values(cursor.GetPosition(), cursor.GetRemaining(), encoding == EncodingEnum::BigEndian);
  return ParseElements(values, elements);
}
} // namespace itk

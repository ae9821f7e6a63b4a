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

#include <algorithm>
#include <cstring>
#include <exception>
#include <map>
#include <memory>
#include <new>
#include <type_traits>

#include <expat.h>
#include <zlib.h>

namespace itk
{
namespace
{
using AttributesType = std::map<std::string, std::string>;

struct XMLTypeInfo
{
  const char * name;
  unsigned int size;
  bool         real;
  bool         isSigned;
};

constexpr XMLTypeInfo XMLTypes[] = { { "Int8", 1, false, true },   { "UInt8", 1, false, false },
                                     { "Int16", 2, false, true },  { "UInt16", 2, false, false },
                                     { "Int32", 4, false, true },  { "UInt32", 4, false, false },
                                     { "Int64", 8, false, true },  { "UInt64", 8, false, false },
                                     { "Float32", 4, true, true }, { "Float64", 8, true, true } };

/** Compression makes at most a thousandth of constant data. */
constexpr std::size_t LargestRatio = 1100;

/** Bytes of base64 up to its padding or the given number of bytes; `position` moves behind what was read. */
std::string
DecodeBase64(const std::string & text, std::size_t & position, std::size_t largest, const std::string & field)
{
  std::string   bytes;
  std::uint32_t group = 0;
  unsigned int  digits = 0;
  unsigned int  padding = 0;
  while (position < text.size() && bytes.size() < largest)
  {
    const char c = text[position];
    if (IsASCIIBlank(c))
    {
      ++position;
      continue;
    }
    const char *       alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const char * const found = c == '\0' ? nullptr : std::strchr(alphabet, c);
    if (c != '=' && (found == nullptr || padding > 0))
    {
      throw VTKFileError(field, "holds something that is no base64");
    }
    ++position;
    padding += c == '=' ? 1 : 0;
    group = group << 6 | (c == '=' ? 0u : static_cast<std::uint32_t>(found - alphabet));
    if (++digits == 4)
    {
      if (padding > 2)
      {
        throw VTKFileError(field, "holds something that is no base64");
      }
      for (unsigned int b = 0; b + padding < 3; ++b)
      {
        bytes.push_back(static_cast<char>(group >> (16 - 8 * b) & 0xffu));
      }
      digits = 0;
      group = 0;
      if (padding > 0)
      {
        break;
      }
    }
  }
  if (digits != 0)
  {
    throw VTKFileError(field, "ends within a group of base64: the file is truncated");
  }
  return bytes;
}

/** The elements of a surface are some dozens, five within each other. Expat has a hundred bytes for each that is open.
 */
constexpr unsigned int MaximumDepth = 64;
constexpr std::size_t  MaximumNumberOfElements = 100000;

class XMLParser
{
public:
  explicit XMLParser(const std::string & bytes)
    : m_Bytes(bytes)
  {}

  VTKSurfaceParts
  Parse()
  {
    // Appended data need not be XML: expat gets the text before them.
    std::size_t       end = m_Bytes.size();
    std::string       tail;
    const std::size_t appended = m_Bytes.find("<AppendedData");
    if (appended != std::string::npos)
    {
      const std::size_t close = m_Bytes.find('>', appended);
      const std::size_t mark = close == std::string::npos ? close : m_Bytes.find_first_not_of(" \t\r\n", close + 1);
      if (mark == std::string::npos || m_Bytes[mark] != '_')
      {
        throw VTKFileError("AppendedData", "has no \"_\" before its data");
      }
      m_AppendedBegin = mark + 1;
      m_AppendedIsRaw = m_Bytes.substr(appended, close - appended).find("\"raw\"") != std::string::npos;
      end = close + 1;
      tail = "</AppendedData></VTKFile>";
    }
    const std::unique_ptr<std::remove_pointer_t<XML_Parser>, void (*)(XML_Parser)> parser(XML_ParserCreate(nullptr),
                                                                                          XML_ParserFree);
    if (parser == nullptr)
    {
      throw std::bad_alloc();
    }
    m_Parser = parser.get();
    XML_SetUserData(m_Parser, this);
    XML_SetElementHandler(m_Parser, Start, End);
    XML_SetCharacterDataHandler(m_Parser, Text);
    XML_SetStartDoctypeDeclHandler(m_Parser, DocumentType);
    bool                  good = true;
    constexpr std::size_t piece = std::size_t{ 1 } << 20;
    for (std::size_t at = 0; good && at < end; at += piece)
    {
      good = XML_Parse(m_Parser, m_Bytes.data() + at, static_cast<int>(std::min(piece, end - at)), 0) == XML_STATUS_OK;
      // Expat keeps what it has not understood yet, a tag of a hundred million attributes say, and then all of these.
      if (good && static_cast<std::size_t>(XML_GetCurrentByteIndex(m_Parser)) + 4 * piece < at)
      {
        throw VTKFileError("line " + std::to_string(XML_GetCurrentLineNumber(m_Parser)), "holds a tag of megabytes");
      }
    }
    good = good && XML_Parse(m_Parser, tail.data(), static_cast<int>(tail.size()), 1) == XML_STATUS_OK;
    if (m_Error)
    {
      std::rethrow_exception(m_Error);
    }
    if (!good)
    {
      throw VTKFileError("line " + std::to_string(XML_GetCurrentLineNumber(m_Parser)),
                         std::string("is no well-formed XML (") + XML_ErrorString(XML_GetErrorCode(m_Parser)) + ")");
    }
    if (!m_SawPiece)
    {
      throw VTKFileError("VTKFile", "holds no Piece of a PolyData", "write the surface as PolyData (.vtp)");
    }
    return std::move(m_Parts);
  }

private:
  static void XMLCALL
  Start(void * self, const XML_Char * name, const XML_Char ** attributes)
  {
    static_cast<XMLParser *>(self)->Guard([&](XMLParser & p) { p.StartElement(name, attributes); });
  }
  static void XMLCALL
  End(void * self, const XML_Char * name)
  {
    static_cast<XMLParser *>(self)->Guard([&](XMLParser & p) { p.EndElement(name); });
  }
  static void XMLCALL
  DocumentType(void * self, const XML_Char *, const XML_Char *, const XML_Char *, int)
  {
    static_cast<XMLParser *>(self)->Guard(
      [](XMLParser &) { throw VTKFileError("DOCTYPE", "is there, which no VTK file has"); });
  }
  static void XMLCALL
  Text(void * self, const XML_Char * text, int length)
  {
    static_cast<XMLParser *>(self)->Guard([&](XMLParser & p) {
      if (p.m_InArray && p.m_Inner == 0)
      {
        p.m_Text.append(text, static_cast<std::size_t>(length));
      }
    });
  }

  /** No exception may pass through expat. */
  template <typename TFunction>
  void
  Guard(TFunction && function)
  {
    if (m_Error)
    {
      return;
    }
    try
    {
      function(*this);
    }
    catch (...)
    {
      m_Error = std::current_exception();
      XML_StopParser(m_Parser, XML_FALSE);
    }
  }

  void
  StartElement(const std::string & name, const XML_Char ** list)
  {
    if (++m_Depth > MaximumDepth || ++m_Elements > MaximumNumberOfElements)
    {
      throw VTKFileError("line " + std::to_string(XML_GetCurrentLineNumber(m_Parser)),
                         m_Depth > MaximumDepth
                           ? "is nested deeper than " + std::to_string(MaximumDepth) + " elements"
                           : "has more than " + std::to_string(MaximumNumberOfElements) + " elements");
    }
    AttributesType attributes;
    for (; *list != nullptr; list += 2)
    {
      attributes[list[0]] = list[1];
    }
    if (m_InArray)
    {
      // What is known of the array, such as its range.
      ++m_Inner;
    }
    else if (name == "VTKFile")
    {
      if (attributes["type"] != "PolyData")
      {
        throw VTKFileError("VTKFile", "is not of type PolyData", "write the surface as PolyData (.vtp)");
      }
      const std::string & order = attributes["byte_order"];
      if (!order.empty() && order != "BigEndian" && order != "LittleEndian")
      {
        throw VTKFileError("byte_order", "is neither LittleEndian nor BigEndian", "export or copy the file again");
      }
      m_BigEndian = order == "BigEndian";
      m_HeaderSize = attributes["header_type"] == "UInt64" ? 8 : 4;
      m_Compressor = attributes["compressor"];
    }
    else if (name == "Piece")
    {
      m_SawPiece = true;
      m_FirstPoint = m_Parts.points.size();
      m_Points = this->Count(attributes, "NumberOfPoints");
      m_Polygons = this->Count(attributes, "NumberOfPolys");
      m_Strips = this->Count(attributes, "NumberOfStrips");
    }
    else if (name == "PointData" || name == "CellData" || name == "Points" || name == "Polys" || name == "Strips" ||
             name == "Verts" || name == "Lines" || name == "FieldData")
    {
      m_Section = name;
      m_Cells = {};
      m_Cells.offsets.clear();
    }
    else if (name == "DataArray" || name == "Array")
    {
      m_InArray = true;
      m_Array = std::move(attributes);
      m_Text.clear();
    }
  }

  void
  EndElement(const std::string & name)
  {
    --m_Depth;
    if (m_Inner > 0)
    {
      --m_Inner;
    }
    else if (name == "DataArray" || name == "Array")
    {
      m_InArray = false;
      if (m_SawPiece && name == "DataArray")
      {
        this->TakeArray();
      }
    }
    else if (name == "Polys" || name == "Strips")
    {
      this->TakeCells(name == "Polys" ? m_Parts.polygons : m_Parts.strips);
    }
    if (name == m_Section)
    {
      m_Section.clear();
    }
  }

  void
  TakeArray()
  {
    const std::string & name = m_Array["Name"];
    const bool          ofPoints = m_Section == "PointData";
    m_Field = m_Section + (name.empty() ? "" : "." + name);
    if (m_Section == "Points")
    {
      const std::string & components = m_Array["NumberOfComponents"];
      if (!components.empty() && components != "3")
      {
        throw VTKFileError(m_Field, "has " + components.substr(0, 20) + " components", "give three numbers a point");
      }
      const std::vector<double> values = this->Values(3 * m_Points, true);
      for (std::size_t i = 0; i < m_Points; ++i)
      {
        m_Parts.points.push_back({ { values[3 * i], values[3 * i + 1], values[3 * i + 2] } });
      }
    }
    else if ((m_Section == "Polys" || m_Section == "Strips") && (name == "offsets" || name == "connectivity"))
    {
      const bool                offsets = name == "offsets";
      const std::vector<double> values = this->Values(m_Section == "Polys" ? m_Polygons : m_Strips, offsets);
      auto &                    target = offsets ? m_Cells.offsets : m_Cells.connectivity;
      target.clear();
      for (const double value : values)
      {
        target.push_back(ToVTKInteger(value, m_Field));
      }
    }
    else if ((ofPoints || m_Section == "CellData") && IsVTKLabelName(name))
    {
      const std::string & components = m_Array["NumberOfComponents"];
      if (!components.empty() && components != "1")
      {
        throw VTKFileError(m_Field, "has " + components.substr(0, 20) + " components", "give one number a point");
      }
      // The number of cells matters to nobody.
      std::vector<double> values = ofPoints ? this->Values(m_Points, true) : std::vector<double>();
      auto                found = std::find_if(m_Parts.labels.begin(), m_Parts.labels.end(), [&](const auto & labels) {
        return labels.name == name && labels.ofCells != ofPoints;
      });
      if (found == m_Parts.labels.end())
      {
        m_Parts.labels.push_back({ name, {}, !ofPoints });
        found = m_Parts.labels.end() - 1;
      }
      found->values.insert(found->values.end(), values.begin(), values.end());
    }
  }

  /** Ends of the cells as offsets behind those of earlier pieces. */
  void
  TakeCells(VTKSurfaceParts::CellsType & cells)
  {
    const auto base = static_cast<std::int64_t>(cells.connectivity.size());
    const auto first = static_cast<std::int64_t>(m_FirstPoint);
    const auto last = static_cast<std::int64_t>(m_FirstPoint + m_Points);
    for (const std::int64_t end : m_Cells.offsets)
    {
      cells.offsets.push_back(base + end);
    }
    for (const std::int64_t id : m_Cells.connectivity)
    {
      // A piece counts its own points.
      cells.connectivity.push_back(id >= 0 && id < last - first ? id + first : -1);
    }
    m_Cells.offsets.clear();
    m_Cells.connectivity.clear();
  }

  std::size_t
  Count(const AttributesType & attributes, const char * name)
  {
    const auto found = attributes.find(name);
    if (found == attributes.end())
    {
      return 0;
    }
    const char *       text = found->second.c_str();
    const std::int64_t count = ToVTKInteger(ParseVTKNumber(text, text + found->second.size(), name), name);
    if (count < 0 || static_cast<std::size_t>(count) > m_Bytes.size() * LargestRatio)
    {
      throw VTKFileError(name, "promises " + found->second.substr(0, 30) + ", which the file cannot hold");
    }
    return static_cast<std::size_t>(count);
  }

  /** The array's numbers: `count` of them where that is known. */
  std::vector<double>
  Values(std::size_t count, bool countIsKnown)
  {
    const std::string & typeName = m_Array["type"];
    const auto          type =
      std::find_if(std::begin(XMLTypes), std::end(XMLTypes), [&](const XMLTypeInfo & t) { return typeName == t.name; });
    if (type == std::end(XMLTypes))
    {
      throw VTKFileError(m_Field, "is of an unknown type");
    }
    const std::string & format = m_Array["format"];
    std::vector<double> values;
    if (format == "ascii")
    {
      const char *       at = m_Text.data();
      const char * const end = at + m_Text.size();
      // A word begins behind a blank.
      std::size_t words = 0;
      bool        isBlank = true;
      for (const char letter : m_Text)
      {
        words += isBlank && !IsASCIIBlank(letter) ? 1 : 0;
        isBlank = IsASCIIBlank(letter);
      }
      m_Budget.SpendNumbers(words, m_Field);
      values.reserve(words);
      while ((at = std::find_if_not(at, end, IsASCIIBlank)) != end)
      {
        const char * const stop = std::find_if(at, end, IsASCIIBlank);
        values.push_back(ParseVTKNumber(at, stop, m_Field));
        at = stop;
      }
    }
    else
    {
      const std::string bytes = this->Bytes(format, type->size);
      values.resize(bytes.size() / type->size);
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        values[i] = this->Interpret(bytes.data() + i * type->size, *type);
      }
    }
    if (countIsKnown && values.size() != count)
    {
      throw VTKFileError(
        m_Field, "has " + std::to_string(values.size()) + " values, " + std::to_string(count) + " are expected");
    }
    return values;
  }

  /** Of numbers of so many bytes each. */
  std::string
  Bytes(const std::string & format, std::size_t size)
  {
    if (format == "binary")
    {
      return this->Unpack(size, [this, at = std::size_t{ 0 }](std::size_t count, bool whole) mutable {
        return this->NextBase64(m_Text, at, count, whole);
      });
    }
    if (format != "appended" || m_AppendedBegin == 0)
    {
      throw VTKFileError(m_Field, "has a format that is neither ascii, binary nor appended");
    }
    const std::size_t offset = this->Count(m_Array, "offset");
    if (offset > m_Bytes.size() - m_AppendedBegin)
    {
      throw VTKFileError(m_Field, "begins behind the end of the file: it is truncated");
    }
    std::size_t at = m_AppendedBegin + offset;
    if (m_AppendedIsRaw)
    {
      return this->Unpack(size, [this, at](std::size_t count, bool) mutable {
        if (count > m_Bytes.size() - at)
        {
          throw VTKFileError(m_Field, "ends behind the end of the file: it is truncated");
        }
        at += count;
        return m_Bytes.substr(at - count, count);
      });
    }
    return this->Unpack(
      size, [this, at](std::size_t count, bool whole) mutable { return this->NextBase64(m_Bytes, at, count, whole); });
  }

  /** The next `count` bytes; where `whole`, what follows begins a new group of base64. */
  std::string
  NextBase64(const std::string & text, std::size_t & at, std::size_t count, bool whole)
  {
    if (count / 4 > text.size() / 4)
    {
      throw VTKFileError(m_Field, "promises more than the file holds");
    }
    std::string bytes = std::move(m_Rest);
    m_Rest.clear();
    if (bytes.size() < count)
    {
      bytes += DecodeBase64(text, at, count - bytes.size(), m_Field);
    }
    if (bytes.size() < count)
    {
      throw VTKFileError(m_Field, "ends too early: the file is truncated");
    }
    if (!whole)
    {
      m_Rest = bytes.substr(count);
    }
    bytes.resize(count);
    return bytes;
  }

  /** Plain: length, data. Compressed: number of blocks, size of a block, size of the last one, compressed sizes;
   * blocks. */
  template <typename TNext>
  std::string
  Unpack(std::size_t sizeOfNumber, TNext && nextBytes)
  {
    const auto next = [&](std::size_t count, bool whole) {
      // Each byte belongs to one array. Were it not so, a thousand pieces could read the same appended data, each time
      // into memory of its own, or for ever.
      m_Claimed += count;
      if (m_Claimed > m_Bytes.size())
      {
        throw VTKFileError(m_Field, "and what stands before it name more bytes than the file has");
      }
      return nextBytes(count, whole);
    };
    m_Rest.clear();
    const std::size_t largest = m_Bytes.size() * LargestRatio;
    if (m_Compressor.empty())
    {
      const std::string head = next(m_HeaderSize, false);
      const std::size_t length = this->Header(head, 0, m_Bytes.size());
      m_Budget.SpendNumbers(length / sizeOfNumber, m_Field);
      return next(length, true);
    }
    if (m_Compressor != "vtkZLibDataCompressor")
    {
      throw VTKFileError(
        "compressor", "is " + m_Compressor.substr(0, 40), "write the file with zlib or without compression");
    }
    std::string       head = next(m_HeaderSize, false);
    const std::size_t blocks = this->Header(head, 0, m_Bytes.size());
    head += next((2 + blocks) * m_HeaderSize, true);
    const std::size_t size = this->Header(head, 1, largest);
    const std::size_t partial = this->Header(head, 2, largest);
    if (blocks > 0 && size > largest / blocks)
    {
      throw VTKFileError(m_Field, "promises more than the file can hold");
    }
    std::size_t compressed = 0;
    for (std::size_t b = 0; b < blocks; ++b)
    {
      compressed += this->Header(head, 3 + b, m_Bytes.size());
    }
    const std::string packed = next(compressed, true);
    std::string       bytes;
    std::size_t       at = 0;
    for (std::size_t b = 0; b < blocks; ++b)
    {
      const std::size_t in = this->Header(head, 3 + b, m_Bytes.size());
      const std::size_t out = b + 1 == blocks && partial > 0 ? partial : size;
      const std::size_t before = bytes.size();
      if (out > LargestRatio * (in + 64))
      {
        throw VTKFileError(m_Field, "promises more than the file can hold");
      }
      m_Budget.SpendNumbers(out / sizeOfNumber + 1, m_Field);
      bytes.resize(before + out);
      auto length = static_cast<uLongf>(out);
      if (uncompress(reinterpret_cast<Bytef *>(&bytes[before]),
                     &length,
                     reinterpret_cast<const Bytef *>(packed.data() + at),
                     static_cast<uLong>(in)) != Z_OK ||
          length != out)
      {
        throw VTKFileError(m_Field, "cannot be decompressed");
      }
      at += in;
    }
    return bytes;
  }

  std::size_t
  Header(const std::string & head, std::size_t index, std::size_t largest) const
  {
    const XMLTypeInfo type{ "", static_cast<unsigned int>(m_HeaderSize), false, false };
    const std::size_t value = this->Bits(head.data() + index * m_HeaderSize, type.size);
    if (value > largest)
    {
      throw VTKFileError(m_Field, "promises " + std::to_string(value) + " bytes, which the file cannot hold");
    }
    return value;
  }

  std::uint64_t
  Bits(const char * bytes, unsigned int size) const
  {
    std::uint64_t bits = 0;
    for (unsigned int b = 0; b < size; ++b)
    {
      bits = bits << 8 | static_cast<unsigned char>(bytes[m_BigEndian ? b : size - 1 - b]);
    }
    return bits;
  }

  double
  Interpret(const char * bytes, const XMLTypeInfo & type) const
  {
    std::uint64_t bits = this->Bits(bytes, type.size);
    if (type.real && type.size == 4)
    {
      const auto low = static_cast<std::uint32_t>(bits);
      float      value = 0.0f;
      std::memcpy(&value, &low, 4);
      return value;
    }
    if (type.real)
    {
      double value = 0.0;
      std::memcpy(&value, &bits, 8);
      return value;
    }
    if (type.isSigned && type.size < 8 && (bits >> (8 * type.size - 1) & 1) != 0)
    {
      bits |= ~std::uint64_t{ 0 } << (8 * type.size);
    }
    return type.isSigned ? static_cast<double>(static_cast<std::int64_t>(bits)) : static_cast<double>(bits);
  }

  const std::string & m_Bytes;
  XML_Parser          m_Parser{ nullptr };
  std::exception_ptr  m_Error;
  std::size_t         m_AppendedBegin{ 0 };
  bool                m_AppendedIsRaw{ false };
  bool                m_BigEndian{ false };
  std::size_t         m_HeaderSize{ 4 };
  std::string         m_Compressor;

  bool                       m_SawPiece{ false };
  std::size_t                m_FirstPoint{ 0 };
  std::size_t                m_Points{ 0 };
  std::size_t                m_Polygons{ 0 };
  std::size_t                m_Strips{ 0 };
  std::string                m_Section;
  VTKSurfaceParts::CellsType m_Cells;
  bool                       m_InArray{ false };
  unsigned int               m_Inner{ 0 };
  unsigned int               m_Depth{ 0 };
  std::size_t                m_Elements{ 0 };
  AttributesType             m_Array;
  std::string                m_Text;
  std::string                m_Field;
  /** Decoded bytes that were not asked for yet. */
  std::string m_Rest;
  /** Of the file, by arrays so far. */
  std::size_t     m_Claimed{ 0 };
  VTKMemoryBudget m_Budget;
  VTKSurfaceParts m_Parts;
};
} // namespace

VTKSurfaceParts
ParseXMLVTK(const std::string & bytes)
{
  return XMLParser(bytes).Parse();
}
} // namespace itk

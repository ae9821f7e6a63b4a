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
#include "itkDicomFileCheck.h"

#include "itkASCIICharacter.h"
#include "itkDentalInputError.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string_view>

namespace itk
{
namespace
{
constexpr uint32_t UndefinedLength = 0xffffffffu;
constexpr uint32_t Item = 0xfffee000u;
constexpr uint32_t ItemEnd = 0xfffee00du;
constexpr uint32_t SequenceEnd = 0xfffee0ddu;
constexpr uint32_t PixelData = 0x7fe00010u;

/** What is wrong, for the caller to put a file name to. */
struct Defect
{
  std::string field;
  std::string problem;
};

std::string
TagText(uint32_t tag)
{
  char text[16];
  std::snprintf(text, sizeof(text), "(%04x,%04x)", tag >> 16, tag & 0xffffu);
  return text;
}

struct Element
{
  uint32_t    tag{ 0 };
  std::string vr;
  uint32_t    length{ 0 };
  std::size_t value{ 0 };
};

class Walker
{
public:
  explicit Walker(std::string_view bytes)
    : m_Bytes(bytes)
  {}

  void
  Walk()
  {
    std::size_t position = m_Bytes.size() >= 132 && std::memcmp(m_Bytes.data() + 128, "DICM", 4) == 0 ? 132 : 0;
    // The meta group is explicit whatever follows it.
    while (position + 4 <= m_Bytes.size() && this->Number(position, 2) == 2)
    {
      const Element element = this->ReadElement(position, true);
      this->RequireDefined(element);
      m_Meta[element.tag] = this->Value(element);
      position = element.value + element.length;
    }
    const bool isExplicit = this->CheckTransferSyntax(position);
    uint32_t   before = 0;
    while (position < m_Bytes.size())
    {
      const Element element = this->ReadElement(position, isExplicit);
      if (element.tag <= before)
      {
        throw Defect{ TagText(element.tag), "does not come after " + TagText(before) };
      }
      before = element.tag;
      position = this->Skip(element, isExplicit, 0);
      if (element.length != UndefinedLength && element.length <= 64)
      {
        m_Values[element.tag] = this->Value(element);
      }
      if (element.tag == PixelData)
      {
        this->CheckPixels(element);
        return;
      }
    }
    throw Defect{ TagText(PixelData), "no pixel data: the file is truncated, or no image" };
  }

private:
  uint64_t
  Number(std::size_t position, unsigned int count) const
  {
    if (position + count > m_Bytes.size())
    {
      throw Defect{ "", "truncated at " + std::to_string(m_Bytes.size()) + " bytes" };
    }
    uint64_t value = 0;
    for (unsigned int i = 0; i < count; ++i)
    {
      value |= uint64_t{ static_cast<unsigned char>(m_Bytes[position + i]) } << (8 * i);
    }
    return value;
  }

  uint32_t
  Tag(std::size_t position) const
  {
    return static_cast<uint32_t>((this->Number(position, 2) << 16) | this->Number(position + 2, 2));
  }

  std::string
  Value(const Element & element) const
  {
    return std::string(m_Bytes.data() + element.value, element.length);
  }

  /** Without the padding. */
  static std::string
  Text(const std::map<uint32_t, std::string> & values, uint32_t tag)
  {
    const auto  found = values.find(tag);
    std::string value = found == values.end() ? std::string() : found->second;
    while (!value.empty() && (value.back() == '\0' || value.back() == ' '))
    {
      value.pop_back();
    }
    return value;
  }

  void
  RequireDefined(const Element & element) const
  {
    if (element.length == UndefinedLength)
    {
      throw Defect{ TagText(element.tag), "has no length" };
    }
  }

  Element
  ReadElement(std::size_t position, bool isExplicit) const
  {
    Element element;
    element.tag = this->Tag(position);
    if (!isExplicit)
    {
      element.length = static_cast<uint32_t>(this->Number(position + 4, 4));
      element.value = position + 8;
    }
    else
    {
      static const char * const shortVRs[] = { "AE", "AS", "AT", "CS", "DA", "DS", "DT", "FL", "FD", "IS", "LO",
                                               "LT", "PN", "SH", "SL", "SS", "ST", "TM", "UI", "UL", "US" };
      static const char * const longVRs[] = { "OB", "OD", "OF", "OL", "OV", "OW", "SQ",
                                              "SV", "UC", "UN", "UR", "UT", "UV" };
      this->Number(position + 4, 2);
      element.vr = std::string(m_Bytes.data() + position + 4, 2);
      const auto isOneOf = [&element](const auto & list) {
        return std::any_of(std::begin(list), std::end(list), [&](const char * vr) { return element.vr == vr; });
      };
      if (isOneOf(shortVRs))
      {
        element.length = static_cast<uint32_t>(this->Number(position + 6, 2));
        element.value = position + 8;
      }
      else if (isOneOf(longVRs))
      {
        element.length = static_cast<uint32_t>(this->Number(position + 8, 4));
        element.value = position + 12;
      }
      else
      {
        throw Defect{ TagText(element.tag), "has no known value representation" };
      }
    }
    if (element.length != UndefinedLength && element.length > m_Bytes.size() - element.value)
    {
      throw Defect{ TagText(element.tag),
                    "is of " + std::to_string(element.length) + " bytes, of which " +
                      std::to_string(m_Bytes.size() - element.value) + " are there" };
    }
    return element;
  }

  /** Position after the element; what is inside it is walked too. */
  std::size_t
  Skip(const Element & element, bool isExplicit, unsigned int depth) const
  {
    if (depth > 16)
    {
      throw Defect{ TagText(element.tag), "is nested too deep" };
    }
    if (element.vr == "SQ" || (element.length == UndefinedLength && element.tag != PixelData))
    {
      // Of unknown type and undefined length is what was implicit before.
      return this->SkipItems(element, isExplicit && element.vr != "UN", depth);
    }
    if (element.length == UndefinedLength)
    {
      return this->SkipFragments(element);
    }
    return element.value + element.length;
  }

  std::size_t
  SkipItems(const Element & sequence, bool isExplicit, unsigned int depth) const
  {
    const bool        defined = sequence.length != UndefinedLength;
    const std::size_t end = defined ? sequence.value + sequence.length : m_Bytes.size();
    std::size_t       position = sequence.value;
    while (!defined || position < end)
    {
      const uint32_t tag = this->Tag(position);
      const auto     length = static_cast<uint32_t>(this->Number(position + 4, 4));
      position += 8;
      if (tag == SequenceEnd && !defined)
      {
        return position;
      }
      if (tag != Item)
      {
        throw Defect{ TagText(sequence.tag), "holds something that is no item" };
      }
      const bool itemDefined = length != UndefinedLength;
      if (itemDefined && length > end - position)
      {
        throw Defect{ TagText(sequence.tag), "has an item longer than itself" };
      }
      const std::size_t itemEnd = itemDefined ? position + length : end;
      while (!itemDefined || position < itemEnd)
      {
        if (this->Tag(position) == ItemEnd && !itemDefined)
        {
          position += 8;
          break;
        }
        const Element element = this->ReadElement(position, isExplicit);
        position = this->Skip(element, isExplicit, depth + 1);
      }
      if (itemDefined && position != itemEnd)
      {
        throw Defect{ TagText(sequence.tag), "has an item of a wrong length" };
      }
    }
    if (position != end)
    {
      throw Defect{ TagText(sequence.tag), "is of a wrong length" };
    }
    return position;
  }

  std::size_t
  SkipFragments(const Element & pixels) const
  {
    std::size_t position = pixels.value;
    for (;;)
    {
      const uint32_t tag = this->Tag(position);
      const auto     length = static_cast<uint32_t>(this->Number(position + 4, 4));
      position += 8;
      if (tag == SequenceEnd)
      {
        return position;
      }
      if (tag != Item || length > m_Bytes.size() - position)
      {
        throw Defect{ TagText(pixels.tag), "the compressed pixels are truncated" };
      }
      position += length;
    }
  }

  /** Whether the data set has explicit VRs. */
  bool
  CheckTransferSyntax(std::size_t position) const
  {
    const std::string syntax = Text(m_Meta, 0x00020010u);
    if (syntax.empty())
    {
      return position + 6 <= m_Bytes.size() && IsASCIIUpperCase(static_cast<char>(m_Bytes[position + 4])) &&
             IsASCIIUpperCase(static_cast<char>(m_Bytes[position + 5]));
    }
    if (syntax == "1.2.840.10008.1.2")
    {
      return false;
    }
    for (const char * known : { "1.2.840.10008.1.2.1",
                                "1.2.840.10008.1.2.4.50",
                                "1.2.840.10008.1.2.4.51",
                                "1.2.840.10008.1.2.4.57",
                                "1.2.840.10008.1.2.4.70",
                                "1.2.840.10008.1.2.4.80",
                                "1.2.840.10008.1.2.4.81",
                                "1.2.840.10008.1.2.4.90",
                                "1.2.840.10008.1.2.4.91",
                                "1.2.840.10008.1.2.5" })
    {
      if (syntax == known)
      {
        return true;
      }
    }
    throw Defect{ "TransferSyntaxUID (0002,0010)", "\"" + syntax.substr(0, 64) + "\" is not read" };
  }

  uint64_t
  GetNumber(uint32_t tag, uint64_t fallback) const
  {
    const auto found = m_Values.find(tag);
    if (found == m_Values.end() || found->second.size() < 2)
    {
      return fallback;
    }
    return static_cast<unsigned char>(found->second[0]) |
           (uint64_t{ static_cast<unsigned char>(found->second[1]) } << 8);
  }

  void
  CheckPixels(const Element & pixels) const
  {
    const auto require = [](bool holds, uint32_t tag, const std::string & problem) {
      if (!holds)
      {
        throw Defect{ TagText(tag), problem };
      }
    };
    const uint64_t samples = this->GetNumber(0x00280002u, 1);
    const uint64_t rows = this->GetNumber(0x00280010u, 0);
    const uint64_t columns = this->GetNumber(0x00280011u, 0);
    const uint64_t allocated = this->GetNumber(0x00280100u, 0);
    const uint64_t stored = this->GetNumber(0x00280101u, allocated);
    const uint64_t highBit = this->GetNumber(0x00280102u, stored - 1);
    require(rows > 0, 0x00280010u, "no rows");
    require(columns > 0, 0x00280011u, "no columns");
    require(samples == 1 || samples == 3, 0x00280002u, std::to_string(samples) + " samples a pixel are not read");
    require(allocated == 8 || allocated == 16 || allocated == 32,
            0x00280100u,
            std::to_string(allocated) + " bits a sample are not read" +
              (allocated == 1 ? ": a DICOM segmentation is to be exported as a label map (NRRD, NIfTI, PNG)" : ""));
    require(stored >= 1 && stored <= allocated, 0x00280101u, "more bits stored than allocated");
    require(highBit + 1 >= stored && highBit < allocated, 0x00280102u, "is no high bit of the bits stored");
    require(this->GetNumber(0x00280103u, 0) <= 1, 0x00280103u, "is no pixel representation");
    require(this->GetNumber(0x00280006u, 0) <= 1, 0x00280006u, "is no planar configuration");

    const std::string photometric = Text(m_Values, 0x00280004u);
    bool              known = false;
    for (const char * name : { "MONOCHROME1", "MONOCHROME2", "PALETTE COLOR" })
    {
      known = known || (samples == 1 && photometric == name);
    }
    for (const char * name : { "RGB", "YBR_FULL", "YBR_FULL_422", "YBR_RCT", "YBR_ICT" })
    {
      known = known || (samples == 3 && photometric == name);
    }
    require(known, 0x00280004u, "\"" + photometric.substr(0, 40) + "\" is not read");

    uint64_t          frames = 1;
    const std::string frameText = Text(m_Values, 0x00280008u);
    if (!frameText.empty())
    {
      try
      {
        frames = std::stoul(frameText);
      }
      catch (const std::logic_error &)
      {
        frames = 0;
      }
      require(frames >= 1 && frames <= 1000000, 0x00280008u, "is no number of frames");
    }
    if (pixels.length != UndefinedLength)
    {
      const uint64_t expected = rows * columns * samples * (allocated / 8) * frames;
      require(pixels.length >= expected,
              PixelData,
              std::to_string(pixels.length) + " bytes of pixels, of which " + std::to_string(expected) + " are needed");
    }
  }

  std::string_view                m_Bytes;
  std::map<uint32_t, std::string> m_Meta;
  std::map<uint32_t, std::string> m_Values;
};
} // namespace

void
VerifyDicomFile(const std::string & fileName, std::string_view bytes)
{
  try
  {
    Walker(bytes).Walk();
  }
  catch (const Defect & defect)
  {
    itkDentalInputErrorMacro(
      fileName, defect.field, "damaged or unsupported DICOM: " + defect.problem, "export it again, uncompressed");
  }
}
} // namespace itk

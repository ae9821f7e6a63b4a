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
#ifndef itkDicomTestFile_h
#define itkDicomTestFile_h

#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <utility>

namespace itk
{
/** A DICOM file in explicit VR little endian, written byte by byte: 8 columns, 10 rows, 12 of 16 bits, a ramp whose
 * pixel (column, row) is 10 column + 100 row. Elements are set by tag; an empty value leaves the element out. */
class DicomTestFile
{
public:
  static constexpr unsigned int Columns = 8;
  static constexpr unsigned int Rows = 10;
  static constexpr const char * DX = "1.2.840.10008.5.1.4.1.1.1.1";
  static constexpr const char * CR = "1.2.840.10008.5.1.4.1.1.1";
  static constexpr const char * SC = "1.2.840.10008.5.1.4.1.1.7";

  explicit DicomTestFile(const std::string & sopClass = DX, const std::string & modality = "DX")
    : m_SOPClass(sopClass)
  {
    this->Set(0x0008, 0x0016, "UI", sopClass);
    this->Set(0x0008, 0x0018, "UI", "1.2.3.4.5");
    this->Set(0x0008, 0x0060, "CS", modality);
    this->Set(0x0010, 0x0010, "PN", "Test^Patient");
    this->Set(0x0020, 0x000d, "UI", "1.2.3.4");
    this->Set(0x0020, 0x000e, "UI", "1.2.3.4.6");
    this->SetNumber(0x0028, 0x0002, 1);
    this->Set(0x0028, 0x0004, "CS", "MONOCHROME2");
    this->SetNumber(0x0028, 0x0010, Rows);
    this->SetNumber(0x0028, 0x0011, Columns);
    this->SetNumber(0x0028, 0x0100, 16);
    this->SetNumber(0x0028, 0x0101, 12);
    this->SetNumber(0x0028, 0x0102, 11);
    this->SetNumber(0x0028, 0x0103, 0);
    this->SetFrames(1);
  }

  DicomTestFile &
  Set(uint16_t group, uint16_t element, const std::string & vr, const std::string & value)
  {
    m_Elements[{ group, element }] = { vr, value };
    return *this;
  }

  DicomTestFile &
  SetNumber(uint16_t group, uint16_t element, uint16_t value)
  {
    return this->Set(group, element, "US", LittleEndian(value, 2));
  }

  /** Pixel data of so many frames; (0028,0008) is the caller's. */
  DicomTestFile &
  SetFrames(unsigned int frames)
  {
    std::string pixels;
    for (unsigned int frame = 0; frame < frames; ++frame)
    {
      for (unsigned int row = 0; row < Rows; ++row)
      {
        for (unsigned int column = 0; column < Columns; ++column)
        {
          pixels += LittleEndian(10 * column + 100 * row, 2);
        }
      }
    }
    return this->Set(0x7fe0, 0x0010, "OW", pixels);
  }

  DicomTestFile &
  SetImagerPixelSpacing(const std::string & value)
  {
    return this->Set(0x0018, 0x1164, "DS", value);
  }
  DicomTestFile &
  SetPixelSpacing(const std::string & value)
  {
    return this->Set(0x0028, 0x0030, "DS", value);
  }
  DicomTestFile &
  SetMagnificationFactor(const std::string & value)
  {
    return this->Set(0x0018, 0x1114, "DS", value);
  }
  DicomTestFile &
  SetSourceToDetector(const std::string & value)
  {
    return this->Set(0x0018, 0x1110, "DS", value);
  }

  std::string
  GetBytes(bool preamble = true) const
  {
    std::string meta = Element(0x0002, 0x0001, "OB", std::string("\0\1", 2));
    meta += Element(0x0002, 0x0002, "UI", m_SOPClass);
    meta += Element(0x0002, 0x0003, "UI", "1.2.3.4.5");
    meta += Element(0x0002, 0x0010, "UI", "1.2.840.10008.1.2.1");
    meta += Element(0x0002, 0x0012, "UI", "1.2.3.4.7");
    std::string bytes = preamble ? std::string(128, '\0') + "DICM" : std::string();
    bytes += Element(0x0002, 0x0000, "UL", LittleEndian(static_cast<uint32_t>(meta.size()), 4)) + meta;
    for (const auto & [tag, element] : m_Elements)
    {
      if (!element.second.empty())
      {
        bytes += Element(tag.first, tag.second, element.first, element.second);
      }
    }
    return bytes;
  }

private:
  static std::string
  LittleEndian(uint32_t value, unsigned int count)
  {
    std::string bytes;
    for (unsigned int i = 0; i < count; ++i)
    {
      bytes += static_cast<char>((value >> (8 * i)) & 255u);
    }
    return bytes;
  }

  static std::string
  Element(uint16_t group, uint16_t element, const std::string & vr, std::string value)
  {
    if (value.size() % 2 != 0)
    {
      value += vr == "UI" || vr == "OB" ? '\0' : ' ';
    }
    const auto  length = static_cast<uint32_t>(value.size());
    std::string bytes = LittleEndian(group, 2) + LittleEndian(element, 2) + vr;
    bytes +=
      vr == "OB" || vr == "OW" || vr == "SQ" ? LittleEndian(0, 2) + LittleEndian(length, 4) : LittleEndian(length, 2);
    return bytes + value;
  }

  std::string                                                                  m_SOPClass;
  std::map<std::pair<uint16_t, uint16_t>, std::pair<std::string, std::string>> m_Elements;
};
} // namespace itk

#endif

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
#ifndef itkToothCode_h
#define itkToothCode_h

#include "DentalContourExport.h"

#include <cstdint>
#include <ostream>
#include <string>

namespace itk
{
/** \class ToothCode
 * \brief One tooth, kept as its FDI number (ISO 3950), or unknown.
 *
 * Permanent teeth: FDI UR = 11..18, UL = 21..28, LL = 31..38, LR = 41..48; universal 1..16 = UR8..UR1, UL1..UL8, 17..32
 * = LL8..LL1, LR1..LR8. Primary teeth: FDI 51..55, 61..65, 71..75, 81..85 in the same quadrants, named URA..URE and so
 * on; universal A..J = URE..URA, ULA..ULE, K..T = LLE..LLA, LRA..LRE.
 *
 * People spell codes in many ways. FromString() and JawFromString() are the one place that knows them
 * (Documentation/FileFormats.md has the table); what is not in it is no code, whatever it looks like.
 *
 * \ingroup DentalContour
 */
class DentalContour_EXPORT ToothCode
{
public:
  /** How a written code is to be read. */
  enum class NumberingEnum : uint8_t
  {
    /** UR1 ... LR8, the paper's. */
    Quadrant,
    FDI,
    Universal
  };
  enum class JawEnum : uint8_t
  {
    Upper,
    Lower,
    Unknown
  };
  /** The strata of the paper's tables. */
  enum class GroupEnum : uint8_t
  {
    IncisorsAndCanines,
    Premolars,
    Molars,
    Unknown
  };

  /** An unknown tooth. */
  ToothCode() = default;

  /** Throws std::invalid_argument where FDI has no such tooth; 0 is the unknown tooth. */
  explicit ToothCode(unsigned int fdi);

  /** Reads a code. "" is the unknown tooth. "UR1" and "URA" are read under every numbering, digits as the numbering
   * says and as FDI under Quadrant, the letters A to T under Universal alone. Case and blanks around it do not matter;
   * "UR-1", "1.1" (FDI), "#11", "tooth 11" and "FDI 11" are read too. Throws std::invalid_argument that names the text
   * and what was expected. */
  static ToothCode
  FromString(const std::string & text, NumberingEnum numbering = NumberingEnum::Quadrant);

  /** Whether a text has the form of a code, even where there is no such tooth ("19", "UR9"): it was meant as one, while
   * "soft tissue" was not. */
  static bool
  IsWrittenAsCode(const std::string & text);

  /** Reads a code that does not say its side, such as U1 or L6, spelled as freely as those of FromString(): the tooth
   * of the right side, or unknown where the text is none. */
  static ToothCode
  FromSidelessString(const std::string & text);

  /** "upper", "Maxilla", "lower jaw", "mandible", ...: the jaw, or Unknown where the text names none. */
  static JawEnum
  JawFromString(const std::string & text);

  /** "UR", "FDI" or "universal", as in a case file. Throws std::invalid_argument otherwise. */
  static NumberingEnum
  NumberingFromString(const std::string & text);

  /** 0 where unknown. */
  uint8_t
  GetFDI() const
  {
    return m_FDI;
  }
  bool
  IsKnown() const
  {
    return m_FDI != 0;
  }
  bool
  IsPrimary() const
  {
    return m_FDI > 50;
  }
  /** 1 (UR), 2 (UL), 3 (LL), 4 (LR), of primary teeth too; 0 where unknown. */
  unsigned int
  GetQuadrant() const
  {
    return this->IsPrimary() ? m_FDI / 10u - 4u : m_FDI / 10u;
  }
  /** 1 central incisor .. 8 third molar, of a primary tooth 1 .. 5 second molar; 0 where unknown. */
  unsigned int
  GetPosition() const
  {
    return m_FDI % 10u;
  }
  JawEnum
  GetJaw() const;
  /** On the patient's right. */
  bool
  IsRight() const
  {
    return this->GetQuadrant() == 1 || this->GetQuadrant() == 4;
  }
  bool
  IsLeft() const
  {
    return this->GetQuadrant() == 2 || this->GetQuadrant() == 3;
  }
  GroupEnum
  GetGroup() const;
  /** The same tooth of the other side. */
  ToothCode
  GetContralateral() const;
  /** The same tooth of the other jaw, on the same side. */
  ToothCode
  GetOpposing() const;
  /** 1..32; 0 where unknown and for primary teeth, which have letters. */
  unsigned int
  GetUniversal() const;
  /** "1".."32", of primary teeth "A".."T"; "" where unknown. */
  std::string
  GetUniversalName() const;
  /** "UR1", of a primary tooth "URA"; "" where unknown. */
  std::string
  GetName() const;

  friend bool
  operator==(ToothCode a, ToothCode b)
  {
    return a.m_FDI == b.m_FDI;
  }
  friend bool
  operator!=(ToothCode a, ToothCode b)
  {
    return !(a == b);
  }
  friend bool
  operator<(ToothCode a, ToothCode b)
  {
    return a.m_FDI < b.m_FDI;
  }

private:
  uint8_t m_FDI{ 0 };
};

/** "upper", "lower" or "unknown", as files and messages name a jaw. */
DentalContour_EXPORT const char *
ToString(ToothCode::JawEnum jaw);
/** "Upper", "Lower" or "Unknown", as titles and the names of methods have it. */
DentalContour_EXPORT const char *
ToCapitalizedString(ToothCode::JawEnum jaw);
/** The jaw that opposes this one; of an unknown jaw an unknown one. */
DentalContour_EXPORT ToothCode::JawEnum
                     OtherJaw(ToothCode::JawEnum jaw);

DentalContour_EXPORT std::ostream &
                     operator<<(std::ostream & os, ToothCode code);
DentalContour_EXPORT std::ostream &
                     operator<<(std::ostream & os, ToothCode::NumberingEnum numbering);
DentalContour_EXPORT std::ostream &
                     operator<<(std::ostream & os, ToothCode::JawEnum jaw);
DentalContour_EXPORT std::ostream &
                     operator<<(std::ostream & os, ToothCode::GroupEnum group);
} // namespace itk

#endif

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
 * \brief One permanent tooth, kept as its FDI number (ISO 3950), or unknown.
 *
 * FDI: UR = 11..18, UL = 21..28, LL = 31..38, LR = 41..48. Universal: 1..16 = UR8..UR1, UL1..UL8; 17..32 = LL8..LL1,
 * LR1..LR8.
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

  /** Throws std::invalid_argument where FDI has no such permanent tooth; 0 is the unknown tooth. */
  explicit ToothCode(unsigned int fdi);

  /** Reads a code. "" is the unknown tooth. "UR1"-style codes are read under every numbering, digits as the numbering
   * says and as FDI under Quadrant. Throws std::invalid_argument that names the text and what was expected. */
  static ToothCode
  FromString(const std::string & text, NumberingEnum numbering = NumberingEnum::Quadrant);

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
  /** 1 (UR) .. 4 (LR); 0 where unknown. */
  unsigned int
  GetQuadrant() const
  {
    return m_FDI / 10u;
  }
  /** 1 central incisor .. 8 third molar; 0 where unknown. */
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
  /** 1..32; 0 where unknown. */
  unsigned int
  GetUniversal() const;
  /** "UR1"; "" where unknown. */
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

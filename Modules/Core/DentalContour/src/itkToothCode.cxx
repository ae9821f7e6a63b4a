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
#include "itkToothCode.h"

#include <stdexcept>

namespace itk
{
namespace
{
constexpr const char * QuadrantNames[] = { "", "UR", "UL", "LL", "LR" };

bool
IsPermanentTooth(unsigned int fdi)
{
  return fdi / 10 >= 1 && fdi / 10 <= 4 && fdi % 10 >= 1 && fdi % 10 <= 8;
}

unsigned int
FDIFromUniversal(unsigned int number)
{
  if (number <= 8)
  {
    return 10 + (9 - number);
  }
  if (number <= 16)
  {
    return 20 + (number - 8);
  }
  return number <= 24 ? 30 + (25 - number) : 40 + (number - 24);
}

bool
IsDigits(const std::string & text)
{
  return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

char
UpperCase(char character)
{
  return character >= 'a' && character <= 'z' ? static_cast<char>(character - 'a' + 'A') : character;
}
} // namespace

ToothCode::ToothCode(unsigned int fdi)
  : m_FDI(static_cast<uint8_t>(fdi))
{
  if (fdi != 0 && !IsPermanentTooth(fdi))
  {
    throw std::invalid_argument("FDI has no permanent tooth " + std::to_string(fdi) + " (11-18, 21-28, 31-38, 41-48)");
  }
}

ToothCode
ToothCode::FromString(const std::string & text, NumberingEnum numbering)
{
  if (text.empty())
  {
    return ToothCode();
  }
  if (text.size() == 3 && text[2] >= '1' && text[2] <= '8')
  {
    const std::string quadrant{ UpperCase(text[0]), UpperCase(text[1]) };
    for (unsigned int q = 1; q <= 4; ++q)
    {
      if (quadrant == QuadrantNames[q])
      {
        return ToothCode(10 * q + static_cast<unsigned int>(text[2] - '0'));
      }
    }
  }
  if (IsDigits(text) && text.size() <= 2)
  {
    const auto number = static_cast<unsigned int>(std::stoul(text));
    if (numbering == NumberingEnum::Universal)
    {
      if (number < 1 || number > 32)
      {
        throw std::invalid_argument("universal numbering has no tooth \"" + text + "\" (1-32)");
      }
      return ToothCode(FDIFromUniversal(number));
    }
    // Without a numbering two-digit codes are FDI, always.
    if (!IsPermanentTooth(number))
    {
      throw std::invalid_argument("FDI has no tooth \"" + text +
                                  "\" (11-18, 21-28, 31-38, 41-48); is the numbering \"universal\"?");
    }
    return ToothCode(number);
  }
  throw std::invalid_argument("\"" + text + "\" is no tooth code (UR1-UR8, UL, LL, LR, or digits in FDI or universal)");
}

ToothCode::NumberingEnum
ToothCode::NumberingFromString(const std::string & text)
{
  if (text == "UR")
  {
    return NumberingEnum::Quadrant;
  }
  if (text == "FDI")
  {
    return NumberingEnum::FDI;
  }
  if (text == "universal")
  {
    return NumberingEnum::Universal;
  }
  throw std::invalid_argument("\"" + text + "\" is no numbering (\"UR\", \"FDI\" or \"universal\")");
}

ToothCode::JawEnum
ToothCode::GetJaw() const
{
  switch (this->GetQuadrant())
  {
    case 1:
    case 2:
      return JawEnum::Upper;
    case 3:
    case 4:
      return JawEnum::Lower;
    default:
      return JawEnum::Unknown;
  }
}

ToothCode::GroupEnum
ToothCode::GetGroup() const
{
  const unsigned int position = this->GetPosition();
  if (position == 0)
  {
    return GroupEnum::Unknown;
  }
  return position <= 3 ? GroupEnum::IncisorsAndCanines : position <= 5 ? GroupEnum::Premolars : GroupEnum::Molars;
}

ToothCode
ToothCode::GetContralateral() const
{
  constexpr unsigned int other[] = { 0, 2, 1, 4, 3 };
  return ToothCode(10 * other[this->GetQuadrant()] + this->GetPosition());
}

unsigned int
ToothCode::GetUniversal() const
{
  const unsigned int position = this->GetPosition();
  switch (this->GetQuadrant())
  {
    case 1:
      return 9 - position;
    case 2:
      return 8 + position;
    case 3:
      return 25 - position;
    case 4:
      return 24 + position;
    default:
      return 0;
  }
}

std::string
ToothCode::GetName() const
{
  return this->IsKnown() ? QuadrantNames[this->GetQuadrant()] + std::to_string(this->GetPosition()) : std::string();
}

std::ostream &
operator<<(std::ostream & os, ToothCode code)
{
  return os << (code.IsKnown() ? code.GetName() : "unknown");
}

std::ostream &
operator<<(std::ostream & os, ToothCode::NumberingEnum numbering)
{
  switch (numbering)
  {
    case ToothCode::NumberingEnum::Quadrant:
      return os << "UR";
    case ToothCode::NumberingEnum::FDI:
      return os << "FDI";
    default:
      return os << "universal";
  }
}

std::ostream &
operator<<(std::ostream & os, ToothCode::JawEnum jaw)
{
  switch (jaw)
  {
    case ToothCode::JawEnum::Upper:
      return os << "upper";
    case ToothCode::JawEnum::Lower:
      return os << "lower";
    default:
      return os << "unknown";
  }
}

std::ostream &
operator<<(std::ostream & os, ToothCode::GroupEnum group)
{
  switch (group)
  {
    case ToothCode::GroupEnum::IncisorsAndCanines:
      return os << "incisors and canines";
    case ToothCode::GroupEnum::Premolars:
      return os << "premolars";
    case ToothCode::GroupEnum::Molars:
      return os << "molars";
    default:
      return os << "unknown";
  }
}
} // namespace itk

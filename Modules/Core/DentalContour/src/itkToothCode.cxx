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

#include "itkLowerCase.h"
#include "itkTrimText.h"

#include <stdexcept>

namespace itk
{
namespace
{
using JawEnum = ToothCode::JawEnum;
using NumberingEnum = ToothCode::NumberingEnum;

constexpr const char * QuadrantNames[] = { "", "UR", "UL", "LL", "LR" };

bool
IsPermanentTooth(unsigned int fdi)
{
  return fdi / 10 >= 1 && fdi / 10 <= 4 && fdi % 10 >= 1 && fdi % 10 <= 8;
}

bool
IsPrimaryTooth(unsigned int fdi)
{
  return fdi / 10 >= 5 && fdi / 10 <= 8 && fdi % 10 >= 1 && fdi % 10 <= 5;
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

/** 0 is A. */
unsigned int
FDIFromUniversalLetter(unsigned int letter)
{
  const unsigned int place = letter % 5;
  switch (letter / 5)
  {
    case 0:
      return 50 + (5 - place);
    case 1:
      return 60 + (place + 1);
    case 2:
      return 70 + (5 - place);
    default:
      return 80 + (place + 1);
  }
}

bool
IsDigits(const std::string & text)
{
  return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

bool
StartsWith(const std::string & text, const std::string & start)
{
  return text.compare(0, start.size(), start) == 0;
}

/** A code without what people write around it. */
struct SpelledCode
{
  std::string   text;
  NumberingEnum numbering;
};

SpelledCode
Spell(const std::string & text, NumberingEnum numbering)
{
  SpelledCode code{ LowerCase(TrimText(text)), numbering };
  for (const char * word : { "tooth", "fdi", "#" })
  {
    if (StartsWith(code.text, word) && code.text.size() > std::string(word).size())
    {
      code.numbering = std::string(word) == "fdi" ? NumberingEnum::FDI : code.numbering;
      code.text = TrimText(code.text.substr(std::string(word).size()), " _-");
    }
  }
  // "1.1" is quadrant and position of FDI, whatever the numbering of digits is.
  if (code.text.size() == 3 && code.text[1] == '.' && IsDigits(code.text.substr(0, 1) + code.text[2]))
  {
    code.text.erase(1, 1);
    code.numbering = NumberingEnum::FDI;
  }
  return code;
}

/** 1..4 where the text starts with a quadrant's letters, which are taken off with one character between them and the
 * rest; else 0. */
unsigned int
TakeQuadrant(std::string & text)
{
  for (unsigned int quadrant = 1; quadrant <= 4; ++quadrant)
  {
    if (StartsWith(text, LowerCase(QuadrantNames[quadrant])))
    {
      text.erase(0, text.size() > 3 && (text[2] == ' ' || text[2] == '-' || text[2] == '_') ? 3 : 2);
      return quadrant;
    }
  }
  return 0;
}

struct JawWord
{
  const char * word;
  JawEnum      jaw;
};

/** Whole words only: public tools that look for a letter take lower jaws for upper ones. */
constexpr JawWord JawWords[] = {
  { "upper", JawEnum::Upper },           { "upper jaw", JawEnum::Upper },
  { "upper arch", JawEnum::Upper },      { "upper teeth", JawEnum::Upper },
  { "maxilla", JawEnum::Upper },         { "maxillary", JawEnum::Upper },
  { "maxillary arch", JawEnum::Upper },  { "maxillary teeth", JawEnum::Upper },
  { "lower", JawEnum::Lower },           { "lower jaw", JawEnum::Lower },
  { "lower arch", JawEnum::Lower },      { "lower teeth", JawEnum::Lower },
  { "mandible", JawEnum::Lower },        { "mandibular", JawEnum::Lower },
  { "mandibular arch", JawEnum::Lower }, { "mandibular teeth", JawEnum::Lower },
};
} // namespace

ToothCode::ToothCode(unsigned int fdi)
  : m_FDI(static_cast<uint8_t>(fdi))
{
  if (fdi != 0 && !IsPermanentTooth(fdi) && !IsPrimaryTooth(fdi))
  {
    throw std::invalid_argument("FDI has no tooth " + std::to_string(fdi) +
                                " (11-18, 21-28, 31-38, 41-48; primary 51-55, 61-65, 71-75, 81-85)");
  }
}

ToothCode
ToothCode::FromString(const std::string & text, NumberingEnum numbering)
{
  if (text.empty())
  {
    return ToothCode();
  }
  SpelledCode code = Spell(text, numbering);
  if (const unsigned int quadrant = TakeQuadrant(code.text))
  {
    const char place = code.text.size() == 1 ? code.text[0] : ' ';
    if (place >= '1' && place <= '8')
    {
      return ToothCode(10 * quadrant + static_cast<unsigned int>(place - '0'));
    }
    if (place >= 'a' && place <= 'e')
    {
      return ToothCode(10 * (quadrant + 4) + static_cast<unsigned int>(place - 'a') + 1);
    }
  }
  else if (IsDigits(code.text) && code.text.size() <= 2)
  {
    const auto number = static_cast<unsigned int>(std::stoul(code.text));
    if (code.numbering == NumberingEnum::Universal)
    {
      if (number < 1 || number > 32)
      {
        throw std::invalid_argument("universal numbering has no tooth \"" + text + "\" (1-32)");
      }
      return ToothCode(FDIFromUniversal(number));
    }
    // Without a numbering two-digit codes are FDI, always.
    if (!IsPermanentTooth(number) && !IsPrimaryTooth(number))
    {
      throw std::invalid_argument("FDI has no tooth \"" + text +
                                  "\" (11-18, 21-28, 31-38, 41-48, primary 51-55 to 81-85); is the numbering "
                                  "\"universal\"?");
    }
    return ToothCode(number);
  }
  else if (code.numbering == NumberingEnum::Universal && code.text.size() == 1 && code.text[0] >= 'a' &&
           code.text[0] <= 't')
  {
    return ToothCode(FDIFromUniversalLetter(static_cast<unsigned int>(code.text[0] - 'a')));
  }
  throw std::invalid_argument("\"" + text + "\" is no tooth code (UR1-UR8, UL, LL, LR, or digits in FDI or universal)");
}

bool
ToothCode::IsWrittenAsCode(const std::string & text)
{
  SpelledCode code = Spell(text, NumberingEnum::Quadrant);
  return TakeQuadrant(code.text) > 0 ? code.text.size() <= 1 : IsDigits(code.text);
}

ToothCode
ToothCode::FromSidelessString(const std::string & text)
{
  const std::string code = Spell(text, NumberingEnum::Quadrant).text;
  if (code.size() != 2 || (code[0] != 'u' && code[0] != 'l') || code[1] < '1' || code[1] > '8')
  {
    return ToothCode();
  }
  return ToothCode((code[0] == 'u' ? 10u : 40u) + static_cast<unsigned int>(code[1] - '0'));
}

ToothCode::JawEnum
ToothCode::JawFromString(const std::string & text)
{
  std::string word = LowerCase(TrimText(text));
  for (char & character : word)
  {
    character = character == '_' || character == '-' ? ' ' : character;
  }
  for (const JawWord & known : JawWords)
  {
    if (word == known.word)
    {
      return known.jaw;
    }
  }
  return JawEnum::Unknown;
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
  // Behind the canine a child has molars only.
  return position <= 3                         ? GroupEnum::IncisorsAndCanines
         : position <= 5 && !this->IsPrimary() ? GroupEnum::Premolars
                                               : GroupEnum::Molars;
}

ToothCode
ToothCode::GetContralateral() const
{
  constexpr unsigned int other[] = { 0, 2, 1, 4, 3 };
  return ToothCode(10 * (other[this->GetQuadrant()] + (this->IsPrimary() ? 4 : 0)) + this->GetPosition());
}

ToothCode
ToothCode::GetOpposing() const
{
  constexpr unsigned int other[] = { 0, 4, 3, 2, 1 };
  return ToothCode(10 * (other[this->GetQuadrant()] + (this->IsPrimary() ? 4 : 0)) + this->GetPosition());
}

unsigned int
ToothCode::GetUniversal() const
{
  const unsigned int position = this->GetPosition();
  switch (this->IsPrimary() ? 0 : this->GetQuadrant())
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
ToothCode::GetUniversalName() const
{
  for (unsigned int letter = 0; this->IsPrimary() && letter < 20; ++letter)
  {
    if (FDIFromUniversalLetter(letter) == m_FDI)
    {
      return std::string(1, static_cast<char>('A' + letter));
    }
  }
  return this->IsKnown() ? std::to_string(this->GetUniversal()) : std::string();
}

std::string
ToothCode::GetName() const
{
  if (!this->IsKnown())
  {
    return std::string();
  }
  const std::string quadrant = QuadrantNames[this->GetQuadrant()];
  return quadrant + static_cast<char>((this->IsPrimary() ? 'A' - 1 : '0') + this->GetPosition());
}

const char *
ToString(ToothCode::JawEnum jaw)
{
  switch (jaw)
  {
    case JawEnum::Upper:
      return "upper";
    case JawEnum::Lower:
      return "lower";
    default:
      return "unknown";
  }
}

const char *
ToCapitalizedString(ToothCode::JawEnum jaw)
{
  switch (jaw)
  {
    case JawEnum::Upper:
      return "Upper";
    case JawEnum::Lower:
      return "Lower";
    default:
      return "Unknown";
  }
}

ToothCode::JawEnum
OtherJaw(ToothCode::JawEnum jaw)
{
  switch (jaw)
  {
    case JawEnum::Upper:
      return JawEnum::Lower;
    case JawEnum::Lower:
      return JawEnum::Upper;
    default:
      return JawEnum::Unknown;
  }
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
  return os << ToString(jaw);
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

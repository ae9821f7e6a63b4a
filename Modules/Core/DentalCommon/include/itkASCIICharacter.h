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
#ifndef itkASCIICharacter_h
#define itkASCIICharacter_h

namespace itk
{
/** Whether a character is a blank, and whether a letter or a digit. Of ASCII only, unlike std::isspace() and
 * std::isalnum(), which ask the process' locale: in one of ISO 8859 the bytes of a letter in UTF-8 would be such.
 *
 * \ingroup DentalCommon */
constexpr bool
IsASCIIBlank(char character)
{
  return character == ' ' || (character >= '\t' && character <= '\r');
}

/** 0 to 9, in any locale.
 * \ingroup DentalCommon */
constexpr bool
IsASCIIDigit(char character)
{
  return character >= '0' && character <= '9';
}

/** A to Z, in any locale.
 * \ingroup DentalCommon */
constexpr bool
IsASCIIUpperCase(char character)
{
  return character >= 'A' && character <= 'Z';
}

/** a to z, in any locale.
 * \ingroup DentalCommon */
constexpr bool
IsASCIILowerCase(char character)
{
  return character >= 'a' && character <= 'z';
}

/** A to Z become a to z; all else stays.
 * \ingroup DentalCommon */
constexpr char
ToASCIILowerCase(char character)
{
  return IsASCIIUpperCase(character) ? static_cast<char>(character - 'A' + 'a') : character;
}

/** a to z become A to Z; all else stays.
 * \ingroup DentalCommon */
constexpr char
ToASCIIUpperCase(char character)
{
  return IsASCIILowerCase(character) ? static_cast<char>(character - 'a' + 'A') : character;
}

/** A letter or a digit of ASCII, in any locale.
 * \ingroup DentalCommon */
constexpr bool
IsASCIIAlphanumeric(char character)
{
  return IsASCIIDigit(character) || IsASCIIUpperCase(character) || IsASCIILowerCase(character);
}
} // namespace itk

#endif

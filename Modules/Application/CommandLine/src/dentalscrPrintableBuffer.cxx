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
#include "dentalscrPrintableBuffer.h"

#include <string>

namespace dentalscr
{
namespace
{
void
Show(unsigned char byte, std::string & text)
{
  constexpr char digits[] = "0123456789abcdef";
  text += "\\x";
  text += digits[byte >> 4];
  text += digits[byte & 15];
}

void
ShowAll(const std::string & bytes, std::string & text)
{
  for (const char byte : bytes)
  {
    Show(static_cast<unsigned char>(byte), text);
  }
}

/** Bytes of a letter in UTF-8 by its first one; 0 where it is none. */
std::size_t
GetLength(unsigned char first)
{
  return first >= 0xc2 && first < 0xe0 ? 2 : first >= 0xe0 && first < 0xf0 ? 3 : first >= 0xf0 && first < 0xf5 ? 4 : 0;
}

/** U+0080 to U+009F; ends of lines and paragraphs, and what turns the direction: U+2028 to U+202E, U+2066 to U+2069. */
bool
IsControl(const std::string & letter)
{
  const auto byte = [&letter](std::size_t i) { return static_cast<unsigned char>(letter[i]); };
  if (letter.size() == 2)
  {
    return byte(0) == 0xc2 && byte(1) < 0xa0;
  }
  return letter.size() == 3 && byte(0) == 0xe2 &&
         ((byte(1) == 0x80 && byte(2) >= 0xa8 && byte(2) <= 0xae) ||
          (byte(1) == 0x81 && byte(2) >= 0xa6 && byte(2) <= 0xa9));
}
} // namespace

PrintableBuffer::PrintableBuffer(std::ostream & stream)
  : m_Stream(stream)
  , m_Buffer(stream.rdbuf(this))
{
  // What went wrong with the stream before it was this one's is none of its business.
  stream.clear();
}

PrintableBuffer::~PrintableBuffer()
{
  std::string shown;
  ShowAll(m_Letter, shown);
  m_Buffer->sputn(shown.data(), static_cast<std::streamsize>(shown.size()));
  m_Buffer->pubsync();
  const auto state = m_Stream.rdstate();
  m_Stream.rdbuf(m_Buffer);
  m_Stream.clear(state);
}

PrintableBuffer::int_type
PrintableBuffer::overflow(int_type character)
{
  if (traits_type::eq_int_type(character, traits_type::eof()))
  {
    return traits_type::not_eof(character);
  }
  const char one = traits_type::to_char_type(character);
  return this->xsputn(&one, 1) == 1 ? character : traits_type::eof();
}

std::streamsize
PrintableBuffer::xsputn(const char * text, std::streamsize count)
{
  std::string shown;
  for (std::streamsize i = 0; i < count; ++i)
  {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (!m_Letter.empty() && (byte & 0xc0) != 0x80)
    {
      ShowAll(m_Letter, shown);
      m_Letter.clear();
    }
    if (byte >= 0x80)
    {
      m_Letter += text[i];
      const std::size_t length = GetLength(static_cast<unsigned char>(m_Letter[0]));
      if (length == 0)
      {
        ShowAll(m_Letter, shown);
        m_Letter.clear();
      }
      else if (m_Letter.size() == length)
      {
        if (IsControl(m_Letter))
        {
          ShowAll(m_Letter, shown);
        }
        else
        {
          shown += m_Letter;
        }
        m_Letter.clear();
      }
    }
    else if ((byte < 0x20 && byte != '\n' && byte != '\t') || byte == 0x7f)
    {
      Show(byte, shown);
    }
    else
    {
      shown += text[i];
    }
  }
  const auto size = static_cast<std::streamsize>(shown.size());
  return m_Buffer->sputn(shown.data(), size) == size ? count : 0;
}

int
PrintableBuffer::sync()
{
  // What has begun waits for its end: a stream may be flushed between the bytes of a letter.
  return m_Buffer->pubsync();
}
} // namespace dentalscr

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
  this->sync();
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
    if (m_IsHeld)
    {
      m_IsHeld = false;
      if (byte >= 0x80 && byte < 0xa0)
      {
        Show(byte, shown);
        continue;
      }
      shown += '\xc2';
    }
    if (byte == 0xc2)
    {
      m_IsHeld = true;
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
  if (m_IsHeld)
  {
    m_IsHeld = false;
    m_Buffer->sputc('\xc2');
  }
  return m_Buffer->pubsync();
}
} // namespace dentalscr

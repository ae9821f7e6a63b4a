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
#ifndef dentalscrPrintableBuffer_h
#define dentalscrPrintableBuffer_h

#include <ostream>
#include <streambuf>

namespace dentalscr
{
/** \class PrintableBuffer
 * \brief Stands before a stream and shows control bytes instead of sending them, for as long as it lives.
 *
 * Names of files, teeth and landmarks come from others; with an escape sequence in them they could move the cursor,
 * colour what follows or make a terminal answer. New lines and tabs pass, and so does every letter of every language;
 * other control characters, of ASCII and of Unicode's second block, appear as \xNN. */
class PrintableBuffer : public std::streambuf
{
public:
  explicit PrintableBuffer(std::ostream & stream);
  ~PrintableBuffer() override;
  PrintableBuffer(const PrintableBuffer &) = delete;
  PrintableBuffer &
  operator=(const PrintableBuffer &) = delete;

protected:
  int_type
  overflow(int_type character) override;
  std::streamsize
  xsputn(const char * text, std::streamsize count) override;
  int
  sync() override;

private:
  std::ostream &   m_Stream;
  std::streambuf * m_Buffer;
  /** Whether the byte before was 0xC2, the first of those characters of Unicode; it waits for the second. */
  bool m_IsHeld{ false };
};
} // namespace dentalscr

#endif

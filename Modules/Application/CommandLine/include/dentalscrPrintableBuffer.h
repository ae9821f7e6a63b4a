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
#include <string>

namespace dentalscr
{
/** \class PrintableBuffer
 * \brief Stands before a stream and shows control bytes instead of sending them, for as long as it lives.
 *
 * Names of files, teeth and landmarks come from others; with an escape sequence in them they could move the cursor,
 * colour what follows or make a terminal answer. New lines and tabs pass, and so does every letter of every language in
 * UTF-8; other control characters, of ASCII and of Unicode, those that turn the direction of writing among them, and
 * bytes that are no UTF-8 appear as `\\xNN`. */
class PrintableBuffer : public std::streambuf
{
public:
  explicit PrintableBuffer(std::ostream & stream); /**< Until it is destroyed. */
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
  /** The first bytes of a letter of which more are to come. */
  std::string m_Letter;
};
} // namespace dentalscr

#endif

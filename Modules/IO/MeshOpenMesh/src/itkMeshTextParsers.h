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
#ifndef itkMeshTextParsers_h
#define itkMeshTextParsers_h

#include "itkSurfaceMeshFile.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace itk
{
/** \class MeshTextCursor
 * \brief Words and lines of a text in memory; knows the line for messages. Numbers are read without a locale. */
class MeshTextCursor
{
public:
  MeshTextCursor(const char * bytes, std::size_t size, bool numberSignIsComment);

  /** The next word, on whatever line; empty at the end. */
  std::string_view
  NextWord();
  /** The next word of this line; empty at the line's end. */
  std::string_view
  NextWordOfLine();
  /** \return the rest of the line; goes to the next one. */
  std::string_view
  SkipLine();
  /** Goes to the next line that holds a word; false where there is none. */
  bool
  NextRecord();

  /** A finite number within single precision. \p what is named in the message. */
  double
  ParseNumber(std::string_view word, const char * what) const;
  std::int64_t
  ParseInteger(std::string_view word, const char * what) const;

  [[noreturn]] void
  Fail(const std::string & problem, const std::string & remedy = "repair it or export it again") const;

  std::size_t
  GetLine() const
  {
    return m_Line;
  }
  std::size_t
  GetRemaining() const
  {
    return static_cast<std::size_t>(m_End - m_Position);
  }
  const char *
  GetPosition() const
  {
    return m_Position;
  }

private:
  void
  SkipBlanks();

  const char * m_Position;
  const char * m_End;
  std::size_t  m_Line{ 1 };
  bool         m_NumberSignIsComment;
};

/** The word in quotes, shortened and with unprintable bytes replaced. */
std::string
QuoteForMessage(std::string_view word);

/** Adds a polygon as a fan from its first corner; drops and counts triangles that name a point twice. */
void
AddPolygon(SurfaceMeshFile & surface, const std::uint32_t * corners, std::size_t count);

SurfaceMeshFile
ParseAsciiSTL(const char * bytes, std::size_t size);
SurfaceMeshFile
ParseOBJ(const char * bytes, std::size_t size);
SurfaceMeshFile
ParseOFF(const char * bytes, std::size_t size);
} // namespace itk

#endif

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
#ifndef itkDrawingFile_h
#define itkDrawingFile_h

#include "TracingExport.h"

#include <optional>
#include <string>

namespace itk
{
/** \class DrawingFile
 * \brief A file that is saved to again and again, by one program.
 *
 * What another program has written meanwhile is not overwritten: Verify() and Save() throw DentalInputError where the
 * file is no longer what it was when this object was made, or as this object saved it.
 *
 * \ingroup Tracing
 */
class Tracing_EXPORT DrawingFile
{
public:
  /** "": none, to which nothing is saved. */
  explicit DrawingFile(std::string fileName);
  /** The file that is saved to. */
  const std::string &
  GetFileName() const
  {
    return m_FileName;
  }
  /** Whether there was one before this object saved anything. */
  bool
  WasThere() const
  {
    return m_WasThere;
  }
  /** Throws a DentalInputError where another program has written to the file since it was read. */
  void
  Verify() const;

  /** Whole or not at all. */
  void
  Save(const std::string & content);

private:
  /** SHA-256; nothing where there is no file. */
  std::optional<std::string>
  ComputeDigest() const;

  std::string                m_FileName;
  std::optional<std::string> m_Digest;
  bool                       m_WasThere;
};
} // namespace itk

#endif

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
#ifndef itkMappedFile_h
#define itkMappedFile_h

#include <cstddef>
#include <string>

namespace itk
{
/** \class MappedFile
 * \brief The bytes of a file, mapped read-only where it can be. Throws a SurfaceMeshFileError for what is no readable
 * file with something in it. */
class MappedFile
{
public:
  explicit MappedFile(const std::string & fileName);
  ~MappedFile();
  MappedFile(const MappedFile &) = delete;
  MappedFile &
  operator=(const MappedFile &) = delete;

  const char *
  GetData() const
  {
    return m_Data;
  }
  std::size_t
  GetSize() const
  {
    return m_Size;
  }

private:
  const char * m_Data{ nullptr };
  std::size_t  m_Size{ 0 };
};
} // namespace itk

#endif

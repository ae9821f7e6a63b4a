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
#ifndef itkScanFile_h
#define itkScanFile_h

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <string>

namespace itk
{
/** \class ScanFile
 * \brief The bytes of a file. Throws a SurfaceMeshFileError for what is no readable file with something in it.
 *
 * Read and not mapped: a file that is cut short while it is looked at (a copy that starts again, a share that goes
 * away) would end the process by SIGBUS. */
class ScanFile
{
public:
  explicit ScanFile(const std::string & fileName);
  ScanFile(const ScanFile &) = delete;
  ScanFile &
  operator=(const ScanFile &) = delete;

  const char *
  GetData() const
  {
    return m_Data.get();
  }
  std::size_t
  GetSize() const
  {
    return m_Size;
  }

private:
  struct Releaser
  {
    void
    operator()(char * data) const
    {
      std::free(data);
    }
  };

  std::unique_ptr<char, Releaser> m_Data;
  std::size_t                     m_Size{ 0 };
};
} // namespace itk

#endif

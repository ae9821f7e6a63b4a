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
#include "itkReadFileTail.h"

#include "itkInputFile.h"

namespace itk
{
std::string
ReadFileTail(const std::string & fileName, std::size_t size)
{
  InputFile   file(fileName);
  std::string tail;
  std::string block(size, '\0');
  while (!block.empty())
  {
    block.resize(file.Read(&block[0], block.size()));
    tail += block;
    tail.erase(0, tail.size() > size ? tail.size() - size : 0);
  }
  return tail;
}
} // namespace itk

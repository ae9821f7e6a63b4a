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
#ifndef itkForEachKeptSample_h
#define itkForEachKeptSample_h

#include <cstddef>
#include <vector>

namespace itk
{
/** Walks once round a closed line, of whose samples only some are kept, from behind a gap: a run of kept samples that
 * goes over the line's first point is one run. Where all are kept it begins at the first.
 *
 * \param keep    one a sample, 0 for those that are left out.
 * \param append  called with the number of each kept sample, and whether a run begins with it.
 *
 * \ingroup SilhouetteContour
 */
template <typename TAppend>
void
ForEachKeptSample(const std::vector<char> & keep, TAppend && append)
{
  const std::size_t n = keep.size();
  std::size_t       begin = 0;
  while (begin < n && keep[begin])
  {
    ++begin;
  }
  bool isOpen = false;
  for (std::size_t k = 0; k < n; ++k)
  {
    const std::size_t i = (begin + k) % n;
    if (keep[i])
    {
      append(i, !isOpen);
    }
    isOpen = keep[i] != 0;
  }
}
} // namespace itk

#endif

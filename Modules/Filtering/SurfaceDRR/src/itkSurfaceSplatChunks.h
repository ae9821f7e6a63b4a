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
#ifndef itkSurfaceSplatChunks_h
#define itkSurfaceSplatChunks_h

#include <algorithm>
#include <cstddef>

// How the splats are shared out where each is looked at: preparing and sorting do so alike, and hold widths to the same
// limit. Private to this module.
namespace itk
{
namespace SurfaceSplatDetail
{
constexpr double LargestSigma = 1000.0;

/** Some for each thread, so that one that is interrupted does not hold up the others. */
inline std::size_t
NumberOfChunks(std::size_t count, unsigned int threads)
{
  return threads <= 1 ? 1 : std::min<std::size_t>(4 * static_cast<std::size_t>(threads), 1 + count / 4096);
}
} // namespace SurfaceSplatDetail
} // namespace itk

#endif

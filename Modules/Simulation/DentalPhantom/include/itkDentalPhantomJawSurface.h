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
#ifndef itkDentalPhantomJawSurface_h
#define itkDentalPhantomJawSurface_h

#include "itkTriangleSurface.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace itk
{
/** \struct DentalPhantomJawSurface
 * \brief One phantom jaw as a mesh, with what is known of it.
 *
 * \ingroup DentalPhantom
 */
struct DentalPhantomJawSurface
{
  /** A named point, mm in the frame of the surface. */
  struct Landmark
  {
    std::string           name;  /**< Such as "UR6_MB". */
    std::array<double, 3> point; /**< mm. */
  };
  /** The mesh of the jaw, mm. */
  TriangleSurface surface;
  /** FDI number at each point, 0 = gingiva. */
  std::vector<std::uint8_t> labels;
  /** Names as in formats.md, "UR1_tip"; each point is a vertex of the surface. */
  std::vector<Landmark> landmarks;
};
} // namespace itk

#endif

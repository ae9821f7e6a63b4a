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
#ifndef itkDentalPhantomGrid_h
#define itkDentalPhantomGrid_h

#include "itkDentalPhantomJawSurface.h"

#include <cstdint>
#include <vector>

namespace itk
{
/** \struct DentalPhantomGrid
 * \brief A jaw's mesh while it is made: columns across the arch, rows along it, and the numbers that lay them out.
 *
 * \ingroup DentalPhantom
 */
struct DentalPhantomGrid
{
  int buccalRows{ 0 };
  int fanRows{ 0 };
  int lingualRows{ 0 };
  int palateRows{ 0 };
  int wallRows{ 0 };
  int bottomRows{ 0 };
  /** Rows that are rays: both flanges and the fan. */
  int rayRows{ 0 };
  /** Columns of each side; the midline's is one more. */
  int half{ 0 };
  int columns{ 0 };
  /** Arc length of each column. */
  std::vector<double> stations;
  /** Of the fan's rays. */
  std::vector<double> angles;
  /** Vertices of each column, from the buccal border on. */
  std::vector<std::vector<std::uint32_t>> ids;

  /** Triangles between two columns of equal length, the shorter diagonal of each cell. */
  static void
  AddStrip(TriangleSurface &                  surface,
           const std::vector<std::uint32_t> & first,
           const std::vector<std::uint32_t> & second);
};
} // namespace itk

#endif

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
#include "itkDentalPhantomGrid.h"


namespace itk
{
void
DentalPhantomGrid::AddStrip(TriangleSurface &                  surface,
                            const std::vector<std::uint32_t> & first,
                            const std::vector<std::uint32_t> & second)
{
  for (std::size_t r = 0; r + 1 < first.size(); ++r)
  {
    const std::uint32_t a = first[r];
    const std::uint32_t b = second[r];
    const std::uint32_t d = first[r + 1];
    const std::uint32_t e = second[r + 1];
    // The shorter diagonal.
    double ae = 0.0;
    double bd = 0.0;
    for (unsigned int k = 0; k < 3; ++k)
    {
      ae += (surface.points[a][k] - surface.points[e][k]) * (surface.points[a][k] - surface.points[e][k]);
      bd += (surface.points[b][k] - surface.points[d][k]) * (surface.points[b][k] - surface.points[d][k]);
    }
    const bool other = ae < bd;
    for (const TriangleSurface::TriangleType & t : { TriangleSurface::TriangleType{ { a, b, other ? e : d } },
                                                     TriangleSurface::TriangleType{ { other ? a : b, e, d } } })
    {
      // Where columns meet in one point a cell is a triangle.
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
      {
        surface.triangles.push_back(t);
      }
    }
  }
}
} // namespace itk

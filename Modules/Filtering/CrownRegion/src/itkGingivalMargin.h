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
#ifndef itkGingivalMargin_h
#define itkGingivalMargin_h

#include "itkCrownRegionKernel.h"
#include "itkValleyChart.h"

#include <vector>

namespace itk
{
namespace CrownRegionParts
{
/** Depth of the margin below the occlusal surface (mm) and the surface's turning angle there, a station. */
struct GingivalMargin
{
  std::vector<double> depth;
  std::vector<double> angle;
};

/** The path along the arch that gathers most of one side's valleys, near the height that is expected, without leaps.
 * `front` is the station at the midline. */
GingivalMargin
TraceGingivalMargin(const ValleyChart & chart, unsigned int side, double front, const CrownRegionOptions & options);
} // namespace CrownRegionParts
} // namespace itk

#endif

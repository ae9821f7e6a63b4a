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
#ifndef itkSurfaceSplatRendering_h
#define itkSurfaceSplatRendering_h

#include "itkSurfaceSplatArithmetic.h"
#include "itkSurfaceSplatKernel.h"

#include <vector>

// Scratch memory of a job of a rendering, which its renderers share. Private to this module.
namespace itk
{
/** Rows of a band, four times: a splat of which the first tap is in column u goes into the copy u mod 4, where that
 * column begins a vector. A store of a neighbour that is loaded again then is one whole vector: unaligned ones that
 * overlap would have to wait for each other. */
struct SurfaceSplatKernel::Rendering::ScratchType
{
  std::vector<SurfaceSplatDetail::Float4> copies;
  std::vector<float>                      row;
};
} // namespace itk

#endif

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
#include "itkSelectMeshTriangles.h"

namespace itk
{
DentalJawFrame
JawFrameFromTransform(const VersorRigid3DTransform<double> & transform)
{
  DentalJawFrame frame;
  frame.valid = true;
  const auto & matrix = transform.GetMatrix();
  const auto & offset = transform.GetOffset();
  for (unsigned int r = 0; r < 3; ++r)
  {
    for (unsigned int c = 0; c < 3; ++c)
    {
      frame.axes[r][c] = matrix(r, c);
      frame.origin[c] -= matrix(r, c) * offset[r];
    }
  }
  return frame;
}
} // namespace itk

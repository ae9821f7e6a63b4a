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
#include "itkMillimetresPerUnit.h"

#include <stdexcept>

namespace itk
{
double
MillimetresPerUnitFromString(const std::string & unit)
{
  for (const MeshUnit & known : MeshUnits)
  {
    if (unit == known.name)
    {
      return known.millimetres;
    }
  }
  throw std::invalid_argument("\"" + unit + "\" is no mesh unit (\"mm\", \"cm\", \"inch\", \"m\" or \"um\")");
}
} // namespace itk

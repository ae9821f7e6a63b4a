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
#ifndef dentalscrData_h
#define dentalscrData_h

#include "dentalscrBinding.h"

#include <stdexcept>
#include <string>

namespace dentalscr
{
/** Throws unless the array is N x columns. */
inline void
CheckShape(const py::array & array, py::ssize_t columns, const char * what)
{
  if (array.ndim() != 2 || (array.shape(1) != columns && array.size() > 0))
  {
    std::string shape;
    for (py::ssize_t i = 0; i < array.ndim(); ++i)
    {
      shape += (i > 0 ? ", " : "") + std::to_string(array.shape(i));
    }
    throw std::invalid_argument(std::string(what) + " have the shape (" + shape + "); (N, " + std::to_string(columns) +
                                ") is needed");
  }
}

/** Contours and tooth codes: a part of WrapData(), in a file of its own. */
void
WrapContour(py::module_ & module);
} // namespace dentalscr

#endif

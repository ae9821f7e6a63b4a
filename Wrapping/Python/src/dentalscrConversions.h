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
#ifndef dentalscrConversions_h
#define dentalscrConversions_h

#include "dentalscrBinding.h"

#include "itkMatrix.h"

#include <vector>

namespace dentalscr
{
/** An output that the pipeline will not write to again: what a filter of one call returns. */
template <typename TOutput>
itk::SmartPointer<TOutput>
Detach(TOutput * output)
{
  itk::SmartPointer<TOutput> result = output;
  result->DisconnectPipeline();
  return result;
}

/** A matrix of vnl as an array of its rows. */
template <typename TMatrix>
py::array_t<double>
MatrixToArray(const TMatrix & matrix)
{
  return MakeArray(std::vector<double>(matrix.begin(), matrix.end()),
                   { static_cast<py::ssize_t>(matrix.rows()), static_cast<py::ssize_t>(matrix.cols()) });
}

/** One of ITK. */
template <unsigned int VRows, unsigned int VColumns>
py::array_t<double>
MatrixToArray(const itk::Matrix<double, VRows, VColumns> & matrix)
{
  return MatrixToArray(matrix.GetVnlMatrix());
}
} // namespace dentalscr

#endif

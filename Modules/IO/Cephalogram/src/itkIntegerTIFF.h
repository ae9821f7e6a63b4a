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
#ifndef itkIntegerTIFF_h
#define itkIntegerTIFF_h

#include <cstddef>
#include <string>
#include <vector>

namespace itk
{
/** Not installed. Whether a file is a TIFF of one value a pixel in whole numbers of 32 bits: what NumPy, and with
 * it most label maps, is made of by default. ITK 5.2 takes it for 8 bits and fills it with noughts. */
bool
IsIntegerTIFF(const std::string & fileName);

/** The values of such a file, row by row. Throws an ExceptionObject where it is not whole or has another size. */
std::vector<double>
ReadIntegerTIFF(const std::string & fileName, std::size_t width, std::size_t height);
} // namespace itk

#endif

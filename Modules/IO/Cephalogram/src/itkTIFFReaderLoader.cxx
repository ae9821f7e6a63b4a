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
#include "itkTIFFLayout.h"

#ifdef DENTALSCR_TIFF_LIBRARY
#  include "itkLoadLibraryFunction.h"
#endif

namespace itk
{
const TIFFReader &
LoadTIFFReader()
{
#ifdef DENTALSCR_TIFF_LIBRARY
  static const TIFFReader * const reader =
    LoadLibraryFunction<decltype(&DentalSCRGetTIFFReader)>(DENTALSCR_TIFF_LIBRARY,
                                                           "DentalSCRGetTIFFReader",
                                                           "TIFF files cannot be read",
                                                           DENTALSCR_TIFF_LIBRARY " and libtiff")();
  return *reader;
#else
  return *DentalSCRGetTIFFReader();
#endif
}
} // namespace itk

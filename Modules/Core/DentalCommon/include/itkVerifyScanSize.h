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
#ifndef itkVerifyScanSize_h
#define itkVerifyScanSize_h

#include "DentalCommonExport.h"
#include "itkInputFile.h"

namespace itk
{
/** Throws an InputFileError where a scan's file is longer than 1 GiB, which are 21 million triangles of a binary STL
 * and need some 8 GB of memory. The environment variable DENTALSCR_LARGEST_SCAN_MIB is another bound, a whole number of
 * MiB; what is no such number is an error, too.
 *
 * \ingroup DentalCommon */
DentalCommon_EXPORT void
VerifyScanSize(const InputFile & file);
} // namespace itk

#endif

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
#include "itkDicomImageIO.h"

#ifdef DENTALSCR_DICOM_LIBRARY
#  include "itkLoadLibraryFunction.h"
#endif

#include <atomic>

namespace itk
{
namespace
{
std::atomic<const DicomImageIO *> loaded{ nullptr };
}

const DicomImageIO &
LoadDicomImageIO()
{
  if (loaded == nullptr)
  {
#ifdef DENTALSCR_DICOM_LIBRARY
    // To load it twice is harmless.
    loaded = LoadLibraryFunction<decltype(&DentalSCRGetDicomImageIO)>(DENTALSCR_DICOM_LIBRARY,
                                                                      "DentalSCRGetDicomImageIO",
                                                                      "DICOM files cannot be read",
                                                                      DENTALSCR_DICOM_LIBRARY " and GDCM")();
#else
    loaded = DentalSCRGetDicomImageIO();
#endif
  }
  return *loaded;
}
} // namespace itk

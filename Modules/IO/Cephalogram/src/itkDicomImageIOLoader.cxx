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

#include "itkMacro.h"

#include <atomic>

#ifdef DENTALSCR_DICOM_LIBRARY
#  include <dlfcn.h>
#endif

namespace itk
{
namespace
{
std::atomic<const DicomImageIO *> loaded{ nullptr };
}

const DicomImageIO *
GetLoadedDicomImageIO()
{
  return loaded;
}

const DicomImageIO &
LoadDicomImageIO()
{
  if (loaded == nullptr)
  {
#ifdef DENTALSCR_DICOM_LIBRARY
    // Found as this library's own dependencies are, by its RUNPATH: beside it. To load it twice is harmless.
    void * const library = dlopen(DENTALSCR_DICOM_LIBRARY, RTLD_LAZY | RTLD_LOCAL);
    void * const function = library == nullptr ? nullptr : dlsym(library, "DentalSCRGetDicomImageIO");
    if (function == nullptr)
    {
      const char * const why = dlerror();
      itkGenericExceptionMacro("DICOM files cannot be read: " << (why == nullptr ? "unknown reason" : why)
                                                              << ". Install " << DENTALSCR_DICOM_LIBRARY
                                                              << " and GDCM beside the other libraries of DentalSCR.");
    }
    loaded = reinterpret_cast<decltype(&DentalSCRGetDicomImageIO)>(function)();
#else
    loaded = DentalSCRGetDicomImageIO();
#endif
  }
  return *loaded;
}
} // namespace itk

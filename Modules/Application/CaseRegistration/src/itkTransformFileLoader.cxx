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
#include "itkTransformFile.h"

#include "itkMacro.h"

#ifdef DENTALSCR_TRANSFORM_LIBRARY
#  include <dlfcn.h>
#endif

namespace itk
{
void
WriteTransformFile(const TransformBaseTemplate<double> * transform, const std::string & fileName)
{
#ifdef DENTALSCR_TRANSFORM_LIBRARY
  // Found as this library's own dependencies are, by its RUNPATH: beside it. To load it again is to count it.
  void * const library = dlopen(DENTALSCR_TRANSFORM_LIBRARY, RTLD_LAZY | RTLD_LOCAL);
  void * const function = library == nullptr ? nullptr : dlsym(library, "DentalSCRWriteTransformFile");
  if (function == nullptr)
  {
    const char * const why = dlerror();
    itkGenericExceptionMacro("Transforms cannot be written: " << (why == nullptr ? "unknown reason" : why)
                                                              << ". Install " << DENTALSCR_TRANSFORM_LIBRARY
                                                              << " beside the other libraries of DentalSCR.");
  }
  reinterpret_cast<decltype(&DentalSCRWriteTransformFile)>(function)(transform, fileName.c_str());
#else
  DentalSCRWriteTransformFile(transform, fileName.c_str());
#endif
}
} // namespace itk

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
#ifndef itkLoadLibraryFunction_h
#define itkLoadLibraryFunction_h

#include "itkMacro.h"

#ifndef _WIN32
#  include <dlfcn.h>
#endif

#include <string>

#ifndef _WIN32
namespace itk
{
/** A function of a library that is loaded when it is first needed, because what it links costs more than most programs
 * want to pay when they start. dentalscr_add_loaded_library() in CMake makes such a library.
 *
 * Of internal linkage: the library is found as the dependencies of the library that calls this are, by that one's
 * RUNPATH, hence the call must not be made from another one. To load a library again is to count it.
 *
 * \param library   its file name
 * \param function  its name, declared extern "C"
 * \param failure   what cannot be done without it, to begin the message of the ExceptionObject that is thrown then
 * \param install   what to install beside the other libraries of DentalSCR, to end it */
template <typename TFunction>
static inline TFunction
LoadLibraryFunction(const std::string & library,
                    const std::string & function,
                    const std::string & failure,
                    const std::string & install)
{
  void * const handle = dlopen(library.c_str(), RTLD_LAZY | RTLD_LOCAL);
  void * const address = handle == nullptr ? nullptr : dlsym(handle, function.c_str());
  if (address == nullptr)
  {
    const char * const why = dlerror();
    itkGenericExceptionMacro(<< failure << ": " << (why == nullptr ? "unknown reason" : why) << ". Install " << install
                             << " beside the other libraries of DentalSCR.");
  }
  return reinterpret_cast<TFunction>(address);
}
} // namespace itk
#endif

#endif

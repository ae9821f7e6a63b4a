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
#ifndef dentalscrRegisterImageFormats_h
#define dentalscrRegisterImageFormats_h

#include "CommandLineExport.h"

namespace dentalscr
{
/** Lets ITK read and write the image formats of the program and of the Python package: PNG, TIFF, MetaImage, NRRD, BMP
 * and JPEG. Their libraries are loaded by the first call, since of the verbs render alone writes images by their
 * extension. Throws an itk::ExceptionObject where they cannot be loaded. */
CommandLine_EXPORT void
RegisterImageFormats();
} // namespace dentalscr

#endif

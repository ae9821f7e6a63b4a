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
#ifndef itkRadiographImageIO_h
#define itkRadiographImageIO_h

#include "itkMemoryFile.h"
#include "itkRadiographFileFormat.h"

#include "itkImageIOBase.h"

#include <functional>
#include <string>

namespace itk
{
/** Not installed: the decoder of a format. Those of PNG, JPEG and NIfTI are called here, behind checks of the whole
 * file; all others run in a process of their own. It reads the given file, which has to live as long as it. */
ImageIOBase::Pointer
MakeRadiographImageIO(RadiographFileFormatEnum format, const MemoryFile & file);

/** Calls a decoder's code, silences what it prints, and turns what it throws into an input error, in which the names of
 * files in memory, that mean nothing to anybody, are "it". */
void
CallRadiographImageIO(const std::string & fileName, const std::string & format, const std::function<void()> & function);
} // namespace itk

#endif

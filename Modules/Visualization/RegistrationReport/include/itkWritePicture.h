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
#ifndef itkWritePicture_h
#define itkWritePicture_h

#include "RegistrationReportExport.h"

#include "itkImage.h"
#include "itkRGBPixel.h"

#include <string>

namespace itk
{
/** Writes a picture as PNG, whatever the file's name ends in, whole or not at all: to a temporary file beside it that
 * is renamed at the end. Throws an ExceptionObject that names the file. */
RegistrationReport_EXPORT void
WritePicture(const Image<RGBPixel<unsigned char>, 2> * picture, const std::string & fileName);
} // namespace itk

#endif

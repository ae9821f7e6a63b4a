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
#ifndef itkDicomImageIO_h
#define itkDicomImageIO_h

#include "itkImageIOBase.h"

namespace itk
{
/** \struct DicomImageIO
 * \brief Not installed. What is wanted of GDCM, in a library of its own.
 *
 * GDCM brings 20 further libraries, and its dictionaries are built when it is loaded: half of the time that a program
 * with it needs before its main() begins. Few images are DICOM files, so that it is loaded for one alone.
 */
struct DicomImageIO
{
  /** A GDCMImageIO with a reference that is the caller's. */
  ImageIOBase * (*create)();
};

/** Loads GDCM on the first call, for as long as the process lasts. Throws an ExceptionObject where it cannot. */
const DicomImageIO &
LoadDicomImageIO();
} // namespace itk

extern "C" __attribute__((visibility("default"))) const itk::DicomImageIO *
DentalSCRGetDicomImageIO();

#endif

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
#ifndef itkTransformFile_h
#define itkTransformFile_h

#include "itkTransformBase.h"

#include <string>

namespace itk
{
/** Not installed. Writes a transform as an Insight legacy text file by ITK's own writer, which is in a library of its
 * own and loaded with the first file: it makes a factory for every transform that ITK has, some 35 000 symbols, of
 * which the program would otherwise look up every one before its main() begins. Throws what ITK throws, or an
 * ExceptionObject where the library is missing. */
void
WriteTransformFile(const TransformBaseTemplate<double> * transform, const std::string & fileName);
} // namespace itk

extern "C" __attribute__((visibility("default"))) void
DentalSCRWriteTransformFile(const itk::TransformBaseTemplate<double> * transform, const char * fileName);

#endif

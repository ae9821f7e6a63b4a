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
#ifndef itkDicomFileCheck_h
#define itkDicomFileCheck_h

#include <string>
#include <string_view>

namespace itk
{
/** Not installed. Walks a DICOM file's elements and checks those that describe the pixels, before GDCM sees it: as
 * packaged it is built with assertions, so that damaged bytes would end the program. Throws DentalInputError for what
 * is cut off or nested wrongly, for an unknown VR or transfer syntax, and for pixels that do not fit their description.
 */
void
VerifyDicomFile(const std::string & fileName, std::string_view bytes);
} // namespace itk

#endif

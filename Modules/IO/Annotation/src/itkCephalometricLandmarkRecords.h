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
#ifndef itkCephalometricLandmarkRecords_h
#define itkCephalometricLandmarkRecords_h

#include "itkAnnotationRecords.h"

#include <functional>

namespace itk
{
class JsonNode;

/** Whether a name is a dental landmark's. What has another may be in a form of its own and is not looked at. */
using IsDentalLandmarkType = std::function<bool(const std::string &)>;

/** Every dental landmark of a cephalometric analysis in a file, and the names of all others in leftOut. Throws
 * DentalInputError. Not installed. */
AnnotationRecords
ReadCephalometricLandmarkRecords(const std::string &          fileName,
                                 AnnotationFileFormatEnum     format,
                                 const IsDentalLandmarkType & isDental,
                                 const std::string &          imageName);

/** The same of JSON that was read; its warnings stay with its document. */
AnnotationRecords
ReadCephalometricLandmarkRecords(const JsonNode &             root,
                                 AnnotationFileFormatEnum     format,
                                 const IsDentalLandmarkType & isDental,
                                 const std::string &          imageName);
} // namespace itk

#endif

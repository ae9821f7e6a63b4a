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
#ifndef itkForeignAnnotationRecords_h
#define itkForeignAnnotationRecords_h

#include "itkAnnotationRecords.h"

#include <cstddef>
#include <string>
#include <vector>

namespace itk
{
class JsonNode;

/** COCO, VIA, LabelStudio or Supervisely by what JSON holds, else DentalSCR; not installed. */
AnnotationFileFormatEnum
RecognizeForeignAnnotation(const JsonNode & root);

/** Throws where JSON is a program's whose files are not read, with what to export instead. */
void
RefuseUnknownAnnotation(const JsonNode & root);

/** Every polyline and every point of such a file (records.format says which), of one picture of it. Throws
 * DentalInputError. */
void
ReadForeignAnnotation(const JsonNode & root, const std::string & imageName, AnnotationRecords & records);

/** The polyline or point of a region of VIA, {"shape_attributes": {...}, "region_attributes": {...}}; what is neither
 * is warned of. */
void
ReadVIARegion(const JsonNode & region, AnnotationRecords & records);

/** Which of a file's pictures is meant: the only one, or the one with the radiograph's name. Throws DentalInputError
 * that lists them. */
std::size_t
ChooseImage(const std::string &              fileName,
            const std::string &              field,
            const std::vector<std::string> & images,
            const std::string &              imageName);
} // namespace itk

#endif

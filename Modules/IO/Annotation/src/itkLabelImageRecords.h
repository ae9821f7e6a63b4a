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
#ifndef itkLabelImageRecords_h
#define itkLabelImageRecords_h

#include "itkAnnotationRecords.h"

#include "itkImage.h"

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace itk
{
/** The outlines of the teeth in a label map of FDI numbers, or of a segmentation of 3D Slicer, whose segments have
 * names; not installed. Throws DentalInputError.
 *
 * \param imageSize Width and height of the radiograph, 0 where they are not known: of a NIfTI file that says nothing of
 * directions it tells columns from rows. */
AnnotationRecords
ReadLabelImageRecords(const std::string & fileName, const std::array<std::size_t, 2> & imageSize);

/** Files of one class each, a label and a file: of a picture the outline of what is filled, or thin lines as they were
 * drawn; of a program's file what was drawn with it. Throws DentalInputError. */
AnnotationRecords
ReadClassRecords(const std::vector<std::pair<std::string, std::string>> & files,
                 const std::string &                                      imageName,
                 const std::array<std::size_t, 2> &                       imageSize);

/** Appends the outlines of a mask as closed polylines, without the specks that a brush left; returns whether there were
 * some.
 *
 * \param offset Of the mask's first pixel in the radiograph. */
bool
AppendMaskOutlines(const Image<std::uint8_t, 2> * mask,
                   const std::array<double, 2> &  offset,
                   const std::string &            field,
                   const std::string &            label,
                   AnnotationRecords &            records);
} // namespace itk

#endif

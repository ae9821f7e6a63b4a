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
#ifndef itkAnnotationTable_h
#define itkAnnotationTable_h

#include <array>
#include <string>
#include <vector>

namespace itk
{
/** Not installed. A line of a table of points, what stands in it and where. */
struct AnnotationTableRow
{
  std::string           field;
  std::string           label;
  std::array<double, 3> point;
};

/** Every line of a table (CSV, by comma, semicolon or tab) with a label and as many coordinates as wanted, 2 in pixels
 * or 3 in mm; the columns are those of a header where there is one. Throws DentalInputError.
 *
 * \param imageName Whose lines are taken of a table of many pictures */
std::vector<AnnotationTableRow>
ReadAnnotationTable(const std::string &        fileName,
                    unsigned int               dimension,
                    const std::string &        imageName,
                    std::vector<std::string> & warnings);
} // namespace itk

#endif

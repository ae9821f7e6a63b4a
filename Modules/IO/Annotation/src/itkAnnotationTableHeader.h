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
#ifndef itkAnnotationTableHeader_h
#define itkAnnotationTableHeader_h

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace itk
{
/** Not installed. Where a table of points has what, numbers of columns from 0. */
struct TableColumns
{
  std::size_t label{ 0 };
  std::size_t first[3] = { 1, 2, 3 };
  /** Where there is one; else as many columns as coordinates. */
  std::optional<std::size_t> unit;
  /** Of the picture's name, as a table of many films has. */
  std::optional<std::size_t> picture;
  /** Of width and height beside a place: a box's, or the picture's. */
  std::optional<std::size_t> box[2];
  /** Of the depth where two coordinates are wanted. */
  std::optional<std::size_t> depth;
  /** Named by a header: further columns are nobody's business. */
  bool named{ false };
};

/** Takes the columns from a table's header; false where the line is none. Throws DentalInputError where it is one that
 * cannot be understood.
 *
 * \param field Where the line stands
 * \param dimension 2 of pixels or 3 of mm
 * \param lines What follows it: which column has the names is told by what stands there. */
bool
ReadAnnotationTableHeader(const std::string &                           fileName,
                          const std::string &                           field,
                          const std::vector<std::string> &              cells,
                          unsigned int                                  dimension,
                          const std::vector<std::vector<std::string>> & lines,
                          TableColumns &                                columns);

/** Throws where a header that was not understood says that its columns are no label and coordinates in their order. */
void
VerifyTableHeaderIsNoOther(const std::string &              fileName,
                           const std::string &              field,
                           const std::vector<std::string> & cells,
                           const TableColumns &             columns,
                           unsigned int                     dimension);
} // namespace itk

#endif

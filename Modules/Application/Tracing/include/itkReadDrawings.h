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
#ifndef itkReadDrawings_h
#define itkReadDrawings_h

#include "TracingExport.h"
#include "itkDentalCaseData.h"

#include <string>

namespace itk
{
/** \struct DrawingTexts
 * \brief What is drawn on a radiograph, as the texts of two files; "" where there is nothing.
 * \ingroup Tracing
 */
struct DrawingTexts
{
  std::string contours;  /**< Text of the file of contours. */
  std::string landmarks; /**< Text of the file of landmarks. */
  /** Written by another program: not to be saved over, since the text has not all that is in the file. */
  bool contoursAreForeign{ false };
  bool landmarksAreForeign{ false };
};

/** What a case's description names as its tracing and its landmarks, for a page to go on with. The toolkit's own files
 * are taken as they are, so that nothing in them is lost; what other programs wrote is read, and told as the toolkit
 * would have written it. `data` knows image size and markups grid. Throws DentalInputError.
 *
 * \ingroup Tracing */
Tracing_EXPORT DrawingTexts
ReadDrawings(const DentalCaseData & data, const DentalCase & description);
} // namespace itk

#endif

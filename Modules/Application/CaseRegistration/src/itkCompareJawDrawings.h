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
#ifndef itkCompareJawDrawings_h
#define itkCompareJawDrawings_h

#include "itkDentalCaseData.h"

#include <string>

namespace itk
{
/** Whether one jaw's tracing was drawn on another copy of the radiograph than
 * the other one's, or is in mm, before anything is registered: both then fail
 * under some other cause. On a copy of another size a drawing is as much
 * smaller as it is nearer to the picture's corner. A sentence that names the
 * jaw, empty where nothing is odd; where the pixel spacing, mm, is known it
 * tells mm from pixels. */
std::string
CompareJawDrawings(const DentalCaseData & data);
} // namespace itk

#endif

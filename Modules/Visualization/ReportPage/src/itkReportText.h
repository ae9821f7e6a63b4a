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
#ifndef itkReportText_h
#define itkReportText_h

#include <string>

namespace itk
{
/** For HTML and SVG, in text and between quotes. */
std::string
EscapeForPage(const std::string & text);

/** With so many digits behind the point; "" for what is not finite. */
std::string
FormatForPage(double value, int digits);
} // namespace itk

#endif

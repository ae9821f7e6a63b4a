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
#ifndef itkTracingParts_h
#define itkTracingParts_h

#include <string_view>

namespace itk
{
/** The files that a tracing page is put together from; they travel in the library (page/). */
namespace TracingParts
{
/** tracing.mustache. */
std::string_view
Template();
/** The report page's style, and what is different here. */
std::string_view
CommonStyle();
std::string_view
Style();
/** What is drawn, with its undo and its files; the picture that it is drawn on; the page around both. In this order
 * they are one script. */
std::string_view
DrawingScript();
std::string_view
PictureScript();
std::string_view
PageScript();
} // namespace TracingParts
} // namespace itk

#endif

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
#ifndef itkReportParts_h
#define itkReportParts_h

#include <string_view>

namespace itk
{
/** The files that a page is put together from; they travel in the library (page/, and what the build makes of it). */
namespace ReportParts
{
/** report.mustache, report.css. */
std::string_view
Template();
std::string_view
Style();
/** What moves the picture; needs nothing but a browser. */
std::string_view
PictureScript();
/** The same with plots and the scene, as npm and esbuild bundled it; "" where the build had neither. */
std::string_view
Bundle();
/** Names, versions and licences of what is in the bundle, a JSON list. */
std::string_view
Licences();
/** Documentation/Findings.md. */
std::string_view
Findings();
} // namespace ReportParts
} // namespace itk

#endif

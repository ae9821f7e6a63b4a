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
#ifndef itkReportModel_h
#define itkReportModel_h

#include <nlohmann/json.hpp>

#include <string>

namespace itk
{
/** What the page's template shows, as words: tables, sentences, figures with their unit. `views` is put in by the
 * writer, which draws the pictures. \param result result.json \param details report.json, or null */
nlohmann::ordered_json
MakeReportModel(const nlohmann::ordered_json & result, const nlohmann::ordered_json & details);
} // namespace itk

#endif

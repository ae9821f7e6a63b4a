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
#ifndef itkDentalCaseFileReader_h
#define itkDentalCaseFileReader_h

#include "CaseRegistrationExport.h"
#include "itkDentalCase.h"
#include "itkDentalFrameEstimator.h"
#include "itkMillimetresPerUnit.h"

namespace itk
{
/** Reads a case file. Throws DentalInputError for what makes it unusable; unknown fields become warnings. The files
 * that it names are checked to exist, not read; landmarks that stand in the case file itself are read.
 *
 * \ingroup CaseRegistration */
CaseRegistration_EXPORT DentalCase
ReadDentalCase(const std::string & fileName);

/** Whether a JSON file says what a case file says: names of scans, and what to place them by. A damaged one does not.
 * \ingroup CaseRegistration */
CaseRegistration_EXPORT bool
IsDentalCaseFile(const std::string & fileName);

/** The same of the text of a case file. Names of files are relative to the folder; messages call the text by the name
 * of its source, as "command line". \ingroup CaseRegistration */
CaseRegistration_EXPORT DentalCase
ParseDentalCase(const std::string & text, const std::string & sourceName, const std::string & folder);

/** \name A case that is yet to be drawn
 * The same, but neither scans nor tracing nor landmarks have to be named, and tracing and landmarks that are named need
 * not be there yet: they may be what the drawing is to be written to.
 * @{ */
CaseRegistration_EXPORT DentalCase
ReadDentalCaseToDraw(const std::string & fileName);
CaseRegistration_EXPORT DentalCase
ParseDentalCaseToDraw(const std::string & text, const std::string & sourceName, const std::string & folder);
/** @} */

/** Reads an alignment to start from, as the case file's "init", out of a file of its own; or takes that of an earlier
 * result (result.json, or its folder). \ingroup CaseRegistration */
CaseRegistration_EXPORT void
ReadInitialAlignment(const std::string & fileName, DentalCase & dentalCase);

/** The same of the text of a result that lies in no file; messages call it by the name of its source. A jaw that has
 * failed is no start, which is a warning. \ingroup CaseRegistration */
CaseRegistration_EXPORT void
ParseResultAsStart(const std::string & text, const std::string & sourceName, DentalCase & dentalCase);

/** \name Words of the case file and the command line
 * Each throws std::invalid_argument that names the text and what was expected.
 * @{ */
CaseRegistration_EXPORT OcclusionEnum
OcclusionFromString(const std::string & text);
/** What UMidlineDentalAxisFilter is told of it. */
CaseRegistration_EXPORT DentalFrameEnums::JawsShareFrame
                        ToJawsShareFrame(OcclusionEnum occlusion);
CaseRegistration_EXPORT CrownsEnum
CrownsFromString(const std::string & text);
/** Adds a tooth to those that are left out, by its code in the case's numbering; a code without a side (U6) is both
 * sides' tooth. */
CaseRegistration_EXPORT void
ExcludeTooth(DentalCase & dentalCase, const std::string & text);
/** Adds "scale", "rotation" or "translation" to the case's fixed parameters. */
CaseRegistration_EXPORT void
FixParameter(DentalCase & dentalCase, const std::string & text);
/** @} */

CaseRegistration_EXPORT const char *
ToString(OcclusionEnum occlusion);
CaseRegistration_EXPORT const char *
ToString(CrownsEnum crowns);
} // namespace itk

#endif

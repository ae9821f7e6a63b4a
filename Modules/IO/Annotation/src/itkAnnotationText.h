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
#ifndef itkAnnotationText_h
#define itkAnnotationText_h

#include "itkToothCode.h"

#include <string>
#include <vector>

namespace itk
{
/** \name Cells of a table in a text file; not installed
 * @{ */
bool
EndsWith(const std::string & text, const std::string & end);

/** Without blanks around it, and then without a pair of quotes. */
std::string
Trim(const std::string & text);

/** Cells of a line, trimmed. A cell in quotes may hold the separator, as spreadsheets write it. */
std::vector<std::string>
Split(const std::string & line, char separator);

/** Whether the whole text is one finite number with a decimal point. */
bool
ParseNumber(const std::string & text, double & value);
/** The same, or one with a decimal comma and no point: half of Europe's spreadsheets write them. */
bool
ParseTableNumber(const std::string & text, double & value);

/** Throws where a file of no form that is known by its content does not begin as JSON either: "JSON syntax error" helps
 * nobody who named a file of another program. Files of blanks alone pass. */
void
RequireJsonBeginning(const std::string & fileName);

/** Names in one line; of a long list only the beginning, as 29 names are nothing that anybody reads. */
std::string
ListNames(const std::vector<std::string> & names);

/** Whether a label names a tooth or a jaw, in whatever numbering and spelling. */
bool
NamesToothOrJaw(const std::string & label);

/** A name of a point of a tooth, in whatever spelling of the tooth and with a blank, "-" or "_" before the point, as
 * programs write it: "UR6_MB" of "1.6_MB", "tooth 16_MB", "#16-MB" or "16 MB". Any other text comes back as it is. */
std::string
SpellPointOfTooth(const std::string & name, ToothCode::NumberingEnum numbering);

/** Whether DentalLandmarkSet takes a name. */
bool
IsDentalLandmarkName(const std::string & name);

/** Whether a name is one of these whose point is one that landmarks have. */
bool
NamesPointOfTooth(const std::string & name);

/** Of several labels of one thing the first that names a tooth or a jaw, else the first; "" where there is none. */
std::string
ChooseLabel(const std::vector<std::string> & labels);

/** The same of a point: the first that names a point of a tooth goes before one that names a tooth. */
std::string
ChoosePointLabel(const std::vector<std::string> & labels);
/** @} */
} // namespace itk

#endif

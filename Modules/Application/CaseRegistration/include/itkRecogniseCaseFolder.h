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
#ifndef itkRecogniseCaseFolder_h
#define itkRecogniseCaseFolder_h

#include "CaseRegistrationExport.h"

#include <string>
#include <utility>
#include <vector>

namespace itk
{
/** \struct RecognisedCase
 * \brief What the files of a folder are taken for, and why.
 * \ingroup CaseRegistration
 */
struct RecognisedCase
{
  /** Field of a case file ("upper", "cephalogram.image"; of a frontal radiograph "views.frontal.contours") and the
   * file, as it can be opened from here; in the order of the fields. */
  std::vector<std::pair<std::string, std::string>> files;
  /** A sentence for each file that was looked at, and for what is still to be given. */
  std::vector<std::string> notes;

  /** "" where there is none. */
  std::string
  Find(const std::string & field) const;
};

/** Looks at the files of one folder, not at the folders in it.
 *
 * A scan's jaw is told by whole words of its name, as the makers of scanners write them, never by a letter: "upper" in
 * "UpperJawScan" is one, the u of "uno.stl" is none; of single letters those of iTero's "shell_occlusion_u" alone
 * count. Tracings and landmarks are told by what is in them, and by a word such as "frontal" that they were drawn on
 * the frontal one of two radiographs. Of two files that could be the same thing neither is taken, and the notes say so.
 * Throws DentalInputError where there is no such folder.
 *
 * \ingroup CaseRegistration */
CaseRegistration_EXPORT RecognisedCase
RecogniseCaseFolder(const std::string & folder);
} // namespace itk

#endif

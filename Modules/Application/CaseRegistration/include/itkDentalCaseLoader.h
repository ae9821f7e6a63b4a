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
#ifndef itkDentalCaseLoader_h
#define itkDentalCaseLoader_h

#include "CaseRegistrationExport.h"
#include "itkAnnotationFileReaderBase.h"
#include "itkDentalCaseData.h"

#include <memory>

namespace itk
{
/** Reads every file that the case names but its 2-D landmarks: scans (converted to mm), tracing, landmarks to register
 * with, radiograph, 3-D landmarks; settles the nominal geometry by case file, DICOM, default, in that order. Throws
 * DentalInputError.
 *
 * \ingroup CaseRegistration */
CaseRegistration_EXPORT std::shared_ptr<DentalCaseData>
                        LoadDentalCase(const DentalCase & description);

/** Of that the second part alone, for who draws on: reads the tracing and the landmarks to register with that the
 * description names and settles the traced side. What was drawn before must not be in the data; their geometry is
 * changed where a ruler was drawn, and must be their own.
 *
 * \ingroup CaseRegistration */
CaseRegistration_EXPORT void
LoadCaseDrawings(DentalCaseData & data);

/** Tells a reader of files on a radiograph what a case knows of it: its name, and how many mm a pixel markups have.
 *
 * \ingroup CaseRegistration */
CaseRegistration_EXPORT void
PrepareReader(const DentalRadiograph &     description,
              const DentalRadiographData & data,
              AnnotationFileReaderBase &   reader);

/** Of a view's geometry that is not known, what is likely, with a warning for each: a view is registered with a
 * complete one, and corrects it. Where the sources of its values do not say that its principal point is known, that is
 * the picture's middle, to a tenth of its width; without a spacing it begins with the first radiograph's, else with
 * 0.25 mm.
 *
 * \ingroup CaseRegistration */
CaseRegistration_EXPORT void
CompleteViewGeometry(const DentalCaseData & data, DentalViewData & view, std::vector<std::string> & warnings);

/** What was drawn but of the teeth that the case excludes.
 *
 * \ingroup CaseRegistration */
CaseRegistration_EXPORT DentalContour::Pointer
                        WithoutTeeth(const DentalContour & contour, const std::vector<ToothCode> & teeth);

/** Throws DentalInputError for a landmark that lies outside the image by more than a tenth of it: a hand or a detector
 * misses by less, a wrong unit or another copy of the image by more. `prefix` stands before the landmark's name in the
 * field of the error.
 *
 * \ingroup CaseRegistration */
CaseRegistration_EXPORT void
CheckLandmarksInImage(const CephalometricLandmarkSet &    landmarks,
                      const std::array<unsigned int, 2> & imageSize,
                      const std::string &                 fileName,
                      const std::string &                 prefix);

/** Which side was traced, where the case does not give it, and the tracing without the other side's teeth, as
 * TracedSideFilter decides it; with warnings of what was decided and left out.
 *
 * \ingroup CaseRegistration */
CaseRegistration_EXPORT void
SettleTracedSide(DentalCaseData & data);
} // namespace itk

#endif

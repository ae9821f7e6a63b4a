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
#ifndef itkReadTransformText_h
#define itkReadTransformText_h

#include "CaseRegistrationExport.h"

#include <string>

namespace itk
{
/** The text of a transform in ITK's own format (.tfm, .txt), looked at line by line and written anew: ITK's reader runs
 * past the end of parameters that are too few, and of what has no colon. One transform is read, a
 * Similarity2DTransform, a VersorRigid3DTransform or a CephalometricPoseTransform, with as many finite numbers as it
 * has. Throws DentalInputError.
 *
 * \ingroup CaseRegistration */
CaseRegistration_EXPORT std::string
                        ReadTransformText(const std::string & fileName);
} // namespace itk

#endif

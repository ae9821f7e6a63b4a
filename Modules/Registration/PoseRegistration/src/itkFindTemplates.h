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
#ifndef itkFindTemplates_h
#define itkFindTemplates_h

#include "itkPoseProblem.h"
#include "itkToothOutlineComparison.h"

#include <vector>

namespace itk
{
/** Not installed. The outlines of whole teeth of a problem's jaws that are one stock outline, moved: of another tooth
 * of the tracing, or of the problem's stock. Named "U1", "L6". Lengths are taken with the geometry's pixel spacing. */
std::vector<ToothOutlineComparison::TemplateType>
FindTemplates(const PoseProblem & problem, const PoseGeometry & geometry);
} // namespace itk

#endif

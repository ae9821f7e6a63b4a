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
#ifndef itkUnusedCaseControls_h
#define itkUnusedCaseControls_h

#include "itkCaseResult.h"
#include "itkDentalCaseData.h"

#include <string>
#include <vector>

namespace itk
{
/** What of a registration's settings only some presets heed, beside what the case says. Not installed. */
struct CaseControls
{
  /** False where somebody asked for the silhouette of the mesh itself. */
  bool useSurfaceDRR{ true };
  /** "NAME=VALUE" of the ingredients of preset Robust that are not the default. */
  std::vector<std::string> options;
  bool                     hasPoseMethodCallback{ false };
};

/** What of a case and of its registration's settings a preset has no use for, a sentence each: whoever holds, gives or
 * asks for something is not to believe that it was done. What describes the drawing and is no request, as the traced
 * side, is not among it. */
std::vector<std::string>
DescribeUnusedControls(const DentalCaseData & data, CasePresetEnum preset, const CaseControls & controls);
} // namespace itk

#endif

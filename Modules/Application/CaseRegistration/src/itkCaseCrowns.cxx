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
#include "itkCaseCrowns.h"

#include "itkCrownRegionKernel.h"
#include "itkDentalInputError.h"
#include "itkKeepTriangles.h"

namespace itk
{
TriangleSurface
SelectCaseCrowns(const DentalCaseData &  data,
                 ToothCode::JawEnum      jaw,
                 const DentalJawFrame &  frame,
                 const TriangleSurface & surface)
{
  const bool upper = jaw == ToothCode::JawEnum::Upper;
  const bool byLabels = data.description.crowns == CrownsEnum::Labels;
  const auto region = byLabels ? CrownRegionFromLabels(surface, data.GetJaw(jaw).labels)
                               : ComputeCrownRegion(surface, upper, frame.axes, frame.origin);
  if (!region.valid)
  {
    itkDentalInputErrorMacro(upper ? data.description.upperFile : data.description.lowerFile,
                             "",
                             byLabels ? "its labels name no tooth" : "no crowns were found in it by shape",
                             "leave \"crowns\" out of the case file");
  }
  return KeepTriangles(surface, region.triangles);
}
} // namespace itk

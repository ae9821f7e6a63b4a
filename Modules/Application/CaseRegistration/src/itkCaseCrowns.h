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
#ifndef itkCaseCrowns_h
#define itkCaseCrowns_h

#include "itkCasePoseDescription.h"
#include "itkDentalCaseData.h"

#include "itkToothCrownSet.h"
#include "itkVersorRigid3DTransform.h"

#include <string>
#include <vector>

namespace itk
{
/** The crowns of a jaw as the case wants them found, by CrownRegionMeshFilter; throws a DentalInputError where there
 * are none. The transform is that of the jaw's dental frame, mesh to frame. */
DentalCaseData::MeshType::Pointer
SelectCaseCrowns(const DentalCaseData & data, ToothCode::JawEnum jaw, const VersorRigid3DTransform<double> * frame);

/** The crowns of the teeth that were drawn one by one, in a standard tracing or on a frontal radiograph, cut out of the
 * scans; null where no tooth was. Landmarks of the scans with these names are used for none. */
ToothCrownSet::Pointer
FindCaseToothCrowns(const DentalCaseData &           data,
                    CaseAxisType *                   axis,
                    const std::vector<std::string> & unusableLandmarks);
} // namespace itk

#endif

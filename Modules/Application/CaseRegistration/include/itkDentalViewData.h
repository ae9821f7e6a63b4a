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
#ifndef itkDentalViewData_h
#define itkDentalViewData_h

#include "itkDentalRadiographData.h"
#include "itkDentalView.h"

#include "itkDentalContour.h"
#include "itkToothCode.h"

#include <array>

namespace itk
{
/** \struct DentalViewData
 * \brief A further radiograph in memory: what was drawn on it, and its geometry with the origin of each value.
 * \ingroup CaseRegistration
 */
struct DentalViewData : public DentalRadiographData
{
  DentalView description; /**< What the case file says of the view. */
  /** px. */
  double principalPointSigma{ 4.0 };
  /** Upper, lower; null where nothing was drawn. */
  std::array<DentalContour::Pointer, 2> contours;

  /** What was drawn of a jaw; null where nothing was. */
  const DentalContour *
  GetContour(ToothCode::JawEnum jaw) const
  {
    return contours[jaw == ToothCode::JawEnum::Lower ? 1 : 0];
  }
};
} // namespace itk

#endif

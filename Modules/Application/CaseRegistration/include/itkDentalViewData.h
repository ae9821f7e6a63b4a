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

#include "itkDentalView.h"
#include "itkValueSource.h"

#include "itkDentalContour.h"
#include "itkDentalLandmarkSet.h"
#include "itkImage.h"
#include "itkScalePrior.h"
#include "itkToothCode.h"

#include <array>
#include <string>

namespace itk
{
/** \struct DentalViewData
 * \brief A further radiograph in memory: what was drawn on it, and its geometry with the origin of each value.
 * \ingroup CaseRegistration
 */
struct DentalViewData
{
  using ImageType = Image<float, 2>;

  DentalView description;
  /** Null without a picture. */
  ImageType::Pointer          image;
  std::array<unsigned int, 2> imageSize{ { 0, 0 } };
  /** Complete, identity pose. */
  CephalometricGeometry::Pointer geometry;
  /** Of the distances, of where the patient's left (or face) and the source are, and of pixel spacing and principal
   * point. */
  ValueSourceEnum sourceToEarRods{ ValueSourceEnum::Default };
  ValueSourceEnum sourceToDetector{ ValueSourceEnum::Default };
  ValueSourceEnum side{ ValueSourceEnum::Default };
  ValueSourceEnum source{ ValueSourceEnum::Default };
  ValueSourceEnum pixelSpacing{ ValueSourceEnum::Estimated };
  ValueSourceEnum principalPoint{ ValueSourceEnum::Estimated };
  /** How spacing and direction came about, in words. */
  std::string spacingProvenance;
  std::string directionProvenance;
  /** px. */
  double                    principalPointSigma{ 4.0 };
  ScalePrior::SpacingSource spacingSource{ ScalePrior::SpacingSource::Given };
  /** Upper, lower; null where nothing was drawn. */
  std::array<DentalContour::Pointer, 2> contours;
  CephalometricLandmarkSet::Pointer     landmarks;

  const DentalContour *
  GetContour(ToothCode::JawEnum jaw) const
  {
    return contours[jaw == ToothCode::JawEnum::Lower ? 1 : 0];
  }
};
} // namespace itk

#endif

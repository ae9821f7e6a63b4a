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
#ifndef itkDentalView_h
#define itkDentalView_h

#include "CaseRegistrationExport.h"
#include "itkDentalRadiograph.h"

#include <optional>
#include <string>

namespace itk
{
/** \struct DentalView
 * \brief A further radiograph of a case, as its case file says it ("views").
 * \ingroup CaseRegistration
 */
struct DentalView : public DentalRadiograph
{
  std::string                          name; /**< Names the view. */
  CephalometricGeometry::DirectionEnum direction{ CephalometricGeometry::DirectionEnum::Frontal }; /**< From where. */

  /** Frontal: where the patient's left and the source are. */
  std::optional<CephalometricGeometry::PatientLeftEnum>   patientLeft;
  std::optional<CephalometricGeometry::FrontalSourceEnum> frontalSource;
  /** px. */
  std::optional<double> principalPointSigma;
  bool                  sameHeadPosition{ true };
};

/** Whether a view may be called so: its name stands in results, messages and file names, and has at most 40 letters,
 * digits, "-" and "_".
 *
 * \ingroup CaseRegistration */
CaseRegistration_EXPORT bool
IsViewName(const std::string & name);
} // namespace itk

#endif

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
#ifndef itkOtherFacingHypothesis_h
#define itkOtherFacingHypothesis_h

#include "itkPoseHypothesis.h"

namespace itk
{
/** \class OtherFacingHypothesis
 * \brief The patient faces the other way: where the fit is poor, the other facing is tried.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT OtherFacingHypothesis : public PoseHypothesis
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(OtherFacingHypothesis);

  using Self = OtherFacingHypothesis;
  using Superclass = PoseHypothesis;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(OtherFacingHypothesis, PoseHypothesis);
  /** Of the finding where it is likelier than what was said. */
  static constexpr const char * Code = "facing";

  /** "facing" */
  std::string
  GetCode() const override;
  bool
  IsWorthTrying(const PoseProblem & problem, const PoseGroupResult & result) const override;
  /** A term of the user's has a radiograph of its own (PoseMetricv4), which would go on facing as it did. Any other may
   * stay: it is about the patient, and the frames are the same. */
  std::string
  GetObstacle(const PoseProblem & problem) const override;
  PoseProblem
  Apply(const PoseProblem & problem) const override;

protected:
  OtherFacingHypothesis() = default;
  ~OtherFacingHypothesis() override = default;
};
} // namespace itk

#endif

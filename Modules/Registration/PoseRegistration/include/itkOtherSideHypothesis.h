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
#ifndef itkOtherSideHypothesis_h
#define itkOtherSideHypothesis_h

#include "itkPoseHypothesis.h"

namespace itk
{
/** \class OtherSideHypothesis
 * \brief The other side's outline was traced: registers the tracing to it and compares the likelihoods.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT OtherSideHypothesis : public PoseHypothesis
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(OtherSideHypothesis);

  using Self = OtherSideHypothesis;
  using Superclass = PoseHypothesis;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(OtherSideHypothesis, PoseHypothesis);
  /** Of the finding where it is likelier than what was said. */
  static constexpr const char * Code = "other-side";

  /** "other-side" */
  std::string
  GetCode() const override;
  bool
  IsWorthTrying(const PoseProblem & problem, const PoseGroupResult & result) const override;
  /** The tracing is of no side, or sides are not selected. Terms of the user's may stay: frames and radiograph are the
   * same. */
  std::string
  GetObstacle(const PoseProblem & problem) const override;
  PoseProblem
  Apply(const PoseProblem & problem) const override;
  bool
  GetComparesDeviance() const override
  {
    return true;
  }

protected:
  OtherSideHypothesis() = default;
  ~OtherSideHypothesis() override = default;
};
} // namespace itk

#endif

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
#ifndef itkOtherSpacingHypothesis_h
#define itkOtherSpacingHypothesis_h

#include "itkPoseHypothesis.h"

namespace itk
{
/** \class OtherSpacingHypothesis
 * \brief The pixel spacing is not the one that was given: where nothing fits, the scale is left to the fit.
 *
 * A spacing in cm, of another resolution (300 dpi), or of the radiograph before it was halved, makes a jaw of another
 * size, and every reason that the fit then has against itself is a wrong one. The outcome's pixelSpacing is what the
 * spacing would have to be.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT OtherSpacingHypothesis : public PoseHypothesis
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(OtherSpacingHypothesis);

  using Self = OtherSpacingHypothesis;
  using Superclass = PoseHypothesis;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(OtherSpacingHypothesis, PoseHypothesis);
  /** Of the finding where it is likelier than what was said. */
  static constexpr const char * Code = "pixel-spacing";

  /** "pixel-spacing" */
  std::string
  GetCode() const override;
  bool
  IsWorthTrying(const PoseProblem & problem, const PoseGroupResult & result) const override;
  /** A term of the user's that projects has a spacing of its own. */
  std::string
  GetObstacle(const PoseProblem & problem) const override;
  PoseProblem
  Apply(const PoseProblem & problem) const override;

protected:
  OtherSpacingHypothesis() = default;
  ~OtherSpacingHypothesis() override = default;
};
} // namespace itk

#endif

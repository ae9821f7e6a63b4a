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
#ifndef itkUpwardDrawingHypothesis_h
#define itkUpwardDrawingHypothesis_h

#include "itkPoseHypothesis.h"

namespace itk
{
/** \class UpwardDrawingHypothesis
 * \brief The rows of the drawing were counted from below: where a tracing does not fit, it is tried with above and
 * below exchanged, and what landmarks there are with it.
 *
 * Programs that plot, and coordinates in mm, have their origin at the bottom left, images theirs at the top left. By
 * how much the drawing lies elsewhere then is the start's to find, so that the height of the radiograph does not
 * matter, and so is its scale: the outcome's pixel spacing is 1 where it is in mm. The principal point is not used, as
 * it was given in either way.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT UpwardDrawingHypothesis : public PoseHypothesis
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(UpwardDrawingHypothesis);

  using Self = UpwardDrawingHypothesis;
  using Superclass = PoseHypothesis;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(UpwardDrawingHypothesis, PoseHypothesis);

  /** Of the hypothesis, and of the verdict's finding. */
  static constexpr const char * Code = "upward-drawing";

  std::string
  GetCode() const override;
  bool
  IsWorthTrying(const PoseProblem & problem, const PoseGroupResult & result) const override;
  /** A term of the user's that projects was drawn on a radiograph of its own. */
  std::string
  GetObstacle(const PoseProblem & problem) const override;
  PoseProblem
  Apply(const PoseProblem & problem) const override;

protected:
  UpwardDrawingHypothesis() = default;
  ~UpwardDrawingHypothesis() override = default;
};
} // namespace itk

#endif

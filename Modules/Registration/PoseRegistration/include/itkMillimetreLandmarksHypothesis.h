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
#ifndef itkMillimetreLandmarksHypothesis_h
#define itkMillimetreLandmarksHypothesis_h

#include "itkPoseHypothesis.h"

namespace itk
{
/** \class MillimetreLandmarksHypothesis
 * \brief The landmarks are in millimetres, not in pixels: where landmarks alone do not fit, their places are tried as
 * those of the pixel spacing that was given.
 *
 * Programs that show an image with its spacing save millimetres from the centre of its first pixel. Where no spacing is
 * known the landmarks' own scale is the fit's, and a radiograph that would be metres long says so.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT MillimetreLandmarksHypothesis : public PoseHypothesis
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(MillimetreLandmarksHypothesis);

  using Self = MillimetreLandmarksHypothesis;
  using Superclass = PoseHypothesis;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(MillimetreLandmarksHypothesis, PoseHypothesis);
  /** Of the finding where it is likelier than what was said. */
  static constexpr const char * Code = "landmarks-mm";

  /** "landmarks-mm" */
  std::string
  GetCode() const override;
  bool
  IsWorthTrying(const PoseProblem & problem, const PoseGroupResult & result) const override;
  PoseProblem
  Apply(const PoseProblem & problem) const override;

protected:
  MillimetreLandmarksHypothesis() = default;
  ~MillimetreLandmarksHypothesis() override = default;
};
} // namespace itk

#endif

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
#ifndef itkExchangedLandmarksHypothesis_h
#define itkExchangedLandmarksHypothesis_h

#include "itkPoseHypothesis.h"

namespace itk
{
/** \class ExchangedLandmarksHypothesis
 * \brief The landmarks' names are of the other jaw: where landmarks alone place two jaws and do not fit well, each is
 * tried as the same point of the other one.
 *
 * The tips of upper and lower incisors are 2 to 5 mm apart, and so are the first molars' cusps, in directions that no
 * turn of the head undoes. A single jaw, or jaws apart, fit either way: two points fit anything. So do front teeth
 * alone, or those behind alone, whose turn is free.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT ExchangedLandmarksHypothesis : public PoseHypothesis
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ExchangedLandmarksHypothesis);

  using Self = ExchangedLandmarksHypothesis;
  using Superclass = PoseHypothesis;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(ExchangedLandmarksHypothesis, PoseHypothesis);
  /** Of the finding where it is likelier than what was said. */
  static constexpr const char * Code = "landmarks-exchanged";

  /** Score of landmarks from which on it is worth trying. Of readers' marks the score is 0.05 on average; a clear gain
   * of the other reading leaves none below this. */
  static constexpr double PoorScore = 0.08;

  /** "landmarks-exchanged" */
  std::string
  GetCode() const override;
  bool
  IsWorthTrying(const PoseProblem & problem, const PoseGroupResult & result) const override;
  /** Marks of front teeth alone or of those behind alone. */
  std::string
  GetObstacle(const PoseProblem & problem) const override;
  PoseProblem
  Apply(const PoseProblem & problem) const override;

protected:
  ExchangedLandmarksHypothesis() = default;
  ~ExchangedLandmarksHypothesis() override = default;
};
} // namespace itk

#endif

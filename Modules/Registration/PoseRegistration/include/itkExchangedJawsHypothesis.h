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
#ifndef itkExchangedJawsHypothesis_h
#define itkExchangedJawsHypothesis_h

#include "itkPoseHypothesis.h"

namespace itk
{
/** \class ExchangedJawsHypothesis
 * \brief Upper and lower scan were exchanged: where the fit is poor, each tracing is tried on the other jaw.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT ExchangedJawsHypothesis : public PoseHypothesis
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ExchangedJawsHypothesis);

  using Self = ExchangedJawsHypothesis;
  using Superclass = PoseHypothesis;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(ExchangedJawsHypothesis, PoseHypothesis);
  /** Of the finding where it is likelier than what was said. */
  static constexpr const char * Code = "jaws-exchanged";

  /** "jaws-exchanged" */
  std::string
  GetCode() const override;
  bool
  IsWorthTrying(const PoseProblem & problem, const PoseGroupResult & result) const override;
  /** There are not two jaws with a tracing, or a term of the user's reads their pose: it is about a dental frame that
   * turns over with the jaws. */
  std::string
  GetObstacle(const PoseProblem & problem) const override;
  PoseProblem
  Apply(const PoseProblem & problem) const override;

protected:
  ExchangedJawsHypothesis() = default;
  ~ExchangedJawsHypothesis() override = default;
};
} // namespace itk

#endif

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
#ifndef itkPoseHypothesis_h
#define itkPoseHypothesis_h

#include "PoseRegistrationExport.h"
#include "itkPoseProblem.h"

#include "itkObject.h"

#include <string>

namespace itk
{
/** \class PoseHypothesis
 * \brief Another reading of the same input, tried beside the result to name a likely mistake.
 *
 * A hypothesis turns the question into another one, which PoseRegistrationMethod answers quickly. What came of it
 * stands in the result under the hypothesis' code, whoever wrote it: PoseGroupResult::FindOutcome().
 * RegistrationVerdict names those of the toolkit that explain the evidence better; what a user's own means is for the
 * user to say, by comparing its score with the group's or by its deviance.
 *
 * PoseRegistrationMethodBase::TryHypothesis() runs one alone, however good the fit is, and gives its outcome.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT PoseHypothesis : public Object
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(PoseHypothesis);

  using Self = PoseHypothesis;
  using Superclass = Object;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkTypeMacro(PoseHypothesis, Object);

  /** What came of it. */
  using OutcomeType = PoseHypothesisOutcome;

  /** Short and stable, as the verdict's codes: "facing". The key of its outcome: those of one method differ. */
  virtual std::string
  GetCode() const = 0;

  /** Whether to try it. It is never tried beside a given start or held values: any free search would look better. */
  virtual bool
  IsWorthTrying(const PoseProblem & problem, const PoseGroupResult & result) const = 0;

  /** Why the question cannot be asked of this problem, as the rest of a sentence; empty, as by default, where it can.
   * A term of the user's that would mean something else under the hypothesis is such a reason, unless Apply() exchanges
   * it or leaves it out: a trial against a term that is about another frame fails whatever the truth is. Where the
   * hypothesis is worth trying, the reason stands in PoseGroupResult::untried and among what the verdict calls not
   * checkable. */
  virtual std::string
  GetObstacle(const PoseProblem & problem) const;

  /** The other question. The problem is that of one group. */
  virtual PoseProblem
  Apply(const PoseProblem & problem) const = 0;

  /** Whether the deviance is wanted, which takes another estimate of the noise of both. */
  virtual bool
  GetComparesDeviance() const
  {
    return false;
  }

  /** Whether the other question is about a part of the evidence that the solution does not hang on, so that it begins
   * at the solution instead of with a search. */
  virtual bool
  GetBeginsAtSolution() const
  {
    return false;
  }

protected:
  PoseHypothesis() = default;
  ~PoseHypothesis() override = default;

  /** The options of a quick search: one yaw, few evaluations, no hypotheses of its own. */
  static PoseRegistrationOptions
  MakeQuickOptions(const PoseRegistrationOptions & options, unsigned int maximumEvaluations);
};
} // namespace itk

#endif

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
#ifndef itkOtherViewHypothesis_h
#define itkOtherViewHypothesis_h

#include "itkPoseHypothesis.h"

namespace itk
{
/** \class OtherViewHypothesis
 * \brief A further view was taken otherwise than said: the patient's sides exchanged in it, the source on the other
 * side of the head, or the head turned in the ear rods between the two.
 *
 * It begins at the solution, which hangs on the first view, and asks whether what was drawn on the other one is
 * explained better: its deviance is that of the robust criterion, in which what fits nowhere costs what the kernel
 * charges.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT OtherViewHypothesis : public PoseHypothesis
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(OtherViewHypothesis);

  using Self = OtherViewHypothesis;
  using Superclass = PoseHypothesis;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(OtherViewHypothesis, PoseHypothesis);
  /** What may have been otherwise. */
  enum class QuestionEnum : std::uint8_t
  {
    /** The picture is mirrored against what was said: right and left exchanged, or the face the other way. */
    Sides,
    /** Front for back, or right for left. */
    Source,
    /** The head was turned between the radiographs, of a view that was said to be taken with it held still. */
    Head
  };
  itkSetEnumMacro(Question, QuestionEnum);
  itkGetEnumMacro(Question, QuestionEnum);

  /** Name of the view. */
  itkSetStringMacro(View);
  itkGetStringMacro(View);

  /** "view-sides:frontal", "view-source:frontal", "view-head-moved:frontal" */
  static std::string
  MakeCode(QuestionEnum question, const std::string & view);
  std::string
  GetCode() const override;
  bool
  IsWorthTrying(const PoseProblem & problem, const PoseGroupResult & result) const override;
  std::string
  GetObstacle(const PoseProblem & problem) const override;
  PoseProblem
  Apply(const PoseProblem & problem) const override;
  bool
  GetComparesDeviance() const override
  {
    return true;
  }
  bool
  GetBeginsAtSolution() const override
  {
    return true;
  }

protected:
  OtherViewHypothesis() = default;
  ~OtherViewHypothesis() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  QuestionEnum m_Question{ QuestionEnum::Sides };
  std::string  m_View;
};
} // namespace itk

#endif

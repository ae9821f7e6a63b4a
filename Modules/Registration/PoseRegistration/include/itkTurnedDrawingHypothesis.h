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
#ifndef itkTurnedDrawingHypothesis_h
#define itkTurnedDrawingHypothesis_h

#include "itkPoseHypothesis.h"

namespace itk
{
/** \class TurnedDrawingHypothesis
 * \brief The radiograph was turned by quarter turns before, or after, it was drawn on: where a tracing does not fit, it is
 * tried turned back, and what landmarks there are with it.
 *
 * Scanned films lie on their side, cameras write the orientation beside the pixels, and programs differ in whether they
 * heed it. Turned by so much nothing of a head fits within what is searched. Where the principal point is known it is
 * not used: it was given in pixels of an image that may have been turned as well.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT TurnedDrawingHypothesis : public PoseHypothesis
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(TurnedDrawingHypothesis);

  using Self = TurnedDrawingHypothesis;
  using Superclass = PoseHypothesis;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(TurnedDrawingHypothesis, PoseHypothesis);

  /** What GetCode() starts with. */
  static constexpr const char * Code = "turned-";

  /** By how many quarter turns, clockwise as it is seen, the drawing is turned back: 1, 2 (default) or 3. */
  void
  SetQuarterTurns(unsigned int turns);
  itkGetConstMacro(QuarterTurns, unsigned int);

  /** "turned-90", "turned-180", "turned-270". */
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
  TurnedDrawingHypothesis() = default;
  ~TurnedDrawingHypothesis() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  unsigned int m_QuarterTurns{ 2 };
};
} // namespace itk

#endif

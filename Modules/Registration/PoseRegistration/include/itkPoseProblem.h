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
#ifndef itkPoseProblem_h
#define itkPoseProblem_h

#include "itkLeastSquaresMetricv4.h"
#include "itkPoseRegistrationTypes.h"
#include "itkToothOutlinePoseMetricv4.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace itk
{
/** \struct PoseProblemTerm
 * \brief A further term of the sum that is minimized, and the jaw whose sum it belongs to; Unknown: to every sum.
 * \ingroup PoseRegistration
 */
struct PoseProblemTerm
{
  LeastSquaresMetricv4::Pointer metric; /**< Its residuals are divided by their standard deviations. */
  ToothCode::JawEnum            jaw{ ToothCode::JawEnum::Unknown }; /**< Unknown: every jaw's sum has it. */
};

/** \struct PoseViewInput
 * \brief A further view, as CephalogramView has it. Drawings by jaw: upper, lower.
 * \ingroup PoseRegistration
 */
struct PoseViewInput
{
  std::string                                name;      /**< Names the view in results and findings. */
  PoseGeometry                               geometry;  /**< Of the view's own radiograph. */
  std::array<DentalContour::ConstPointer, 2> tracings;  /**< Upper and lower, continuous pixel indices; null: none. */
  CephalometricLandmarkSet::ConstPointer     landmarks; /**< Marked on the view; null where none were. */
  LandmarkCounterpartSet::ConstPointer       counterparts; /**< Where these are on the scans; null where none were. */
  bool sameHeadPosition{ true }; /**< Whether the head was held as for the lateral radiograph. */
  /** px, 1 sd an axis. */
  double principalPointSigma{ 4.0 };
  double kappaSigma{ 0.016 };
};

/** \struct PoseProblem
 * \brief A question to a pose registration: the jaws, the geometry, how to go about it.
 * \ingroup PoseRegistration
 */
struct PoseProblem
{
  std::vector<PoseJawInput> jaws; /**< One or two, upper first. */
  /** As it is known. */
  PoseGeometry nominal;
  /** With what was not known filled in: made from the jaws where absent. */
  std::optional<PoseGeometry> completed;
  /** The geometry that the jaws' starts are of, where it is another than the nominal one. What the nominal one does not
   * know is as this one has it where something is held, and estimated anew where nothing is. */
  std::optional<PoseGeometry> initialGeometry;
  PoseRegistrationOptions     options;
  /** What a user has added to the jaws' own evidence. A hypothesis under which one of them would mean something else
   * exchanges it or leaves it out, or says that it cannot be asked (PoseHypothesis::GetObstacle()). */
  std::vector<PoseProblemTerm> terms;
  /** Outlines that a reader's software may have put in place of a drawn one: closed lines of any size, of which the
   * teeth of a standard tracing are told to be templates (ToothOutlineComparison). Null: none. */
  DentalContour::ConstPointer stockOutlines;
  /** How the outlines of a standard tracing were drawn. */
  ToothOutlinePoseMetricv4::DrawingEnum drawing{ ToothOutlinePoseMetricv4::DrawingEnum::Unknown };
  /** Views beside the first. */
  std::vector<PoseViewInput> views;
};
} // namespace itk

#endif

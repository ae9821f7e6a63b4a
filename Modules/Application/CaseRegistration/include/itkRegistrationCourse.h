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
#ifndef itkRegistrationCourse_h
#define itkRegistrationCourse_h

#include "itkToothCode.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace itk
{
/** \struct RegistrationStep
 * \brief A step that an optimizer tried.
 * \ingroup CaseRegistration
 */
struct RegistrationStep
{
  /** Of the criterion as it was for this step: kernel width and noise levels change from step to step, and values of
   * different widths are not to be compared. */
  double value{ 0.0 };
  bool   accepted{ false };
  /** How far the step moves the outline, pixels of 0.25 mm; 0 where the method does not know. */
  double length{ 0.0 };
  /** Kernel width, pixels of 0.25 mm; 0 where the method has none. */
  double width{ 0.0 };
};

/** \struct RegistrationCandidateCourse
 * \brief How one candidate went through one stage.
 * \ingroup CaseRegistration
 */
struct RegistrationCandidateCourse
{
  /** As the method numbers them. */
  unsigned int                  candidate{ 0 };
  std::vector<RegistrationStep> steps;
  /** Parameters of the transform after the first and after the last step. */
  std::vector<double> first;
  std::vector<double> last;
  /** Whether the solution came this way. */
  bool chosen{ false };
};

/** \struct RegistrationStageCourse
 * \brief One stage (level) of a registration: its candidates and why the one that was chosen ended.
 * \ingroup CaseRegistration
 */
struct RegistrationStageCourse
{
  /** The jaws that share the pose. */
  std::vector<ToothCode::JawEnum> jaws;
  /** "start", "candidates", "refinement"; "level 1" and so on of the paper's chain. */
  std::string name;
  /** Empty where it is not known. */
  std::string                              stopCondition;
  std::vector<RegistrationCandidateCourse> candidates;
};

/** \struct RegistrationStagePlacement
 * \brief Where a jaw was when a stage began, on the way that led to the solution. One of the two is there.
 * \ingroup CaseRegistration
 */
struct RegistrationStagePlacement
{
  std::string name; /**< What the step is called in the report. */
  /** As JawResult::projection. */
  std::optional<std::array<double, 12>> projection;
  /** Scale, rotation (rad), translation (px): as JawResult::similarity. */
  std::optional<std::array<double, 4>> similarity;
};
} // namespace itk

#endif

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
#ifndef itkViewVerdict_h
#define itkViewVerdict_h

#include "PoseRegistrationExport.h"
#include "itkPoseRegistrationTypes.h"
#include "itkRegistrationFinding.h"

#include <cstddef>
#include <vector>

namespace itk
{
/** \class ViewVerdict
 * \brief Whether a further view agrees with the first one, with findings: what was drawn on it against where the jaws
 * are.
 *
 * A view never makes a jaw fail: the first one places it, and the kernel lets go of what contradicts. It makes it
 * suspect. Documentation/Findings.md has the codes. Free of ITK headers.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT ViewVerdict
{
public:
  /** Limits beyond which a finding is given. */
  struct Thresholds
  {
    /** Standard deviations beyond which a landmark, or the outline of a tooth, is a gross error. */
    double landmarkApart{ 4.0 };
    /** Root mean square of the others' distances over their standard deviations. */
    double suspectLandmarkRatio{ 2.0 };
    /** Of a tracing on a further lateral radiograph. */
    double suspectCost{ 0.5 };
    /** Of move and scale, in standard deviations of their priors. */
    double suspectPriorTension{ 4.5 };
    /** Difference of the robust criterion: 10 is odds of 150. */
    double suspectDeviance{ -10.0 };
    /** Where most of what was drawn on it was let go, for each landmark and each outline of these: half of what letting
     * go of one costs, as a reading that leaves most of it unexplained is none. Of simulated patients exchanged sides
     * explain 12 and more of a landmark and 75 of an outline, a source on the wrong side lets nothing go, and of
     * drawings in mm or of half the scale either explains up to 6 and 20. */
    double suspectDevianceOfLandmark{ -8.0 };
    double suspectDevianceOfOutline{ -40.0 };
    /** The same of a head that was turned between the radiographs and not said to be: up to six more unknowns explain
     * more of any noise. With the move below, one of 88 simulated patients whose heads stood still is suspected, and
     * three of five whose heads were turned. */
    double suspectMoveDeviance{ -12.0 };
    /** And how far the head is moved then, in standard deviations of patients who are turned in the ear rods. Less is
     * what places of the jaws on the first radiograph are uncertain by, seen by a view that is surer of itself. */
    double suspectHeadMove{ 1.0 };
  };

  /** Findings of a view of the result, by its index; none where it agrees. */
  static std::vector<RegistrationFinding>
  Evaluate(const PoseRegistrationResult & result, std::size_t view, const Thresholds & thresholds);
  static std::vector<RegistrationFinding>
  Evaluate(const PoseRegistrationResult & result, std::size_t view)
  {
    return Evaluate(result, view, Thresholds());
  }

  /** Of a view of which nothing can be used. */
  static RegistrationFinding
  MakeUnusedFinding();

  /** The worst of findings. */
  static RegistrationStatusEnum
  GetStatus(const std::vector<RegistrationFinding> & findings);
};
} // namespace itk

#endif

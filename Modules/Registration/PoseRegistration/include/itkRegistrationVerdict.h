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
#ifndef itkRegistrationVerdict_h
#define itkRegistrationVerdict_h

#include "PoseRegistrationExport.h"
#include "itkPoseRegistrationTypes.h"
#include "itkRegistrationFinding.h"
#include "itkViewVerdict.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace itk
{
/** \class RegistrationVerdict
 * \brief Whether a robust registration can be used: ok, suspect (a person should look) or failed, with findings.
 *
 * Judges what the data can tell: the residuals at a fixed kernel width, the predicted uncertainty, near-equal minima,
 * tension with the priors, the other side's fit, widths, winding and codes. The thresholds come from phantom cohorts
 * (Documentation/Robust.md). GetNotCheckable() lists what the data of a case cannot tell. Free of ITK headers.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT RegistrationVerdict
{
public:
  using StatusEnum = RegistrationStatusEnum;

  /** The verdict on one jaw; no findings where it is ok. */
  struct JawVerdict
  {
    StatusEnum                       status{ StatusEnum::Ok }; /**< The worst that a finding says. */
    std::vector<RegistrationFinding> findings;                 /**< Why it is not ok. */
    /** What was seen and is no reason to doubt the pose, as everything else bears it out: to be said, not judged by. */
    std::vector<RegistrationFinding> takenBack;
    /** The same status for the same reasons. */
    bool
    operator==(const JawVerdict & other) const
    {
      return status == other.status && findings == other.findings && takenBack == other.takenBack;
    }
    bool
    operator!=(const JawVerdict & other) const
    {
      return !(*this == other);
    }
  };

  /** px of 0.25 mm and mm. */
  struct Thresholds
  {
    double suspectCost{ 0.36 };        /**< Cost (PoseFitStatistics) from which a fit is poor. */
    double failedCost{ 0.50 };         /**< Cost from which nothing fits. */
    double suspectP90{ 6.0 };          /**< 90th percentile of the distances to the tracing, px. */
    double suspectMedian{ 2.7 };       /**< Median of these distances, px. */
    double suspectInlierShare{ 0.70 }; /**< Least share of the tracing that is explained. */
    double failedInlierShare{ 0.50 };  /**< Share below which nothing fits. */
    /** Estimated drift of the tracing: nobody draws worse. */
    double suspectSmoothSigma{ 3.0 };
    /** At the tracing, and anywhere on the outline. Not judged on bisected tracings. With a standard deviation of 2.4
     * an axis a hundred times the probability of more than 8 px is that of less than 2: there a wrong ok, which weighs
     * a hundred false alarms, costs as much as the alarm. What is predicted is that times 1.08, or more, in every group
     * of jaws that was measured (Documentation/RobustStudies.md). */
    double suspectPredictedSigma{ 2.6 };
    double suspectExtrapolatedSigma{ 5.5 };
    double failedPredictedSigma{ 20.0 };
    /** mm along the arch: codes that are off by a tooth have the teeth 6 mm (below) or 7 (above) from their places,
     * which right ones miss with a standard deviation of 1.0 to 1.4 mm, by 3.9 at most. */
    double suspectCodeOffset{ 5.0 };
    /** Odds of 4.5 against the best other place. */
    double suspectMargin{ 0.78 };
    /** rad, 30.9 degrees, either way. Rotations up to 32 degrees (0.56) are searched: beyond this one a pose stands at
     * the edge. */
    double suspectPitch{ 0.54 };
    /** rad: a patient on the head. Two marks fit any turn. */
    double failedPitch{ 1.57 };
    double suspectPriorTension{ 4.5 };
    /** Of roll and yaw, whose prior has long tails: 17.5 degrees. A scanner's frame may be off by as much as a head. */
    double suspectRotationTension{ 5.0 };
    /** Difference of minus twice the log likelihood: 5 is odds of 12. */
    double suspectOtherSideDeviance{ -5.0 };
    double suspectWinding{ -0.1 };
    /** Of the middle of both sides, where landmarks alone placed a jaw: over incisors and first molars, and of the
     * worse of them. Of 640 jaws none with less was 8 px off (Documentation/Landmarks.md). */
    double suspectMiddleSigma{ 3.5 };
    double suspectLargestMiddleSigma{ 4.5 };
    /** Standard deviations beyond which a landmark is a gross error, not a reader's: one of 3000 by chance. */
    double landmarkApart{ 4.0 };
    /** Root mean square of the others' distances over their standard deviations. */
    double suspectLandmarkRatio{ 2.0 };
    /** Root mean square of the shifts of outlines that alone place a pose, over their standard deviations, of what the
     * pose leaves free of them. Of 424 pairs of jaws 8 had more, 6 of them by a gross error
     * (Documentation/Landmarks.md). */
    double suspectOutlineRatio{ 1.6 };
    /** Of jaws that were placed each by itself, without a tracing: how far the cusps of upper and lower first molars
     * stand apart across the occlusal plane, mm. In occlusion upper ones reach a little below lower ones; the standard
     * deviation comes on top of what is predicted for both poses, and beyond so many nobody bites
     * (Documentation/Landmarks.md). */
    double biteMean{ -0.7 };
    double biteSigma{ 1.5 };
    double suspectBite{ 3.5 };
    /** The longest side of the radiograph, mm, where the fit alone tells the pixel spacing. Films are 18 x 24 to 24 x
     * 30 cm; panels of 43 cm exist, and such a spacing is good to a few per cent. */
    double suspectFilmLength{ 400.0 };
    /** Of a spacing that was given: no radiograph of a head is shorter, nor longer than the next. */
    double shortestFilm{ 80.0 };
    double failedFilmLength{ 450.0 };
    /** Of a jaw's tracing: as much as a hand drew, the registration's own drafts may be beside it. */
    double suspectDraftedShare{ 0.5 };
    double minimumArchWidth{ 30.0 };
    double maximumArchWidth{ 120.0 };
    /** How much better (score) another hypothesis must be to be named. */
    double hypothesisGain{ 0.03 };
    /** Score up to which the drawing fits with another pixel spacing, and logarithm of the ratio of the two from which
     * on it is another: 8 %, beyond what magnification and its default leave open. */
    double spacingScore{ 0.15 };
    double spacingDifference{ 0.08 };
    /** Share of a tracing's score up to which another spacing is suspect that is not sure by the two above: a free
     * scale that is off from the right one fits worse, by 1.07 and more (Documentation/RobustStudies.md). */
    double spacingShare{ 0.95 };
    /** Where a tracing determines roll and yaw, a dental axis that is unsure is borne out by a fit at most so poor and
     * a margin at least so large (IsAxisBorneOut()). */
    double borneOutCost{ 0.3 };
    double borneOutMargin{ 0.85 };
    /** A tracing that fits poorly in places, as over brackets or teeth that have moved, no worse than the first two,
     * says nothing against a pose that the other jaw's tracing bears out, by a cost of its own up to the third, while
     * the drift of both is a hand's (Documentation/RobustStudies.md). */
    double borneOutPoorCost{ 0.45 };
    double borneOutInlierShare{ 0.60 };
    double borneOutOtherCost{ 0.2 };
    double borneOutSmoothSigma{ 2.2 };
    /** Of each further view. */
    ViewVerdict::Thresholds view;
  };

  /** Columns and rows of the radiograph; {0, 0} where nobody knows. */
  using ImageSizeType = std::array<std::size_t, 2>;

  /** One verdict a jaw, in the order of the result. A further view that is not simply ok makes each jaw suspect; a jaw
   * that the other one placed is no better than that. */
  static std::vector<JawVerdict>
  Evaluate(const PoseRegistrationResult & result,
           const Thresholds &             thresholds,
           const ImageSizeType &          imageSize = ImageSizeType{});
  static std::vector<JawVerdict>
  Evaluate(const PoseRegistrationResult & result);

  /** What a tracing is worth of which a registration drafted a share (DentalContour::GetDraftedShare()); nothing where
   * hands drew enough. For methods too that have no verdict of their own. */
  static std::optional<RegistrationFinding>
  JudgeDrafts(double share, const Thresholds & thresholds);

  /** Whether a fit leaves no doubt of the scan's dental axis, however unsure it was before: the tracing determined roll
   * and yaw, which an axis that is off makes up for, and lies well on the outline at a place that has no rival. Of a
   * jaw without a tracing landmarks or outlines of teeth determine the middles of both sides, which an axis that is off
   * by some degrees hardly moves. A tracing that fits poorly in places bears out nothing, even where the other jaw's
   * excuses it (JawVerdict::takenBack). For callers that found nothing else to doubt: an unsure axis by itself is no
   * reason then (Documentation/RobustStudies.md has what it cost and found). */
  static bool
  IsAxisBorneOut(const PoseGroupResult &         group,
                 const PoseJawResult &           jaw,
                 const JawVerdict &              verdict,
                 const PoseRegistrationOptions & options,
                 const Thresholds &              thresholds);

  /** One of the sentences below, for callers that say the same of each cast. */
  static constexpr const char * ClosedCastLine = "winding of a closed cast";

  /** What cannot be told from this case's data, as sentences. */
  static std::vector<std::string>
  GetNotCheckable(const PoseRegistrationResult & result, const PoseRegistrationOptions & options);
};
} // namespace itk

#endif

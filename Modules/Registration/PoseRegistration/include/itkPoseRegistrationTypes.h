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
#ifndef itkPoseRegistrationTypes_h
#define itkPoseRegistrationTypes_h

#include "itkCephalometricLandmarkSet.h"
#include "itkLandmarkCounterpartSet.h"
#include "itkToothCrownSet.h"
#include "itkPoseFitStatistics.h"
#include "itkDentalContour.h"
#include "itkPoseTypes.h"
#include "itkTracedSide.h"
#include "itkTriangleSurface.h"


#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace itk
{
/** Plain data of the pose registration.
 *
 * Frames: mesh (mm, as the surface is), dental (x anterior, y patient's left, z superior, origin on the midline plane),
 * cephalostat (CephalometricGeometry). Lengths "in px" are units of 0.25 mm in the detector plane, whatever the image's
 * pixel: the working plane w = ((u - pp_u) f sp_u, (v - pp_v) sp_v) / 0.25 has the patient facing right.
 */

/** A jaw to register. */
struct PoseJawInput
{
  /** Mesh frame, mm; must outlive the call. */
  const TriangleSurface * surface{ nullptr };
  PoseFrame               frame;
  ToothCode::JawEnum      jaw{ ToothCode::JawEnum::Upper };
  /** Null where none of this jaw was drawn. */
  DentalContour::ConstPointer tracing;
  /** Null where no landmarks were marked. Those of all jaws. */
  CephalometricLandmarkSet::ConstPointer landmarks;
  /** Of this jaw's landmarks, mesh frame, mm; null where there are none. */
  LandmarkCounterpartSet::ConstPointer counterparts;
  /** What outlines of whole teeth are compared with (traced side Standard), mesh frame, mm; null where there are none.
   */
  ToothCrownSet::ConstPointer crowns;
  /** Start instead of the global search, of this jaw's frame; before PoseRegistrationOptions::initialPose. Of jaws that
   * share a pose the first that has one speaks. */
  std::optional<PoseParameters> initialPose;
};

/** Every ingredient of the method; the defaults are preset "robust". */
struct PoseRegistrationOptions
{
  TracedSideEnum tracedSide{ TracedSideEnum::Right }; /**< The side whose outline was drawn, or the middle of both. */

  /** Cut at the midline plane, or take the whole mesh's outline. */
  bool useSideSelection{ true };
  /** Triangles of the right side: y < midlineMargin mm. Half a millimetre short of the plane, since the other side's
   * incisor often stands in front there (1-2 px of outline that was never traced). */
  double midlineMargin{ -0.5 };
  /** Keep only the occlusal and anterior part of the outline. */
  bool useFacingFilter{ true };
  /** Match position and normal, or position only. Weight of a unit normal, px. */
  bool   useOrientation{ true };
  double orientationWeight{ 8.0 };
  /** Match coded points with the same tooth or one up to toothRange positions away. */
  bool         gateByTooth{ false };
  unsigned int toothRange{ 1 };
  /** Weight of the direction from the outline to the tracing beside the forward one; 0: off. It fades in over
   * taperLength px from the tracing's ends; gaps shorter than gapLength px are none. */
  double reverseWeight{ 0.0 };
  double taperLength{ 6.0 };
  double gapLength{ 8.0 };
  /** Correlation along the tracing (generalised least squares), or independent points. */
  bool   useCorrelatedNoise{ true };
  double correlationLength{ 14.0 };
  double covarianceCorrelationLength{ 18.0 };
  /** Factor on the standard deviations. */
  double covarianceInflation{ 1.0 };
  /** The nearest contour point absorbs part of the noise, the more so the larger it is: in the covariance the levels
   * are multiplied by min(1.6, 1 + absorbedNoise (smooth level / px)^2). */
  double absorbedNoise{ 0.2 };
  /** Estimate the two noise levels (REML), or keep the initial ones. */
  bool   estimateNoise{ true };
  double initialSmoothSigma{ 1.3 };
  double initialWhiteSigma{ 0.6 };
  /** Geman-McClure, or least squares. */
  bool useRobustKernel{ true };
  /** 6 degrees of freedom and scale, or a similarity: pitch, tx, tz, kappa. */
  bool useFullPose{ true };
  /** One pose for all jaws given, or one a jaw. */
  bool useJointPose{ true };
  /** Yaw of the global start, rad. */
  std::vector<double> yawStarts{ -0.1396263401595464, 0.0, 0.1396263401595464 };
  /** Candidates kept a yaw start. */
  unsigned int startsPerYaw{ 4 };
  /** Weight of the tooth codes' arc positions in the choice among candidates, px-free cost a mm; 0: off. */
  double codeWeight{ 0.02 };
  /** Standard deviation of the teeth's mean distance along the arch from where their codes put them, mm, in the last
   * choice. */
  double codeSigma{ 2.0 };
  /** Regenerate the outline at each evaluation, or keep that of the start. */
  bool         regenerateOutline{ true };
  unsigned int maximumEvaluations{ 14 };

  /** Standard deviations of the priors; 0: fixed. */
  double rollSigma{ 0.0610865238198015 };
  double yawSigma{ 0.0610865238198015 };
  /** Degrees of freedom of the t distribution that is the prior of roll and yaw; up to 2: Gaussian, as the others. */
  double rotationPriorFreedom{ 4.0 };
  double tySigma{ 2.0 };
  double kappaSigma{ 0.016 };
  /** Of kappa where the pixel spacing is not known. */
  double kappaSigmaWithoutSpacing{ 0.25 };

  /** Standard deviation of roll and yaw in the covariance where they are not estimated (bisected tracing, similarity).
   */
  double unobservedRotationSigma{ 0.03490658503988659 };
  /** What is held by fixRotation and fixTranslation is not known for certain: pitch (roll and yaw: as above) and shift,
   * mm, in the covariance. A held scale has kappa's sigma. */
  double heldPitchSigma{ 0.01745329251994330 };
  double heldTranslationSigma{ 1.0 };
  /** Try the other side, and, where the fit is poor, exchanged jaws and the other facing. */
  bool checkHypotheses{ true };
  /** Score above which the fit counts as poor for that. */
  double poorScore{ 0.15 };

  /** Manual control. The initial pose says which place is meant (PoseRegistrationMethodBase::SetInitialTransform()). */
  bool           fixScale{ false };
  bool           fixRotation{ false };
  bool           fixTranslation{ false };
  bool           useInitialPose{ false };
  PoseParameters initialPose{ {} };
  /** FDI numbers of teeth to leave out. */
  std::vector<std::uint8_t> excludedTeeth;

  /** Points a jaw above which a tracing is thinned. */
  unsigned int maximumTracingPoints{ 200 };
  unsigned int numberOfThreads{ 0 };

  /** Steps of the refinement of starts as similarities, contour held: kernel widths (px) one after another, evaluations
   * at most, step below which it ends (rms, px). */
  std::vector<double> startKernelWidths{ 10.0, 8.0, 6.0, 5.0, 4.0, 3.0 };
  unsigned int        startEvaluations{ 13 };
  double              startTolerance{ 0.05 };
  /** Starts nearer to a better one than this are the same, px. */
  double startDistance{ 3.0 };
  /** The same of the pooled candidates in all degrees of freedom. */
  std::vector<double> coarseKernelWidths{ 6.0, 4.5, 3.0 };
  unsigned int        coarseEvaluations{ 6 };
  double              coarseTolerance{ 0.05 };
  /** Of the candidates that go on to the end: the best of so many places that lie further apart than this, px, and a
   * second way into the best place. */
  unsigned int maximumPlaces{ 3 };
  double       placeDistance{ 4.0 };
  double       secondWayDistance{ 1.0 };
  /** Candidates behind the best by more than this score do not go on. */
  double scoreMargin{ 0.12 };
  /** The same of the last refinement: kernel width, px, before the noise is known; afterwards the width is the factor
   * times the noise's standard deviation, however small. In the covariance, which is no step of a descent and must not
   * trust a lucky estimate, it is never below fineKernelWidth. */
  double fineKernelWidth{ 3.0 };
  double adaptiveKernelFactor{ 2.5 };
  double fineTolerance{ 0.005 };
  /** Error of the moving contour itself, px, in covariances: half the sample spacing, facets, the cut at the midline.
   */
  double modelSigma{ 0.15 };
  /** The most that the correction for absorbed noise may be. */
  double absorbedNoiseLimit{ 1.6 };
};

/** One minimum of the criterion. */
struct PoseCandidate
{
  PoseParameters parameters{ {} }; /**< Of the minimum. */
  /** Minus twice the logarithm of the minimum's posterior weight but for a constant: what minima are ranked by. The
   * evidence with the noise estimated there, marginal over the pose about the minimum, its priors and the teeth's
   * places.
   */
  double deviance{ 0.0 };
  /** Fixed-width cost + code term: what starts are ranked by, and hypotheses compared. */
  double score{ 0.0 };
  double cost{ 0.0 };
  double codeTerm{ 0.0 };
  /** Rms distance of the moving contours to those of the best candidate, px. */
  double distance{ 0.0 };
};

/** How a landmark that was registered with is explained at the solution. */
struct PoseLandmarkFit
{
  /** CephalometricLandmarkSet::MakeName(). */
  std::string name;
  /** Marked minus predicted, pixels of the radiograph. */
  std::array<double, 2> residual{ { 0.0, 0.0 } };
  /** Standard deviation of that along u and v, pixels: of the mark, and of its place on the scan. */
  std::array<double, 2> sigma{ { 0.0, 0.0 } };
  /** The residual in standard deviations. */
  double distance{ 0.0 };
  /** What the robust kernel leaves of it, 1 to 0. */
  double weight{ 1.0 };
};

/** How an outline of a whole tooth that was registered with is explained at the solution. */
struct PoseOutlineFit
{
  /** "U1", "L6". */
  std::string name;
  /** How far the hand shifted it, as far as can be told: drawn minus predicted, pixels of the radiograph. */
  std::array<double, 2> shift{ { 0.0, 0.0 } };
  /** The same in standard deviations. */
  double shiftDistance{ 0.0 };
  /** Shift, turn and size together, in standard deviations of a shift. */
  double distance{ 0.0 };
  /** What the robust kernel leaves of it, 1 to 0. */
  double weight{ 1.0 };
  /** Share of its crown's points that lie on the scan's outline. */
  double matchedShare{ 1.0 };
  /** Its shape is another tooth's, as a stock template's is: only tip and axis count. */
  bool isTemplate{ false };
  /** The outline that it is, moved, turned and scaled, closer than hands draw: "L6", "UR1 of the stock"; "" where it
   * was not found to be one. */
  std::string templateOf;
  /** How far it is from that one, root mean square, mm on the detector. */
  double templateDistance{ 0.0 };
  /** What it was compared with: the projected outline of the crown at the solution, an open line, pixels. */
  std::vector<std::array<double, 2>> crown;
};

/** Result for one jaw. */
struct PoseJawResult
{
  ToothCode::JawEnum jaw{ ToothCode::JawEnum::Upper }; /**< Whose result it is. */
  bool               registered{ false };              /**< Whether there is a pose. */
  /** The dental frame that the pose is of. */
  PoseFrame frame;
  /** Why not, where not. */
  std::string failure;
  /** Mesh frame to cephalostat frame. */
  std::array<double, 9> rotation{ {} };
  std::array<double, 3> translation{ {} };
  /** Mesh frame (mm) to continuous pixel index, row-major 3x4. */
  std::array<double, 12> projection{ {} };
  /** Of the tracing; numberOfPoints is 0 where there is none. */
  PoseFitStatistics fit;
  /** Of the landmarks of this jaw. */
  std::vector<PoseLandmarkFit> landmarks;
  /** Of the outlines of whole teeth of this jaw. */
  std::vector<PoseOutlineFit> outlines;
  /** Outlines that were not registered with, and why: a line a reason, "outlines U6 and L6: ...". */
  std::vector<std::string> unusedOutlines;
  /** Why its tracing was not used, where landmarks placed it nevertheless; "" where it was. */
  std::string tracingFailure;
  /** Neither tracing nor landmarks: the other jaw, whose frame it shares, placed it. */
  bool placedByOther{ false };
  /** Standard deviation an axis of where a jaw that the other one placed bites on the film, against the scans' bite,
   * mm. Bite scans repeat to 0.1 to 0.3 mm, and on a film patients bite as they are told. */
  static constexpr double BiteSigma = 0.3;
  /** The variance an axis that it adds in the working plane, px^2 of 0.25 mm; 0 for a jaw with drawings of its own. */
  double
  GetBiteVariance(const PoseGeometry & geometry) const
  {
    const double bite = BiteSigma * geometry.sourceToDetector / geometry.sourceToMidsagittal / PoseWorkingPixel;
    return placedByOther ? bite * bite : 0.0;
  }
  /** Standard deviation an axis of the middle of both sides' images, px: root mean square over the jaw's incisors and
   * first molars, and the larger of the two. */
  double middleSigma{ 0.0 };
  double largestMiddleSigma{ 0.0 };
  /** Where the cusps of the first molars' region come to lie, the middle of both sides, px of 0.25 mm in the working
   * plane; not a number where the scan has nothing there. */
  std::array<double, 2> molarPlace{ { NumericTraits<double>::quiet_NaN(), NumericTraits<double>::quiet_NaN() } };
  /** Standard deviation an axis, px. */
  double molarSigma{ 0.0 };
  /** Extent of the surface along y, mm. */
  double archWidth{ 0.0 };
  /** Component along the occlusal direction of the sum of area normals over the area: positive for an open shell with
   * outward winding, near 0 for a closed cast. */
  double winding{ 0.0 };
  /** Share of the tracing whose tooth codes are of the side that was not said to be traced. */
  double otherSideCodes{ 0.0 };
  /** Share of the tracing that a registration drafted and nobody mended (DentalContour::GetDraftedShare()). */
  double draftedShare{ 0.0 };
  /** The moving contour at the solution: open, in pixels of the radiograph, with its outward unit normals there, and
   * its points in the mesh frame, mm. */
  std::vector<std::array<double, 2>> contour;
  std::vector<std::array<double, 2>> contourNormals;
  std::vector<std::array<double, 3>> contourPoints;
};

/** What came of a hypothesis: another reading of the same input, tried beside the result (PoseHypothesis). */
struct PoseHypothesisOutcome
{
  /** Score of its best candidate; 1 where there is none. */
  double score{ 1.0 };
  /** Minus twice the log likelihood of the evidence under the hypothesis minus that of the result: clearly negative
   * where the hypothesis explains it better. 0 where it was not asked for (PoseHypothesis::GetComparesDeviance()), or
   * where there is no candidate. */
  double deviance{ 0.0 };
  /** mm a pixel in the detector plane that the best candidate amounts to, its scale included; 0 where there is none. */
  std::array<double, 2> pixelSpacing{ { 0.0, 0.0 } };
  /** How far its best candidate moves the head for a further view, where it may be moved: the largest of turns and
   * shifts, in standard deviations of patients who are turned in the ear rods (Documentation/Views.md). */
  double headMove{ 0.0 };
};

/** Result for a group of jaws that share one pose. */
struct PoseGroupResult
{
  /** Values of all unknowns, and their covariance, row-major, of which parameters and covariance below are a part; the
   * blocks in their order, each with its place (RegistrationState). */
  std::vector<double>                state;
  std::vector<double>                stateCovariance;
  std::map<std::string, std::size_t> blocks;

  std::vector<std::size_t> jaws;             /**< Indices into the problem's jaws. */
  PoseParameters           parameters{ {} }; /**< The pose that the group's jaws share. */
  /** 7x7, row-major; inflation included. */
  std::array<double, 49> covariance{ {} };
  double                 smoothSigma{ 0.0 };
  double                 whiteSigma{ 0.0 };
  /** |parameter - prior mean| / sigma; 0 where there is no prior. */
  std::array<double, 7>      priorTension{ {} };
  double                     score{ 1.0 };
  std::vector<PoseCandidate> candidates;
  /** 1 - the odds of the best candidate that is elsewhere against the best, exp(-difference of deviances / 2): 0 where
   * they are equal, 1 where there is none. */
  double       margin{ 1.0 };
  unsigned int evaluations{ 0 };
  bool         converged{ false };
  /** Why the optimizer's last run at the solution ended. */
  std::string stopCondition;
  /** The middle of both sides was fitted. */
  bool bisected{ false };
  /** By the code of the hypothesis ("other-side"): of each that was tried, the method's own and a user's alike. What is
   * not there was not tried. */
  std::map<std::string, PoseHypothesisOutcome> outcomes;
  /** By the code of the hypothesis: why one that was worth trying could not be asked (PoseHypothesis::GetObstacle()).
   */
  std::map<std::string, std::string> untried;

  /** Null where that hypothesis was not tried. */
  const PoseHypothesisOutcome *
  FindOutcome(const std::string & code) const
  {
    const auto found = outcomes.find(code);
    return found == outcomes.end() ? nullptr : &found->second;
  }
};

struct PoseViewResult;

/** Everything that a pose registration found. */
struct PoseRegistrationResult
{
  std::vector<PoseJawResult>   jaws;   /**< One a jaw of the problem, in its order. */
  std::vector<PoseGroupResult> groups; /**< Jaws that were placed together, or one alone. */
  /** Index into groups, a jaw; the number of groups where the jaw was not registered. */
  std::vector<std::size_t> groupOfJaw;
  /** What the working plane was made with: the given values or the estimates. */
  PoseGeometry geometry;
  bool         aborted{ false };
  /** Of the views beside the first. */
  std::vector<PoseViewResult> views;
};

/** What a further view shows at the solution. */
struct PoseViewResult
{
  std::string name; /**< As the case names it. */
  /** The same jaws and groups, with the pose that they have in this view, at its scale, and its geometry. What of them
   * was not drawn on this view is empty. */
  PoseRegistrationResult result;
  bool                   sameHeadPosition{ true };
  /** How the head was moved for it, by group of jaws: pitch, roll, yaw (rad), shifts x, y, z (mm), and standard
   * deviations. */
  std::vector<std::array<double, 6>> moves;
  std::vector<std::array<double, 6>> moveSigmas;
  /** By group: |move| and |kappa| over the standard deviation of their priors, the largest. */
  std::vector<double> priorTensions;
};
} // namespace itk

#endif

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
#include "itkRegistrationVerdict.h"

#include "itkExchangedJawsHypothesis.h"
#include "itkExchangedLandmarksHypothesis.h"
#include "itkJoinNames.h"
#include "itkMillimetresPerUnit.h"
#include "itkMillimetreLandmarksHypothesis.h"
#include "itkOtherFacingHypothesis.h"
#include "itkOtherSideHypothesis.h"
#include "itkOtherSpacingHypothesis.h"
#include "itkSortFindings.h"
#include "itkTurnedDrawingHypothesis.h"
#include "itkUpwardDrawingHypothesis.h"
#include "itkVerdictText.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <utility>

namespace itk
{
namespace
{
using StatusEnum = RegistrationVerdict::StatusEnum;

/** Share of a tracing's points with codes of the other side above which the codes are doubted: the majority. A few may
 * be slips of the pen, as of a tooth at the midline. */
constexpr double MajorityOfCodes = 0.5;
/** |winding| below which the surface is taken for a closed body, whose normals cancel out: 0 but for its openings,
 * where an open shell has 0.3 to 0.6 (DentalJawFrame::openness). The size of Thresholds::suspectWinding, so that a cast
 * is either judged by its winding or said not to be. */
constexpr double WindingOfClosedCast = 0.1;
/** Logarithm of the ratio of two pixel spacings from which on landmarks, and outlines of whole teeth, tell them apart
 * by a good fit alone: a molar marked at its other end, or the tooth behind it, is a third of the distance between
 * incisor and molar. Copies are half as large, or twice. */
constexpr double SpacingDifferenceOfLandmarks = 0.4;
/** And from which on they do where all of them fit at the other spacing, by at most such a share of the score of every
 * other reading, the given one among them. Of right drawings a free scale is off by up to 0.09; of drawings at 0.7 to
 * 1.3 times the spacing it has 0.02 to 0.4 of the score (Documentation/RobustStudies.md). */
constexpr double SmallSpacingDifferenceOfLandmarks = 0.15;
constexpr double SpacingShareOfLandmarks = 0.5;
/** Share of an outline of a tooth that has to lie on the crown of the scan. Of 3558 outlines of phantoms none had less
 * than 0.6, while roots without their crowns have 0 to 0.5. */
constexpr double MatchedShareOfATooth = 0.5;
/** The score with the rows counted from below, as a share of the best one with rows as they are. */
constexpr double UpwardShare = 0.75;
/** mm: 8 x 10 inches is the format of cephalometric films, and about that of the detectors that came after them. */
constexpr double UsualFilmLength = 254.0;
/** px of 0.25 mm above which a standard deviation is no longer a length on a film. */
constexpr double LargestSigmaInWords = 1000.0;
constexpr double DegreesPerRadian = 180.0 / 3.14159265358979323846;

/** What a rule measured and the limit that it is beyond. */
struct Measure
{
  std::optional<double> value;
  std::optional<double> limit;
  const char *          unit{ "" };
};

void
Add(RegistrationVerdict::JawVerdict & verdict,
    StatusEnum                        severity,
    const char *                      code,
    const std::string &               text,
    const Measure &                   measure)
{
  verdict.status = std::max(verdict.status, severity);
  verdict.findings.push_back({ severity, code, text, measure.value, measure.limit, measure.unit });
}

/** Where no number decides. */
void
Add(RegistrationVerdict::JawVerdict & verdict, StatusEnum severity, const char * code, const std::string & text)
{
  Add(verdict, severity, code, text, Measure());
}

/** The first of several measures that is beyond its limit. */
Measure
FirstAbove(std::initializer_list<Measure> measures)
{
  for (const Measure & measure : measures)
  {
    if (*measure.value > *measure.limit)
    {
      return measure;
    }
  }
  return Measure();
}

void
JudgeWidth(const PoseJawResult &                   jaw,
           const RegistrationVerdict::Thresholds & thresholds,
           RegistrationVerdict::JawVerdict &       verdict)
{
  const double width = jaw.archWidth;
  if (width >= thresholds.minimumArchWidth && width <= thresholds.maximumArchWidth)
  {
    return;
  }
  std::string text = "the arch is " + FormatNumber(width, width < 1.0 ? 4 : 1) + " mm wide";
  for (const MeshUnit & unit : MeshUnits)
  {
    if (width * unit.millimetres >= thresholds.minimumArchWidth &&
        width * unit.millimetres <= thresholds.maximumArchWidth)
    {
      text += std::string("; the mesh may be in ") + unit.name + " (it would then be " +
              FormatNumber(width * unit.millimetres, 1) + " mm)";
      break;
    }
  }
  Add(verdict,
      StatusEnum::Suspect,
      "arch-width",
      text,
      { width, width < thresholds.minimumArchWidth ? thresholds.minimumArchWidth : thresholds.maximumArchWidth, "mm" });
}

void
JudgeFit(const PoseFitStatistics &               fit,
         const RegistrationVerdict::Thresholds & thresholds,
         RegistrationVerdict::JawVerdict &       verdict)
{
  const std::string residuals = "median distance " + FormatNumber(fit.medianResidual, 1) + " px, 90 % below " +
                                FormatNumber(fit.p90Residual, 1) + " px of 0.25 mm, " +
                                FormatNumber(100.0 * fit.inlierShare, 0) + " % of the tracing within 4 px";
  if (fit.cost > thresholds.failedCost || fit.inlierShare < thresholds.failedInlierShare)
  {
    Add(verdict,
        StatusEnum::Failed,
        "no-fit",
        "the tracing does not lie on the projected outline: " + residuals,
        fit.cost > thresholds.failedCost ? Measure{ fit.cost, thresholds.failedCost, "" }
                                         : Measure{ fit.inlierShare, thresholds.failedInlierShare, "" });
  }
  else if (fit.cost > thresholds.suspectCost || fit.p90Residual > thresholds.suspectP90 ||
           fit.medianResidual > thresholds.suspectMedian || fit.inlierShare < thresholds.suspectInlierShare)
  {
    const Measure above = FirstAbove({ { fit.medianResidual, thresholds.suspectMedian, "px" },
                                       { fit.p90Residual, thresholds.suspectP90, "px" },
                                       { fit.cost, thresholds.suspectCost, "" } });
    Add(verdict,
        StatusEnum::Suspect,
        "poor-fit",
        "the tracing fits the projected outline poorly: " + residuals,
        above.value ? above : Measure{ fit.inlierShare, thresholds.suspectInlierShare, "" });
  }
}

void
JudgeUncertainty(const PoseFitStatistics &               fit,
                 const PoseGroupResult &                 group,
                 const RegistrationVerdict::Thresholds & thresholds,
                 RegistrationVerdict::JawVerdict &       verdict)
{
  if (group.smoothSigma > thresholds.suspectSmoothSigma)
  {
    Add(verdict,
        StatusEnum::Suspect,
        "rough-tracing",
        "tracing and outline differ by " + FormatNumber(group.smoothSigma, 1) +
          " px (sd) along the teeth, more than hands draw: shapes of another patient, jaw or date?",
        { group.smoothSigma, thresholds.suspectSmoothSigma, "px" });
  }
  if (fit.predictedSigma > thresholds.failedPredictedSigma)
  {
    Add(verdict,
        StatusEnum::Failed,
        "undetermined",
        "the tracing does not determine the pose at all; trace more teeth",
        { fit.predictedSigma, thresholds.failedPredictedSigma, "px" });
  }
  if (fit.hasCodes && std::abs(fit.codeOffset) > thresholds.suspectCodeOffset)
  {
    Add(verdict,
        StatusEnum::Suspect,
        "code-offset",
        "the teeth lie " + FormatNumber(std::abs(fit.codeOffset), 1) +
          " mm along the arch from where teeth of their codes are on average: slipped by a tooth, wrong codes, or "
          "teeth missing",
        { std::abs(fit.codeOffset), thresholds.suspectCodeOffset, "mm" });
  }
  // A bisected tracing leaves the two sides' landmarks uncertain by itself.
  const bool bisected = group.bisected;
  if (!bisected && (fit.predictedSigma > thresholds.suspectPredictedSigma ||
                    fit.extrapolatedSigma > thresholds.suspectExtrapolatedSigma))
  {
    Add(verdict,
        StatusEnum::Suspect,
        "uncertain",
        "the tracing does not determine the pose: the predicted uncertainty is " + FormatNumber(fit.predictedSigma, 1) +
          " px an axis at the tracing and up to " + FormatNumber(fit.extrapolatedSigma, 1) +
          " px elsewhere; trace more teeth",
        FirstAbove({ { fit.predictedSigma, thresholds.suspectPredictedSigma, "px" },
                     { fit.extrapolatedSigma, thresholds.suspectExtrapolatedSigma, "px" } }));
  }
}

/** The landmarks of a group against each other: one that stands apart, or all of them. */
void
JudgeLandmarks(const PoseRegistrationResult &          result,
               const PoseGroupResult &                 group,
               const PoseJawResult &                   jaw,
               const RegistrationVerdict::Thresholds & thresholds,
               RegistrationVerdict::JawVerdict &       verdict)
{
  LandmarkTally            tally(thresholds.landmarkApart);
  std::vector<std::string> unmatched;
  double                   smallestShare = 1.0;
  bool                     hasLandmarks = false;
  for (const std::size_t j : group.jaws)
  {
    for (const PoseLandmarkFit & landmark : result.jaws[j].landmarks)
    {
      tally.Add("landmark " + landmark.name, landmark.distance);
      hasLandmarks = true;
    }
    for (const PoseOutlineFit & outline : result.jaws[j].outlines)
    {
      // What lies on nothing has no residuals: it neither confirms the others nor stands apart from them.
      if (outline.matchedShare < MatchedShareOfATooth && outline.distance <= thresholds.landmarkApart)
      {
        unmatched.push_back("outline " + outline.name);
        smallestShare = std::min(smallestShare, outline.matchedShare);
      }
      else
      {
        tally.Add("outline " + outline.name, outline.distance);
      }
    }
  }
  if (!unmatched.empty())
  {
    Add(verdict,
        StatusEnum::Suspect,
        "outline-unmatched",
        JoinNames(unmatched) +
          (unmatched.size() == 1 ? " lies on nothing of the crown that the scan shows: is it a root without its crown, "
                                   "or of another tooth?"
                                 : " lie on nothing of the crowns that the scans show: are they roots without their "
                                   "crowns, or of other teeth?"),
        { smallestShare, MatchedShareOfATooth, "" });
  }
  const std::vector<std::string> & apart = tally.GetApart();
  // As many against as for: none of them is a gross error among good ones.
  if (!apart.empty() && (tally.GetKept() < 2 || apart.size() >= tally.GetKept()) && jaw.fit.numberOfPoints == 0)
  {
    const bool isOne = apart.size() == 1;
    Add(verdict,
        StatusEnum::Failed,
        "landmarks-disagree",
        std::string(hasLandmarks ? "the landmarks do" : "the outlines do") + " not fit the scans: " + JoinNames(apart) +
          (isOne ? " lies" : " lie") + " far from where the others put " + (isOne ? "it" : "them") +
          (hasLandmarks ? "; were names of the two jaws, or of incisor and molar, exchanged?"
                        : "; were names of the two jaws, or of incisor and molar, exchanged, or are they roots without "
                          "their crowns?") +
          (result.geometry.pixelSpacingKnown ? " Or is pixel_spacing_mm of another copy of the radiograph?" : ""),
        { tally.GetLargest(), thresholds.landmarkApart, "sd" });
    return;
  }
  if (!result.geometry.pixelSpacingKnown && jaw.fit.numberOfPoints == 0)
  {
    Add(verdict,
        StatusEnum::Suspect,
        "scale-by-landmarks",
        "the pixel spacing is not known, and landmarks alone tell the scale: give pixel_spacing_mm");
  }
  if (!apart.empty())
  {
    Add(verdict,
        StatusEnum::Suspect,
        "landmark-apart",
        JoinNames(apart) + (apart.size() == 1 ? " lies" : " lie") + " far from where everything else puts " +
          (apart.size() == 1 ? "it and was left out: is it the right tooth and point?"
                             : "them and were left out: are they the right teeth and points?"),
        { tally.GetLargest(), thresholds.landmarkApart, "sd" });
  }
  const double ratio = tally.GetRatio();
  if (ratio > thresholds.suspectLandmarkRatio)
  {
    Add(verdict,
        StatusEnum::Suspect,
        "landmarks-rough",
        std::string(hasLandmarks ? "the landmarks lie " : "the outlines lie ") + FormatNumber(ratio, 1) +
          " times as far from their places as their errors tell: another patient, jaw or unit?",
        { ratio, thresholds.suspectLandmarkRatio, "sd" });
  }
}

/** The outlines of a group that nothing else places, against each other. A gross error of one of four is shared out by
 * the pose: none of them stands apart, but together they are shifted further than hands shift them. */
void
JudgeOutlines(const PoseRegistrationResult &          result,
              const PoseGroupResult &                 group,
              const RegistrationVerdict::Thresholds & thresholds,
              RegistrationVerdict::JawVerdict &       verdict)
{
  // What of the shifts' coordinates the pose itself takes: its place on the film, pitch and size.
  constexpr double coordinatesOfPose = 4.0;
  double           sum = 0.0;
  double           coordinates = -coordinatesOfPose;
  for (const std::size_t j : group.jaws)
  {
    const PoseJawResult & jaw = result.jaws[j];
    if (jaw.fit.numberOfPoints > 0 || !jaw.landmarks.empty())
    {
      return;
    }
    for (const PoseOutlineFit & outline : jaw.outlines)
    {
      if (outline.distance <= thresholds.landmarkApart)
      {
        sum += outline.shiftDistance * outline.shiftDistance;
        coordinates += 2.0;
      }
    }
  }
  const double ratio = coordinates > 0.0 ? std::sqrt(sum / coordinates) : 0.0;
  if (ratio > thresholds.suspectOutlineRatio)
  {
    Add(
      verdict,
      StatusEnum::Suspect,
      "outlines-contradict",
      "the outlines contradict each other: they are shifted " + FormatNumber(ratio, 1) +
        " times as far as hands shift them, and a gross error of one moves all; look at each on the overlay, and mark "
        "landmarks as well",
      { ratio, thresholds.suspectOutlineRatio, "sd" });
  }
}

/** Whether front teeth and teeth behind them were marked. */
struct MarkedTeeth
{
  bool isFront{ false };
  bool isBack{ false };
};

MarkedTeeth
FindMarkedTeeth(const PoseRegistrationResult & result, const PoseGroupResult & group)
{
  MarkedTeeth marked;
  const auto  note = [&marked](const std::string & name) {
    // "U1_tip", "L6": the tooth's position. Milk teeth have a letter.
    const std::size_t digit = name.find_first_of("12345678");
    if (digit != std::string::npos)
    {
      (name[digit] <= '3' ? marked.isFront : marked.isBack) = true;
    }
  };
  for (const std::size_t j : group.jaws)
  {
    for (const PoseLandmarkFit & landmark : result.jaws[j].landmarks)
    {
      note(landmark.name);
    }
    for (const PoseOutlineFit & outline : result.jaws[j].outlines)
    {
      note(outline.name);
    }
  }
  return marked;
}

/** What to mark besides, by the names of what was marked. */
std::string
DescribeMissingMarks(const PoseRegistrationResult & result, const PoseGroupResult & group)
{
  const MarkedTeeth marked = FindMarkedTeeth(result, group);
  return marked.isFront && !marked.isBack ? "front teeth alone do not tell how the head is tipped: mark molars as well"
         : marked.isBack && !marked.isFront
           ? "posterior teeth alone do not tell how the head is tipped: mark incisors as well"
           : "mark incisors and molars of both jaws";
}

/** Whether what was drawn tells how the head is tipped: marks of front teeth alone, or of posterior teeth alone, do
 * not, and whatever pitch comes out of them means nothing. */
bool
TellsPitch(const PoseRegistrationResult & result, const PoseGroupResult & group)
{
  const MarkedTeeth marked = FindMarkedTeeth(result, group);
  return marked.isFront == marked.isBack || std::any_of(group.jaws.begin(), group.jaws.end(), [&](std::size_t j) {
           return result.jaws[j].fit.numberOfPoints > 0;
         });
}

/** What drawings that are of no side determine: the middle of both. */
void
JudgeMiddle(const PoseRegistrationResult &          result,
            const PoseGroupResult &                 group,
            const PoseJawResult &                   jaw,
            const RegistrationVerdict::Thresholds & thresholds,
            RegistrationVerdict::JawVerdict &       verdict)
{
  const auto toWords = [](double sigma) {
    return sigma > LargestSigmaInWords ? "more than " + FormatNumber(LargestSigmaInWords, 0) : FormatNumber(sigma, 1);
  };
  const std::string figures = "the predicted uncertainty of the middle of both sides is " + toWords(jaw.middleSigma) +
                              " px an axis and up to " + toWords(jaw.largestMiddleSigma) +
                              " px at incisors or first molars; " + DescribeMissingMarks(result, group);
  if (jaw.middleSigma > thresholds.failedPredictedSigma)
  {
    Add(verdict,
        StatusEnum::Failed,
        "undetermined",
        "what was drawn does not determine the pose: " + figures,
        { jaw.middleSigma, thresholds.failedPredictedSigma, "px" });
  }
  else if (jaw.middleSigma > thresholds.suspectMiddleSigma ||
           jaw.largestMiddleSigma > thresholds.suspectLargestMiddleSigma)
  {
    Add(verdict,
        StatusEnum::Suspect,
        "uncertain",
        "what was drawn determines the pose poorly: " + figures,
        FirstAbove({ { jaw.middleSigma, thresholds.suspectMiddleSigma, "px" },
                     { jaw.largestMiddleSigma, thresholds.suspectLargestMiddleSigma, "px" } }));
  }
}

/** Jaws that were placed each by itself, by a few marks or outlines, against each other: on the film the patient bites.
 * A gross error of one of two marks, which nothing of its own jaw contradicts, tips the jaw, and parts its molars from
 * those of the other one, or drives them into them. */
void
JudgeBite(const PoseRegistrationResult &                 result,
          const RegistrationVerdict::Thresholds &        thresholds,
          std::vector<RegistrationVerdict::JawVerdict> & verdicts)
{
  std::array<const PoseJawResult *, 2> jaws{ { nullptr, nullptr } };
  for (const PoseJawResult & jaw : result.jaws)
  {
    const bool byMarks = jaw.fit.numberOfPoints == 0 && (!jaw.landmarks.empty() || !jaw.outlines.empty());
    if (jaw.registered && byMarks && std::isfinite(jaw.molarPlace[1]))
    {
      jaws[jaw.jaw == ToothCode::JawEnum::Upper ? 0 : 1] = &jaw;
    }
  }
  if (jaws[0] == nullptr || jaws[1] == nullptr || result.groupOfJaw.size() < 2 ||
      result.groupOfJaw[0] == result.groupOfJaw[1])
  {
    return;
  }
  // Across the occlusal plane, which is tipped as the jaws are on average.
  const double pitch = 0.5 * (result.groups[result.groupOfJaw[0]].parameters[PosePitch] +
                              result.groups[result.groupOfJaw[1]].parameters[PosePitch]);
  const double u = jaws[1]->molarPlace[0] - jaws[0]->molarPlace[0];
  const double v = jaws[1]->molarPlace[1] - jaws[0]->molarPlace[1];
  const double perPixel = PoseWorkingPixel * result.geometry.sourceToMidsagittal / result.geometry.sourceToDetector;
  const double gap = perPixel * (v * std::cos(pitch) - u * std::sin(pitch));
  const double sigma =
    std::hypot(thresholds.biteSigma, perPixel * std::hypot(jaws[0]->molarSigma, jaws[1]->molarSigma));
  const double ratio = std::abs(gap - thresholds.biteMean) / sigma;
  if (ratio <= thresholds.suspectBite)
  {
    return;
  }
  for (std::size_t j = 0; j < result.jaws.size(); ++j)
  {
    if (result.jaws[j].registered)
    {
      Add(verdicts[j],
          StatusEnum::Suspect,
          "bite",
          std::string("the jaws, placed each by itself, ") +
            (gap > thresholds.biteMean ? "stand " + FormatNumber(gap, 1) + " mm apart at the first molars"
                                       : "overlap by " + FormatNumber(-gap, 1) + " mm at the first molars") +
            ", where teeth touch on a radiograph: a mark or outline of one of them may be a gross error; look at both "
            "jaws on the overlay, or mark more teeth",
          { ratio, thresholds.suspectBite, "sd" });
    }
  }
}

/** Whether another position may be the answer. A tracing's, of any jaw that shares the pose, are told apart from 4 px
 * on; landmarks and outlines of teeth err by half of that anyway, and a minimum nearer than twice as far is in their
 * sigma. */
void
JudgeMargin(const PoseRegistrationResult &          result,
            const PoseGroupResult &                 group,
            const RegistrationVerdict::Thresholds & thresholds,
            RegistrationVerdict::JawVerdict &       verdict)
{
  // Elsewhere, as the margin means it; the result does not carry the option that was used.
  const double placeDistance = PoseRegistrationOptions().placeDistance;
  const bool   isTraced = std::any_of(
    group.jaws.begin(), group.jaws.end(), [&](std::size_t j) { return result.jaws[j].fit.numberOfPoints > 0; });
  double margin = isTraced ? group.margin : 1.0;
  double distance = 0.0;
  for (const PoseCandidate & candidate : group.candidates)
  {
    if (candidate.distance > (isTraced ? placeDistance : 2.0 * placeDistance))
    {
      const double own = -std::expm1(-0.5 * (candidate.deviance - group.candidates.front().deviance));
      margin = isTraced ? margin : std::min(margin, own);
      distance = distance > 0.0 ? distance : candidate.distance;
    }
  }
  if (margin < thresholds.suspectMargin)
  {
    Add(verdict,
        StatusEnum::Suspect,
        "ambiguous",
        "another position, " + FormatNumber(distance, 0) + " px away, fits nearly as well",
        { margin, thresholds.suspectMargin, "" });
  }
}

/** How long the film would be were its spacing in a unit in which films have that length, the more usual length first:
 * "229 mm were pixel_spacing_mm in inches, 90 mm in cm"; empty where no unit explains it. */
std::string
DescribeFilmInOtherUnits(double length, const RegistrationVerdict::Thresholds & thresholds)
{
  std::vector<std::pair<double, std::string>> lengths;
  for (const auto & [factor, unit] : { std::make_pair(10.0, "cm"), std::make_pair(25.4, "inches") })
  {
    if (factor * length >= thresholds.shortestFilm && factor * length <= thresholds.suspectFilmLength)
    {
      lengths.emplace_back(factor * length, unit);
    }
  }
  const auto offUsual = [](double millimetres) { return std::abs(std::log(millimetres / UsualFilmLength)); };
  std::stable_sort(lengths.begin(), lengths.end(), [&](const auto & left, const auto & right) {
    return offUsual(left.first) < offUsual(right.first);
  });
  std::string text;
  for (const auto & [inUnit, unit] : lengths)
  {
    text += text.empty() ? FormatNumber(inUnit, 0) + " mm were pixel_spacing_mm in " + unit
                         : ", " + FormatNumber(inUnit, 0) + " mm in " + unit;
  }
  return text;
}

/** A spacing that only the drawing tells makes a film of some size. */
void
JudgeFilm(const PoseGeometry &                       geometry,
          const RegistrationVerdict::ImageSizeType & imageSize,
          const RegistrationVerdict::Thresholds &    thresholds,
          RegistrationVerdict::JawVerdict &          verdict)
{
  const double length = std::max(static_cast<double>(imageSize[0]) * geometry.pixelSpacing[0],
                                 static_cast<double>(imageSize[1]) * geometry.pixelSpacing[1]);
  if (geometry.pixelSpacingKnown)
  {
    const bool isShort = length < thresholds.shortestFilm;
    if (length > 0.0 && (isShort || length > thresholds.failedFilmLength))
    {
      const std::string inOtherUnits = DescribeFilmInOtherUnits(length, thresholds);
      Add(verdict,
          StatusEnum::Suspect,
          "film-size",
          "by its pixel spacing the radiograph would be " + FormatNumber(length, 0) + " mm long" +
            (inOtherUnits.empty() ? ": is pixel_spacing_mm of another resolution?"
                                  : ", and " + inOtherUnits + ": give mm a pixel"),
          { length, isShort ? thresholds.shortestFilm : thresholds.failedFilmLength, "mm" });
    }
    return;
  }
  if (length <= thresholds.suspectFilmLength)
  {
    return;
  }
  const bool failed = length > thresholds.failedFilmLength;
  Add(verdict,
      failed ? StatusEnum::Failed : StatusEnum::Suspect,
      "film-size",
      "the radiograph would be " + FormatNumber(length, 0) +
        " mm long: was it drawn in mm, or on a smaller copy of the image? Give pixels of this one, or pixel_spacing_mm",
      { length, failed ? thresholds.failedFilmLength : thresholds.suspectFilmLength, "mm" });
}

void
JudgePriors(const PoseGroupResult &                 group,
            bool                                    hasViews,
            const RegistrationVerdict::Thresholds & thresholds,
            RegistrationVerdict::JawVerdict &       verdict)
{
  for (const unsigned int k : { PoseRoll, PoseYaw, PoseTy, PoseKappa })
  {
    const bool   rotation = k == PoseRoll || k == PoseYaw;
    const double limit = rotation ? thresholds.suspectRotationTension : thresholds.suspectPriorTension;
    if (group.priorTension[k] <= limit)
    {
      continue;
    }
    const double value = group.parameters[k];
    std::string  text;
    switch (k)
    {
      case PoseKappa:
        text = "the scale contradicts pixel spacing and distances by " +
               FormatNumber(100.0 * (std::exp(value) - 1.0), 1) + " %: check the pixel spacing and its plane";
        break;
      case PoseRoll:
        text = "the head would be rolled by " + FormatNumber(value * DegreesPerRadian, 1) + " degrees";
        break;
      case PoseYaw:
        text = "the head would be turned by " + FormatNumber(value * DegreesPerRadian, 1) + " degrees";
        break;
      default:
        text = "the midline would be " + FormatNumber(value, 1) + " mm off the midsagittal plane" +
               (hasViews ? ": are the principal points of all radiographs right?" : "");
        break;
    }
    Add(verdict, StatusEnum::Suspect, "prior-tension", text, { group.priorTension[k], limit, "sd" });
  }
}
/** Of standard drawings, few points of each jaw, a scale that is a little off looks like exchanged jaws or names:
 * beside them it is named as what may be so as well, with the spacing that fits better where there is one. Empty where
 * the spacing was estimated. */
std::string
AskForSpacing(const PoseRegistrationResult & registration, const PoseGroupResult & group, double gain)
{
  if (!registration.geometry.pixelSpacingKnown)
  {
    return std::string();
  }
  std::string                   text = "; or is pixel_spacing_mm of another copy of the radiograph";
  const PoseHypothesisOutcome * other = group.FindOutcome(OtherSpacingHypothesis::Code);
  const double spacing = other != nullptr ? 0.5 * (other->pixelSpacing[0] + other->pixelSpacing[1]) : 0.0;
  if (spacing > 0.0 && other->score < group.score - gain)
  {
    text += " (with " + FormatNumber(spacing, spacing < 0.1 ? 3 : 2) + " mm what was drawn fits better as well)";
  }
  return text + "?";
}

/** The other readings of the drawing that are told by their score. Names that are exchanged fit the other facing a
 * little better as well, and a scale that is free fits everything a little better: one is named, the best. */
void
JudgeReadings(const PoseRegistrationResult &          registration,
              const PoseGroupResult &                 group,
              const RegistrationVerdict::Thresholds & thresholds,
              RegistrationVerdict::JawVerdict &       verdict)
{
  const PoseGeometry & geometry = registration.geometry;
  const bool           isTraced = std::any_of(
    group.jaws.begin(), group.jaws.end(), [&](std::size_t j) { return registration.jaws[j].fit.numberOfPoints > 0; });
  const double difference =
    isTraced ? thresholds.spacingDifference : std::max(thresholds.spacingDifference, SpacingDifferenceOfLandmarks);
  const auto spacingOf = [&](const PoseHypothesisOutcome & outcome) {
    return 0.5 * (outcome.pixelSpacing[0] + outcome.pixelSpacing[1]);
  };
  const double given = 0.5 * (geometry.pixelSpacing[0] + geometry.pixelSpacing[1]);
  const auto   isSpacing = [](const std::string & code) { return code == OtherSpacingHypothesis::Code; };
  const auto   isTurned = [](const std::string & code) { return code.rfind(TurnedDrawingHypothesis::Code, 0) == 0; };
  const PoseHypothesisOutcome * otherSpacing = group.FindOutcome(OtherSpacingHypothesis::Code);
  // Landmarks and outlines of four teeth have few coordinates: what tells a spacing that is off by less than a tooth's
  // width from a mark at the wrong tooth is that no other reading comes near to it.
  double bestOtherScore = group.score;
  for (const auto & [code, outcome] : group.outcomes)
  {
    if (!isSpacing(code) && code != UpwardDrawingHypothesis::Code)
    {
      bestOtherScore = std::min(bestOtherScore, outcome.score);
    }
  }
  const auto isOtherSpacing = [&](const PoseHypothesisOutcome & outcome) {
    const double apart = spacingOf(outcome) > 0.0 ? std::abs(std::log(spacingOf(outcome) / given)) : 0.0;
    return apart >= difference || (!isTraced && apart >= SmallSpacingDifferenceOfLandmarks &&
                                   outcome.score <= SpacingShareOfLandmarks * bestOtherScore);
  };
  const double scoreAsItIs = otherSpacing != nullptr ? std::min(otherSpacing->score, group.score) : group.score;
  using EntryType = std::pair<const std::string, PoseHypothesisOutcome>;
  const EntryType * best = nullptr;
  const EntryType * bestScale = nullptr;
  const EntryType * betterScale = nullptr;
  for (const auto & entry : group.outcomes)
  {
    const PoseHypothesisOutcome & outcome = entry.second;
    const std::string &           code = entry.first;
    if (code != OtherFacingHypothesis::Code && code != ExchangedLandmarksHypothesis::Code &&
        code != MillimetreLandmarksHypothesis::Code && code != UpwardDrawingHypothesis::Code && !isSpacing(code) &&
        !isTurned(code))
    {
      continue;
    }
    // It frees the scale as well, and has to be better than that alone.
    if (code == UpwardDrawingHypothesis::Code && outcome.score > UpwardShare * scoreAsItIs)
    {
      continue;
    }
    // A scale that is free differs a little by itself.
    if (isSpacing(code) && !isOtherSpacing(outcome))
    {
      continue;
    }
    // Worn or crowded teeth and hard noise fit no spacing well, but the right one better.
    if (isSpacing(code) && isTraced && outcome.score <= thresholds.spacingShare * group.score)
    {
      betterScale = &entry;
    }
    // Where the scale is free only a good fit with another one is sure.
    if (isSpacing(code) && outcome.score > thresholds.spacingScore)
    {
      continue;
    }
    const EntryType *& place = isSpacing(code) ? bestScale : best;
    if (outcome.score < group.score - thresholds.hypothesisGain &&
        (place == nullptr || outcome.score < place->second.score))
    {
      place = &entry;
    }
  }
  // A scale that is free fits at least as well as one that was said: it has to be better than the other readings by as
  // much as they are better than none.
  if (bestScale != nullptr &&
      (best == nullptr || bestScale->second.score < best->second.score - thresholds.hypothesisGain))
  {
    best = bestScale;
  }
  const PoseHypothesisOutcome * exchangedJaws = group.FindOutcome(ExchangedJawsHypothesis::Code);
  const bool isExchanged = exchangedJaws != nullptr && exchangedJaws->score < group.score - thresholds.hypothesisGain;
  // One mistake at a time: with the scans exchanged nothing fits well, whatever the scale, and at a wrong scale each
  // scan fits the other's tracing about as well as its own.
  if (isExchanged && (best == nullptr || exchangedJaws->score <= best->second.score + thresholds.hypothesisGain ||
                      best->first == OtherFacingHypothesis::Code))
  {
    Add(verdict,
        StatusEnum::Failed,
        "jaws-exchanged",
        "upper and lower scan seem to be exchanged" +
          (isTraced ? std::string() : AskForSpacing(registration, group, thresholds.hypothesisGain)),
        { group.score - exchangedJaws->score, thresholds.hypothesisGain, "" });
    if (best != nullptr && exchangedJaws->score < best->second.score)
    {
      return;
    }
  }
  if (best == nullptr)
  {
    if (betterScale != nullptr && !isExchanged)
    {
      const double spacing = spacingOf(betterScale->second);
      Add(verdict,
          StatusEnum::Suspect,
          "pixel-spacing",
          "what was drawn fits better with a pixel spacing of " + FormatNumber(spacing, spacing < 0.1 ? 3 : 2) +
            " mm than with " + FormatNumber(given, given < 0.1 ? 3 : 2) +
            " mm: check pixel_spacing_mm, its unit and its plane",
          { spacing, given, "mm" });
    }
    return;
  }
  // A drawing in mm has a spacing of 1; that of an estimated scale is as sure as a patient's size, and by four marks of
  // half a millimetre's error over an arch of 40 mm no surer than a tenth.
  const double        sureness = isTraced ? 0.05 : 0.1;
  const std::string & code = best->first;
  const Measure       gain{ group.score - best->second.score, thresholds.hypothesisGain, "" };
  if (code == ExchangedLandmarksHypothesis::Code)
  {
    Add(verdict,
        StatusEnum::Failed,
        "landmarks-exchanged",
        "the names of upper and lower landmarks seem to be exchanged: each fits better as the same point of the other "
        "jaw; write U for L and L for U in their names" +
          AskForSpacing(registration, group, thresholds.hypothesisGain),
        gain);
  }
  else if (code == MillimetreLandmarksHypothesis::Code)
  {
    Add(verdict,
        StatusEnum::Failed,
        "landmarks-mm",
        "the landmarks seem to be in mm: divided by the pixel spacing they fit; give pixels of the radiograph",
        gain);
  }
  else if (isSpacing(code))
  {
    const double spacing = spacingOf(best->second);
    const bool   inMillimetres = std::abs(std::log(spacing)) < sureness && std::abs(std::log(given)) > sureness;
    const bool   mayBeMarks = !isTraced && std::abs(std::log(spacing / given)) < SpacingDifferenceOfLandmarks;
    Add(verdict,
        StatusEnum::Failed,
        "pixel-spacing",
        "what was drawn fits with a pixel spacing of " + FormatNumber(spacing, spacing < 0.1 ? 3 : 2) + " mm, not of " +
          FormatNumber(given, given < 0.1 ? 3 : 2) +
          " mm: check pixel_spacing_mm and its unit, or whether it was drawn " +
          (inMillimetres ? std::string("in mm instead of pixels")
                         : "on a copy of the radiograph " + FormatNumber(given / spacing, 2) + " times as large") +
          (mayBeMarks ? "; the same teeth of both jaws drawn at their neighbours look alike" : ""),
        { spacing, given, "mm" });
  }
  else if (code == UpwardDrawingHypothesis::Code)
  {
    const double spacing = spacingOf(best->second);
    const bool   isOtherScale = geometry.pixelSpacingKnown && std::abs(std::log(spacing / given)) > difference;
    const bool   isInMillimetres = isOtherScale && std::abs(std::log(spacing)) < sureness;
    Add(verdict,
        StatusEnum::Failed,
        "upward-drawing",
        "the drawing fits with above and below exchanged" +
          (isOtherScale ? " and a pixel spacing of " + FormatNumber(spacing, spacing < 0.1 ? 3 : 2) + " mm" : "") +
          ": were its rows counted from below, as programs that plot do" + (isInMillimetres ? ", and in mm" : "") +
          "? Give pixels of the radiograph and count v from its top: its height less what was written",
        gain);
  }
  else if (isTurned(code))
  {
    Add(verdict,
        StatusEnum::Failed,
        "turned-image",
        "the drawing fits when it is turned by " + code.substr(std::string(TurnedDrawingHypothesis::Code).size()) +
          " degrees clockwise: was the radiograph turned after, or before, it was drawn on?" +
          (code == std::string(TurnedDrawingHypothesis::Code) + "180"
             ? ""
             : " Or was the row written before the column in its coordinates?"),
        gain);
  }
  else
  {
    // Of a few landmarks, or outlines of four teeth, rows from below look like it.
    Add(verdict,
        StatusEnum::Failed,
        "facing",
        std::string("the patient seems to face the other way: check `facing`") +
          (isTraced ? ""
                    : ", that v is counted from the top of the radiograph, and that u, the column, is written first"),
        gain);
  }
}

/** A view that contradicts the first one is told of each jaw: nobody knows which of the two is wrong. */
void
AddOfViews(const PoseRegistrationResult &                 result,
           const RegistrationVerdict::Thresholds &        thresholds,
           std::vector<RegistrationVerdict::JawVerdict> & verdicts)
{
  for (std::size_t v = 0; v < result.views.size(); ++v)
  {
    const auto findings = ViewVerdict::Evaluate(result, v, thresholds.view);
    if (ViewVerdict::GetStatus(findings) == StatusEnum::Ok)
    {
      continue;
    }
    for (std::size_t j = 0; j < result.jaws.size(); ++j)
    {
      if (result.jaws[j].registered)
      {
        Add(verdicts[j],
            StatusEnum::Suspect,
            "view",
            "the view \"" + result.views[v].name + "\" is not simply ok: " + findings.front().text);
      }
    }
  }
}

/** Where two tracings share a pose and nothing is doubted but that one of them fits poorly, the other, by its own good
 * fit, says that the pose is right: what fits poorly is then not where the jaw stands, but what was drawn. */
void
TakeBackPoorFits(const PoseRegistrationResult &                 result,
                 const RegistrationVerdict::Thresholds &        thresholds,
                 std::vector<RegistrationVerdict::JawVerdict> & verdicts)
{
  const auto hasOnly = [](const RegistrationVerdict::JawVerdict & verdict, const char * code) {
    return verdict.findings.size() == 1 && verdict.findings.front().code == code;
  };
  for (const PoseGroupResult & group : result.groups)
  {
    if (group.jaws.size() != 2 || group.smoothSigma > thresholds.borneOutSmoothSigma ||
        group.margin < thresholds.borneOutMargin)
    {
      continue;
    }
    for (const std::size_t j : group.jaws)
    {
      const std::size_t         other = group.jaws[0] == j ? group.jaws[1] : group.jaws[0];
      const PoseFitStatistics & fit = result.jaws[j].fit;
      const PoseFitStatistics & fitOfOther = result.jaws[other].fit;
      if (hasOnly(verdicts[j], "poor-fit") && hasOnly(verdicts[other], "other-jaw") &&
          fit.cost <= thresholds.borneOutPoorCost && fit.inlierShare >= thresholds.borneOutInlierShare &&
          fitOfOther.numberOfPoints > 0 && fitOfOther.cost <= thresholds.borneOutOtherCost)
      {
        verdicts[j].takenBack = verdicts[j].findings;
        for (const std::size_t each : group.jaws)
        {
          verdicts[each].findings.clear();
          verdicts[each].status = RegistrationVerdict::StatusEnum::Ok;
        }
      }
    }
  }
}

/** A jaw of which nothing was drawn is where the other one is, and as sure. */
void
AddOfOtherJaw(const PoseRegistrationResult & result, std::vector<RegistrationVerdict::JawVerdict> & verdicts)
{
  for (std::size_t j = 0; j < result.jaws.size(); ++j)
  {
    if (!result.jaws[j].registered || !result.jaws[j].placedByOther)
    {
      continue;
    }
    for (const std::size_t other : result.groups[result.groupOfJaw[j]].jaws)
    {
      if (other != j)
      {
        Add(verdicts[j],
            verdicts[other].status,
            "placed-by-other",
            std::string("nothing was drawn of this jaw: the ") + ToString(result.jaws[other].jaw) +
              " one, whose frame it shares, placed it, as the jaws bit on each other when they were scanned");
      }
    }
  }
}
} // namespace

std::vector<RegistrationVerdict::JawVerdict>
RegistrationVerdict::Evaluate(const PoseRegistrationResult & result,
                              const Thresholds &             thresholds,
                              const ImageSizeType &          imageSize)
{
  std::vector<JawVerdict> verdicts(result.jaws.size());
  for (std::size_t j = 0; j < result.jaws.size(); ++j)
  {
    const PoseJawResult & jaw = result.jaws[j];
    JawVerdict &          verdict = verdicts[j];
    if (!jaw.registered)
    {
      Add(verdict, StatusEnum::Failed, "not-registered", jaw.failure);
      continue;
    }
    const PoseGroupResult & group = result.groups[result.groupOfJaw[j]];
    const bool              traced = jaw.fit.numberOfPoints > 0;
    if (traced)
    {
      JudgeFit(jaw.fit, thresholds, verdict);
      JudgeUncertainty(jaw.fit, group, thresholds, verdict);
    }
    const auto hasLandmarks = [&](std::size_t other) {
      return !result.jaws[other].landmarks.empty() || !result.jaws[other].outlines.empty();
    };
    const bool byLandmarks = std::any_of(group.jaws.begin(), group.jaws.end(), hasLandmarks);
    if (byLandmarks)
    {
      JudgeLandmarks(result, group, jaw, thresholds, verdict);
      JudgeOutlines(result, group, thresholds, verdict);
    }
    if (!traced)
    {
      JudgeMiddle(result, group, jaw, thresholds, verdict);
    }
    if (!jaw.tracingFailure.empty())
    {
      Add(verdict,
          StatusEnum::Suspect,
          "tracing-unused",
          "the tracing was not used, landmarks alone placed the jaw: " + jaw.tracingFailure);
    }
    JudgeFilm(result.geometry, imageSize, thresholds, verdict);
    const std::size_t before = verdict.findings.size();
    JudgeWidth(jaw, thresholds, verdict);
    const bool wrongUnit = verdict.findings.size() > before;
    for (std::size_t other : group.jaws)
    {
      JawVerdict fitOfOther;
      if (result.jaws[other].fit.numberOfPoints == 0)
      {
        continue;
      }
      JudgeFit(result.jaws[other].fit, thresholds, fitOfOther);
      if (other != j && fitOfOther.status != StatusEnum::Ok)
      {
        Add(verdict, StatusEnum::Suspect, "other-jaw", "the other jaw, which shares this pose, fits poorly");
      }
    }
    if (jaw.winding < thresholds.suspectWinding)
    {
      Add(verdict,
          StatusEnum::Suspect,
          "inward-winding",
          "the triangles face inward: the scan may be mirrored, or its triangles are wound the wrong way",
          { jaw.winding, thresholds.suspectWinding, "" });
    }
    if (jaw.otherSideCodes > MajorityOfCodes)
    {
      Add(verdict,
          StatusEnum::Suspect,
          "side-codes",
          "the tooth codes are of the side that is not said to be traced: check traced_side and the numbering",
          { jaw.otherSideCodes, MajorityOfCodes, "" });
    }
    if (const auto drafts = JudgeDrafts(jaw.draftedShare, thresholds))
    {
      verdict.status = std::max(verdict.status, drafts->severity);
      verdict.findings.push_back(*drafts);
    }
    const PoseHypothesisOutcome * otherSide = group.FindOutcome(OtherSideHypothesis::Code);
    if (otherSide != nullptr && otherSide->deviance < thresholds.suspectOtherSideDeviance)
    {
      Add(
        verdict,
        StatusEnum::Suspect,
        "other-side",
        "the outline of the other side fits significantly better: the other side may have been traced, or the scan is "
        "mirrored",
        { otherSide->deviance, thresholds.suspectOtherSideDeviance, "" });
    }
    JudgeMargin(result, group, thresholds, verdict);
    JudgePriors(group, !result.views.empty(), thresholds, verdict);
    const double pitch = TellsPitch(result, group) ? group.parameters[PosePitch] : 0.0;
    if (std::abs(pitch) > thresholds.failedPitch)
    {
      Add(verdict,
          StatusEnum::Failed,
          "upside-down",
          "the patient would stand on the head, tipped by " + FormatNumber(pitch * DegreesPerRadian, 0) +
            " degrees: check `facing`, a mirrored or turned image, and exchanged names",
          { std::abs(pitch) * DegreesPerRadian, thresholds.failedPitch * DegreesPerRadian, "deg" });
    }
    else if (std::abs(pitch) > thresholds.suspectPitch)
    {
      Add(verdict,
          StatusEnum::Suspect,
          "search-limit",
          "the head would be tipped by " + FormatNumber(pitch * DegreesPerRadian, 0) +
            " degrees, at or beyond what is searched",
          { std::abs(pitch) * DegreesPerRadian, thresholds.suspectPitch * DegreesPerRadian, "deg" });
    }
    // In another unit nothing fits, whatever else is tried.
    if (wrongUnit)
    {
      continue;
    }
    JudgeReadings(result, group, thresholds, verdict);
  }
  JudgeBite(result, thresholds, verdicts);
  AddOfViews(result, thresholds, verdicts);
  TakeBackPoorFits(result, thresholds, verdicts);
  AddOfOtherJaw(result, verdicts);
  for (JawVerdict & verdict : verdicts)
  {
    SortFindings(verdict.findings);
  }
  return verdicts;
}

std::vector<RegistrationVerdict::JawVerdict>
RegistrationVerdict::Evaluate(const PoseRegistrationResult & result)
{
  return Evaluate(result, Thresholds());
}

bool
RegistrationVerdict::IsAxisBorneOut(const PoseGroupResult &         group,
                                    const PoseJawResult &           jaw,
                                    const JawVerdict &              verdict,
                                    const PoseRegistrationOptions & options,
                                    const Thresholds &              thresholds)
{
  if (!verdict.takenBack.empty())
  {
    return false;
  }
  if (jaw.fit.numberOfPoints == 0)
  {
    return jaw.landmarks.size() + jaw.outlines.size() > 1;
  }
  const bool rotates = !group.bisected && options.useFullPose && !options.fixRotation;
  return rotates && jaw.fit.numberOfPoints > 0 && jaw.fit.cost <= thresholds.borneOutCost &&
         group.margin >= thresholds.borneOutMargin;
}

std::optional<RegistrationFinding>
RegistrationVerdict::JudgeDrafts(double share, const Thresholds & thresholds)
{
  if (!(share > thresholds.suspectDraftedShare))
  {
    return std::nullopt;
  }
  return RegistrationFinding{ StatusEnum::Suspect,
                              "drafts-unmended",
                              FormatNumber(100.0 * share, 0) +
                                " % of this jaw's outlines are drafts as a registration projected them: of these it "
                                "knows only what it said itself, and fit, sigma and expected error look better than "
                                "they are; mend them by the radiograph, or leave them out",
                              share,
                              thresholds.suspectDraftedShare,
                              "" };
}

std::vector<std::string>
RegistrationVerdict::GetNotCheckable(const PoseRegistrationResult & result, const PoseRegistrationOptions & options)
{
  std::vector<std::string> lines;
  lines.emplace_back("source distance, depth and pixel spacing: one view shows their product alone");
  lines.emplace_back("which side the X-ray source was on");
  if (!result.geometry.pixelSpacingKnown)
  {
    lines.emplace_back("pixel spacing: it was not given, the scale is the fit's own");
  }
  if (!result.geometry.principalPointKnown)
  {
    lines.emplace_back("principal point: it was not given, the tracing's centre was used");
  }
  bool registered = false;
  bool coded = false;
  bool traced = false;
  bool closedCast = false;
  for (const PoseJawResult & jaw : result.jaws)
  {
    registered = registered || jaw.registered;
    coded = coded || jaw.fit.hasCodes;
    traced = traced || jaw.fit.numberOfPoints > 0;
    closedCast = closedCast || (jaw.registered && std::abs(jaw.winding) < WindingOfClosedCast);
  }
  // Of a jaw that was not registered nobody looked.
  if (registered && traced && !coded)
  {
    lines.emplace_back("whether each tooth lies on its own: the tracing has no tooth codes");
  }
  if (closedCast)
  {
    lines.emplace_back(ClosedCastLine);
  }
  if (options.useInitialPose || options.fixRotation || options.fixScale || options.fixTranslation)
  {
    lines.emplace_back(
      "exchanged jaws, facing, other side, other minima: not searched beside a given start or held values");
  }
  for (const PoseGroupResult & group : result.groups)
  {
    for (const auto & hypothesis : group.untried)
    {
      lines.push_back("hypothesis \"" + hypothesis.first + "\": not tried, " + hypothesis.second);
    }
  }
  if (IsBisected(options.tracedSide))
  {
    lines.emplace_back("roll and yaw of the head: a bisected tracing does not carry them");
    lines.emplace_back("whether the tracing really is the middle of both sides");
  }
  for (const PoseGroupResult & group : result.groups)
  {
    const auto drawn = [&](std::size_t j) {
      return !result.jaws[j].landmarks.empty() || !result.jaws[j].outlines.empty();
    };
    const auto isTraced = [&](std::size_t j) { return result.jaws[j].fit.numberOfPoints > 0; };
    if (std::count_if(group.jaws.begin(), group.jaws.end(), drawn) == 1 &&
        std::none_of(group.jaws.begin(), group.jaws.end(), isTraced))
    {
      lines.emplace_back("whether what was marked is of this jaw: the same teeth of the other jaw fit as well");
      break;
    }
  }
  lines.emplace_back("a mirrored scan of a nearly symmetric dentition");
  lines.emplace_back("whether scan and radiograph are of one patient, where the dentitions are alike");
  return lines;
}
} // namespace itk

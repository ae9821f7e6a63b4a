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
#include "itkViewVerdict.h"

#include "itkJoinNames.h"
#include "itkOtherViewHypothesis.h"
#include "itkVerdictText.h"

#include <algorithm>
#include <string>

namespace itk
{
RegistrationStatusEnum
ViewVerdict::GetStatus(const std::vector<RegistrationFinding> & findings)
{
  RegistrationStatusEnum worst = RegistrationStatusEnum::Ok;
  for (const RegistrationFinding & finding : findings)
  {
    worst = std::max(worst, finding.severity);
  }
  return worst;
}

RegistrationFinding
ViewVerdict::MakeUnusedFinding()
{
  constexpr auto Suspect = RegistrationStatusEnum::Suspect;
  return { Suspect,      "view-unused", "nothing that was drawn on it can be used: see the warnings",
           std::nullopt, std::nullopt,  "" };
}

std::vector<RegistrationFinding>
ViewVerdict::Evaluate(const PoseRegistrationResult & result, std::size_t index, const Thresholds & thresholds)
{
  using QuestionEnum = OtherViewHypothesis::QuestionEnum;
  const PoseViewResult &           view = result.views.at(index);
  const bool                       isFrontal = view.result.geometry.direction == CephalometricDirectionEnum::Frontal;
  std::vector<RegistrationFinding> findings;
  const auto                       add = [&](RegistrationStatusEnum severity,
                       const char *           code,
                       const std::string &    text,
                       double                 value,
                       double                 limit,
                       const char *           unit) {
    findings.push_back({ severity, code, text, value, limit, unit });
  };
  constexpr auto Suspect = RegistrationStatusEnum::Suspect;

  LandmarkTally tally(thresholds.landmarkApart);
  bool          hasLandmarks = false;
  bool          hasOutlines = false;
  std::size_t   outlinesApart = 0;
  double        cost = 0.0;
  bool          isTraced = false;
  for (const PoseJawResult & jaw : view.result.jaws)
  {
    if (!jaw.registered)
    {
      continue;
    }
    for (const PoseLandmarkFit & landmark : jaw.landmarks)
    {
      tally.Add(landmark.name, landmark.distance);
      hasLandmarks = true;
    }
    for (const PoseOutlineFit & outline : jaw.outlines)
    {
      tally.Add("outline " + outline.name, outline.distance);
      hasOutlines = true;
      outlinesApart += outline.distance > thresholds.landmarkApart ? 1 : 0;
    }
    if (jaw.fit.numberOfPoints > 0)
    {
      isTraced = true;
      cost = std::max(cost, jaw.fit.cost);
    }
  }
  const std::vector<std::string> & apart = tally.GetApart();
  const std::size_t                fitting = tally.GetKept();
  if (apart.empty() && fitting == 0 && !isTraced)
  {
    findings.push_back(MakeUnusedFinding());
    return findings;
  }

  // Another reading of it that explains what nothing else does is said in place of its symptoms. Where most of it
  // contradicts, as a drawing of another scale does, some reading always fits a little better: it has to explain most.
  const auto getDeviance = [&](QuestionEnum question) {
    double best = 0.0;
    for (const PoseGroupResult & group : result.groups)
    {
      const auto * outcome = group.FindOutcome(OtherViewHypothesis::MakeCode(question, view.name));
      best = outcome != nullptr ? std::min(best, outcome->deviance) : best;
    }
    return best;
  };
  const double sides = getDeviance(QuestionEnum::Sides);
  const double source = getDeviance(QuestionEnum::Source);
  const double head = getDeviance(QuestionEnum::Head);
  double       headMove = 0.0;
  for (const PoseGroupResult & group : result.groups)
  {
    if (const auto * outcome = group.FindOutcome(OtherViewHypothesis::MakeCode(QuestionEnum::Head, view.name)))
    {
      headMove = std::max(headMove, outcome->headMove);
    }
  }
  const bool isHeadMoved = head < thresholds.suspectMoveDeviance && headMove > thresholds.suspectHeadMove;
  const bool isContrary = apart.size() > fitting;
  double     readingLimit = thresholds.suspectDeviance;
  if (isContrary)
  {
    readingLimit = std::min(readingLimit,
                            thresholds.suspectDevianceOfLandmark * static_cast<double>(apart.size() - outlinesApart) +
                              thresholds.suspectDevianceOfOutline * static_cast<double>(outlinesApart));
  }
  // Of several that fit better the best one: a head that may be turned explains a part of any other mistake.
  const double best = std::min({ sides, source, isHeadMoved ? head : 0.0 });
  if (sides == best && sides < readingLimit)
  {
    add(Suspect,
        "view-sides",
        std::string("what was drawn on it fits with right and left exchanged: is ") +
          (isFrontal ? "patient_left" : "facing") + " right, or do the names have the wrong sides?",
        sides,
        readingLimit,
        "");
    return findings;
  }
  if (source == best && source < readingLimit)
  {
    add(Suspect,
        "view-source",
        std::string("what was drawn on it fits better with the source on the other side of the head: is ") +
          (isFrontal ? "geometry.source" : "source_side") + " right?",
        source,
        readingLimit,
        "");
    return findings;
  }

  const std::string drawings = !hasOutlines ? "landmarks" : hasLandmarks ? "landmarks and outlines" : "outlines";
  const double      ratio = tally.GetRatio();
  if (isContrary)
  {
    add(
      Suspect,
      "view-disagrees",
      "it contradicts the first radiograph: " + std::to_string(apart.size()) + " of " +
        std::to_string(apart.size() + fitting) + " " + drawings + " do not fit (" + JoinNames(apart) +
        "); is it of the same patient, marked in pixels of this very picture, and are its geometry and principal point "
        "right?",
      tally.GetLargest(),
      thresholds.landmarkApart,
      "sd");
  }
  else if (!apart.empty())
  {
    add(Suspect,
        "view-landmark-apart",
        drawings + " on it stand apart and were let go: " + JoinNames(apart),
        tally.GetLargest(),
        thresholds.landmarkApart,
        "sd");
  }
  else if (ratio > thresholds.suspectLandmarkRatio)
  {
    add(Suspect,
        "view-landmarks-rough",
        "the " + drawings + " on it lie " + FormatNumber(ratio, 1) +
          " standard deviations from where they are expected",
        ratio,
        thresholds.suspectLandmarkRatio,
        "");
  }
  if (isTraced && cost > thresholds.suspectCost)
  {
    add(Suspect,
        "view-poor-fit",
        "its tracing fits poorly: is it of the crowns, and of the side that \"traced_side\" says?",
        cost,
        thresholds.suspectCost,
        "");
  }
  double tension = 0.0;
  for (const double own : view.priorTensions)
  {
    tension = std::max(tension, own);
  }
  if (tension > thresholds.suspectPriorTension || isHeadMoved)
  {
    const bool isTense = tension > thresholds.suspectPriorTension;
    add(Suspect,
        "view-head-moved",
        view.sameHeadPosition
          ? "it fits better with the head elsewhere, or at another scale, than in the first one: say "
            "\"same_head_position\": false where the patient was turned, and check that it is of this patient, its "
            "principal "
            "point and pixel spacing"
          : "it fits only with the head far from where it was in the first one, or at another scale: check that it "
            "is of this patient, its principal point and pixel spacing",
        isTense ? tension : head,
        isTense ? thresholds.suspectPriorTension : thresholds.suspectMoveDeviance,
        isTense ? "sd" : "");
  }
  return findings;
}
} // namespace itk

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
#include "itkPoseTerms.h"

#include "itkGemanMcClureKernel.h"
#include "itkGroupByReason.h"
#include "itkJoinNames.h"
#include "itkPoseFrameOperations.h"

#include <algorithm>
#include <vector>

namespace itk
{
namespace
{
/** Those of a jaw that were marked, in its dental frame. */
LandmarkCounterpartSet::Pointer
MakeCounterparts(const PoseJawInput &             jaw,
                 const LandmarkCounterpartSet *   all,
                 const CephalometricLandmarkSet * landmarks)
{
  const auto counterparts = LandmarkCounterpartSet::New();
  for (LandmarkCounterpartSet::CounterpartType counterpart : all->GetCounterparts())
  {
    if (counterpart.jaw != jaw.jaw || landmarks->Find(counterpart.name) == nullptr)
    {
      continue;
    }
    for (auto & point : counterpart.points)
    {
      const auto q = ToDentalFrame(jaw.frame, { { point[0], point[1], point[2] } });
      std::copy(q.begin(), q.end(), point.Begin());
    }
    counterparts->Add(counterpart);
  }
  return counterparts;
}

} // namespace

std::shared_ptr<const TriangleSurface>
ToDentalFrame(const TriangleSurface & surface, const PoseFrame & frame)
{
  auto moved = std::make_shared<TriangleSurface>();
  moved->triangles = surface.triangles;
  moved->points.resize(surface.points.size());
  for (std::size_t i = 0; i < surface.points.size(); ++i)
  {
    const auto q = ToDentalFrame(frame, { { surface.points[i][0], surface.points[i][1], surface.points[i][2] } });
    for (int k = 0; k < 3; ++k)
    {
      moved->points[i][k] = q[k];
    }
  }
  return moved;
}

LandmarkPoseMetricv4::Pointer
MakeLandmarkTerm(const PoseJawInput &               jaw,
                 const LandmarkCounterpartSet *     all,
                 const CephalometricLandmarkSet *   landmarks,
                 const CephalometricPoseTransform * transform,
                 const PoseRegistrationOptions &    options)
{
  if (landmarks == nullptr || all == nullptr)
  {
    return nullptr;
  }
  const auto counterparts = MakeCounterparts(jaw, all, landmarks);
  if (counterparts->GetCounterparts().empty())
  {
    return nullptr;
  }
  auto term = LandmarkPoseMetricv4::New();
  term->SetTransform(transform);
  term->SetCounterparts(counterparts);
  term->SetCephalometricLandmarks(landmarks);
  if (options.useRobustKernel)
  {
    term->SetRobustKernel(GemanMcClureKernel::New());
  }
  return term;
}

SilhouettePoseMetricv4::Pointer
MakeSilhouetteTerm(ToothCode::JawEnum                 jaw,
                   const DentalContour *              tracing,
                   const CephalometricPoseTransform * transform,
                   const PoseRegistrationOptions &    options)
{
  auto term = SilhouettePoseMetricv4::New();
  term->SetTransform(transform);
  term->SetFixedContour(tracing);
  term->SetJaw(jaw);
  term->SetTracedSide(options.tracedSide);
  term->SetUseSideSelection(options.useSideSelection);
  term->SetMidlineMargin(options.midlineMargin);
  term->SetUseFacingFilter(options.useFacingFilter);
  term->SetUseOrientation(options.useOrientation);
  term->SetOrientationWeight(options.orientationWeight);
  term->SetGateByTooth(options.gateByTooth);
  term->SetToothRange(options.toothRange);
  term->SetReverseWeight(options.reverseWeight);
  term->SetTaperLength(options.taperLength);
  term->SetGapLength(options.gapLength);
  term->SetMaximumTracingPoints(options.maximumTracingPoints);
  term->SetExcludedTeeth(options.excludedTeeth);
  return term;
}

ToothCrownSet::Pointer
ToDentalFrame(const ToothCrownSet * crowns, const PoseJawInput & jaw)
{
  const auto moved = ToothCrownSet::New();
  if (crowns != nullptr)
  {
    for (ToothCrownSet::CrownType crown : crowns->GetCrowns())
    {
      if (crown.tooth.GetJaw() == jaw.jaw)
      {
        crown.surface = ToDentalFrame(*crown.surface, jaw.frame);
        crown.profile = crown.profile ? ToDentalFrame(*crown.profile, jaw.frame) : nullptr;
        moved->Add(crown);
      }
    }
  }
  return moved;
}

ToothOutlinePoseMetricv4::Pointer
MakeOutlineTerm(const PoseJawInput &               jaw,
                const ToothCrownSet *              crowns,
                const DentalContour *              tracing,
                const CephalometricLandmarkSet *   landmarks,
                LandmarkPoseMetricv4 *             landmarkTerm,
                const CephalometricPoseTransform * transform,
                const PoseRegistrationOptions &    options)
{
  auto term = ToothOutlinePoseMetricv4::New();
  term->SetTransform(transform);
  term->SetCrowns(crowns);
  term->SetFixedContour(tracing);
  term->SetJaw(jaw.jaw);
  term->SetExcludedTeeth(options.excludedTeeth);
  if (landmarkTerm != nullptr)
  {
    std::vector<ToothCode> marked;
    for (const auto & landmark : landmarks->GetLandmarks())
    {
      if (landmark.meaning.jaw == jaw.jaw &&
          landmarkTerm->GetCounterparts()->Find(CephalometricLandmarkSet::MakeName(landmark.meaning)) != nullptr)
      {
        // Without a side it is the analysis's own tooth, of whichever side.
        const unsigned int right = jaw.jaw == ToothCode::JawEnum::Upper ? 10 : 40;
        marked.push_back(landmark.meaning.tooth.IsKnown() ? landmark.meaning.tooth
                                                          : ToothCode(right + landmark.meaning.position));
      }
    }
    term->SetMarkedTeeth(marked);
    // What a textbook's place gets wrong, landmark and crown get wrong alike: both together were worse than one.
    constexpr double surestPlaceOfATextbook = 1.0;
    term->SetMaximumCutSigma(surestPlaceOfATextbook);
  }
  term->Prepare();
  if (landmarkTerm != nullptr && term->GetFailure().empty())
  {
    landmarkTerm->SetOutlinedTeeth(term->GetOutlinedTeeth());
  }
  return term;
}

std::vector<std::string>
DescribeUnused(const ToothOutlinePoseMetricv4 & term)
{
  std::vector<std::string> lines;
  for (const auto & entry : GroupByReason(term.GetUnused()))
  {
    lines.push_back((entry.second.size() > 1 ? "outlines " : "outline ") + JoinNames(entry.second) + ": " +
                    entry.first);
  }
  return lines;
}
} // namespace itk

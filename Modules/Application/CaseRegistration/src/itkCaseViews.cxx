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
#include "itkCaseViews.h"

#include "itkLandmarkProjectionFilter.h"
#include "itkViewVerdict.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace itk
{
namespace
{
using JawEnum = ToothCode::JawEnum;

/** Whether two radiographs have the same polylines, to the last point. */
bool
IsSameContour(const DentalContour * one, const DentalContour * other)
{
  if (one == nullptr || other == nullptr || one->GetNumberOfPoints() == 0)
  {
    return false;
  }
  const auto a = one->GetPolylines();
  const auto b = other->GetPolylines();
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto & p, const auto & q) {
    return p.code == q.code && p.points == q.points;
  });
}

/** Whether two radiographs have the same marks, to the last digit. */
bool
IsSameLandmarks(const CephalometricLandmarkSet * one, const CephalometricLandmarkSet * other)
{
  if (one == nullptr || other == nullptr || one->GetLandmarks().empty())
  {
    return false;
  }
  const auto & a = one->GetLandmarks();
  const auto & b = other->GetLandmarks();
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto & p, const auto & q) {
    return p.name == q.name && p.point == q.point;
  });
}

/** The first radiograph's, as a view's. */
struct FirstRadiograph
{
  const DentalContour *
  GetContour(JawEnum jaw) const
  {
    return data.GetJaw(jaw).contour;
  }
  const DentalCaseData &           data;
  const CephalometricLandmarkSet * cephalometricLandmarks;
};
} // namespace

std::shared_ptr<DentalCaseData>
MakeCaseOfView(const DentalCaseData & data, const DentalViewData & view)
{
  auto own = std::make_shared<DentalCaseData>(data);
  static_cast<DentalRadiographData &>(*own) = view;
  static_cast<DentalRadiograph &>(own->description) = view.description;
  own->description.contourClassFiles.clear();
  own->description.views.clear();
  own->views.clear();
  own->inputs.clear();
  own->warnings.clear();
  own->upper.contour = view.contours[0];
  own->lower.contour = view.contours[1];
  if (view.description.direction == CephalometricGeometry::DirectionEnum::Frontal)
  {
    // Names and codes of a frontal radiograph have the sides that they say.
    own->description.tracedSide = TracedSideEnum::Both;
  }
  return own;
}

CaseViews::CaseViews(const DentalCaseData & data, CaseAxisType * axis, CaseResult & result)
  : m_Data(data)
{
  const FirstRadiograph first{ data, data.cephalometricLandmarks.GetPointer() };
  for (std::size_t v = 0; v < data.views.size(); ++v)
  {
    const DentalViewData & view = data.views[v];
    const std::string      prefix = "view " + view.description.name + ": ";
    // Of the first radiograph, or of a view before this one.
    const auto findTwin = [&](const auto & isTwin) {
      if (isTwin(first))
      {
        return std::string("the first radiograph");
      }
      const auto twin = std::find_if(data.views.begin(), data.views.begin() + static_cast<std::ptrdiff_t>(v), isTwin);
      return twin == data.views.begin() + static_cast<std::ptrdiff_t>(v) ? std::string()
                                                                         : "view " + twin->description.name;
    };
    const auto isOwn = [&](const std::string & what, const std::string & twin) {
      if (!twin.empty())
      {
        result.warnings.push_back(prefix + what + " not used: it is the drawing of " + twin +
                                  ", to the last digit, and would count twice; name what was drawn on this radiograph");
      }
      return twin.empty();
    };
    if (view.description.direction == CephalometricGeometry::DirectionEnum::Lateral)
    {
      result.warnings.push_back("view " + view.description.name +
                                " is a second lateral radiograph: it says nothing of how far the jaws stand to a side");
    }
    auto own = CephalogramView::New();
    own->SetName(view.description.name);
    own->SetGeometry(view.geometry);
    const auto usable = [&](JawEnum jaw) {
      const DentalContour * const drawn = view.GetContour(jaw);
      return data.GetJaw(jaw).mesh.IsNotNull() && CountTracingPoints(drawn) > 0 &&
                 isOwn(std::string("the ") + ToString(jaw) + " tracing is",
                       findTwin([&](const auto & other) { return IsSameContour(drawn, other.GetContour(jaw)); }))
               ? drawn
               : nullptr;
    };
    own->SetUpperContour(usable(JawEnum::Upper));
    own->SetLowerContour(usable(JawEnum::Lower));
    if (view.cephalometricLandmarks.IsNotNull() && isOwn("its file of landmarks is", findTwin([&](const auto & other) {
                                                           return IsSameLandmarks(view.cephalometricLandmarks,
                                                                                  other.cephalometricLandmarks);
                                                         })))
    {
      const auto counterparts = FindCaseCounterparts(data,
                                                     view.cephalometricLandmarks,
                                                     view.description.direction,
                                                     false,
                                                     axis,
                                                     "view " + view.description.name + ": ",
                                                     result);
      if (!counterparts->GetCounterparts().empty())
      {
        own->SetCephalometricLandmarks(view.cephalometricLandmarks);
        own->SetLandmarkCounterparts(counterparts);
      }
    }
    own->SetSameHeadPosition(view.description.sameHeadPosition);
    own->SetPrincipalPointSigma(view.principalPointSigma);
    own->SetSpacingSource(SpacingSourceOf(view));
    if (own->GetUpperContour() == nullptr && own->GetLowerContour() == nullptr &&
        own->GetCephalometricLandmarks() == nullptr)
    {
      m_Unused.push_back(&view);
      continue;
    }
    m_Views.push_back(own);
    m_ViewData.push_back(&view);
  }
}

bool
CaseViews::HasEvidence(JawEnum jaw) const
{
  return std::any_of(m_Views.begin(), m_Views.end(), [jaw](const auto & view) {
    if (view->GetContour(jaw) != nullptr)
    {
      return true;
    }
    const auto * counterparts = view->GetLandmarkCounterparts();
    return counterparts != nullptr && std::any_of(counterparts->GetCounterparts().begin(),
                                                  counterparts->GetCounterparts().end(),
                                                  [jaw](const auto & counterpart) { return counterpart.jaw == jaw; });
  });
}

void
CaseViews::Describe(const PoseSolution &              solution,
                    const RegistrationVerdictFilter & verdict,
                    const CasePoseSettings &          settings,
                    CaseResult &                      result) const
{
  for (std::size_t v = 0; v < m_Views.size(); ++v)
  {
    const DentalViewData &      data = *m_ViewData[v];
    const PoseViewResult &      found = solution.GetView(data.description.name);
    const PoseSolution::Pointer own = solution.MakeViewSolution(data.description.name);
    CaseViewResult              view;
    view.name = data.description.name;
    view.sameHeadPosition = data.description.sameHeadPosition;
    view.findings = verdict.GetViewVerdict(view.name).findings;
    view.status = verdict.GetViewVerdict(view.name).status;
    view.result = std::make_shared<CaseResult>();
    CaseResult & shown = *view.result;
    shown.preset = result.preset;
    shown.viewName = view.name;
    shown.data = MakeCaseOfView(m_Data, data);
    shown.geometry = CephalometricGeometry::New();
    shown.geometry->CopyParameters(data.geometry);
    shown.jawsShareFrame = result.jawsShareFrame;
    shown.unusableLandmarks = result.unusableLandmarks;
    const auto silhouettes =
      MakeWholeSilhouettes(m_Data, *own, settings.numberOfContourPoints, settings.numberOfThreads);
    for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
    {
      if (!own->IsRegistered(jaw))
      {
        continue;
      }
      JawResult &           place = shown.jaws[jaw];
      const PoseJawResult & poseJaw = own->GetJaw(jaw);
      const std::size_t     group = own->GetResult().groupOfJaw[static_cast<std::size_t>(own->GetIndex(jaw))];
      view.moves[jaw] = found.moves[group];
      view.moveSigmas[jaw] = found.moveSigmas[group];
      view.scaleFactors[jaw] = std::exp(own->GetGroup(jaw).parameters[PoseKappa]);
      place.status = view.status;
      DescribePlacedJaw(*own, jaw, m_Data.description.millimetresPerUnit, m_Views[v]->GetLandmarkCounterparts(), place);
      const DentalContour::Pointer whole = silhouettes[jaw == JawEnum::Upper ? 0 : 1];
      DentalContour *              tracing = shown.data->GetJaw(jaw).contour;
      if (tracing != nullptr && tracing->GetNumberOfPoints() > 0 && poseJaw.fit.numberOfPoints > 0)
      {
        Measure(tracing, whole, "whole", place);
        MeasureMatched(tracing, *own, jaw, place);
        MeasureTeeth(tracing, place.contours.back().second, place);
      }
      else
      {
        DescribeWithoutDistances(*own, jaw, whole, place);
      }
      for (const std::string & unused : poseJaw.unusedOutlines)
      {
        result.warnings.push_back("view " + view.name + ": " + unused);
      }
      if (!poseJaw.tracingFailure.empty() && poseJaw.unusedOutlines.empty())
      {
        result.warnings.push_back("view " + view.name + ": the " + ToString(jaw) +
                                  " tracing is not used: " + poseJaw.tracingFailure);
      }
    }
    // A view's own landmarks_px are of landmarks_3d; tips and cusps without them are told of the first radiograph.
    ProjectLandmarks(*shown.data, own, nullptr, shown);
    for (auto & entry : shown.jaws)
    {
      if (!entry.second.expectedError)
      {
        entry.second.expectedError = LandmarkProjectionFilter::ToMeanDistance(own->GetMiddleSigma(entry.first));
      }
      LeaveOutBoundlessError(shown.data->imageSize, entry.second);
    }
    result.views.push_back(std::move(view));
  }
  for (const DentalViewData * data : m_Unused)
  {
    CaseViewResult view;
    view.name = data->description.name;
    view.sameHeadPosition = data->description.sameHeadPosition;
    view.findings = { ViewVerdict::MakeUnusedFinding() };
    view.status = ViewVerdict::GetStatus(view.findings);
    view.result = std::make_shared<CaseResult>();
    CaseResult & shown = *view.result;
    shown.preset = result.preset;
    shown.viewName = view.name;
    shown.data = MakeCaseOfView(m_Data, *data);
    shown.geometry = CephalometricGeometry::New();
    shown.geometry->CopyParameters(data->geometry);
    shown.jawsShareFrame = result.jawsShareFrame;
    result.views.push_back(std::move(view));
  }
}
} // namespace itk

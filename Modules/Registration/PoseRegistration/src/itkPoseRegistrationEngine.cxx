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
#include "itkPoseRegistrationEngine.h"

#include "itkFindSilhouettes.h"
#include "itkFindTemplates.h"
#include "itkLandmarkPoseStart.h"
#include "itkPoseFrameOperations.h"
#include "itkPoseGeometryCompletion.h"
#include "itkPoseJawDescription.h"
#include "itkPoseTerms.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

namespace itk
{
std::vector<PoseRegistrationEngine::JawType>
PoseRegistrationEngine::PrepareJaws(const PoseProblem &      problem,
                                    const PoseGeometry &     geometry,
                                    PoseRegistrationResult & result) const
{
  const PoseRegistrationOptions & options = problem.options;
  std::vector<JawType>            jaws(problem.jaws.size());
  std::vector<std::string>        tracingFailures(problem.jaws.size());
  auto                            transform = CephalometricPoseTransform::New();
  transform->SetPoseGeometry(geometry);
  for (std::size_t j = 0; j < jaws.size(); ++j)
  {
    const PoseJawInput & input = problem.jaws[j];
    result.jaws[j].jaw = input.jaw;
    result.jaws[j].frame = input.frame;
    if (input.surface == nullptr || input.surface->triangles.empty())
    {
      result.jaws[j].failure = "there is no surface";
      continue;
    }
    jaws[j].crowns = ToDentalFrame(input.crowns, input);
    jaws[j].landmarks = MakeLandmarkTerm(input, input.counterparts, input.landmarks, transform, options);
    if (input.tracing.IsNull())
    {
      continue;
    }
    if (options.tracedSide == TracedSideEnum::Standard)
    {
      const auto outlines =
        MakeOutlineTerm(input, jaws[j].crowns, input.tracing, input.landmarks, jaws[j].landmarks, transform, options);
      outlines->SetDrawing(problem.drawing);
      tracingFailures[j] = outlines->GetFailure();
      result.jaws[j].unusedOutlines = DescribeUnused(*outlines);
      jaws[j].outlines = tracingFailures[j].empty() ? outlines : nullptr;
      continue;
    }
    jaws[j].metric = MakeSilhouetteTerm(input.jaw, input.tracing, transform, options);
  }
  monitor->ForEach(jaws.size(), options.numberOfThreads, [&](std::size_t j) {
    if (!result.jaws[j].failure.empty())
    {
      return;
    }
    jaws[j].surface = ToDentalFrame(*problem.jaws[j].surface, problem.jaws[j].frame);
    this->PrepareViews(problem, j, jaws[j]);
    if (jaws[j].metric.IsNotNull())
    {
      jaws[j].metric->SetMovingSurface(jaws[j].surface);
      jaws[j].metric->Prepare();
      tracingFailures[j] = jaws[j].metric->GetFailure();
      if (!tracingFailures[j].empty())
      {
        jaws[j].metric = nullptr;
      }
    }
    // Landmarks and other views speak for the jaw where its tracing cannot. Of outlines each one is said to be unused.
    if (jaws[j].landmarks.IsNull() && !jaws[j].HasEvidenceOfAView())
    {
      result.jaws[j].failure = tracingFailures[j];
    }
    else if (options.tracedSide != TracedSideEnum::Standard)
    {
      result.jaws[j].tracingFailure = tracingFailures[j];
    }
  });
  return jaws;
}

PoseRegistrationEngine::MetricType::Pointer
PoseRegistrationEngine::MakeMetric(const PoseProblem &              problem,
                                   const PoseGeometry &             geometry,
                                   const std::vector<JawType> &     jaws,
                                   const std::vector<std::size_t> & members) const
{
  auto sum = MetricType::New();
  for (const std::size_t j : members)
  {
    if (jaws[j].metric.IsNotNull())
    {
      sum->AddMetric(jaws[j].metric);
    }
  }
  PosePriors(problem.options, geometry.pixelSpacingKnown).AddTo(*sum);
  for (const std::size_t j : members)
  {
    if (jaws[j].outlines.IsNotNull())
    {
      sum->AddMetric(jaws[j].outlines, MetricType::SettingsEnum::Own);
    }
    if (jaws[j].landmarks.IsNotNull())
    {
      // The errors of marks and of whole teeth are known: neither the width nor the levels that a tracing's points go
      // through are theirs.
      sum->AddMetric(jaws[j].landmarks, MetricType::SettingsEnum::Own);
    }
  }
  AddViews(problem, jaws, members, *sum);
  for (const PoseProblemTerm & term : problem.terms)
  {
    // What a user has set of kernel and noise is the user's.
    sum->AddMetric(term.metric, MetricType::SettingsEnum::Own);
  }
  sum->Initialize();
  return sum;
}

PoseRegistrationResult
PoseRegistrationEngine::Run(const PoseProblem & asked, std::vector<GroupType> * answered) const
{
  PoseProblem                     problem = asked;
  const PoseRegistrationOptions & options = problem.options;
  PoseRegistrationResult          result;
  result.geometry = problem.completed ? *problem.completed : CompleteGeometry(problem);
  CheckGeometry(result.geometry);
  std::vector<ToothOutlineComparison::TemplateType> templates;
  if (options.tracedSide == TracedSideEnum::Standard)
  {
    templates = FindTemplates(problem, result.geometry);
    if (!templates.empty())
    {
      // By one hand all alike.
      problem.drawing = ToothOutlinePoseMetricv4::DrawingEnum::ByTemplate;
    }
  }
  result.jaws.resize(problem.jaws.size());
  const std::vector<JawType> jaws = this->PrepareJaws(problem, result.geometry, result);

  // Groups of jaws with one pose.
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t j = 0; j < jaws.size(); ++j)
  {
    const bool anyEvidence =
      jaws[j].HasEvidence() || (options.useJointPose && std::any_of(jaws.begin(), jaws.end(), [](const JawType & jaw) {
                                  return jaw.HasEvidence();
                                }));
    if (result.jaws[j].failure.empty() && !anyEvidence)
    {
      result.jaws[j].failure = jaws[j].HasEvidenceOfAView()
                                 ? "it was drawn on a further view alone, and no other jaw shares its frame: a start "
                                   "is searched on the lateral one"
                                 : "nothing was drawn of this jaw, and no other jaw shares its frame";
    }
    if (!result.jaws[j].failure.empty())
    {
      continue;
    }
    if (options.useJointPose && !groups.empty())
    {
      groups[0].push_back(j);
    }
    else
    {
      groups.push_back({ j });
    }
  }
  result.groupOfJaw.assign(jaws.size(), groups.size());
  for (std::size_t g = 0; g < groups.size(); ++g)
  {
    const std::vector<std::size_t> & members = groups[g];
    const auto                       index = static_cast<unsigned int>(g);
    PoseProblem                      own = problem;
    own.completed = result.geometry;
    own.jaws.clear();
    own.terms.clear();
    for (const std::size_t j : members)
    {
      own.jaws.push_back(problem.jaws[j]);
    }
    std::copy_if(
      problem.terms.begin(), problem.terms.end(), std::back_inserter(own.terms), [&own](const PoseProblemTerm & term) {
        return term.jaw == ToothCode::JawEnum::Unknown ||
               std::any_of(
                 own.jaws.begin(), own.jaws.end(), [&](const PoseJawInput & jaw) { return jaw.jaw == term.jaw; });
      });
    const auto started = std::find_if(
      own.jaws.begin(), own.jaws.end(), [](const PoseJawInput & jaw) { return jaw.initialPose.has_value(); });
    if (started != own.jaws.end())
    {
      own.options.initialPose = *started->initialPose;
      if (problem.initialGeometry)
      {
        const auto centroid = started->surface->AreaCentroid();
        const auto middle = ToDentalFrame(started->frame, { { centroid[0], centroid[1], centroid[2] } });
        own.options.initialPose =
          PoseModel::ConvertPose(*problem.initialGeometry, own.options.initialPose, result.geometry, middle.data());
      }
      own.options.useInitialPose = true;
    }
    PoseGroupResult group;
    group.jaws = members;
    group.bisected = IsBisected(options.tracedSide);
    const MetricType::Pointer metric = this->MakeMetric(own, result.geometry, jaws, members);
    if (groupObserver)
    {
      groupObserver(index, static_cast<unsigned int>(groups.size()), metric);
    }
    PoseGroupRegistration registration(
      own.options,
      result.geometry.pixelSpacingKnown,
      metric,
      parts,
      optimizer,
      start,
      *monitor,
      [&](PoseStageEnum stage) {
        if (stageObserver)
        {
          stageObserver(index, stage);
        }
      },
      index,
      false);
    if (!registration.Run(group))
    {
      result.aborted = true;
      return result;
    }
    if (group.candidates.empty())
    {
      for (const std::size_t j : members)
      {
        result.jaws[j].failure = "no start was found: nothing of what was drawn can be matched with the surface";
      }
      result.groups.push_back(std::move(group));
      continue;
    }
    const GroupType answer{ own, registration.GetMetric(), registration.GetSolution(), index };
    this->TryHypotheses(answer, group);
    if (answered != nullptr)
    {
      answered->push_back(answer);
    }
    if (monitor->IsAborted())
    {
      result.aborted = true;
      return result;
    }
    const auto  silhouettes = FindSilhouettes(*metric, registration.GetSolution());
    const auto  landmarks = LandmarkPoseStart::FindTerms(*metric);
    const auto  outlines = LandmarkPoseStart::FindOutlineTerms(*metric);
    std::size_t nextSilhouette = 0;
    std::size_t nextLandmarks = 0;
    std::size_t nextOutlines = 0;
    for (std::size_t m = 0; m < members.size(); ++m)
    {
      PoseJawResult & jaw = result.jaws[members[m]];
      result.groupOfJaw[members[m]] = g;
      jaw.registered = true;
      PlaceJaw(result.geometry, group.parameters, jaw);
      DescribeJaw(problem.jaws[members[m]], *jaws[members[m]].surface, options, jaw);
      // The jaws' terms are the sum's first of their kind, in the order of the jaws.
      const JawType & prepared = jaws[members[m]];
      jaw.placedByOther = !prepared.HasEvidence() && !prepared.HasEvidenceOfAView();
      if (prepared.metric.IsNotNull())
      {
        const FoundSilhouette & found = silhouettes[nextSilhouette++];
        DescribeFit(*found.metric, found.position, group.covariance, result.geometry, jaw);
      }
      const std::vector<double> pose(group.parameters.begin(), group.parameters.end());
      if (prepared.outlines.IsNotNull())
      {
        DescribeOutlines(*outlines[nextOutlines++], templates, pose, jaw);
      }
      if (prepared.landmarks.IsNotNull())
      {
        DescribeLandmarks(*landmarks[nextLandmarks++], pose, jaw);
      }
      DescribeMiddle(
        *prepared.surface, result.geometry, PoseModel(result.geometry, group.parameters), group.covariance, jaw);
    }
    result.groups.push_back(std::move(group));
  }
  this->DescribeViews(problem, jaws, result);
  return result;
}

std::string
PoseRegistrationEngine::GetObstacle(const PoseProblem & problem)
{
  const PoseRegistrationOptions & options = problem.options;
  const bool isHeld = options.useInitialPose || options.fixRotation || options.fixScale || options.fixTranslation;
  return isHeld ? "beside a given start or held values any free search looks better" : "";
}

void
PoseRegistrationEngine::TryHypotheses(const GroupType & group, PoseGroupResult & result) const
{
  if (!group.problem.options.checkHypotheses || !GetObstacle(group.problem).empty())
  {
    return;
  }
  std::size_t done = 0;
  const auto  tellDone = [&]() {
    if (hypothesisObserver)
    {
      hypothesisObserver(group.index, static_cast<double>(done) / static_cast<double>(hypotheses.size()));
    }
    ++done;
  };
  for (const auto & hypothesis : hypotheses)
  {
    tellDone();
    if (monitor->IsAborted())
    {
      return;
    }
    if (!hypothesis->IsWorthTrying(group.problem, result))
    {
      continue;
    }
    const std::string obstacle = hypothesis->GetObstacle(group.problem);
    if (!obstacle.empty())
    {
      result.untried[hypothesis->GetCode()] = obstacle;
      continue;
    }
    const auto outcome = this->TryHypothesis(group, *hypothesis);
    if (!outcome)
    {
      return;
    }
    result.outcomes[hypothesis->GetCode()] = *outcome;
  }
  tellDone();
}

std::optional<PoseHypothesisOutcome>
PoseRegistrationEngine::TryHypothesis(const GroupType & group, const PoseHypothesis & hypothesis) const
{
  PoseProblem question = hypothesis.Apply(group.problem);
  question.options.useJointPose = true;
  if (hypothesis.GetBeginsAtSolution())
  {
    const RegistrationState & state = group.metric->GetState();
    std::copy_n(group.solution.begin() + static_cast<std::ptrdiff_t>(state.GetOffset("pose")),
                PoseKappa,
                question.options.initialPose.begin());
    question.options.initialPose[PoseKappa] = group.solution[state.GetOffset("scale")];
    question.options.useInitialPose = true;
  }
  PoseRegistrationResult answer;
  answer.geometry = question.completed ? *question.completed : CompleteGeometry(question);
  answer.jaws.resize(question.jaws.size());
  const std::vector<JawType> jaws = this->PrepareJaws(question, answer.geometry, answer);
  std::vector<std::size_t>   members;
  for (std::size_t j = 0; j < jaws.size(); ++j)
  {
    if (answer.jaws[j].failure.empty() && (jaws[j].HasEvidence() || jaws[j].HasEvidenceOfAView()))
    {
      members.push_back(j);
    }
  }
  PoseHypothesisOutcome outcome;
  if (members.empty() || monitor->IsAborted())
  {
    return outcome;
  }
  PoseGroupResult           result;
  const MetricType::Pointer metric = this->MakeMetric(question, answer.geometry, jaws, members);
  PoseGroupRegistration     other(
    question.options,
    answer.geometry.pixelSpacingKnown,
    metric,
    parts,
    optimizer,
    start,
    *monitor,
    [](PoseStageEnum) {},
    group.index,
    true);
  if (!other.Run(result))
  {
    return std::nullopt;
  }
  if (!result.candidates.empty())
  {
    outcome.score = result.score;
    outcome.headMove = ComputeHeadMove(group.problem, question, result);
    for (unsigned int d = 0; d < 2; ++d)
    {
      outcome.pixelSpacing[d] = answer.geometry.pixelSpacing[d] * std::exp(-result.parameters[PoseKappa]);
    }
    if (hypothesis.GetComparesDeviance() && hypothesis.GetBeginsAtSolution())
    {
      outcome.deviance = CandidatePosterior::ComputeCriterion(*other.GetMetric(), other.GetSolution(), *group.metric) -
                         CandidatePosterior::ComputeCriterion(*group.metric, group.solution, *group.metric);
    }
    else if (hypothesis.GetComparesDeviance())
    {
      std::array<double, 2> deviance{};
      monitor->ForEach(2, group.problem.options.numberOfThreads, [&](std::size_t k) {
        deviance[k] = k == 0 ? CandidatePosterior::ComputeEvidence(*group.metric, group.solution)
                             : CandidatePosterior::ComputeEvidence(*other.GetMetric(), other.GetSolution());
      });
      outcome.deviance = deviance[1] - deviance[0];
    }
  }
  return outcome;
}
} // namespace itk

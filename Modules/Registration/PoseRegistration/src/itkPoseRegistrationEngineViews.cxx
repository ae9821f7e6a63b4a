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

#include "itkCorrelatedNoiseModel.h"
#include "itkGemanMcClureKernel.h"
#include "itkParameterPriorMetricv4.h"
#include "itkPoseCovariance.h"
#include "itkPoseJawDescription.h"
#include "itkPoseStateBlocks.h"
#include "itkPoseTerms.h"
#include "itkViewPoseMetricv4.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

// What the engine does with the views beside the first one: their terms, and what the result says of them.
namespace itk
{
namespace
{
/** px of 0.25 mm: noise of a tracing of crowns on a further lateral view, wide, as its levels are not estimated as
 * those of the first one are. */
constexpr ContourNoiseLevels OutlineNoise{ 4.0, 0.6 };

/** What is known of how far the head was moved for a view, 1 sd: of a patient who was turned in the ear rods pitch,
 * roll, yaw (rad) and shifts (mm); where the head stood still only what the principal point leaves open, along the
 * film. */
constexpr double Degree = 0.017453292519943295;
constexpr double MoveSigmas[6] = { 3.0 * Degree, 1.5 * Degree, 1.5 * Degree, 1.5, 1.5, 1.5 };

std::array<double, 6>
MakeMoveSigmas(const PoseViewInput & view)
{
  std::array<double, 6> sigmas{};
  const double          demagnified = view.geometry.sourceToMidsagittal / view.geometry.sourceToDetector;
  for (unsigned int k = 0; k < 6; ++k)
  {
    sigmas[k] = view.sameHeadPosition ? 0.0 : MoveSigmas[k];
  }
  const unsigned int along[2] = { PoseTx + view.geometry.GetFilmAxis(), PoseTz };
  for (unsigned int d = 0; d < 2; ++d)
  {
    sigmas[along[d]] =
      std::hypot(sigmas[along[d]], view.principalPointSigma * view.geometry.pixelSpacing[d] * demagnified);
  }
  return sigmas;
}
} // namespace

void
PoseRegistrationEngine::PrepareViews(const PoseProblem & problem, std::size_t j, JawType & prepared) const
{
  const PoseJawInput & input = problem.jaws[j];
  const std::size_t    index = input.jaw == ToothCode::JawEnum::Upper ? 0 : 1;
  prepared.views.resize(problem.views.size());
  for (std::size_t v = 0; v < problem.views.size(); ++v)
  {
    const PoseViewInput & view = problem.views[v];
    JawType::ViewType &   own = prepared.views[v];
    auto                  transform = CephalometricPoseTransform::New();
    transform->SetPoseGeometry(view.geometry);
    own.landmarks = MakeLandmarkTerm(input, view.counterparts, view.landmarks, transform, problem.options);
    if (view.tracings[index].IsNull())
    {
      continue;
    }
    if (view.geometry.direction == CephalometricDirectionEnum::Frontal)
    {
      // Teeth stand behind one another there, and the outer outline of the jaw is mostly that of others than were
      // drawn: each is compared with its own crown.
      const auto outlines = MakeOutlineTerm(
        input, prepared.crowns, view.tracings[index], view.landmarks, own.landmarks, transform, problem.options);
      own.failure = outlines->GetFailure();
      own.unusedOutlines = DescribeUnused(*outlines);
      own.outlines = own.failure.empty() ? outlines : nullptr;
      continue;
    }
    PoseRegistrationOptions options = problem.options;
    // Whole teeth of a standard tracing are drawn on the first view.
    options.tracedSide =
      problem.options.tracedSide == TracedSideEnum::Standard ? TracedSideEnum::Right : problem.options.tracedSide;
    own.silhouette = MakeSilhouetteTerm(input.jaw, view.tracings[index], transform, options);
    if (options.useRobustKernel)
    {
      own.silhouette->SetRobustKernel(GemanMcClureKernel::New());
    }
    auto noise = CorrelatedNoiseModel::New();
    noise->SetCorrelationLength(options.useCorrelatedNoise ? options.correlationLength : 0.0);
    own.silhouette->SetNoiseModel(noise);
    own.silhouette->SetNoiseLevels(OutlineNoise);
    own.silhouette->SetKernelWidth(options.adaptiveKernelFactor * std::hypot(OutlineNoise.smooth, OutlineNoise.white));
    own.silhouette->SetMovingSurface(prepared.surface);
    own.silhouette->Prepare();
    own.failure = own.silhouette->GetFailure();
    if (!own.failure.empty())
    {
      own.silhouette = nullptr;
    }
  }
}

void
PoseRegistrationEngine::AddViews(const PoseProblem &              problem,
                                 const std::vector<JawType> &     jaws,
                                 const std::vector<std::size_t> & members,
                                 MetricType &                     sum)
{
  for (std::size_t v = 0; v < problem.views.size(); ++v)
  {
    const PoseViewInput & view = problem.views[v];
    const auto            has = [&](std::size_t j) { return jaws[j].views[v].HasEvidence(); };
    if (std::none_of(members.begin(), members.end(), has))
    {
      continue;
    }
    const std::string                              move = PoseStateBlocks::MakeMoveName(view.name);
    const std::string                              scale = PoseStateBlocks::MakeScaleName(view.name);
    std::vector<ParameterPriorMetricv4::PriorType> priors(6);
    std::vector<bool>                              isFree(6);
    const auto                                     sigmas = MakeMoveSigmas(view);
    for (unsigned int k = 0; k < 6; ++k)
    {
      isFree[k] = sigmas[k] > 0.0;
      priors[k].sigma = isFree[k] ? sigmas[k] : std::numeric_limits<double>::infinity();
    }
    auto ofMove = ParameterPriorMetricv4::New();
    ofMove->SetBlock(PoseStateBlocks::MakePose(move));
    ofMove->SetPriors(priors);
    auto ofScale = ParameterPriorMetricv4::New();
    ofScale->SetBlock(PoseStateBlocks::MakeScale(scale));
    ofScale->SetPriors({ { 0.0, view.kappaSigma, 0.0 } });
    // Before the terms: a start leaves these out, and the blocks must stay in their order.
    sum.AddMetric(ofMove);
    sum.AddMetric(ofScale);
    // Outlines pull with half a millimetre's certainty, and a jaw that is still some millimetres off on the first view
    // would be dragged past its place there; a silhouette that contradicts is let go only by a kernel that is narrow.
    // Landmarks beside them wait for them.
    const bool isOutlined = std::any_of(members.begin(), members.end(), [&](std::size_t j) {
      return jaws[j].views[v].outlines.IsNotNull() || jaws[j].views[v].silhouette.IsNotNull();
    });
    const auto add = [&](PoseMetricv4 * term, MetricType::SettingsEnum settings) {
      if (term != nullptr)
      {
        auto wrapped = ViewPoseMetricv4::New();
        wrapped->SetView(view.name);
        wrapped->SetTerm(term);
        wrapped->SetJoins(isOutlined ? ViewPoseMetricv4::JoinsEnum::Refinement
                                     : ViewPoseMetricv4::JoinsEnum::Candidates);
        sum.AddMetric(wrapped, settings);
      }
    };
    for (const std::size_t j : members)
    {
      add(jaws[j].views[v].silhouette, MetricType::SettingsEnum::Own);
      add(jaws[j].views[v].outlines, MetricType::SettingsEnum::Own);
      add(jaws[j].views[v].landmarks, MetricType::SettingsEnum::Own);
    }
    sum.SetBlockFree(move, isFree);
  }
}

double
PoseRegistrationEngine::ComputeHeadMove(const PoseProblem &     problem,
                                        const PoseProblem &     question,
                                        const PoseGroupResult & group)
{
  double largest = 0.0;
  for (std::size_t v = 0; v < question.views.size(); ++v)
  {
    const PoseViewInput & view = question.views[v];
    const auto            moved = group.blocks.find(PoseStateBlocks::MakeMoveName(view.name));
    if (problem.views[v].sameHeadPosition && !view.sameHeadPosition && moved != group.blocks.end() &&
        !group.state.empty())
    {
      const auto sigmas = MakeMoveSigmas(view);
      for (unsigned int k = 0; k < 6; ++k)
      {
        largest = std::max(largest, std::abs(group.state[moved->second + k]) / sigmas[k]);
      }
    }
  }
  return largest;
}

void
PoseRegistrationEngine::DescribeViews(const PoseProblem &          problem,
                                      const std::vector<JawType> & jaws,
                                      PoseRegistrationResult &     result) const
{
  for (std::size_t v = 0; v < problem.views.size(); ++v)
  {
    const PoseViewInput & input = problem.views[v];
    const auto            sigmas = MakeMoveSigmas(input);
    PoseViewResult        view;
    view.name = input.name;
    view.sameHeadPosition = input.sameHeadPosition;
    view.result.geometry = input.geometry;
    view.result.groupOfJaw = result.groupOfJaw;
    for (const PoseGroupResult & group : result.groups)
    {
      PoseGroupResult own;
      own.jaws = group.jaws;
      own.smoothSigma = group.smoothSigma;
      own.whiteSigma = group.whiteSigma;
      own.converged = group.converged;
      own.parameters = group.parameters;
      own.covariance = group.covariance;
      std::array<double, 6> move{};
      std::array<double, 6> moveSigma{};
      double                tension = 0.0;
      const auto            moved = group.blocks.find(PoseStateBlocks::MakeMoveName(input.name));
      const auto            scaled = group.blocks.find(PoseStateBlocks::MakeScaleName(input.name));
      if (moved != group.blocks.end() && scaled != group.blocks.end() && !group.state.empty())
      {
        std::vector<std::size_t> places;
        for (unsigned int k = 0; k < 6; ++k)
        {
          places.push_back(group.blocks.at("pose") + k);
        }
        for (unsigned int k = 0; k < 6; ++k)
        {
          places.push_back(moved->second + k);
        }
        places.push_back(scaled->second);
        std::vector<double> x;
        for (const std::size_t place : places)
        {
          x.push_back(group.state[place]);
        }
        const auto position = ViewPoseMetricv4::MakeTermPosition(x);
        std::copy(position.begin(), position.end(), own.parameters.begin());
        const auto         size = static_cast<unsigned int>(group.state.size());
        vnl_matrix<double> covariance(
          static_cast<unsigned int>(places.size()), static_cast<unsigned int>(places.size()), 0.0);
        if (!group.stateCovariance.empty())
        {
          covariance = PickCovariance(vnl_matrix<double>(group.stateCovariance.data(), size, size), places);
        }
        const auto               jacobian = ViewPoseMetricv4::MakeTermJacobian(x);
        const vnl_matrix<double> ofView = jacobian * covariance * jacobian.transpose();
        std::copy(ofView.begin(), ofView.end(), own.covariance.begin());
        for (unsigned int k = 0; k < 6; ++k)
        {
          move[k] = x[6 + k];
          moveSigma[k] = std::sqrt(std::max(0.0, covariance(6 + k, 6 + k)));
          tension = sigmas[k] > 0.0 ? std::max(tension, std::abs(move[k]) / sigmas[k]) : tension;
        }
        tension = std::max(tension, std::abs(x[12]) / input.kappaSigma);
      }
      view.moves.push_back(move);
      view.moveSigmas.push_back(moveSigma);
      view.priorTensions.push_back(tension);
      view.result.groups.push_back(std::move(own));
    }
    for (std::size_t j = 0; j < jaws.size(); ++j)
    {
      PoseJawResult jaw;
      jaw.jaw = result.jaws[j].jaw;
      jaw.frame = result.jaws[j].frame;
      jaw.registered = result.jaws[j].registered;
      jaw.failure = result.jaws[j].failure;
      jaw.placedByOther = result.jaws[j].placedByOther;
      if (v < jaws[j].views.size())
      {
        jaw.tracingFailure = jaws[j].views[v].failure;
        jaw.unusedOutlines = jaws[j].views[v].unusedOutlines;
      }
      if (jaw.registered)
      {
        const PoseGroupResult & group = view.result.groups[result.groupOfJaw[j]];
        PlaceJaw(input.geometry, group.parameters, jaw);
        const std::vector<double> x(group.parameters.begin(), group.parameters.end());
        const JawType::ViewType & own = jaws[j].views[v];
        if (own.silhouette.IsNotNull())
        {
          DescribeFit(*own.silhouette, x, group.covariance, input.geometry, jaw);
        }
        if (own.outlines.IsNotNull())
        {
          DescribeOutlines(*own.outlines, {}, x, jaw);
        }
        if (own.landmarks.IsNotNull())
        {
          DescribeLandmarks(*own.landmarks, x, jaw);
        }
        DescribeMiddle(
          *jaws[j].surface, input.geometry, PoseModel(input.geometry, group.parameters), group.covariance, jaw);
      }
      view.result.jaws.push_back(std::move(jaw));
    }
    result.views.push_back(std::move(view));
  }
}
} // namespace itk

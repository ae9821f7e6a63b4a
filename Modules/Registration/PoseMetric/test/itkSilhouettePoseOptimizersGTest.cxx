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
#include "itkLeastSquaresMetricChecker.h"
#include "itkSilhouettePoseTestCase.h"

#include "itkLeastSquaresSumMetricv4.h"
#include "itkLevenbergMarquardtOptimizerv4.h"
#include "itkParameterPriorMetricv4.h"
#include "itkPoseStateBlocks.h"
#include "itkSquaresKernel.h"

#include "itkAmoebaOptimizerv4.h"
#include "itkLBFGSBOptimizerv4.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>

namespace
{
using SumType = itk::LeastSquaresSumMetricv4;
using OptimizerType = itk::ObjectToObjectOptimizerBaseTemplate<double>;

const SilhouettePoseTestCase &
Case()
{
  static const SilhouettePoseTestCase typical(
    75, SilhouettePoseTestCase::Source::CohortEnum::Typical, SilhouettePoseTestCase::Source::TracedSideEnum::Right);
  return typical;
}

/** Both jaws under one pose, with the priors of the method, around the truth of the pitch and the place. */
SumType::Pointer
MakeSum()
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  auto             sum = SumType::New();
  for (unsigned int jaw : { 0u, 1u })
  {
    sum->AddMetric(Case().MakeMetric(jaw));
  }
  auto pose = itk::ParameterPriorMetricv4::New();
  pose->SetBlock(itk::PoseStateBlocks::MakePose());
  pose->SetPriors({ { 0.0, infinity, 0.0 },
                    { 0.0, 0.061, 4.0 },
                    { 0.0, 0.061, 4.0 },
                    { 0.0, infinity, 0.0 },
                    { 0.0, 2.0, 0.0 },
                    { 0.0, infinity, 0.0 } });
  auto scale = itk::ParameterPriorMetricv4::New();
  scale->SetBlock(itk::PoseStateBlocks::MakeScale());
  scale->SetPriors({ { 0.0, 0.016, 0.0 } });
  sum->AddMetric(pose);
  sum->AddMetric(scale);
  sum->Initialize();
  return sum;
}

using MetricsType = std::array<SumType::Pointer, 3>;

/** Lets three optimizers go from the same place a few pixels beside the truth, each on a metric of its own:
 * Levenberg-Marquardt, a quasi-Newton method and a simplex. */
MetricsType
Optimize(const std::function<void(SumType &)> & prepare)
{
  const auto levenbergMarquardt = itk::LevenbergMarquardtOptimizerv4::New();

  const auto                                 lbfgsb = itk::LBFGSBOptimizerv4::New();
  itk::LBFGSBOptimizerv4::BoundSelectionType unbounded(4);
  unbounded.Fill(itk::LBFGSBOptimizerv4::UNBOUNDED);
  lbfgsb->SetBoundSelection(unbounded);
  lbfgsb->SetNumberOfIterations(200);
  lbfgsb->SetCostFunctionConvergenceFactor(10.0);

  const auto amoeba = itk::AmoebaOptimizerv4::New();
  amoeba->SetNumberOfIterations(3000);
  amoeba->SetParametersConvergenceTolerance(1e-5);
  amoeba->SetFunctionConvergenceTolerance(1e-8);
  itk::AmoebaOptimizerv4::ParametersType delta(4);
  // Wider than the valleys of the criterion. No restarts: ITK draws their directions from a generator that the whole
  // process shares.
  delta.Fill(2.0);
  amoeba->SetInitialSimplexDelta(delta);

  const std::array<OptimizerType *, 3> optimizers{
    { levenbergMarquardt.GetPointer(), lbfgsb.GetPointer(), amoeba.GetPointer() }
  };
  MetricsType metrics;
  for (unsigned int i = 0; i < 3; ++i)
  {
    metrics[i] = MakeSum();
    // What a tracing determines well, or a simplex creeps along the valley of roll and depth for thousands of steps.
    metrics[i]->SetBlockFree("pose", { true, false, false, true, false, true });
    prepare(*metrics[i]);
    auto position = metrics[i]->GetParameters();
    position[0] += 0.5;
    position[1] -= 0.4;
    position[2] += 0.5;
    position[3] += 0.2;
    LeastSquaresMetricChecker::MoveTo(*metrics[i], position);
    optimizers[i]->SetMetric(metrics[i]);
    optimizers[i]->StartOptimization();
  }
  return metrics;
}
} // namespace

TEST(SilhouettePoseOptimizers, ReachTheSameMinimumWhereTheMetricIsSmooth)
{
  // Matches held and nothing reweighted: a sum of squares of seven parameters.
  const auto metrics = Optimize([](SumType & sum) {
    sum.SetRobustKernel(itk::SquaresKernel::New());
    sum.Hold(SumType::HoldEnum::Matches);
  });
  for (const auto & metric : metrics)
  {
    // They end where the value does not fall by 1e-8 of itself or so, at the root of that from the minimum, px.
    EXPECT_NEAR(metric->GetValue(), metrics[0]->GetValue(), 1e-7 * metrics[0]->GetValue());
    EXPECT_LT(metrics[0]->GetStepLength(metrics[0]->GetParameters(), metric->GetParameters()), 1e-3);
  }
}

TEST(SilhouettePoseOptimizers, ReachTheSamePlaceOfTheCriterionItself)
{
  // The contour is made anew and matched anew, sample by sample, at each position: where samples are half a pixel apart
  // the criterion has valleys of that width. Methods that follow slopes step over most of them, a simplex that has
  // shrunk sits in one. The noise of the tracing is three times as wide.
  const auto   metrics = Optimize([](SumType &) {});
  const double limits[3] = { 1.03, 1.03, 1.2 };
  double       least = metrics[0]->GetValue();
  for (const auto & metric : metrics)
  {
    least = std::min(least, metric->GetValue());
  }
  for (unsigned int i = 0; i < 3; ++i)
  {
    EXPECT_LT(metrics[i]->GetValue(), limits[i] * least);
    EXPECT_LT(metrics[0]->GetStepLength(metrics[0]->GetParameters(), metrics[i]->GetParameters()), i < 2 ? 0.7 : 1.5);
  }
}

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
#include "itkPoseSilhouetteKernel.h"

#include "itkSilhouettePoseTestCase.h"

#include <gtest/gtest.h>

#include <cmath>

TEST(PoseSilhouetteKernel, ResidualJacobianMatchesDifferencesOfRegeneratedContours)
{
  // Facets well below a pixel, or their edges are what is measured.
  const SilhouettePoseTestCase c(72,
                                 SilhouettePoseTestCase::Source::CohortEnum::Typical,
                                 SilhouettePoseTestCase::Source::TracedSideEnum::Right,
                                 0.0,
                                 120000);
  const auto                   metric = c.MakeMetric(0);
  metric->Initialize();
  const itk::PoseSilhouetteKernel & kernel = metric->GetKernel();
  const auto                        pose = metric->GetTransform()->GetPoseParameters();
  const auto                        lin = kernel.Linearize(0, pose, kernel.ComputeContours(pose)[0], true);
  // The contour made anew moves along its normal as its surface points do, where no other part of the outline takes
  // over.
  const double steps[7] = { 1e-3, 2e-3, 2e-3, 0.05, 0.5, 0.05, 1e-3 };
  for (unsigned int k = 0; k < 7; ++k)
  {
    auto a = pose, b = pose;
    a[k] -= steps[k];
    b[k] += steps[k];
    const auto   ca = kernel.ComputeContours(a);
    const auto   cb = kernel.ComputeContours(b);
    const auto   la = kernel.Linearize(0, a, ca[0], false);
    const auto   lb = kernel.Linearize(0, b, cb[0], false);
    unsigned int close = 0, used = 0;
    for (std::size_t i = 0; i < lin.residual.size(); ++i)
    {
      // Beside corners of the outline the nearest point jumps: a kink, not a derivative.
      if (lin.facing[i] < 1.0 || std::sqrt(lin.squaredDistance[i]) > std::abs(lin.residual[i]) + 1e-12)
      {
        continue;
      }
      // So does one that goes over to another part of the surface.
      const auto & pa = ca[0].rim[la.match[i]];
      const auto & pb = cb[0].rim[lb.match[i]];
      if (std::hypot(pa[0] - pb[0], pa[1] - pb[1], pa[2] - pb[2]) > 1.0)
      {
        continue;
      }
      ++used;
      const double moved = lb.residual[i] - la.residual[i];
      const double expected = 2.0 * steps[k] * lin.jacobian[7 * i + k];
      // Facets and samples 0.5 px apart on curves of a few px radius leave some hundredths of a pixel.
      close += std::abs(moved - expected) < 0.08 + 0.1 * std::abs(expected) ? 1 : 0;
    }
    EXPECT_GT(used, lin.residual.size() / 2);
    EXPECT_GT(close, used * 85 / 100) << "parameter " << k << ", used " << used;
  }
}

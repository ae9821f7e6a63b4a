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
#ifndef dentalscrOptimizers_h
#define dentalscrOptimizers_h

#include "dentalscrBinding.h"

#include "itkLBFGS2Optimizerv4.h"
#include "itkLBFGSBOptimizerv4.h"

namespace dentalscr
{
/** SetOptimizerAs...() of the quasi-Newton methods, which serve every registration method. */
template <typename TMethod>
void
DefineQuasiNewton(ProcessClass<TMethod> & type)
{
  type
    .def(
      "SetOptimizerAsLBFGSB",
      [](TMethod &    self,
         double       gradientConvergenceTolerance,
         unsigned int numberOfIterations,
         unsigned int maximumNumberOfCorrections,
         unsigned int maximumNumberOfFunctionEvaluations,
         double       costFunctionConvergenceFactor) {
        auto optimizer = itk::LBFGSBOptimizerv4::New();
        optimizer->SetGradientConvergenceTolerance(gradientConvergenceTolerance);
        optimizer->SetNumberOfIterations(numberOfIterations);
        optimizer->SetMaximumNumberOfCorrections(maximumNumberOfCorrections);
        optimizer->SetMaximumNumberOfFunctionEvaluations(maximumNumberOfFunctionEvaluations);
        optimizer->SetCostFunctionConvergenceFactor(costFunctionConvergenceFactor);
        self.SetOptimizer(optimizer);
      },
      py::arg("gradientConvergenceTolerance") = 1e-5,
      py::arg("numberOfIterations") = 500,
      py::arg("maximumNumberOfCorrections") = 5,
      py::arg("maximumNumberOfFunctionEvaluations") = 2000,
      py::arg("costFunctionConvergenceFactor") = 1e7,
      "Optimizes with ITK's LBFGSBOptimizerv4, a quasi-Newton method within bounds. The parameters "
      "are ITK's.")
    .def(
      "SetOptimizerAsLBFGS2",
      [](TMethod & self,
         double    solutionAccuracy,
         int       numberOfIterations,
         int       hessianApproximateAccuracy,
         int       deltaConvergenceDistance,
         double    deltaConvergenceTolerance,
         int       lineSearchMaximumEvaluations) {
        auto optimizer = itk::LBFGS2Optimizerv4::New();
        optimizer->SetSolutionAccuracy(solutionAccuracy);
        optimizer->SetMaximumIterations(numberOfIterations);
        optimizer->SetHessianApproximationAccuracy(hessianApproximateAccuracy);
        optimizer->SetDeltaConvergenceDistance(deltaConvergenceDistance);
        optimizer->SetDeltaConvergenceTolerance(deltaConvergenceTolerance);
        optimizer->SetMaximumLineSearchEvaluations(lineSearchMaximumEvaluations);
        self.SetOptimizer(optimizer);
      },
      py::arg("solutionAccuracy") = 1e-5,
      py::arg("numberOfIterations") = 100,
      py::arg("hessianApproximateAccuracy") = 6,
      py::arg("deltaConvergenceDistance") = 0,
      py::arg("deltaConvergenceTolerance") = 1e-5,
      py::arg("lineSearchMaximumEvaluations") = 40,
      "Optimizes with ITK's LBFGS2Optimizerv4, a quasi-Newton method without bounds. The "
      "parameters are ITK's.");
}
} // namespace dentalscr

#endif

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
#ifndef itkPoseFitStatistics_h
#define itkPoseFitStatistics_h

#include <cstddef>


namespace itk
{
/** How well a jaw's tracing is explained at the solution, with a fixed kernel width of 4 px; lengths in px. */
struct PoseFitStatistics
{
  std::size_t numberOfPoints{ 0 }; /**< Points of the tracing that were compared. */
  /** mean(1 - sqrt(w)), w the Geman-McClure weight: 0 perfect, 1 nothing fits. */
  double cost{ 1.0 };
  double medianResidual{ 0.0 };
  double rmsResidual{ 0.0 };
  double p90Residual{ 0.0 };
  /** Share of the tracing within 4 px of the moving contour. */
  double inlierShare{ 0.0 };
  /** Share of the moving contour that has a tracing beside it: the overlap the other way. */
  double overlap{ 0.0 };
  /** Mean of (arc of tooth - arc at which its code has it, PoseToothPlaces), mm; 0 without codes. */
  double codeOffset{ 0.0 };
  bool   hasCodes{ false };
  /** Root mean square over the matched points of the predicted sigma an axis, px. */
  double predictedSigma{ 0.0 };
  /** The same, largest over the whole moving contour: what landmarks far from the tracing have. */
  double extrapolatedSigma{ 0.0 };
  /** Length of the tracing and of the open moving contour, px. */
  double tracingLength{ 0.0 };
  double contourLength{ 0.0 };
};
} // namespace itk

#endif

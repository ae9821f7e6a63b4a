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
#ifndef itkCasePoseRegistration_h
#define itkCasePoseRegistration_h

#include "itkCaseResult.h"
#include "itkDentalFrameEstimator.h"
#include "itkPoseRegistrationTypes.h"

#include <functional>

namespace itk
{
/** \struct CasePoseSettings
 * \brief What the robust chain needs beside the data. */
struct CasePoseSettings
{
  /** The method's ingredients; what the case says is set over them. */
  PoseRegistrationOptions options;
  /** The prior of the scale is the user's; otherwise it follows from where the pixel spacing comes from. */
  bool         kappaSigmaIsGiven{ false };
  unsigned int numberOfThreads{ 0 };
  /** Points of the resampled whole silhouette, upper and lower, for the figures that presets are compared on. */
  std::array<unsigned int, 2> numberOfContourPoints{ { 441, 439 } };
  /** Called with progress in [0, 1]; returns true to abort. */
  std::function<bool(double)> progress;
};

/** Preset "robust" from the dental frame on: all jaws that can be registered, jointly where they share a frame. Fills
 * the jaws of the result, and the geometry with what had to be estimated. The surfaces (upper, lower; mm) must be those
 * of the frames. */
void
RegisterCaseByPose(const DentalCaseData &                 data,
                   const DentalFrameResult &              frames,
                   const std::array<TriangleSurface, 2> & surfaces,
                   const CasePoseSettings &               settings,
                   CaseResult &                           result);
} // namespace itk

#endif

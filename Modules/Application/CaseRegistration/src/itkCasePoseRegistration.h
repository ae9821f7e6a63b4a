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
#include "itkPoseRegistrationTypes.h"
#include "itkUMidlineDentalAxisFilter.h"

#include <array>
#include <functional>

namespace itk
{
class PoseRegistrationMethodBase;

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
  /** Called with the method before it runs, where it is set. */
  std::function<void(PoseRegistrationMethodBase &)> configure;
  /** Updates a process object with the caller's progress and abort. */
  std::function<void(ProcessObject *)> run;
};

/** A tracing of fewer points does not determine a similarity with any redundancy. */
constexpr unsigned int MinimumTracingPoints = 5;

/** Points that count: of weight above 0. None of a null contour. */
unsigned int
CountTracingPoints(const DentalContour * contour);

/** Preset "robust" from the dental frames on: all jaws that can be registered, jointly where they share a frame. Wires
 * PoseRegistrationMethod and what lies downstream, and fills the jaws of the result, and the geometry with what had to
 * be estimated. The filter has been updated with the scans of the case. */
void
RegisterCaseByPose(const DentalCaseData &                               data,
                   UMidlineDentalAxisFilter<DentalCaseData::MeshType> * axis,
                   const CasePoseSettings &                             settings,
                   CaseResult &                                         result);
} // namespace itk

#endif

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
#ifndef itkPoseCovariance_h
#define itkPoseCovariance_h

#include "PoseRegistrationExport.h"
#include "itkPosePriors.h"
#include "itkPoseRegistrationTypes.h"

#include "itkLeastSquaresSumMetricv4.h"

#include "vnl/vnl_matrix.h"

#include <array>
#include <cstddef>
#include <vector>

namespace itk
{
/** Covariance of all unknowns of a metric, in the order of its state, natural units: as of pose and scale below. What
 * is neither free nor held by the options has none. */
PoseRegistration_EXPORT vnl_matrix<double>
                        ComputeStateCovariance(const LeastSquaresSumMetricv4 & metric,
                                               const PoseRegistrationOptions & options,
                                               const PosePriors &              priors,
                                               const ResidualNoiseModel *      noiseModel = nullptr);

/** Rows and columns of a state's covariance at some places of the state, in their order.
 * \ingroup PoseRegistration */
PoseRegistration_EXPORT vnl_matrix<double>
                        PickCovariance(const vnl_matrix<double> & covariance, const std::vector<std::size_t> & places);

/** Covariance of pose and scale, 7x7 in the order of PoseParameters, row-major, of a state's.
 * \ingroup PoseRegistration */
PoseRegistration_EXPORT std::array<double, 49>
                        PickPoseCovariance(const vnl_matrix<double> & covariance, const RegistrationState & state);

/** Covariance of pose and scale at the position and the noise levels of a metric, 7x7 in the order of PoseParameters,
 * row-major, rad and mm: the inverse of the information of residuals and priors, with the noise model's longer
 * correlation length and levels estimated for it, the options' inflation included.
 *
 * - The nearest contour point absorbs part of the noise: levels are multiplied by
 *   min(absorbedNoiseLimit, 1 + absorbedNoise smooth^2 / px^2).
 * - Rotations and a shift that were not estimated enter with their priors.
 * - What a user holds was not estimated: its own uncertainty, with what the estimated parameters do when it moves,
 * comes on top instead of being narrowed by the data.
 *
 * The noise model is the options' correlation over covarianceCorrelationLength where none is given. The metric stays as
 * it is. */
PoseRegistration_EXPORT std::array<double, 49>
                        ComputePoseCovariance(const LeastSquaresSumMetricv4 & metric,
                                              const PoseRegistrationOptions & options,
                                              const PosePriors &              priors,
                                              const ResidualNoiseModel *      noiseModel = nullptr);
} // namespace itk

#endif

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
#ifndef itkPosePriors_h
#define itkPosePriors_h

#include "PoseRegistrationExport.h"
#include "itkPoseRegistrationTypes.h"

#include "itkParameterPriorMetricv4.h"

#include <array>

namespace itk
{
/** \class PosePriors
 * \brief What the options say of the seven parameters beforehand: which are free, and the priors of these.
 *
 * A standard deviation of 0 holds a parameter, infinity leaves it free; between them it is the prior's.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT PosePriors
{
public:
  using SigmasType = std::array<double, 7>;
  /** Of the options, for a radiograph whose pixel spacing is known or not. */
  PosePriors(const PoseRegistrationOptions & options, bool pixelSpacingKnown);

  /** Of the fit; similarityOnly: pitch, tx, tz and kappa alone. */
  SigmasType
  GetFitSigmas(bool similarityOnly) const;
  /** Of the covariance: rotations and a shift that were not estimated are uncertain all the same. */
  SigmasType
  GetCovarianceSigmas() const;
  /** How far what the user holds may be off; 0 for all else. */
  SigmasType
  GetHeldSigmas() const;

  /** Adds the priors of the fit, of the blocks "pose" and "scale", as the last two terms of a sum. */
  void
  AddTo(class LeastSquaresSumMetricv4 & sum) const;

  /** Frees what the standard deviations do not hold. */
  static void
  SetFree(LeastSquaresMetricv4 & metric, const SigmasType & sigmas);
  /** Sets the priors of a clone of what AddTo() made; what is held or free has none. */
  void
  SetPriors(LeastSquaresSumMetricv4 & sum, const SigmasType & sigmas, bool forVariance) const;

private:
  ParameterPriorMetricv4::PriorType
  MakePrior(unsigned int parameter, double sigma) const;

  PoseRegistrationOptions m_Options;
  bool                    m_PixelSpacingKnown;
};
} // namespace itk

#endif

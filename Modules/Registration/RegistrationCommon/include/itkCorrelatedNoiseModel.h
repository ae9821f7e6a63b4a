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
#ifndef itkCorrelatedNoiseModel_h
#define itkCorrelatedNoiseModel_h

#include "itkResidualNoiseModel.h"

#include "itkNumericTraits.h"

namespace itk
{
/** \class CorrelatedNoiseModel
 * \brief The hand drifts smoothly along a tracing: correlation falls with the distance along it as a Gaussian.
 *
 * G_ij = exp(-(s_i - s_j)^2 / (2 length^2)) (n_i . n_j), cut off where the exponential is below 2e-9. With a length of
 * 0 all errors are independent and the two variances add.
 *
 * \ingroup RegistrationCommon
 */
class RegistrationCommon_EXPORT CorrelatedNoiseModel : public ResidualNoiseModel
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(CorrelatedNoiseModel);

  using Self = CorrelatedNoiseModel;
  using Superclass = ResidualNoiseModel;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(CorrelatedNoiseModel, ResidualNoiseModel);

  /** px of 0.25 mm; 14 by default, 0: independent. */
  itkSetClampMacro(CorrelationLength, double, 0.0, NumericTraits<double>::max());
  itkGetConstMacro(CorrelationLength, double);

  double
  GetCorrelation(double arcDistance) const override;

protected:
  CorrelatedNoiseModel() = default;
  ~CorrelatedNoiseModel() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  double m_CorrelationLength{ 14.0 };
};
} // namespace itk

#endif

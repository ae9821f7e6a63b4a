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
#ifndef itkGemanMcClureKernel_h
#define itkGemanMcClureKernel_h

#include "itkRobustKernel.h"

namespace itk
{
/** \class GemanMcClureKernel
 * \brief Redescending weights (c^2 / (c^2 + d^2))^2: a residual far beyond the width does not count at all.
 *
 * Source: Geman and McClure, Bulletin of the ISI 1987; the charge is (1 - sqrt(w))^2.
 *
 * \ingroup RegistrationCommon
 */
class RegistrationCommon_EXPORT GemanMcClureKernel : public RobustKernel
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(GemanMcClureKernel);

  using Self = GemanMcClureKernel;
  using Superclass = RobustKernel;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(GemanMcClureKernel, RobustKernel);

  /** The weight itself, for those whose kernel is always this one and who call it at every point of a tracing; no
   * object and no virtual call stands between. Distance and width are in the same unit. */
  static double
  Weight(double squaredDistance, double width)
  {
    const double a = width * width / (width * width + squaredDistance);
    return a * a;
  }

  double
  GetWeight(double squaredDistance, double width) const override;
  double
  GetWeightDerivative(double squaredDistance, double width) const override;
  double
  GetCharge(double weight) const override;
  double
  GetChargeDerivative(double weight) const override;

protected:
  GemanMcClureKernel() = default;
  ~GemanMcClureKernel() override = default;
};
} // namespace itk

#endif

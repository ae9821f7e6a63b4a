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
#ifndef itkRobustKernel_h
#define itkRobustKernel_h

#include "RegistrationCommonExport.h"

#include "itkObject.h"
#include "itkObjectFactory.h"

namespace itk
{
/** \class RobustKernel
 * \brief How much a residual counts by its size: a weight w(d) between 1 at distance 0 and 0 far away.
 *
 * A kernel has no state: width c and distance d are given at each call, so that metrics and threads share one object.
 * The criterion that belongs to a weight function, in the dual form of Black and Rangarajan (IJCV 1996), charges for
 * what is let go: with z = sqrt(w) the term of a residual is z^2 r^2 + c^2 charge(z), and the weight is where that is
 * smallest.
 *
 * \ingroup RegistrationCommon
 */
class RegistrationCommon_EXPORT RobustKernel : public Object
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(RobustKernel);

  using Self = RobustKernel;
  using Superclass = Object;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkTypeMacro(RobustKernel, Object);

  /** w at a squared distance with a width c > 0, both in the same unit. */
  virtual double
  GetWeight(double squaredDistance, double width) const = 0;

  /** d w / d (squared distance). */
  virtual double
  GetWeightDerivative(double squaredDistance, double width) const = 0;

  /** What is charged for a weight, in units of the squared width; 0 where w is 1. */
  virtual double
  GetCharge(double weight) const = 0;

  /** d charge / d weight. */
  virtual double
  GetChargeDerivative(double weight) const = 0;

protected:
  RobustKernel() = default;
  ~RobustKernel() override = default;
};
} // namespace itk

#endif

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
#ifndef itkResidualNoiseModel_h
#define itkResidualNoiseModel_h

#include "RegistrationCommonExport.h"

#include "itkObject.h"
#include "itkObjectFactory.h"

namespace itk
{
/** \class ResidualNoiseModel
 * \brief How the errors of the points along a tracing hang together: the matrix G of K = smooth^2 G + white^2 W^-1.
 *
 * The model has no state but its settings; levels and weights belong to the metric, so that metrics and threads share
 * one object. ContourNoiseModel has the formulas and estimates the two levels. Metrics that hold the same object take
 * part in one estimate and have the same levels.
 *
 * \ingroup RegistrationCommon
 */
class RegistrationCommon_EXPORT ResidualNoiseModel : public Object
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ResidualNoiseModel);

  using Self = ResidualNoiseModel;
  using Superclass = Object;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkTypeMacro(ResidualNoiseModel, Object);

  /** Correlation of the errors of two points of a tracing by the distance along it, px of 0.25 mm; 1 at 0. Of two
   * residuals it is this times the cosine between the normals that they are taken along. */
  virtual double
  GetCorrelation(double arcDistance) const = 0;

protected:
  ResidualNoiseModel() = default;
  ~ResidualNoiseModel() override = default;
};
} // namespace itk

#endif

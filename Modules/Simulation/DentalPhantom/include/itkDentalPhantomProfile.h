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
#ifndef itkDentalPhantomProfile_h
#define itkDentalPhantomProfile_h

#include "DentalPhantomExport.h"

#include <vector>

namespace itk
{
/** \class DentalPhantomProfile
 * \brief A cubic Hermite curve over a few knots: how a crown's half widths change with its height.
 *
 * Slopes are central differences of the knots. Constant beyond the ends.
 *
 * \ingroup DentalPhantom
 */
class DentalPhantom_EXPORT DentalPhantomProfile
{
public:
  DentalPhantomProfile() = default;
  /** Knots in ascending order of x, one y each. */
  DentalPhantomProfile(std::vector<double> xs, std::vector<double> ys);
  /** The value at t; beyond the knots that of the nearest one. */
  double
  operator()(double t) const;

private:
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> slope;
};
} // namespace itk

#endif

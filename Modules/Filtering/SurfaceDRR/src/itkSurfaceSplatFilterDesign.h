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
#ifndef itkSurfaceSplatFilterDesign_h
#define itkSurfaceSplatFilterDesign_h

#include <vector>

// Designs the filters that make Gaussians of B-splines: done once for a width, apart from what is done for each splat.
// Private to this module.
namespace itk
{
namespace SurfaceSplatDetail
{
/** Least-squares fit of a symmetric filter h[0..R] such that the spline filtered by h is the Gaussian of this width, at
 * all sub-pixel positions alike. \return the largest error, relative to the peak. */
template <int VDegree>
double
FitFilter(double sigma, double cut, std::vector<float> & filter);

extern template double
FitFilter<3>(double, double, std::vector<float> &);
extern template double
FitFilter<5>(double, double, std::vector<float> &);
} // namespace SurfaceSplatDetail
} // namespace itk

#endif

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
#ifndef itkDentalFrameSamples_h
#define itkDentalFrameSamples_h

#include "itkDentalFrameEstimator.h"
#include "itkDentalFrameMath.h"

#include <vector>

// The estimator's first step: a scan becomes points of equal weight with normals, so that neither how finely it is
// meshed nor specks beside it speak later on. Private to this module.
namespace itk
{
namespace DentalFrameKernel
{
using namespace DentalFrameMath;

/** Uniform samples of a jaw's surface, and what the choice of the occlusal side needs. */
struct Samples
{
  std::vector<Vector3> points;
  std::vector<Vector3> normals;
  /** 1 - |mean normal within 2 mm|: 0 on a flat base, large on cusps and fissures. */
  std::vector<double> roughness;
  Vector3             centroid{ 0.0, 0.0, 0.0 };
  Vector3             netNormal{ 0.0, 0.0, 0.0 };
  double              area{ 0.0 };
  double              meanRoughness{ 0.0 };
};

/** Welds repeated points, drops specks, and takes systematic samples by area in the order of the triangles: the same
 * samples in whatever frame the mesh is. */
Samples
TakeSamples(const TriangleSurface & surface, unsigned int count);

/** Middles of the edges that belong to one triangle alone, repeated points welded: the border of an open shell, and the
 * borders of its holes. */
std::vector<Vector3>
FindRim(const TriangleSurface & surface);

/** The value below which the given fraction of the values lies; 0 for none. */
double
Quantile(std::vector<double> values, double fraction);
} // namespace DentalFrameKernel
} // namespace itk

#endif

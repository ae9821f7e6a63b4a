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
#include "itkFindSilhouettes.h"

#include "itkForEachTerm.h"
#include "itkPoseStateBlocks.h"

#include <algorithm>

namespace itk
{
namespace
{
/** Whether both project a point onto the same pixel. */
bool
IsSameView(const PoseGeometry & a, const PoseGeometry & b)
{
  return a.direction == b.direction && a.sourceToMidsagittal == b.sourceToMidsagittal &&
         a.sourceToDetector == b.sourceToDetector && a.sourceSign == b.sourceSign && a.facingSign == b.facingSign &&
         a.pixelSpacing == b.pixelSpacing && a.principalPoint == b.principalPoint;
}
} // namespace

std::vector<FoundSilhouette>
FindSilhouettes(const LeastSquaresMetricv4 & metric, const LeastSquaresMetricv4::PositionType & x)
{
  std::vector<FoundSilhouette> found;
  ForEachTerm<SilhouettePoseMetricv4>(
    metric, x, [&](const SilhouettePoseMetricv4 & term, const LeastSquaresMetricv4::PositionType & own) {
      found.push_back({ &term, own });
    });
  return found;
}

std::vector<FoundSilhouette>
FindSilhouettes(const LeastSquaresMetricv4 & metric)
{
  return FindSilhouettes(metric, metric.GetState().GetValues());
}

std::vector<FoundSilhouette>
FindSilhouettesOfStart(const LeastSquaresMetricv4 & metric)
{
  std::vector<FoundSilhouette> ofStart;
  for (const FoundSilhouette & found : FindSilhouettes(metric))
  {
    const SilhouettePoseMetricv4 & silhouette = *found.metric;
    const auto                     isSameView = [&](const FoundSilhouette & other) {
      return IsSameView(other.metric->GetKernel().GetSettings().geometry,
                        silhouette.GetKernel().GetSettings().geometry);
    };
    if (silhouette.GetPoseBlock() == PoseStateBlocks::MakePose().name &&
        silhouette.GetScaleBlock() == PoseStateBlocks::MakeScale().name &&
        std::all_of(ofStart.begin(), ofStart.end(), isSameView))
    {
      ofStart.push_back(found);
    }
  }
  return ofStart;
}
} // namespace itk

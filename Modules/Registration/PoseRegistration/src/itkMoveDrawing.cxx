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
#include "itkMoveDrawing.h"

namespace itk
{
void
MoveDrawing(PoseProblem & problem, const std::function<Point<double, 2>(const Point<double, 2> &)> & move)
{
  problem.completed.reset();
  problem.nominal.principalPointKnown = false;
  for (PoseJawInput & jaw : problem.jaws)
  {
    jaw.initialPose.reset();
    if (jaw.tracing.IsNotNull())
    {
      auto moved = DentalContour::New();
      for (DentalContour::PolylineType polyline : jaw.tracing->GetPolylines())
      {
        for (auto & point : polyline.points)
        {
          point = move(point);
        }
        moved->AddPolyline(polyline);
      }
      jaw.tracing = moved;
    }
    if (jaw.landmarks.IsNotNull())
    {
      auto moved = CephalometricLandmarkSet::New();
      for (const auto & landmark : jaw.landmarks->GetLandmarks())
      {
        moved->AddLandmark(landmark.name, move(landmark.point), landmark.sigma, landmark.confidence);
      }
      jaw.landmarks = moved;
    }
  }
}
} // namespace itk

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
#include "itkCaseScene.h"

#include "itkFirstViewName.h"
#include "itkProjectionRows.h"
#include "itkRigidTransformRows.h"

#include <cmath>
#include <string>
#include <utility>

namespace itk
{
namespace
{
using JawEnum = ToothCode::JawEnum;
using RowsType = std::array<double, 12>;

/** How much larger a projection shows things than another: two of its rows grow with the scale, the third with
 * neither's homogeneous factor. */
double
ComputeScale(const RowsType & projection, const RowsType & nominal)
{
  const auto relativeVolume = [](const RowsType & p) {
    const double determinant =
      p[0] * (p[5] * p[10] - p[6] * p[9]) - p[1] * (p[4] * p[10] - p[6] * p[8]) + p[2] * (p[4] * p[9] - p[5] * p[8]);
    const double depth = std::sqrt(p[8] * p[8] + p[9] * p[9] + p[10] * p[10]);
    return std::abs(determinant) / (depth * depth * depth);
  };
  return std::sqrt(relativeVolume(projection) / relativeVolume(nominal));
}

/** Where a jaw stands in a view's cephalostat frame against where it stands in the first one's: how the head was moved.
 */
void
MoveHead(const RowsType & inView, const RowsType & inFirst, CephalometricGeometry * geometry)
{
  const RowsType                      motion = TimesRigidInverse(inView, inFirst);
  CephalometricGeometry::RotationType rotation;
  CephalometricGeometry::VectorType   translation;
  SplitRigidTransformRows(motion, rotation, translation);
  geometry->SetPose(rotation, translation);
}

/** A radiograph as it stands in the first one's cephalostat frame. */
SceneView
MakeSceneView(const CaseResult & shown, const CaseResult & first, const std::string & name)
{
  const DentalCaseData & data = *shown.data;
  const double           unit = data.description.millimetresPerUnit;
  auto                   geometry = CephalometricGeometry::New();
  geometry->CopyParameters(shown.geometry);
  geometry->SetPoseToIdentity();
  RowsType nominal = geometry->GetProjection().matrix;

  SceneView view;
  view.name = name;
  view.sourceToDetector = geometry->GetSourceToDetectorDistance();
  view.radiograph = data.image.GetPointer();
  view.imageSize = data.imageSize;
  double       logarithm = 0.0;
  unsigned int scales = 0;
  bool         isMoved = &shown != &first;
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    SceneViewJaw own;
    own.tracing = data.GetJaw(jaw).contour.GetPointer();
    const auto found = shown.jaws.find(jaw);
    const auto placed = first.jaws.find(jaw);
    if (found != shown.jaws.end() && found->second.registered && placed != first.jaws.end())
    {
      const JawResult & registered = found->second;
      const auto &      place = placed->second.meshToCephalostat;
      if (isMoved)
      {
        MoveHead(registered.meshToCephalostat, place, geometry);
        nominal = geometry->GetProjection().matrix;
        isMoved = false;
      }
      own.projection = TimesRigidInverse(ScaleColumns(registered.projection, 1.0 / unit), place);
      logarithm += std::log(ComputeScale(*own.projection, nominal));
      ++scales;
      for (const LandmarkPrediction & landmark : registered.landmarks)
      {
        const auto * const onScan = data.landmarks3D.IsNull() ? nullptr : data.landmarks3D->Find(landmark.name);
        if (onScan == nullptr)
        {
          continue;
        }
        SceneLandmark seen;
        seen.name = landmark.name;
        seen.pixel = landmark.position;
        for (unsigned int row = 0; row < 3; ++row)
        {
          seen.point[row] = place[4 * row + 3];
          for (unsigned int d = 0; d < 3; ++d)
          {
            seen.point[row] += place[4 * row + d] * unit * onScan->point[d];
          }
        }
        own.landmarks.push_back(seen);
      }
    }
    view.jaws[jaw] = own;
  }
  // A larger image is drawn as one with smaller pixels: about the principal point, which stays.
  const double scale = scales == 0 ? 1.0 : std::exp(logarithm / scales);
  const auto   principal = geometry->GetPrincipalPoint();
  for (unsigned int column = 0; column < 4; ++column)
  {
    const double depth = nominal[8 + column];
    view.projection[column] = principal[0] * depth + scale * (nominal[column] - principal[0] * depth);
    view.projection[4 + column] = principal[1] * depth + scale * (nominal[4 + column] - principal[1] * depth);
    view.projection[8 + column] = depth;
  }
  return view;
}
} // namespace

RegistrationSceneSource::Pointer
MakeCaseScene(const CaseResult & result)
{
  auto scene = RegistrationSceneSource::New();
  for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
  {
    const auto found = result.jaws.find(jaw);
    if (found != result.jaws.end() && found->second.registered && result.data->GetJaw(jaw).mesh.IsNotNull())
    {
      scene->SetScan(jaw, result.data->GetJaw(jaw).mesh, found->second.meshToCephalostat, found->second.meshToUMDA);
    }
  }
  scene->AddView(MakeSceneView(result, result, FirstViewName));
  for (const CaseViewResult & view : result.views)
  {
    scene->AddView(MakeSceneView(*view.result, result, view.name));
  }
  return scene;
}
} // namespace itk

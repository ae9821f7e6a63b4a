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
#include "itkPoseGeometryConversion.h"

namespace itk
{
PoseGeometry
ToPoseGeometry(const CephalometricGeometry & geometry)
{
  PoseGeometry own;
  own.direction = geometry.GetDirection();
  own.sourceToMidsagittal = geometry.GetSourceToMidsagittalDistance();
  own.sourceToDetector = geometry.GetSourceToDetectorDistance();
  own.sourceSign = geometry.GetSourceSign();
  own.facingSign = geometry.GetFacingSign();
  own.pixelSpacingKnown = geometry.HasPixelSpacing();
  for (unsigned int d = 0; d < 2; ++d)
  {
    if (own.pixelSpacingKnown)
    {
      own.pixelSpacing[d] = geometry.GetPixelSpacing()[d];
    }
    own.principalPoint[d] = geometry.GetPrincipalPoint()[d];
  }
  return own;
}

void
CopyToGeometry(const PoseGeometry & from, double scaleFactor, CephalometricGeometry & geometry)
{
  using GeometryType = CephalometricGeometry;
  geometry.SetDirection(from.direction);
  geometry.SetSourceToMidsagittalDistance(from.sourceToMidsagittal);
  geometry.SetSourceToDetectorDistance(from.sourceToDetector);
  const bool sourceIsPositive = from.sourceSign > 0.0;
  const bool facingIsPositive = from.facingSign > 0.0;
  if (from.direction == CephalometricDirectionEnum::Lateral)
  {
    geometry.SetSourceSide(sourceIsPositive ? GeometryType::SourceSideEnum::Right : GeometryType::SourceSideEnum::Left);
    geometry.SetFacing(facingIsPositive ? GeometryType::FacingEnum::Right : GeometryType::FacingEnum::Left);
  }
  else
  {
    geometry.SetFrontalSource(sourceIsPositive ? GeometryType::FrontalSourceEnum::Behind
                                               : GeometryType::FrontalSourceEnum::InFront);
    geometry.SetPatientLeft(facingIsPositive ? GeometryType::PatientLeftEnum::Right
                                             : GeometryType::PatientLeftEnum::Left);
  }
  GeometryType::PixelSpacingType spacing;
  GeometryType::PixelIndexType   principal;
  for (unsigned int d = 0; d < 2; ++d)
  {
    // The geometry has no scale of its own: a larger picture is one with smaller pixels.
    spacing[d] = from.pixelSpacing[d] / scaleFactor;
    principal[d] = from.principalPoint[d];
  }
  geometry.SetPixelSpacing(spacing);
  geometry.SetPrincipalPoint(principal);
}
} // namespace itk

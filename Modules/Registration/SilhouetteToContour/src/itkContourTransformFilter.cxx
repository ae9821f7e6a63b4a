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
#include "itkContourTransformFilter.h"

namespace itk
{
namespace
{
/** A normal stays across the line that it is the normal of, on the side that it is on, and of unit length.
 * (TransformCovariantVector() at a point applies the transposed matrix in ITK 5.2.) */
DentalContour::NormalType
MoveNormal(const ContourTransformFilter::TransformType & transform,
           const DentalContour::NormalType &             normal,
           const DentalContour::PointType &              point)
{
  using VectorType = ContourTransformFilter::TransformType::InputVectorType;
  VectorType along;
  VectorType outward;
  along[0] = -normal[1];
  along[1] = normal[0];
  outward[0] = normal[0];
  outward[1] = normal[1];
  const auto                movedAlong = transform.TransformVector(along, point);
  const auto                movedOutward = transform.TransformVector(outward, point);
  DentalContour::NormalType moved;
  moved[0] = movedAlong[1] / movedAlong.GetNorm();
  moved[1] = -movedAlong[0] / movedAlong.GetNorm();
  // A reflection exchanges the sides.
  return moved[0] * movedOutward[0] + moved[1] * movedOutward[1] < 0.0 ? -moved : moved;
}
} // namespace

ContourTransformFilter::ContourTransformFilter()
{
  this->AddRequiredInputName("Transform");
}

void
ContourTransformFilter::VerifyPreconditions() ITKv5_CONST
{
  if (this->GetInput() == nullptr)
  {
    itkExceptionMacro("No contour to move: call SetInput() with a DentalContour.");
  }
  if (this->GetTransformInput() == nullptr)
  {
    itkExceptionMacro("No transform: call SetTransform() with that of a registration.");
  }
  Superclass::VerifyPreconditions();
}

void
ContourTransformFilter::GenerateData()
{
  const TransformType * transform = this->GetTransform();
  if (transform == nullptr)
  {
    itkExceptionMacro("The transform is empty: update the registration that finds it.");
  }
  DentalContour * const output = this->GetOutput();
  output->Initialize();
  // Without it every Update() would execute again.
  output->SetBufferedRegion(0);
  for (auto polyline : this->GetInput()->GetPolylines())
  {
    for (std::size_t i = 0; i < polyline.normals.size(); ++i)
    {
      // At the point where it was; one that is not known stays so.
      auto & normal = polyline.normals[i];
      if (normal.GetNorm() > 0.0)
      {
        normal = MoveNormal(*transform, normal, polyline.points[i]);
      }
    }
    for (auto & point : polyline.points)
    {
      point = transform->TransformPoint(point);
    }
    output->AddPolyline(polyline);
  }
}
} // namespace itk

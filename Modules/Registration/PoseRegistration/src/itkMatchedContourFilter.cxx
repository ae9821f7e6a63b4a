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
#include "itkMatchedContourFilter.h"

#include <vector>

namespace itk
{
MatchedContourFilter::MatchedContourFilter()
{
  this->AddRequiredInputName("MovingContour", 0);
  this->AddRequiredInputName("FixedContour", 1);
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
}

MatchedContourFilter::DataObjectPointer
MatchedContourFilter::MakeOutput(DataObjectPointerArraySizeType)
{
  return ContourType::New().GetPointer();
}

MatchedContourFilter::ContourType *
MatchedContourFilter::GetOutput()
{
  return itkDynamicCastInDebugMode<ContourType *>(this->ProcessObject::GetOutput(0));
}

void
MatchedContourFilter::GenerateData()
{
  ContourType * output = this->GetOutput();
  output->Initialize();
  // All there is: without it every Update() would execute again.
  output->SetBufferedRegion(0);
  const auto * fixed = this->GetFixedContour()->GetPoints();
  if (fixed == nullptr)
  {
    // Nothing was traced.
    return;
  }
  ContourType::PolylineType piece;
  const auto                flush = [&]() {
    output->AddPolyline(piece);
    piece = ContourType::PolylineType();
  };
  for (const auto & polyline : this->GetMovingContour()->GetPolylines())
  {
    for (std::size_t i = 0; i < polyline.points.size(); ++i)
    {
      const auto & point = polyline.points[i];
      bool         beside = false;
      for (auto it = fixed->Begin(); it != fixed->End() && !beside; ++it)
      {
        beside = it.Value().EuclideanDistanceTo(point) < m_MaximumDistance;
      }
      if (!piece.points.empty() && (!beside || piece.points.back().EuclideanDistanceTo(point) > m_MaximumGap))
      {
        flush();
      }
      if (beside)
      {
        AppendPoint(polyline, i, piece);
      }
    }
  }
  flush();
}

void
MatchedContourFilter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "MaximumDistance: " << m_MaximumDistance << std::endl;
  os << indent << "MaximumGap: " << m_MaximumGap << std::endl;
}
} // namespace itk

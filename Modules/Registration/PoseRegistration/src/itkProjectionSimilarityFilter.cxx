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
#include "itkProjectionSimilarityFilter.h"

#include "itkPoseModel.h"

#include <algorithm>
#include <cmath>

namespace itk
{
ProjectionSimilarityFilter::ProjectionSimilarityFilter()
{
  this->AddRequiredInputName("Solution", 0);
  this->AddRequiredInputName("Mesh", 1);
  this->AddRequiredInputName("Frame", 2);
  this->SetNumberOfRequiredOutputs(2);
  this->SetNthOutput(0, this->MakeOutput(0));
  this->SetNthOutput(1, this->MakeOutput(1));
}

ProjectionSimilarityFilter::DataObjectPointer
ProjectionSimilarityFilter::MakeOutput(DataObjectPointerArraySizeType index)
{
  if (index == 0)
  {
    return DecoratedTransformType::New().GetPointer();
  }
  return DecoratedRealType::New().GetPointer();
}

ProjectionSimilarityFilter::DecoratedTransformType *
ProjectionSimilarityFilter::GetTransformOutput()
{
  return dynamic_cast<DecoratedTransformType *>(this->ProcessObject::GetOutput(0));
}

const ProjectionSimilarityFilter::TransformType *
ProjectionSimilarityFilter::GetTransform()
{
  return this->GetTransformOutput()->Get();
}

ProjectionSimilarityFilter::DecoratedRealType *
ProjectionSimilarityFilter::GetRMSOutput()
{
  return dynamic_cast<DecoratedRealType *>(this->ProcessObject::GetOutput(1));
}

double
ProjectionSimilarityFilter::GetRMS()
{
  return this->GetRMSOutput()->Get();
}

void
ProjectionSimilarityFilter::GenerateData()
{
  const PoseSolution * solution = this->GetSolution();
  const auto           projection = solution->GetProjectionMatrix(m_Jaw);
  const PoseGeometry & geometry = solution->GetResult().geometry;
  const auto *         frame = this->GetFrame()->Get();
  if (frame == nullptr)
  {
    itkExceptionMacro("The frame is empty: give SetFrame() the transform of this jaw.");
  }
  // The geometry's own projection is that of the pose that moves nothing.
  const PoseModel own(geometry, PoseParameters{ {} });
  double          mean[4] = { 0.0, 0.0, 0.0, 0.0 };
  double          dot = 0.0;
  double          cross = 0.0;
  double          squares = 0.0;
  double          otherSquares = 0.0;
  double          count = 0.0;
  const auto *    points = this->GetMesh()->GetPoints();
  if (points == nullptr)
  {
    itkExceptionMacro("The mesh has no points: give SetMesh() the scan of the jaw.");
  }
  for (auto it = points->Begin(); it != points->End(); ++it)
  {
    PoseSolution::PointType point;
    point[0] = it.Value()[0];
    point[1] = it.Value()[1];
    point[2] = it.Value()[2];
    const auto q = frame->TransformPoint(point);
    double     w[2];
    own.Project(q.GetDataPointer(), w);
    const auto pixel = PoseModel::ToPixel(geometry, { { w[0], w[1] } });
    double     h[3];
    for (unsigned int row = 0; row < 3; ++row)
    {
      h[row] = projection(row, 0) * point[0] + projection(row, 1) * point[1] + projection(row, 2) * point[2] +
               projection(row, 3);
    }
    const double values[4] = {
      pixel[0] - geometry.principalPoint[0], pixel[1] - geometry.principalPoint[1], h[0] / h[2], h[1] / h[2]
    };
    // Running covariance: no cancellation (Welford).
    count += 1.0;
    double delta[4];
    for (unsigned int d = 0; d < 4; ++d)
    {
      delta[d] = values[d] - mean[d];
      mean[d] += delta[d] / count;
    }
    const double weight = (count - 1.0) / count;
    dot += weight * (delta[0] * delta[2] + delta[1] * delta[3]);
    cross += weight * (delta[0] * delta[3] - delta[1] * delta[2]);
    squares += weight * (delta[0] * delta[0] + delta[1] * delta[1]);
    otherSquares += weight * (delta[2] * delta[2] + delta[3] * delta[3]);
  }
  if (!(squares > 0.0))
  {
    itkExceptionMacro("The mesh has no extent: give SetMesh() the scan of the jaw.");
  }
  const double                  c = dot / squares;
  const double                  s = cross / squares;
  TransformType::ParametersType parameters(4);
  parameters[0] = std::hypot(dot, cross) / squares;
  parameters[1] = std::atan2(cross, dot);
  parameters[2] = mean[2] - c * mean[0] + s * mean[1];
  parameters[3] = mean[3] - s * mean[0] - c * mean[1];
  auto transform = TransformType::New();
  transform->SetParameters(parameters);
  this->GetTransformOutput()->Set(transform);
  // What is left over after the best scale and angle.
  this->GetRMSOutput()->Set(std::sqrt(std::max(0.0, otherSquares - (dot * dot + cross * cross) / squares) / count));
}

void
ProjectionSimilarityFilter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Jaw: " << static_cast<int>(m_Jaw) << std::endl;
}
} // namespace itk

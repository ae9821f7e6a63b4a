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
#include "itkSimilarityPlacementFilter.h"

#include "itkGeometryPlacementFilter.h"

#include <cmath>

namespace itk
{
SimilarityPlacementFilter::SimilarityPlacementFilter()
{
  this->AddRequiredInputName("Similarity", 0);
  this->AddRequiredInputName("Frame", 1);
  this->AddRequiredInputName("Geometry", 2);
  this->SetNumberOfRequiredOutputs(2);
  this->SetNthOutput(0, this->MakeOutput(0));
  this->SetNthOutput(1, this->MakeOutput(1));
}

SimilarityPlacementFilter::DataObjectPointer
SimilarityPlacementFilter::MakeOutput(DataObjectPointerArraySizeType index)
{
  if (index == 0)
  {
    return DecoratedTransformType::New().GetPointer();
  }
  return DecoratedMatrixType::New().GetPointer();
}

SimilarityPlacementFilter::DecoratedTransformType *
SimilarityPlacementFilter::GetTransformOutput()
{
  return itkDynamicCastInDebugMode<DecoratedTransformType *>(this->ProcessObject::GetOutput(0));
}

const SimilarityPlacementFilter::RigidTransformType *
SimilarityPlacementFilter::GetTransform()
{
  return this->GetTransformOutput()->Get();
}

SimilarityPlacementFilter::DecoratedMatrixType *
SimilarityPlacementFilter::GetProjectionMatrixOutput()
{
  return itkDynamicCastInDebugMode<DecoratedMatrixType *>(this->ProcessObject::GetOutput(1));
}

const SimilarityPlacementFilter::ProjectionMatrixType &
SimilarityPlacementFilter::GetProjectionMatrix()
{
  return this->GetProjectionMatrixOutput()->Get();
}

void
SimilarityPlacementFilter::VerifyPreconditions() ITKv5_CONST
{
  if (this->GetSimilarityInput() == nullptr)
  {
    itkExceptionMacro("No similarity: call SetSimilarity(), or SetSimilarityInput() with a registration's output.");
  }
  if (this->GetFrame() == nullptr)
  {
    itkExceptionMacro("No frame: call SetFrame() with a rigid transform, as UMidlineDentalAxisFilter gives it.");
  }
  if (this->GetGeometry() == nullptr)
  {
    itkExceptionMacro("No geometry: call SetGeometry() with that of the radiograph.");
  }
  Superclass::VerifyPreconditions();
}

void
SimilarityPlacementFilter::GenerateData()
{
  const GeometryType *   geometry = this->GetGeometry();
  const SimilarityType * similarity = this->GetSimilarity();
  auto                   placement = GeometryPlacementFilter::New();
  placement->SetGeometry(geometry);
  placement->SetFrame(this->GetFrame());
  placement->CentralRayThroughOriginOn();
  placement->Update();
  if (similarity == nullptr)
  {
    itkExceptionMacro("The similarity is empty: update the registration that finds it.");
  }
  const auto   parameters = similarity->GetParameters();
  const double scale = parameters[0];
  const double angle = parameters[1];
  if (!(scale > 0.0))
  {
    itkExceptionMacro("The scale " << scale << " of the similarity must be positive.");
  }

  // Similarity x projection x unit, as one matrix.
  const double         cs = scale * std::cos(angle);
  const double         sn = scale * std::sin(angle);
  const double         rows[3][3] = { { cs, -sn, parameters[2] }, { sn, cs, parameters[3] }, { 0.0, 0.0, 1.0 } };
  const auto           projection = placement->GetOutput()->GetProjectionMatrix();
  ProjectionMatrixType matrix;
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 4; ++column)
    {
      double sum = 0.0;
      for (unsigned int d = 0; d < 3; ++d)
      {
        sum += rows[row][d] * projection(d, column);
      }
      matrix(row, column) = column < 3 ? sum * m_MillimetresPerUnit : sum;
    }
  }
  this->GetProjectionMatrixOutput()->Set(matrix);

  const double f = geometry->GetFacingSign();
  const double c = std::cos(angle);
  const double s = f * std::sin(angle);
  // The scale is a factor on the magnification, as the pose registration's is: a pixel is so many mm fewer or more.
  const double m = scale * geometry->GetSourceToDetectorDistance() / geometry->GetSourceToMidsagittalDistance();
  const double shift[3] = { f * (parameters[2] - geometry->GetPrincipalPoint()[0]) * geometry->GetPixelSpacing()[0] / m,
                            0.0,
                            -(parameters[3] - geometry->GetPrincipalPoint()[1]) * geometry->GetPixelSpacing()[1] / m };
  const double turn[3][3] = { { c, 0.0, s }, { 0.0, 1.0, 0.0 }, { -s, 0.0, c } };
  const auto & own = this->GetFrame()->Get()->GetMatrix();
  const auto & offset = this->GetFrame()->Get()->GetOffset();
  RigidTransformType::MatrixType rotation;
  RigidTransformType::OffsetType translation;
  for (unsigned int row = 0; row < 3; ++row)
  {
    translation[row] = shift[row];
    for (unsigned int d = 0; d < 3; ++d)
    {
      translation[row] += turn[row][d] * offset[d];
    }
    for (unsigned int column = 0; column < 3; ++column)
    {
      rotation(row, column) = 0.0;
      for (unsigned int d = 0; d < 3; ++d)
      {
        rotation(row, column) += turn[row][d] * own(d, column);
      }
    }
  }
  auto transform = RigidTransformType::New();
  // As far as rounding goes: a product of rotations.
  transform->SetMatrix(rotation, 1e-6);
  transform->SetOffset(translation);
  this->GetTransformOutput()->Set(transform);
}

void
SimilarityPlacementFilter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "MillimetresPerUnit: " << m_MillimetresPerUnit << std::endl;
}
} // namespace itk

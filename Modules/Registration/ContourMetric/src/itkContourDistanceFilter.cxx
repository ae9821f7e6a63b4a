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
#include "itkContourDistanceFilter.h"

#include "itkContourChamferKernel.h"
#include "itkMakeContourArrays.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
struct SummaryType
{
  double mean{ 0.0 };
  double largest{ 0.0 };
};

SummaryType
Summarize(const std::vector<double> & distances, const std::vector<double> & weights)
{
  SummaryType summary;
  double      sumOfWeights = 0.0;
  for (std::size_t i = 0; i < distances.size(); ++i)
  {
    const double weight = weights.empty() ? 1.0 : weights[i];
    if (weight > 0.0)
    {
      summary.mean += weight * distances[i];
      sumOfWeights += weight;
      summary.largest = std::max(summary.largest, distances[i]);
    }
  }
  summary.mean /= sumOfWeights;
  return summary;
}

bool
HasWeight(const ContourArrays & contour)
{
  return contour.weights.empty()
           ? contour.GetNumberOfPoints() > 0
           : std::any_of(contour.weights.begin(), contour.weights.end(), [](double weight) { return weight > 0.0; });
}

std::vector<ContourDistanceFilter::ToothDistanceType>
SummarizeByTooth(const DentalContour & contour, const std::vector<double> & distances)
{
  std::vector<ContourDistanceFilter::ToothDistanceType> teeth;
  for (DentalContour::PointIdentifier id = 0; id < contour.GetNumberOfPoints(); ++id)
  {
    const double distance = distances[id];
    if (!std::isfinite(distance))
    {
      continue;
    }
    const ToothCode code = contour.GetToothCode(id);
    auto tooth = std::find_if(teeth.begin(), teeth.end(), [&](const auto & other) { return other.tooth == code; });
    if (tooth == teeth.end())
    {
      tooth = teeth.insert(tooth, ContourDistanceFilter::ToothDistanceType());
      tooth->tooth = code;
    }
    ++tooth->numberOfPoints;
    tooth->mean += distance;
    tooth->rms += distance * distance;
    tooth->maximum = std::max(tooth->maximum, distance);
  }
  for (auto & tooth : teeth)
  {
    tooth.mean /= static_cast<double>(tooth.numberOfPoints);
    tooth.rms = std::sqrt(tooth.rms / static_cast<double>(tooth.numberOfPoints));
  }
  return teeth;
}
} // namespace

ContourDistanceFilter::ContourDistanceFilter()
{
  this->SetPrimaryInputName("FixedContour");
  this->AddRequiredInputName("MovingContour", 1);
  this->AddOptionalInputName("Transform", 2);
  this->SetNumberOfRequiredOutputs(0);
  this->SetPrimaryOutputName("Chamfer");
  for (const char * name : { "Chamfer",
                             "MovingToFixedMean",
                             "FixedToMovingMean",
                             "MovingToFixedHausdorff",
                             "FixedToMovingHausdorff",
                             "Hausdorff" })
  {
    this->ProcessObject::SetOutput(name, this->MakeOutput(name));
  }
}

DataObject::Pointer
ContourDistanceFilter::MakeOutput(const DataObjectIdentifierType & name)
{
  return Superclass::MakeOutput(name).IsNull() ? nullptr : RealObjectType::New().GetPointer();
}

void
ContourDistanceFilter::VerifyPreconditions() ITKv5_CONST
{
  if (this->GetFixedContour() == nullptr)
  {
    itkExceptionMacro("No fixed contour: call SetFixedContour() with the tracing.");
  }
  if (this->GetMovingContour() == nullptr)
  {
    itkExceptionMacro("No moving contour: call SetMovingContour() with the aligned silhouette.");
  }
  Superclass::VerifyPreconditions();
}

void
ContourDistanceFilter::GenerateData()
{
  const ContourArrays fixed = MakeContourArrays(*this->GetFixedContour());
  const ContourArrays moving = MakeContourArrays(*this->GetMovingContour());
  if (!HasWeight(fixed))
  {
    itkExceptionMacro("The fixed contour has no point of positive weight: there is nothing to measure to.");
  }
  if (!HasWeight(moving))
  {
    itkExceptionMacro("The moving contour has no point of positive weight: there is nothing to measure to.");
  }
  ContourSimilarity similarity;
  if (this->GetTransform() != nullptr)
  {
    similarity.scale = this->GetTransform()->GetScale();
    similarity.angle = this->GetTransform()->GetAngle();
    similarity.tx = this->GetTransform()->GetOffset()[0];
    similarity.ty = this->GetTransform()->GetOffset()[1];
    if (!(similarity.scale > 0.0))
    {
      itkExceptionMacro("The transform's scale " << similarity.scale << " is not positive.");
    }
  }
  ContourChamferKernel kernel;
  kernel.Initialize(fixed, moving, m_Distance);
  m_MovingToFixedDistances = kernel.GetMovingToFixedDistances(similarity);
  this->UpdateProgress(0.5f);
  m_FixedToMovingDistances = kernel.GetFixedToMovingDistances(similarity);
  m_FixedToMovingDistancesByTooth = SummarizeByTooth(*this->GetFixedContour(), m_FixedToMovingDistances);

  const SummaryType movingToFixed = Summarize(m_MovingToFixedDistances, moving.weights);
  const SummaryType fixedToMoving = Summarize(m_FixedToMovingDistances, fixed.weights);
  this->SetMovingToFixedMean(movingToFixed.mean);
  this->SetFixedToMovingMean(fixedToMoving.mean);
  this->SetChamfer(0.5 * (movingToFixed.mean + fixedToMoving.mean));
  this->SetMovingToFixedHausdorff(movingToFixed.largest);
  this->SetFixedToMovingHausdorff(fixedToMoving.largest);
  this->SetHausdorff(std::max(movingToFixed.largest, fixedToMoving.largest));
}

void
ContourDistanceFilter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Distance: " << m_Distance << std::endl;
  os << indent << "MovingToFixedMean: " << this->GetMovingToFixedMean() << std::endl;
  os << indent << "FixedToMovingMean: " << this->GetFixedToMovingMean() << std::endl;
  os << indent << "Chamfer: " << this->GetChamfer() << std::endl;
  os << indent << "MovingToFixedHausdorff: " << this->GetMovingToFixedHausdorff() << std::endl;
  os << indent << "FixedToMovingHausdorff: " << this->GetFixedToMovingHausdorff() << std::endl;
  os << indent << "Hausdorff: " << this->GetHausdorff() << std::endl;
  os << indent << "MovingToFixedDistances: " << m_MovingToFixedDistances.size() << std::endl;
  os << indent << "FixedToMovingDistances: " << m_FixedToMovingDistances.size() << std::endl;
  os << indent << "FixedToMovingDistancesByTooth: " << m_FixedToMovingDistancesByTooth.size() << std::endl;
}
} // namespace itk

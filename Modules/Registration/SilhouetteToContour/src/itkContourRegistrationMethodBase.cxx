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
#include "itkContourRegistrationMethodBase.h"

#include "itkMakeContourArrays.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace itk
{
namespace
{
/** Bounding box, centroid and whether there are two distinct points, of the points that count. */
struct ExtentType
{
  double low[2]{ 0.0, 0.0 };
  double high[2]{ 0.0, 0.0 };
  double centroid[2]{ 0.0, 0.0 };

  double
  GetDiagonal() const
  {
    return std::hypot(high[0] - low[0], high[1] - low[1]);
  }
};

ExtentType
MeasureExtent(const DentalContour & contour, const char * name)
{
  const ContourArrays arrays = MakeContourArrays(contour);
  ExtentType          extent;
  double              sumOfWeights = 0.0;
  for (std::size_t i = 0; i < arrays.GetNumberOfPoints(); ++i)
  {
    const double weight = arrays.weights.empty() ? 1.0 : arrays.weights[i];
    if (!(weight > 0.0))
    {
      continue;
    }
    for (int k = 0; k < 2; ++k)
    {
      const double x = arrays.points[2 * i + k];
      extent.low[k] = sumOfWeights > 0.0 ? std::min(extent.low[k], x) : x;
      extent.high[k] = sumOfWeights > 0.0 ? std::max(extent.high[k], x) : x;
      extent.centroid[k] += weight * x;
    }
    sumOfWeights += weight;
  }
  extent.centroid[0] /= sumOfWeights;
  extent.centroid[1] /= sumOfWeights;
  if (!(sumOfWeights > 0.0))
  {
    itkGenericExceptionMacro("The " << name
                                    << " contour has no point of positive weight; there is nothing to register.");
  }
  if (!(extent.GetDiagonal() > 0.0))
  {
    itkGenericExceptionMacro(
      "The " << name
             << " contour is a single point, which has neither size nor direction; give at least "
                "two distinct points.");
  }
  return extent;
}

ContourSimilarity
ComputeBoundingBoxSimilarity(const DentalContour & fixed, const DentalContour & moving)
{
  const ExtentType  to = MeasureExtent(fixed, "fixed");
  const ExtentType  from = MeasureExtent(moving, "moving");
  ContourSimilarity similarity;
  similarity.scale = to.GetDiagonal() / from.GetDiagonal();
  similarity.tx = to.centroid[0] - similarity.scale * from.centroid[0];
  similarity.ty = to.centroid[1] - similarity.scale * from.centroid[1];
  return similarity;
}
} // namespace

ContourRegistrationMethodBase::ContourRegistrationMethodBase()
  : m_InitialParameters(4)
  , m_OptimizerPosition(4)
{
  this->SetPrimaryInputName("FixedContour");
  this->AddRequiredInputName("MovingContour", 1);
  this->AddOptionalInputName("InitialTransform", 2);
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
  m_InitialParameters.Fill(0.0);
  m_OptimizerPosition.Fill(0.0);
}

DataObject::Pointer
ContourRegistrationMethodBase::MakeOutput(DataObjectPointerArraySizeType)
{
  return DecoratedTransformType::New().GetPointer();
}

auto
ContourRegistrationMethodBase::GetOutput() -> DecoratedTransformType *
{
  return static_cast<DecoratedTransformType *>(this->ProcessObject::GetOutput(0));
}

auto
ContourRegistrationMethodBase::GetOutput() const -> const DecoratedTransformType *
{
  return static_cast<const DecoratedTransformType *>(this->ProcessObject::GetOutput(0));
}

auto
ContourRegistrationMethodBase::GetTransform() const -> const TransformType *
{
  return this->GetOutput()->Get();
}

auto
ContourRegistrationMethodBase::ComputeBoundingBoxTransform(const ContourType * fixed, const ContourType * moving)
  -> TransformType::Pointer
{
  if (fixed == nullptr || moving == nullptr)
  {
    itkGenericExceptionMacro("The bounding-box start needs a fixed and a moving contour.");
  }
  const auto transform = TransformType::New();
  transform->SetParameters(MakeParameters(ComputeBoundingBoxSimilarity(*fixed, *moving)));
  return transform;
}

void
ContourRegistrationMethodBase::VerifyPreconditions() ITKv5_CONST
{
  if (this->GetFixedContour() == nullptr)
  {
    itkExceptionMacro("No fixed contour: call SetFixedContour() with the tracing.");
  }
  if (this->GetMovingContour() == nullptr)
  {
    itkExceptionMacro("No moving contour: call SetMovingContour() with the projected silhouette.");
  }
  Superclass::VerifyPreconditions();
}

ContourSimilarity
ContourRegistrationMethodBase::FindStart() const
{
  ContourSimilarity similarity = ComputeBoundingBoxSimilarity(*this->GetFixedContour(), *this->GetMovingContour());
  if (const TransformType * initial = this->GetInitialTransform())
  {
    similarity.scale = initial->GetScale();
    similarity.angle = initial->GetAngle();
    similarity.tx = initial->GetOffset()[0];
    similarity.ty = initial->GetOffset()[1];
    if (!(similarity.scale > 0.0))
    {
      itkExceptionMacro("The initial transform's scale " << similarity.scale << " is not positive.");
    }
  }
  return similarity;
}

ContourSimilarity
ContourRegistrationMethodBase::StartRun()
{
  m_CurrentLevel = 0;
  m_OptimizerIteration = 0;
  m_MetricValue = 0.0;
  m_StopConditionDescription.clear();
  const ContourSimilarity start = this->FindStart();
  m_InitialParameters = MakeParameters(start);
  m_OptimizerPosition = m_InitialParameters;
  return start;
}

void
ContourRegistrationMethodBase::SetIteration(unsigned int              level,
                                            std::size_t               iteration,
                                            double                    value,
                                            const ContourSimilarity & similarity)
{
  m_CurrentLevel = level;
  m_OptimizerIteration = iteration;
  m_MetricValue = value;
  m_OptimizerPosition = MakeParameters(similarity);
}

void
ContourRegistrationMethodBase::CheckAbort()
{
  if (this->GetAbortGenerateData())
  {
    std::ostringstream text;
    text << "Aborted in level " << m_CurrentLevel << " after " << m_OptimizerIteration << " iterations.";
    m_StopConditionDescription = text.str();
    ProcessAborted exception(__FILE__, __LINE__);
    exception.SetDescription(text.str());
    throw exception;
  }
}

void
ContourRegistrationMethodBase::SetResult(const ContourSimilarity & similarity)
{
  m_OptimizerPosition = MakeParameters(similarity);
  const auto transform = TransformType::New();
  transform->SetParameters(m_OptimizerPosition);
  this->GetOutput()->Set(transform);
  this->UpdateProgress(1.0F);
}

auto
ContourRegistrationMethodBase::MakeParameters(const ContourSimilarity & similarity) -> ParametersType
{
  ParametersType parameters(4);
  parameters[0] = similarity.scale;
  parameters[1] = similarity.angle;
  parameters[2] = similarity.tx;
  parameters[3] = similarity.ty;
  return parameters;
}

void
ContourRegistrationMethodBase::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "InitialParameters: " << m_InitialParameters << std::endl;
  os << indent << "CurrentLevel: " << m_CurrentLevel << std::endl;
  os << indent << "OptimizerIteration: " << m_OptimizerIteration << std::endl;
  os << indent << "MetricValue: " << m_MetricValue << std::endl;
  os << indent << "OptimizerPosition: " << m_OptimizerPosition << std::endl;
  os << indent << "StopConditionDescription: " << m_StopConditionDescription << std::endl;
}
} // namespace itk

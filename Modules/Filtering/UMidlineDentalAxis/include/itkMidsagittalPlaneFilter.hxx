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
#ifndef itkMidsagittalPlaneFilter_hxx
#define itkMidsagittalPlaneFilter_hxx

#include "itkMidsagittalPlaneFilter.h"

#include "itkMakeTriangleSurface.h"

namespace itk
{
template <typename TMesh>
MidsagittalPlaneFilter<TMesh>::MidsagittalPlaneFilter()
{
  this->SetPrimaryInputName("UpperMesh");
  this->AddOptionalInputName("LowerMesh", 1);
  this->SetNumberOfRequiredInputs(0);
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
}

template <typename TMesh>
auto
MidsagittalPlaneFilter<TMesh>::MakeOutput(DataObjectPointerArraySizeType) -> DataObjectPointer
{
  return PlaneObjectType::New().GetPointer();
}

template <typename TMesh>
auto
MidsagittalPlaneFilter<TMesh>::GetPlaneOutput() -> PlaneObjectType *
{
  return static_cast<PlaneObjectType *>(this->ProcessObject::GetOutput(0));
}

template <typename TMesh>
auto
MidsagittalPlaneFilter<TMesh>::GetPlaneOutput() const -> const PlaneObjectType *
{
  return static_cast<const PlaneObjectType *>(this->ProcessObject::GetOutput(0));
}

template <typename TMesh>
auto
MidsagittalPlaneFilter<TMesh>::GetNormal() const -> VectorType
{
  return VectorType(this->GetPlaneOutput()->Get().normal.data());
}

template <typename TMesh>
double
MidsagittalPlaneFilter<TMesh>::GetOffset() const
{
  return this->GetPlaneOutput()->Get().offset;
}

template <typename TMesh>
double
MidsagittalPlaneFilter<TMesh>::SignedDistance(const PointType & point) const
{
  return this->GetNormal() * point.GetVectorFromOrigin() - this->GetOffset();
}

template <typename TMesh>
void
MidsagittalPlaneFilter<TMesh>::VerifyPreconditions() ITKv5_CONST
{
  Superclass::VerifyPreconditions();
  if (this->GetUpperMesh() == nullptr && this->GetLowerMesh() == nullptr)
  {
    itkExceptionMacro("There is no mesh. Call SetUpperMesh() or SetLowerMesh().");
  }
  if (!(m_Options.startStep > 0.0 && m_Options.trimmedFraction > 0.0 && m_Options.trimmedFraction <= 1.0 &&
        m_Options.truncationDistance > 0.0 && m_Options.rankingDistance > 0.0 && m_Options.normalWeight >= 0.0))
  {
    itkExceptionMacro("The options have startStep "
                      << m_Options.startStep << ", trimmedFraction " << m_Options.trimmedFraction
                      << ", truncationDistance " << m_Options.truncationDistance << ", rankingDistance "
                      << m_Options.rankingDistance << ", normalWeight " << m_Options.normalWeight
                      << "; the first, third and fourth must be positive, the second in (0, 1], the last not negative. "
                         "Call SetOptions().");
  }
}

template <typename TMesh>
void
MidsagittalPlaneFilter<TMesh>::GenerateData()
{
  const MeshType * upper = this->GetUpperMesh();
  const MeshType * lower = this->GetLowerMesh();
  TriangleSurface  surfaces[2];
  if (upper != nullptr)
  {
    surfaces[0] = MakeTriangleSurface(upper);
  }
  if (lower != nullptr)
  {
    surfaces[1] = MakeTriangleSurface(lower);
  }
  this->UpdateProgress(0.1f);
  DentalFrameOptions options;
  options.jawsShareFrame = DentalFrameEnums::JawsShareFrame::On;
  options.refineMidline = true;
  options.midline = m_Options;
  options.threads = this->GetNumberOfWorkUnits();
  options.abort = [this]() { return this->GetAbortGenerateData(); };
  const DentalFrameResult frame =
    EstimateDentalFrame(upper != nullptr ? &surfaces[0] : nullptr, lower != nullptr ? &surfaces[1] : nullptr, options);
  if (this->GetAbortGenerateData())
  {
    this->ResetPipeline();
    throw ProcessAborted(__FILE__, __LINE__);
  }
  const MidsagittalPlaneResult & plane = upper != nullptr ? frame.midsagittalUpper : frame.midsagittalLower;
  if ((upper != nullptr && !frame.upper.valid) || (lower != nullptr && !frame.lower.valid) || !plane.valid)
  {
    itkExceptionMacro("No dental arch was found in the "
                      << (upper != nullptr && !frame.upper.valid ? "upper" : "lower")
                      << " mesh. Check its unit (mm) and that it shows the teeth of a whole jaw.");
  }
  this->GetPlaneOutput()->Set(plane);
  this->GetPlaneOutput()->Modified();
  this->UpdateProgress(1.0f);
}

template <typename TMesh>
void
MidsagittalPlaneFilter<TMesh>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "NormalWeight: " << m_Options.normalWeight << std::endl;
  os << indent << "TrimmedFraction: " << m_Options.trimmedFraction << std::endl;
  os << indent << "TruncationDistance: " << m_Options.truncationDistance << std::endl;
  os << indent << "RankingDistance: " << m_Options.rankingDistance << std::endl;
  os << indent << "SearchSamples: " << m_Options.searchSamples << std::endl;
  os << indent << "FinalSamples: " << m_Options.finalSamples << std::endl;
  os << indent << "StartStep: " << m_Options.startStep << std::endl;
  os << indent << "StartRange: " << m_Options.startRange << std::endl;
  os << indent << "Restarts: " << (m_Options.restarts ? "On" : "Off") << std::endl;
  const MidsagittalPlaneResult & plane = this->GetPlaneOutput()->Get();
  os << indent << "Normal: " << VectorType(plane.normal.data()) << std::endl;
  os << indent << "Offset: " << plane.offset << std::endl;
  os << indent << "Residual: " << plane.residual << std::endl;
  os << indent << "InlierFraction: " << plane.inlierFraction << std::endl;
  os << indent << "Margin: " << plane.margin << std::endl;
}
} // namespace itk

#endif

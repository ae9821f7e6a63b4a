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
#ifndef itkContourMaskFilter_hxx
#define itkContourMaskFilter_hxx

#include <vector>

namespace itk
{
template <typename TMaskImage>
ContourMaskFilter<TMaskImage>::ContourMaskFilter()
{
  this->AddRequiredInputName("MaskImage");
}

template <typename TMaskImage>
void
ContourMaskFilter<TMaskImage>::VerifyPreconditions() ITKv5_CONST
{
  if (this->GetInput() == nullptr)
  {
    itkExceptionMacro("No contour: call SetInput() with a DentalContour.");
  }
  if (this->GetMaskImage() == nullptr)
  {
    itkExceptionMacro("No mask: call SetMaskImage() with an image that is not 0 where the contour is to be kept.");
  }
  Superclass::VerifyPreconditions();
}

template <typename TMaskImage>
void
ContourMaskFilter<TMaskImage>::GenerateInputRequestedRegion()
{
  Superclass::GenerateInputRequestedRegion();
  // Where the contour runs is not known before it is there.
  const_cast<MaskImageType *>(this->GetMaskImage())->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TMaskImage>
void
ContourMaskFilter<TMaskImage>::GenerateData()
{
  DentalContour * const output = this->GetOutput();
  output->Initialize();
  // Without it every Update() would execute again.
  output->SetBufferedRegion(0);
  const MaskImageType * const mask = this->GetMaskImage();
  const auto                  region = mask->GetBufferedRegion();
  for (const auto & polyline : this->GetInput()->GetPolylines())
  {
    const std::size_t count = polyline.points.size();
    std::vector<bool> keep(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      typename MaskImageType::IndexType index;
      for (unsigned int d = 0; d < 2; ++d)
      {
        index[d] = Math::RoundHalfIntegerUp<IndexValueType>(polyline.points[i][d]);
      }
      keep[i] = region.IsInside(index) && mask->GetPixel(index) != typename MaskImageType::PixelType{};
    }
    for (const auto & stretch : KeepPoints(polyline, keep))
    {
      if (stretch.points.size() >= m_MinimumNumberOfPoints)
      {
        output->AddPolyline(stretch);
      }
    }
  }
}

template <typename TMaskImage>
void
ContourMaskFilter<TMaskImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "MinimumNumberOfPoints: " << m_MinimumNumberOfPoints << std::endl;
}
} // namespace itk

#endif

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
#ifndef itkContourMaskFilter_h
#define itkContourMaskFilter_h

#include "SilhouetteContourExport.h"
#include "itkDentalContour.h"
#include "itkImage.h"
#include "itkMeshToMeshFilter.h"

namespace itk
{
/** \class ContourMaskFilter
 * \brief The stretches of a contour that run through a mask, as polylines of their own.
 *
 * The outline of a segmented object is only in part what a scan shows: elsewhere it is the edge of a window, or where
 * two things overlap. A mask, made by any ITK filter, says where it is to be believed. Inputs: a contour in continuous
 * pixel indices and a mask image of which only these indices count (no origin, spacing, direction). A point is kept
 * where the pixel that it lies in is not 0; outside of the mask's buffered region it is not. A stretch of kept points
 * becomes an open polyline; across the start of a closed polyline it is one; a polyline that is kept as a whole stays
 * as it is, closed where it was. Codes, weights, sigmas, kinds and what a
 * silhouette's points know are kept. Stretches of fewer than
 * MinimumNumberOfPoints points are left out.
 *
 * Errors: no contour, no mask.
 *
 * \ingroup SilhouetteContour
 */
template <typename TMaskImage>
class ITK_TEMPLATE_EXPORT ContourMaskFilter : public MeshToMeshFilter<DentalContour, DentalContour>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ContourMaskFilter);

  using Self = ContourMaskFilter;
  using Superclass = MeshToMeshFilter<DentalContour, DentalContour>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(ContourMaskFilter, MeshToMeshFilter);

  static_assert(TMaskImage::ImageDimension == 2, "A mask of contours has two dimensions.");

  using MaskImageType = TMaskImage;

  /** Where the contour is kept. */
  itkSetInputMacro(MaskImage, MaskImageType);
  itkGetInputMacro(MaskImage, MaskImageType);

  /** Default 2. */
  itkSetClampMacro(MinimumNumberOfPoints, SizeValueType, 1, NumericTraits<SizeValueType>::max());
  itkGetConstMacro(MinimumNumberOfPoints, SizeValueType);

protected:
  ContourMaskFilter();
  ~ContourMaskFilter() override = default;

  void
  VerifyPreconditions() ITKv5_CONST override;

  /** A contour has no physical space to compare. */
  void
  VerifyInputInformation() ITKv5_CONST override
  {}

  /** The mask has none of a mesh's information, and the whole of it is needed. */
  void
  GenerateOutputInformation() override
  {}

  void
  GenerateInputRequestedRegion() override;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  SizeValueType m_MinimumNumberOfPoints{ 2 };
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkContourMaskFilter.hxx"
#endif

namespace itk
{
extern template class ContourMaskFilter<Image<unsigned char, 2>>;
extern template class ContourMaskFilter<Image<unsigned short, 2>>;
} // namespace itk

#endif

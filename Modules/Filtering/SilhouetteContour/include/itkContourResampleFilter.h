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
#ifndef itkContourResampleFilter_h
#define itkContourResampleFilter_h

#include "SilhouetteContourExport.h"
#include "itkDentalContour.h"
#include "itkMeshToMeshFilter.h"

namespace itk
{
/** \class ContourResampleFilter
 * \brief Points at equal distances along every polyline of a contour.
 *
 * Either the number of points in total, which is shared out by the polylines' lengths (at least 2 for an open one, 3
 * for a closed one), or the distance between points, which is rounded so that it fits a whole number of times. Open
 * polylines keep their first and last point; closed ones begin at their first point. Codes are kept, weights are
 * interpolated; rim point, normal and tooth are those of the nearer of the two points that a new one lies between. Lone
 * points and polylines of no length become one point each.
 *
 * Distances are Euclidean in the units of the points: pixels. Corners between the new points are cut.
 *
 * Source: arc-length resampling of the silhouettes in the paper (441 and 439 points).
 *
 * \ingroup SilhouetteContour
 */
class SilhouetteContour_EXPORT ContourResampleFilter : public MeshToMeshFilter<DentalContour, DentalContour>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ContourResampleFilter);

  using Self = ContourResampleFilter;
  using Superclass = MeshToMeshFilter<DentalContour, DentalContour>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(ContourResampleFilter, MeshToMeshFilter);

  /** Points in total; 0 (the default): by Spacing. */
  itkSetMacro(NumberOfPoints, SizeValueType);
  itkGetConstMacro(NumberOfPoints, SizeValueType);

  /** px between points, used where NumberOfPoints is 0. Default 1. */
  itkSetMacro(Spacing, double);
  itkGetConstMacro(Spacing, double);

protected:
  ContourResampleFilter() = default;
  ~ContourResampleFilter() override = default;

  void
  VerifyPreconditions() ITKv5_CONST override;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  SizeValueType m_NumberOfPoints{ 0 };
  double        m_Spacing{ 1.0 };
};
} // namespace itk

#endif

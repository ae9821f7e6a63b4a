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
#ifndef itkContourTransformFilter_h
#define itkContourTransformFilter_h

#include "SilhouetteToContourExport.h"
#include "itkDentalContour.h"

#include "itkDataObjectDecorator.h"
#include "itkMeshToMeshFilter.h"
#include "itkTransform.h"

namespace itk
{
/** \class ContourTransformFilter
 * \brief A contour whose points a 2-D transform has moved: the aligned silhouette for an overlay.
 *
 * Codes, weights, order and closedness of the polylines are kept, so are rim points, which are on the surface and do
 * not move with their image; normals are turned. (TransformMeshFilter of ITK is for meshes whose cells are shared with
 * the output; a DentalContour reads its polylines back from its own.)
 *
 * Errors (ExceptionObject): no contour or no transform.
 *
 * \test itkContourTransformFilterGTest.cxx
 * \ingroup SilhouetteToContour
 */
class SilhouetteToContour_EXPORT ContourTransformFilter : public MeshToMeshFilter<DentalContour, DentalContour>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ContourTransformFilter);

  using Self = ContourTransformFilter;
  using Superclass = MeshToMeshFilter<DentalContour, DentalContour>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(ContourTransformFilter, MeshToMeshFilter);

  using TransformType = Transform<double, 2, 2>;
  /** From the contour's picture to the output's, pixels. Must be set. */
  itkSetGetDecoratedObjectInputMacro(Transform, TransformType);

protected:
  ContourTransformFilter();
  ~ContourTransformFilter() override = default;
  void
  VerifyPreconditions() ITKv5_CONST override;
  void
  GenerateData() override;
};
} // namespace itk

#endif

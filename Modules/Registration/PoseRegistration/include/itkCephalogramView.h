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
#ifndef itkCephalogramView_h
#define itkCephalogramView_h

#include "PoseRegistrationExport.h"

#include "itkCephalometricGeometry.h"
#include "itkCephalometricLandmarkSet.h"
#include "itkDataObject.h"
#include "itkDentalContour.h"
#include "itkLandmarkCounterpartSet.h"
#include "itkScalePrior.h"
#include "itkToothCode.h"

#include <string>

namespace itk
{
/** \class CephalogramView
 * \brief A further radiograph of the same patient, with what was drawn on it: evidence of PoseRegistrationMethod beside
 * the first, lateral one.
 *
 * Its geometry says from where it was taken (CephalometricGeometry::SetDirection()), and where its principal point and
 * pixel spacing are: both have to be known. A frontal tracing is of single teeth with their codes, incisal edges and
 * buccal borders of molars; landmarks have sides. Any of contours and landmarks may be missing, as long as something is
 * there.
 *
 * Biplanar machines take both radiographs at once (SameHeadPosition). Otherwise the patient was turned in the ear rods,
 * and small rotations and shifts of the head are estimated along.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT CephalogramView : public DataObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(CephalogramView);

  using Self = CephalogramView;
  using Superclass = DataObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(CephalogramView, DataObject);

  /** Short; what results and messages call it. Views of one registration differ in it. */
  itkSetStringMacro(Name);
  itkGetStringMacro(Name);

  /** Where the radiograph was taken. Its pose is not used. */
  itkSetConstObjectMacro(Geometry, CephalometricGeometry);
  itkGetConstObjectMacro(Geometry, CephalometricGeometry);

  /** Continuous pixel indices of this radiograph. */
  itkSetConstObjectMacro(UpperContour, DentalContour);
  itkGetConstObjectMacro(UpperContour, DentalContour);
  itkSetConstObjectMacro(LowerContour, DentalContour);
  itkGetConstObjectMacro(LowerContour, DentalContour);
  const DentalContour *
  GetContour(ToothCode::JawEnum jaw) const
  {
    return jaw == ToothCode::JawEnum::Lower ? m_LowerContour.GetPointer() : m_UpperContour.GetPointer();
  }

  /** Landmarks of this radiograph, and where they are on the scans (LandmarkCounterpartFilter), meshes' frames. */
  itkSetConstObjectMacro(CephalometricLandmarks, CephalometricLandmarkSet);
  itkGetConstObjectMacro(CephalometricLandmarks, CephalometricLandmarkSet);
  itkSetConstObjectMacro(LandmarkCounterparts, LandmarkCounterpartSet);
  itkGetConstObjectMacro(LandmarkCounterparts, LandmarkCounterpartSet);

  /** Whether the head stood as in the first radiograph. On by default. */
  itkSetMacro(SameHeadPosition, bool);
  itkGetConstMacro(SameHeadPosition, bool);
  itkBooleanMacro(SameHeadPosition);

  /** How well the principal point is known, pixels, 1 sd an axis: a pixel of it is a quarter of a millimetre of shift.
   * Default 4. */
  itkSetMacro(PrincipalPointSigma, double);
  itkGetConstMacro(PrincipalPointSigma, double);

  /** Where the pixel spacing comes from, of which the prior of the view's scale is. Given by default. */
  itkSetEnumMacro(SpacingSource, ScalePrior::SpacingSource);
  itkGetEnumMacro(SpacingSource, ScalePrior::SpacingSource);

  /** Of the geometry, contours and landmarks as well. */
  ModifiedTimeType
  GetMTime() const override;

  /** Throws an exception that names what is missing, and the call to make. */
  void
  Verify() const;

protected:
  CephalogramView() = default;
  ~CephalogramView() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  std::string                            m_Name{ "frontal" };
  CephalometricGeometry::ConstPointer    m_Geometry;
  DentalContour::ConstPointer            m_UpperContour;
  DentalContour::ConstPointer            m_LowerContour;
  CephalometricLandmarkSet::ConstPointer m_CephalometricLandmarks;
  LandmarkCounterpartSet::ConstPointer   m_LandmarkCounterparts;
  bool                                   m_SameHeadPosition{ true };
  double                                 m_PrincipalPointSigma{ 4.0 };
  ScalePrior::SpacingSource              m_SpacingSource{ ScalePrior::SpacingSource::Given };
};
} // namespace itk

#endif

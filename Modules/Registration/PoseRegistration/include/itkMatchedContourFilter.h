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
#ifndef itkMatchedContourFilter_h
#define itkMatchedContourFilter_h

#include "PoseRegistrationExport.h"

#include "itkDentalContour.h"
#include "itkProcessObject.h"

namespace itk
{
/** \class MatchedContourFilter
 * \brief The part of a moving contour that has a tracing beside it, in pieces.
 *
 * The moving contour of a pose registration (PoseSolution::MakeMovingContour()) holds everything that could be matched.
 * What lies within MaximumDistance of a tracing's point is kept; a stretch that is not, or a gap longer than
 * MaximumGap, ends a piece. Lengths in pixels of the contours.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT MatchedContourFilter : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(MatchedContourFilter);

  using Self = MatchedContourFilter;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(MatchedContourFilter, ProcessObject);

  using ContourType = DentalContour;
  using Superclass::MakeOutput;
  using DataObjectPointer = Superclass::DataObjectPointer;
  using DataObjectPointerArraySizeType = Superclass::DataObjectPointerArraySizeType;
  /** The tracing and the contour, continuous pixel indices. Both must be set. */
  itkSetInputMacro(FixedContour, ContourType);
  itkGetInputMacro(FixedContour, ContourType);
  itkSetInputMacro(MovingContour, ContourType);
  itkGetInputMacro(MovingContour, ContourType);

  /** 10 px by default: 2.5 mm at 0.25 mm a pixel. */
  itkSetMacro(MaximumDistance, double);
  itkGetConstMacro(MaximumDistance, double);
  /** 12 px by default. */
  itkSetMacro(MaximumGap, double);
  itkGetConstMacro(MaximumGap, double);
  /** The pieces, continuous pixel indices. */
  ContourType *
  GetOutput();

  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  MatchedContourFilter();
  ~MatchedContourFilter() override = default;
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  double m_MaximumDistance{ 10.0 };
  double m_MaximumGap{ 12.0 };
};
} // namespace itk

#endif

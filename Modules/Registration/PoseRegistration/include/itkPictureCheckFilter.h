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
#ifndef itkPictureCheckFilter_h
#define itkPictureCheckFilter_h

#include "PoseRegistrationExport.h"
#include "itkRegistrationFinding.h"

#include "itkCephalometricGeometry.h"
#include "itkDentalContour.h"
#include "itkImage.h"
#include "itkProcessObject.h"
#include "itkSimpleDataObjectDecorator.h"

#include <string>
#include <vector>

namespace itk
{
/** \class PictureCheckFilter
 * \brief Whether a radiograph is the one that was drawn on, as far as its grey values tell: a registration fits what
 * was drawn, and never looks at the picture.
 *
 * Inputs: the radiograph and what was drawn of each jaw (continuous pixel indices), all of which may be missing, and
 * the geometry, whose pixel spacing says how wide an edge of the picture is (unknown: nothing can be told). Output: the
 * findings, which are about every jaw that was drawn; none where the drawing lies on edges of the picture.
 * GetNotCheckable() says what could not be told.
 *
 * A picture that was turned or mirrored after it was drawn on is told where the drawing lies on edges in that reading,
 * better than anywhere about, and is nothing special where it is; one that was not drawn on, where it does so up to
 * 40 mm beside. Code: \c picture (Documentation/Findings.md).
 *
 * Errors: no geometry.
 *
 * \test itkPictureCheckFilterGTest.cxx
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT PictureCheckFilter : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(PictureCheckFilter);

  using Self = PictureCheckFilter;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(PictureCheckFilter, ProcessObject);

  using ImageType = Image<float, 2>;
  using FindingsType = std::vector<RegistrationFinding>;
  using DecoratedFindingsType = SimpleDataObjectDecorator<FindingsType>;
  using Superclass::MakeOutput;
  using DataObjectPointer = Superclass::DataObjectPointer;
  using DataObjectPointerArraySizeType = Superclass::DataObjectPointerArraySizeType;

  /** The picture, grey values of any range; none leaves the question open. */
  itkSetInputMacro(Radiograph, ImageType);
  itkGetInputMacro(Radiograph, ImageType);
  /** What was drawn of each jaw, continuous pixel indices of the picture; either may be missing. */
  itkSetInputMacro(UpperContour, DentalContour);
  itkGetInputMacro(UpperContour, DentalContour);
  itkSetInputMacro(LowerContour, DentalContour);
  itkGetInputMacro(LowerContour, DentalContour);
  /** Its pixel spacing, mm. */
  itkSetInputMacro(Geometry, CephalometricGeometry);
  itkGetInputMacro(Geometry, CephalometricGeometry);

  /** What was found, as a data object downstream; empty where nothing is doubted. */
  DecoratedFindingsType *
  GetFindingsOutput();
  /** Valid after Update(). */
  const FindingsType &
  GetFindings();

  /** What the data could not tell, as sentences; valid after Update(). */
  const std::vector<std::string> &
  GetNotCheckable() const
  {
    return m_NotCheckable;
  }

  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  PictureCheckFilter();
  ~PictureCheckFilter() override = default;
  void
  VerifyPreconditions() ITKv5_CONST override;
  /** What was drawn is in pixel indices of the radiograph, whatever the spacing that its file states. */
  void
  VerifyInputInformation() ITKv5_CONST override
  {}
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  std::vector<std::string> m_NotCheckable;
};
} // namespace itk

#endif

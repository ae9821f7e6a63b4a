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
#ifndef itkDentalContourFileWriter_h
#define itkDentalContourFileWriter_h

#include "AnnotationExport.h"
#include "itkDentalContour.h"

#include "itkProcessObject.h"
#include "itkSize.h"

#include <string>

namespace itk
{
/** \class DentalContourFileWriter
 * \brief Writes the contours of one or both jaws as contours.json (Documentation/FileFormats.md).
 *
 * Coordinates are written with the fewest digits that read back to the same bits. Codes are "UR1"-style unless another
 * numbering is chosen, which is then stated in the file. The file appears whole or not at all; what cannot be written
 * throws a DentalInputError that names the file.
 *
 * \ingroup Annotation
 */
class Annotation_EXPORT DentalContourFileWriter : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(DentalContourFileWriter);

  using Self = DentalContourFileWriter;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(DentalContourFileWriter, ProcessObject);

  using ImageSizeType = Size<2>;
  using NumberingEnum = ToothCode::NumberingEnum;
  /** The file to write. Must be set. */
  itkSetStringMacro(FileName);
  itkGetStringMacro(FileName);

  /** At least one of the two. */
  itkSetInputMacro(Upper, DentalContour);
  itkGetInputMacro(Upper, DentalContour);
  itkSetInputMacro(Lower, DentalContour);
  itkGetInputMacro(Lower, DentalContour);

  /** Width and height of the radiograph; required. */
  itkSetMacro(ImageSize, ImageSizeType);
  itkGetConstReferenceMacro(ImageSize, ImageSizeType);

  /** Default Quadrant. */
  itkSetEnumMacro(Numbering, NumberingEnum);
  itkGetEnumMacro(Numbering, NumberingEnum);

  /** Brings the inputs up to date and writes. */
  void
  Write();
  void
  Update() override
  {
    this->Write();
  }

protected:
  DentalContourFileWriter();
  ~DentalContourFileWriter() override = default;

  void
  VerifyPreconditions() ITKv5_CONST override;
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  std::string   m_FileName;
  ImageSizeType m_ImageSize;
  NumberingEnum m_Numbering{ NumberingEnum::Quadrant };
};
} // namespace itk

#endif

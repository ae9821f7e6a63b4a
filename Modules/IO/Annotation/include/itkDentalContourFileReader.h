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
#ifndef itkDentalContourFileReader_h
#define itkDentalContourFileReader_h

#include "AnnotationExport.h"
#include "itkAnnotationFileFormat.h"
#include "itkDentalContour.h"

#include "itkFixedArray.h"
#include "itkProcessObject.h"
#include "itkSize.h"

#include <string>
#include <vector>

namespace itk
{
/** \class DentalContourFileReader
 * \brief Reads the tracing on a radiograph: one itk::DentalContour a jaw, in continuous pixel indices.
 *
 * Reads contours.json (Documentation/FileFormats.md) and, as far as they hold curves, Slicer markups, labelme files and
 * CSV with a line `label,x,y` a point. In these a curve's label is its tooth code, which also tells its jaw, or "upper"
 * or "lower".
 *
 * Strict: a code that the numbering has not, a code of the other jaw, a point that is not two finite numbers, a weight
 * outside [0, 1], an image size that contradicts SetImageSize(), no image size at all, or more than 10 % of the points
 * outside the image throw a DentalInputError that names the field, e.g. `contours.upper[3].code`. Unknown fields, fewer
 * points outside, a tooth that occurs twice in a jaw, and a jaw with 1 to 4 points are warnings: see GetWarnings().
 *
 * A jaw without contour is an empty output. The library judges no jaw: one with fewer than
 * MinimumNumberOfPoints points is the caller's to refuse.
 *
 * \ingroup Annotation
 */
class Annotation_EXPORT DentalContourFileReader : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(DentalContourFileReader);

  using Self = DentalContourFileReader;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(DentalContourFileReader, ProcessObject);

  using FileFormatEnum = AnnotationFileFormatEnum;
  using PixelOriginEnum = AnnotationPixelOriginEnum;
  using NumberingEnum = ToothCode::NumberingEnum;
  using ImageSizeType = Size<2>;
  using VectorType = FixedArray<double, 2>;

  /** Points that a jaw needs to be registered. */
  static constexpr SizeValueType MinimumNumberOfPoints = 5;
  /** More than this part of the points outside the image is an error. */
  static constexpr double MaximumFractionOutside = 0.1;

  itkSetStringMacro(FileName);
  itkGetStringMacro(FileName);

  /** Default Automatic. */
  itkSetEnumMacro(FileFormat, FileFormatEnum);
  itkGetEnumMacro(FileFormat, FileFormatEnum);

  /** The numbering that the case states. Default Quadrant: "UR1" and two-digit codes as FDI. The file's own "numbering"
   * is used where it is there; universal against FDI is an error. */
  itkSetEnumMacro(Numbering, NumberingEnum);
  itkGetEnumMacro(Numbering, NumberingEnum);

  /** Width and height of the radiograph, where there is one. Default (0, 0): not known, the file has to say it. */
  itkSetMacro(ImageSize, ImageSizeType);
  itkGetConstReferenceMacro(ImageSize, ImageSizeType);

  /** Where a foreign file's (0, 0) is; contours.json always counts from the centre. Default FormatDefault. */
  itkSetEnumMacro(PixelOrigin, PixelOriginEnum);
  itkGetEnumMacro(PixelOrigin, PixelOriginEnum);

  /** Spacing and origin (mm) that the radiograph had in Slicer: markups are in mm. Default (1, 1) and (0, 0), as Slicer
   * loads a picture without spacing. */
  itkSetMacro(MarkupsSpacing, VectorType);
  itkGetConstReferenceMacro(MarkupsSpacing, VectorType);
  itkSetMacro(MarkupsOrigin, VectorType);
  itkGetConstReferenceMacro(MarkupsOrigin, VectorType);

  /** The contour of a jaw; empty where the jaw is not traced. */
  DentalContour *
  GetOutput(ToothCode::JawEnum jaw);
  const DentalContour *
  GetOutput(ToothCode::JawEnum jaw) const;
  DentalContour *
  GetUpperOutput()
  {
    return this->GetOutput(ToothCode::JawEnum::Upper);
  }
  DentalContour *
  GetLowerOutput()
  {
    return this->GetOutput(ToothCode::JawEnum::Lower);
  }

  /** \name After Update()
   * @{ */
  /** Of the radiograph, by SetImageSize() or by the file. */
  itkGetConstReferenceMacro(ReadImageSize, ImageSizeType);
  /** What the file turned out to be. */
  itkGetEnumMacro(ReadFileFormat, FileFormatEnum);
  /** Under which the codes were read. */
  itkGetEnumMacro(ReadNumbering, NumberingEnum);
  /** Of both jaws. A pixel reaches half a pixel to each side of its index. */
  itkGetConstMacro(NumberOfPointsOutside, SizeValueType);
  /** Each "file: field: what". */
  const std::vector<std::string> &
  GetWarnings() const
  {
    return m_Warnings;
  }
  /** @} */

protected:
  DentalContourFileReader();
  ~DentalContourFileReader() override = default;

  using Superclass::MakeOutput;
  DataObject::Pointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

  void
  VerifyPreconditions() ITKv5_CONST override;
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  std::string     m_FileName;
  FileFormatEnum  m_FileFormat{ FileFormatEnum::Automatic };
  NumberingEnum   m_Numbering{ NumberingEnum::Quadrant };
  ImageSizeType   m_ImageSize;
  PixelOriginEnum m_PixelOrigin{ PixelOriginEnum::FormatDefault };
  VectorType      m_MarkupsSpacing;
  VectorType      m_MarkupsOrigin;

  ImageSizeType            m_ReadImageSize;
  FileFormatEnum           m_ReadFileFormat{ FileFormatEnum::Automatic };
  NumberingEnum            m_ReadNumbering{ NumberingEnum::Quadrant };
  SizeValueType            m_NumberOfPointsOutside{ 0 };
  std::vector<std::string> m_Warnings;
};
} // namespace itk

#endif

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
#include "itkAnnotationFileReaderBase.h"
#include "itkDentalContour.h"

#include "itkSize.h"

#include <string>
#include <utility>
#include <vector>

namespace itk
{
/** \class DentalContourFileReader
 * \brief Reads the tracing on a radiograph: one itk::DentalContour a jaw, in continuous pixel indices.
 *
 * Reads contours.json (Documentation/FileFormats.md) and, as far as they hold curves, Slicer markups, the files of
 * labelme, CVAT, COCO, VIA, Label Studio and Supervisely, CSV with a line `label,x,y` a point, and label maps of FDI
 * numbers. In these a curve's label is its tooth code, which also tells its jaw, or a jaw ("upper", "mandible").
 * SetClassFiles() takes files of one tooth or jaw each instead. Labels are read as ToothCode::FromString() does;
 * curves that are neither tooth nor jaw are left out with a warning that names them, and a file of which nothing is a
 * tooth is an error.
 *
 * A line of known length that was drawn along a ruler ("Calibration_30mm") is no contour: see GetCalibrations().
 *
 * Strict: a code that the numbering has not, a code of the other jaw, a point that is not two finite numbers, a weight
 * outside [0, 1], an image size that contradicts SetImageSize(), no image size at all, or more than 10 % of the points
 * outside the image throw a DentalInputError that names the field, e.g. `contours.upper[3].code`. Unknown fields, fewer
 * points outside, a tooth that occurs twice in a jaw, and a jaw with 1 to 4 points are warnings: see GetWarnings().
 *
 * The file's own "numbering" goes before the one that the case states by SetNumbering(); universal against FDI is an
 * error.
 *
 * A jaw without contour is an empty output. The library judges no jaw: one with fewer than
 * MinimumNumberOfPoints points is the caller's to refuse.
 *
 * \ingroup Annotation
 */
class Annotation_EXPORT DentalContourFileReader : public AnnotationFileReaderBase
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(DentalContourFileReader);

  using Self = DentalContourFileReader;
  using Superclass = AnnotationFileReaderBase;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(DentalContourFileReader, AnnotationFileReaderBase);

  using ImageSizeType = Size<2>;
  /** A tooth code or jaw, and the picture in which it alone is filled or drawn. */
  using ClassFilesType = std::vector<std::pair<std::string, std::string>>;

  /** A line along a ruler. */
  struct CalibrationType
  {
    std::string label;              /**< As the file calls the line. */
    double      millimetres{ 0.0 }; /**< Length that was marked. */
    /** Between its ends. */
    double pixels{ 0.0 };
  };

  /** Points that a jaw needs to be registered. */
  static constexpr SizeValueType MinimumNumberOfPoints = 5;
  /** More than this part of the points outside the image is an error. */
  static constexpr double MaximumFractionOutside = 0.1;

  /** Width and height of the radiograph, where there is one. Default (0, 0): not known, the file has to say it. */
  itkSetMacro(ImageSize, ImageSizeType);
  itkGetConstReferenceMacro(ImageSize, ImageSizeType);

  /** Also takes back SetClassFiles(): of the two what is said last is read. */
  using Superclass::SetFileName;
  void
  SetFileName(const char * fileName) override;

  /** Files of one tooth or jaw each, in place of one file, whose name is left for messages: masks, drawn lines, or what
   * a program drew, as 3D Slicer saves a curve in a file of its own. Default none. */
  void
  SetClassFiles(const ClassFilesType & files);
  const ClassFilesType &
  GetClassFiles() const
  {
    return m_ClassFiles;
  }

  /** The side of codes that do not say one (U1, L6). Default off: right, as good as left where the middle of both sides
   * was drawn. */
  itkSetMacro(SidelessCodesAreLeft, bool);
  itkGetConstMacro(SidelessCodesAreLeft, bool);
  itkBooleanMacro(SidelessCodesAreLeft);

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
  /** Under which the codes were read. */
  itkGetEnumMacro(ReadNumbering, NumberingEnum);
  /** Of both jaws. A pixel reaches half a pixel to each side of its index. */
  itkGetConstMacro(NumberOfPointsOutside, SizeValueType);
  /** How many contours have a code without a side. */
  itkGetConstMacro(NumberOfSidelessCodes, SizeValueType);
  /** What was drawn along rulers. */
  const std::vector<CalibrationType> &
  GetCalibrations() const
  {
    return m_Calibrations;
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
  ImageSizeType m_ImageSize;
  ImageSizeType m_ReadImageSize;
  NumberingEnum m_ReadNumbering{ NumberingEnum::Quadrant };
  SizeValueType m_NumberOfPointsOutside{ 0 };
  SizeValueType m_NumberOfSidelessCodes{ 0 };
  bool          m_SidelessCodesAreLeft{ false };

  ClassFilesType               m_ClassFiles;
  std::vector<CalibrationType> m_Calibrations;
};
} // namespace itk

#endif

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
#ifndef itkAnnotationFileReaderBase_h
#define itkAnnotationFileReaderBase_h

#include "AnnotationExport.h"
#include "itkAnnotationFileFormat.h"
#include "itkToothCode.h"

#include "itkFixedArray.h"
#include "itkProcessObject.h"

#include <string>
#include <vector>

namespace itk
{
/** \class AnnotationFileReaderBase
 * \brief What readers of tracings and of landmarks share: the file, its format and numbering, where its pixels are
 * counted from, and what was odd about it.
 *
 * \ingroup Annotation
 */
class Annotation_EXPORT AnnotationFileReaderBase : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(AnnotationFileReaderBase);

  using Self = AnnotationFileReaderBase;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkTypeMacro(AnnotationFileReaderBase, ProcessObject);

  using FileFormatEnum = AnnotationFileFormatEnum;
  using PixelOriginEnum = AnnotationPixelOriginEnum;
  using NumberingEnum = ToothCode::NumberingEnum;
  using VectorType = FixedArray<double, 2>;
  /** The file to read. Must be set. */
  itkSetStringMacro(FileName);
  itkGetStringMacro(FileName);

  /** Default Automatic. */
  itkSetEnumMacro(FileFormat, FileFormatEnum);
  itkGetEnumMacro(FileFormat, FileFormatEnum);

  /** How digits in a code or name are read where the file does not say it. Default Quadrant: "UR1" and two-digit codes
   * as FDI. */
  itkSetEnumMacro(Numbering, NumberingEnum);
  itkGetEnumMacro(Numbering, NumberingEnum);

  /** Where the (0, 0) of a foreign 2-D file is; our own count from the centre of the first pixel. Default
   * FormatDefault.
   */
  itkSetEnumMacro(PixelOrigin, PixelOriginEnum);
  itkGetEnumMacro(PixelOrigin, PixelOriginEnum);

  /** The radiograph's file, of which only the name counts: COCO, CVAT, VIA and Label Studio put the annotations of many
   * pictures into one file. Not needed where there is one picture in it. */
  itkSetStringMacro(ImageFileName);
  itkGetStringMacro(ImageFileName);

  /** 2-D only: spacing and origin (mm) that the radiograph had in Slicer, whose markups are in mm. Default (1, 1) and
   * (0, 0), as Slicer loads a picture without spacing. */
  itkSetMacro(MarkupsSpacing, VectorType);
  itkGetConstReferenceMacro(MarkupsSpacing, VectorType);
  itkSetMacro(MarkupsOrigin, VectorType);
  itkGetConstReferenceMacro(MarkupsOrigin, VectorType);

  /** After Update(): what the file turned out to be. */
  itkGetEnumMacro(ReadFileFormat, FileFormatEnum);
  /** After Update(): each "file: field: what". */
  const std::vector<std::string> &
  GetWarnings() const
  {
    return m_Warnings;
  }

protected:
  AnnotationFileReaderBase();
  ~AnnotationFileReaderBase() override = default;

  void
  VerifyPreconditions() ITKv5_CONST override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

  /** Takes over what the file turned out to be and what was odd so far. */
  void
  StartReading(FileFormatEnum readFormat, std::vector<std::string> warnings);
  /** For GetWarnings(): the field and what is odd about it. */
  void
  Warn(const std::string & field, const std::string & text);

  /** A 2-D coordinate as the file has it to a continuous pixel index, once its format is known. */
  double
  ToPixelIndex(double coordinate, unsigned int axis) const;

private:
  std::string              m_FileName;
  std::string              m_ImageFileName;
  FileFormatEnum           m_FileFormat{ FileFormatEnum::Automatic };
  NumberingEnum            m_Numbering{ NumberingEnum::Quadrant };
  PixelOriginEnum          m_PixelOrigin{ PixelOriginEnum::FormatDefault };
  VectorType               m_MarkupsSpacing;
  VectorType               m_MarkupsOrigin;
  FileFormatEnum           m_ReadFileFormat{ FileFormatEnum::Automatic };
  std::vector<std::string> m_Warnings;
};
} // namespace itk

#endif

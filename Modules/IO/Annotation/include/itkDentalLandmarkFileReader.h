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
#ifndef itkDentalLandmarkFileReader_h
#define itkDentalLandmarkFileReader_h

#include "AnnotationExport.h"
#include "itkAnnotationFileFormat.h"
#include "itkDentalLandmarkSet.h"

#include "itkFixedArray.h"
#include "itkProcessObject.h"

#include <string>
#include <vector>

namespace itk
{
/** \class DentalLandmarkFileReader
 * \brief Reads named landmarks: 3-D in the mesh file's unit and frame, 2-D in continuous pixel indices.
 *
 * Reads landmarks3d.json and landmarks2d.json (Documentation/FileFormats.md), Slicer's fiducials, the point shapes of
 * labelme (2-D), and CSV. 3-D positions are given out as they stand; Slicer's RAS is turned into LPS, the frame in
 * which Slicer loads a mesh.
 *
 * A point that is not the right number of finite numbers, and a landmark that is there twice, throw a DentalInputError
 * that names the field, e.g. `UR6_MB[2]`. What has no landmark's name is left out with a warning: see GetWarnings().
 *
 * Names are kept as they are written, but for universal numbers: those are turned into names such as "UR6_MB",
 * because "11_tip" elsewhere is FDI.
 *
 * \ingroup Annotation
 */
template <unsigned int VDimension>
class DentalLandmarkFileReader : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(DentalLandmarkFileReader);

  using Self = DentalLandmarkFileReader;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(DentalLandmarkFileReader, ProcessObject);

  using FileFormatEnum = AnnotationFileFormatEnum;
  using PixelOriginEnum = AnnotationPixelOriginEnum;
  using NumberingEnum = ToothCode::NumberingEnum;
  using LandmarkSetType = DentalLandmarkSet<VDimension>;
  using VectorType = FixedArray<double, 2>;

  itkSetStringMacro(FileName);
  itkGetStringMacro(FileName);

  /** Default Automatic. */
  itkSetEnumMacro(FileFormat, FileFormatEnum);
  itkGetEnumMacro(FileFormat, FileFormatEnum);

  /** How digits in a name are read. Default Quadrant: as FDI. */
  itkSetEnumMacro(Numbering, NumberingEnum);
  itkGetEnumMacro(Numbering, NumberingEnum);

  /** Where the (0, 0) of a foreign 2-D file is. Default FormatDefault. */
  itkSetEnumMacro(PixelOrigin, PixelOriginEnum);
  itkGetEnumMacro(PixelOrigin, PixelOriginEnum);

  /** 2-D only: spacing and origin (mm) that the radiograph had in Slicer. Default (1, 1) and (0, 0). */
  itkSetMacro(MarkupsSpacing, VectorType);
  itkGetConstReferenceMacro(MarkupsSpacing, VectorType);
  itkSetMacro(MarkupsOrigin, VectorType);
  itkGetConstReferenceMacro(MarkupsOrigin, VectorType);

  LandmarkSetType *
  GetOutput();
  const LandmarkSetType *
  GetOutput() const;

  /** After Update(): what the file turned out to be. */
  itkGetEnumMacro(ReadFileFormat, FileFormatEnum);
  /** After Update(): each "file: field: what". */
  const std::vector<std::string> &
  GetWarnings() const
  {
    return m_Warnings;
  }

protected:
  DentalLandmarkFileReader();
  ~DentalLandmarkFileReader() override = default;

  using Superclass::MakeOutput;
  DataObject::Pointer
  MakeOutput(ProcessObject::DataObjectPointerArraySizeType index) override;

  void
  VerifyPreconditions() ITKv5_CONST override;
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  std::string              m_FileName;
  FileFormatEnum           m_FileFormat{ FileFormatEnum::Automatic };
  NumberingEnum            m_Numbering{ NumberingEnum::Quadrant };
  PixelOriginEnum          m_PixelOrigin{ PixelOriginEnum::FormatDefault };
  VectorType               m_MarkupsSpacing;
  VectorType               m_MarkupsOrigin;
  FileFormatEnum           m_ReadFileFormat{ FileFormatEnum::Automatic };
  std::vector<std::string> m_Warnings;
};

extern template class DentalLandmarkFileReader<2>;
extern template class DentalLandmarkFileReader<3>;
} // namespace itk

#endif

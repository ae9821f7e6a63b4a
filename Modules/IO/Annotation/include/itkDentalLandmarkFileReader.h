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
#include "itkAnnotationFileReaderBase.h"
#include "itkDentalLandmarkSet.h"

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
class DentalLandmarkFileReader : public AnnotationFileReaderBase
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(DentalLandmarkFileReader);

  using Self = DentalLandmarkFileReader;
  using Superclass = AnnotationFileReaderBase;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(DentalLandmarkFileReader, AnnotationFileReaderBase);

  using LandmarkSetType = DentalLandmarkSet<VDimension>;
  /** The landmarks, in the file's order. */
  LandmarkSetType *
  GetOutput();
  const LandmarkSetType *
  GetOutput() const;

protected:
  DentalLandmarkFileReader();
  ~DentalLandmarkFileReader() override = default;

  using Superclass::MakeOutput;
  DataObject::Pointer
  MakeOutput(ProcessObject::DataObjectPointerArraySizeType index) override;

  void
  GenerateData() override;
};

extern template class DentalLandmarkFileReader<2>;
extern template class DentalLandmarkFileReader<3>;
} // namespace itk

#endif

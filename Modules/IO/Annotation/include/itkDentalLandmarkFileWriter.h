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
#ifndef itkDentalLandmarkFileWriter_h
#define itkDentalLandmarkFileWriter_h

#include "AnnotationExport.h"
#include "itkDentalLandmarkSet.h"

#include "itkProcessObject.h"

#include <string>

namespace itk
{
/** \class DentalLandmarkFileWriter
 * \brief Writes landmarks as landmarks3d.json or landmarks2d.json (Documentation/FileFormats.md), names as they are.
 *
 * Coordinates are written with the fewest digits that read back to the same bits. The file appears whole or not at all;
 * what cannot be written throws a DentalInputError that names the file.
 *
 * \ingroup Annotation
 */
template <unsigned int VDimension>
class DentalLandmarkFileWriter : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(DentalLandmarkFileWriter);

  using Self = DentalLandmarkFileWriter;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;
  using LandmarkSetType = DentalLandmarkSet<VDimension>;

  itkNewMacro(Self);
  itkTypeMacro(DentalLandmarkFileWriter, ProcessObject);
  /** The file to write. Must be set. */
  itkSetStringMacro(FileName);
  itkGetStringMacro(FileName);
  /** What is written. Must be set. */
  using Superclass::SetInput;
  void
  SetInput(const LandmarkSetType * landmarks);
  const LandmarkSetType *
  GetInput() const;

  /** Brings the input up to date and writes. */
  void
  Write();
  void
  Update() override
  {
    this->Write();
  }

protected:
  DentalLandmarkFileWriter() = default;
  ~DentalLandmarkFileWriter() override = default;

  void
  VerifyPreconditions() ITKv5_CONST override;
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  std::string m_FileName;
};

extern template class DentalLandmarkFileWriter<2>;
extern template class DentalLandmarkFileWriter<3>;
} // namespace itk

#endif

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
#ifndef itkCephalometricLandmarkFileReader_h
#define itkCephalometricLandmarkFileReader_h

#include "AnnotationExport.h"
#include "itkAnnotationFileReaderBase.h"
#include "itkCephalometricLandmarkSet.h"
#include "itkJsonDocument.h"

#include <optional>

namespace itk
{
/** \class CephalometricLandmarkFileReader
 * \brief Reads the dental landmarks of a cephalometric analysis, continuous pixel indices, to register with.
 *
 * Reads what programs, data sets and detectors write (Documentation/FileFormats.md has the table): the toolkit's own
 * JSON, Aariz and CEPHA29, detectors with a confidence, the challenges CL-Detection 2023 and ISBI 2015, labelme's
 * points, Slicer's fiducials, CSV. Names are CephalometricLandmarkSet's; one with a tooth's number ("16_MB") is read by
 * the numbering.
 *
 * What is no dental landmark (Sella, Nasion) is left out, and one warning lists it. No dental landmark at all, a dental
 * one without a place, and two names of one point throw a DentalInputError that names the field.
 *
 * \ingroup Annotation
 */
class Annotation_EXPORT CephalometricLandmarkFileReader : public AnnotationFileReaderBase
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(CephalometricLandmarkFileReader);

  using Self = CephalometricLandmarkFileReader;
  using Superclass = AnnotationFileReaderBase;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(CephalometricLandmarkFileReader, AnnotationFileReaderBase);

  /** Reads this object of a document instead of a file: a case file may hold its landmarks itself. Sets FileName to the
   * document's; the document's own warnings are not among GetWarnings(). */
  void
  SetJsonNode(const JsonNode & node);
  /** The landmarks, as continuous pixel indices. */
  CephalometricLandmarkSet *
  GetOutput();
  const CephalometricLandmarkSet *
  GetOutput() const;

protected:
  CephalometricLandmarkFileReader();
  ~CephalometricLandmarkFileReader() override = default;

  using Superclass::MakeOutput;
  DataObject::Pointer
  MakeOutput(ProcessObject::DataObjectPointerArraySizeType index) override;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  /** A name of a tooth's number, or of another spelling of a tooth, to one of its code; others stay as they are. */
  std::string
  NameFromNumber(const std::string & name) const;

  std::optional<JsonNode> m_JsonNode;
};
} // namespace itk

#endif

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
#ifndef itkDentalPhantomCaseWriter_h
#define itkDentalPhantomCaseWriter_h

#include "DentalPhantomExport.h"
#include "itkDentalPhantomCaseSource.h"

#include "itkObject.h"
#include "itkObjectFactory.h"

#include <string>

namespace itk
{
/** \class DentalPhantomCaseWriter
 * \brief Writes a phantom case as a folder that `dentalscr register` reads.
 *
 * case.json, contours.json, landmarks3d.json, landmarks2d.json, upper and lower mesh, ceph.png, and truth.json with the
 * true 3x4 matrices, which no registration reads. A standard tracing is outlines.json (whole teeth) and
 * cephalometric.json (landmarks), with case-outlines.json and case-landmarks.json for either alone beside case.json; a
 * frontal view is frontal.png, frontal.json and frontal-contours.json. The files are written beside the folder and
 * moved there when all are complete, case.json last; files of an earlier case are replaced, others left alone. Throws a
 * DentalInputError that names what cannot be written; nothing is left then.
 *
 * \ingroup DentalPhantom
 */
class DentalPhantom_EXPORT DentalPhantomCaseWriter : public Object
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(DentalPhantomCaseWriter);

  using Self = DentalPhantomCaseWriter;
  using Superclass = Object;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(DentalPhantomCaseWriter, Object);
  /** The case to write. Must be set. */
  itkSetObjectMacro(CaseSource, DentalPhantomCaseSource);
  itkGetModifiableObjectMacro(CaseSource, DentalPhantomCaseSource);

  /** The case's folder; its parent must exist. */
  itkSetStringMacro(DirectoryName);
  itkGetStringMacro(DirectoryName);

  /** "stl" (default, binary), "ply", "obj" or "off". */
  itkSetStringMacro(MeshExtension);
  itkGetStringMacro(MeshExtension);

  /** Width of one of the four views of the jaws in preview.png, px; 0 (default): no such picture. */
  itkSetClampMacro(PreviewSize, unsigned int, 0u, 2000u);
  itkGetConstMacro(PreviewSize, unsigned int);

  /** Updates the case and writes it. */
  void
  Write();
  void
  Update()
  {
    this->Write();
  }

protected:
  DentalPhantomCaseWriter() = default;
  ~DentalPhantomCaseWriter() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  void
  WriteFiles(const std::string & directory);

  DentalPhantomCaseSource::Pointer m_CaseSource;
  std::string                      m_DirectoryName;
  std::string                      m_MeshExtension{ "stl" };
  unsigned int                     m_PreviewSize{ 0 };
};
} // namespace itk

#endif

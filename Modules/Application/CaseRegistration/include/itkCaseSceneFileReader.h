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
#ifndef itkCaseSceneFileReader_h
#define itkCaseSceneFileReader_h

#include "CaseRegistrationExport.h"
#include "itkCaseResult.h"
#include "itkRegistrationScene.h"

#include "itkProcessObject.h"

#include <string>
#include <vector>

namespace itk
{
/** \class CaseSceneFileReader
 * \brief The scene of a result that was written earlier, of any preset.
 *
 * Places and projections are those of result.json. Scans, radiograph and tracing are read again from the files that it
 * names, as the case file names them; with exclusions of that run. Of a file that has changed since, what was read of
 * it is left out and a warning says so; where the case cannot be read, all of that is. In place of such scans come
 * those of the result's folder (upper_ceph.stl). A relative name of the case file is looked for from the current
 * directory, then from the result's folder and from the folder around it; CaseFileName says where the case is now.
 *
 * Errors (DentalInputError): what is no result of this version, and a result without a registered jaw or without a scan
 * that could be shown.
 *
 * \test itkCaseSceneGTest.cxx
 * \ingroup CaseRegistration
 */
class CaseRegistration_EXPORT CaseSceneFileReader : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(CaseSceneFileReader);

  using Self = CaseSceneFileReader;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(CaseSceneFileReader, ProcessObject);

  using Superclass::MakeOutput;
  using DataObjectPointer = Superclass::DataObjectPointer;
  using DataObjectPointerArraySizeType = Superclass::DataObjectPointerArraySizeType;

  /** result.json, or the folder that it is in. */
  itkSetStringMacro(FileName);
  itkGetStringMacro(FileName);

  /** The case file, where it is no longer where the result says. Default "": as the result says. */
  itkSetStringMacro(CaseFileName);
  itkGetStringMacro(CaseFileName);
  /** The scene: scans, frames, radiographs. */
  RegistrationScene *
  GetOutput();

  /** What is not shown, and why, a sentence each; valid after Update(). */
  const std::vector<std::string> &
  GetWarnings() const
  {
    return m_Warnings;
  }

  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  CaseSceneFileReader();
  ~CaseSceneFileReader() override = default;
  void
  VerifyPreconditions() ITKv5_CONST override;
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  std::string              m_FileName;
  std::string              m_CaseFileName;
  std::vector<std::string> m_Warnings;
};
} // namespace itk

#endif

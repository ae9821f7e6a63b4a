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
#ifndef itkCaseResultFileReader_h
#define itkCaseResultFileReader_h

#include "CaseRegistrationExport.h"
#include "itkPoseSolution.h"

#include "itkProcessObject.h"

#include <array>
#include <string>

namespace itk
{
/** \class CaseResultFileReader
 * \brief Reads a result.json back as a PoseSolution, for the filters downstream of a registration.
 *
 * What comes back is what a place on the radiograph and its uncertainty are made of: geometry, dental frames, poses,
 * covariances and projections of the jaws that were registered (LandmarkProjectionFilter, ProjectionSimilarityFilter).
 * Tracing, candidates and fit are not in it: RegistrationVerdictFilter has nothing to judge here, the verdict stands in
 * the file.
 *
 * Errors (DentalInputError): what cannot be read, a schema that is not this version's, and a result of a preset without
 * a pose, or of a version that did not write it.
 *
 * \ingroup CaseRegistration
 */
class CaseRegistration_EXPORT CaseResultFileReader : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(CaseResultFileReader);

  using Self = CaseResultFileReader;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(CaseResultFileReader, ProcessObject);

  using Superclass::MakeOutput;
  using DataObjectPointer = Superclass::DataObjectPointer;
  using DataObjectPointerArraySizeType = Superclass::DataObjectPointerArraySizeType;

  /** result.json, or the folder that it is in. */
  itkSetStringMacro(FileName);
  itkGetStringMacro(FileName);

  /** The text of a result that lies in no file; messages call it by the file name. Empty, the default: the file is
   * read. */
  itkSetStringMacro(Text);
  itkGetStringMacro(Text);

  /** A further view, by its name, whose poses and projections are read instead of those of the first radiograph; ""
   * (default) or "lateral": the first one. */
  itkSetStringMacro(ViewName);
  itkGetStringMacro(ViewName);
  /** What the registration had found. */
  PoseSolution *
  GetOutput();

  /** "ok", "suspect" or "failed"; "" where the jaw is not in the result. On a further view the worse of the jaw's and
   * the view's. Valid after Update(). */
  const std::string &
  GetStatus(ToothCode::JawEnum jaw) const
  {
    return m_Status[jaw == ToothCode::JawEnum::Upper ? 0 : 1];
  }

  /** mm in one unit of the files of the scans; valid after Update(). */
  itkGetConstMacro(MillimetresPerUnit, double);

  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  CaseResultFileReader();
  ~CaseResultFileReader() override = default;
  void
  VerifyPreconditions() ITKv5_CONST override;
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  std::string                m_FileName;
  std::string                m_Text;
  std::string                m_ViewName;
  std::array<std::string, 2> m_Status;
  double                     m_MillimetresPerUnit{ 1.0 };
};
} // namespace itk

#endif

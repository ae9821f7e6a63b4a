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
#ifndef itkDentalCaseReader_h
#define itkDentalCaseReader_h

#include "itkDentalCaseObject.h"

#include "itkProcessObject.h"

#include <optional>
#include <string>

namespace itk
{
/** \class DentalCaseReader
 * \brief Reads a case: its file, or a description made by a program, and every file that it names but the 2-D
 * landmarks.
 *
 * Output: a DentalCaseObject for CaseRegistration. Errors: DentalInputError, which names file, field and remedy.
 *
 * \ingroup CaseRegistration
 */
class CaseRegistration_EXPORT DentalCaseReader : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(DentalCaseReader);

  using Self = DentalCaseReader;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(DentalCaseReader, ProcessObject);

  using OutputType = DentalCaseObject;
  using Superclass::MakeOutput;
  using DataObjectPointer = Superclass::DataObjectPointer;
  using DataObjectPointerArraySizeType = Superclass::DataObjectPointerArraySizeType;

  /** The case file. */
  itkSetStringMacro(FileName);
  itkGetStringMacro(FileName);

  /** What a case file would say, instead of one. */
  void
  SetDescription(const DentalCase & description);
  void
  ClearDescription();
  /** The case with everything that it names. */
  OutputType *
  GetOutput();

  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  DentalCaseReader();
  ~DentalCaseReader() override = default;
  void
  VerifyPreconditions() ITKv5_CONST override;
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  std::string               m_FileName;
  std::optional<DentalCase> m_Description;
};
} // namespace itk

#endif

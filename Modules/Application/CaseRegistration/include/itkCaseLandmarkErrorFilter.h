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
#ifndef itkCaseLandmarkErrorFilter_h
#define itkCaseLandmarkErrorFilter_h

#include "itkCaseResultObject.h"

#include "itkProcessObject.h"

namespace itk
{
/** \class CaseLandmarkErrorFilter
 * \brief Measures a case's result against the landmarks that were marked on its radiograph.
 *
 * Input: what CaseRegistration gives; output: the same with the distance of each predicted landmark from the marked one
 * and their statistics, for CaseResultFolderWriter. The marks are read here, from the file that the case names, and not
 * with the case: what is downstream of the registration cannot help it. A case that names none goes through unchanged.
 *
 * Errors: DentalInputError of a file that cannot be read.
 *
 * \ingroup CaseRegistration
 *
 * \test itkCasePipelineGTest.cxx
 */
class CaseRegistration_EXPORT CaseLandmarkErrorFilter : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(CaseLandmarkErrorFilter);

  using Self = CaseLandmarkErrorFilter;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(CaseLandmarkErrorFilter, ProcessObject);

  using InputType = CaseResultObject;
  using OutputType = CaseResultObject;
  using Superclass::MakeOutput;
  using DataObjectPointer = Superclass::DataObjectPointer;
  using DataObjectPointerArraySizeType = Superclass::DataObjectPointerArraySizeType;

  using Superclass::SetInput;
  /** The result of a CaseRegistration; it stays as it is. */
  void
  SetInput(const InputType * input);
  const InputType *
  GetInput() const;

  /** The same result with errors, where the case names marked landmarks. */
  OutputType *
  GetOutput();

  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  CaseLandmarkErrorFilter();
  ~CaseLandmarkErrorFilter() override = default;
  void
  VerifyPreconditions() ITKv5_CONST override;
  void
  GenerateData() override;
};
} // namespace itk

#endif

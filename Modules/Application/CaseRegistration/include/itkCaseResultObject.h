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
#ifndef itkCaseResultObject_h
#define itkCaseResultObject_h

#include "CaseRegistrationExport.h"
#include "itkCaseResult.h"

#include "itkDataObject.h"

namespace itk
{
/** \class CaseResultObject
 * \brief The result of a case as a data object of the pipeline: output of CaseRegistration, input of CaseResultWriter.
 * \ingroup CaseRegistration
 */
class CaseRegistration_EXPORT CaseResultObject : public DataObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(CaseResultObject);

  using Self = CaseResultObject;
  using Superclass = DataObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(CaseResultObject, DataObject);

  /** Takes a result; what is made of the object before is made again. */
  void
  Set(const CaseResult & result);
  const CaseResult &
  Get() const
  {
    return m_Result;
  }

  void
  Initialize() override;
  void
  Graft(const DataObject * data) override;

protected:
  CaseResultObject() = default;
  ~CaseResultObject() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  CaseResult m_Result;
};
} // namespace itk

#endif

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
#ifndef itkDentalCaseObject_h
#define itkDentalCaseObject_h

#include "CaseRegistrationExport.h"
#include "itkDentalCaseData.h"

#include "itkDataObject.h"

#include <memory>

namespace itk
{
/** \class DentalCaseObject
 * \brief A case as a data object of the pipeline: output of DentalCaseReader, input of CaseRegistration.
 *
 * The data are shared and never changed: who wants another case sets another one.
 *
 * \ingroup CaseRegistration
 */
class CaseRegistration_EXPORT DentalCaseObject : public DataObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(DentalCaseObject);

  using Self = DentalCaseObject;
  using Superclass = DataObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(DentalCaseObject, DataObject);

  using DataPointer = std::shared_ptr<const DentalCaseData>;

  /** Takes a case, which nobody changes any more. */
  void
  Set(DataPointer data);
  /** Null where there is none. */
  const DataPointer &
  Get() const
  {
    return m_Data;
  }

  void
  Initialize() override;
  void
  Graft(const DataObject * data) override;

protected:
  DentalCaseObject() = default;
  ~DentalCaseObject() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  DataPointer m_Data;
};
} // namespace itk

#endif

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
#ifndef itkCaseViews_h
#define itkCaseViews_h

#include "itkCasePoseDescription.h"
#include "itkCasePoseRegistration.h"

#include "itkCephalogramView.h"
#include "itkRegistrationVerdictFilter.h"

#include <memory>
#include <vector>

namespace itk
{
/** Not installed. The case with another radiograph: what was drawn on it, and its geometry. */
std::shared_ptr<DentalCaseData>
MakeCaseOfView(const DentalCaseData & data, const DentalViewData & view);

/** Not installed. The views of a case, for a registration and after it. */
class CaseViews
{
public:
  /** Finds the counterparts of landmarks; what is not used is a warning of the result. */
  CaseViews(const DentalCaseData & data, CaseAxisType * axis, CaseResult & result);

  /** Of those on which something was drawn that can be used. */
  const std::vector<CephalogramView::Pointer> &
  GetViews() const
  {
    return m_Views;
  }
  bool
  HasEvidence(ToothCode::JawEnum jaw) const;

  /** What each shows at the solution. */
  void
  Describe(const PoseSolution &              solution,
           const RegistrationVerdictFilter & verdict,
           const CasePoseSettings &          settings,
           CaseResult &                      result) const;

private:
  const DentalCaseData &                m_Data;
  std::vector<CephalogramView::Pointer> m_Views;
  /** The data of each. */
  std::vector<const DentalViewData *> m_ViewData;
  /** Those of which nothing can be used. */
  std::vector<const DentalViewData *> m_Unused;
};
} // namespace itk

#endif

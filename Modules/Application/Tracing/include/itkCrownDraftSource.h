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
#ifndef itkCrownDraftSource_h
#define itkCrownDraftSource_h

#include "TracingExport.h"
#include "itkCaseResult.h"
#include "itkDentalContour.h"

#include <map>
#include <memory>

namespace itk
{
/** \class CrownDraftSource
 * \brief What a person would draw of the crowns, if the registration were right: drafts to be accepted or mended.
 *
 * Of each jaw and side the outline that the registration itself compares a tracing with, the occlusally and anteriorly
 * facing border of the side's projection (ComputeOpenSilhouette()), cut into teeth: by the scan's labels where there
 * are any, else about its landmarks, else by place along the arch (ToothCrownFilter). What does not depend on a pose is
 * made once, by the constructor; Compute() costs some tens of milliseconds.
 *
 * \ingroup Tracing
 */
class Tracing_EXPORT CrownDraftSource
{
public:
  using DraftsType = std::map<ToothCode::JawEnum, DentalContour::PolylinesType>;

  /** Jaws in which no arch is found, or whose scan there is not, have no drafts. */
  explicit CrownDraftSource(const DentalCaseData & data);
  ~CrownDraftSource();
  CrownDraftSource(const CrownDraftSource &) = delete;
  CrownDraftSource &
  operator=(const CrownDraftSource &) = delete;

  /** Open polylines in continuous pixel indices, a point a millimetre, of the jaws that are registered. */
  DraftsType
  Compute(const CaseResult & result) const;

private:
  class Implementation;
  std::unique_ptr<const Implementation> m_Implementation;
};
} // namespace itk

#endif

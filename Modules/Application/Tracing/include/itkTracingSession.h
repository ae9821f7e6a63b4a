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
#ifndef itkTracingSession_h
#define itkTracingSession_h

#include "TracingExport.h"
#include "itkDentalCaseData.h"

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <string>

namespace itk
{
class CaseRegistration;
class CrownDraftSource;

/** \class TracingSession
 * \brief Registers a case again and again while somebody draws on its radiograph.
 *
 * The scans are read once, and one CaseRegistration keeps what depends on them alone. Each time what is drawn is read
 * by the readers that read it from files, and registered as the verb register does: what a session says is what the
 * saved files give. Calls wait for each other; the session may be used from any thread.
 *
 * \ingroup Tracing
 */
class Tracing_EXPORT TracingSession
{
public:
  /** `data`: a case without drawings, as LoadDentalCase() gives it; not changed. */
  explicit TracingSession(std::shared_ptr<const DentalCaseData> data, unsigned int numberOfThreads = 0);
  ~TracingSession();
  TracingSession(const TracingSession &) = delete;
  TracingSession &
  operator=(const TracingSession &) = delete;

  /** \param drawings JSON: {"contours": contours.json or null, "landmarks": cephalometric landmarks or null}
   *  \return JSON: status, findings, residuals, sigmas, predicted landmarks and drafts of the crowns
   *
   * Throws DentalInputError for what cannot be registered, under the names "contours" and "landmarks", and
   * ProcessAborted after Abort(). */
  std::string
  Register(const std::string & drawings);

  /** Ends the registration that runs, and all later ones: whoever waits for them is leaving. From any thread. */
  void
  Abort();

  /** Throws DentalInputError where the readers of the toolkit would refuse what is drawn. `imageSize` is the
   * radiograph's, width and height. */
  static void
  Verify(const std::string & drawings, const std::array<unsigned int, 2> & imageSize);

private:
  std::mutex                              m_Mutex;
  std::atomic<bool>                       m_IsAborted{ false };
  std::shared_ptr<const DentalCaseData>   m_Data;
  SmartPointer<CaseRegistration>          m_Registration;
  std::unique_ptr<const CrownDraftSource> m_Drafts;
};
} // namespace itk

#endif

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
#ifndef itkExperimentMonitor_h
#define itkExperimentMonitor_h

#include "itkProcessObject.h"

#include <functional>

namespace itk
{
/** \class ExperimentMonitor
 * \brief What a study says while it computes a case, and how it learns that it should stop. */
class ExperimentMonitor
{
public:
  ExperimentMonitor(std::function<bool()> isAborted, std::function<void(double)> report)
    : m_IsAborted(std::move(isAborted))
    , m_Report(std::move(report))
  {}

  /** The part of the case that is done, in [0, 1]. Throws ProcessAborted where the experiment is to end. */
  void
  Advance(double part) const
  {
    m_Report(part);
    if (m_IsAborted())
    {
      throw ProcessAborted(__FILE__, __LINE__);
    }
  }

  /** For ExperimentRunner::SetAbort() and those that make a case. */
  const std::function<bool()> &
  GetAbort() const
  {
    return m_IsAborted;
  }

private:
  std::function<bool()>       m_IsAborted;
  std::function<void(double)> m_Report;
};

/** Ends an execution of the process at its next word of progress where isAborted gives true. An empty function never
 * does. */
inline void
AbortWhere(const std::function<bool()> & isAborted, ProcessObject * process)
{
  if (isAborted)
  {
    process->AddObserver(ProgressEvent(), [isAborted, process](const EventObject &) {
      if (isAborted())
      {
        process->AbortGenerateDataOn();
      }
    });
  }
}
} // namespace itk

#endif

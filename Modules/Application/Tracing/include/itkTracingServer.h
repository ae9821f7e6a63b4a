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
#ifndef itkTracingServer_h
#define itkTracingServer_h

#include "TracingExport.h"

#include <functional>
#include <memory>
#include <string>

namespace itk
{
/** \class TracingServer
 * \brief Answers one page, on this machine alone.
 *
 * It listens on 127.0.0.1, at a port that the system chooses unless one is asked for, and answers under a path that
 * nobody can guess (128 random bits). A browser that was sent here by another page, under another name of this machine
 * (DNS rebinding) or with a request that another page could make (no JSON, or a foreign origin) is refused. There is
 * nothing to be had but the page, and nothing to be sent but what the functions below take.
 *
 * One page is answered at a time, the one that was loaded last: two windows that draw on one radiograph would overwrite
 * what the other one saved. A page that is closed says so, and where none is loaded within a few seconds the server
 * ends.
 *
 * \ingroup Tracing
 */
class Tracing_EXPORT TracingServer
{
public:
  /** Takes the text of a request, returns that of the answer, JSON both. What it throws is told to the page. */
  using FunctionType = std::function<std::string(const std::string &)>;
  /** Makes the page, HTML. It has to know its number: its requests are POSTs to NUMBER/register, NUMBER/save and
   * NUMBER/closed beside it. */
  using PageFunctionType = std::function<std::string(unsigned int number)>;

  TracingServer();
  ~TracingServer();
  TracingServer(const TracingServer &) = delete;
  TracingServer &
  operator=(const TracingServer &) = delete;

  /** Called at each time that the page is loaded. */
  void
  SetPage(PageFunctionType function);
  /** Where one is not set, the page is told that there is none. */
  void
  SetRegister(FunctionType function);
  void
  SetSave(FunctionType function);

  /** Opens the port; 0: any. Throws DentalInputError where it is taken. */
  void
  Bind(int port);

  /** "http://127.0.0.1:PORT/TOKEN/", after Bind(). */
  std::string
  GetAddress() const;

  /** Answers until Stop(), which may be called at any time and from another thread, or until the page was closed.
   * \return whether the page was closed */
  bool
  Run();

  /** Ends Run(); a registration that is at work is given up. */
  void
  Stop();

private:
  class Implementation;
  std::unique_ptr<Implementation> m_Implementation;
};
} // namespace itk

#endif

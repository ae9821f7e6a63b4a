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
#ifndef itkTracingTransport_h
#define itkTracingTransport_h

#include <cstddef>
#include <functional>
#include <string>

namespace itk
{
/** \class TracingTransport
 * \brief Not installed. HTTP without an opinion: what TracingServer asks of a library that is loaded for it.
 */
class TracingTransport
{
public:
  struct RequestType
  {
    std::string method;
    std::string path;
    std::string host;
    std::string origin;
    std::string site;
    std::string contentType;
    std::string body;
  };
  struct AnswerType
  {
    int         status{ 200 };
    std::string contentType;
    std::string body;
  };
  /** Called from several threads; must not throw. */
  using HandlerType = std::function<AnswerType(const RequestType &)>;

  virtual ~TracingTransport() = default;
  virtual void
  SetHandler(HandlerType handler) = 0;
  virtual void
  SetLargestRequest(std::size_t bytes) = 0;
  /** 0: any. \return the port; not positive where it cannot be had */
  virtual int
  Bind(const char * host, int port) = 0;
  /** Once; returns after Stop(), which may come first and waits until it has been called. */
  virtual void
  Listen() = 0;
  virtual void
  Stop() = 0;
};
} // namespace itk

/** The caller deletes it. */
extern "C" __attribute__((visibility("default"))) itk::TracingTransport *
DentalSCRMakeTracingTransport();

#endif

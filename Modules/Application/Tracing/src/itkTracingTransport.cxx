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
#include "itkTracingTransport.h"

#include <httplib.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <utility>

namespace
{
class Transport : public itk::TracingTransport
{
public:
  Transport()
  {
    // The library's own options let two programs listen at one port, and each get some of the other's requests.
    m_Server.set_socket_options([](socket_t) {});
    m_Server.set_default_headers({ { "Cache-Control", "no-store" },
                                   { "Referrer-Policy", "no-referrer" },
                                   { "X-Content-Type-Options", "nosniff" },
                                   { "X-Frame-Options", "DENY" },
                                   { "Cross-Origin-Resource-Policy", "same-origin" } });
    // A connection that is kept keeps a thread, and the end waits for it.
    m_Server.set_keep_alive_timeout(1);
    const auto answer = [this](const httplib::Request & request, httplib::Response & response) {
      const AnswerType made = m_Handler({ request.method,
                                          request.path,
                                          request.get_header_value("Host"),
                                          request.get_header_value("Origin"),
                                          request.get_header_value("Sec-Fetch-Site"),
                                          request.get_header_value("Content-Type"),
                                          request.body });
      response.status = made.status;
      response.set_content(made.body, made.contentType.c_str());
    };
    m_Server.Get(".*", answer);
    m_Server.Post(".*", answer);
  }

  void
  SetHandler(HandlerType handler) override
  {
    m_Handler = std::move(handler);
  }
  void
  SetLargestRequest(std::size_t bytes) override
  {
    m_Server.set_payload_max_length(bytes);
  }
  int
  Bind(const char * host, int port) override
  {
    return port == 0 ? m_Server.bind_to_any_port(host) : (m_Server.bind_to_port(host, port) ? port : -1);
  }
  void
  Listen() override
  {
    if (!m_IsStopped)
    {
      m_Server.listen_after_bind();
    }
    m_HasEnded = true;
  }
  void
  Stop() override
  {
    m_IsStopped = true;
    // The library forgets a stop that comes before it listens.
    while (!m_Server.is_running() && !m_HasEnded)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    m_Server.stop();
  }

private:
  httplib::Server   m_Server;
  HandlerType       m_Handler;
  std::atomic<bool> m_IsStopped{ false };
  std::atomic<bool> m_HasEnded{ false };
};
} // namespace

itk::TracingTransport *
DentalSCRMakeTracingTransport()
{
  return new Transport;
}

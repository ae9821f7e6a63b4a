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
#include "itkTracingServer.h"

#include "itkDentalInputError.h"
#include "itkDescribePlainly.h"
#include "itkTracingTransport.h"

#ifdef DENTALSCR_TRACING_LIBRARY
#  include "itkLoadLibraryFunction.h"
#endif

#include <nlohmann/json.hpp>

#include <cstdint>
#include <exception>
#include <random>
#include <utility>

namespace itk
{
namespace
{
using RequestType = TracingTransport::RequestType;
using AnswerType = TracingTransport::AnswerType;

constexpr char Host[] = "127.0.0.1";
constexpr char Scheme[] = "http://";
constexpr char JsonType[] = "application/json";
/** A tracing of all teeth has a hundred kB. */
constexpr std::size_t LargestRequest = std::size_t{ 8 } << 20;

TracingTransport *
MakeTransport()
{
#ifdef DENTALSCR_TRACING_LIBRARY
  return LoadLibraryFunction<decltype(&DentalSCRMakeTracingTransport)>(DENTALSCR_TRACING_LIBRARY,
                                                                       "DentalSCRMakeTracingTransport",
                                                                       "The tracing page cannot be served",
                                                                       DENTALSCR_TRACING_LIBRARY)();
#else
  return DentalSCRMakeTracingTransport();
#endif
}

/** 128 bits of the system's own randomness. */
std::string
MakeToken()
{
  std::random_device source;
  std::string        token;
  for (unsigned int word = 0; word < 4; ++word)
  {
    std::uint32_t bits = source();
    for (unsigned int digit = 0; digit < 8; ++digit, bits >>= 4)
    {
      token += "0123456789abcdef"[bits & 15U];
    }
  }
  return token;
}

AnswerType
MakeError(int status, const std::string & text)
{
  const nlohmann::json json{ { "error", text } };
  return { status, JsonType, json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) };
}
} // namespace

class TracingServer::Implementation
{
public:
  std::unique_ptr<TracingTransport> transport{ MakeTransport() };
  std::string                       token{ MakeToken() };
  std::string                       page;
  FunctionType                      registerDrawings;
  FunctionType                      save;
  int                               port{ 0 };

  std::string
  GetAuthority() const
  {
    return std::string(Host) + ':' + std::to_string(port);
  }

  /** A page of another origin can make a browser send things here: not under this name, nor with this origin. */
  bool
  IsOwn(const RequestType & request) const
  {
    // "none": typed, or opened from outside the browser. Absent: no browser.
    const bool fromHere = request.site.empty() || request.site == "same-origin" || request.site == "none";
    return request.host == this->GetAuthority() && fromHere &&
           (request.method == "GET" ||
            (request.origin == Scheme + this->GetAuthority() && request.contentType.rfind(JsonType, 0) == 0));
  }

  AnswerType
  Answer(const RequestType & request) const
  {
    if (!this->IsOwn(request))
    {
      return MakeError(403, "only the page itself is answered");
    }
    const std::string root = '/' + token + '/';
    if (request.method == "GET" && request.path == root)
    {
      return { 200, "text/html; charset=utf-8", page };
    }
    if (request.method == "POST" && request.path == root + "register" && registerDrawings)
    {
      return this->Call(registerDrawings, request.body);
    }
    if (request.method == "POST" && request.path == root + "save" && save)
    {
      return this->Call(save, request.body);
    }
    return MakeError(404, "there is nothing here");
  }

private:
  AnswerType
  Call(const FunctionType & function, const std::string & body) const
  {
    try
    {
      return { 200, JsonType, function(body) };
    }
    catch (const DentalInputError & error)
    {
      return MakeError(422, error.GetOneLine());
    }
    catch (const ExceptionObject & error)
    {
      return MakeError(422, DescribePlainly(error));
    }
    catch (const std::exception & error)
    {
      return MakeError(422, error.what());
    }
  }
};

TracingServer::TracingServer()
  : m_Implementation(std::make_unique<Implementation>())
{
  Implementation & own = *m_Implementation;
  own.transport->SetLargestRequest(LargestRequest);
  own.transport->SetHandler([&own](const RequestType & request) { return own.Answer(request); });
}

TracingServer::~TracingServer() = default;

void
TracingServer::SetPage(const std::string & page)
{
  m_Implementation->page = page;
}

void
TracingServer::SetRegister(FunctionType function)
{
  m_Implementation->registerDrawings = std::move(function);
}

void
TracingServer::SetSave(FunctionType function)
{
  m_Implementation->save = std::move(function);
}

void
TracingServer::Bind(int port)
{
  m_Implementation->port = m_Implementation->transport->Bind(Host, port);
  if (m_Implementation->port <= 0)
  {
    itkDentalInputErrorMacro("--port",
                             "",
                             std::to_string(port) + " of 127.0.0.1 cannot be had: it is taken, or not allowed",
                             "leave the option out, and the system chooses one");
  }
}

std::string
TracingServer::GetAddress() const
{
  return Scheme + m_Implementation->GetAuthority() + '/' + m_Implementation->token + '/';
}

void
TracingServer::Run()
{
  m_Implementation->transport->Listen();
}

void
TracingServer::Stop()
{
  m_Implementation->transport->Stop();
}
} // namespace itk

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

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <optional>
#include <random>
#include <thread>
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
constexpr char HtmlType[] = "text/html; charset=utf-8";
/** What a page takes that is loaded again. */
constexpr std::chrono::seconds Farewell{ 5 };
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
  using ClockType = std::chrono::steady_clock;

  std::unique_ptr<TracingTransport> transport{ MakeTransport() };
  std::string                       token{ MakeToken() };
  PageFunctionType                  page;
  FunctionType                      registerDrawings;
  FunctionType                      save;
  int                               port{ 0 };
  std::mutex                        mutex;
  std::condition_variable           changed;
  /** The number of the page that was loaded last. */
  unsigned int number{ 0 };
  /** When that one was closed; nothing while it is open. */
  std::optional<ClockType::time_point> closed;
  bool                                 hasEnded{ false };

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
  Answer(const RequestType & request)
  {
    if (!this->IsOwn(request))
    {
      return MakeError(403,
                       "only the page itself is answered, under the address that the program has printed: type it, or "
                       "paste it, into the browser's own line");
    }
    const std::string root = '/' + token + '/';
    if (request.path.rfind(root, 0) != 0)
    {
      return MakeError(404, "there is nothing here: the address is not the one that the program has printed");
    }
    const std::string what = request.path.substr(root.size());
    if (request.method == "GET" && what.empty() && page)
    {
      const unsigned int own = this->Open();
      return this->Call([this, own](const std::string &) { return page(own); }, "", HtmlType);
    }
    const std::size_t slash = what.find('/');
    if (request.method != "POST" || slash == std::string::npos)
    {
      return MakeError(404, "there is nothing here");
    }
    const std::string sender = what.substr(0, slash);
    const std::string verb = what.substr(slash + 1);
    const bool        isLast = this->IsLast(sender);
    if (verb == "closed")
    {
      if (isLast)
      {
        const std::lock_guard<std::mutex> lock(mutex);
        closed = ClockType::now();
        changed.notify_all();
      }
      return { 200, JsonType, "{}" };
    }
    const FunctionType & function = verb == "register" ? registerDrawings : verb == "save" ? save : nothing;
    if (!function)
    {
      return MakeError(404, "there is nothing here");
    }
    if (!isLast)
    {
      return MakeError(409, "this radiograph was opened in another window since: go on there, or load this page again");
    }
    return this->Call(function, request.body, JsonType);
  }

  /** Waits until the page has been closed for long enough, or until End(). \return the former */
  bool
  WaitForFarewell()
  {
    std::unique_lock<std::mutex> lock(mutex);
    while (!hasEnded)
    {
      if (!closed)
      {
        changed.wait(lock);
      }
      else if (ClockType::now() >= *closed + Farewell)
      {
        return true;
      }
      else
      {
        changed.wait_until(lock, *closed + Farewell);
      }
    }
    return false;
  }

  void
  End()
  {
    const std::lock_guard<std::mutex> lock(mutex);
    hasEnded = true;
    changed.notify_all();
  }

private:
  const FunctionType nothing;

  unsigned int
  Open()
  {
    const std::lock_guard<std::mutex> lock(mutex);
    closed.reset();
    changed.notify_all();
    return ++number;
  }

  bool
  IsLast(const std::string & sender)
  {
    const std::lock_guard<std::mutex> lock(mutex);
    return number > 0 && sender == std::to_string(number);
  }

  static AnswerType
  Call(const FunctionType & function, const std::string & body, const char * type)
  {
    try
    {
      return { 200, type, function(body) };
    }
    catch (const ProcessAborted &)
    {
      return MakeError(503, "the program is ending");
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
TracingServer::SetPage(PageFunctionType function)
{
  m_Implementation->page = std::move(function);
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

bool
TracingServer::Run()
{
  Implementation & own = *m_Implementation;
  bool             isClosed = false;
  std::thread      watcher([&own, &isClosed]() {
    isClosed = own.WaitForFarewell();
    if (isClosed)
    {
      own.transport->Stop();
    }
  });
  own.transport->Listen();
  own.End();
  watcher.join();
  return isClosed;
}

void
TracingServer::Stop()
{
  m_Implementation->transport->Stop();
}
} // namespace itk

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
#include "dentalscrCaseOptions.h"
#include "dentalscrCommands.h"

#include "itkCaseInputFile.h"
#include "itkDentalCaseFileReader.h"
#include "itkDentalCaseLoader.h"
#include "itkDentalInputError.h"
#include "itkDrawingFile.h"
#include "itkReadDrawings.h"
#include "itkTextFile.h"
#include "itkTracingPage.h"
#include "itkTracingServer.h"
#include "itkTracingSession.h"

#include "itkMultiThreaderBase.h"

#include <nlohmann/json.hpp>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <functional>
#include <iostream>
#include <iterator>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <tuple>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace dentalscr
{
namespace
{
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct TraceOptions
{
  std::string image;
  std::string caseFile;
  CaseOptions fields;
  std::string output;
  std::string landmarks;
  std::string page;
  int         port{ 0 };
};

/** What is known beside the radiograph; of a radiograph alone that is its name. */
itk::DentalCase
ReadCase(const TraceOptions & options)
{
  const std::string given = options.fields.GetFirstGiven();
  if (!options.caseFile.empty() && !given.empty())
  {
    itkDentalInputErrorMacro("command line",
                             given,
                             "stands beside a case file, which has a field for it",
                             "change the case file, or leave it out and give all that it says as options");
  }
  itk::DentalCase description;
  if (!options.caseFile.empty())
  {
    description = itk::ReadDentalCaseToDraw(options.caseFile);
  }
  else if (!given.empty())
  {
    description = options.fields.Read(false);
  }
  if (!options.image.empty())
  {
    description.imageFile = options.image;
  }
  if (description.imageFile.empty())
  {
    itkDentalInputErrorMacro("command line",
                             "image",
                             "there is no radiograph to draw on",
                             "name it, or one in the case file's cephalogram.image");
  }
  if (description.fileName.empty())
  {
    description.fileName = "command line";
  }
  return description;
}

/** Where the drawing goes, what is there already comes from, before what the case names. */
void
GoOnWith(const std::string & fileName, std::string & drawn)
{
  std::error_code ignored;
  if (!fileName.empty() && fs::is_regular_file(fileName, ignored))
  {
    drawn = fileName;
  }
}

/** What another program wrote is gone on with, never saved over: it may hold more than a tracing. */
void
RefuseForeign(bool isForeign, const std::string & read, const std::string & written, const char * option)
{
  if (isForeign && !written.empty() && read == written)
  {
    itkDentalInputErrorMacro(written,
                             "",
                             "was written by another program, and saving would take the place of all that it holds",
                             std::string("give it as ") + option +
                               " (or name it in the case file), and a new file for what you draw");
  }
}

/** One of the two drawings, as a person may read it; "" where it is not drawn. */
std::string
ToText(const Json & drawings, const char * name)
{
  const auto found = drawings.find(name);
  return found != drawings.end() && found->is_object() ? found->dump(1) + '\n' : std::string();
}

/** A signal that asks the program to end is told to a thread, since what ends a server may not be done in a handler.
 * The second one ends the program at once. One at a time. */
class EndOnSignal
{
public:
  explicit EndOnSignal(std::function<void()> end)
  {
    if (pipe2(s_Pipe, O_CLOEXEC | O_NONBLOCK) != 0)
    {
      itkGenericExceptionMacro("A pipe can't be made: " << std::strerror(errno));
    }
    for (std::size_t i = 0; i < std::size(Signals); ++i)
    {
      struct sigaction action
      {};
      action.sa_handler = Handle;
      sigemptyset(&action.sa_mask);
      action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
      sigaction(Signals[i], nullptr, &m_Before[i]);
      // Who starts a program with nohup wants it to go on without a terminal.
      if (m_Before[i].sa_handler != SIG_IGN)
      {
        sigaction(Signals[i], &action, nullptr);
      }
    }
    m_Waiter = std::thread([this, end = std::move(end)]() {
      pollfd wanted{ s_Pipe[0], POLLIN, 0 };
      while (poll(&wanted, 1, -1) < 0 && errno == EINTR)
      {}
      if (!m_IsOver)
      {
        end();
      }
    });
  }
  ~EndOnSignal()
  {
    for (std::size_t i = 0; i < std::size(Signals); ++i)
    {
      sigaction(Signals[i], &m_Before[i], nullptr);
    }
    m_IsOver = true;
    Handle(0);
    m_Waiter.join();
    close(s_Pipe[0]);
    close(s_Pipe[1]);
  }
  EndOnSignal(const EndOnSignal &) = delete;
  EndOnSignal &
  operator=(const EndOnSignal &) = delete;

private:
  /** Those that mean: please end. A terminal that is closed is one of them. */
  static constexpr int Signals[] = { SIGINT, SIGTERM, SIGHUP };

  static void
  Handle(int)
  {
    const int                   before = errno;
    const char                  byte = 0;
    [[maybe_unused]] const auto written = write(s_Pipe[1], &byte, 1);
    errno = before;
  }

  static inline int s_Pipe[2]{ -1, -1 };
  struct sigaction  m_Before[std::size(Signals)];
  std::atomic<bool> m_IsOver{ false };
  std::thread       m_Waiter;
};

int
Trace(const TraceOptions & options, const CommonOptions & common)
{
  if (!options.output.empty() &&
      fs::u8path(options.output).lexically_normal() == fs::u8path(options.landmarks).lexically_normal())
  {
    itkDentalInputErrorMacro("command line",
                             "--landmarks",
                             "is the file of --output, and one would overwrite the other",
                             "give the landmarks a file of their own");
  }
  itk::DentalCase description = ReadCase(options);
  const bool      hasScans = !description.upperFile.empty() || !description.lowerFile.empty();
  itk::DentalCase drawn = description;
  GoOnWith(options.output, drawn.contoursFile);
  if (drawn.contoursFile == options.output && !options.output.empty())
  {
    drawn.contourClassFiles.clear();
  }
  if (!options.landmarks.empty())
  {
    std::string file;
    GoOnWith(options.landmarks, file);
    if (!file.empty())
    {
      drawn.cephalometricLandmarksFile = file;
      drawn.cephalometricLandmarks = nullptr;
    }
  }
  description.contoursFile.clear();
  description.contourClassFiles.clear();
  description.cephalometricLandmarksFile.clear();
  description.cephalometricLandmarks = nullptr;
  // A page by itself registers nothing: the scans are not worth their time.
  if (!options.page.empty())
  {
    description.upperFile.clear();
    description.lowerFile.clear();
    description.upperLabelsFile.clear();
    description.lowerLabelsFile.clear();
  }
  itk::DrawingFile                                 contoursFile(options.output);
  itk::DrawingFile                                 landmarksFile(options.landmarks);
  const std::shared_ptr<const itk::DentalCaseData> data = itk::LoadDentalCase(description);
  for (const std::string & warning : data->warnings)
  {
    std::cerr << "dentalscr: warning: " << warning << '\n';
  }
  const itk::DrawingTexts texts = itk::ReadDrawings(*data, drawn);
  itk::TracingPageContent content;
  content.radiograph = data->image;
  if (data->HasPixelSpacing())
  {
    content.pixelSpacing = { { data->geometry->GetPixelSpacing()[0], data->geometry->GetPixelSpacing()[1] } };
  }
  content.markupsGrid = data->markupsGrid.value_or(content.markupsGrid);
  content.title = fs::path(description.imageFile).filename().string();
  content.identity = itk::ComputeFileSHA256(description.imageFile).substr(0, 16);
  content.contours = texts.contours;
  content.landmarks = texts.landmarks;
  if (!options.page.empty())
  {
    itk::WriteFileAtomically(options.page, itk::MakeTracingPage(content));
    if (!common.quiet)
    {
      std::cout << "written to " << options.page << std::endl;
    }
    return AllRegistered;
  }
  RefuseForeign(texts.contoursAreForeign, drawn.contoursFile, options.output, "--contours");
  RefuseForeign(
    texts.landmarksAreForeign, drawn.cephalometricLandmarksFile, options.landmarks, "--cephalometric-landmarks");
  content.served = true;
  content.canRegister = hasScans;
  content.contoursFile = fs::path(options.output).filename().string();
  content.landmarksFile = fs::path(options.landmarks).filename().string();
  content.contoursAreSaved = !options.output.empty() && drawn.contoursFile == options.output;
  content.landmarksAreSaved = !options.landmarks.empty() && drawn.cephalometricLandmarksFile == options.landmarks;
  content.savesItself = !contoursFile.WasThere() && !landmarksFile.WasThere();

  itk::TracingServer                   server;
  std::unique_ptr<itk::TracingSession> session;
  if (hasScans)
  {
    session = std::make_unique<itk::TracingSession>(
      data, common.threads > 0 ? common.threads : itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads());
    server.SetRegister([&session](const std::string & drawings) { return session->Register(drawings); });
  }
  // What is saved is what a page that is loaded again goes on with.
  std::mutex contentMutex;
  if (!options.output.empty() || !options.landmarks.empty())
  {
    server.SetSave([&](const std::string & drawings) {
      // What is refused later, by register, is better refused now.
      itk::TracingSession::Verify(drawings, data->imageSize);
      const Json                        json = Json::parse(drawings);
      const std::string                 contours = ToText(json, "contours");
      const std::string                 landmarks = ToText(json, "landmarks");
      const std::lock_guard<std::mutex> lock(contentMutex);
      contoursFile.Verify();
      landmarksFile.Verify();
      Json saved = Json::array();
      for (const auto & [file, text, kept, isSaved, name] :
           { std::tie(contoursFile, contours, content.contours, content.contoursAreSaved, content.contoursFile),
             std::tie(landmarksFile, landmarks, content.landmarks, content.landmarksAreSaved, content.landmarksFile) })
      {
        if (!text.empty() && !name.empty())
        {
          file.Save(text);
          kept = text;
          isSaved = true;
          saved.push_back(name);
        }
      }
      return Json{ { "saved", saved } }.dump();
    });
  }
  server.SetPage([&](unsigned int number) {
    const std::lock_guard<std::mutex> lock(contentMutex);
    content.number = number;
    return itk::MakeTracingPage(content);
  });
  server.Bind(options.port);
  // Before the address: who has read it may ask for the end at once.
  const EndOnSignal end([&]() {
    server.Stop();
    if (session)
    {
      session->Abort();
    }
  });
  // Said also when all else is quiet: without it nobody finds the page.
  std::cout << server.GetAddress() << std::endl;
  if (!common.quiet)
  {
    std::cerr << "Open this address in a browser on this machine. To end, close the page or press Ctrl-C." << std::endl;
  }
  const bool isClosed = server.Run();
  if (isClosed && !common.quiet)
  {
    std::cerr << "The page was closed." << std::endl;
  }
  return AllRegistered;
}
} // namespace

void
AddTraceCommand(CLI::App & program, const CommonOptions & common, RunFunction & run)
{
  auto   options = std::make_shared<TraceOptions>();
  auto * command = program.add_subcommand(
    "trace", "Opens a radiograph to be traced in a browser, with drafts of the crowns where the scans are known");
  command->add_option("radiograph", options->image, "The radiograph (default: the case's)")->type_name("FILE");
  command->add_option("--case", options->caseFile, "Case file, whose scans are registered while you draw")
    ->type_name("FILE");
  command
    ->add_option("-o,--output", options->output, "File for the tracing (contours.json); what is in it is gone on with")
    ->type_name("FILE");
  command->add_option("--landmarks", options->landmarks, "The same for landmarks (cephalometric_landmarks)")
    ->type_name("FILE");
  command
    ->add_option("--page", options->page, "Write one HTML file that works by itself, instead of answering a browser")
    ->type_name("FILE");
  command->add_option("--port", options->port, "Port of 127.0.0.1 (0: any that is free)")
    ->check(CLI::Range(0, 65535))
    ->capture_default_str();
  options->fields.AddTo(command);
  command->footer(
    "The page is answered on this machine alone, at an address that nobody can guess; only the files named by\n"
    "--output and --landmarks are written, when you save, or after every change where neither is there yet. Without\n"
    "them the page downloads what is drawn. The program ends when the page is closed, or by Ctrl-C.\n"
    "Examples:\n"
    "  dentalscr trace ceph.png --output contours.json --landmarks landmarks.json\n"
    "  dentalscr trace ceph.png --upper upper.stl --lower lower.stl --output contours.json\n"
    "  dentalscr trace --case case.json --output contours.json\n"
    "  dentalscr trace ceph.png --page trace.html\n");
  command->callback([options, &common, &run]() { run = [options, &common]() { return Trace(*options, common); }; });
}
} // namespace dentalscr

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
#include "itkReadDrawings.h"
#include "itkTextFile.h"
#include "itkTracingPage.h"
#include "itkTracingServer.h"
#include "itkTracingSession.h"

#include "itkMultiThreaderBase.h"

#include <nlohmann/json.hpp>

#include <csignal>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <thread>

#include <pthread.h>

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
  else if (!options.fields.GetValue("--upper").empty() || !options.fields.GetValue("--lower").empty())
  {
    description = options.fields.Read(false);
  }
  else if (!given.empty())
  {
    itkDentalInputErrorMacro(
      "command line", given, "says something of a case without a scan", "give --upper or --lower too, or leave it out");
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

/** One of the two drawings, as a person may read it. */
void
Write(const Json & drawing, const std::string & fileName)
{
  if (!fileName.empty() && drawing.is_object())
  {
    itk::WriteFileAtomically(fileName, drawing.dump(1) + '\n');
  }
}

/** Interrupts wait for a thread that is there for them: what ends a server may not be done in a handler. Threads that
 * are started while this lives, and only they, leave interrupts alone as well: it comes before all others. */
class HeldInterrupts
{
public:
  HeldInterrupts()
  {
    sigemptyset(&m_Signals);
    sigaddset(&m_Signals, SIGINT);
    sigaddset(&m_Signals, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &m_Signals, &m_Before);
  }
  ~HeldInterrupts() { pthread_sigmask(SIG_SETMASK, &m_Before, nullptr); }
  HeldInterrupts(const HeldInterrupts &) = delete;
  HeldInterrupts &
  operator=(const HeldInterrupts &) = delete;

  void
  Wait() const
  {
    int received = 0;
    sigwait(&m_Signals, &received);
  }

private:
  sigset_t m_Signals{};
  sigset_t m_Before{};
};

int
Trace(const TraceOptions & options, const CommonOptions & common)
{
  const HeldInterrupts interrupts;
  itk::DentalCase      description = ReadCase(options);
  const bool           hasScans = !description.upperFile.empty() || !description.lowerFile.empty();
  itk::DentalCase      drawn = description;
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
  content.served = true;
  content.canRegister = hasScans;
  content.contoursFile = fs::path(options.output).filename().string();
  content.landmarksFile = fs::path(options.landmarks).filename().string();

  itk::TracingServer                   server;
  std::unique_ptr<itk::TracingSession> session;
  if (hasScans)
  {
    session = std::make_unique<itk::TracingSession>(
      data, common.threads > 0 ? common.threads : itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads());
    server.SetRegister([&session](const std::string & drawings) { return session->Register(drawings); });
  }
  if (!options.output.empty() || !options.landmarks.empty())
  {
    server.SetSave([&](const std::string & drawings) {
      // What is refused later, by register, is better refused now.
      itk::TracingSession::Verify(drawings, data->imageSize);
      const Json json = Json::parse(drawings);
      Write(json.value("contours", Json()), options.output);
      Write(json.value("landmarks", Json()), options.landmarks);
      return Json{ { "saved", { content.contoursFile, content.landmarksFile } } }.dump();
    });
  }
  server.SetPage(itk::MakeTracingPage(content));
  server.Bind(options.port);
  // Said also when all else is quiet: without it nobody finds the page.
  std::cout << server.GetAddress() << std::endl;
  if (!common.quiet)
  {
    std::cerr << "Open this address in a browser on this machine. Ctrl-C ends it." << std::endl;
  }
  std::thread waiter([&]() {
    interrupts.Wait();
    server.Stop();
  });
  server.Run();
  waiter.join();
  return AllRegistered;
}
} // namespace

void
AddTraceCommand(CLI::App & program, const CommonOptions & common, RunFunction & run)
{
  auto   options = std::make_shared<TraceOptions>();
  auto * command = program.add_subcommand(
    "trace", "Opens a radiograph to be traced in a browser, with drafts of the crowns where the scans are known");
  command->add_option("radiograph", options->image, "The radiograph (default: the case's)");
  command->add_option("--case", options->caseFile, "Case file, whose scans are registered while you draw");
  command->add_option(
    "-o,--output", options->output, "File for the tracing (contours.json); what is in it is gone on with");
  command->add_option("--landmarks", options->landmarks, "The same for landmarks (cephalometric_landmarks)");
  command->add_option(
    "--page", options->page, "Write one HTML file that works by itself, instead of answering a browser");
  command->add_option("--port", options->port, "Port of 127.0.0.1 (0: any that is free)")
    ->check(CLI::Range(0, 65535))
    ->capture_default_str();
  options->fields.AddTo(command);
  command->footer(
    "The page is answered on this machine alone, at an address that nobody can guess; only the files named by\n"
    "--output and --landmarks are written, when you save. Without them the page downloads what is drawn.\n"
    "Examples:\n"
    "  dentalscr trace ceph.png --output contours.json --landmarks landmarks.json\n"
    "  dentalscr trace ceph.png --upper upper.stl --lower lower.stl --output contours.json\n"
    "  dentalscr trace --case case.json --output contours.json\n"
    "  dentalscr trace ceph.png --page trace.html\n");
  command->callback([options, &common, &run]() { run = [options, &common]() { return Trace(*options, common); }; });
}
} // namespace dentalscr

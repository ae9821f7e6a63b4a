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
#include "itkBatchRunner.h"

#include "itkCaseInputFile.h"
#include "itkCaseResultWriter.h"
#include "itkDentalInputError.h"
#include "itkDentalSCRVersion.h"
#include "itkJsonDocument.h"
#include "itkOutputFolder.h"
#include "itkTextFile.h"

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <thread>

namespace itk
{
namespace
{
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

/** How often a runner looks whether a process has ended: short against a registration, long against a look. */
constexpr auto PollInterval = std::chrono::milliseconds(10);

double
SecondsSince(const Clock::time_point & start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/** The last line that a process has said. */
std::string
LastLine(const fs::path & log)
{
  try
  {
    std::string text = ReadTextFile(log.string(), "a log");
    while (!text.empty() && (text.back() == '\n' || text.back() == '\r'))
    {
      text.pop_back();
    }
    return text.substr(text.rfind('\n') + 1);
  }
  catch (const DentalInputError &)
  {
    return {};
  }
}

/** Whether every file that a result was made of is what it was. */
bool
InputsAreUnchanged(const JsonNode & root, const BatchCase & one)
{
  const auto inputs = root.Find("inputs");
  if (!inputs)
  {
    return false;
  }
  // Of a case file its names are relative to it, of options to where the program runs.
  const auto     recorded = inputs->Find("case");
  const fs::path folder = recorded ? fs::path(one.arguments.front()).parent_path() : fs::path();
  for (const auto & member : inputs->GetMembers())
  {
    const std::string path = member.second.Get("path").AsString();
    const fs::path    file = member.first == "case" ? fs::path(one.arguments.front()) : folder / path;
    std::error_code   error;
    if (!fs::is_regular_file(file, error) || ComputeFileSHA256(file.string()) != member.second.Get("sha256").AsString())
    {
      return false;
    }
  }
  return true;
}
} // namespace

/** A process that runs: there is none whose number is not known. */
struct BatchRunner::ChildType
{
  pid_t             process;
  std::size_t       index;
  Clock::time_point start;
};

BatchRunner::BatchRunner() = default;
BatchRunner::~BatchRunner() = default;

void
BatchRunner::SetCases(const std::vector<BatchCase> & cases)
{
  m_Cases = cases;
  this->Modified();
}

void
BatchRunner::SetProgram(const std::vector<std::string> & words)
{
  m_Program = words;
  this->Modified();
}

void
BatchRunner::SetArguments(const std::vector<std::string> & arguments)
{
  m_Arguments = arguments;
  this->Modified();
}

std::vector<BatchRecord>
BatchRunner::GetRecords() const
{
  std::vector<BatchRecord> records;
  for (std::size_t i = 0; i < m_Records.size(); ++i)
  {
    if (m_IsDone[i])
    {
      records.push_back(m_Records[i]);
    }
  }
  return records;
}

double
BatchRunner::GetSecondsLeft() const
{
  if (m_NumberOfRunCases == 0)
  {
    return -1.0;
  }
  return m_SecondsSinceStart / static_cast<double>(m_NumberOfRunCases) *
         static_cast<double>(m_Cases.size() - m_NumberOfFinishedCases);
}

void
BatchRunner::Update()
{
  this->SetAbortGenerateData(false);
  this->VerifyPreconditions();
  this->InvokeEvent(StartEvent());
  this->GenerateData();
  this->InvokeEvent(EndEvent());
}

void
BatchRunner::VerifyPreconditions() ITKv5_CONST
{
  if (m_Program.empty() || m_OutputFolder.empty())
  {
    itkExceptionMacro("There is no program or no folder. Call SetProgram() and SetOutputFolder().");
  }
  if (m_Cases.empty())
  {
    itkExceptionMacro("There is no case. Call SetCases().");
  }
}

bool
BatchRunner::KeepEarlier(std::size_t index)
{
  const BatchCase & one = m_Cases[index];
  const fs::path    folder = fs::path(m_OutputFolder) / one.id;
  const fs::path    recordFile = fs::path(m_OutputFolder) / ".batch" / (one.id + ".json");
  std::error_code   error;
  if (!fs::exists(recordFile, error) || !fs::exists(folder / "result.json", error))
  {
    return false;
  }
  try
  {
    const auto               root = JsonDocument::ReadFile(recordFile.string()).GetRoot();
    std::vector<std::string> arguments;
    const auto               recorded = root.Get("arguments");
    for (std::size_t i = 0; i < recorded.GetSize(); ++i)
    {
      arguments.push_back(recorded.At(i).AsString());
    }
    std::vector<std::string> now = one.arguments;
    now.insert(now.end(), m_Arguments.begin(), m_Arguments.end());
    const auto exitCode = root.Get("exit_code").AsInteger(-1, 255);
    // Another version may come to another result, and the tables say of all rows what made them.
    if (arguments != now || exitCode < 0 || exitCode > 1 || root.Get("software").AsString() != DentalSCRVersion ||
        !InputsAreUnchanged(JsonDocument::ReadFile((folder / "result.json").string()).GetRoot(), one))
    {
      return false;
    }
    BatchRecord & record = m_Records[index];
    record.ReadResult(folder.string());
    record.exitCode = static_cast<int>(exitCode);
    record.seconds = root.Get("seconds").AsNumber();
    record.isKept = true;
    return true;
  }
  catch (const DentalInputError &)
  {
    // Not whole: as good as not there.
    return false;
  }
}

BatchRunner::ChildType
BatchRunner::Start(std::size_t index, unsigned int threads) const
{
  const BatchCase & one = m_Cases[index];
  const fs::path    records = fs::path(m_OutputFolder) / ".batch";
  std::error_code   error;
  // From here until it is written anew there is no record: killed in between, the case is run again. And no result:
  // what lies in the folder when the process has ended is the process's own.
  fs::remove(records / (one.id + ".json"), error);
  RemoveCaseResult((fs::path(m_OutputFolder) / one.id).string());
  std::vector<std::string> words = m_Program;
  words.emplace_back("register");
  words.insert(words.end(), one.arguments.begin(), one.arguments.end());
  words.insert(words.end(), m_Arguments.begin(), m_Arguments.end());
  words.insert(
    words.end(),
    { "--output", (fs::path(m_OutputFolder) / one.id).string(), "--quiet", "--threads", std::to_string(threads) });
  std::vector<char *> pointers;
  for (std::string & word : words)
  {
    pointers.push_back(&word[0]);
  }
  pointers.push_back(nullptr);
  const std::string log = (records / (one.id + ".log")).string();
  const pid_t       parent = getpid();
  const auto        start = Clock::now();
  const pid_t       process = fork();
  if (process == 0)
  {
    // Between fork and exec only what a signal handler may do. It ends with its runner, however that ends, and by its
    // runner alone: the terminal's Ctrl-C goes to a group, and would look like a case that has failed.
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent)
    {
      _exit(126);
    }
    const int nothing = open("/dev/null", O_RDWR);
    const int said = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (nothing < 0 || said < 0 || dup2(nothing, 0) < 0 || dup2(nothing, 1) < 0 || dup2(said, 2) < 0)
    {
      _exit(126);
    }
    execvp(pointers[0], pointers.data());
    _exit(127);
  }
  if (process < 0)
  {
    itkExceptionMacro("No process can be started: " << std::strerror(errno));
  }
  return { process, index, start };
}

void
BatchRunner::Finish(std::size_t index, int exitCode, double seconds)
{
  const BatchCase & one = m_Cases[index];
  const fs::path    folder = fs::path(m_OutputFolder) / one.id;
  const fs::path    records = fs::path(m_OutputFolder) / ".batch";
  BatchRecord &     record = m_Records[index];
  record.exitCode = exitCode;
  record.seconds = seconds;
  // Without the program's name before it: whoever tells of it puts it there.
  constexpr char prefix[] = "dentalscr: ";
  std::string    said = LastLine(records / (one.id + ".log"));
  if (said.rfind(prefix, 0) == 0)
  {
    said.erase(0, sizeof(prefix) - 1);
  }
  const std::string ended = "the program ended with " + std::to_string(exitCode);
  if (exitCode == 0 || exitCode == 1)
  {
    try
    {
      record.ReadResult(folder.string());
    }
    catch (const DentalInputError &)
    {
      // An interpreter ends with 1, too.
      record.status = BatchRecord().status;
      record.jaws.clear();
      record.message = ended + " and left no result: " + said;
    }
  }
  else
  {
    record.message = exitCode == 2     ? said
                     : exitCode < 0    ? "nobody can say how the program ended: " + said
                     : exitCode == 127 ? "the program " + m_Program.front() + " can't be started"
                     : exitCode > 128
                       ? "the program was ended by signal " + std::to_string(exitCode - 128) + ": " + said
                       : ended + ": " + said;
  }
  if (record.jaws.empty())
  {
    // Half a result is none.
    RemoveCaseResult(folder.string());
  }
  std::vector<std::string> arguments = one.arguments;
  arguments.insert(arguments.end(), m_Arguments.begin(), m_Arguments.end());
  const Json json = { { "software", DentalSCRVersion },
                      { "arguments", arguments },
                      { "exit_code", exitCode },
                      { "seconds", seconds },
                      { "message", record.message } };
  WriteFileAtomically((records / (one.id + ".json")).string(),
                      json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n');
}

void
BatchRunner::GenerateData()
{
  m_Folder = nullptr;
  m_Folder = std::make_unique<OutputFolder>(m_OutputFolder);
  std::error_code error;
  const fs::path  records = fs::path(m_OutputFolder) / ".batch";
  fs::create_directories(records, error);
  if (error)
  {
    itkDentalInputErrorMacro(
      m_OutputFolder, "", "can't be written: " + error.message(), "choose another output folder");
  }
  m_Records.assign(m_Cases.size(), BatchRecord());
  m_IsDone.assign(m_Cases.size(), false);
  m_NumberOfFinishedCases = 0;
  m_NumberOfRunCases = 0;
  for (std::size_t i = 0; i < m_Cases.size(); ++i)
  {
    m_Records[i].one = m_Cases[i];
  }
  const auto beginning = Clock::now();
  const auto cores = std::max(1u, std::thread::hardware_concurrency());
  const auto jobs = m_NumberOfJobs > 0 ? m_NumberOfJobs : cores;
  // Cores that no case needs serve the others.
  const auto             threads = std::max(1u, cores / jobs);
  std::size_t            next = 0;
  std::vector<ChildType> children;
  const auto             endAll = [&]() {
    for (const ChildType & child : children)
    {
      kill(child.process, SIGTERM);
    }
    for (const ChildType & child : children)
    {
      while (waitpid(child.process, nullptr, 0) < 0 && errno == EINTR)
      {}
    }
    children.clear();
  };
  const auto done = [&](std::size_t index) {
    m_IsDone[index] = true;
    ++m_NumberOfFinishedCases;
    m_Record = m_Records[index];
    m_SecondsSinceStart = SecondsSince(beginning);
    this->UpdateProgress(static_cast<float>(m_NumberOfFinishedCases) / static_cast<float>(m_Cases.size()));
    this->InvokeEvent(IterationEvent());
  };
  try
  {
    while (m_NumberOfFinishedCases < m_Cases.size())
    {
      this->InvokeEvent(ProgressEvent());
      // Before any process is asked how it ended: what is ended by an abort has not failed.
      if (this->GetAbortGenerateData())
      {
        throw ProcessAborted(__FILE__, __LINE__);
      }
      bool waits = true;
      while (waits && next < m_Cases.size() && children.size() < jobs)
      {
        const std::size_t index = next++;
        if (m_Resume && this->KeepEarlier(index))
        {
          // One at a time: its files were read to know them, and others may have ended meanwhile.
          done(index);
          waits = false;
        }
        else
        {
          children.push_back(this->Start(index, threads));
        }
      }
      for (std::size_t k = 0; k < children.size();)
      {
        int         status = 0;
        const pid_t ended = waitpid(children[k].process, &status, WNOHANG);
        if (ended == 0 || (ended < 0 && errno == EINTR))
        {
          ++k;
          continue;
        }
        const ChildType child = children[k];
        children.erase(children.begin() + static_cast<std::ptrdiff_t>(k));
        const int exitCode = ended < 0 ? -1 : WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        this->Finish(child.index, exitCode, SecondsSince(child.start));
        ++m_NumberOfRunCases;
        done(child.index);
      }
      if (waits && !children.empty())
      {
        std::this_thread::sleep_for(PollInterval);
      }
    }
  }
  catch (...)
  {
    endAll();
    throw;
  }
}

void
BatchRunner::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Cases: " << m_Cases.size() << std::endl;
  os << indent << "Arguments: " << m_Arguments.size() << std::endl;
  os << indent << "Program: " << (m_Program.empty() ? "(none)" : m_Program.front()) << std::endl;
  os << indent << "OutputFolder: " << m_OutputFolder << std::endl;
  os << indent << "NumberOfJobs: " << m_NumberOfJobs << std::endl;
  os << indent << "Resume: " << (m_Resume ? "On" : "Off") << std::endl;
  os << indent << "NumberOfFinishedCases: " << m_NumberOfFinishedCases << std::endl;
  os << indent << "NumberOfRunCases: " << m_NumberOfRunCases << std::endl;
  os << indent << "SecondsSinceStart: " << m_SecondsSinceStart << std::endl;
  os << indent << "Record: " << m_Record.one.id << std::endl;
}
} // namespace itk

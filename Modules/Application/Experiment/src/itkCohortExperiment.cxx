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
#include "itkCohortExperiment.h"

#include "itkExperimentCaseFiles.h"
#include "itkExperimentPictures.h"
#include "itkExperimentPlan.h"

#include "itkDentalInputError.h"
#include "itkDentalSCRVersion.h"
#include "itkJobQueue.h"
#include "itkJsonDocument.h"
#include "itkOutputFolder.h"
#include "itkParallelFor.h"
#include "itkTextFile.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <thread>

namespace itk
{
namespace
{
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using StudyEnum = CohortExperimentEnums::Study;

const char *
NameOf(StudyEnum study)
{
  switch (study)
  {
    case StudyEnum::Capture:
      return "capture";
    case StudyEnum::Sensitivity:
      return "sensitivity";
    case StudyEnum::Ablation:
      return "ablation";
    case StudyEnum::Coverage:
      return "coverage";
    case StudyEnum::Verdict:
      return "verdict";
    case StudyEnum::Practice:
      return "practice";
    case StudyEnum::Views:
      return "views";
    default:
      return "tables";
  }
}

/** About preset robust and phantoms of every kind: no choice of methods, level or files. */
bool
IsAboutRobust(StudyEnum study)
{
  return study == StudyEnum::Ablation || study == StudyEnum::Coverage || study == StudyEnum::Verdict ||
         study == StudyEnum::Practice || study == StudyEnum::Views;
}

} // namespace

std::ostream &
operator<<(std::ostream & os, CohortExperimentEnums::Study study)
{
  return os << NameOf(study);
}

void
CohortExperiment::SetMethods(const std::vector<std::string> & names)
{
  if (names != m_Methods)
  {
    m_Methods = names;
    this->Modified();
  }
}

void
CohortExperiment::SetLevel(CohortEnum level)
{
  this->SetPhantomLevel(DentalPhantomLevel::Named(NameOf(level)));
}

auto
CohortExperiment::GetLevel() const -> CohortEnum
{
  const auto & names = DentalPhantomLevel::GetNames();
  return static_cast<CohortEnum>(std::find(names.begin(), names.end(), m_Level.name) - names.begin());
}

void
CohortExperiment::SetPhantomLevel(const DentalPhantomLevel & level)
{
  level.Validate();
  if (level != m_Level)
  {
    m_Level = level;
    this->Modified();
  }
}

std::unique_ptr<ExperimentPlan>
CohortExperiment::MakePlan() const
{
  std::vector<std::string> names = m_Methods;
  const bool               isDefault = names == std::vector<std::string>{ "default" };
  if (m_Study == StudyEnum::Sensitivity && isDefault)
  {
    names = {
      "bounding-box", "single-stage", "paper", "robust", "one-sided", "icp", "icp-trimmed", "cpd", "cpd-robust"
    };
  }
  if (IsAboutRobust(m_Study) && !isDefault)
  {
    itkDentalInputErrorMacro("--methods",
                             "",
                             std::string("the study ") + NameOf(m_Study) + " is about preset robust alone",
                             "leave out --methods");
  }
  if ((IsAboutRobust(m_Study) || m_Study == StudyEnum::Sensitivity) && !m_CaseDirectory.empty())
  {
    itkDentalInputErrorMacro(std::string("--study ") + NameOf(m_Study),
                             "",
                             "varies simulated cases on purpose and can't take cases from files",
                             "leave out --from");
  }
  std::vector<ExperimentMethod> methods;
  try
  {
    methods = SelectExperimentMethods(names);
  }
  catch (const std::invalid_argument & error)
  {
    itkDentalInputErrorMacro("--methods", "", error.what(), "see dentalscr experiment --help");
  }
  if (methods.empty())
  {
    itkDentalInputErrorMacro("--methods", "", "no method is chosen", "see dentalscr experiment --help");
  }
  if (m_CaseDirectory.empty() && !IsAboutRobust(m_Study) && m_Level.frontalView)
  {
    itkDentalInputErrorMacro("--parameters",
                             "frontal.given",
                             "cases that are drawn here have a lateral radiograph alone",
                             "make them with dentalscr phantom --count and take them with --from");
  }
  ExperimentCohort cohort;
  if (!IsAboutRobust(m_Study))
  {
    cohort.level = m_Level;
  }
  cohort.seed = m_Seed;
  cohort.count = m_NumberOfCases;
  if (!m_CaseDirectory.empty())
  {
    cohort.files = FindExperimentCaseFiles(m_CaseDirectory);
  }
  else if (m_NumberOfCases == 0)
  {
    itkDentalInputErrorMacro("--cases", "", "0 cases leave nothing to measure", "ask for at least 1");
  }
  if (IsAboutRobust(m_Study))
  {
    cohort.name = "case";
  }
  switch (m_Study)
  {
    case StudyEnum::Capture:
      return MakeCapturePlan(cohort, methods, m_NumberOfStarts);
    case StudyEnum::Sensitivity:
      return MakeSensitivityPlan(cohort, methods);
    case StudyEnum::Ablation:
      return MakeAblationPlan(cohort);
    case StudyEnum::Coverage:
      return MakeCoveragePlan(cohort);
    case StudyEnum::Verdict:
      return MakeVerdictPlan(cohort);
    case StudyEnum::Practice:
      return MakePracticePlan(cohort);
    case StudyEnum::Views:
      return MakeViewsPlan(cohort);
    default:
      return MakeTablesPlan(cohort, methods);
  }
}

std::string
CohortExperiment::ClaimFolder(const std::vector<ExperimentMethod> & methods) const
{
  const fs::path  folder = fs::u8path(m_OutputDirectory);
  std::error_code error;
  fs::create_directories(folder / "cases", error);
  if (error)
  {
    itkDentalInputErrorMacro(
      m_OutputDirectory, "", "can't be written: " + error.message(), "choose another output folder");
  }
  Json manifest;
  manifest["schema"] = "dentalscr-experiment/1";
  manifest["software"] = DentalSCRVersion;
  manifest["study"] = NameOf(m_Study);
  manifest["from"] =
    m_CaseDirectory.empty() ? std::string() : fs::absolute(fs::u8path(m_CaseDirectory)).lexically_normal().string();
  const bool drawsLevel = m_CaseDirectory.empty() && !IsAboutRobust(m_Study);
  manifest["level"] = drawsLevel ? m_Level.name : "";
  // Null where all are those of the level's table: a folder that was begun with others is told apart either way.
  manifest["parameters"] =
    drawsLevel && m_Level != DentalPhantomLevel::Named(m_Level.name) ? Json::parse(m_Level.ToJson()) : Json();
  manifest["seed"] = m_Seed;
  manifest["methods"] = Json::array();
  for (const ExperimentMethod & method : methods)
  {
    manifest["methods"].push_back(method.name);
  }
  if (m_Study == StudyEnum::Capture)
  {
    manifest["starts"] = m_NumberOfStarts;
  }
  const std::string file = (folder / "experiment.json").string();
  if (fs::exists(file, error))
  {
    Json              before;
    const std::string text = ReadTextFile(file, "an experiment");
    try
    {
      JsonDocument::Verify(text, file);
      before = Json::parse(text);
    }
    catch (const DentalInputError &)
    {
      itkDentalInputErrorMacro(file, "", "is not what an experiment writes", "name a new output folder");
    }
    for (const auto & item : manifest.items())
    {
      const Json theirs = before.is_object() && before.contains(item.key()) ? before[item.key()] : Json();
      if (theirs != item.value())
      {
        itkDentalInputErrorMacro(file,
                                 item.key(),
                                 "the folder holds an experiment with " + theirs.dump() + ", not " +
                                   item.value().dump(),
                                 "name a new output folder, or resume with the options of that experiment");
      }
    }
  }
  else
  {
    if (!fs::is_empty(folder / "cases", error))
    {
      itkDentalInputErrorMacro(
        (folder / "cases").string(), "", "holds files of an unknown experiment", "name a new output folder");
    }
    WriteFileAtomically(file, manifest.dump(1) + '\n');
  }
  return manifest.dump();
}

void
CohortExperiment::RunCases(ExperimentPlan & plan, const std::string & key)
{
  const std::size_t count = plan.GetCohort().size();
  const fs::path    folder = fs::u8path(m_OutputDirectory) / "cases";
  const auto        fileOf = [&](std::size_t i) { return (folder / (plan.GetCohort().GetId(i) + ".json")).string(); };

  // With the digest of its files: a case that was edited is run again.
  std::vector<std::string> keys;
  for (std::size_t i = 0; i < count; ++i)
  {
    keys.push_back(key + plan.GetCohort().GetInputKey(i));
  }

  std::vector<std::size_t> open;
  m_NumberOfResumedCases = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    std::error_code error;
    bool            there = false;
    if (fs::exists(fileOf(i), error))
    {
      try
      {
        const std::string text = ReadTextFile(fileOf(i), "a case of an experiment");
        JsonDocument::Verify(text, fileOf(i));
        plan.Accept(i, text, keys[i]);
        there = true;
      }
      catch (const std::exception &)
      {
        // Whatever it is, it is replaced.
      }
    }
    if (there)
    {
      ++m_NumberOfResumedCases;
    }
    else
    {
      open.push_back(i);
    }
  }

  /** A case that is computed, by a thread: what is written last is read first. */
  struct JobType
  {
    std::thread         thread;
    std::atomic<double> part{ 0.0 };
    std::string         text;
    std::exception_ptr  problem;
    std::atomic<bool>   hasEnded{ false };
  };
  std::map<std::size_t, JobType> jobs;
  std::size_t                    done = 0;
  std::atomic<bool>              abort{ false };
  JobQueue                       queue;
  queue.watch = [&]() {
    m_CurrentStage = std::to_string(count - open.size() + done) + " of " + std::to_string(count) + " cases";
    double inParts = 0.0;
    for (const auto & job : jobs)
    {
      inParts += job.second.part;
    }
    const auto progress =
      static_cast<float>((static_cast<double>(count - open.size() + done) + inParts) / static_cast<double>(count));
    this->UpdateProgress(0.98F * progress);
    if (this->GetAbortGenerateData())
    {
      abort = true;
      throw ProcessAborted(__FILE__, __LINE__);
    }
  };
  queue.begin = [&](std::size_t k) {
    JobType &         job = jobs[k];
    const std::size_t i = open[k];
    const auto        work = [&, i]() {
      try
      {
        job.text = plan.Compute(
          i, keys[i], ExperimentMonitor([&abort]() { return abort.load(); }, [&job](double part) { job.part = part; }));
        WriteFileAtomically(fileOf(i), job.text);
      }
      catch (...)
      {
        job.problem = std::current_exception();
      }
      job.hasEnded = true;
    };
    std::vector<std::thread> threads;
    if (StartThreads(1, work, threads) == 1)
    {
      job.thread = std::move(threads.front());
    }
    else
    {
      // On this one, then, which tells of no progress meanwhile.
      work();
    }
    return true;
  };
  queue.hasEnded = [&](std::size_t k) {
    JobType & job = jobs.at(k);
    if (!job.hasEnded)
    {
      return false;
    }
    if (job.thread.joinable())
    {
      job.thread.join();
    }
    const std::string        text = std::move(job.text);
    const std::exception_ptr problem = job.problem;
    jobs.erase(k);
    if (problem)
    {
      std::rethrow_exception(problem);
    }
    plan.Accept(open[k], text, keys[open[k]]);
    ++done;
    return true;
  };
  queue.end = [&]() {
    // Of a failure the others' cases are completed, and stand in the folder; of an abort they end at their next word.
    for (auto & job : jobs)
    {
      if (job.second.thread.joinable())
      {
        job.second.thread.join();
      }
    }
  };
  queue.Run(open.size(), std::max<ThreadIdType>(1, this->GetNumberOfWorkUnits()));
}

/** Takes away the page and all pictures of an earlier run, which may have been of fewer cases. */
void
CohortExperiment::RemovePage() const
{
  const fs::path folder = fs::u8path(m_OutputDirectory);
  const auto     remove = [&folder](const char * name) {
    std::error_code error;
    fs::remove(folder / name, error);
    if (error)
    {
      itkDentalInputErrorMacro(
        (folder / name).u8string(), "", "is of an earlier run and can't be removed: " + error.message(), "remove it");
    }
  };
  remove("index.html");
  for (const ExperimentPicture & picture : ExperimentPictures)
  {
    remove(picture.fileName);
  }
}

void
CohortExperiment::Update()
{
  // Its inputs and outputs are files: each call runs.
  this->ResetPipeline();
  this->SetAbortGenerateData(false);
  this->InvokeEvent(StartEvent());
  try
  {
    this->GenerateData();
  }
  catch (const ProcessAborted &)
  {
    this->InvokeEvent(AbortEvent());
    throw;
  }
  this->UpdateProgress(1.0F);
  this->InvokeEvent(EndEvent());
}

void
CohortExperiment::GenerateData()
{
  m_WrittenFiles.clear();
  const auto         plan = this->MakePlan();
  const OutputFolder owned(m_OutputDirectory);
  const std::string  key = this->ClaimFolder(plan->GetMethods());
  this->RunCases(*plan, key);

  m_CurrentStage = "tables";
  this->UpdateProgress(0.98F);
  // All of them in memory before the first is written.
  const std::map<std::string, std::string> files = plan->MakeFiles();
  this->RemovePage();
  for (const auto & file : files)
  {
    WriteFileAtomically((fs::u8path(m_OutputDirectory) / file.first).string(), file.second);
    m_WrittenFiles.push_back(file.first);
  }
  if (m_DrawFigures)
  {
    m_CurrentStage = "figures";
    this->UpdateProgress(0.99F);
    const auto figures = plan->DrawFigures(m_OutputDirectory, [this]() {
      this->UpdateProgress(0.99F);
      return this->GetAbortGenerateData();
    });
    m_WrittenFiles.insert(m_WrittenFiles.end(), figures.begin(), figures.end());
  }
}

void
CohortExperiment::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfCases: " << m_NumberOfCases << std::endl;
  os << indent << "Seed: " << m_Seed << std::endl;
  os << indent << "Level: " << m_Level.name << std::endl;
  os << indent << "CaseDirectory: " << m_CaseDirectory << std::endl;
  os << indent << "OutputDirectory: " << m_OutputDirectory << std::endl;
  os << indent << "Study: " << m_Study << std::endl;
  os << indent << "NumberOfStarts: " << m_NumberOfStarts << std::endl;
  os << indent << "Methods:";
  for (const std::string & method : m_Methods)
  {
    os << ' ' << method;
  }
  os << std::endl;
  os << indent << "DrawFigures: " << (m_DrawFigures ? "On" : "Off") << std::endl;
  os << indent << "CurrentStage: " << m_CurrentStage << std::endl;
  os << indent << "WrittenFiles: " << m_WrittenFiles.size() << std::endl;
  os << indent << "NumberOfResumedCases: " << m_NumberOfResumedCases << std::endl;
}
} // namespace itk

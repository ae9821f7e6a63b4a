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
#ifndef itkExperimentPlan_h
#define itkExperimentPlan_h

#include "itkDentalPhantomCaseSource.h"
#include "itkExperimentMethod.h"
#include "itkExperimentMonitor.h"
#include "itkExperimentRecord.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace itk
{
/** Where the cases of an experiment come from. */
struct ExperimentCohort
{
  /** Of simulated cases, before their seed; the level's where empty. */
  std::string        name;
  DentalPhantomLevel level;
  std::uint64_t      seed{ 1 };
  std::size_t        count{ 0 };
  /** Case files with their names instead, where not empty. */
  std::vector<std::pair<std::string, std::string>> files;

  std::size_t
  size() const
  {
    return files.empty() ? count : files.size();
  }
  bool
  IsSimulated() const
  {
    return files.empty();
  }
  std::string
  GetId(std::size_t i) const;
  /** Another where the files of the case were edited; empty for a simulated one. */
  std::string
  GetInputKey(std::size_t i) const;
  /** Throws ProcessAborted where isAborted gives true meanwhile. */
  ExperimentCase
  Make(std::size_t                   i,
       bool                          withRadiograph,
       const std::function<bool()> & isAborted,
       const ExperimentVariation &   variation = ExperimentVariation()) const;
  /** In words. */
  std::string
  Describe() const;
};

const char *
NameOf(DentalPhantomCaseSource::CohortEnum level);

/** \class ExperimentPlan
 * \brief A study case by case: what to compute for each, and the files that follow from all. */
class ExperimentPlan
{
public:
  using AbortType = std::function<bool()>;

  explicit ExperimentPlan(ExperimentCohort cohort, std::vector<ExperimentMethod> methods)
    : m_Cohort(std::move(cohort))
    , m_Methods(std::move(methods))
  {}
  virtual ~ExperimentPlan();

  const ExperimentCohort &
  GetCohort() const
  {
    return m_Cohort;
  }
  const std::vector<ExperimentMethod> &
  GetMethods() const
  {
    return m_Methods;
  }

  /** Called from several threads; the record as text. Throws ProcessAborted where the monitor does. */
  virtual std::string
  Compute(std::size_t i, const std::string & key, const ExperimentMonitor & monitor) const = 0;

  /** Takes the record of a case; throws std::exception where it is none, or another experiment's. */
  virtual void
  Accept(std::size_t i, const std::string & text, const std::string & key) = 0;

  /** Every file by name, when all cases were accepted. */
  virtual std::map<std::string, std::string>
  MakeFiles() const = 0;

  /** Pictures, straight into the folder; returns their names. */
  virtual std::vector<std::string>
  DrawFigures(const std::string & folder, const AbortType & abort) const;

protected:
  /** Runs it; what a case can't do comes back in words, empty where all went well. ProcessAborted passes. */
  static std::string
  Try(const std::function<void()> & work);

  /** A paragraph that lists the cases that could not be used; empty where there are none. */
  static std::string
  DescribeFailures(const std::vector<ExperimentRecord> & records);

  /** Whether a method needs the radiograph. */
  static bool
  NeedsRadiograph(const std::vector<ExperimentMethod> & methods);

private:
  ExperimentCohort              m_Cohort;
  std::vector<ExperimentMethod> m_Methods;
};

std::unique_ptr<ExperimentPlan>
MakeTablesPlan(const ExperimentCohort & cohort, const std::vector<ExperimentMethod> & methods);
std::unique_ptr<ExperimentPlan>
MakeCapturePlan(const ExperimentCohort &              cohort,
                const std::vector<ExperimentMethod> & methods,
                unsigned int                          numberOfStarts);
std::unique_ptr<ExperimentPlan>
MakeSensitivityPlan(const ExperimentCohort & cohort, const std::vector<ExperimentMethod> & methods);
std::unique_ptr<ExperimentPlan>
MakeAblationPlan(const ExperimentCohort & cohort);
std::unique_ptr<ExperimentPlan>
MakeCoveragePlan(const ExperimentCohort & cohort);
std::unique_ptr<ExperimentPlan>
MakeVerdictPlan(const ExperimentCohort & cohort);
std::unique_ptr<ExperimentPlan>
MakePracticePlan(const ExperimentCohort & cohort);
std::unique_ptr<ExperimentPlan>
MakeViewsPlan(const ExperimentCohort & cohort);
} // namespace itk

#endif

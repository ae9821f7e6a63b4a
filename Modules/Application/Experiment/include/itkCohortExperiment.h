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
#ifndef itkCohortExperiment_h
#define itkCohortExperiment_h

#include "ExperimentExport.h"
#include "itkDentalPhantomCaseSource.h"
#include "itkExperimentMethod.h"

#include "itkProcessObject.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace itk
{
class ExperimentPlan;

/** \class CohortExperimentEnums
 * \brief What an experiment asks.
 * \ingroup Experiment
 */
class CohortExperimentEnums
{
public:
  enum class Study : uint8_t
  {
    /** The paper's three tables and the statistics. */
    Tables,
    /** Capture range and success rate over seeded starts (van de Kraats et al. 2005). */
    Capture,
    /** Error against what is wrong with the input. */
    Sensitivity,
    /** Preset robust with one ingredient at a time switched off. */
    Ablation,
    /** Accuracy of preset robust, coverage of its regions, its verdict, on every kind of case. */
    Coverage,
    /** Its verdict on good cases of every kind and on wrong inputs. */
    Verdict,
    /** What it makes of the landmarks and standard tracings that every clinic has, by kind of input. */
    Practice,
    /** What a frontal radiograph adds to each degree of freedom. */
    Views
  };
};

/** \class CohortExperiment
 * \brief Runs methods on a cohort and writes tables, statistics and plot data into a folder.
 *
 * The cohort is simulated (case i has the seed Seed + i, so that `dentalscr phantom` makes the same case), or a folder
 * of case files with 2-D landmarks. Cases run in parallel, each on one thread; each leaves a file in the folder's
 * cases/ when it is complete, and a run that finds such files goes on from them. What the folder was begun with stands
 * in its experiment.json: other settings (but for another number of cases) are refused. Tables appear when all cases
 * are there, each file whole. All files but cases/ and times.csv hold the same bits for the same settings, whatever the
 * number of threads and interruptions.
 *
 * Events: StartEvent, ProgressEvent at least ten times a second (GetCurrentStage()), EndEvent. AbortGenerateDataOn()
 * ends the run with ProcessAborted; what was complete is kept.
 *
 * Errors: DentalInputError for an unknown method, no case, a folder that can't be written or belongs to another
 * experiment.
 *
 * \ingroup Experiment
 */
class Experiment_EXPORT CohortExperiment : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(CohortExperiment);

  using Self = CohortExperiment;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(CohortExperiment, ProcessObject);

  using CohortEnum = DentalPhantomCaseSource::CohortEnum;
  using StudyEnum = CohortExperimentEnums::Study;

  /** Default 34, the paper's. */
  itkSetMacro(NumberOfCases, unsigned int);
  itkGetConstMacro(NumberOfCases, unsigned int);

  /** Of the first case and of the statistics. Default 1. */
  itkSetMacro(Seed, std::uint64_t);
  itkGetConstMacro(Seed, std::uint64_t);

  /** Default Typical. Ablation, Coverage, Verdict, Practice and Views have levels of their own. */
  void
  SetLevel(CohortEnum level);
  CohortEnum
  GetLevel() const;

  /** The same with any parameter of the phantom changed. A frontal radiograph is not part of these cases: Update()
   * throws where one is asked for. */
  void
  SetPhantomLevel(const DentalPhantomLevel & level);
  const DentalPhantomLevel &
  GetPhantomLevel() const
  {
    return m_Level;
  }

  /** A folder whose subfolders hold case.json each (or one that does itself): used, all of them, instead of simulated
   * cases. Tables and Capture only. A case whose files were edited is run again when a folder is resumed. */
  itkSetStringMacro(CaseDirectory);
  itkGetStringMacro(CaseDirectory);

  /** Where everything goes; made where it is missing. */
  itkSetStringMacro(OutputDirectory);
  itkGetStringMacro(OutputDirectory);
  /** What is asked; the methods and the tables follow from it. */
  itkSetEnumMacro(Study, StudyEnum);
  itkGetEnumMacro(Study, StudyEnum);

  /** Starts a case and jaw of the study of the capture range; intensity-driven methods take the first two cases only.
   * Default 100. */
  itkSetClampMacro(NumberOfStarts, unsigned int, 10, 100000);
  itkGetConstMacro(NumberOfStarts, unsigned int);

  /** Names of methods and groups; see SelectExperimentMethods(). Default "default"; Sensitivity takes its own default.
   * Ablation, Coverage, Verdict, Practice and Views are about preset robust alone and take none. */
  void
  SetMethods(const std::vector<std::string> & names);
  const std::vector<std::string> &
  GetMethods() const
  {
    return m_Methods;
  }

  /** Draw the qualitative figure of representative cases (study Tables). Default on. */
  itkSetMacro(DrawFigures, bool);
  itkGetConstMacro(DrawFigures, bool);
  itkBooleanMacro(DrawFigures);

  /** "12 of 34 cases". */
  const std::string &
  GetCurrentStage() const
  {
    return m_CurrentStage;
  }

  /** Valid after Update(): names of the files in the folder, and how many cases were there before. */
  const std::vector<std::string> &
  GetWrittenFiles() const
  {
    return m_WrittenFiles;
  }
  itkGetConstMacro(NumberOfResumedCases, unsigned int);
  /** Runs the cases and writes the tables. */
  void
  Update() override;

protected:
  CohortExperiment() = default;
  ~CohortExperiment() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;
  void
  GenerateData() override;

private:
  std::unique_ptr<ExperimentPlan>
  MakePlan() const;
  /** Throws where the folder belongs to another experiment; returns the key of this one's records. */
  std::string
  ClaimFolder(const std::vector<ExperimentMethod> & methods) const;
  void
  RemovePage() const;
  void
  RunCases(ExperimentPlan & plan, const std::string & key);

  unsigned int             m_NumberOfCases{ 34 };
  std::uint64_t            m_Seed{ 1 };
  DentalPhantomLevel       m_Level;
  std::string              m_CaseDirectory;
  std::string              m_OutputDirectory;
  StudyEnum                m_Study{ StudyEnum::Tables };
  unsigned int             m_NumberOfStarts{ 100 };
  std::vector<std::string> m_Methods{ "default" };
  bool                     m_DrawFigures{ true };
  std::string              m_CurrentStage;
  std::vector<std::string> m_WrittenFiles;
  unsigned int             m_NumberOfResumedCases{ 0 };
};

Experiment_EXPORT std::ostream &
                  operator<<(std::ostream & os, CohortExperimentEnums::Study study);
} // namespace itk

#endif

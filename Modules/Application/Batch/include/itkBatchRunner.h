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
#ifndef itkBatchRunner_h
#define itkBatchRunner_h

#include "BatchExport.h"
#include "itkBatchRecord.h"

#include "itkProcessObject.h"

#include <memory>
#include <string>
#include <vector>

namespace itk
{
class OutputFolder;

/** \class BatchRunner
 * \brief Registers many cases, each by a process of its own, so that what breaks one leaves the others alone.
 *
 * A process is `dentalscr register` with the case's arguments, those of SetArguments() and a folder of its own below
 * OutputFolder; what lies there of an earlier run is removed when it starts. As many run at once as NumberOfJobs says,
 * each with its share of the cores, which changes no result. What each has said stands in the hidden folder `.batch` of
 * the output, beside a record of what was run; with Resume a case is left as it is whose record and result are there,
 * made by this version and the same arguments of files that have not changed since. The folder belongs to one runner at
 * a time. A process that ends without a result it could be asked for is an unusable case, whatever its exit code.
 *
 * Events: ProgressEvent at least ten times a second while it waits, IterationEvent after each case (GetRecord()).
 * AbortGenerateDataOn() ends the processes, and Update() by ProcessAborted; what was complete is kept.
 *
 * Errors (DentalInputError): a folder that cannot be written or is another runner's.
 *
 * \ingroup Batch
 */
class Batch_EXPORT BatchRunner : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(BatchRunner);

  using Self = BatchRunner;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(BatchRunner, ProcessObject);

  /** What is run, in this order. */
  void
  SetCases(const std::vector<BatchCase> & cases);
  /** The program dentalscr, and what stands before its verb: "python3", "-m", "dentalscr" is one as well. */
  void
  SetProgram(const std::vector<std::string> & words);
  const std::vector<std::string> &
  GetProgram() const
  {
    return m_Program;
  }
  /** For every case: options of `register`. */
  void
  SetArguments(const std::vector<std::string> & arguments);
  itkSetStringMacro(OutputFolder);
  itkGetStringMacro(OutputFolder);
  /** Cores that all of them share; 0 (default): all that there are. A node of a cluster may have more than a job of
   * its queue was given. */
  itkSetMacro(NumberOfCores, unsigned int);
  itkGetConstMacro(NumberOfCores, unsigned int);
  /** Processes at a time; 0 (default): one a core. */
  itkSetMacro(NumberOfJobs, unsigned int);
  itkGetConstMacro(NumberOfJobs, unsigned int);
  itkSetMacro(Resume, bool);
  itkGetConstMacro(Resume, bool);
  itkBooleanMacro(Resume);
  /** Where another runner is at work in the folder: wait until it has ended. Default off. */
  itkSetMacro(WaitForFolder, bool);
  itkGetConstMacro(WaitForFolder, bool);
  itkBooleanMacro(WaitForFolder);

  /** In the order of the cases, as far as they are done. */
  std::vector<BatchRecord>
  GetRecords() const;
  /** The one that was done last; of an IterationEvent. */
  const BatchRecord &
  GetRecord() const
  {
    return m_Record;
  }
  std::size_t
  GetNumberOfFinishedCases() const
  {
    return m_NumberOfFinishedCases;
  }
  std::size_t
  GetNumberOfCases() const
  {
    return m_Cases.size();
  }
  /** Estimated from those that were run; negative where none was. */
  double
  GetSecondsLeft() const;

  /** There is nothing that it could be asked for but to run. */
  void
  Update() override;

protected:
  BatchRunner();
  ~BatchRunner() override;
  void
  VerifyPreconditions() ITKv5_CONST override;
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  struct ChildType;

  bool
  KeepEarlier(std::size_t index);
  /** The process of a runner that was killed ends by itself, a moment later: it still owns its case's folder. */
  void
  WaitForEarlierProcess(const std::string & folder) const;
  ChildType
  Start(std::size_t index, unsigned int threads) const;
  void
  Finish(std::size_t index, int exitCode, double seconds);

  /** Owned from Update() to the end of this object: summaries are written into it after the last case. */
  std::unique_ptr<OutputFolder> m_Folder;

  std::vector<BatchCase>   m_Cases;
  std::vector<std::string> m_Arguments;
  std::vector<std::string> m_Program;
  std::string              m_OutputFolder;
  unsigned int             m_NumberOfCores{ 0 };
  unsigned int             m_NumberOfJobs{ 0 };
  bool                     m_Resume{ false };
  bool                     m_WaitForFolder{ false };
  std::vector<BatchRecord> m_Records;
  std::vector<bool>        m_IsDone;
  BatchRecord              m_Record;
  std::size_t              m_NumberOfFinishedCases{ 0 };
  std::size_t              m_NumberOfRunCases{ 0 };
  double                   m_SecondsSinceStart{ 0.0 };
};
} // namespace itk

#endif

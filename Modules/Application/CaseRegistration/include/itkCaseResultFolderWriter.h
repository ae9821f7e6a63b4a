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
#ifndef itkCaseResultFolderWriter_h
#define itkCaseResultFolderWriter_h

#include "itkCaseResultObject.h"

#include "itkProcessObject.h"

#include <memory>
#include <string>
#include <vector>

namespace itk
{
class OutputFolder;

/** \class CaseResultFolderWriter
 * \brief Writes everything that a case's result is made of into a folder, whole or not at all.
 *
 * Input: what CaseRegistration gives. Documentation/FileFormats.md lists the files. Errors: DentalInputError where the
 * folder cannot be written.
 *
 * \ingroup CaseRegistration
 */
class CaseRegistration_EXPORT CaseResultFolderWriter : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(CaseResultFolderWriter);

  using Self = CaseResultFolderWriter;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(CaseResultFolderWriter, ProcessObject);

  using InputType = CaseResultObject;

  using Superclass::SetInput;
  /** What is written. */
  void
  SetInput(const InputType * input);
  const InputType *
  GetInput() const;

  /** Made where it is not there; files of an earlier result in it are replaced. */
  itkSetStringMacro(FolderName);
  itkGetStringMacro(FolderName);

  /** Write what is for people as well: overlays, scans in the cephalostat frame, the page. Default on. */
  itkSetMacro(WriteReport, bool);
  itkGetConstMacro(WriteReport, bool);
  itkBooleanMacro(WriteReport);

  /** Write report.html, where what is for people is written. Default on. */
  itkSetMacro(WritePage, bool);
  itkGetConstMacro(WritePage, bool);
  itkBooleanMacro(WritePage);

  /** Leave paths and names out of all files. Default off. */
  itkSetMacro(Anonymous, bool);
  itkGetConstMacro(Anonymous, bool);
  itkBooleanMacro(Anonymous);

  /** The words that the program was called with, for report.json; not written where it is to be anonymous. */
  void
  SetCommandLine(const std::vector<std::string> & words)
  {
    if (m_CommandLine != words)
    {
      m_CommandLine = words;
      this->Modified();
    }
  }
  const std::vector<std::string> &
  GetCommandLine() const
  {
    return m_CommandLine;
  }

  /** Owns the folder from now until it is written (OutputFolder), for a run that takes its time: another one that wants
   * the same folder is told at once, and not when both are done. */
  void
  ClaimFolder();

  /** A writer has no output: this brings its input up to date and writes, each time. */
  void
  Update() override;

protected:
  CaseResultFolderWriter();
  ~CaseResultFolderWriter() override;
  void
  VerifyPreconditions() ITKv5_CONST override;
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  std::string              m_FolderName;
  bool                     m_WriteReport{ true };
  bool                     m_WritePage{ true };
  bool                     m_Anonymous{ false };
  std::vector<std::string> m_CommandLine;

  std::unique_ptr<OutputFolder> m_Folder;
};
} // namespace itk

#endif

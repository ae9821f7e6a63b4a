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
#ifndef itkCaseRegistration_h
#define itkCaseRegistration_h

#include "CaseRegistrationExport.h"
#include "itkCaseResultObject.h"
#include "itkDentalCaseObject.h"
#include "itkPoseRegistrationTypes.h"
#include "itkRegistrationIterationInformation.h"

#include "itkProcessObject.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace itk
{
class DentalFrameObject;
class PoseRegistrationMethodBase;
class ScanCheckFilter;
template <typename TMesh>
class UMidlineDentalAxisFilter;

/** \class CaseRegistration
 * \brief Takes a case through the chain of a preset: dental axis, projection, contour, registration, landmarks,
 * verdict.
 *
 * One class for the program and for Python: a composite that wires the process objects of the chain, each of which
 * stands for itself in its module, and computes nothing of its own. Input: a case,
 * from DentalCaseReader; output: its result, for CaseResultFolderWriter. A jaw that can't be registered does not stop
 * the other: its status and reasons say why.
 *
 * Events: StartEvent, ProgressEvent, MultiResolutionIterationEvent where a stage begins (GetCurrentStage()),
 * IterationEvent at each of the method that runs, EndEvent; AbortGenerateDataOn() ends the run with ProcessAborted.
 * What RegistrationIterationInformation tells is that of the method which runs or ran last, its level among it: a
 * RegistrationIterationCommand logs a case as it logs a method.
 *
 * Dental axis and checks of the scans depend on the scans alone. They are kept: who registers again what changed of the
 * drawing, in a copy of the data with the same scans, has the same result in two thirds of the time.
 *
 * \ingroup CaseRegistration
 */
class CaseRegistration_EXPORT CaseRegistration
  : public ProcessObject
  , public RegistrationIterationInformation
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(CaseRegistration);

  using Self = CaseRegistration;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(CaseRegistration, ProcessObject);

  using DataPointer = DentalCaseObject::DataPointer;
  using InputType = DentalCaseObject;
  using OutputType = CaseResultObject;
  using Superclass::MakeOutput;
  using DataObjectPointer = Superclass::DataObjectPointer;
  using DataObjectPointerArraySizeType = Superclass::DataObjectPointerArraySizeType;
  /** The case, as DentalCaseReader gives it. */
  using Superclass::SetInput;
  void
  SetInput(const InputType * input);
  const InputType *
  GetInput() const;
  /** The same for a case that is no pipeline's: makes the input of it. */
  void
  SetData(DataPointer data);
  /** Of the input; null where it has none. */
  const DentalCaseData *
  GetData() const;
  /** The result; it has a jaw each that the case has, also those that could not be registered. */
  OutputType *
  GetOutput();
  const OutputType *
  GetOutput() const;
  /** Which chain is run: the paper's, or the robust one (default). */
  itkSetEnumMacro(Preset, CasePresetEnum);
  itkGetEnumMacro(Preset, CasePresetEnum);

  /** Points of the resampled silhouette (upper, lower): the paper's 441 and 439. */
  itkSetMacro(NumberOfUpperContourPoints, unsigned int);
  itkGetConstMacro(NumberOfUpperContourPoints, unsigned int);
  itkSetMacro(NumberOfLowerContourPoints, unsigned int);
  itkGetConstMacro(NumberOfLowerContourPoints, unsigned int);

  /** Take the paper's silhouette from the surface DRR (default) or exactly from the mesh. */
  itkSetMacro(UseSurfaceDRR, bool);
  itkGetConstMacro(UseSurfaceDRR, bool);
  itkBooleanMacro(UseSurfaceDRR);

  /** Every ingredient of preset Robust; PoseRegistrationOptionTable sets them by name. What the case says of itself
   * (traced side, manual control, whether the jaws share a frame), threads and callbacks are set over it. So is
   * kappaSigma where it is the default and the pixel spacing is a DICOM file's, but not the detector's: 5 %.
   * SetOption("kappaSigma=...") holds in any case. Other presets ignore all of it, with a warning. */
  void
  SetPoseOptions(const PoseRegistrationOptions & options);
  const PoseRegistrationOptions &
  GetPoseOptions() const
  {
    return m_PoseOptions;
  }

  /** An ingredient of preset Robust. */
  struct OptionType
  {
    std::string name; /**< As the options of the program and of Python name it. */
    /** In a few words, with the unit. */
    std::string description;
    std::string defaultValue;
  };

  /** All that SetOption() knows. */
  static std::vector<OptionType>
  GetOptions();

  /** One of them, "NAME=VALUE". Throws std::invalid_argument that lists what there is. */
  void
  SetOption(const std::string & assignment);

  /** Preset Robust: called with the method of the chain when its inputs and options are set, before it runs. It may
   * exchange the method's parts, as a kernel with SetRobustKernel() or hypotheses with ClearHypotheses(): whatever
   * PoseRegistrationMethodBase takes. Other presets do not call it. */
  using PoseMethodCallbackType = std::function<void(PoseRegistrationMethodBase &)>;
  void
  SetPoseMethodCallback(PoseMethodCallbackType callback);

  /** Preset Robust: move the midline plane of the dental axis to the scan's mirror plane. Default on. */
  itkSetMacro(RefineMidline, bool);
  itkGetConstMacro(RefineMidline, bool);
  itkBooleanMacro(RefineMidline);

  /** Valid after Update(). */
  const CaseResult &
  GetResult() const
  {
    return this->GetOutput()->Get();
  }

  /** What runs now, e.g. "upper: registration". */
  const std::string &
  GetCurrentStage() const
  {
    return m_CurrentStage;
  }

  unsigned int
  GetCurrentLevel() const override;
  unsigned int
  GetCurrentCandidate() const override;
  std::size_t
  GetOptimizerIteration() const override;
  double
  GetMetricValue() const override;
  OptimizerParameters<double>
  GetOptimizerPosition() const override;
  double
  GetStepLength() const override;
  bool
  GetStepAccepted() const override;
  std::string
  GetOptimizerStopConditionDescription() const override;

  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

  /** Reaches the process object that runs. */
  void
  SetAbortGenerateData(bool abort) override;

protected:
  CaseRegistration();
  ~CaseRegistration() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;
  void
  VerifyPreconditions() ITKv5_CONST override;
  void
  GenerateData() override;

private:
  using JawEnum = ToothCode::JawEnum;
  using AxisType = UMidlineDentalAxisFilter<DentalCaseData::MeshType>;

  void
  EnterStage(const std::string & stage, float progress);
  /** The dental axis of the scans, that of the last run where nothing that it depends on is another. */
  void
  PrepareAxis();
  /** What can be said of the scans before anything is registered. */
  void
  CheckScans();
  /** Whether the picture is the one that was drawn on. */
  void
  CheckPicture();
  /** Whether outlines of whole teeth and landmarks of the same teeth are of one place. */
  void
  CheckOutlinesByLandmarks();
  /** Drafts that nobody mended, where they are too few for a finding. */
  void
  WarnOfDrafts();
  void
  RegisterBySimilarity();
  void
  RegisterByPose();
  /** What a method says of itself, kept: it does not outlive its stage. */
  struct IterationType
  {
    unsigned int                level{ 0 };
    unsigned int                candidate{ 0 };
    std::size_t                 iteration{ 0 };
    double                      value{ 0.0 };
    OptimizerParameters<double> position;
    double                      stepLength{ 0.0 };
    bool                        accepted{ true };
    std::string                 stopCondition;
  };
  void
  KeepIteration(const RegistrationIterationInformation & method);
  /** Updates a process object between two values of this one's progress. */
  void
  Run(ProcessObject * process, float from, float to);

  DataPointer             m_Data;
  CasePresetEnum          m_Preset{ CasePresetEnum::Robust };
  unsigned int            m_NumberOfUpperContourPoints{ 441 };
  unsigned int            m_NumberOfLowerContourPoints{ 439 };
  bool                    m_UseSurfaceDRR{ true };
  PoseRegistrationOptions m_PoseOptions;
  PoseMethodCallbackType  m_PoseMethodCallback;
  bool                    m_KappaSigmaIsGiven{ false };
  bool                    m_RefineMidline{ true };
  CaseResult              m_Result;
  SmartPointer<AxisType>  m_Axis;
  std::string             m_CurrentStage;
  IterationType           m_Iteration;
  /** Of the axis' frames. */
  SmartPointer<ScanCheckFilter> m_Checks;
  /** What runs, to be told of an abort; null between. */
  ProcessObject * m_Running{ nullptr };
};
} // namespace itk

#endif

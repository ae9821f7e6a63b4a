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
#include "itkCaseRegistration.h"

#include "itkAppendTexts.h"
#include "itkCaseJaws.h"
#include "itkCasePoseRegistration.h"
#include "itkCaseSimilarityRegistration.h"
#include "itkCheckWholeTeeth.h"
#include "itkCompareJawDrawings.h"
#include "itkDentalCaseFileReader.h"
#include "itkDentalInputError.h"
#include "itkDescribePlainly.h"
#include "itkLandmarksOffTeeth.h"
#include "itkPictureCheckFilter.h"
#include "itkPoseRegistrationOptionTable.h"
#include "itkPrincipalPointCheck.h"
#include "itkRegistrationVerdict.h"
#include "itkRigidTransformRows.h"
#include "itkScanCheckFilter.h"
#include "itkSortFindings.h"
#include "itkCommand.h"
#include "itkTimeProbe.h"
#include "itkTracingPixelSpacingFilter.h"
#include "itkUMidlineDentalAxisFilter.h"
#include "itkUnusedCaseControls.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <typeinfo>
#include <utility>

namespace itk
{
namespace
{
/** The one option that is not in PoseRegistrationOptions. */
constexpr char RefineMidlineName[] = "refineMidline";

/** "NAME=VALUE" of what is not the default. */
std::vector<std::string>
DescribeOptions(const PoseRegistrationOptions & options, bool refineMidline)
{
  std::vector<std::string> changes = PoseRegistrationOptionTable::GetChanges(options);
  if (!refineMidline)
  {
    changes.push_back(std::string(RefineMidlineName) + "=off");
  }
  return changes;
}

double
DraftedShareOf(const DentalCaseData & data, ToothCode::JawEnum jaw)
{
  const auto & contour = data.GetJaw(jaw).contour;
  return contour.IsNull() ? 0.0 : contour->GetDraftedShare();
}

/** Whether the given principal point is where ear rods are, seen from the jaws that were placed. */
void
JudgePrincipalPoint(const DentalCaseData & data, CaseResult & result)
{
  if (data.sources.principalPoint != ValueSourceEnum::Given)
  {
    return;
  }
  for (auto & entry : result.jaws)
  {
    JawResult & jaw = entry.second;
    // Of a jaw that lies elsewhere the place tells nothing.
    if (!jaw.registered || jaw.status == RegistrationStatusEnum::Failed)
    {
      continue;
    }
    // The jaw's middle is the origin of its UMDA frame, whose x axis is forward along the occlusal plane.
    const auto toMesh = ToRigidTransform(jaw.meshToUMDA, 1e-3)->GetInverseTransform();
    const auto toCephalostat = ToRigidTransform(jaw.meshToCephalostat, 1e-3);
    const auto place = [&](double x) {
      Point<double, 3> point;
      point.Fill(0.0);
      point[0] = x;
      return toCephalostat->TransformPoint(toMesh->TransformPoint(point));
    };
    const auto                middle = place(0.0);
    const auto                axis = place(1.0) - middle;
    JawSeenFromPrincipalPoint seen;
    seen.forward = middle[0];
    seen.down = -middle[2];
    seen.occlusalSlope = std::atan2(-axis[2], axis[0]);
    if (const auto rows = CheckRowOrder(result.geometry, data.imageSize, seen))
    {
      jaw.AddFinding(*rows);
    }
    else if (const auto finding = CheckPrincipalPoint(result.geometry, data.imageSize, seen))
    {
      jaw.AddFinding(*finding);
    }
  }
}
} // namespace

CaseRegistration::CaseRegistration()
{
  this->SetNumberOfRequiredInputs(1);
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
}

// Here, where what it holds is known.
CaseRegistration::~CaseRegistration() = default;

CaseRegistration::DataObjectPointer
CaseRegistration::MakeOutput(DataObjectPointerArraySizeType)
{
  return OutputType::New().GetPointer();
}

void
CaseRegistration::SetInput(const InputType * input)
{
  this->ProcessObject::SetNthInput(0, const_cast<InputType *>(input));
}

const CaseRegistration::InputType *
CaseRegistration::GetInput() const
{
  return itkDynamicCastInDebugMode<const InputType *>(this->GetPrimaryInput());
}

void
CaseRegistration::SetData(DataPointer data)
{
  if (this->GetInput() != nullptr && this->GetInput()->Get() == data)
  {
    return;
  }
  auto input = InputType::New();
  input->Set(std::move(data));
  this->SetInput(input);
}

const DentalCaseData *
CaseRegistration::GetData() const
{
  return this->GetInput() != nullptr ? this->GetInput()->Get().get() : nullptr;
}

CaseRegistration::OutputType *
CaseRegistration::GetOutput()
{
  return itkDynamicCastInDebugMode<OutputType *>(this->ProcessObject::GetOutput(0));
}

const CaseRegistration::OutputType *
CaseRegistration::GetOutput() const
{
  return itkDynamicCastInDebugMode<const OutputType *>(this->ProcessObject::GetOutput(0));
}

void
CaseRegistration::VerifyPreconditions() ITKv5_CONST
{
  if (this->GetInput() == nullptr)
  {
    itkExceptionMacro("There is no case: call SetInput() with the output of a DentalCaseReader, or SetData() with what "
                      "LoadDentalCase() returns.");
  }
  Superclass::VerifyPreconditions();
}

std::vector<CaseRegistration::OptionType>
CaseRegistration::GetOptions()
{
  std::vector<OptionType> options{
    { RefineMidlineName, "move the midline plane of the dental axis to the scan's mirror plane", "on" }
  };
  const PoseRegistrationOptions defaults;
  for (const auto & entry : PoseRegistrationOptionTable::GetEntries())
  {
    options.push_back({ entry.name, entry.description, PoseRegistrationOptionTable::Get(defaults, entry.name) });
  }
  return options;
}

void
CaseRegistration::SetPoseOptions(const PoseRegistrationOptions & options)
{
  m_PoseOptions = options;
  m_KappaSigmaIsGiven = options.kappaSigma != PoseRegistrationOptions().kappaSigma;
  this->Modified();
}

void
CaseRegistration::SetPoseMethodCallback(PoseMethodCallbackType callback)
{
  m_PoseMethodCallback = std::move(callback);
  this->Modified();
}

void
CaseRegistration::SetOption(const std::string & assignment)
{
  const std::size_t sign = assignment.find('=');
  const std::string name = assignment.substr(0, sign);
  if (sign != std::string::npos && name == RefineMidlineName)
  {
    this->SetRefineMidline(PoseRegistrationOptionTable::ParseSwitch(name, assignment.substr(sign + 1)));
    return;
  }
  const auto options = GetOptions();
  if (sign != std::string::npos &&
      std::none_of(options.begin(), options.end(), [&](const OptionType & option) { return option.name == name; }))
  {
    std::string known;
    for (const OptionType & option : options)
    {
      known += (known.empty() ? "" : ", ") + option.name;
    }
    throw std::invalid_argument("there is no option \"" + name + "\"; there are " + known);
  }
  PoseRegistrationOptionTable::Set(m_PoseOptions, assignment);
  m_KappaSigmaIsGiven = m_KappaSigmaIsGiven || name == "kappaSigma";
  this->Modified();
}

void
CaseRegistration::SetAbortGenerateData(bool abort)
{
  Superclass::SetAbortGenerateData(abort);
  if (m_Running != nullptr)
  {
    m_Running->SetAbortGenerateData(abort);
  }
}

void
CaseRegistration::Run(ProcessObject * process, float from, float to)
{
  auto progress = FunctionCommand::New();
  progress->SetCallback(
    [&](const EventObject &) { this->UpdateProgress(from + (to - from) * process->GetProgress()); });
  const auto observer = process->AddObserver(ProgressEvent(), progress);
  // What stands in the middle of an iterative method is of interest to whoever watches the whole.
  const auto * method = dynamic_cast<const RegistrationIterationInformation *>(process);
  auto         iteration = FunctionCommand::New();
  iteration->SetCallback([this, method](const EventObject & event) {
    // The exact type: a level of the method is an iteration event in ITK as well, and a level here is a stage of the
    // case.
    if (method != nullptr && typeid(event) == typeid(IterationEvent))
    {
      this->KeepIteration(*method);
      this->InvokeEvent(IterationEvent());
    }
  });
  const auto iterationObserver = process->AddObserver(IterationEvent(), iteration);
  m_Running = process;
  const auto end = [&]() {
    m_Running = nullptr;
    process->RemoveObserver(observer);
    process->RemoveObserver(iterationObserver);
    if (method != nullptr)
    {
      m_Iteration.stopCondition = method->GetOptimizerStopConditionDescription();
    }
  };
  try
  {
    process->Update();
  }
  catch (...)
  {
    end();
    throw;
  }
  end();
  // A process that had nothing left to do when it was asked to end has ended well; the case has not.
  if (this->GetAbortGenerateData())
  {
    throw ProcessAborted(__FILE__, __LINE__);
  }
}

void
CaseRegistration::KeepIteration(const RegistrationIterationInformation & method)
{
  m_Iteration.level = method.GetCurrentLevel();
  m_Iteration.candidate = method.GetCurrentCandidate();
  m_Iteration.iteration = method.GetOptimizerIteration();
  m_Iteration.value = method.GetMetricValue();
  m_Iteration.position = method.GetOptimizerPosition();
  m_Iteration.stepLength = method.GetStepLength();
  m_Iteration.accepted = method.GetStepAccepted();
}

unsigned int
CaseRegistration::GetCurrentLevel() const
{
  return m_Iteration.level;
}

unsigned int
CaseRegistration::GetCurrentCandidate() const
{
  return m_Iteration.candidate;
}

std::size_t
CaseRegistration::GetOptimizerIteration() const
{
  return m_Iteration.iteration;
}

double
CaseRegistration::GetMetricValue() const
{
  return m_Iteration.value;
}

OptimizerParameters<double>
CaseRegistration::GetOptimizerPosition() const
{
  return m_Iteration.position;
}

double
CaseRegistration::GetStepLength() const
{
  return m_Iteration.stepLength;
}

bool
CaseRegistration::GetStepAccepted() const
{
  return m_Iteration.accepted;
}

std::string
CaseRegistration::GetOptimizerStopConditionDescription() const
{
  return m_Iteration.stopCondition;
}

void
CaseRegistration::EnterStage(const std::string & stage, float progress)
{
  m_CurrentStage = stage;
  this->UpdateProgress(progress);
  this->InvokeEvent(MultiResolutionIterationEvent());
  if (this->GetAbortGenerateData())
  {
    throw ProcessAborted(__FILE__, __LINE__);
  }
}

void
CaseRegistration::PrepareAxis()
{
  const bool refines = m_Preset == CasePresetEnum::Robust && m_RefineMidline;
  const auto share = ToJawsShareFrame(m_Data->description.occlusion);
  if (m_Axis.IsNotNull() && m_Axis->GetUpperMesh() == m_Data->upper.mesh &&
      m_Axis->GetLowerMesh() == m_Data->lower.mesh && m_Axis->GetJawsShareFrame() == share &&
      m_Axis->GetRefineMidline() == refines && m_Axis->GetNumberOfWorkUnits() == this->GetNumberOfWorkUnits())
  {
    return;
  }
  // A new one: earlier results hold on to the frames of the old one.
  m_Axis = AxisType::New();
  m_Axis->SetUpperMesh(m_Data->upper.mesh);
  m_Axis->SetLowerMesh(m_Data->lower.mesh);
  m_Axis->SetJawsShareFrame(share);
  m_Axis->SetRefineMidline(refines);
  m_Axis->SetNumberOfWorkUnits(this->GetNumberOfWorkUnits());
  m_Axis->RequireArchesOff();
  m_Axis->TransformMeshesOff();
}

void
CaseRegistration::CheckScans()
{
  if (m_Data->upper.mesh.IsNull() && m_Data->lower.mesh.IsNull())
  {
    return;
  }
  if (m_Checks.IsNull())
  {
    m_Checks = ScanCheckFilter::New();
  }
  ScanCheckFilter * checks = m_Checks;
  checks->SetUpperMesh(m_Data->upper.mesh);
  checks->SetLowerMesh(m_Data->lower.mesh);
  checks->SetFrames(m_Axis->GetFrameOutput());
  checks->SetLandmarks(m_Data->landmarks3D);
  checks->SetMillimetresPerUnit(m_Data->description.millimetresPerUnit);
  checks->Update();
  for (auto & entry : m_Result.jaws)
  {
    for (const RegistrationFinding & finding : checks->GetFindings(entry.first))
    {
      entry.second.AddFinding(finding);
    }
  }
  m_Result.unusableLandmarks = checks->GetUnusableLandmarks();
  m_Result.notCheckable.insert(
    m_Result.notCheckable.end(), checks->GetNotCheckable().begin(), checks->GetNotCheckable().end());
}

void
CaseRegistration::CheckOutlinesByLandmarks()
{
  const auto hasOutlines = [this](ToothCode::JawEnum jaw) {
    const auto found = m_Result.jaws.find(jaw);
    return found != m_Result.jaws.end() && found->second.registered && !found->second.usedOutlines.empty();
  };
  if (m_Result.jawsShareFrame && hasOutlines(ToothCode::JawEnum::Upper) && hasOutlines(ToothCode::JawEnum::Lower))
  {
    if (const auto finding =
          FindOutlinesShortOfTheBite(*m_Data->upper.contour, *m_Data->lower.contour, *m_Result.geometry))
    {
      for (auto & entry : m_Result.jaws)
      {
        entry.second.AddFinding(*finding);
      }
    }
  }
  if (m_Data->cephalometricLandmarks.IsNull())
  {
    return;
  }
  for (const auto & entry : m_Result.jaws)
  {
    const auto & jaw = entry.second;
    if (!jaw.registered || jaw.usedOutlines.empty())
    {
      continue;
    }
    const auto finding = FindOutlinesApartFromLandmarks(
      *m_Data->GetJaw(entry.first).contour, entry.first, *m_Data->cephalometricLandmarks, *m_Result.geometry);
    if (finding)
    {
      // Jaws in one frame have one pose, which what is wrong with the drawing of either moves.
      for (auto & other : m_Result.jaws)
      {
        if (other.first == entry.first || m_Result.jawsShareFrame)
        {
          other.second.AddFinding(*finding);
        }
      }
    }
  }
}

void
CaseRegistration::CheckPicture()
{
  auto check = PictureCheckFilter::New();
  check->SetRadiograph(m_Data->image);
  check->SetUpperContour(m_Data->upper.contour);
  check->SetLowerContour(m_Data->lower.contour);
  check->SetGeometry(m_Result.geometry);
  check->Update();
  for (auto & entry : m_Result.jaws)
  {
    for (const RegistrationFinding & finding : check->GetFindings())
    {
      entry.second.AddFinding(finding);
    }
  }
  m_Result.notCheckable.insert(
    m_Result.notCheckable.end(), check->GetNotCheckable().begin(), check->GetNotCheckable().end());
}

void
CaseRegistration::WarnOfDrafts()
{
  for (const auto & entry : m_Result.jaws)
  {
    const double share = DraftedShareOf(*m_Data, entry.first);
    // Of more the verdict speaks.
    if (share > 0.0 && !RegistrationVerdict::JudgeDrafts(share, {}))
    {
      m_Result.warnings.push_back(std::string(ToString(entry.first)) + ": " +
                                  std::to_string(std::lround(100.0 * share)) +
                                  " % of the outlines are drafts as a registration projected them, no evidence of a "
                                  "person's");
    }
  }
}

void
CaseRegistration::GenerateData()
{
  TimeProbe total;
  total.Start();
  m_Data = this->GetInput()->Get();
  if (!m_Data)
  {
    itkExceptionMacro("The input holds no case: call Set() of the DentalCaseObject, or use a DentalCaseReader.");
  }
  const DentalCase & description = m_Data->description;
  if (description.fixScale && description.fixRotation && description.fixTranslation && !description.HasStart())
  {
    itkDentalInputErrorMacro(description.fileName,
                             "init",
                             "scale, rotation and translation are held, but there is no start to hold them at",
                             "give a start (--init, or \"init\" in the case file), or hold less (--fix)");
  }
  m_Result = CaseResult();
  m_Iteration = IterationType();
  m_Result.preset = m_Preset;
  m_Result.data = m_Data;
  m_Result.warnings = m_Data->warnings;
  m_Result.inputs = m_Data->inputs;
  ChooseJaws(*m_Data, m_Result);

  this->EnterStage("dental axis", 0.1F);
  TimeProbe axisProbe;
  axisProbe.Start();
  this->PrepareAxis();
  this->Run(m_Axis, 0.1F, 0.3F);
  const DentalFrameResult & frames = m_Axis->GetFrame();
  axisProbe.Stop();
  this->EnterStage("checks", 0.3F);
  m_Result.jawsShareFrame = frames.jawsShareFrame;
  if (frames.occlusionFinding != DentalFrameEnums::OcclusionFinding::NotTested)
  {
    m_Result.occlusionFound = DescribeOcclusion(frames);
    if (description.occlusion == OcclusionEnum::Yes && !frames.occlusionPlausible)
    {
      // They get one pose as the case says, and the verdict finds what that leads to: this is what it comes from.
      m_Result.warnings.push_back(
        "\"occlusion\" is true, but the scans do not lie in occlusion: " + m_Result.occlusionFound +
        "; leave \"occlusion\" out, so that it is found out, or say false");
    }
  }
  if (frames.jawsShareFrame && m_Preset == CasePresetEnum::Robust && m_PoseOptions.useJointPose)
  {
    PlaceJawsBesideTheOther(*m_Data, m_Result);
  }
  if (frames.jawsShareFrame)
  {
    m_Result.overjet = frames.overjet;
    m_Result.overbite = frames.overbite;
  }
  for (auto & entry : m_Result.jaws)
  {
    const DentalJawFrame & frame = frames.GetJaw(entry.first);
    entry.second.archWidth = frame.archWidth;
    entry.second.archDepth = frame.archDepth;
    entry.second.frameConfidence = frame.confidence;
    entry.second.seconds.emplace_back("read", m_Data->readSeconds);
    entry.second.seconds.emplace_back("axis", axisProbe.GetTotal());
  }
  this->CheckScans();
  this->WarnOfDrafts();
  if (const std::string text = CompareJawDrawings(*m_Data); !text.empty())
  {
    m_Result.warnings.push_back(text);
  }

  m_Result.geometry = CephalometricGeometry::New();
  m_Result.geometry->CopyParameters(m_Data->geometry);
  if (!m_Data->HasPixelSpacing())
  {
    m_Result.warnings.push_back(
      "the pixel spacing is unknown and was estimated from the arch's size; lengths in mm are rough");
  }
  AppendTexts(
    m_Result.warnings,
    DescribeUnusedControls(
      *m_Data,
      m_Preset,
      { m_UseSurfaceDRR, DescribeOptions(m_PoseOptions, m_RefineMidline), static_cast<bool>(m_PoseMethodCallback) }));
  if (m_Preset == CasePresetEnum::Robust)
  {
    this->RegisterByPose();
    this->CheckOutlinesByLandmarks();
    // The other presets may be millimetres beside the tracing themselves.
    AppendTexts(m_Result.warnings, DescribeLandmarksOffTeeth(*m_Data, m_Result));
  }
  else
  {
    this->RegisterBySimilarity();
  }
  this->CheckPicture();
  if (m_Preset == CasePresetEnum::Robust)
  {
    // The paper's chain does not place a jaw in space as the cephalostat holds it.
    JudgePrincipalPoint(*m_Data, m_Result);
  }
  for (auto & entry : m_Result.jaws)
  {
    SortFindings(entry.second.findings);
  }
  total.Stop();
  m_Result.totalSeconds = total.GetTotal() + m_Data->readSeconds;
  this->GetOutput()->Set(m_Result);
  this->UpdateProgress(1.0F);
}

void
CaseRegistration::RegisterByPose()
{
  this->EnterStage("registration", 0.35F);
  CasePoseSettings settings;
  settings.options = m_PoseOptions;
  settings.configure = m_PoseMethodCallback;
  settings.kappaSigmaIsGiven = m_KappaSigmaIsGiven;
  m_Result.options = DescribeOptions(m_PoseOptions, m_RefineMidline);
  settings.numberOfThreads = this->GetNumberOfWorkUnits();
  settings.numberOfContourPoints = { { m_NumberOfUpperContourPoints, m_NumberOfLowerContourPoints } };
  settings.run = [this](ProcessObject * process) { this->Run(process, 0.35F, 0.95F); };
  try
  {
    RegisterCaseByPose(*m_Data, m_Axis, settings, m_Result);
  }
  catch (const ProcessAborted &)
  {
    throw;
  }
  catch (const DentalInputError &)
  {
    throw;
  }
  catch (const ExceptionObject & error)
  {
    // A scan 25 times too large has no pose from which it could be seen: its findings say why, and this what came of
    // it. Where nothing was found, the mistake is not in the files.
    const bool isExplained = std::any_of(m_Result.jaws.begin(), m_Result.jaws.end(), [](const auto & entry) {
      return entry.second.status != RegistrationStatusEnum::Ok;
    });
    if (!isExplained)
    {
      throw;
    }
    for (auto & entry : m_Result.jaws)
    {
      entry.second.registered = false;
      entry.second.AddFinding(RegistrationStatusEnum::Failed, "not-registered", DescribePlainly(error));
    }
  }
}

void
CaseRegistration::RegisterBySimilarity()
{
  const auto frameOf = [this](JawEnum jaw) {
    return jaw == JawEnum::Upper ? m_Axis->GetUpperTransformOutput() : m_Axis->GetLowerTransformOutput();
  };
  // A spacing that nobody knows is estimated once for both jaws: they lie in one image.
  if (!m_Data->HasPixelSpacing())
  {
    auto spacing = TracingPixelSpacingFilter::New();
    spacing->SetGeometry(m_Data->geometry);
    for (const auto & entry : m_Result.jaws)
    {
      if (entry.second.status != RegistrationStatusEnum::Failed)
      {
        const auto & input = m_Data->GetJaw(entry.first);
        spacing->SetJaw(entry.first, input.mesh, input.contour, frameOf(entry.first));
      }
    }
    spacing->Update();
    m_Result.geometry->SetPixelSpacing(spacing->GetOutput()->GetPixelSpacing());
  }

  bool                   havePrincipalPoint = false;
  CaseSimilaritySettings settings;
  settings.preset = m_Preset;
  settings.useSurfaceDRR = m_UseSurfaceDRR;
  float progress = 0.35F;
  settings.run = [&](ProcessObject * process) { this->Run(process, progress, progress + 0.3F); };
  for (auto & entry : m_Result.jaws)
  {
    JawResult & result = entry.second;
    if (result.status == RegistrationStatusEnum::Failed)
    {
      continue;
    }
    this->EnterStage(std::string(ToString(entry.first)) + ": registration", progress);
    settings.numberOfContourPoints =
      entry.first == JawEnum::Upper ? m_NumberOfUpperContourPoints : m_NumberOfLowerContourPoints;
    try
    {
      RegisterJawBySimilarity(*m_Data, entry.first, frameOf(entry.first), m_Result.geometry, settings, result);
      progress += 0.3F;
    }
    catch (const ProcessAborted &)
    {
      throw;
    }
    catch (const ExceptionObject & error)
    {
      result.registered = false;
      result.AddFinding(RegistrationStatusEnum::Failed, "not-registered", DescribePlainly(error));
      progress += 0.3F;
      continue;
    }
    if (!m_Data->HasPrincipalPoint() && !havePrincipalPoint)
    {
      // Nothing else is known: the central ray through this jaw's centroid, as the recipe has it anyway.
      CephalometricGeometry::PixelIndexType principal;
      principal[0] = result.similarity.translation[0];
      principal[1] = result.similarity.translation[1];
      m_Result.geometry->SetPrincipalPoint(principal);
      havePrincipalPoint = true;
    }
    if (havePrincipalPoint)
    {
      result.meshToCephalostat =
        ToRows(*PlaceInCephalostat(frameOf(entry.first), result.similarity, m_Result.geometry));
    }
    PredictLandmarks(*m_Data, entry.first, result);
    if (const auto wholeTeeth = FindWholeTeeth(*m_Data->GetJaw(entry.first).contour, entry.first, *m_Result.geometry))
    {
      result.AddFinding(*wholeTeeth);
    }
    if (const auto drafts = RegistrationVerdict::JudgeDrafts(DraftedShareOf(*m_Data, entry.first), {}))
    {
      result.AddFinding(*drafts);
    }
    // The paper's recipe can fit the wrong place well (Documentation/Registration.md): it never vouches for itself.
    result.AddFinding(RegistrationStatusEnum::Suspect,
                      "unchecked-method",
                      std::string("preset ") + ToString(m_Preset) +
                        " does not check its own accuracy: look at the overlay");
  }
}

void
CaseRegistration::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Data: " << (m_Data ? m_Data->description.fileName : "(none)") << std::endl;
  os << indent << "Preset: " << ToString(m_Preset) << std::endl;
  os << indent << "NumberOfUpperContourPoints: " << m_NumberOfUpperContourPoints << std::endl;
  os << indent << "NumberOfLowerContourPoints: " << m_NumberOfLowerContourPoints << std::endl;
  os << indent << "UseSurfaceDRR: " << m_UseSurfaceDRR << std::endl;
  os << indent << "PoseOptions:";
  for (const std::string & change : PoseRegistrationOptionTable::GetChanges(m_PoseOptions))
  {
    os << ' ' << change;
  }
  os << std::endl;
  os << indent << "KappaSigmaIsGiven: " << (m_KappaSigmaIsGiven ? "On" : "Off") << std::endl;
  os << indent << "PoseMethodCallback: " << (m_PoseMethodCallback ? "set" : "(none)") << std::endl;
  os << indent << "RefineMidline: " << (m_RefineMidline ? "On" : "Off") << std::endl;
  itkPrintSelfObjectMacro(Axis);
  itkPrintSelfObjectMacro(Checks);
  os << indent << "CurrentStage: " << m_CurrentStage << std::endl;
  os << indent << "Iteration: level " << m_Iteration.level << ", iteration " << m_Iteration.iteration << ", value "
     << m_Iteration.value << std::endl;
  os << indent << "Running: " << (m_Running != nullptr ? m_Running->GetNameOfClass() : "(none)") << std::endl;
  os << indent << "ResultStatus: " << ToString(this->GetResult().GetStatus()) << std::endl;
}
} // namespace itk

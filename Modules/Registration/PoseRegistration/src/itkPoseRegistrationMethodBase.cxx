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
#include "itkPoseRegistrationMethodBase.h"

#include "itkJawIndex.h"
#include "itkPoseGeometryConversion.h"

#include "itkDentalFrameEstimator.h"
#include "itkExchangedJawsHypothesis.h"
#include "itkExchangedLandmarksHypothesis.h"
#include "itkLevenbergMarquardtOptimizerv4.h"
#include "itkMillimetreLandmarksHypothesis.h"
#include "itkOtherFacingHypothesis.h"
#include "itkOtherSideHypothesis.h"
#include "itkOtherSpacingHypothesis.h"
#include "itkOtherViewHypothesis.h"
#include "itkRigidTransformRows.h"
#include "itkTurnedDrawingHypothesis.h"
#include "itkUpwardDrawingHypothesis.h"
#include "itkPoseFrameOperations.h"
#include "itkPoseGeometryCompletion.h"
#include "itkPoseRegistrationEngine.h"
#include "itkPoseRegistrationOptionTable.h"
#include "itkPoseStartSearch.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace itk
{
namespace
{
using JawEnum = ToothCode::JawEnum;
constexpr JawEnum Jaws[] = { JawEnum::Upper, JawEnum::Lower };

/** Without a transform between them, whose rounding would move the origin. */
PoseFrame
ToFrame(const DentalJawFrame & jaw)
{
  PoseFrame frame;
  for (unsigned int row = 0; row < 3; ++row)
  {
    std::copy(jaw.axes[row].begin(), jaw.axes[row].end(), frame.rotation.begin() + 3 * row);
  }
  frame.origin = jaw.origin;
  return frame;
}

/** Mesh frame to cephalostat, as pose of the dental frame. */
PoseParameters
ToParameters(const VersorRigid3DTransform<double> & transform, double scaleFactor, const PoseFrame & frame)
{
  std::array<double, 9> rows;
  std::array<double, 3> shift;
  ToDentalMotion(frame, transform, rows, shift);
  Matrix<double, 3, 3>    rotation;
  const Vector<double, 3> translation(shift.data());
  std::copy(rows.begin(), rows.end(), rotation.GetVnlMatrix().data_block());
  auto pose = CephalometricPoseTransform::New();
  pose->SetParametersFromRotation(rotation, translation, std::log(scaleFactor));
  return pose->GetPoseParameters();
}
} // namespace

/** The groups of the last run. */
struct PoseRegistrationMethodBase::AnsweredType
{
  std::vector<PoseRegistrationEngine::GroupType> groups;
};

PoseRegistrationMethodBase::PoseRegistrationMethodBase()
  : m_Optimizer(LevenbergMarquardtOptimizerv4::New().GetPointer())
  , m_Start(PoseStartSearch::New().GetPointer())
{
  m_Hypotheses = { OtherSideHypothesis::New().GetPointer(),           OtherFacingHypothesis::New().GetPointer(),
                   ExchangedJawsHypothesis::New().GetPointer(),       ExchangedLandmarksHypothesis::New().GetPointer(),
                   MillimetreLandmarksHypothesis::New().GetPointer(), OtherSpacingHypothesis::New().GetPointer() };
  for (const unsigned int turns : { 1, 2, 3 })
  {
    auto turned = TurnedDrawingHypothesis::New();
    turned->SetQuarterTurns(turns);
    m_Hypotheses.emplace_back(turned.GetPointer());
  }
  m_Hypotheses.emplace_back(UpwardDrawingHypothesis::New().GetPointer());
  this->AddRequiredInputName("Geometry", 0);
  this->AddOptionalInputName("UpperMesh", 1);
  this->AddOptionalInputName("LowerMesh", 2);
  this->AddOptionalInputName("UpperContour", 3);
  this->AddOptionalInputName("LowerContour", 4);
  this->AddOptionalInputName("UpperFrame", 5);
  this->AddOptionalInputName("LowerFrame", 6);
  this->AddOptionalInputName("JointFrame", 7);
  this->AddOptionalInputName("CephalometricLandmarks", 8);
  this->AddOptionalInputName("LandmarkCounterparts", 9);
  this->AddOptionalInputName("ToothCrowns", 10);
  this->AddOptionalInputName("StockOutlines", 11);
  this->SetNumberOfRequiredOutputs(1 + 2 * NumberOfJaws);
  for (unsigned int i = 0; i < 1 + 2 * NumberOfJaws; ++i)
  {
    this->SetNthOutput(i, this->MakeOutput(i));
  }
}

// Here, where what it holds is known.
PoseRegistrationMethodBase::~PoseRegistrationMethodBase() = default;

PoseRegistrationMethodBase::DataObjectPointer
PoseRegistrationMethodBase::MakeOutput(DataObjectPointerArraySizeType index)
{
  if (index == 0)
  {
    return SolutionType::New().GetPointer();
  }
  if (index <= NumberOfJaws)
  {
    return DecoratedTransformType::New().GetPointer();
  }
  return GeometryType::New().GetPointer();
}

void
PoseRegistrationMethodBase::SetOptions(const PoseRegistrationOptions & options)
{
  m_Options = options;
  this->Modified();
}

void
PoseRegistrationMethodBase::SetTracedSide(TracedSideEnum side)
{
  if (m_Options.tracedSide != side)
  {
    m_Options.tracedSide = side;
    this->Modified();
  }
}

void
PoseRegistrationMethodBase::SetSpacingSource(ScalePrior::SpacingSource source)
{
  if (m_SpacingSource != source)
  {
    m_SpacingSource = source;
    this->Modified();
  }
}

void
PoseRegistrationMethodBase::ClearSpacingSource()
{
  if (m_SpacingSource)
  {
    m_SpacingSource.reset();
    this->Modified();
  }
}

void
PoseRegistrationMethodBase::SetInitialTransform(JawEnum jaw, const RigidTransformType * transform, double scaleFactor)
{
  if (!(scaleFactor > 0.0))
  {
    itkExceptionMacro("The scale factor " << scaleFactor << " of SetInitialTransform() must be positive.");
  }
  m_Initial[ToIndex(jaw)] = { transform, scaleFactor };
  this->Modified();
}

void
PoseRegistrationMethodBase::ClearInitialTransforms()
{
  m_Initial = {};
  this->Modified();
}

void
PoseRegistrationMethodBase::AddMetric(TermType * term, JawEnum jaw)
{
  if (term == nullptr)
  {
    itkExceptionMacro("AddMetric() was given no metric.");
  }
  m_Terms.emplace_back(term);
  m_TermJaws.push_back(jaw);
  this->Modified();
}

void
PoseRegistrationMethodBase::ClearMetrics()
{
  m_Terms.clear();
  m_TermJaws.clear();
  this->Modified();
}

void
PoseRegistrationMethodBase::AddHypothesis(const PoseHypothesis * hypothesis)
{
  if (hypothesis == nullptr)
  {
    itkExceptionMacro("AddHypothesis() was given no hypothesis.");
  }
  const std::string code = hypothesis->GetCode();
  if (std::any_of(
        m_Hypotheses.begin(), m_Hypotheses.end(), [&](const auto & other) { return other->GetCode() == code; }))
  {
    itkExceptionMacro("There is a hypothesis with the code \""
                      << code << "\" already, and the outcome stands under it: call ClearHypotheses() first, or give "
                      << hypothesis->GetNameOfClass() << " another code.");
  }
  m_Hypotheses.emplace_back(hypothesis);
  this->Modified();
}

void
PoseRegistrationMethodBase::ClearHypotheses()
{
  m_Hypotheses.clear();
  this->Modified();
}

void
PoseRegistrationMethodBase::AddView(const CephalogramView * view)
{
  if (view == nullptr)
  {
    itkExceptionMacro("AddView() was given no view.");
  }
  const auto hasName = [view](const auto & other) { return std::string(other->GetName()) == view->GetName(); };
  if (std::any_of(m_Views.begin(), m_Views.end(), hasName))
  {
    itkExceptionMacro("There is a view \"" << view->GetName() << "\" already: give this one another name.");
  }
  m_Views.emplace_back(view);
  this->Modified();
}

void
PoseRegistrationMethodBase::ClearViews()
{
  if (!m_Views.empty())
  {
    m_Views.clear();
    this->Modified();
  }
}

ModifiedTimeType
PoseRegistrationMethodBase::GetMTime() const
{
  // A term that a user changed runs the method again. The optimizer's own time changes as it runs.
  ModifiedTimeType time = Superclass::GetMTime();
  for (const auto & term : m_Terms)
  {
    time = std::max(time, term->GetMTime());
  }
  for (const auto & hypothesis : m_Hypotheses)
  {
    time = std::max(time, hypothesis->GetMTime());
  }
  for (const auto & view : m_Views)
  {
    time = std::max(time, view->GetMTime());
  }
  for (const Object * part : { static_cast<const Object *>(m_RobustKernel.GetPointer()),
                               static_cast<const Object *>(m_NoiseModel.GetPointer()),
                               static_cast<const Object *>(m_CovarianceNoiseModel.GetPointer()),
                               static_cast<const Object *>(m_InitialGeometry.GetPointer()),
                               static_cast<const Object *>(m_Start.GetPointer()) })
  {
    time = part == nullptr ? time : std::max(time, part->GetMTime());
  }
  return time;
}

PoseRegistrationMethodBase::SolutionType *
PoseRegistrationMethodBase::GetOutput()
{
  return itkDynamicCastInDebugMode<SolutionType *>(this->ProcessObject::GetOutput(0));
}

const PoseRegistrationMethodBase::SolutionType *
PoseRegistrationMethodBase::GetOutput() const
{
  return itkDynamicCastInDebugMode<const SolutionType *>(this->ProcessObject::GetOutput(0));
}

PoseRegistrationMethodBase::DecoratedTransformType *
PoseRegistrationMethodBase::GetTransformOutput(JawEnum jaw)
{
  return itkDynamicCastInDebugMode<DecoratedTransformType *>(this->ProcessObject::GetOutput(1 + ToIndex(jaw)));
}

const PoseRegistrationMethodBase::RigidTransformType *
PoseRegistrationMethodBase::GetTransform(JawEnum jaw)
{
  return this->GetTransformOutput(jaw)->Get();
}

PoseRegistrationMethodBase::GeometryType *
PoseRegistrationMethodBase::GetGeometryOutput(JawEnum jaw)
{
  return itkDynamicCastInDebugMode<GeometryType *>(this->ProcessObject::GetOutput(1 + NumberOfJaws + ToIndex(jaw)));
}

unsigned int
PoseRegistrationMethodBase::GetCurrentCandidate() const
{
  return m_CurrentIteration.candidate;
}

double
PoseRegistrationMethodBase::GetStepLength() const
{
  return m_CurrentIteration.step.stepLength;
}

bool
PoseRegistrationMethodBase::GetStepAccepted() const
{
  return m_CurrentIteration.step.accepted;
}

std::size_t
PoseRegistrationMethodBase::GetOptimizerIteration() const
{
  return m_CurrentIteration.step.iteration;
}

double
PoseRegistrationMethodBase::GetMetricValue() const
{
  return m_CurrentIteration.step.value;
}

OptimizerParameters<double>
PoseRegistrationMethodBase::GetOptimizerPosition() const
{
  OptimizerParameters<double> position(static_cast<unsigned int>(m_CurrentIteration.pose.size()));
  std::copy(m_CurrentIteration.pose.begin(), m_CurrentIteration.pose.end(), position.begin());
  return position;
}

std::string
PoseRegistrationMethodBase::GetOptimizerStopConditionDescription() const
{
  const auto & groups = this->GetOutput()->GetResult().groups;
  return groups.empty() ? std::string() : groups.back().stopCondition;
}

const PoseRegistrationMethodBase::ContourType *
PoseRegistrationMethodBase::GetContour(JawEnum jaw) const
{
  return jaw == JawEnum::Upper ? this->GetUpperContour() : this->GetLowerContour();
}

bool
PoseRegistrationMethodBase::HasDrawing(JawEnum jaw) const
{
  if (this->GetContour(jaw) != nullptr)
  {
    return true;
  }
  const auto * landmarks = this->GetCephalometricLandmarks();
  const auto * counterparts = this->GetLandmarkCounterparts();
  return landmarks != nullptr && counterparts != nullptr &&
         std::any_of(landmarks->GetLandmarks().begin(), landmarks->GetLandmarks().end(), [&](const auto & landmark) {
           return landmark.meaning.jaw == jaw &&
                  counterparts->Find(CephalometricLandmarkSet::MakeName(landmark.meaning)) != nullptr;
         });
}

void
PoseRegistrationMethodBase::VerifyPreconditions() ITKv5_CONST
{
  Superclass::VerifyPreconditions();
  // Nothing upstream has run yet: which landmarks have counterparts, GenerateData() sees.
  const bool hasLandmarks = this->GetCephalometricLandmarks() != nullptr && this->GetLandmarkCounterparts() != nullptr;
  const auto mayHaveDrawing = [&](JawEnum jaw) { return hasLandmarks || this->GetContour(jaw) != nullptr; };
  if (std::none_of(
        std::begin(Jaws), std::end(Jaws), [&](JawEnum jaw) { return this->HasMesh(jaw) && mayHaveDrawing(jaw); }))
  {
    itkExceptionMacro("No jaw has both a mesh and something that was drawn of it: call SetUpperMesh() and "
                      "SetUpperContour(), SetLowerMesh() and SetLowerContour(), or both pairs, or "
                      "SetCephalometricLandmarks() and SetLandmarkCounterparts().");
  }
  for (const JawEnum jaw : m_TermJaws)
  {
    if (jaw != JawEnum::Unknown && (!this->HasMesh(jaw) || !mayHaveDrawing(jaw)))
    {
      itkExceptionMacro("AddMetric() was given a term of the " << ToString(jaw)
                                                               << " jaw, which lacks its mesh or contour: set them, or "
                                                                  "call ClearMetrics().");
    }
  }
  if (m_Options.tracedSide == TracedSideEnum::Standard && this->GetToothCrowns() == nullptr &&
      (this->GetUpperContour() != nullptr || this->GetLowerContour() != nullptr))
  {
    itkExceptionMacro("The outlines of a standard tracing are of whole teeth: call SetToothCrowns() with what "
                      "ToothCrownFilter cuts out of the scans.");
  }
  for (const auto & view : m_Views)
  {
    view->Verify();
    const bool isTraced = view->GetContour(JawEnum::Upper) != nullptr || view->GetContour(JawEnum::Lower) != nullptr;
    if (isTraced && view->GetGeometry()->GetDirection() == CephalometricDirectionEnum::Frontal &&
        this->GetToothCrowns() == nullptr)
    {
      itkExceptionMacro("The tracing of view \"" << view->GetName()
                                                 << "\" is of single teeth: call SetToothCrowns() with what "
                                                    "ToothCrownFilter cuts out of the scans.");
    }
  }
  if (m_InitialGeometry.IsNotNull() && (m_InitialGeometry->GetFacing() != this->GetGeometry()->GetFacing() ||
                                        m_InitialGeometry->GetDirection() != this->GetGeometry()->GetDirection()))
  {
    itkExceptionMacro(
      "The geometry of SetInitialGeometry() is of a radiograph that faces another way: a start in it means "
      "nothing here. Leave the initial transforms out.");
  }
  if (m_Optimizer.IsNull())
  {
    itkExceptionMacro("No optimizer: call SetOptimizer(), with a LevenbergMarquardtOptimizerv4 for example.");
  }
  if (m_Start.IsNull())
  {
    itkExceptionMacro("No start: call SetStart(), with a PoseStartSearch for example.");
  }
}

void
PoseRegistrationMethodBase::UpdateFrames(const std::array<TriangleSurface, NumberOfJaws> & surfaces)
{
  const DecoratedTransformType * joint = this->GetJointFrame();
  m_JawsShareFrame = joint != nullptr && joint->Get() != nullptr;
  if (m_JawsShareFrame)
  {
    m_Frames.fill(ToPoseFrame(*joint->Get()));
    return;
  }
  const std::array<const DecoratedTransformType *, NumberOfJaws> given{ { this->GetUpperFrame(),
                                                                          this->GetLowerFrame() } };
  bool                                                           isComplete = true;
  for (const JawEnum jaw : Jaws)
  {
    const bool needed = this->HasMesh(jaw) && this->HasDrawing(jaw);
    const auto frame = given[ToIndex(jaw)];
    if (frame != nullptr && frame->Get() != nullptr)
    {
      m_Frames[ToIndex(jaw)] = ToPoseFrame(*frame->Get());
    }
    else if (needed)
    {
      isComplete = false;
    }
  }
  if (isComplete)
  {
    return;
  }
  DentalFrameOptions frameOptions;
  frameOptions.refineMidline = true;
  frameOptions.threads = this->GetNumberOfWorkUnits();
  frameOptions.abort = [this]() { return this->GetAbortGenerateData(); };
  const DentalFrameResult frames = EstimateDentalFrame(this->HasMesh(JawEnum::Upper) ? &surfaces[0] : nullptr,
                                                       this->HasMesh(JawEnum::Lower) ? &surfaces[1] : nullptr,
                                                       frameOptions);
  m_JawsShareFrame = frames.jawsShareFrame && frames.joint.valid;
  for (const JawEnum jaw : Jaws)
  {
    const DentalJawFrame & own = frames.GetJaw(jaw);
    const DentalJawFrame & frame = m_JawsShareFrame ? frames.joint : own;
    if (this->HasMesh(jaw) && this->HasDrawing(jaw) && !frame.valid && !this->GetAbortGenerateData())
    {
      const char * name = ToString(jaw);
      itkExceptionMacro("No dental arch was found in the " << name << " mesh. Set its frame with Set"
                                                           << ToCapitalizedString(jaw) << "Frame().");
    }
    m_Frames[ToIndex(jaw)] = ToFrame(frame);
  }
}

void
PoseRegistrationMethodBase::Report(const IterationType & iteration)
{
  m_CurrentIteration = iteration;
  if (m_Metric.IsNotNull() && !iteration.hypothesis)
  {
    const PoseParameters & pose = iteration.pose;
    m_Metric->SetBlockValues("pose", { pose[0], pose[1], pose[2], pose[3], pose[4], pose[5] });
    m_Metric->SetBlockValues("scale", { pose[PoseKappa] });
    m_Metric->SetKernelWidth(iteration.kernelWidth);
    m_Metric->SetNoiseLevels(iteration.noise);
    m_Metric->InvokeEvent(IterationEvent());
  }
  if (auto * optimizer = dynamic_cast<LevenbergMarquardtOptimizerv4 *>(m_Optimizer.GetPointer()))
  {
    if (!optimizer->ReportIteration(iteration.step))
    {
      // An observer of the optimizer has stopped it: that is the end of the registration.
      this->AbortGenerateDataOn();
    }
  }
  this->InvokeEvent(IterationEvent());
}

void
PoseRegistrationMethodBase::GenerateData()
{
  // Levels are events too: those before the first step must not speak of the last run's last one.
  m_CurrentIteration = IterationType();
  if (std::none_of(
        std::begin(Jaws), std::end(Jaws), [this](JawEnum jaw) { return this->HasMesh(jaw) && this->HasDrawing(jaw); }))
  {
    itkExceptionMacro("No landmark of the radiograph has a counterpart on a scan: see what "
                      "LandmarkCounterpartFilter::GetUnused() says, or set contours.");
  }
  const GeometryType *                      nominal = this->GetGeometry();
  std::array<TriangleSurface, NumberOfJaws> surfaces;
  for (const JawEnum jaw : Jaws)
  {
    this->GetTransformOutput(jaw)->Set(nullptr);
    this->GetGeometryOutput(jaw)->CopyParameters(nominal);
    // The other jaw's surface serves the frame even without a contour.
    if (this->HasMesh(jaw))
    {
      surfaces[ToIndex(jaw)] = this->MakeSurface(jaw);
    }
  }
  this->UpdateFrames(surfaces);

  PoseProblem problem;
  problem.options = m_Options;
  problem.options.useJointPose = m_Options.useJointPose && m_JawsShareFrame;
  problem.options.numberOfThreads = this->GetNumberOfWorkUnits();
  if (m_SpacingSource)
  {
    problem.options.kappaSigma = ScalePrior::GetSigma(*m_SpacingSource);
  }
  bool isStarted = false;
  for (const JawEnum jaw : Jaws)
  {
    // A jaw of which nothing was drawn goes along where it shares the other's frame.
    if (!this->HasMesh(jaw) || (!this->HasDrawing(jaw) && !problem.options.useJointPose))
    {
      continue;
    }
    PoseJawInput input;
    input.landmarks = this->GetCephalometricLandmarks();
    input.counterparts = this->GetLandmarkCounterparts();
    input.crowns = this->GetToothCrowns();
    input.surface = &surfaces[ToIndex(jaw)];
    input.frame = m_Frames[ToIndex(jaw)];
    input.jaw = jaw;
    input.tracing = this->GetContour(jaw);
    const InitialType & initial = m_Initial[ToIndex(jaw)];
    if (initial.transform.IsNotNull())
    {
      input.initialPose = ToParameters(*initial.transform, initial.scaleFactor, input.frame);
      isStarted = true;
    }
    problem.jaws.push_back(input);
  }
  problem.stockOutlines = this->GetStockOutlines();
  problem.nominal = ToPoseGeometry(*nominal);
  problem.nominal.principalPointKnown = m_PrincipalPointKnown;
  if (isStarted && m_InitialGeometry.IsNotNull())
  {
    problem.initialGeometry = ToPoseGeometry(*m_InitialGeometry);
  }
  for (const auto & view : m_Views)
  {
    PoseViewInput input;
    input.name = view->GetName();
    input.geometry = ToPoseGeometry(*view->GetGeometry());
    for (const JawEnum jaw : Jaws)
    {
      input.tracings[ToIndex(jaw)] = view->GetContour(jaw);
    }
    input.landmarks = view->GetCephalometricLandmarks();
    input.counterparts = view->GetLandmarkCounterparts();
    input.sameHeadPosition = view->GetSameHeadPosition();
    input.principalPointSigma = view->GetPrincipalPointSigma();
    input.kappaSigma = ScalePrior::GetSigma(view->GetSpacingSource());
    problem.views.push_back(input);
  }

  PoseIterationMonitor   monitor([this](const IterationType & iteration) { this->Report(iteration); },
                               [this]() { return this->GetAbortGenerateData(); });
  PoseRegistrationEngine engine;
  this->ConnectParts(engine, monitor);
  engine.hypotheses = m_Hypotheses;
  for (const auto & view : m_Views)
  {
    for (const auto question : { OtherViewHypothesis::QuestionEnum::Sides,
                                 OtherViewHypothesis::QuestionEnum::Source,
                                 OtherViewHypothesis::QuestionEnum::Head })
    {
      auto hypothesis = OtherViewHypothesis::New();
      hypothesis->SetView(view->GetName());
      hypothesis->SetQuestion(question);
      engine.hypotheses.emplace_back(hypothesis);
    }
  }
  for (std::size_t t = 0; t < m_Terms.size(); ++t)
  {
    problem.terms.push_back({ m_Terms[t], m_TermJaws[t] });
  }
  engine.groupObserver = [this](unsigned int, unsigned int numberOfGroups, MetricType * metric) {
    m_NumberOfLevels = 4 * numberOfGroups;
    // One to look at: the group's own is cloned in other threads while observers are told.
    m_Metric = metric->Clone();
  };
  engine.stageObserver = [this](unsigned int group, PoseStageEnum stage) {
    if (this->GetAbortGenerateData())
    {
      // What was aborted enters no further level.
      return;
    }
    m_CurrentLevel = 4 * group + static_cast<unsigned int>(stage);
    this->InvokeEvent(MultiResolutionIterationEvent());
    this->UpdateProgress(static_cast<float>(m_CurrentLevel) / static_cast<float>(m_NumberOfLevels));
  };
  engine.hypothesisObserver = [this](unsigned int group, double share) {
    if (!this->GetAbortGenerateData())
    {
      // They come after the last level and take the second half of its share.
      this->UpdateProgress((4.0f * static_cast<float>(group) + 3.5f + 0.5f * static_cast<float>(share)) /
                           static_cast<float>(m_NumberOfLevels));
    }
  };
  PoseRegistrationResult result;
  auto                   answered = std::make_unique<AnsweredType>();
  m_Answered.reset();
  try
  {
    result = engine.Run(problem, &answered->groups);
  }
  catch (const PoseGeometryError & error)
  {
    itkExceptionMacro("The geometry cannot be used: " << error.what() << ". Correct it with SetGeometry().");
  }
  if (result.aborted || this->GetAbortGenerateData())
  {
    this->ResetPipeline();
    this->ThrowAborted();
  }
  for (auto & group : answered->groups)
  {
    for (PoseJawInput & jaw : group.problem.jaws)
    {
      // They end with this call; TryHypothesis() makes them anew.
      jaw.surface = nullptr;
    }
  }
  m_Answered = std::move(answered);

  PoseRegistrationOptions used = m_Options;
  used.useInitialPose = m_Options.useInitialPose || isStarted;
  used.kappaSigma = problem.options.kappaSigma;
  this->GetOutput()->SetResult(result, used);
  for (const JawEnum jaw : Jaws)
  {
    if (this->GetOutput()->IsRegistered(jaw))
    {
      this->GetTransformOutput(jaw)->Set(this->GetOutput()->MakeRigidTransform(jaw));
      this->GetOutput()->CopyToGeometry(jaw, this->GetGeometryOutput(jaw));
    }
  }
  this->UpdateProgress(1.0f);
}

void
PoseRegistrationMethodBase::ConnectParts(PoseRegistrationEngine & engine, PoseIterationMonitor & monitor) const
{
  engine.parts = { m_RobustKernel, m_NoiseModel, m_CovarianceNoiseModel };
  engine.optimizer = m_Optimizer;
  engine.start = m_Start;
  engine.monitor = &monitor;
}

void
PoseRegistrationMethodBase::ThrowAborted()
{
  ProcessAborted aborted(__FILE__, __LINE__);
  aborted.SetLocation(ITK_LOCATION);
  aborted.SetDescription("The registration was aborted.");
  throw aborted;
}

PoseHypothesisOutcome
PoseRegistrationMethodBase::TryHypothesis(const PoseHypothesis * hypothesis, JawEnum jaw)
{
  if (hypothesis == nullptr)
  {
    itkExceptionMacro("TryHypothesis() was given no hypothesis.");
  }
  this->Update();
  // Its message says why a jaw was not registered.
  this->GetOutput()->GetGroup(jaw);
  const auto &                      groups = m_Answered->groups;
  const auto                        found = std::find_if(groups.begin(), groups.end(), [jaw](const auto & group) {
    return std::any_of(group.problem.jaws.begin(), group.problem.jaws.end(), [jaw](const PoseJawInput & input) {
      return input.jaw == jaw;
    });
  });
  PoseRegistrationEngine::GroupType group = *found;
  for (const std::string & obstacle :
       { PoseRegistrationEngine::GetObstacle(group.problem), hypothesis->GetObstacle(group.problem) })
  {
    if (!obstacle.empty())
    {
      itkExceptionMacro("The hypothesis \"" << hypothesis->GetCode() << "\" cannot be tried: " << obstacle << ".");
    }
  }
  std::array<TriangleSurface, NumberOfJaws> surfaces;
  for (PoseJawInput & input : group.problem.jaws)
  {
    surfaces[ToIndex(input.jaw)] = this->MakeSurface(input.jaw);
    input.surface = &surfaces[ToIndex(input.jaw)];
  }
  this->AbortGenerateDataOff();
  PoseIterationMonitor   monitor([this](const IterationType & iteration) { this->Report(iteration); },
                               [this]() { return this->GetAbortGenerateData(); });
  PoseRegistrationEngine engine;
  this->ConnectParts(engine, monitor);
  const auto outcome = engine.TryHypothesis(group, *hypothesis);
  if (!outcome || this->GetAbortGenerateData())
  {
    this->AbortGenerateDataOff();
    this->ThrowAborted();
  }
  return *outcome;
}

void
PoseRegistrationMethodBase::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "TracedSide: " << m_Options.tracedSide << std::endl;
  for (const auto & entry : PoseRegistrationOptionTable::GetEntries())
  {
    os << indent << entry.name << ": " << PoseRegistrationOptionTable::Get(m_Options, entry.name) << std::endl;
  }
  os << indent << "FixScale: " << m_Options.fixScale << std::endl;
  os << indent << "FixRotation: " << m_Options.fixRotation << std::endl;
  os << indent << "FixTranslation: " << m_Options.fixTranslation << std::endl;
  os << indent << "UseInitialPose: " << m_Options.useInitialPose << std::endl;
  os << indent << "InitialPose:";
  for (const double parameter : m_Options.initialPose)
  {
    os << ' ' << parameter;
  }
  os << std::endl;
  os << indent << "ExcludedTeeth:";
  for (const unsigned int tooth : m_Options.excludedTeeth)
  {
    os << ' ' << tooth;
  }
  os << std::endl;
  os << indent << "PrincipalPointKnown: " << m_PrincipalPointKnown << std::endl;
  os << indent << "SpacingSource: " << (m_SpacingSource ? static_cast<int>(*m_SpacingSource) : -1) << std::endl;
  itkPrintSelfObjectMacro(Optimizer);
  itkPrintSelfObjectMacro(Start);
  itkPrintSelfObjectMacro(RobustKernel);
  itkPrintSelfObjectMacro(NoiseModel);
  itkPrintSelfObjectMacro(CovarianceNoiseModel);
  itkPrintSelfObjectMacro(InitialGeometry);
  itkPrintSelfObjectMacro(Metric);
  os << indent << "Metrics: " << m_Terms.size() << std::endl;
  os << indent << "Views:";
  for (const auto & view : m_Views)
  {
    os << ' ' << view->GetName();
  }
  os << std::endl;
  os << indent << "Hypotheses:";
  for (const auto & hypothesis : m_Hypotheses)
  {
    os << ' ' << hypothesis->GetCode();
  }
  os << std::endl;
  os << indent << "JawsShareFrame: " << m_JawsShareFrame << std::endl;
  os << indent << "CurrentLevel: " << m_CurrentLevel << " of " << m_NumberOfLevels << std::endl;
  os << indent << "CurrentIteration: " << m_CurrentIteration.step.iteration << std::endl;
  for (const JawEnum jaw : Jaws)
  {
    const unsigned int j = ToIndex(jaw);
    os << indent << (j == 0 ? "Upper" : "Lower") << " initial transform: " << (m_Initial[j].transform.IsNotNull())
       << ", frame origin: " << m_Frames[j].origin[0] << ' ' << m_Frames[j].origin[1] << ' ' << m_Frames[j].origin[2]
       << std::endl;
  }
}
} // namespace itk

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
#ifndef itkPoseRegistrationMethodBase_h
#define itkPoseRegistrationMethodBase_h

#include "itkCephalogramView.h"
#include "itkPoseHypothesis.h"
#include "itkPoseRegistrationIteration.h"
#include "itkPoseSolution.h"
#include "itkPoseStart.h"

#include "itkDataObjectDecorator.h"
#include "itkDentalContour.h"
#include "itkLeastSquaresSumMetricv4.h"
#include "itkObjectToObjectOptimizerBase.h"
#include "itkProcessObject.h"
#include "itkRegistrationIterationInformation.h"
#include "itkScalePrior.h"
#include "itkSimpleDataObjectDecorator.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace itk
{
class PoseIterationMonitor;
class PoseRegistrationEngine;

/** \class PoseRegistrationMethodBase
 * \brief All of PoseRegistrationMethod but the type of the meshes.
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT PoseRegistrationMethodBase
  : public ProcessObject
  , public RegistrationIterationInformation
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(PoseRegistrationMethodBase);

  using Self = PoseRegistrationMethodBase;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkTypeMacro(PoseRegistrationMethodBase, ProcessObject);

  using JawEnum = ToothCode::JawEnum;
  using ContourType = DentalContour;
  using GeometryType = CephalometricGeometry;
  using RigidTransformType = VersorRigid3DTransform<double>;
  using DecoratedTransformType = DataObjectDecorator<RigidTransformType>;
  using SolutionType = PoseSolution;
  using MetricType = LeastSquaresSumMetricv4;
  using TermType = LeastSquaresMetricv4;
  using OptimizerType = ObjectToObjectOptimizerBaseTemplate<double>;
  using IterationType = PoseRegistrationIteration;
  using DataObjectPointer = Superclass::DataObjectPointer;
  using DataObjectPointerArraySizeType = Superclass::DataObjectPointerArraySizeType;

  // Inputs ------------------------------------------------------------------------------------------------------
  /** Tracings of the radiograph, continuous pixel indices; either may be missing. */
  itkSetInputMacro(UpperContour, ContourType);
  itkGetInputMacro(UpperContour, ContourType);
  itkSetInputMacro(LowerContour, ContourType);
  itkGetInputMacro(LowerContour, ContourType);
  /** Landmarks of a cephalometric analysis, continuous pixel indices, as evidence beside the contours or instead of
   * them, and where they are on the scans (LandmarkCounterpartFilter). A jaw of which nothing was drawn goes along with
   * the other where they share a frame. */
  itkSetInputMacro(CephalometricLandmarks, CephalometricLandmarkSet);
  itkGetInputMacro(CephalometricLandmarks, CephalometricLandmarkSet);
  itkSetInputMacro(LandmarkCounterparts, LandmarkCounterpartSet);
  itkGetInputMacro(LandmarkCounterparts, LandmarkCounterpartSet);
  /** The crowns that outlines of whole teeth are compared with (ToothCrownFilter), meshes' frames; needed where the
   * option tracedSide is Standard and a contour is set. */
  itkSetInputMacro(ToothCrowns, ToothCrownSet);
  itkGetInputMacro(ToothCrowns, ToothCrownSet);

  /** Outlines that a reader's software offers in place of a drawn one, as another patient's tracing has them: closed
   * lines of any size. Teeth of a standard tracing that are one of them, moved, are templates, of which tip and axis
   * count (ToothOutlineComparison). Optional: the outlines of the tracing itself are compared in any case. */
  itkSetInputMacro(StockOutlines, DentalContour);
  itkGetInputMacro(StockOutlines, DentalContour);
  itkSetInputMacro(Geometry, GeometryType);
  itkGetInputMacro(Geometry, GeometryType);

  /** Mesh frame to dental frame, as UMidlineDentalAxisFilter (RefineMidline on) gives it: GetUpperTransformOutput(),
   * GetLowerTransformOutput(), GetJointTransformOutput(). Where the joint one is set and holds a transform, both jaws
   * share its frame and, with the option useJointPose, one pose. Frames that are not set are estimated. */
  itkSetInputMacro(UpperFrame, DecoratedTransformType);
  itkGetInputMacro(UpperFrame, DecoratedTransformType);
  itkSetInputMacro(LowerFrame, DecoratedTransformType);
  itkGetInputMacro(LowerFrame, DecoratedTransformType);
  itkSetInputMacro(JointFrame, DecoratedTransformType);
  itkGetInputMacro(JointFrame, DecoratedTransformType);

  /** A further radiograph of the patient beside the first, as evidence: the solution explains all of them, and says of
   * each how well (PoseSolution::MakeViewSolution()). A start is searched on the first view alone. Throws where there
   * is a view of that name already; what a view lacks, Update() says. */
  void
  AddView(const CephalogramView * view);
  void
  ClearViews();
  const std::vector<CephalogramView::ConstPointer> &
  GetViews() const
  {
    return m_Views;
  }

  // Options -----------------------------------------------------------------------------------------------------

  /** Every ingredient of the method. Thread number is this object's own. */
  void
  SetOptions(const PoseRegistrationOptions & options);
  const PoseRegistrationOptions &
  GetOptions() const
  {
    return m_Options;
  }

  /** Which side was traced: the option that cases differ in. */
  void
  SetTracedSide(TracedSideEnum side);
  TracedSideEnum
  GetTracedSide() const
  {
    return m_Options.tracedSide;
  }

  /** Whether the geometry's principal point is one. Default on; off, the tracing's centre is used. */
  itkSetMacro(PrincipalPointKnown, bool);
  itkGetConstMacro(PrincipalPointKnown, bool);
  itkBooleanMacro(PrincipalPointKnown);

  /** Where the pixel spacing comes from: its prior of the scale (ScalePrior) takes the place of the option kappaSigma.
   * Without a call the option holds, whose default is that of a spacing that was given. */
  void
  SetSpacingSource(ScalePrior::SpacingSource source);
  void
  ClearSpacingSource();

  /** Which place of a jaw is meant: mesh frame to cephalostat frame, and the factor on the magnification. Of jaws with
   * one pose the upper's speaks first. What the search finds elsewhere is left out, and what it finds there is the
   * answer, the same as without a start; where it finds nothing there, or something is held, the registration goes on
   * from the start itself. */
  void
  SetInitialTransform(JawEnum jaw, const RigidTransformType * transform, double scaleFactor = 1.0);
  void
  ClearInitialTransforms();

  /** The geometry that the initial transforms and their factors are of: that of an earlier registration. Null, the
   * default: that of this one. Where they differ each start is converted (PoseModel::ConvertPose()). A pixel spacing or
   * principal point that is not known is estimated as without a start; where a part of the pose is held, it is as this
   * geometry has it. Throws in Update() where the two face another way. */
  itkSetConstObjectMacro(InitialGeometry, GeometryType);
  itkGetConstObjectMacro(InitialGeometry, GeometryType);

  // Parts -------------------------------------------------------------------------------------------------------

  /** LevenbergMarquardtOptimizerv4 by default, of which candidates take clones. Any other v4 optimizer runs as it is,
   * in one thread, by its own stop rules, each time over all parameters that are free: its scales and bounds are of so
   * many. An abort ends it at its next evaluation. Its evaluations are IterationEvents of a step that was not accepted,
   * its own IterationEvents those of one that was. Documentation/Pipeline.md says what ITK's optimizers need. */
  itkSetObjectMacro(Optimizer, OptimizerType);
  itkGetModifiableObjectMacro(Optimizer, OptimizerType);

  /** PoseStartSearch by default. */
  itkSetConstObjectMacro(Start, PoseStart);
  itkGetConstObjectMacro(Start, PoseStart);

  /** Kernel of the silhouettes in place of the options' (useRobustKernel), and noise model in place of theirs
   * (useCorrelatedNoise, correlationLength; of the covariance covarianceCorrelationLength). Null: those of the options.
   */
  itkSetConstObjectMacro(RobustKernel, RobustKernel);
  itkGetConstObjectMacro(RobustKernel, RobustKernel);
  itkSetConstObjectMacro(NoiseModel, ResidualNoiseModel);
  itkGetConstObjectMacro(NoiseModel, ResidualNoiseModel);
  itkSetConstObjectMacro(CovarianceNoiseModel, ResidualNoiseModel);
  itkGetConstObjectMacro(CovarianceNoiseModel, ResidualNoiseModel);

  /** A further term of the sum that is minimized, as a metric of one's own. It may read the blocks "pose" and "scale"
   * or have blocks of its own. What it has of a robust kernel and of noise stays as it is set: the method configures
   * the terms that it makes itself, and no others.
   *
   * Jaws that stand apart have a pose each, and a sum each. Where a jaw is given the term is one of that jaw's sum;
   * with Unknown, the default, of every sum. Throws in Update() where that jaw has no mesh or contour. */
  void
  AddMetric(TermType * term, JawEnum jaw = JawEnum::Unknown);
  void
  ClearMetrics();
  const std::vector<TermType::Pointer> &
  GetMetrics() const
  {
    return m_Terms;
  }
  /** The jaw that each of them was given with. */
  const std::vector<JawEnum> &
  GetMetricJaws() const
  {
    return m_TermJaws;
  }

  /** By default OtherSideHypothesis, OtherFacingHypothesis, ExchangedJawsHypothesis, ExchangedLandmarksHypothesis,
   * MillimetreLandmarksHypothesis, OtherSpacingHypothesis, TurnedDrawingHypothesis of one, two and three quarter turns
   * and UpwardDrawingHypothesis. What came of one stands in the solution's PoseGroupResult::outcomes under its code;
   * codes therefore differ. */
  void
  AddHypothesis(const PoseHypothesis * hypothesis);
  void
  ClearHypotheses();

  /** Runs a hypothesis alone, beside the solution of the group that a jaw is of, however good the fit is and whether or
   * not it was added: what it gives is what would stand in the solution's outcomes. Updates the registration first
   * where that is due. Sends the IterationEvents of the trial, and ends with ProcessAborted where an observer aborts.
   *
   * Throws where the jaw was not registered, where the method has a start or held values (any free search would look
   * better), and where PoseHypothesis::GetObstacle() says why the question cannot be asked. */
  PoseHypothesisOutcome
  TryHypothesis(const PoseHypothesis * hypothesis, JawEnum jaw);

  /** Of the views, the terms, the hypotheses and the start as well: a change of one of them runs the registration
   * again. */
  ModifiedTimeType
  GetMTime() const override;

  // While it runs -----------------------------------------------------------------------------------------------

  /** Groups are jaws with a pose of their own; level = 4 group + stage. */
  unsigned int
  GetCurrentLevel() const override
  {
    return m_CurrentLevel;
  }
  itkGetConstMacro(NumberOfLevels, unsigned int);
  /** The step that the last IterationEvent was about. */
  const IterationType &
  GetCurrentIteration() const
  {
    return m_CurrentIteration;
  }
  /** Of the stage; their steps may alternate. */
  unsigned int
  GetCurrentCandidate() const override;
  /** Steps that were accepted in this stage, of this candidate. */
  std::size_t
  GetOptimizerIteration() const override;
  /** Value of the criterion with the kernel width and the noise levels of the step (GetCurrentIteration()): values of
   * one candidate can be compared only as long as these stay. */
  double
  GetMetricValue() const override;
  /** Root mean square motion of the moving contours, px of 0.25 mm. */
  double
  GetStepLength() const override;
  bool
  GetStepAccepted() const override;
  /** pitch, roll, yaw (rad), tx, ty, tz (mm), kappa. */
  OptimizerParameters<double>
  GetOptimizerPosition() const override;
  /** Of the solution of the last group that ended. */
  std::string
  GetOptimizerStopConditionDescription() const override;

  /** The sum of the group that runs, at the position of the last step that is no hypothesis's; null before the first
   * group. It sends IterationEvents at these steps. */
  itkGetModifiableObjectMacro(Metric, MetricType);

  // Outputs -----------------------------------------------------------------------------------------------------

  /** Pose, covariance, candidates, fit. The primary output. */
  SolutionType *
  GetOutput();
  const SolutionType *
  GetOutput() const;
  /** Mesh frame to cephalostat frame, decorated; its Get() is null for a jaw that was not registered. */
  DecoratedTransformType *
  GetTransformOutput(JawEnum jaw);
  const RigidTransformType *
  GetTransform(JawEnum jaw);
  /** Geometry with the pose: ProjectPoint() of a mesh point is its place on the radiograph. */
  GeometryType *
  GetGeometryOutput(JawEnum jaw);

  /** Whether one frame was used for both jaws; valid after Update(). */
  itkGetConstMacro(JawsShareFrame, bool);

  using Superclass::MakeOutput;
  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  PoseRegistrationMethodBase();
  ~PoseRegistrationMethodBase() override;

  void
  VerifyPreconditions() ITKv5_CONST override;
  /** Meshes, contours and a geometry share no physical space that could be compared. */
  void
  VerifyInputInformation() ITKv5_CONST override
  {}
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;
  /** Whether a jaw has a scan, and the scan as flat arrays. */
  virtual bool
  HasMesh(JawEnum jaw) const = 0;
  virtual TriangleSurface
  MakeSurface(JawEnum jaw) const = 0;

private:
  static constexpr unsigned int NumberOfJaws = 2;
  struct InitialType
  {
    RigidTransformType::ConstPointer transform;
    double                           scaleFactor{ 1.0 };
  };
  struct AnsweredType;

  const ContourType *
  GetContour(JawEnum jaw) const;
  /** A contour, or a landmark that has a counterpart. */
  bool
  HasDrawing(JawEnum jaw) const;
  /** With the parts of this object; events that no stage sends are its own to connect. */
  void
  ConnectParts(PoseRegistrationEngine & engine, PoseIterationMonitor & monitor) const;
  [[noreturn]] void
  ThrowAborted();
  void
  UpdateFrames(const std::array<TriangleSurface, NumberOfJaws> & surfaces);
  void
  Report(const IterationType & iteration);

  PoseRegistrationOptions                    m_Options;
  bool                                       m_PrincipalPointKnown{ true };
  std::optional<ScalePrior::SpacingSource>   m_SpacingSource;
  std::array<InitialType, NumberOfJaws>      m_Initial;
  GeometryType::ConstPointer                 m_InitialGeometry;
  OptimizerType::Pointer                     m_Optimizer;
  PoseStart::ConstPointer                    m_Start;
  RobustKernel::ConstPointer                 m_RobustKernel;
  ResidualNoiseModel::ConstPointer           m_NoiseModel;
  ResidualNoiseModel::ConstPointer           m_CovarianceNoiseModel;
  std::vector<CephalogramView::ConstPointer> m_Views;
  std::vector<TermType::Pointer>             m_Terms;
  std::vector<JawEnum>                       m_TermJaws;
  std::vector<PoseHypothesis::ConstPointer>  m_Hypotheses;
  unsigned int                               m_CurrentLevel{ 0 };
  unsigned int                               m_NumberOfLevels{ 4 };
  IterationType                              m_CurrentIteration;
  MetricType::Pointer                        m_Metric;
  bool                                       m_JawsShareFrame{ false };
  std::array<PoseFrame, NumberOfJaws>        m_Frames;
  /** What hypotheses are tried beside: of the solution that stands, without the surfaces. */
  std::unique_ptr<AnsweredType> m_Answered;
};
} // namespace itk

#endif

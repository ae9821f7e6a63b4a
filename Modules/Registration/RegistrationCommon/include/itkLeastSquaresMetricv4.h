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
#ifndef itkLeastSquaresMetricv4_h
#define itkLeastSquaresMetricv4_h

#include "itkContourNoiseModel.h"
#include "itkLeastSquaresMetric.h"
#include "itkRegistrationFit.h"
#include "itkRegistrationState.h"
#include "itkResidualNoiseBlock.h"
#include "itkRobustKernel.h"

#include "itkObjectToObjectMetricBase.h"

#include <functional>
#include <string>
#include <vector>

namespace itk
{
/** \class LeastSquaresMetricv4
 * \brief Base of the metrics whose value is a sum over residuals, and of their sums: terms of one criterion.
 *
 * A term declares the blocks of parameters that it reads and computes its residuals and their derivatives. It is a v4
 * metric: any v4 optimizer takes it, alone or as a term of a LeastSquaresSumMetricv4, which owns the state of the
 * whole.
 *
 * A metric of one's own implements DeclareBlocks(), GetNumberOfResiduals(), ComputeResiduals() (residuals divided by
 * their standard deviation, so that terms can be added) and InternalClone(). Where it is asked for a Jacobian and has
 * none, it calls ComputeJacobianByDifferences(). A setter whose value changes the criterion calls Modified(), as those
 * of itkSetMacro() do, or SettingsChanged() where nothing that was prepared depends on it: by that time a registration
 * knows that it has to run again. What else is virtual here is for metrics with a robust kernel, a noise model or
 * matches, and does nothing by default:
 *
 * - the value is the criterion at the kernel width, noise levels and matching rule as they are set, a fixed function
 * for any optimizer. SetKernelWidth(), SetReach(), SetNoiseLevels(), UpdateNoiseCorrelation() and EstimateNoise()
 * change it, between runs of an optimizer;
 * - Hold(Matches) freezes matches at the current position, and in the residuals their weights, which makes residuals
 * and value differentiable everywhere and equal in value and slope to the free ones there. In the value the weights
 * stay those of the kernel at each position: the value with its charge is the robust criterion, whose slope is that of
 * the residuals' only where the weights are of that position. Tests differentiate both. Hold(Contours) freezes only
 * which samples are matched with: cheaper, for searches that begin far away.
 *
 * Positions: x holds all parameters of this metric's blocks in the order of DeclareBlocks(), natural units. An
 * optimizer sees the free ones, scaled (RegistrationState). As all v4 metrics do, GetDerivative() returns MINUS the
 * gradient. A metric is evaluated by one thread at a time; Clone() gives each thread its own, cheaply, what is constant
 * being shared.
 *
 * \ingroup RegistrationCommon
 */
class RegistrationCommon_EXPORT LeastSquaresMetricv4
  : public ObjectToObjectMetricBaseTemplate<double>
  , public LeastSquaresMetric
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(LeastSquaresMetricv4);

  using Self = LeastSquaresMetricv4;
  using Superclass = ObjectToObjectMetricBaseTemplate<double>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkTypeMacro(LeastSquaresMetricv4, ObjectToObjectMetricBaseTemplate);

  using ParametersType = Superclass::ParametersType;
  using BlockType = RegistrationState::BlockType;
  using BlocksType = RegistrationState::BlocksType;
  using VectorType = vnl_vector<double>;
  using MatrixType = vnl_matrix<double>;
  using PositionType = std::vector<double>;

  // The state ---------------------------------------------------------------------------------------------------

  /** The blocks that this metric reads, with their values before anything else is known. */
  virtual BlocksType
  DeclareBlocks() const = 0;

  /** Of settings, values, what is free, and the fixed and the moving object. */
  ModifiedTimeType
  GetMTime() const override;

  /** Blocks, values and what is free. */
  const RegistrationState &
  GetState() const;
  /** Values of a block, natural units. Initialize() keeps them. */
  void
  SetBlockValues(const std::string & block, const std::vector<double> & values);
  std::vector<double>
  GetBlockValues(const std::string & block) const;
  /** Values of all blocks. */
  void
  SetValues(const PositionType & x);
  /** Which parameters of a block an optimizer may move; the others are removed from its parameters. */
  void
  SetBlockFree(const std::string & block, const std::vector<bool> & isFree);
  void
  SetBlockFree(const std::string & block, bool isFree);

  // What a term computes ------------------------------------------------------------------------------------------

  /** Residuals at x, divided by their standard deviation, and where not null their derivatives: a row a residual, a
   * column a parameter of x. Sizes are set. */
  virtual void
  ComputeResiduals(const PositionType & x, VectorType & residuals, MatrixType * jacobian) const = 0;

  /** The criterion at x; by default the sum of the squared residuals. */
  virtual double
  ComputeValue(const PositionType & x) const;

  /** Its gradient, plus sign; by default 2 J' r. */
  virtual void
  ComputeGradient(const PositionType & x, VectorType & gradient) const;

  /** Adds the squared distances, px^2 of 0.25 mm, that samples of what is matched move by between two positions, and
   * their number. */
  virtual void
  AddSquaredMotion(const PositionType & from, const PositionType & to, double & sum, double & count) const;

  /** Adds how well this metric's evidence is explained at x. */
  virtual void
  AddFit(const PositionType & x, RegistrationFit & fit) const;

  // Kernel and noise ----------------------------------------------------------------------------------------------

  /** Width of the robust kernel, px of 0.25 mm, of every term that has one. */
  virtual void
  SetKernelWidth(double width);
  /** How far from the solution a registration is, in standard deviations of what a whole measurement may be off by: 0,
   * as by default, at the end of a run and wherever a solution is judged. A metric whose kernel lets go of whole
   * measurements, as of outlines of teeth, may widen it so far; others need nothing of it. */
  virtual void
  SetReach(double standardDeviations);
  virtual void
  SetRobustKernel(const RobustKernel * kernel);
  /** Model of the noise, of every term that has one. */
  virtual void
  SetNoiseModel(const ResidualNoiseModel * model);
  /** Levels of the noise, px of 0.25 mm, of every term with this model; of all terms where it is null. */
  virtual void
  SetNoiseLevels(const ContourNoiseLevels & levels, const ResidualNoiseModel * model = nullptr);
  /** False where no term has such noise. */
  virtual bool
  GetNoiseLevels(ContourNoiseLevels & levels, const ResidualNoiseModel * model = nullptr) const;

  /** Takes the correlation of the noise from position x: with which normals the errors of two points hang together. It
   * is held while an optimizer runs, as the levels are, so that the value stays a fixed function; a metric that was not
   * told takes it from the first position that is evaluated. */
  virtual void
  UpdateNoiseCorrelation(const PositionType & x);

  /** Appends the residuals whose noise is to be estimated; x as everywhere. */
  virtual void
  AppendNoiseBlocks(const PositionType & x, std::vector<ResidualNoiseBlock> & blocks) const;

  /** Adds J'J, J'r and r'r of the residuals whose noise is known: of a metric that appends no noise block all of them.
   */
  virtual void
  AddFixedInformation(const PositionType & x, MatrixType & information, VectorType & gradient, double & value) const;

  /** What this metric says of a minimum beside the evidence that EstimateNoise() computes: minus twice a log
   * likelihood, up to a constant, of what is known with its noise. A registration adds it to evidence and priors when
   * it tells several minima apart. By default the criterion, ComputeValue(); where noiseIsEstimated and the metric has
   * levels of noise (GetNoiseLevels()), 0, since the evidence has its residuals. A metric whose value is too sure of
   * itself for that, as one that counts each point of a template's outline, says here what it would bet on. */
  virtual double
  ComputeKnownDeviance(const PositionType & x, bool noiseIsEstimated) const;

  /** Estimates the levels of every noise model by restricted maximum likelihood at the current position, with the free
   * parameters integrated out, and sets them.
   * \return minus twice the restricted log likelihood there.
   * \param minimumWeight weights are taken as at least this: with more than 0 a point that fits nowhere counts against
   * a hypothesis instead of dropping out. */
  double
  EstimateNoise(double minimumWeight = 0.0);

  // Matches ---------------------------------------------------------------------------------------------------------

  /** What stays as it is at the current position while the parameters move. */
  enum class HoldEnum : uint8_t
  {
    /** Everything follows the parameters. */
    Nothing,
    /** The samples of a contour move as points of the scan do; they are not made anew. */
    Contours,
    /** Samples, which of them is matched with which and directions; the weights in the residuals, not in the value. */
    Matches
  };
  virtual void
  Hold(HoldEnum what); /**< Until it is called again; Nothing lets all follow. */

  // In a registration ------------------------------------------------------------------------------------------------

  /** From when on a registration evaluates a term. */
  enum class JoinsEnum : std::uint8_t
  {
    /** The search for where to begin. */
    Start,
    /** The first steps from each start. For terms that say nothing far from the solution, and for those of another
     * radiograph, whose pixels mean nothing in the first one's. */
    Candidates,
    /** The last refinement of what is left. For terms that mislead some millimetres beside the solution. */
    Refinement
  };
  /** Default Start. Cloned with the state. */
  void
  SetJoins(JoinsEnum joins);
  JoinsEnum
  GetJoins() const
  {
    return m_Joins;
  }

  // v4 --------------------------------------------------------------------------------------------------------------

  /** Prepares the evaluation. Throws where something is missing or no parameter is free. */
  void
  Initialize() override;

  MeasureType
  GetValue() const override;
  void
  GetDerivative(DerivativeType & derivative) const override;
  void
  GetValueAndDerivative(MeasureType & value, DerivativeType & derivative) const override;
  NumberOfParametersType
  GetNumberOfParameters() const override;
  NumberOfParametersType
  GetNumberOfLocalParameters() const override;
  void
  SetParameters(ParametersType & parameters) override;
  const ParametersType &
  GetParameters() const override;
  bool
  HasLocalSupport() const override
  {
    return false;
  }
  void
  UpdateTransformParameters(const DerivativeType & derivative, ParametersValueType factor) override;

  /** Called before each evaluation that an optimizer asks for (GetValue(), GetDerivative(), both, or GetResiduals()),
   * in its thread. What it throws ends the optimizer's run: most of ITK's optimizers ask nobody else whether to go on.
   * Not cloned. */
  using EvaluationCallbackType = std::function<void()>;
  void
  SetEvaluationCallback(EvaluationCallbackType callback);

  // LeastSquaresMetric ------------------------------------------------------------------------------------------------

  void
  GetResiduals(VectorType & residuals, MatrixType * jacobian) const override;
  /** Root mean square motion in px of 0.25 mm; the norm of the step where nothing is matched. */
  double
  GetStepLength(const ParametersType & from, const ParametersType & to) const override;
  ParametersType
  GetMaximumSteps() const override;

protected:
  LeastSquaresMetricv4() = default;
  ~LeastSquaresMetricv4() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

  /** Checks the inputs and prepares what is constant. Called by Initialize(). */
  virtual void
  InitializeTerm();

  /** Jacobian of ComputeResiduals() by central differences, for metrics without derivatives of their own: a step of
   * 1e-5 over the parameter's scale. */
  void
  ComputeJacobianByDifferences(const PositionType & x, MatrixType & jacobian) const;

  /** To be called by setters of what changes the criterion and nothing that was prepared, as a kernel's width. */
  void
  SettingsChanged();

  /** Another metric like this one: made with New(), its members those of this one, its state by CopyState(). Every
   * class implements it, one without members too: a registration evaluates clones, one a thread, and what is not copied
   * has its default there without a word. */
  LightObject::Pointer
  InternalClone() const override = 0;

  /** A copy of a metric that another one has as a part, for InternalClone(). Throws where it is of another class: that
   * of a class that inherits InternalClone() is one of its base class, or by ITK's default none, and would be another
   * metric, without a word. */
  static Pointer
  CloneTerm(const Self & term);

  /** Copies state, parameters and Joins of another metric of the same blocks, for InternalClone(). */
  void
  CopyState(const Self & other);

private:
  /** Adds the declared blocks that are not there yet, and drops those that are declared no longer. */
  void
  UpdateBlocks() const;
  void
  StateChanged();
  void
  AnnounceEvaluation() const;
  MeasureType
  EvaluateValue() const;
  void
  EvaluateDerivative(DerivativeType & derivative) const;

  /** Changes with values, what is free, kernel and noise: nothing that was prepared depends on them, so that it stays
   * valid. */
  TimeStamp m_CriterionTime;

  mutable RegistrationState m_State;
  mutable ParametersType    m_Parameters;
  EvaluationCallbackType    m_EvaluationCallback;
  JoinsEnum                 m_Joins{ JoinsEnum::Start };

  friend class LeastSquaresSumMetricv4;
};
} // namespace itk

#endif

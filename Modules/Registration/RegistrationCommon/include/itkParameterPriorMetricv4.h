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
#ifndef itkParameterPriorMetricv4_h
#define itkParameterPriorMetricv4_h

#include "itkLeastSquaresMetricv4.h"

#include <string>
#include <vector>

namespace itk
{
/** \class ParameterPriorMetricv4
 * \brief What is known of a block's parameters beforehand, as a term: Gaussian, or Student's t with long tails.
 *
 * Each parameter has a mean, a standard deviation s (infinity: nothing is known, no residual) and degrees of freedom n
 * of a t distribution; up to 2 is Gaussian. With d the difference from the mean the value is, Gaussian, d^2/s^2, and
 * for the t distribution of that standard deviation minus twice its log density, (n + 1) log(1 + d^2 / ((n - 2) s^2)):
 * tight where most are, and yet willing to let a far value be. Its residual is d times the root of the precision (n +
 * 1) / ((n - 2) s^2 + d^2), whose square has the derivative of that value (a quadratic majoriser).
 *
 * For a covariance the precision that belongs to the distribution's variance is the honest one
 * (UseVariancePrecision): (n - 2) / ((n - 2) s^2 + d^2).
 *
 * \ingroup RegistrationCommon
 */
class RegistrationCommon_EXPORT ParameterPriorMetricv4 : public LeastSquaresMetricv4
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ParameterPriorMetricv4);

  using Self = ParameterPriorMetricv4;
  using Superclass = LeastSquaresMetricv4;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(ParameterPriorMetricv4, LeastSquaresMetricv4);

  /** Prior of one parameter, natural units. */
  struct PriorType
  {
    double mean{ 0.0 };             /**< Where the parameter is expected. */
    double sigma{ 1.0 };            /**< Its standard deviation, or the scale of Student's t. */
    double degreesOfFreedom{ 0.0 }; /**< Of Student's t; 0: Gaussian. */
  };

  /** The block that this is about, with its parameters; must be set. */
  void
  SetBlock(const BlockType & block);
  const BlockType &
  GetBlock() const
  {
    return m_Block;
  }
  /** One a parameter of the block. */
  void
  SetPriors(const std::vector<PriorType> & priors);
  const std::vector<PriorType> &
  GetPriors() const
  {
    return m_Priors;
  }
  /** Whether Student's t counts with the precision of its variance instead of that of its peak. Off by default. */
  itkSetMacro(UseVariancePrecision, bool);
  itkGetConstMacro(UseVariancePrecision, bool);
  itkBooleanMacro(UseVariancePrecision);

  /** Precision of a prior at a value: what the residual's square is d^2 times. */
  static double
  GetPrecision(const PriorType & prior, double value, bool forVariance);
  /** Minus twice the log density at a value, 0 at the mean. */
  static double
  GetDeviance(const PriorType & prior, double value);

  BlocksType
  DeclareBlocks() const override;
  SizeValueType
  GetNumberOfResiduals() const override;
  void
  ComputeResiduals(const PositionType & x, VectorType & residuals, MatrixType * jacobian) const override;
  double
  ComputeValue(const PositionType & x) const override;
  void
  Hold(HoldEnum what) override;

protected:
  ParameterPriorMetricv4() = default;
  ~ParameterPriorMetricv4() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;
  void
  InitializeTerm() override;
  LightObject::Pointer
  InternalClone() const override;

private:
  /** Throws unless there is one prior a parameter; priors may have been set since Initialize(). */
  void
  VerifyPriors(const PositionType & x) const;

  BlockType              m_Block;
  std::vector<PriorType> m_Priors;
  bool                   m_UseVariancePrecision{ false };
  /** Where the precisions are held, or empty. */
  PositionType m_HeldPosition;
};
} // namespace itk

#endif

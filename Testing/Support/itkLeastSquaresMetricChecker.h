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
#ifndef itkLeastSquaresMetricChecker_h
#define itkLeastSquaresMetricChecker_h

#include "itkLeastSquaresMetricv4.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

/** What every LeastSquaresMetricv4 promises, checked on any of them: derivatives against differences, what holding
 * leaves as it is, clones, masks. Whoever writes a metric calls Check() in a test of it, with an initialised metric at
 * a position of no symmetry; it stands where it stood afterwards, free.
 *
 * Here, beside the test headers that several modules share, and not among the library's: it needs GoogleTest. */
namespace LeastSquaresMetricChecker
{
using MetricType = itk::LeastSquaresMetricv4;
using HoldEnum = MetricType::HoldEnum;
using ParametersType = MetricType::ParametersType;
using VectorType = MetricType::VectorType;
using MatrixType = MetricType::MatrixType;

struct Settings
{
  /** Half of a central difference, in the optimizer's units (mm, or what the scales say). */
  double step{ 1e-3 };
  /** Of the largest of a parameter's derivatives: differences of second order leave the step's square times the third
   * derivative, and rounding over the step. */
  double jacobianTolerance{ 1e-6 };
  /** Of the length of the gradient, the same. */
  double gradientTolerance{ 1e-6 };
  /** Of the value, and of the length of the gradient: how far the held ones may be from the free ones where they are
   * held. Only rounding, for a metric whose contours are not rounded when they are made. */
  double heldTolerance{ 1e-12 };
  /** Whether twice J'r is the gradient of the value, as of a sum of squares and of every majoriser. */
  bool residualsHaveTheGradient{ true };
};

inline void
MoveTo(MetricType & metric, const ParametersType & position)
{
  ParametersType copy = position;
  metric.SetParameters(copy);
}

inline double
ValueAt(MetricType & metric, const ParametersType & position)
{
  MoveTo(metric, position);
  return metric.GetValue();
}

/** Plus the gradient. */
inline VectorType
GradientOf(const MetricType & metric)
{
  MetricType::DerivativeType derivative;
  metric.GetDerivative(derivative);
  VectorType gradient(derivative.Size());
  for (unsigned int k = 0; k < gradient.size(); ++k)
  {
    gradient[k] = -derivative[k];
  }
  return gradient;
}

inline void
CheckSizes(MetricType & metric)
{
  const auto count = static_cast<unsigned int>(metric.GetNumberOfParameters());
  VectorType residuals;
  MatrixType jacobian;
  metric.GetResiduals(residuals, &jacobian);
  EXPECT_EQ(residuals.size(), metric.GetNumberOfResiduals());
  EXPECT_EQ(jacobian.rows(), residuals.size());
  EXPECT_EQ(jacobian.cols(), count);
  EXPECT_EQ(metric.GetParameters().Size(), count);
  EXPECT_EQ(metric.GetNumberOfLocalParameters(), count);
  EXPECT_EQ(metric.GetMaximumSteps().Size(), count);
  EXPECT_EQ(metric.GetState().GetNumberOfFreeParameters(), count);
  EXPECT_EQ(GradientOf(metric).size(), count);
  EXPECT_FALSE(metric.HasLocalSupport());
  // The same with and without a Jacobian, and in one call or two.
  VectorType alone;
  metric.GetResiduals(alone, nullptr);
  EXPECT_EQ(alone, residuals);
  double                     value = 0.0;
  MetricType::DerivativeType derivative;
  metric.GetValueAndDerivative(value, derivative);
  EXPECT_EQ(value, metric.GetValue());
  for (unsigned int k = 0; k < count; ++k)
  {
    EXPECT_EQ(-derivative[k], GradientOf(metric)[k]);
  }
  // The values of the blocks declared are what an optimizer sees, scaled.
  const itk::RegistrationState & state = metric.GetState();
  std::size_t                    declared = 0;
  for (const auto & block : metric.DeclareBlocks())
  {
    ASSERT_TRUE(state.HasBlock(block.name)) << block.name;
    declared += block.parameters.size();
  }
  EXPECT_EQ(state.GetNumberOfParameters(), declared);
  for (unsigned int k = 0; k < count; ++k)
  {
    const double natural = state.GetValues()[state.GetFreeIndices()[k]];
    EXPECT_NEAR(metric.GetParameters()[k], natural * state.GetFreeScale(k), 1e-14 * std::abs(natural));
  }
  EXPECT_EQ(metric.GetStepLength(metric.GetParameters(), metric.GetParameters()), 0.0);
}

/** With matches, directions and weights held. */
inline void
CheckJacobian(MetricType & metric, const Settings & settings)
{
  const ParametersType position = metric.GetParameters();
  metric.Hold(HoldEnum::Matches);
  VectorType residuals;
  MatrixType jacobian;
  metric.GetResiduals(residuals, &jacobian);
  for (unsigned int k = 0; k < jacobian.cols(); ++k)
  {
    ParametersType before = position;
    ParametersType after = position;
    before[k] -= settings.step;
    after[k] += settings.step;
    VectorType low, high;
    MoveTo(metric, before);
    metric.GetResiduals(low, nullptr);
    MoveTo(metric, after);
    metric.GetResiduals(high, nullptr);
    double largest = 0.0;
    for (unsigned int i = 0; i < jacobian.rows(); ++i)
    {
      largest = std::max(largest, std::abs(jacobian(i, k)));
    }
    for (unsigned int i = 0; i < jacobian.rows(); ++i)
    {
      EXPECT_NEAR((high[i] - low[i]) / (2.0 * settings.step), jacobian(i, k), settings.jacobianTolerance * largest)
        << "residual " << i << ", parameter " << k;
    }
  }
  MoveTo(metric, position);
  metric.Hold(HoldEnum::Nothing);
}

/** MINUS the gradient, as v4 metrics return it. */
inline void
CheckDerivative(MetricType & metric, const Settings & settings)
{
  const ParametersType position = metric.GetParameters();
  metric.Hold(HoldEnum::Matches);
  const VectorType           gradient = GradientOf(metric);
  MetricType::DerivativeType derivative;
  metric.GetDerivative(derivative);
  for (unsigned int k = 0; k < gradient.size(); ++k)
  {
    ParametersType before = position;
    ParametersType after = position;
    before[k] -= settings.step;
    after[k] += settings.step;
    const double slope = (ValueAt(metric, after) - ValueAt(metric, before)) / (2.0 * settings.step);
    EXPECT_NEAR(derivative[k], -slope, settings.gradientTolerance * gradient.magnitude()) << "parameter " << k;
  }
  MoveTo(metric, position);
  metric.Hold(HoldEnum::Nothing);
}

/** Value and slope held are the free ones at the position where they are held. */
inline void
CheckHeldIsFreeWhereItIsHeld(MetricType & metric, const Settings & settings)
{
  VectorType   residuals;
  const double value = metric.GetValue();
  const auto   gradient = GradientOf(metric);
  metric.GetResiduals(residuals, nullptr);
  for (const HoldEnum what : { HoldEnum::Contours, HoldEnum::Matches })
  {
    metric.Hold(what);
    VectorType held;
    metric.GetResiduals(held, nullptr);
    EXPECT_NEAR(metric.GetValue(), value, settings.heldTolerance * std::abs(value)) << static_cast<int>(what);
    EXPECT_LE((GradientOf(metric) - gradient).magnitude(), settings.heldTolerance * gradient.magnitude())
      << static_cast<int>(what);
    EXPECT_LE((held - residuals).magnitude(), settings.heldTolerance * residuals.magnitude()) << static_cast<int>(what);
  }
  metric.Hold(HoldEnum::Nothing);
  EXPECT_EQ(metric.GetValue(), value) << "let go, everything is as it was";
}

inline void
CheckResidualsHaveTheGradient(MetricType & metric, const Settings & settings)
{
  VectorType residuals;
  MatrixType jacobian;
  metric.GetResiduals(residuals, &jacobian);
  const VectorType gradient = GradientOf(metric);
  const VectorType ofResiduals = 2.0 * (residuals * jacobian);
  EXPECT_LE((ofResiduals - gradient).magnitude(), settings.gradientTolerance * gradient.magnitude());
}

/** A clone gives the same bits where its original stands and elsewhere, and goes its own way. */
inline void
CheckClone(MetricType & metric)
{
  const ParametersType            position = metric.GetParameters();
  const itk::LightObject::Pointer copy = metric.Clone().GetPointer();
  auto *                          clone = dynamic_cast<MetricType *>(copy.GetPointer());
  ASSERT_NE(clone, nullptr);
  EXPECT_STREQ(clone->GetNameOfClass(), metric.GetNameOfClass());
  EXPECT_EQ(clone->GetParameters(), position);
  const auto expectSame = [&]() {
    VectorType residuals, cloned;
    MatrixType jacobian, clonedJacobian;
    EXPECT_EQ(clone->GetValue(), metric.GetValue());
    EXPECT_EQ(GradientOf(*clone), GradientOf(metric));
    metric.GetResiduals(residuals, &jacobian);
    clone->GetResiduals(cloned, &clonedJacobian);
    EXPECT_EQ(cloned, residuals);
    EXPECT_EQ(clonedJacobian, jacobian);
  };
  clone->Initialize();
  expectSame();
  ParametersType elsewhere = position;
  for (unsigned int k = 0; k < elsewhere.Size(); ++k)
  {
    elsewhere[k] += k % 2 == 0 ? 0.3 : -0.2;
  }
  MoveTo(*clone, elsewhere);
  EXPECT_EQ(metric.GetParameters(), position);
  MoveTo(metric, elsewhere);
  expectSame();
  // One that is made on the way, too: the value is a fixed function, not one of where it was evaluated first.
  const itk::LightObject::Pointer copyOnTheWay = metric.Clone().GetPointer();
  clone = dynamic_cast<MetricType *>(copyOnTheWay.GetPointer());
  expectSame();
  MoveTo(metric, position);
  MoveTo(*clone, position);
  expectSame();
  // What is held stays held in a clone made then.
  metric.Hold(HoldEnum::Matches);
  const itk::LightObject::Pointer heldCopy = metric.Clone().GetPointer();
  clone = dynamic_cast<MetricType *>(heldCopy.GetPointer());
  MoveTo(metric, elsewhere);
  MoveTo(*clone, elsewhere);
  expectSame();
  MoveTo(metric, position);
  metric.Hold(HoldEnum::Nothing);
}

/** A parameter that is held leaves the optimizer's parameters, and nothing else changes. */
inline void
CheckMasks(MetricType & metric)
{
  VectorType residuals;
  MatrixType jacobian;
  metric.GetResiduals(residuals, &jacobian);
  const double                             value = metric.GetValue();
  const VectorType                         gradient = GradientOf(metric);
  const ParametersType                     position = metric.GetParameters();
  const itk::RegistrationState::BlocksType blocks = metric.GetState().GetBlocks();
  unsigned int                             column = 0;
  for (const auto & block : blocks)
  {
    std::vector<bool> before;
    for (const auto & parameter : block.parameters)
    {
      before.push_back(parameter.isFree);
    }
    for (std::size_t k = 0; k < before.size(); ++k)
    {
      if (!before[k] || position.Size() == 1)
      {
        continue;
      }
      std::vector<bool> isFree = before;
      isFree[k] = false;
      metric.SetBlockFree(block.name, isFree);
      ASSERT_EQ(metric.GetNumberOfParameters(), position.Size() - 1) << block.name << ' ' << k;
      VectorType others;
      MatrixType otherJacobian;
      metric.GetResiduals(others, &otherJacobian);
      const VectorType otherGradient = GradientOf(metric);
      EXPECT_EQ(metric.GetValue(), value);
      EXPECT_EQ(others, residuals);
      ASSERT_EQ(otherJacobian.cols(), jacobian.cols() - 1);
      for (unsigned int a = 0; a + 1 < position.Size(); ++a)
      {
        const unsigned int from = a < column ? a : a + 1;
        EXPECT_EQ(metric.GetParameters()[a], position[from]);
        EXPECT_EQ(otherGradient[a], gradient[from]);
        EXPECT_EQ(otherJacobian.get_column(a), jacobian.get_column(from));
      }
      ++column;
    }
    metric.SetBlockFree(block.name, before);
  }
  EXPECT_EQ(metric.GetParameters(), position);
}

inline void
CheckUpdate(MetricType & metric)
{
  const ParametersType       position = metric.GetParameters();
  MetricType::DerivativeType update(position.Size());
  for (unsigned int k = 0; k < position.Size(); ++k)
  {
    update[k] = 0.1 * (k + 1);
  }
  metric.UpdateTransformParameters(update, 0.5);
  for (unsigned int k = 0; k < position.Size(); ++k)
  {
    EXPECT_EQ(metric.GetParameters()[k], position[k] + 0.5 * update[k]);
  }
  EXPECT_THROW(metric.UpdateTransformParameters(MetricType::DerivativeType(position.Size() + 1), 1.0),
               itk::ExceptionObject);
  MoveTo(metric, position);
}

inline void
Check(MetricType & metric, const Settings & settings = Settings())
{
  CheckSizes(metric);
  CheckJacobian(metric, settings);
  CheckDerivative(metric, settings);
  CheckHeldIsFreeWhereItIsHeld(metric, settings);
  if (settings.residualsHaveTheGradient)
  {
    CheckResidualsHaveTheGradient(metric, settings);
  }
  CheckClone(metric);
  CheckMasks(metric);
  CheckUpdate(metric);
}
} // namespace LeastSquaresMetricChecker

#endif

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
#ifndef itkLeastSquaresFunctionMetricv4_h
#define itkLeastSquaresFunctionMetricv4_h

#include "RegistrationCommonExport.h"
#include "itkLeastSquaresMetricv4.h"

#include <functional>
#include <vector>

namespace itk
{
/** \class LeastSquaresFunctionMetricv4
 * \brief A term whose residuals a function gives: the shortest way to a metric of one's own.
 *
 * The metric needs to be told two things: which blocks of parameters the function reads, and the function, which takes
 * their values one after another (natural units) and returns the residuals, each divided by its standard deviation.
 * Derivatives are found by differences, and clones copy the function with what it holds, so that nothing else has to be
 * written, as of Ceres' cost functors:
 *
 * \code
 * auto term = itk::LeastSquaresFunctionMetricv4::New();
 * term->SetBlocks({ itk::PoseStateBlocks::MakePose() });
 * term->SetFunction([](const std::vector<double> & pose) { return std::vector<double>{ (pose[5] - 3.0) / 0.5 }; });
 * registration->AddMetric(term);
 * \endcode
 *
 * Clones call the function in several threads at once: what it holds by reference or pointer must not change then. It
 * must be smooth, and of the same number of residuals wherever it is called. A term with derivatives of its own, a
 * robust kernel, a noise model or matches derives from LeastSquaresMetricv4 instead.
 *
 * Errors (ExceptionObject): no blocks, no function, no residuals, another number of residuals than before, a residual
 * that is not finite.
 *
 * \ingroup RegistrationCommon
 * \test itkLeastSquaresFunctionMetricv4GTest.cxx
 */
class RegistrationCommon_EXPORT LeastSquaresFunctionMetricv4 : public LeastSquaresMetricv4
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(LeastSquaresFunctionMetricv4);

  using Self = LeastSquaresFunctionMetricv4;
  using Superclass = LeastSquaresMetricv4;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(LeastSquaresFunctionMetricv4, LeastSquaresMetricv4);

  using FunctionType = std::function<std::vector<double>(const PositionType & x)>;

  /** What the function reads, with the values before anything else is known. */
  void
  SetBlocks(const BlocksType & blocks);
  BlocksType
  DeclareBlocks() const override;

  /** The residuals at the values of the blocks, in their order. */
  void
  SetFunction(FunctionType function);

  /** As many as the function returned when the metric was initialized; before that it is called. */
  SizeValueType
  GetNumberOfResiduals() const override;

  void
  ComputeResiduals(const PositionType & x, VectorType & residuals, MatrixType * jacobian) const override;

protected:
  LeastSquaresFunctionMetricv4() = default;
  ~LeastSquaresFunctionMetricv4() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;
  void
  InitializeTerm() override;
  LightObject::Pointer
  InternalClone() const override;

private:
  std::vector<double>
  CallFunction(const PositionType & x) const;

  BlocksType   m_Blocks;
  FunctionType m_Function;
  /** 0 before the metric is initialized. */
  SizeValueType m_NumberOfResiduals{ 0 };
};
} // namespace itk

#endif

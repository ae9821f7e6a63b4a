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
#ifndef itkLeastSquaresSumMetricv4_h
#define itkLeastSquaresSumMetricv4_h

#include "itkLeastSquaresMetricv4.h"

#include <vector>

namespace itk
{
/** \class LeastSquaresSumMetricv4
 * \brief Sum of metrics over one state: jaws, views, landmarks, priors, whatever a user writes.
 *
 * The sum's state is the union of its terms' blocks, in the order in which the terms were added; a term's own values
 * and what is free there are the sum's from the moment it is added. A term that is to count more or less says so in its
 * residuals' standard deviations. A sum is a metric and may be a term. Kernel and noise that are set on the sum are
 * set on all terms but those that were added with settings of their own.
 *
 * (ObjectToObjectMultiMetricv4 of ITK cannot serve: its metrics share one transform object, and there is none here.)
 *
 * Clone() clones the terms. Errors (ExceptionObject): no term; a term that is the sum itself; blocks of one name and
 * different sizes.
 *
 * \ingroup RegistrationCommon
 */
class RegistrationCommon_EXPORT LeastSquaresSumMetricv4 : public LeastSquaresMetricv4
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(LeastSquaresSumMetricv4);

  using Self = LeastSquaresSumMetricv4;
  using Superclass = LeastSquaresMetricv4;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(LeastSquaresSumMetricv4, LeastSquaresMetricv4);

  using MetricType = LeastSquaresMetricv4;

  /** Whose a term's robust kernel and noise are. */
  enum class SettingsEnum : uint8_t
  {
    /** The sum's: SetRobustKernel(), SetKernelWidth(), SetNoiseModel(), SetNoiseLevels() and EstimateNoise() reach it.
     */
    OfTheSum,
    /** Its own: they stay as the term has them, and its residuals count in EstimateNoise() as what is known. */
    Own
  };

  /** Appends a term. The values of its blocks are taken over where the sum has not had such a block before. */
  void
  AddMetric(MetricType * metric, SettingsEnum settings = SettingsEnum::OfTheSum);
  void
  RemoveMetric(const MetricType * metric);
  SizeValueType
  GetNumberOfMetrics() const
  {
    return m_Metrics.size();
  }
  MetricType *
  GetMetric(SizeValueType index) const;
  SettingsEnum
  GetMetricSettings(SizeValueType index) const;

  /** Of the terms as well. */
  ModifiedTimeType
  GetMTime() const override;

  BlocksType
  DeclareBlocks() const override;
  SizeValueType
  GetNumberOfResiduals() const override;
  void
  ComputeResiduals(const PositionType & x, VectorType & residuals, MatrixType * jacobian) const override;
  double
  ComputeValue(const PositionType & x) const override;
  void
  ComputeGradient(const PositionType & x, VectorType & gradient) const override;
  void
  AddSquaredMotion(const PositionType & from, const PositionType & to, double & sum, double & count) const override;
  void
  AddFit(const PositionType & x, RegistrationFit & fit) const override;
  void
  SetReach(double standardDeviations) override;
  void
  SetKernelWidth(double width) override;
  void
  SetRobustKernel(const RobustKernel * kernel) override;
  void
  SetNoiseModel(const ResidualNoiseModel * model) override;
  void
  SetNoiseLevels(const ContourNoiseLevels & levels, const ResidualNoiseModel * model = nullptr) override;
  bool
  GetNoiseLevels(ContourNoiseLevels & levels, const ResidualNoiseModel * model = nullptr) const override;
  /** The sum over the terms; the noise of those that were added with settings of their own is not estimated here. */
  double
  ComputeKnownDeviance(const PositionType & x, bool noiseIsEstimated) const override;
  void
  UpdateNoiseCorrelation(const PositionType & x) override;
  void
  AppendNoiseBlocks(const PositionType & x, std::vector<ResidualNoiseBlock> & blocks) const override;
  void
  AddFixedInformation(const PositionType & x,
                      MatrixType &         information,
                      VectorType &         gradient,
                      double &             value) const override;
  void
  Hold(HoldEnum what) override;

  /** The part of a position of the sum that a term reads. */
  PositionType
  GetTermPosition(SizeValueType index, const PositionType & x) const;

protected:
  LeastSquaresSumMetricv4() = default;
  ~LeastSquaresSumMetricv4() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;
  void
  InitializeTerm() override;
  LightObject::Pointer
  InternalClone() const override;

private:
  struct TermType
  {
    MetricType::Pointer metric;
    SettingsEnum        settings{ SettingsEnum::OfTheSum };
    /** Place among the sum's parameters of each of the term's. */
    std::vector<std::size_t> places;
  };
  void
  UpdatePlaces() const;

  mutable std::vector<TermType> m_Metrics;
};
} // namespace itk

#endif

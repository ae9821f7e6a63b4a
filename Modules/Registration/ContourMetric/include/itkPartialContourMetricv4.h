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
#ifndef itkPartialContourMetricv4_h
#define itkPartialContourMetricv4_h

#include "itkContourToContourMetricv4.h"
#include "itkLeastSquaresMetric.h"
#include "itkPartialContourKernel.h"

#include "vnl/vnl_matrix_fixed.h"

namespace itk
{
/** \class PartialContourMetricv4
 * \brief Distance between an open tracing and a contour that it covers in part, for v4 and least-squares optimizers.
 *
 * Every point of the tracing counts, through a robust kernel; the moving contour's points count, with a weight of 0
 * (off) and up, only where the tracing could have had a point. Options: line directions beside positions, tooth codes
 * as a gate, points' weights (the contours'), Gaussian priors on the similarity, and noise that is correlated along the
 * tracing (generalised least squares). PartialContourKernel has the formulas. The value is a mean square, px^2 of the
 * fixed contour.
 *
 * Annealing: StartLevel(), which SilhouetteToContourRegistrationMethod calls, goes from InitialKernelWidth at the first
 * level to FinalKernelWidth at the last in equal ratios (graduated non-convexity), and with CorrelatedNoise estimates
 * the noise at the start of the last NumberOfCorrelatedLevels levels. Observers of MultiResolutionIterationEvent may
 * call SetKernelWidth() and UpdateNoiseModel() as well. Without a registration method call them yourself.
 *
 * Use: contours, transform, Initialize(), then an optimizer's SetMetric(): any v4 optimizer;
 * LevenbergMarquardtOptimizerv4; or itk::LevenbergMarquardtOptimizer through LeastSquaresMetricCostFunction. What the
 * optimizer's parameters mean is said in ContourToContourMetricv4. Beyond the bounds the residuals are those at the
 * nearest position within and the excess, so that value and sum of squares grow there alike. At a bound the Jacobian is
 * the one-sided derivative: of a parameter that the residuals push outwards it is that of the excess alone, so that
 * least-squares solvers slide along the bound.
 *
 * The defaults are what did best on simulated cases, Documentation/Metric.md; priors and the reverse direction are the
 * user's to add.
 *
 * Settings take effect at the next Initialize(), but for SetKernelWidth(). Errors (ExceptionObject): widths, lengths
 * and sigmas that are not positive, weights that are negative.
 *
 * \ingroup ContourMetric
 */
class ContourMetric_EXPORT PartialContourMetricv4
  : public ContourToContourMetricv4
  , public LeastSquaresMetric
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(PartialContourMetricv4);

  using Self = PartialContourMetricv4;
  using Superclass = ContourToContourMetricv4;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(PartialContourMetricv4, ContourToContourMetricv4);

  // Both bases name it.
  using ParametersType = Superclass::ParametersType;

  using RobustKernelEnum = ContourMetricEnums::RobustKernel;
  using SpacingSourceEnum = ContourMetricEnums::SpacingSource;
  using CovarianceType = vnl_matrix_fixed<double, NumberOfParameters, NumberOfParameters>;

  /** GemanMcClure (default), Huber or Squares. */
  itkSetEnumMacro(RobustKernel, RobustKernelEnum);
  itkGetEnumMacro(RobustKernel, RobustKernelEnum);

  /** Width c of the kernel now, px; 5 by default. Effective at once; a noise model keeps the weights it has. */
  virtual void
  SetKernelWidth(double width);
  itkGetConstMacro(KernelWidth, double);

  /** Whether StartLevel() sets the width; on by default, from 12 to 5 px. */
  itkSetMacro(Annealing, bool);
  itkGetConstMacro(Annealing, bool);
  itkBooleanMacro(Annealing);
  itkSetMacro(InitialKernelWidth, double);
  itkGetConstMacro(InitialKernelWidth, double);
  itkSetMacro(FinalKernelWidth, double);
  itkGetConstMacro(FinalKernelWidth, double);

  /** Pixels that a right angle between the line directions counts, 8 by default; 0: position alone. */
  itkSetMacro(DirectionWeight, double);
  itkGetConstMacro(DirectionWeight, double);
  /** Sigma of the smoothing of directions along the contours, px; 5 by default. */
  itkSetMacro(DirectionSmoothing, double);
  itkGetConstMacro(DirectionSmoothing, double);

  /** Weight of the censored direction from the moving contour to the tracing, a stretch of contour against the same
   * stretch; 0 (default) leaves it out. */
  itkSetMacro(ReverseWeight, double);
  itkGetConstMacro(ReverseWeight, double);
  /** The reverse direction fades in over this length from an end of the tracing, px; 6 by default. */
  itkSetMacro(TaperLength, double);
  itkGetConstMacro(TaperLength, double);
  /** Ends of two polylines of the tracing that are closer than this are no ends, px; 8 by default. */
  itkSetMacro(GapLength, double);
  itkGetConstMacro(GapLength, double);

  /** Match points that carry tooth codes with the same tooth or one up to ToothRange positions away; on by default,
   * range 1. Sides are not told apart. Points without code match everything. */
  itkSetMacro(GateByTooth, bool);
  itkGetConstMacro(GateByTooth, bool);
  itkBooleanMacro(GateByTooth);
  itkSetMacro(ToothRange, unsigned int);
  itkGetConstMacro(ToothRange, unsigned int);

  /** Whether StartLevel() calls UpdateNoiseModel() in the last NumberOfCorrelatedLevels levels; off by default, 2. The
   * fit of a similarity does not gain by it (Documentation/Metric.md): call UpdateNoiseModel() after a registration for
   * an honest covariance. */
  itkSetMacro(CorrelatedNoise, bool);
  itkGetConstMacro(CorrelatedNoise, bool);
  itkBooleanMacro(CorrelatedNoise);
  itkSetMacro(NumberOfCorrelatedLevels, unsigned int);
  itkGetConstMacro(NumberOfCorrelatedLevels, unsigned int);
  /** Length over which the drift of the hand is correlated along the tracing, px; 12 by default. */
  itkSetMacro(CorrelationLength, double);
  itkGetConstMacro(CorrelationLength, double);
  /** Standard deviations of the drift and of the white part, px: those in use, or where the estimation starts. */
  itkSetMacro(SmoothNoise, double);
  itkGetConstMacro(SmoothNoise, double);
  itkSetMacro(WhiteNoise, double);
  itkGetConstMacro(WhiteNoise, double);
  /** Estimate both by restricted maximum likelihood; on by default. */
  itkSetMacro(EstimateNoise, bool);
  itkGetConstMacro(EstimateNoise, bool);
  itkBooleanMacro(EstimateNoise);

  /** Gaussian priors. A sigma of infinity (default) leaves the parameter free. Scale: mean, and sigma of its logarithm
   * (0.02: 2 %). Rotation: rad. Translation: the moving point `at` lands on `position`, sigma px in each coordinate.
   */
  virtual void
  SetScalePrior(double scale, double relativeSigma);
  virtual void
  SetRotationPrior(double angle, double sigma);
  virtual void
  SetTranslationPrior(const PointType & at, const PointType & position, double sigma);
  const PartialContourPrior &
  GetPrior() const
  {
    return m_Prior;
  }

  /** Relative sigma of the scale (spacing x magnification) by where the spacing comes from: 1.6 % for the magnification
   * of an unknown patient in a known spacing (PoseRegistration's), 5 % for a DICOM file, whose spacing may be that of
   * the detector or of the film, 25 % for an assumed or estimated one. */
  static double
  GetScaleSigma(SpacingSourceEnum source);

  /** Estimates weights and noise at the current position and makes the value generalised least squares from now on.
   * False, and nothing changed, where no point of the tracing has any weight left. */
  virtual bool
  UpdateNoiseModel();
  /** Back to the robust kernel with independent points. */
  virtual void
  ForgetNoiseModel();
  bool
  HasNoiseModel() const
  {
    return m_Kernel.HasCorrelatedNoise();
  }
  /** In use: estimated, or as set. px */
  const ContourNoiseLevels &
  GetNoiseLevels() const
  {
    return m_Kernel.GetNoise();
  }

  /** What lies together at the current position, within this distance, px. */
  PartialContourOverlap
  ComputeOverlap(double distance) const;

  /** Covariance of the optimizer's parameters at the current position, px^2: inverse of the information of residuals
   * and priors. Honest only with a noise model: without one positions and directions of all points are taken as
   * independent, with variance SmoothNoise^2 + WhiteNoise^2. Throws where the information is singular. */
  CovarianceType
  ComputeCovariance() const;

  void
  StartLevel(unsigned int level, unsigned int numberOfLevels, const ContourSimilarity & estimate) override;

  // LeastSquaresMetric
  SizeValueType
  GetNumberOfResiduals() const override;
  void
  GetResiduals(vnl_vector<double> & residuals, vnl_matrix<double> * jacobian) const override;

protected:
  PartialContourMetricv4() = default;
  ~PartialContourMetricv4() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;
  void
  InitializeContours(const ContourArrays & fixed, const ContourArrays & moving) override;
  MeasureType
  ComputeValue(const ContourSimilarity & similarity, ContourChamferKernel::GradientType * gradient) const override;
  MeasureType
  ComputeApproximateValue(const ContourSimilarity & similarity, SizeValueType numberOfPoints) const override;

  double
  ComputePenalty(double excess, double & slope) const override;

private:
  void
  CheckSettings() const;
  /** Whether the parameter is exactly at a bound and the residuals push it outwards. */
  bool
  IsHeldByBound(unsigned int               parameter,
                const vnl_vector<double> & residuals,
                const vnl_matrix<double> & jacobian) const;

  RobustKernelEnum     m_RobustKernel{ RobustKernelEnum::GemanMcClure };
  double               m_KernelWidth{ 5.0 };
  bool                 m_Annealing{ true };
  double               m_InitialKernelWidth{ 12.0 };
  double               m_FinalKernelWidth{ 5.0 };
  double               m_DirectionWeight{ 8.0 };
  double               m_DirectionSmoothing{ 5.0 };
  double               m_ReverseWeight{ 0.0 };
  double               m_TaperLength{ 6.0 };
  double               m_GapLength{ 8.0 };
  bool                 m_GateByTooth{ true };
  unsigned int         m_ToothRange{ 1 };
  bool                 m_CorrelatedNoise{ false };
  unsigned int         m_NumberOfCorrelatedLevels{ 2 };
  double               m_CorrelationLength{ 12.0 };
  double               m_SmoothNoise{ 1.3 };
  double               m_WhiteNoise{ 0.6 };
  bool                 m_EstimateNoise{ true };
  PartialContourPrior  m_Prior;
  PartialContourKernel m_Kernel;
};
} // namespace itk

#endif

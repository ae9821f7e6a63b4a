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
#ifndef itkPartialContourKernel_h
#define itkPartialContourKernel_h

#include "itkContourNoiseModel.h"
#include "itkOrientedContourIndex.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace itk
{
/** \class PartialContourPrior
 * \brief Gaussian priors on a similarity; a sigma of infinity leaves that part free.
 * \ingroup ContourMetric
 */
struct PartialContourPrior
{
  /** Logarithm of the scale: spacing times magnification. */
  double logScale{ 0.0 };
  double logScaleSigma{ std::numeric_limits<double>::infinity() };
  /** rad */
  double angle{ 0.0 };
  double angleSigma{ std::numeric_limits<double>::infinity() };
  /** Where the moving point `at` lands, px; sigma in each coordinate. */
  std::array<double, 2> at{ { 0.0, 0.0 } };
  std::array<double, 2> position{ { 0.0, 0.0 } };
  double                positionSigma{ std::numeric_limits<double>::infinity() };
};

/** \class PartialContourOverlap
 * \brief How much of two contours lies together under a similarity.
 * \ingroup ContourMetric
 */
struct PartialContourOverlap
{
  /** Share of the tracing, by weight, with the moving contour (not its end) within the distance. */
  double fixedShare{ 0.0 };
  /** Share of the moving contour, by length and weight, with the tracing (no end, no gap) within the distance. */
  double movingShare{ 0.0 };
  /** Root mean square and largest distance of the matched share of the tracing, px. */
  double rms{ 0.0 };
  double largest{ 0.0 };
};

/** \class PartialContourKernel
 * \brief Residuals between an open tracing and a moving contour that it covers in part, under a similarity.
 *
 * Every point of the tracing (fixed) counts: the distance D to the nearest place of the moving contour, in position and
 * line direction (OrientedContourIndex), through a robust kernel rho of settable width c:
 *
 *   value = (1 / sum w) [ sum w_i rho(D_i) + sum v_j g_j^2 rho(D_j) + sigma^2 sum ((x_k - m_k) / sigma_k)^2 ]     px^2
 *
 * The second sum is over the moving contour's points, v_j the reverse weight times the stretch of contour that the
 * point stands for over the tracing's spacing. It is censored: g_j is 0 where the nearest place of the tracing is an
 * end or a gap, and rises to 1 within the taper length of it, so that the value stays continuous. The third sum are the
 * priors, sigma^2 the tracing's noise (smooth^2 + white^2).
 *
 * With UpdateNoise() the first sum becomes generalised least squares, sigma^2 (V r)' K^-1 (V r), with
 * K = smooth^2 G + white^2 W^-1 (ContourNoiseModel; G along the tracing, its polylines strung together, with the normals
 * of the matched places; W the points' weights), V^2 the weights of the robust kernel at the similarity given (bifactor
 * weights: a gross error then counts little however well its neighbours are known), and the two levels estimated there
 * (REML) from the points within the kernel's width. V and K are then held until the next call, so that the value remains
 * a function of the similarity alone. r_i is the distance with a sign, by the tracing's normal; beyond an end of the
 * moving contour it is taken to the end's line. Directions steer matching and weights then, and are no residuals.
 *
 * The residuals are the rows whose squares sum up to the value; where the match is unique they are differentiable, and
 * their Jacobian is exact.
 *
 * Source of the bifactor weights: Yang, Song and Xu, Robust estimator for correlated observations based on bifactor
 * equivalent weights, J. Geodesy 2002.
 *
 * Evaluation changes nothing: any number of threads may evaluate at once. Free of ITK.
 *
 * \ingroup ContourMetric
 */
class ContourMetric_EXPORT PartialContourKernel
{
public:
  using RobustKernelEnum = ContourMetricEnums::RobustKernel;
  using GradientType = std::array<double, 4>;
  /** Every choice of the metric. */
  struct SettingsType
  {
    RobustKernelEnum robustKernel{ RobustKernelEnum::GemanMcClure };
    /** c, px */
    double width{ 3.0 };
    /** Pixels that a right angle between the directions counts. 0: position alone. */
    double directionWeight{ 0.0 };
    /** Directions are smoothed along the contours by a Gaussian of this sigma, px. */
    double directionSmoothing{ 5.0 };
    /** 0: the reverse direction is left out. */
    double reverseWeight{ 0.0 };
    double taperLength{ 6.0 };
    /** Ends of two polylines of the tracing closer than this, px, are no ends. */
    double gapLength{ 8.0 };
    /** Points that carry tooth codes are matched with the same tooth or one up to toothRange positions away. */
    bool               gateByTooth{ true };
    unsigned int       toothRange{ 1 };
    double             correlationLength{ 12.0 };
    bool               estimateNoise{ true };
    ContourNoiseLevels noise;
    /** Points of one strand that the correlated noise takes at most; more are thinned. */
    std::size_t         maximumNumberOfCorrelatedPoints{ 400 };
    PartialContourPrior prior;
  };

  /** Throws std::invalid_argument where a contour has no point of positive weight or a point is not finite. */
  void
  Initialize(const ContourArrays & fixed, const ContourArrays & moving, const SettingsType & settings);

  const SettingsType &
  GetSettings() const
  {
    return m_Settings;
  }

  /** Of the robust kernel. A noise model is held with the weights that it has. */
  void
  SetWidth(double width)
  {
    m_Settings.width = width;
  }

  /** Weights, noise levels and K at this similarity, for the value from now on; false where no point has any weight
   * left, and nothing is changed. */
  bool
  UpdateNoise(const ContourSimilarity & similarity);
  /** Back to independent points. */
  void
  ForgetNoise();
  bool
  HasCorrelatedNoise() const
  {
    return !m_Factors.empty();
  }
  /** Those in use: estimated by UpdateNoise(), else of the settings. */
  const ContourNoiseLevels &
  GetNoise() const
  {
    return m_Noise;
  }

  /** With a gradient, its derivatives by scale, angle, tx and ty. The scale must be positive, everything finite. */
  double
  Evaluate(const ContourSimilarity & similarity, GradientType * gradient = nullptr) const;

  /** The same from at most about this many points of each contour, evenly spaced; noise taken as independent. */
  double
  EvaluateApproximately(const ContourSimilarity & similarity, std::size_t numberOfPoints) const;

  /** Constant for given contours and settings. */
  std::size_t
  GetNumberOfResiduals() const;

  /** The residuals, and, where not null, their derivatives by scale, angle, tx, ty: four a residual. */
  void
  EvaluateResiduals(const ContourSimilarity & similarity, double * residuals, double * jacobian = nullptr) const;

  /** Sum of squares of the residuals over the negative log likelihood: value = 2 scale * -log L + const. */
  double
  GetValueOfUnitInformation() const
  {
    return this->GetVariance() / m_SumOfWeights;
  }

  PartialContourOverlap
  ComputeOverlap(const ContourSimilarity & similarity, double distance) const;

  /** D of every fixed point, and of every moving point that is not censored, in their order; NaN for the others. */
  std::vector<double>
  GetFixedDistances(const ContourSimilarity & similarity) const;
  std::vector<double>
  GetMovingDistances(const ContourSimilarity & similarity) const;

private:
  struct SampleType
  {
    std::uint32_t id;
    double        x;
    double        y;
    double        directionX;
    double        directionY;
    double        weight;
    /** Length of contour that it stands for. */
    double                             length;
    OrientedContourIndex::CodeMaskType allowed;
  };
  struct BlockType
  {
    /** Fixed samples, in order along the chain. */
    std::vector<std::size_t> samples;
    double                   weightOfEach{ 1.0 };
    std::vector<double>      normalX;
    std::vector<double>      normalY;
    std::vector<double>      arc;
    /** G of the last UpdateNoise(). */
    std::vector<double> correlation;
  };
  struct FactorType
  {
    /** Lower Cholesky factor of K, column by column. */
    std::vector<double> lower;
    /** Diagonal of V. */
    std::vector<double> roots;
  };
  struct MapType;
  struct RowType;

  static void
  MakeSamples(const ContourArrays &              contour,
              const std::vector<ContourStrand> & strands,
              const OrientedContourIndex &       index,
              const SettingsType &               settings,
              std::vector<SampleType> &          samples);
  void
  MakeBlocks(const ContourArrays & fixed, const std::vector<ContourStrand> & strands);
  void
  FindEnds(const ContourArrays & fixed, const std::vector<ContourStrand> & strands);
  bool
  ComputeForward(const MapType & map, const SampleType & sample, RowType & row) const;
  bool
  ComputeReverse(const MapType & map, const SampleType & sample, RowType & row) const;
  void
  ComputeSigned(const MapType & map, const SampleType & sample, double nx, double ny, double * r, double * jr) const;
  double
  GetVariance() const
  {
    return m_Noise.smooth * m_Noise.smooth + m_Noise.white * m_Noise.white;
  }
  void
  WriteRows(const RowType & row, double factor, double *& residuals, double *& jacobian) const;

  SettingsType            m_Settings;
  OrientedContourIndex    m_FixedIndex;
  OrientedContourIndex    m_MovingIndex;
  std::vector<SampleType> m_FixedSamples;
  std::vector<SampleType> m_MovingSamples;
  std::size_t             m_NumberOfFixedPoints{ 0 };
  std::size_t             m_NumberOfMovingPoints{ 0 };
  double                  m_SumOfWeights{ 1.0 };
  double                  m_FixedSpacing{ 0.0 };
  /** Of every moving target: normals at its start and end, not normalised, x y x y. */
  std::vector<std::array<double, 4>> m_EndNormals;
  /** Of every strand of the fixed contour: length, and whether its start and end are free. */
  struct ReachType
  {
    double length;
    bool   startIsFree;
    bool   endIsFree;
  };
  std::vector<ReachType>  m_Reach;
  std::vector<BlockType>  m_Blocks;
  std::vector<FactorType> m_Factors;
  ContourNoiseLevels      m_Noise;
};
} // namespace itk

#endif

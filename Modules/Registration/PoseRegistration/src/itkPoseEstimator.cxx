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
#include "itkPoseEstimator.h"

#include "itkPoseContourIndex.h"
#include "itkPoseNoiseModel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace itk
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double ScoreWidth = 4.0;
/** Error of the moving contour itself, px: half the sample spacing, facets, the cut at the midline. */
constexpr double ModelSigma = 0.15;

double
GemanMcClure(double d, double c)
{
  const double a = c * c / (c * c + d * d);
  return a * a;
}

/** What the kernel sees of a match: the residual along the normal and, past the end of the contour, the distance along
 * it. Continuous, as is FacingWeight(): a switch would let a step of a thousandth of a pixel change the criterion. */
double
MatchDistance(double normal, double tangential)
{
  return std::hypot(normal, std::max(0.0, std::abs(tangential) - 1.0));
}

/** 1 where contour and tracing face the same way, 0 where their normals differ by more than some 65 degrees. */
double
FacingWeight(double cosine)
{
  const double t = std::min(1.0, std::max(0.0, (cosine - 0.4) / 0.2));
  return t * t * (3.0 - 2.0 * t);
}

} // namespace

/** The normal equations at a linearisation. */
class PoseEstimator::Solver
{
public:
  Solver(const PoseEstimator & estimator, const std::array<double, 7> & sigmas, double correlationLength)
    : m_Estimator(estimator)
    , m_CorrelationLength(correlationLength)
  {
    for (unsigned int k = 0; k < 7; ++k)
    {
      if (sigmas[k] > 0.0)
      {
        m_Active.push_back(k);
      }
    }
    m_Sigmas = sigmas;
    this->SetPriors(PoseParameters{ {} }, false);
  }

  /** Precision of the priors at a pose. Roll and yaw have Student's t: tight for the many heads that stand straight,
   * with tails for the frame or head that does not; its quadratic majoriser at the pose (or, for a covariance, the one
   * with the distribution's variance). */
  void
  SetPriors(const PoseParameters & parameters, bool forCovariance)
  {
    const double freedom = m_Estimator.m_Options.rotationPriorFreedom;
    m_Precision.resize(m_Active.size());
    for (std::size_t a = 0; a < m_Active.size(); ++a)
    {
      const unsigned int k = m_Active[a];
      const double       s = m_Sigmas[k];
      m_Precision[a] = std::isinf(s) ? 0.0 : 1.0 / (s * s);
      if ((k == PoseRoll || k == PoseYaw) && freedom > 2.0)
      {
        const double x = parameters[k];
        m_Precision[a] = (forCovariance ? freedom - 2.0 : freedom + 1.0) / ((freedom - 2.0) * s * s + x * x);
      }
    }
  }

  /** From the prior's mean, which is zero. */
  Eigen::VectorXd
  Offset(const PoseParameters & parameters) const
  {
    Eigen::VectorXd offset(m_Active.size());
    for (std::size_t a = 0; a < m_Active.size(); ++a)
    {
      offset[a] = parameters[m_Active[a]];
    }
    return offset;
  }

  /** Weights by distance, correlation by normals. */
  void
  SetBlocks(const Linearization & lin, double width, bool robust)
  {
    m_Width = width;
    m_Robust = robust;
    m_Blocks.clear();
    std::size_t offset = 0;
    for (const PoseStrand & strand : m_Estimator.m_Strands)
    {
      const std::size_t n = strand.tracing.Size();
      PoseNoiseBlock    block;
      block.weight.resize(n);
      block.residual.resize(n);
      block.jacobian.resize(n, m_Active.size());
      for (std::size_t i = 0; i < n; ++i)
      {
        const std::size_t k = offset + i;
        block.weight[i] = this->KernelWeight(lin, k) * strand.tracing.weight[i];
        block.residual[i] = lin.residual[k];
        for (std::size_t a = 0; a < m_Active.size(); ++a)
        {
          block.jacobian(i, a) = lin.jacobian[7 * k + m_Active[a]];
        }
      }
      block.SetCorrelation(strand.tracing, &lin.nu[offset], &lin.nv[offset], m_CorrelationLength);
      m_Blocks.push_back(std::move(block));
      offset += n;
    }
  }

  double
  KernelWeight(const Linearization & lin, std::size_t k) const
  {
    return lin.facing[k] * (m_Robust ? GemanMcClure(lin.distance[k], m_Width) : 1.0);
  }

  void
  Factor(const PoseNoise & noise)
  {
    m_Information = m_Precision.asDiagonal();
    m_Gradient = Eigen::VectorXd::Zero(m_Active.size());
    for (const PoseNoiseBlock & block : m_Blocks)
    {
      const Eigen::LLT<Eigen::MatrixXd> factor(block.Covariance(noise));
      const Eigen::MatrixXd             j = factor.matrixL().solve(block.jacobian);
      const Eigen::VectorXd             r = factor.matrixL().solve(block.residual);
      m_Information.noalias() += j.transpose() * j;
      m_Gradient.noalias() += j.transpose() * r;
    }
  }

  /** What a step must lower: r' K^-1 r + priors + what the kernel charges for points that it lets go (the dual form of
   * Black and Rangarajan 1996), with weights at that pose. With weights held fixed, one point that jumps to another
   * part of the outline would forbid every step. Correlation as in SetBlocks(). */
  double
  Objective(const Linearization & lin, const PoseParameters & parameters, const PoseNoise & noise) const
  {
    const Eigen::VectorXd offset = this->Offset(parameters);
    double                value = offset.dot(m_Precision.cwiseProduct(offset));
    const double          charge = m_Width * m_Width / (noise.white * noise.white);
    std::size_t           begin = 0;
    for (std::size_t s = 0; s < m_Blocks.size(); ++s)
    {
      const Eigen::Index                      n = m_Blocks[s].weight.size();
      const Eigen::Map<const Eigen::VectorXd> r(&lin.residual[begin], n);
      Eigen::MatrixXd                         k = (noise.smooth * noise.smooth) * m_Blocks[s].correlation;
      for (Eigen::Index i = 0; i < n; ++i)
      {
        const double given = m_Estimator.m_Strands[s].tracing.weight[i];
        const double w = this->KernelWeight(lin, begin + i);
        k(i, i) += noise.white * noise.white / std::max(given * w, 1e-6);
        value += m_Robust ? charge * given * (std::sqrt(w) - 1.0) * (std::sqrt(w) - 1.0) : 0.0;
      }
      const Eigen::LLT<Eigen::MatrixXd> factor(k);
      value += factor.matrixL().solve(r).squaredNorm();
      begin += n;
    }
    return value;
  }

  PoseParameters
  Step(const PoseParameters & parameters, double damping) const
  {
    Eigen::MatrixXd information = m_Information;
    information.diagonal() += damping * m_Information.diagonal();
    // Not singular, where nothing at all is observed.
    information.diagonal().array() += 1e-9;
    const Eigen::VectorXd gradient = m_Gradient + m_Precision.cwiseProduct(this->Offset(parameters));
    const Eigen::VectorXd step = -information.ldlt().solve(gradient);
    // A common factor, so that the direction stays.
    static const double limits[7] = { 0.1, 0.07, 0.07, 6.0, 6.0, 6.0, 0.03 };
    double              factor = 1.0;
    for (std::size_t a = 0; a < m_Active.size(); ++a)
    {
      factor = std::min(factor, limits[m_Active[a]] / std::max(std::abs(step[a]), 1e-300));
    }
    PoseParameters moved = parameters;
    for (std::size_t a = 0; a < m_Active.size(); ++a)
    {
      moved[m_Active[a]] += factor * step[a];
    }
    return moved;
  }

  const PoseEstimator &       m_Estimator;
  double                      m_CorrelationLength;
  std::vector<unsigned int>   m_Active;
  std::array<double, 7>       m_Sigmas;
  Eigen::VectorXd             m_Precision;
  std::vector<PoseNoiseBlock> m_Blocks;
  double                      m_Width{ 0.0 };
  bool                        m_Robust{ true };
  Eigen::MatrixXd             m_Information;
  Eigen::VectorXd             m_Gradient;
};

PoseEstimator::PoseEstimator(const PoseGeometry &          geometry,
                             const PoseRegistrationOptions & options,
                             std::vector<PoseStrand>       strands)
  : m_Geometry(geometry)
  , m_Options(options)
  , m_Strands(std::move(strands))
{
  for (const PoseStrand & strand : m_Strands)
  {
    m_Count += strand.tracing.Size();
  }
}

std::array<double, 7>
PoseEstimator::GetPriorSigmas(bool similarityOnly) const
{
  std::array<double, 7> sigmas{
    { Infinity, m_Options.rollSigma, m_Options.yawSigma, Infinity, m_Options.tySigma, Infinity, m_Options.kappaSigma }
  };
  if (!m_Geometry.pixelSpacingKnown)
  {
    sigmas[PoseKappa] = m_Options.kappaSigmaWithoutSpacing;
  }
  if (similarityOnly || !m_Options.useFullPose || m_Options.tracedSide == PoseTracedSideEnum::Mean)
  {
    sigmas[PoseRoll] = sigmas[PoseYaw] = sigmas[PoseTy] = 0.0;
  }
  if (m_Options.fixScale)
  {
    sigmas[PoseKappa] = 0.0;
  }
  if (m_Options.fixRotation)
  {
    sigmas[PosePitch] = sigmas[PoseRoll] = sigmas[PoseYaw] = 0.0;
  }
  if (m_Options.fixTranslation)
  {
    sigmas[PoseTx] = sigmas[PoseTy] = sigmas[PoseTz] = 0.0;
  }
  return sigmas;
}

std::array<double, 7>
PoseEstimator::GetHeldSigmas() const
{
  std::array<double, 7> sigmas{};
  if (m_Options.fixRotation)
  {
    sigmas[PosePitch] = m_Options.heldPitchSigma;
    sigmas[PoseRoll] = sigmas[PoseYaw] = m_Options.unobservedRotationSigma;
  }
  if (m_Options.fixTranslation)
  {
    sigmas[PoseTx] = sigmas[PoseTy] = sigmas[PoseTz] = m_Options.heldTranslationSigma;
  }
  if (m_Options.fixScale)
  {
    sigmas[PoseKappa] = m_Geometry.pixelSpacingKnown ? m_Options.kappaSigma : m_Options.kappaSigmaWithoutSpacing;
  }
  return sigmas;
}

std::array<double, 7>
PoseEstimator::GetCovarianceSigmas() const
{
  std::array<double, 7> sigmas = this->GetPriorSigmas(false);
  if (!m_Options.fixRotation)
  {
    for (unsigned int k : { PoseRoll, PoseYaw })
    {
      sigmas[k] = sigmas[k] > 0.0 ? sigmas[k] : m_Options.unobservedRotationSigma;
    }
  }
  if (!m_Options.fixTranslation)
  {
    sigmas[PoseTy] = sigmas[PoseTy] > 0.0 ? sigmas[PoseTy] : m_Options.tySigma;
  }
  return sigmas;
}

std::vector<PoseContour>
PoseEstimator::ComputeContours(const PoseParameters & parameters) const
{
  const PoseModel          model(m_Geometry, parameters);
  std::vector<PoseContour> contours(m_Strands.size());
  for (std::size_t s = 0; s < m_Strands.size(); ++s)
  {
    for (const PoseContourModel * contourModel : m_Strands[s].models)
    {
      PoseContour   more = contourModel->Compute(model);
      PoseContour & all = contours[s];
      if (all.Size() == 0)
      {
        all = std::move(more);
        continue;
      }
      for (std::size_t run : more.runs)
      {
        all.runs.push_back(run + all.u.size());
      }
      all.u.insert(all.u.end(), more.u.begin(), more.u.end());
      all.v.insert(all.v.end(), more.v.begin(), more.v.end());
      all.nu.insert(all.nu.end(), more.nu.begin(), more.nu.end());
      all.nv.insert(all.nv.end(), more.nv.begin(), more.nv.end());
      all.rim.insert(all.rim.end(), more.rim.begin(), more.rim.end());
      all.rimOther.insert(all.rimOther.end(), more.rimOther.begin(), more.rimOther.end());
    }
  }
  return contours;
}

PoseEstimator::Linearization
PoseEstimator::Linearize(const PoseParameters &           parameters,
                         const std::vector<PoseContour> & contours,
                         bool                             withJacobian) const
{
  const PoseModel model(m_Geometry, parameters);
  Linearization   lin;
  lin.residual.resize(m_Count);
  lin.distance.resize(m_Count);
  lin.nu.resize(m_Count);
  lin.nv.resize(m_Count);
  lin.facing.resize(m_Count);
  lin.match.resize(m_Count);
  lin.jacobian.assign(withJacobian ? 7 * m_Count : 0, 0.0);
  const double normalWeight2 =
    m_Options.useOrientation ? m_Options.orientationWeight * m_Options.orientationWeight : 0.0;
  std::size_t k = 0;
  for (std::size_t s = 0; s < m_Strands.size(); ++s)
  {
    const PoseTracing &    tracing = m_Strands[s].tracing;
    const PoseContour &    contour = contours[s];
    const PoseContourIndex index(contour);
    for (std::size_t i = 0; i < tracing.Size(); ++i, ++k)
    {
      if (index.Empty())
      {
        // Nothing to match: a residual that no pose can change, without weight.
        lin.residual[k] = lin.distance[k] = 1e3;
        lin.nv[k] = 1.0;
        lin.facing[k] = 0.0;
        continue;
      }
      const std::size_t j = index.Nearest(tracing.u[i], tracing.v[i], tracing.nu[i], tracing.nv[i], normalWeight2);
      const double      nu = contour.nu[j];
      const double      nv = contour.nv[j];
      const double      du = tracing.u[i] - contour.u[j];
      const double      dv = tracing.v[i] - contour.v[j];
      const double      r = nu * du + nv * dv;
      const double      tangential = std::abs(nu * dv - nv * du);
      lin.residual[k] = r;
      lin.distance[k] = MatchDistance(r, tangential);
      lin.nu[k] = nu;
      lin.nv[k] = nv;
      const auto & direction = index.GetDirection(j);
      lin.facing[k] =
        m_Options.useOrientation ? FacingWeight(direction[0] * tracing.nu[i] + direction[1] * tracing.nv[i]) : 1.0;
      lin.match[k] = j;
      if (withJacobian)
      {
        double w[2], jacobian[14];
        model.ProjectWithJacobian(contour.rim[j].data(), w, jacobian);
        if (!contour.rimOther.empty())
        {
          double other[14];
          model.ProjectWithJacobian(contour.rimOther[j].data(), w, other);
          for (int a = 0; a < 14; ++a)
          {
            jacobian[a] = 0.5 * (jacobian[a] + other[a]);
          }
        }
        for (int a = 0; a < 7; ++a)
        {
          lin.jacobian[7 * k + a] = -(nu * jacobian[a] + nv * jacobian[7 + a]);
        }
      }
    }
  }
  return lin;
}

PoseState
PoseEstimator::Refine(const PoseState & start, const PoseSchedule & schedule) const
{
  return this->Run(start, schedule, nullptr, start.parameters);
}

PoseState
PoseEstimator::RefineFrozen(const PoseState &                start,
                            const PoseSchedule &             schedule,
                            const std::vector<PoseContour> & contours,
                            const PoseParameters &           contourPose) const
{
  return this->Run(start, schedule, &contours, contourPose);
}

PoseState
PoseEstimator::Run(const PoseState &                start,
                   const PoseSchedule &             schedule,
                   const std::vector<PoseContour> * frozen,
                   const PoseParameters &           frozenPose) const
{
  std::vector<PoseContour> own;
  if (frozen == nullptr && !m_Options.regenerateOutline)
  {
    own = this->ComputeContours(start.parameters);
    frozen = &own;
  }
  const PoseModel frozenModel(m_Geometry, frozenPose);
  const auto      contoursAt = [&](const PoseParameters & parameters) {
    if (frozen == nullptr)
    {
      return this->ComputeContours(parameters);
    }
    std::vector<PoseContour> contours = *frozen;
    const PoseModel          model(m_Geometry, parameters);
    for (PoseContour & contour : contours)
    {
      PoseContourModel::Reproject(contour, frozenModel, model);
    }
    return contours;
  };
  const bool correlated = schedule.correlated && m_Options.useCorrelatedNoise;
  Solver solver(*this, this->GetPriorSigmas(schedule.similarityOnly), correlated ? m_Options.correlationLength : 0.0);
  PoseState state = start;
  state.evaluations = 0;
  state.converged = false;
  std::vector<PoseContour> contours = contoursAt(state.parameters);
  Linearization            lin = this->Linearize(state.parameters, contours, true);
  state.evaluations = 1;
  double       damping = 0.0;
  unsigned int accepted = 0;
  const bool   estimate = schedule.estimateNoise && m_Options.estimateNoise;
  while (!solver.m_Active.empty())
  {
    const bool annealed = accepted >= schedule.widths.size();
    double     width = annealed ? schedule.widths.back() : schedule.widths[accepted];
    if (annealed && estimate)
    {
      width = 2.5 * std::hypot(state.noise.smooth, state.noise.white);
    }
    solver.SetPriors(state.parameters, false);
    solver.SetBlocks(lin, width, m_Options.useRobustKernel);
    // Every second step once the kernel is narrow: the levels settle much faster than the pose.
    if (estimate && annealed && (accepted - schedule.widths.size()) % 2 == 0)
    {
      state.noise =
        EstimatePoseNoise(solver.m_Blocks, solver.m_Precision, solver.Offset(state.parameters), state.noise);
    }
    solver.Factor(state.noise);
    const double before = solver.Objective(lin, state.parameters, state.noise);
    bool         moved = false;
    while (state.evaluations < schedule.maximumEvaluations)
    {
      const PoseParameters     next = solver.Step(state.parameters, damping);
      std::vector<PoseContour> nextContours = contoursAt(next);
      Linearization            nextLin = this->Linearize(next, nextContours, true);
      ++state.evaluations;
      const double distance = this->ContourDistance(contours, state.parameters, next);
      if (solver.Objective(nextLin, next, state.noise) < before)
      {
        state.parameters = next;
        contours = std::move(nextContours);
        lin = std::move(nextLin);
        damping = damping > 1e-4 ? 0.1 * damping : 0.0;
        moved = true;
        ++accepted;
        state.converged = distance < schedule.tolerance;
        break;
      }
      if (distance < schedule.tolerance)
      {
        state.converged = true;
        break;
      }
      damping = std::max(10.0 * damping, 1e-2);
    }
    if (!moved && !(state.converged && !annealed))
    {
      break;
    }
    if (!moved)
    {
      // Nothing to gain at this width: go on to the narrower one.
      ++accepted;
      state.converged = false;
    }
    if (state.converged && accepted > schedule.widths.size())
    {
      break;
    }
    if (state.evaluations >= schedule.maximumEvaluations)
    {
      break;
    }
  }
  this->Score(state, contours);
  return state;
}

void
PoseEstimator::Score(PoseState & state, const std::vector<PoseContour> & contours) const
{
  state.cost = 0.0;
  state.codeTerm = 0.0;
  double      total = 0.0;
  std::size_t coded = 0;
  for (std::size_t s = 0; s < m_Strands.size(); ++s)
  {
    const PoseFitStatistics fit = this->ComputeStatistics(s, contours[s]);
    state.cost += fit.cost * static_cast<double>(fit.numberOfPoints);
    total += static_cast<double>(fit.numberOfPoints);
    if (fit.hasCodes)
    {
      state.codeTerm += std::abs(fit.codeOffset);
      ++coded;
    }
  }
  state.cost = total > 0.0 ? state.cost / total : 1.0;
  state.codeTerm = coded > 0 ? state.codeTerm / static_cast<double>(coded) : 0.0;
  state.score = state.cost + m_Options.codeWeight * state.codeTerm;
}

PoseFitStatistics
PoseEstimator::ComputeStatistics(std::size_t s, const PoseContour & contour) const
{
  const PoseStrand &  strand = m_Strands[s];
  const PoseTracing & tracing = strand.tracing;
  PoseFitStatistics   fit;
  fit.numberOfPoints = tracing.Size();
  fit.tracingLength = tracing.length;
  fit.contourLength = PoseContourModel::Spacing * static_cast<double>(contour.Size());
  if (contour.Size() == 0 || tracing.Size() == 0)
  {
    fit.inlierShare = 0.0;
    return fit;
  }
  const PoseContourIndex index(contour);
  const double           normalWeight2 =
    m_Options.useOrientation ? m_Options.orientationWeight * m_Options.orientationWeight : 0.0;
  std::vector<double>   distances;
  double                weights = 0.0, cost = 0.0, squares = 0.0, inliers = 0.0;
  std::array<double, 9> arcSum{}, arcCount{}, arcExpected{};
  for (std::size_t i = 0; i < tracing.Size(); ++i)
  {
    const std::size_t j = index.Nearest(tracing.u[i], tracing.v[i], tracing.nu[i], tracing.nv[i], normalWeight2);
    const double      du = tracing.u[i] - contour.u[j];
    const double      dv = tracing.v[i] - contour.v[j];
    const double      nu = contour.nu[j];
    const double      nv = contour.nv[j];
    const double      r = std::abs(nu * du + nv * dv);
    const double      d = MatchDistance(r, nu * dv - nv * du);
    const auto &      direction = index.GetDirection(j);
    const double      facing =
      m_Options.useOrientation ? FacingWeight(direction[0] * tracing.nu[i] + direction[1] * tracing.nv[i]) : 1.0;
    const double w = facing * GemanMcClure(d, ScoreWidth);
    weights += tracing.weight[i];
    cost += tracing.weight[i] * (1.0 - std::sqrt(w));
    inliers += facing > 0.5 && d < ScoreWidth ? tracing.weight[i] : 0.0;
    squares += d * d;
    distances.push_back(d);
    const double expected = PoseArch::ExpectedArc(tracing.tooth[i]);
    if (expected > 0.0 && strand.arch != nullptr && strand.arch->IsValid())
    {
      const int position = tracing.tooth[i] % 10;
      arcSum[position] += std::abs(strand.arch->Arc(contour.rim[j][0], contour.rim[j][1]));
      arcCount[position] += 1.0;
      arcExpected[position] = expected;
    }
  }
  double teeth = 0.0;
  for (int k = 1; k < 9; ++k)
  {
    if (arcCount[k] > 0.0)
    {
      fit.codeOffset += arcSum[k] / arcCount[k] - arcExpected[k];
      teeth += 1.0;
    }
  }
  if (teeth > 0.0)
  {
    fit.codeOffset /= teeth;
    fit.hasCodes = true;
  }
  fit.cost = weights > 0.0 ? cost / weights : 1.0;
  fit.inlierShare = weights > 0.0 ? inliers / weights : 0.0;
  fit.rmsResidual = std::sqrt(squares / static_cast<double>(distances.size()));
  std::sort(distances.begin(), distances.end());
  const auto quantile = [&](double q) {
    const double      x = q * static_cast<double>(distances.size() - 1);
    const std::size_t k = static_cast<std::size_t>(x);
    const std::size_t l = std::min(k + 1, distances.size() - 1);
    return distances[k] + (x - static_cast<double>(k)) * (distances[l] - distances[k]);
  };
  fit.medianResidual = quantile(0.5);
  fit.p90Residual = quantile(0.9);
  return fit;
}

double
PoseEstimator::ComputeOverlap(std::size_t strand, const PoseContour & contour) const
{
  const PoseTracing & tracing = m_Strands[strand].tracing;
  std::size_t         near = 0;
  for (std::size_t j = 0; j < contour.Size(); ++j)
  {
    bool found = false;
    for (std::size_t i = 0; i < tracing.Size() && !found; ++i)
    {
      const double du = tracing.u[i] - contour.u[j];
      const double dv = tracing.v[i] - contour.v[j];
      found = du * du + dv * dv < ScoreWidth * ScoreWidth;
    }
    near += found ? 1 : 0;
  }
  return contour.Size() > 0 ? static_cast<double>(near) / static_cast<double>(contour.Size()) : 0.0;
}

std::array<double, 49>
PoseEstimator::ComputeCovariance(const PoseState & state, PoseNoise & noise) const
{
  // What a user holds was not estimated: its own uncertainty comes on top instead of being narrowed by the data.
  std::array<double, 7>       sigmas = this->GetCovarianceSigmas();
  const std::array<double, 7> heldSigmas = this->GetHeldSigmas();
  for (unsigned int k = 0; k < 7; ++k)
  {
    sigmas[k] = heldSigmas[k] > 0.0 ? Infinity : sigmas[k];
  }
  Solver solver(*this, sigmas, m_Options.useCorrelatedNoise ? m_Options.covarianceCorrelationLength : 0.0);
  noise = state.noise;
  std::array<double, 49> covariance{};
  if (solver.m_Active.empty())
  {
    return covariance;
  }
  const Linearization lin = this->Linearize(state.parameters, this->ComputeContours(state.parameters), true);
  solver.SetPriors(state.parameters, true);
  solver.SetBlocks(
    lin, std::max(3.0, 2.5 * std::hypot(state.noise.smooth, state.noise.white)), m_Options.useRobustKernel);
  if (m_Options.estimateNoise)
  {
    noise = EstimatePoseNoise(solver.m_Blocks, solver.m_Precision, solver.Offset(state.parameters), state.noise);
  }
  const double absorbed = std::min(1.6, 1.0 + m_Options.absorbedNoise * noise.smooth * noise.smooth);
  noise.smooth *= absorbed;
  noise.white *= absorbed;
  // What outline and frame get wrong stays where the tracing is perfect.
  noise.smooth = std::hypot(noise.smooth, ModelSigma);
  solver.Factor(noise);
  std::vector<Eigen::Index> estimated, held;
  for (std::size_t a = 0; a < solver.m_Active.size(); ++a)
  {
    (heldSigmas[solver.m_Active[a]] > 0.0 ? held : estimated).push_back(static_cast<Eigen::Index>(a));
  }
  Eigen::MatrixXd information = solver.m_Information(estimated, estimated);
  information.diagonal().array() += 1e-9;
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(solver.m_Information.rows(), solver.m_Information.cols());
  Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(full.rows(), static_cast<Eigen::Index>(held.size()));
  if (!estimated.empty())
  {
    const Eigen::MatrixXd inverse =
      information.ldlt().solve(Eigen::MatrixXd::Identity(information.rows(), information.cols()));
    full(estimated, estimated) = inverse;
    if (!held.empty())
    {
      const Eigen::MatrixXd coupling = solver.m_Information(estimated, held);
      const Eigen::MatrixXd follows = -inverse * coupling;
      spread(estimated, Eigen::all) = follows;
    }
  }
  full *= m_Options.covarianceInflation * m_Options.covarianceInflation;
  for (std::size_t h = 0; h < held.size(); ++h)
  {
    const double sigma = heldSigmas[solver.m_Active[held[h]]];
    spread(held[h], h) = 1.0;
    full += sigma * sigma * spread.col(h) * spread.col(h).transpose();
  }
  for (std::size_t a = 0; a < solver.m_Active.size(); ++a)
  {
    for (std::size_t b = 0; b < solver.m_Active.size(); ++b)
    {
      covariance[7 * solver.m_Active[a] + solver.m_Active[b]] = 0.5 * (full(a, b) + full(b, a));
    }
  }
  return covariance;
}

std::array<double, 2>
PoseEstimator::PredictedSigma(std::size_t                      strand,
                              const PoseParameters &           parameters,
                              const std::vector<PoseContour> & contours,
                              const std::array<double, 49> &   covariance) const
{
  const PoseModel     model(m_Geometry, parameters);
  const Linearization lin = this->Linearize(parameters, contours, false);
  std::size_t         begin = 0;
  for (std::size_t s = 0; s < strand; ++s)
  {
    begin += m_Strands[s].tracing.Size();
  }
  const std::size_t n = m_Strands[strand].tracing.Size();
  if (n == 0 || contours[strand].Size() == 0)
  {
    return { { 0.0, 0.0 } };
  }
  const auto variance = [&](std::size_t sample) {
    double w[2], jacobian[14];
    double sum = 0.0;
    model.ProjectWithJacobian(contours[strand].rim[sample].data(), w, jacobian);
    for (int axis = 0; axis < 2; ++axis)
    {
      for (int a = 0; a < 7; ++a)
      {
        for (int b = 0; b < 7; ++b)
        {
          sum += 0.5 * jacobian[7 * axis + a] * covariance[7 * a + b] * jacobian[7 * axis + b];
        }
      }
    }
    return sum;
  };
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    sum += variance(lin.match[begin + i]);
  }
  double largest = 0.0;
  for (std::size_t j = 0; j < contours[strand].Size(); j += 10)
  {
    largest = std::max(largest, variance(j));
  }
  return { { std::sqrt(sum / static_cast<double>(n)), std::sqrt(largest) } };
}

double
PoseEstimator::ComputeDeviance(const PoseState & state) const
{
  Solver solver(*this, this->GetPriorSigmas(false), m_Options.useCorrelatedNoise ? m_Options.correlationLength : 0.0);
  const Linearization lin = this->Linearize(state.parameters, this->ComputeContours(state.parameters), true);
  solver.SetPriors(state.parameters, false);
  solver.SetBlocks(lin, ScoreWidth, m_Options.useRobustKernel);
  for (PoseNoiseBlock & block : solver.m_Blocks)
  {
    // A point that fits nowhere counts against a model, it does not drop out.
    block.weight = block.weight.cwiseMax(1e-3);
  }
  double deviance = 0.0;
  EstimatePoseNoise(solver.m_Blocks, solver.m_Precision, solver.Offset(state.parameters), state.noise, &deviance);
  return deviance;
}

double
PoseEstimator::ContourDistance(const std::vector<PoseContour> & contours,
                               const PoseParameters &           contourPose,
                               const PoseParameters &           other) const
{
  const PoseModel from(m_Geometry, contourPose);
  const PoseModel to(m_Geometry, other);
  double          sum = 0.0;
  double          count = 0.0;
  for (const PoseContour & contour : contours)
  {
    // Every fifth sample: 2.5 px apart.
    for (std::size_t i = 0; i < contour.Size(); i += 5)
    {
      double a[2], b[2];
      from.Project(contour.rim[i].data(), a);
      to.Project(contour.rim[i].data(), b);
      sum += (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
      count += 1.0;
    }
  }
  return count > 0.0 ? std::sqrt(sum / count) : 0.0;
}
} // namespace itk

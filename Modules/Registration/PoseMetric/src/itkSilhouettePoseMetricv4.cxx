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
#include "itkSilhouettePoseMetricv4.h"

#include "itkCorrelatedNoiseModel.h"
#include "itkGemanMcClureKernel.h"
#include "itkPoseMatching.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace itk
{
namespace
{
/** As ContourNoiseModel::ComputeCovariance() has it: no weight is quite 0. */
constexpr double SmallestWeight = 1e-6;
} // namespace

SilhouettePoseMetricv4::SilhouettePoseMetricv4()
  : m_RobustKernel(GemanMcClureKernel::New().GetPointer())
  , m_NoiseModel(CorrelatedNoiseModel::New().GetPointer())
{
  m_SettingsTime.Modified();
}

void
SilhouettePoseMetricv4::SetMovingSurface(SurfacePointer surface)
{
  if (m_Surface != surface)
  {
    m_Surface = std::move(surface);
    this->Modified();
  }
}

void
SilhouettePoseMetricv4::SetExcludedTeeth(const std::vector<std::uint8_t> & teeth)
{
  if (m_ExcludedTeeth != teeth)
  {
    m_ExcludedTeeth = teeth;
    this->Modified();
  }
}

void
SilhouettePoseMetricv4::SetReverseWeight(double weight)
{
  if (!(weight >= 0.0) || !std::isfinite(weight))
  {
    itkExceptionMacro("The reverse weight " << weight << " must be 0 or more: see SetReverseWeight().");
  }
  if (m_ReverseWeight != weight)
  {
    m_ReverseWeight = weight;
    this->Modified();
  }
}

ModifiedTimeType
SilhouettePoseMetricv4::GetMTime() const
{
  return std::max({ Superclass::GetMTime(), m_RobustKernel->GetMTime(), m_NoiseModel->GetMTime() });
}

void
SilhouettePoseMetricv4::SetRobustKernel(const RobustKernel * kernel)
{
  if (kernel == nullptr)
  {
    itkExceptionMacro("No robust kernel: give SetRobustKernel() one; SquaresKernel is least squares.");
  }
  if (m_RobustKernel != kernel)
  {
    m_RobustKernel = kernel;
    m_SettingsTime.Modified();
    this->SettingsChanged();
  }
}

void
SilhouettePoseMetricv4::SetKernelWidth(double width)
{
  if (!(width > 0.0))
  {
    itkExceptionMacro("The kernel width " << width << " px must be positive: see SetKernelWidth().");
  }
  if (m_KernelWidth != width)
  {
    m_KernelWidth = width;
    this->SettingsChanged();
  }
}

void
SilhouettePoseMetricv4::SetNoiseModel(const ResidualNoiseModel * model)
{
  if (model == nullptr)
  {
    itkExceptionMacro(
      "No noise model: give SetNoiseModel() one; a CorrelatedNoiseModel of length 0 is independent noise.");
  }
  if (m_NoiseModel != model)
  {
    m_NoiseModel = model;
    m_Correlations.reset();
    m_SettingsTime.Modified();
    this->SettingsChanged();
  }
}

void
SilhouettePoseMetricv4::SetNoiseLevels(const ContourNoiseLevels & levels, const ResidualNoiseModel * model)
{
  const bool isMeant = model == nullptr || model == m_NoiseModel.GetPointer();
  if (isMeant && (m_NoiseLevels.smooth != levels.smooth || m_NoiseLevels.white != levels.white))
  {
    m_NoiseLevels = levels;
    this->SettingsChanged();
  }
}

bool
SilhouettePoseMetricv4::GetNoiseLevels(ContourNoiseLevels & levels, const ResidualNoiseModel * model) const
{
  if (model != nullptr && model != m_NoiseModel.GetPointer())
  {
    return false;
  }
  levels = m_NoiseLevels;
  return true;
}

void
SilhouettePoseMetricv4::Prepare()
{
  Superclass::InitializeTerm();
  const ContourType * const outline = this->GetMovingContour();
  if (!m_Surface && outline == nullptr)
  {
    itkExceptionMacro("No scan: call SetMovingMesh() or SetMovingSurface() with the jaw in its dental frame, or "
                      "SetMovingContour() with an outline of it.");
  }
  if (m_Surface && outline != nullptr)
  {
    itkExceptionMacro("A scan and an outline: take one back, with SetMovingSurface(nullptr) or "
                      "SetMovingContour(nullptr).");
  }
  if (this->GetFixedContour() == nullptr)
  {
    itkExceptionMacro("No tracing: call SetFixedContour() with this jaw's tracing (a DentalContour).");
  }
  // Not the state's time: what is free and where it stands changes nothing here.
  const ModifiedTimeType time = std::max({ this->Object::GetMTime(),
                                           this->GetTransform()->GetMTime(),
                                           this->GetFixedContour()->GetMTime(),
                                           outline == nullptr ? ModifiedTimeType(0) : outline->GetMTime() });
  if (m_Kernel && m_KernelTime >= time)
  {
    return;
  }
  PoseSilhouetteSettings settings;
  settings.geometry = this->GetTransform()->GetPoseGeometry();
  settings.jaw = m_Jaw;
  settings.tracedSide = m_TracedSide;
  settings.useSideSelection = m_UseSideSelection;
  settings.midlineMargin = m_MidlineMargin;
  settings.useFacingFilter = m_UseFacingFilter;
  settings.useOrientation = m_UseOrientation;
  settings.orientationWeight = m_OrientationWeight;
  settings.excludedTeeth = m_ExcludedTeeth;
  settings.maximumTracingPoints = m_MaximumTracingPoints;
  settings.gateByTooth = m_GateByTooth;
  settings.toothRange = m_ToothRange;
  settings.reverseWeight = m_ReverseWeight;
  settings.taperLength = m_TaperLength;
  settings.gapLength = m_GapLength;
  const DentalContour::PolylinesType tracing = this->GetFixedContour()->GetPolylines();
  if (m_Surface)
  {
    try
    {
      m_Kernel = std::make_shared<const PoseSilhouetteKernel>(*m_Surface, tracing, settings);
    }
    catch (const std::invalid_argument & error)
    {
      itkExceptionMacro("The scan of the " << ToString(m_Jaw) << " jaw cannot be used: " << error.what()
                                           << " Read or build its mesh again.");
    }
  }
  else
  {
    m_Kernel = std::make_shared<const PoseSilhouetteKernel>(
      outline->GetPolylines(), this->GetTransform()->GetPoseParameters(), tracing, settings);
  }
  m_KernelTime = time;
  m_Correlations.reset();
  m_Held.reset();
  m_Hold = HoldEnum::Nothing;
  m_Normals.clear();
  m_Linearized = EvaluationType();
  m_Last = EvaluationType();
}

const std::string &
SilhouettePoseMetricv4::GetFailure() const
{
  return this->GetKernel().GetFailure();
}

const PoseSilhouetteKernel &
SilhouettePoseMetricv4::GetKernel() const
{
  if (!m_Kernel)
  {
    itkExceptionMacro("The metric is not prepared: call Initialize() or Prepare().");
  }
  return *m_Kernel;
}

void
SilhouettePoseMetricv4::InitializeTerm()
{
  this->Prepare();
  if (!m_Kernel->GetFailure().empty())
  {
    itkExceptionMacro("The tracing of the " << ToString(m_Jaw) << " jaw cannot be matched: " << m_Kernel->GetFailure()
                                            << '.');
  }
  this->UpdateCorrelations();
}

void
SilhouettePoseMetricv4::UpdateCorrelations() const
{
  const ModifiedTimeType time = m_NoiseModel->GetMTime();
  if (m_Correlations && m_CorrelationsTime == time)
  {
    return;
  }
  m_CorrelationsTime = time;
  m_SettingsTime.Modified();
  auto correlations = std::make_shared<CorrelationsType>();
  for (const auto & strand : this->GetKernel().GetStrands())
  {
    const std::size_t   n = strand.tracing.Size();
    std::vector<double> rho(n * n);
    for (std::size_t i = 0; i < n; ++i)
    {
      rho[i * n + i] = 1.0;
      for (std::size_t j = 0; j < i; ++j)
      {
        rho[i * n + j] = rho[j * n + i] = m_NoiseModel->GetCorrelation(strand.tracing.arc[i] - strand.tracing.arc[j]);
      }
    }
    correlations->push_back(std::move(rho));
  }
  m_Correlations = correlations;
}

SizeValueType
SilhouettePoseMetricv4::GetNumberOfResiduals() const
{
  SizeValueType count = 0;
  for (const auto & strand : this->GetKernel().GetStrands())
  {
    count += strand.tracing.Size();
  }
  return m_Kernel->GetSettings().reverseWeight > 0.0 ? 2 * count : count;
}

SilhouettePoseMetricv4::EvaluationType &
SilhouettePoseMetricv4::Evaluate(const PositionType & x) const
{
  if (m_Linearized.x == x)
  {
    return m_Linearized;
  }
  if (m_Last.x == x)
  {
    return m_Last;
  }
  const PoseParameters         pose = ToPoseParameters(x);
  const PoseSilhouetteKernel & kernel = this->GetKernel();
  EvaluationType               evaluation;
  evaluation.x = x;
  const std::size_t count = kernel.GetStrands().size();
  if (m_Held)
  {
    evaluation.contours = kernel.MoveContours(m_Held->contours, ToPoseParameters(m_Held->x), pose);
  }
  else
  {
    evaluation.contours = kernel.ComputeContours(pose);
  }
  for (std::size_t s = 0; s < count; ++s)
  {
    evaluation.strands.push_back(m_Hold == HoldEnum::Matches
                                   ? kernel.LinearizeHeld(s, pose, evaluation.contours[s], m_Held->strands[s], true)
                                   : kernel.Linearize(s, pose, evaluation.contours[s], true));
    if (kernel.GetSettings().reverseWeight > 0.0)
    {
      evaluation.reverse.push_back(kernel.LinearizeReverse(
        s, pose, evaluation.contours[s], m_Hold == HoldEnum::Matches ? &m_Held->reverse[s] : nullptr));
    }
  }
  m_Last = std::move(evaluation);
  return m_Last;
}

double
SilhouettePoseMetricv4::GetRobustWeight(double squaredDistance, double facing) const
{
  return facing * m_RobustKernel->GetWeight(squaredDistance, m_KernelWidth);
}

void
SilhouettePoseMetricv4::UpdateWeights(EvaluationType & evaluation) const
{
  const auto & strands = m_Kernel->GetStrands();
  evaluation.weights.resize(strands.size());
  for (std::size_t s = 0; s < strands.size(); ++s)
  {
    const auto & lin = evaluation.strands[s];
    evaluation.weights[s].resize(lin.residual.size());
    for (std::size_t i = 0; i < lin.residual.size(); ++i)
    {
      evaluation.weights[s][i] = this->GetRobustWeight(lin.squaredDistance[i], lin.facing[i]);
    }
  }
}

void
SilhouettePoseMetricv4::FillCorrelation(const EvaluationType & evaluation, std::size_t s, double * correlation) const
{
  if (m_Normals.empty())
  {
    this->TakeNormals(evaluation);
  }
  const std::vector<double> & nu = m_Normals[s][0];
  const std::vector<double> & nv = m_Normals[s][1];
  const std::vector<double> & rho = (*m_Correlations)[s];
  const std::size_t           n = nu.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    correlation[i * n + i] = 1.0;
    for (std::size_t j = 0; j < i; ++j)
    {
      const double g = rho[i * n + j] * (nu[i] * nu[j] + nv[i] * nv[j]);
      correlation[i * n + j] = g;
      correlation[j * n + i] = g;
    }
  }
}

void
SilhouettePoseMetricv4::TakeNormals(const EvaluationType & evaluation) const
{
  m_Normals.clear();
  for (const auto & lin : evaluation.strands)
  {
    m_Normals.push_back({ { lin.nu, lin.nv } });
  }
}

void
SilhouettePoseMetricv4::UpdateNoiseCorrelation(const PositionType & x)
{
  this->TakeNormals(this->Evaluate(x));
  m_SettingsTime.Modified();
}

void
SilhouettePoseMetricv4::UpdateFactors(EvaluationType & evaluation) const
{
  this->UpdateCorrelations();
  if (evaluation.settingsTime == m_SettingsTime.GetMTime() && evaluation.kernelWidth == m_KernelWidth &&
      evaluation.levels.smooth == m_NoiseLevels.smooth && evaluation.levels.white == m_NoiseLevels.white)
  {
    return;
  }
  this->UpdateWeights(evaluation);
  const auto & strands = m_Kernel->GetStrands();
  evaluation.factors.resize(strands.size());
  evaluation.whitened.resize(strands.size());
  for (std::size_t s = 0; s < strands.size(); ++s)
  {
    const auto &                lin = evaluation.strands[s];
    const std::vector<double> & given = strands[s].tracing.weight;
    const std::size_t           n = lin.residual.size();
    std::vector<double> &       k = evaluation.factors[s];
    k.resize(n * n);
    this->FillCorrelation(evaluation, s, k.data());
    const double smooth2 = m_NoiseLevels.smooth * m_NoiseLevels.smooth;
    const double white2 = m_NoiseLevels.white * m_NoiseLevels.white;
    // The lower triangle, column by column, is all that the factorisation reads.
    for (std::size_t j = 0; j < n; ++j)
    {
      for (std::size_t i = j; i < n; ++i)
      {
        k[j * n + i] *= smooth2;
      }
      k[j * n + j] += white2 / std::max(given[j] * evaluation.weights[s][j], SmallestWeight);
    }
    if (!ContourNoiseModel::Factor(k.data(), n))
    {
      itkExceptionMacro("The covariance of the residuals is not positive definite; the noise model "
                        << m_NoiseModel->GetNameOfClass() << " must give correlations that are, and the white level ("
                        << m_NoiseLevels.white << " px) must be positive.");
    }
    evaluation.whitened[s] = lin.residual;
    ContourNoiseModel::Whiten(k.data(), n, evaluation.whitened[s].data(), 1);
  }
  evaluation.kernelWidth = m_KernelWidth;
  evaluation.levels = m_NoiseLevels;
  evaluation.settingsTime = m_SettingsTime.GetMTime();
}

void
SilhouettePoseMetricv4::ComputeResiduals(const PositionType & x, VectorType & residuals, MatrixType * jacobian) const
{
  EvaluationType &                         at = this->Evaluate(x);
  std::vector<std::vector<double>>         whitened;
  const std::vector<std::vector<double>> * factors = &at.factors;
  if (m_Hold == HoldEnum::Matches)
  {
    // The weights, and with them the covariance, are those of the position that is held.
    auto & held = const_cast<EvaluationType &>(*m_Held);
    this->UpdateFactors(held);
    factors = &held.factors;
    for (std::size_t s = 0; s < at.strands.size(); ++s)
    {
      whitened.push_back(at.strands[s].residual);
      ContourNoiseModel::Whiten((*factors)[s].data(), whitened[s].size(), whitened[s].data(), 1);
    }
  }
  else
  {
    this->UpdateFactors(at);
    whitened = at.whitened;
  }
  residuals.set_size(static_cast<unsigned int>(this->GetNumberOfResiduals()));
  if (jacobian != nullptr)
  {
    jacobian->set_size(residuals.size(), 7);
  }
  unsigned int        row = 0;
  std::vector<double> columns;
  for (std::size_t s = 0; s < at.strands.size(); ++s)
  {
    const auto &      lin = at.strands[s];
    const std::size_t n = lin.residual.size();
    for (std::size_t i = 0; i < n; ++i)
    {
      residuals[row + static_cast<unsigned int>(i)] = whitened[s][i];
    }
    if (jacobian != nullptr)
    {
      columns.resize(7 * n);
      for (std::size_t i = 0; i < n; ++i)
      {
        for (std::size_t a = 0; a < 7; ++a)
        {
          columns[a * n + i] = lin.jacobian[7 * i + a];
        }
      }
      ContourNoiseModel::Whiten((*factors)[s].data(), n, columns.data(), 7);
      for (std::size_t i = 0; i < n; ++i)
      {
        for (unsigned int a = 0; a < 7; ++a)
        {
          (*jacobian)(row + static_cast<unsigned int>(i), a) = columns[a * n + i];
        }
      }
    }
    row += static_cast<unsigned int>(n);
  }
  for (std::size_t s = 0; s < at.reverse.size(); ++s)
  {
    const auto & lin = at.reverse[s];
    const auto & weighing = m_Hold == HoldEnum::Matches ? m_Held->reverse[s] : lin;
    for (std::size_t i = 0; i < lin.residual.size(); ++i, ++row)
    {
      const double root =
        std::sqrt(m_Kernel->GetStrands()[s].reverse.GetWeight() * weighing.taper[i] *
                  this->GetRobustWeight(weighing.squaredDistance[i], weighing.facing[i]) / this->GetVariance());
      residuals[row] = root * lin.residual[i];
      for (unsigned int a = 0; jacobian != nullptr && a < 7; ++a)
      {
        (*jacobian)(row, a) = root * lin.jacobian[7 * i + a];
      }
    }
  }
  if (jacobian != nullptr && &at == &m_Last)
  {
    // An optimizer comes back here.
    m_Linearized = std::move(m_Last);
    m_Last = EvaluationType();
  }
}

double
SilhouettePoseMetricv4::ComputeValue(const PositionType & x) const
{
  EvaluationType & at = this->Evaluate(x);
  this->UpdateFactors(at);
  const auto & strands = m_Kernel->GetStrands();
  const double unit = m_KernelWidth * m_KernelWidth / (m_NoiseLevels.white * m_NoiseLevels.white);
  double       value = 0.0;
  for (std::size_t s = 0; s < strands.size(); ++s)
  {
    for (std::size_t i = 0; i < at.whitened[s].size(); ++i)
    {
      value += at.whitened[s][i] * at.whitened[s][i] +
               unit * strands[s].tracing.weight[i] * m_RobustKernel->GetCharge(at.weights[s][i]);
    }
  }
  const double width2 = m_KernelWidth * m_KernelWidth;
  for (std::size_t s = 0; s < at.reverse.size(); ++s)
  {
    const auto & lin = at.reverse[s];
    for (std::size_t i = 0; i < lin.residual.size(); ++i)
    {
      const double weight = this->GetRobustWeight(lin.squaredDistance[i], lin.facing[i]);
      value += strands[s].reverse.GetWeight() * lin.taper[i] / this->GetVariance() *
               (weight * lin.residual[i] * lin.residual[i] + width2 * m_RobustKernel->GetCharge(weight));
    }
  }
  return value;
}

void
SilhouettePoseMetricv4::ComputeGradient(const PositionType & x, VectorType & gradient) const
{
  EvaluationType & at = this->Evaluate(x);
  this->UpdateFactors(at);
  const auto & strands = m_Kernel->GetStrands();
  const double white2 = m_NoiseLevels.white * m_NoiseLevels.white;
  const double unit = m_KernelWidth * m_KernelWidth / white2;
  gradient.set_size(7);
  gradient.fill(0.0);
  for (std::size_t s = 0; s < strands.size(); ++s)
  {
    const auto &        lin = at.strands[s];
    const std::size_t   n = lin.residual.size();
    std::vector<double> z = at.whitened[s];
    ContourNoiseModel::WhitenTransposed(at.factors[s].data(), n, z.data(), 1);
    for (std::size_t i = 0; i < n; ++i)
    {
      const double given = strands[s].tracing.weight[i];
      const double weight = at.weights[s][i];
      // The weight moves as well: with it the point's variance, and what is charged.
      double byWeight = unit * given * m_RobustKernel->GetChargeDerivative(weight);
      if (given * weight > SmallestWeight)
      {
        byWeight += z[i] * z[i] * white2 / (given * weight * weight);
      }
      const double byDistance =
        byWeight * lin.facing[i] * m_RobustKernel->GetWeightDerivative(lin.squaredDistance[i], m_KernelWidth);
      for (unsigned int a = 0; a < 7; ++a)
      {
        gradient[a] += 2.0 * z[i] * lin.jacobian[7 * i + a] + byDistance * lin.distanceJacobian[7 * i + a];
      }
    }
  }
  const double width2 = m_KernelWidth * m_KernelWidth;
  for (std::size_t s = 0; s < at.reverse.size(); ++s)
  {
    const auto & lin = at.reverse[s];
    for (std::size_t i = 0; i < lin.residual.size(); ++i)
    {
      const double given = strands[s].reverse.GetWeight() / this->GetVariance();
      const double r = lin.residual[i];
      const double weight = this->GetRobustWeight(lin.squaredDistance[i], lin.facing[i]);
      const double byWeight = r * r + width2 * m_RobustKernel->GetChargeDerivative(weight);
      const double byDistance =
        byWeight * lin.facing[i] * m_RobustKernel->GetWeightDerivative(lin.squaredDistance[i], m_KernelWidth);
      const double ofTaper = weight * r * r + width2 * m_RobustKernel->GetCharge(weight);
      for (unsigned int a = 0; a < 7; ++a)
      {
        gradient[a] +=
          given *
          (lin.taper[i] * (2.0 * weight * r * lin.jacobian[7 * i + a] + byDistance * lin.distanceJacobian[7 * i + a]) +
           ofTaper * lin.taperJacobian[7 * i + a]);
      }
    }
  }
}

void
SilhouettePoseMetricv4::AddSquaredMotion(const PositionType & from,
                                         const PositionType & to,
                                         double &             sum,
                                         double &             count) const
{
  const std::vector<PoseContour> & contours = m_Held ? m_Held->contours : this->Evaluate(from).contours;
  m_Kernel->AddSquaredMotion(contours, ToPoseParameters(from), ToPoseParameters(to), sum, count);
}

std::vector<PoseFitStatistics>
SilhouettePoseMetricv4::ComputeFitStatistics(const PositionType & x) const
{
  const EvaluationType &         at = this->Evaluate(x);
  std::vector<PoseFitStatistics> statistics;
  for (std::size_t s = 0; s < at.contours.size(); ++s)
  {
    statistics.push_back(m_Kernel->ComputeStatistics(s, at.contours[s]));
  }
  return statistics;
}

void
SilhouettePoseMetricv4::AddFit(const PositionType & x, RegistrationFit & fit) const
{
  for (const PoseFitStatistics & statistics : this->ComputeFitStatistics(x))
  {
    fit.cost += statistics.cost * static_cast<double>(statistics.numberOfPoints);
    fit.numberOfPoints += statistics.numberOfPoints;
    if (statistics.hasCodes)
    {
      fit.codeOffset += std::abs(statistics.codeOffset);
      ++fit.numberOfCodedStrands;
    }
  }
}

void
SilhouettePoseMetricv4::AppendNoiseBlocks(const PositionType & x, std::vector<ResidualNoiseBlock> & blocks) const
{
  this->UpdateCorrelations();
  EvaluationType & at = this->Evaluate(x);
  this->UpdateWeights(at);
  // The weights may be newer than the factors now.
  at.settingsTime = 0;
  const auto & strands = m_Kernel->GetStrands();
  for (std::size_t s = 0; s < strands.size(); ++s)
  {
    const auto &       lin = at.strands[s];
    ResidualNoiseBlock block;
    block.model = m_NoiseModel;
    block.count = lin.residual.size();
    block.residuals = lin.residual;
    block.correlation.resize(block.count * block.count);
    this->FillCorrelation(at, s, block.correlation.data());
    block.jacobian.resize(7 * block.count);
    for (std::size_t i = 0; i < block.count; ++i)
    {
      block.weights.push_back(at.weights[s][i] * strands[s].tracing.weight[i]);
      for (std::size_t a = 0; a < 7; ++a)
      {
        block.jacobian[a * block.count + i] = lin.jacobian[7 * i + a];
      }
    }
    blocks.push_back(std::move(block));
  }
}

void
SilhouettePoseMetricv4::AddFixedInformation(const PositionType &, MatrixType &, VectorType &, double &) const
{}

void
SilhouettePoseMetricv4::Hold(HoldEnum what)
{
  if (what == HoldEnum::Nothing)
  {
    m_Held.reset();
  }
  else
  {
    m_Held = std::make_shared<const EvaluationType>(this->Evaluate(this->GetState().GetValues()));
  }
  m_Hold = what;
  m_Linearized = EvaluationType();
  m_Last = EvaluationType();
}

const std::vector<PoseContour> &
SilhouettePoseMetricv4::GetContours(const PositionType & x) const
{
  return this->Evaluate(x).contours;
}

std::array<double, 2>
SilhouettePoseMetricv4::PredictSigma(std::size_t                    s,
                                     const PositionType &           x,
                                     const std::array<double, 49> & covariance) const
{
  const EvaluationType & at = this->Evaluate(x);
  const PoseModel        model(m_Kernel->GetSettings().geometry, ToPoseParameters(x));
  const PoseContour &    contour = at.contours[s];
  const auto &           match = at.strands[s].match;
  if (match.empty() || contour.Size() == 0)
  {
    return { { 0.0, 0.0 } };
  }
  const auto variance = [&](std::size_t sample) {
    double jacobian[14];
    PoseMatching::ComputeSampleJacobian(model, contour, sample, jacobian);
    const auto own = PoseModel::PropagateCovariance(jacobian, covariance);
    return 0.5 * (own[0] + own[3]);
  };
  double      sum = 0.0;
  std::size_t count = 0;
  for (const std::size_t sample : match)
  {
    if (sample != PoseSilhouetteKernel::NoMatch)
    {
      sum += variance(sample);
      ++count;
    }
  }
  double largest = 0.0;
  for (std::size_t j = 0; j < contour.Size(); j += 10)
  {
    largest = std::max(largest, variance(j));
  }
  return { { count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0.0, std::sqrt(largest) } };
}

LightObject::Pointer
SilhouettePoseMetricv4::InternalClone() const
{
  auto clone = Self::New();
  clone->SetFixedObject(this->GetFixedObject());
  clone->SetMovingObject(this->GetMovingObject());
  clone->m_Surface = m_Surface;
  clone->m_Jaw = m_Jaw;
  clone->m_TracedSide = m_TracedSide;
  clone->m_UseSideSelection = m_UseSideSelection;
  clone->m_MidlineMargin = m_MidlineMargin;
  clone->m_UseFacingFilter = m_UseFacingFilter;
  clone->m_UseOrientation = m_UseOrientation;
  clone->m_OrientationWeight = m_OrientationWeight;
  clone->m_MaximumTracingPoints = m_MaximumTracingPoints;
  clone->m_GateByTooth = m_GateByTooth;
  clone->m_ToothRange = m_ToothRange;
  clone->m_ReverseWeight = m_ReverseWeight;
  clone->m_TaperLength = m_TaperLength;
  clone->m_GapLength = m_GapLength;
  clone->m_ExcludedTeeth = m_ExcludedTeeth;
  clone->m_RobustKernel = m_RobustKernel;
  clone->m_KernelWidth = m_KernelWidth;
  clone->m_NoiseModel = m_NoiseModel;
  clone->m_NoiseLevels = m_NoiseLevels;
  clone->m_Hold = m_Hold;
  clone->m_Kernel = m_Kernel;
  clone->m_Correlations = m_Correlations;
  clone->m_CorrelationsTime = m_CorrelationsTime;
  clone->m_Normals = m_Normals;
  if (m_Held && m_Hold == HoldEnum::Matches)
  {
    // A copy: its weights and factors are made anew where a setting changes, perhaps in several threads.
    clone->m_Held = std::make_shared<const EvaluationType>(*m_Held);
  }
  else
  {
    clone->m_Held = m_Held;
  }
  clone->CopyPose(*this);
  // Prepared as the original is: what the setters above changed is the same.
  clone->m_KernelTime = std::max(clone->Object::GetMTime(), m_KernelTime);
  return clone.GetPointer();
}

void
SilhouettePoseMetricv4::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Surface: " << (m_Surface ? m_Surface->triangles.size() : 0) << " triangles" << std::endl;
  os << indent << "Jaw: " << static_cast<int>(m_Jaw) << std::endl;
  os << indent << "TracedSide: " << m_TracedSide << std::endl;
  os << indent << "UseSideSelection: " << (m_UseSideSelection ? "On" : "Off") << std::endl;
  os << indent << "MidlineMargin: " << m_MidlineMargin << std::endl;
  os << indent << "UseFacingFilter: " << (m_UseFacingFilter ? "On" : "Off") << std::endl;
  os << indent << "UseOrientation: " << (m_UseOrientation ? "On" : "Off") << std::endl;
  os << indent << "OrientationWeight: " << m_OrientationWeight << std::endl;
  os << indent << "MaximumTracingPoints: " << m_MaximumTracingPoints << std::endl;
  os << indent << "GateByTooth: " << (m_GateByTooth ? "On" : "Off") << std::endl;
  os << indent << "ToothRange: " << m_ToothRange << std::endl;
  os << indent << "ReverseWeight: " << m_ReverseWeight << std::endl;
  os << indent << "TaperLength: " << m_TaperLength << std::endl;
  os << indent << "GapLength: " << m_GapLength << std::endl;
  os << indent << "ExcludedTeeth:";
  for (const unsigned int tooth : m_ExcludedTeeth)
  {
    os << ' ' << tooth;
  }
  os << std::endl;
  itkPrintSelfObjectMacro(RobustKernel);
  os << indent << "KernelWidth: " << m_KernelWidth << std::endl;
  itkPrintSelfObjectMacro(NoiseModel);
  os << indent << "NoiseLevels: " << m_NoiseLevels.smooth << ' ' << m_NoiseLevels.white << std::endl;
  os << indent << "Hold: " << static_cast<int>(m_Hold) << std::endl;
  os << indent << "Prepared: " << (m_Kernel ? "yes" : "no") << ", correlations "
     << (m_Correlations ? m_Correlations->size() : 0) << ", held " << (m_Held ? "yes" : "no") << std::endl;
}
} // namespace itk

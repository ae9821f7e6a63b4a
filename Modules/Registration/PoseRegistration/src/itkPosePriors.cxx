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
#include "itkPosePriors.h"

#include "itkForEachTerm.h"
#include "itkLeastSquaresSumMetricv4.h"
#include "itkPoseStateBlocks.h"

#include <limits>
#include <vector>

namespace itk
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
}

PosePriors::PosePriors(const PoseRegistrationOptions & options, bool pixelSpacingKnown)
  : m_Options(options)
  , m_PixelSpacingKnown(pixelSpacingKnown)
{}

PosePriors::SigmasType
PosePriors::GetFitSigmas(bool similarityOnly) const
{
  SigmasType sigmas{
    { Infinity, m_Options.rollSigma, m_Options.yawSigma, Infinity, m_Options.tySigma, Infinity, m_Options.kappaSigma }
  };
  if (!m_PixelSpacingKnown)
  {
    sigmas[PoseKappa] = m_Options.kappaSigmaWithoutSpacing;
  }
  if (similarityOnly || !m_Options.useFullPose || IsBisected(m_Options.tracedSide))
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

PosePriors::SigmasType
PosePriors::GetHeldSigmas() const
{
  SigmasType sigmas{};
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
    sigmas[PoseKappa] = m_PixelSpacingKnown ? m_Options.kappaSigma : m_Options.kappaSigmaWithoutSpacing;
  }
  return sigmas;
}

PosePriors::SigmasType
PosePriors::GetCovarianceSigmas() const
{
  SigmasType sigmas = this->GetFitSigmas(false);
  if (!m_Options.fixRotation)
  {
    for (const unsigned int k : { PoseRoll, PoseYaw })
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

ParameterPriorMetricv4::PriorType
PosePriors::MakePrior(unsigned int parameter, double sigma) const
{
  ParameterPriorMetricv4::PriorType prior;
  // What is held has no prior: it would add a constant.
  prior.sigma = sigma > 0.0 ? sigma : Infinity;
  // Roll and yaw have Student's t: tight for the many heads that stand straight, with tails for the frame or head that
  // does not.
  prior.degreesOfFreedom = parameter == PoseRoll || parameter == PoseYaw ? m_Options.rotationPriorFreedom : 0.0;
  return prior;
}

void
PosePriors::AddTo(LeastSquaresSumMetricv4 & sum) const
{
  auto pose = ParameterPriorMetricv4::New();
  pose->SetBlock(PoseStateBlocks::MakePose());
  auto scale = ParameterPriorMetricv4::New();
  scale->SetBlock(PoseStateBlocks::MakeScale());
  sum.AddMetric(pose);
  sum.AddMetric(scale);
  this->SetPriors(sum, this->GetFitSigmas(false), false);
}

void
PosePriors::SetFree(LeastSquaresMetricv4 & metric, const SigmasType & sigmas)
{
  std::vector<bool> pose;
  for (unsigned int k = 0; k < PoseKappa; ++k)
  {
    pose.push_back(sigmas[k] > 0.0);
  }
  metric.SetBlockFree("pose", pose);
  metric.SetBlockFree("scale", sigmas[PoseKappa] > 0.0);
}

void
PosePriors::SetPriors(LeastSquaresSumMetricv4 & sum, const SigmasType & sigmas, bool forVariance) const
{
  // The first of each block is the method's own; a user's prior on the same block comes after it and stays.
  bool poseIsSet = false;
  bool scaleIsSet = false;
  ForEachTerm<ParameterPriorMetricv4>(sum, [&](ParameterPriorMetricv4 & prior) {
    std::vector<ParameterPriorMetricv4::PriorType> priors;
    if (prior.GetBlock().parameters.empty())
    {
      return;
    }
    if (prior.GetBlock().name == "pose" && !poseIsSet)
    {
      poseIsSet = true;
      for (unsigned int k = 0; k < PoseKappa; ++k)
      {
        priors.push_back(this->MakePrior(k, sigmas[k]));
      }
    }
    else if (prior.GetBlock().name == "scale" && !scaleIsSet)
    {
      scaleIsSet = true;
      priors.push_back(this->MakePrior(PoseKappa, sigmas[PoseKappa]));
    }
    else
    {
      return;
    }
    prior.SetPriors(priors);
    prior.SetUseVariancePrecision(forVariance);
  });
}
} // namespace itk

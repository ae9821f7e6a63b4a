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
#include "itkLandmarkPoseMetricv4.h"

#include "itkPoseSilhouetteKernel.h"
#include "itkSquaresKernel.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
constexpr unsigned int NumberOfParameters = PoseMetricv4::NumberOfPoseParameters;
/** One width for all terms: their fits are added. */
constexpr double FitWidth = PoseSilhouetteKernel::FitWidth;

std::string
JoinNames(const std::vector<std::string> & names)
{
  std::string text;
  for (const std::string & name : names)
  {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text.empty() ? "none" : text;
}

template <typename TLandmarks>
std::string
ListNames(const TLandmarks & landmarks)
{
  std::vector<std::string> names;
  for (const auto & landmark : landmarks.GetLandmarks())
  {
    names.push_back(landmark.name);
  }
  return JoinNames(names);
}
} // namespace

LandmarkPoseMetricv4::LandmarkPoseMetricv4()
  : m_RobustKernel(SquaresKernel::New().GetPointer())
{}

void
LandmarkPoseMetricv4::SetCovariance(const std::string & name, const CovarianceType & covariance)
{
  m_Covariances[name] = covariance;
  this->Modified();
}

void
LandmarkPoseMetricv4::ClearCovariances()
{
  m_Covariances.clear();
  this->Modified();
}

void
LandmarkPoseMetricv4::SetRobustKernel(const RobustKernel * kernel)
{
  if (kernel == nullptr)
  {
    itkExceptionMacro("No robust kernel: give SetRobustKernel() one; SquaresKernel is least squares.");
  }
  if (m_RobustKernel != kernel)
  {
    m_RobustKernel = kernel;
    this->SettingsChanged();
  }
}

ModifiedTimeType
LandmarkPoseMetricv4::GetMTime() const
{
  return std::max(Superclass::GetMTime(), m_RobustKernel->GetMTime());
}

void
LandmarkPoseMetricv4::InitializeTerm()
{
  Superclass::InitializeTerm();
  const MovingLandmarksType * moving = this->GetMovingLandmarks();
  const FixedLandmarksType *  fixed = this->GetFixedLandmarks();
  if (moving == nullptr)
  {
    itkExceptionMacro(
      "No landmarks of the scan: call SetMovingLandmarks() with a DentalLandmarkSet in its dental frame.");
  }
  if (fixed == nullptr)
  {
    itkExceptionMacro("No landmarks of the radiograph: call SetFixedLandmarks() with a DentalLandmarkSet in pixels.");
  }
  if (!(m_Sigma > 0.0) || !(m_KernelWidthInSigmas > 0.0))
  {
    itkExceptionMacro("Sigma (" << m_Sigma << " px) and KernelWidthInSigmas (" << m_KernelWidthInSigmas
                                << ") must be positive: see SetSigma() and SetKernelWidthInSigmas().");
  }
  auto pairs = std::make_shared<PairsType>();
  for (const auto & landmark : fixed->GetLandmarks())
  {
    const auto * counterpart = moving->Find(landmark.name);
    if (counterpart == nullptr)
    {
      continue;
    }
    PairType pair;
    pair.name = landmark.name;
    pair.moving = counterpart->point;
    pair.fixed = landmark.point;
    CovarianceType covariance;
    covariance.SetIdentity();
    covariance *= m_Sigma * m_Sigma;
    const auto own = m_Covariances.find(landmark.name);
    if (own != m_Covariances.end())
    {
      covariance = own->second;
    }
    const double l00 = std::sqrt(covariance(0, 0));
    const double l10 = covariance(1, 0) / l00;
    const double l11 = std::sqrt(covariance(1, 1) - l10 * l10);
    if (!(l00 > 0.0) || !(l11 > 0.0) || covariance(0, 1) != covariance(1, 0))
    {
      itkExceptionMacro("The covariance of \"" << landmark.name
                                               << "\" is not symmetric and positive definite: give SetCovariance() the "
                                                  "square pixels by which the mark is uncertain.");
    }
    pair.whitening[0] = 1.0 / l00;
    pair.whitening[1] = -l10 / (l00 * l11);
    pair.whitening[2] = 1.0 / l11;
    pairs->push_back(pair);
  }
  if (pairs->empty())
  {
    itkExceptionMacro("No landmark is in both sets. The radiograph has: " << ListNames(*fixed) << "; the scan has: "
                                                                          << ListNames(*moving) << '.');
  }
  m_Pairs = pairs;
  m_HeldWeights.clear();
}

const LandmarkPoseMetricv4::PairsType &
LandmarkPoseMetricv4::GetPairs() const
{
  if (!m_Pairs)
  {
    itkExceptionMacro("The metric is not prepared: call Initialize().");
  }
  return *m_Pairs;
}

std::vector<std::string>
LandmarkPoseMetricv4::GetMatchedNames() const
{
  std::vector<std::string> names;
  for (const PairType & pair : this->GetPairs())
  {
    names.push_back(pair.name);
  }
  return names;
}

SizeValueType
LandmarkPoseMetricv4::GetNumberOfResiduals() const
{
  return 2 * this->GetPairs().size();
}

LandmarkPoseMetricv4::TransformType::Pointer
LandmarkPoseMetricv4::MakeTransformAt(const PositionType & x) const
{
  TransformType::ParametersType parameters(NumberOfParameters);
  std::copy_n(x.begin(), NumberOfParameters, parameters.begin());
  TransformType::Pointer transform = this->GetTransform()->Clone();
  transform->SetParameters(parameters);
  return transform;
}

void
LandmarkPoseMetricv4::ComputeDifference(const TransformType & transform,
                                        const PairType &      pair,
                                        double                difference[2],
                                        double *              jacobian) const
{
  const auto   projected = transform.TransformPoint(pair.moving);
  const double d[2] = { pair.fixed[0] - projected[0], pair.fixed[1] - projected[1] };
  difference[0] = pair.whitening[0] * d[0];
  difference[1] = pair.whitening[1] * d[0] + pair.whitening[2] * d[1];
  if (jacobian != nullptr)
  {
    TransformType::JacobianType projection;
    transform.ComputeJacobianWithRespectToParameters(pair.moving, projection);
    for (unsigned int a = 0; a < NumberOfParameters; ++a)
    {
      jacobian[a] = -pair.whitening[0] * projection(0, a);
      jacobian[NumberOfParameters + a] = -pair.whitening[1] * projection(0, a) - pair.whitening[2] * projection(1, a);
    }
  }
}

void
LandmarkPoseMetricv4::ComputeResiduals(const PositionType & x, VectorType & residuals, MatrixType * jacobian) const
{
  const auto        transform = this->MakeTransformAt(x);
  const PairsType & pairs = this->GetPairs();
  residuals.set_size(static_cast<unsigned int>(2 * pairs.size()));
  if (jacobian != nullptr)
  {
    jacobian->set_size(residuals.size(), NumberOfParameters);
  }
  for (unsigned int i = 0; i < pairs.size(); ++i)
  {
    double difference[2], derivative[2 * NumberOfParameters];
    this->ComputeDifference(*transform, pairs[i], difference, jacobian != nullptr ? derivative : nullptr);
    const double squared = difference[0] * difference[0] + difference[1] * difference[1];
    const double root =
      std::sqrt(m_HeldWeights.empty() ? m_RobustKernel->GetWeight(squared, m_KernelWidthInSigmas) : m_HeldWeights[i]);
    for (unsigned int axis = 0; axis < 2; ++axis)
    {
      residuals[2 * i + axis] = root * difference[axis];
      for (unsigned int a = 0; a < NumberOfParameters && jacobian != nullptr; ++a)
      {
        (*jacobian)(2 * i + axis, a) = root * derivative[NumberOfParameters * axis + a];
      }
    }
  }
}

double
LandmarkPoseMetricv4::ComputeValue(const PositionType & x) const
{
  const auto   transform = this->MakeTransformAt(x);
  const double unit = m_KernelWidthInSigmas * m_KernelWidthInSigmas;
  double       value = 0.0;
  for (const PairType & pair : this->GetPairs())
  {
    double difference[2];
    this->ComputeDifference(*transform, pair, difference, nullptr);
    const double squared = difference[0] * difference[0] + difference[1] * difference[1];
    const double weight = m_RobustKernel->GetWeight(squared, m_KernelWidthInSigmas);
    value += weight * squared + unit * m_RobustKernel->GetCharge(weight);
  }
  return value;
}

void
LandmarkPoseMetricv4::ComputeGradient(const PositionType & x, VectorType & gradient) const
{
  const auto   transform = this->MakeTransformAt(x);
  const double unit = m_KernelWidthInSigmas * m_KernelWidthInSigmas;
  gradient.set_size(NumberOfParameters);
  gradient.fill(0.0);
  for (const PairType & pair : this->GetPairs())
  {
    double difference[2], derivative[2 * NumberOfParameters];
    this->ComputeDifference(*transform, pair, difference, derivative);
    const double squared = difference[0] * difference[0] + difference[1] * difference[1];
    const double weight = m_RobustKernel->GetWeight(squared, m_KernelWidthInSigmas);
    // d value / d (squared distance), in which the weight moves as well.
    const double slope = weight + (squared + unit * m_RobustKernel->GetChargeDerivative(weight)) *
                                    m_RobustKernel->GetWeightDerivative(squared, m_KernelWidthInSigmas);
    for (unsigned int a = 0; a < NumberOfParameters; ++a)
    {
      gradient[a] += 2.0 * slope * (difference[0] * derivative[a] + difference[1] * derivative[NumberOfParameters + a]);
    }
  }
}

void
LandmarkPoseMetricv4::AddSquaredMotion(const PositionType & from,
                                       const PositionType & to,
                                       double &             sum,
                                       double &             count) const
{
  const auto           before = this->MakeTransformAt(from);
  const auto           after = this->MakeTransformAt(to);
  const PoseGeometry & geometry = this->GetTransform()->GetPoseGeometry();
  for (const PairType & pair : this->GetPairs())
  {
    const auto   move = after->TransformPoint(pair.moving) - before->TransformPoint(pair.moving);
    const double u = move[0] * geometry.pixelSpacing[0] / PoseWorkingPixel;
    const double v = move[1] * geometry.pixelSpacing[1] / PoseWorkingPixel;
    sum += u * u + v * v;
    count += 1.0;
  }
}

void
LandmarkPoseMetricv4::AddFit(const PositionType & x, RegistrationFit & fit) const
{
  const auto           transform = this->MakeTransformAt(x);
  const PoseGeometry & geometry = this->GetTransform()->GetPoseGeometry();
  for (const PairType & pair : this->GetPairs())
  {
    const auto   difference = pair.fixed - transform->TransformPoint(pair.moving);
    const double u = difference[0] * geometry.pixelSpacing[0] / PoseWorkingPixel;
    const double v = difference[1] * geometry.pixelSpacing[1] / PoseWorkingPixel;
    fit.cost += 1.0 - FitWidth * FitWidth / (FitWidth * FitWidth + u * u + v * v);
    ++fit.numberOfPoints;
  }
}

void
LandmarkPoseMetricv4::Hold(HoldEnum what)
{
  m_HeldWeights.clear();
  if (what != HoldEnum::Matches)
  {
    return;
  }
  const auto transform = this->MakeTransformAt(this->GetState().GetValues());
  for (const PairType & pair : this->GetPairs())
  {
    double difference[2];
    this->ComputeDifference(*transform, pair, difference, nullptr);
    m_HeldWeights.push_back(
      m_RobustKernel->GetWeight(difference[0] * difference[0] + difference[1] * difference[1], m_KernelWidthInSigmas));
  }
}

LightObject::Pointer
LandmarkPoseMetricv4::InternalClone() const
{
  auto clone = Self::New();
  clone->SetFixedObject(this->GetFixedObject());
  clone->SetMovingObject(this->GetMovingObject());
  clone->m_Sigma = m_Sigma;
  clone->m_Covariances = m_Covariances;
  clone->m_RobustKernel = m_RobustKernel;
  clone->m_KernelWidthInSigmas = m_KernelWidthInSigmas;
  clone->m_Pairs = m_Pairs;
  clone->m_HeldWeights = m_HeldWeights;
  clone->CopyPose(*this);
  return clone.GetPointer();
}

void
LandmarkPoseMetricv4::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Sigma: " << m_Sigma << std::endl;
  os << indent << "Covariances: " << m_Covariances.size() << std::endl;
  itkPrintSelfObjectMacro(RobustKernel);
  os << indent << "KernelWidthInSigmas: " << m_KernelWidthInSigmas << std::endl;
  os << indent << "Pairs: " << (m_Pairs ? m_Pairs->size() : 0) << std::endl;
  os << indent << "HeldWeights: " << m_HeldWeights.size() << std::endl;
}
} // namespace itk

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

#include "itkJoinNames.h"
#include "itkPoseSilhouetteKernel.h"
#include "itkSquaresKernel.h"
#include "itkToothOutlinePoseMetricv4.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
constexpr unsigned int NumberOfParameters = PoseMetricv4::NumberOfPoseParameters;
/** Width of the kernel that fits are judged with, standard deviations. */
constexpr double FitWidthInSigmas = 4.0;

std::string
ListNames(const LandmarkCounterpartSet & counterparts)
{
  std::vector<std::string> names;
  for (const auto & counterpart : counterparts.GetCounterparts())
  {
    names.push_back(counterpart.name);
  }
  return names.empty() ? "none" : JoinNames(names);
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
  return names.empty() ? "none" : JoinNames(names);
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
LandmarkPoseMetricv4::SetOutlinedTeeth(const std::vector<ToothCode> & teeth)
{
  if (m_OutlinedTeeth != teeth)
  {
    m_OutlinedTeeth = teeth;
    this->Modified();
  }
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
  const bool isAnalysis = this->GetCounterparts() != nullptr || this->GetCephalometricLandmarks() != nullptr;
  const bool hasMoving = isAnalysis ? this->GetCounterparts() != nullptr : this->GetMovingLandmarks() != nullptr;
  const bool hasFixed =
    isAnalysis ? this->GetCephalometricLandmarks() != nullptr : this->GetFixedLandmarks() != nullptr;
  if (!hasMoving)
  {
    itkExceptionMacro("No landmarks of the scan: call "
                      << (isAnalysis ? "SetCounterparts() with a LandmarkCounterpartSet"
                                     : "SetMovingLandmarks() with a DentalLandmarkSet")
                      << " in its dental frame.");
  }
  if (!hasFixed)
  {
    itkExceptionMacro("No landmarks of the radiograph: call "
                      << (isAnalysis ? "SetCephalometricLandmarks() with a CephalometricLandmarkSet"
                                     : "SetFixedLandmarks() with a DentalLandmarkSet")
                      << " in pixels.");
  }
  if (!(m_Sigma > 0.0) || !(m_KernelWidthInSigmas > 0.0))
  {
    itkExceptionMacro("Sigma (" << m_Sigma << " px) and KernelWidthInSigmas (" << m_KernelWidthInSigmas
                                << ") must be positive: see SetSigma() and SetKernelWidthInSigmas().");
  }
  const auto pairs = std::make_shared<PairsType>(
    isAnalysis ? this->PairCounterparts(*this->GetCounterparts(), *this->GetCephalometricLandmarks())
               : this->PairByName(*this->GetMovingLandmarks(), *this->GetFixedLandmarks()));
  if (pairs->empty())
  {
    itkExceptionMacro(
      "No landmark is in both sets. The radiograph has: "
      << (isAnalysis ? ListNames(*this->GetCephalometricLandmarks()) : ListNames(*this->GetFixedLandmarks()))
      << "; the scan has: "
      << (isAnalysis ? ListNames(*this->GetCounterparts()) : ListNames(*this->GetMovingLandmarks())) << '.');
  }
  m_Pairs = pairs;
  m_HeldWeights.clear();
  this->ChooseForemost(this->GetState().GetValues());
}

void
LandmarkPoseMetricv4::SetWhitening(const CovarianceType & covariance, PairType & pair) const
{
  const double l00 = std::sqrt(covariance(0, 0));
  const double l10 = covariance(1, 0) / l00;
  const double l11 = std::sqrt(covariance(1, 1) - l10 * l10);
  if (!(l00 > 0.0) || !(l11 > 0.0) || covariance(0, 1) != covariance(1, 0))
  {
    itkExceptionMacro("The covariance of \"" << pair.name
                                             << "\" is not symmetric and positive definite: give SetCovariance() the "
                                                "square pixels by which the mark is uncertain.");
  }
  pair.whitening[0] = 1.0 / l00;
  pair.whitening[1] = -l10 / (l00 * l11);
  pair.whitening[2] = 1.0 / l11;
}

LandmarkPoseMetricv4::PairsType
LandmarkPoseMetricv4::PairByName(const MovingLandmarksType & moving, const FixedLandmarksType & fixed) const
{
  PairsType pairs;
  for (const auto & landmark : fixed.GetLandmarks())
  {
    const auto * counterpart = moving.Find(landmark.name);
    if (counterpart == nullptr)
    {
      continue;
    }
    PairType pair;
    pair.name = landmark.name;
    pair.moving = { counterpart->point };
    pair.rule = LandmarkCounterpartSet::RuleEnum::Middle;
    pair.fixed = landmark.point;
    CovarianceType covariance;
    covariance.SetIdentity();
    covariance *= m_Sigma * m_Sigma;
    const auto own = m_Covariances.find(landmark.name);
    this->SetWhitening(own != m_Covariances.end() ? own->second : covariance, pair);
    pairs.push_back(pair);
  }
  return pairs;
}

LandmarkPoseMetricv4::PairsType
LandmarkPoseMetricv4::PairCounterparts(const LandmarkCounterpartSet &   moving,
                                       const CephalometricLandmarkSet & fixed) const
{
  const PoseGeometry & geometry = this->GetTransform()->GetPoseGeometry();
  const double         magnification = geometry.sourceToDetector / geometry.sourceToMidsagittal;
  PairsType            pairs;
  for (const auto & landmark : fixed.GetLandmarks())
  {
    const std::string name = CephalometricLandmarkSet::MakeName(landmark.meaning);
    const auto *      counterpart = moving.Find(name);
    if (counterpart == nullptr)
    {
      continue;
    }
    PairType pair;
    pair.name = name;
    pair.moving = counterpart->points;
    pair.rule = counterpart->rule;
    pair.fixed = landmark.point;
    const double factor = landmark.confidence >= 0.0 ? ComputeConfidenceFactor(landmark.confidence) : 1.0;
    const double reader[2] = { ReaderSigmaAlong, ReaderSigmaAcross };
    const double own[2] = { counterpart->sigmaAlong, counterpart->sigmaAcross };
    const bool   isOutlined = std::any_of(m_OutlinedTeeth.begin(), m_OutlinedTeeth.end(), [&](const ToothCode & tooth) {
      return geometry.direction == CephalometricDirectionEnum::Frontal
                 ? tooth == landmark.meaning.tooth
                 : tooth.GetPosition() == landmark.meaning.position;
    });
    CovarianceType covariance;
    covariance.Fill(0.0);
    for (unsigned int axis = 0; axis < 2; ++axis)
    {
      const double mark = landmark.sigma > 0.0 ? landmark.sigma : factor * reader[axis] / geometry.pixelSpacing[axis];
      const double scan = magnification * own[axis] / geometry.pixelSpacing[axis];
      const double shared = isOutlined ? 1.0 + ToothOutlinePoseMetricv4::SharedErrorShare : 1.0;
      covariance(axis, axis) = shared * mark * mark + scan * scan;
    }
    const auto given = m_Covariances.find(name);
    this->SetWhitening(given != m_Covariances.end() ? given->second : covariance, pair);
    pairs.push_back(pair);
  }
  return pairs;
}

double
LandmarkPoseMetricv4::ComputeConfidenceFactor(double confidence)
{
  return 2.0 - 1.25 * std::min(1.0, std::max(0.0, confidence));
}

std::array<double, 2>
LandmarkPoseMetricv4::GetShares(std::size_t number) const
{
  const PairType & pair = this->GetPairs()[number];
  if (pair.moving.size() == 1)
  {
    return { { 1.0, 0.0 } };
  }
  // Which of two is foremost is not seen from the front: a name without a side is the midline's.
  if (pair.rule == LandmarkCounterpartSet::RuleEnum::Middle ||
      this->GetTransform()->GetPoseGeometry().direction == CephalometricDirectionEnum::Frontal)
  {
    return { { 0.5, 0.5 } };
  }
  return m_Foremost[number] == 0 ? std::array<double, 2>{ { 1.0, 0.0 } } : std::array<double, 2>{ { 0.0, 1.0 } };
}

LandmarkPoseMetricv4::TransformType::OutputPointType
LandmarkPoseMetricv4::ProjectPair(const TransformType & transform, std::size_t number) const
{
  const PairType &               pair = this->GetPairs()[number];
  const auto                     shares = this->GetShares(number);
  TransformType::OutputPointType image;
  image.Fill(0.0);
  for (std::size_t k = 0; k < pair.moving.size(); ++k)
  {
    if (shares[k] > 0.0)
    {
      const auto projected = transform.TransformPoint(pair.moving[k]);
      image[0] += shares[k] * projected[0];
      image[1] += shares[k] * projected[1];
    }
  }
  return image;
}

void
LandmarkPoseMetricv4::ChooseForemost(const PositionType & x)
{
  const PairsType & pairs = this->GetPairs();
  m_Foremost.assign(pairs.size(), 0);
  const auto   transform = this->MakeTransformAt(x);
  const double facing = this->GetTransform()->GetPoseGeometry().facingSign;
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    if (pairs[i].moving.size() == 2)
    {
      const auto first = transform->TransformPoint(pairs[i].moving[0]);
      const auto second = transform->TransformPoint(pairs[i].moving[1]);
      m_Foremost[i] = facing * (second[0] - first[0]) > 0.0 ? 1 : 0;
    }
  }
}

std::vector<LandmarkPoseMetricv4::ResidualType>
LandmarkPoseMetricv4::ComputeLandmarkResiduals(const PositionType & x) const
{
  const auto                transform = this->MakeTransformAt(x);
  const PairsType &         pairs = this->GetPairs();
  std::vector<ResidualType> residuals;
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    double whitened[2];
    this->ComputeDifference(*transform, i, whitened, nullptr);
    const double squared = whitened[0] * whitened[0] + whitened[1] * whitened[1];
    const auto   difference = pairs[i].fixed - this->ProjectPair(*transform, i);
    // The whitening is the inverse of the covariance's lower triangular root.
    const auto & whitening = pairs[i].whitening;
    const double lower = whitening[1] / whitening[0];
    residuals.push_back({ pairs[i].name,
                          { difference[0], difference[1] },
                          { 1.0 / whitening[0], std::hypot(1.0, lower) / whitening[2] },
                          std::sqrt(squared),
                          m_RobustKernel->GetWeight(squared, m_KernelWidthInSigmas) });
  }
  return residuals;
}

std::vector<LandmarkPoseMetricv4::CorrespondenceType>
LandmarkPoseMetricv4::GetCorrespondences() const
{
  std::vector<CorrespondenceType> correspondences;
  for (const PairType & pair : this->GetPairs())
  {
    CorrespondenceType correspondence;
    correspondence.fixed = pair.fixed;
    correspondence.moving.Fill(0.0);
    for (const auto & point : pair.moving)
    {
      for (unsigned int d = 0; d < 3; ++d)
      {
        correspondence.moving[d] += point[d] / static_cast<double>(pair.moving.size());
      }
    }
    correspondences.push_back(correspondence);
  }
  return correspondences;
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
  if (this->GetTransform() == nullptr)
  {
    itkExceptionMacro("The metric is not prepared: call SetTransform() and Initialize().");
  }
  TransformType::ParametersType parameters(NumberOfParameters);
  std::copy_n(x.begin(), NumberOfParameters, parameters.begin());
  TransformType::Pointer transform = this->GetTransform()->Clone();
  transform->SetParameters(parameters);
  return transform;
}

void
LandmarkPoseMetricv4::ComputeDifference(const TransformType & transform,
                                        std::size_t           number,
                                        double                difference[2],
                                        double *              jacobian) const
{
  const PairType & pair = this->GetPairs()[number];
  const auto       projected = this->ProjectPair(transform, number);
  const double     d[2] = { pair.fixed[0] - projected[0], pair.fixed[1] - projected[1] };
  difference[0] = pair.whitening[0] * d[0];
  difference[1] = pair.whitening[1] * d[0] + pair.whitening[2] * d[1];
  if (jacobian == nullptr)
  {
    return;
  }
  std::fill_n(jacobian, 2 * NumberOfParameters, 0.0);
  const auto shares = this->GetShares(number);
  for (std::size_t k = 0; k < pair.moving.size(); ++k)
  {
    if (shares[k] == 0.0)
    {
      continue;
    }
    TransformType::JacobianType projection;
    transform.ComputeJacobianWithRespectToParameters(pair.moving[k], projection);
    for (unsigned int a = 0; a < NumberOfParameters; ++a)
    {
      jacobian[a] -= shares[k] * pair.whitening[0] * projection(0, a);
      jacobian[NumberOfParameters + a] -=
        shares[k] * (pair.whitening[1] * projection(0, a) + pair.whitening[2] * projection(1, a));
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
    this->ComputeDifference(*transform, i, difference, jacobian != nullptr ? derivative : nullptr);
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
  for (std::size_t i = 0; i < this->GetPairs().size(); ++i)
  {
    double difference[2];
    this->ComputeDifference(*transform, i, difference, nullptr);
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
  for (std::size_t i = 0; i < this->GetPairs().size(); ++i)
  {
    double difference[2], derivative[2 * NumberOfParameters];
    this->ComputeDifference(*transform, i, difference, derivative);
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
  for (std::size_t i = 0; i < this->GetPairs().size(); ++i)
  {
    const auto   move = this->ProjectPair(*after, i) - this->ProjectPair(*before, i);
    const double u = move[0] * geometry.pixelSpacing[0] / PoseWorkingPixel;
    const double v = move[1] * geometry.pixelSpacing[1] / PoseWorkingPixel;
    sum += u * u + v * v;
    count += 1.0;
  }
}

void
LandmarkPoseMetricv4::AddFit(const PositionType & x, RegistrationFit & fit) const
{
  // By what is known of each mark's error: the width, in its standard deviations, is to a mark what 4 px are to a point
  // of a tracing, whose error is one.
  const auto   transform = this->MakeTransformAt(x);
  const double unit = FitWidthInSigmas * FitWidthInSigmas;
  for (std::size_t i = 0; i < this->GetPairs().size(); ++i)
  {
    double difference[2];
    this->ComputeDifference(*transform, i, difference, nullptr);
    fit.cost += 1.0 - unit / (unit + difference[0] * difference[0] + difference[1] * difference[1]);
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
  this->ChooseForemost(this->GetState().GetValues());
  const auto transform = this->MakeTransformAt(this->GetState().GetValues());
  for (std::size_t i = 0; i < this->GetPairs().size(); ++i)
  {
    double difference[2];
    this->ComputeDifference(*transform, i, difference, nullptr);
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
  clone->m_OutlinedTeeth = m_OutlinedTeeth;
  clone->m_RobustKernel = m_RobustKernel;
  clone->m_KernelWidthInSigmas = m_KernelWidthInSigmas;
  clone->m_Pairs = m_Pairs;
  clone->m_Foremost = m_Foremost;
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
  os << indent << "OutlinedTeeth: " << m_OutlinedTeeth.size() << std::endl;
  itkPrintSelfObjectMacro(RobustKernel);
  os << indent << "KernelWidthInSigmas: " << m_KernelWidthInSigmas << std::endl;
  os << indent << "Pairs: " << (m_Pairs ? m_Pairs->size() : 0) << std::endl;
  os << indent << "Foremost: " << m_Foremost.size() << std::endl;
  os << indent << "HeldWeights: " << m_HeldWeights.size() << std::endl;
}
} // namespace itk

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
#include "itkLandmarkProjectionFilter.h"

#include "itkCephalometricLandmarkSet.h"

#include "itkMath.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace itk
{
namespace
{
using LandmarksType = LandmarkProjectionFilter::LandmarksType;

/** What a name says behind the tooth's code: "_MB". */
std::string
KindOf(const std::string & name)
{
  return name.substr(std::min(name.size(), name.find('_')));
}

/** The same landmark of the other side; null without one. */
template <typename TLandmarks>
const typename TLandmarks::LandmarkType *
FindOtherSide(const TLandmarks & landmarks, const typename TLandmarks::LandmarkType & own)
{
  const auto & all = landmarks.GetLandmarks();
  const auto   found = std::find_if(all.begin(), all.end(), [&](const auto & landmark) {
    return landmark.tooth == own.tooth.GetContralateral() && KindOf(landmark.name) == KindOf(own.name);
  });
  return found == all.end() ? nullptr : &*found;
}
} // namespace

LandmarkProjectionFilter::LandmarkProjectionFilter()
{
  this->AddRequiredInputName("Solution", 0);
  this->AddOptionalInputName("Landmarks", 1);
  this->AddOptionalInputName("Counterparts", 2);
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
}

LandmarkProjectionFilter::DataObjectPointer
LandmarkProjectionFilter::MakeOutput(DataObjectPointerArraySizeType)
{
  return OutputType::New().GetPointer();
}

LandmarkProjectionFilter::OutputType *
LandmarkProjectionFilter::GetOutput()
{
  return itkDynamicCastInDebugMode<OutputType *>(this->ProcessObject::GetOutput(0));
}

PoseSolution::PointType
LandmarkProjectionFilter::ToMillimetres(const LandmarksType::PointType & point) const
{
  PoseSolution::PointType millimetres;
  for (unsigned int d = 0; d < 3; ++d)
  {
    millimetres[d] = point[d] * m_MillimetresPerUnit;
  }
  return millimetres;
}

void
LandmarkProjectionFilter::VerifyPreconditions() ITKv5_CONST
{
  Superclass::VerifyPreconditions();
  if (this->GetLandmarks() == nullptr && this->GetCounterparts() == nullptr)
  {
    itkExceptionMacro("There is nothing to project: call SetLandmarks() with landmarks of the scans, or "
                      "SetCounterparts() with what a LandmarkCounterpartFilter found on them.");
  }
}

void
LandmarkProjectionFilter::GenerateData()
{
  this->GetOutput()->Initialize();
  m_Covariances.clear();
  m_MiddleCovariances.clear();
  m_Middles.clear();
  if (const LandmarksType * landmarks = this->GetLandmarks())
  {
    this->ProjectLandmarks(*landmarks);
  }
  if (const LandmarkCounterpartSet * counterparts = this->GetCounterparts())
  {
    const auto ofLandmarks = static_cast<std::ptrdiff_t>(m_Middles.size());
    for (const auto & counterpart : counterparts->GetCounterparts())
    {
      const bool isThere = std::any_of(m_Middles.begin(),
                                       m_Middles.begin() + ofLandmarks,
                                       [&](const MiddleType & middle) { return middle.name == counterpart.name; });
      // The place of a tooth of one side is no middle.
      const bool hasSide = CephalometricLandmarkSet::ParseName(counterpart.name).tooth.IsKnown();
      if (!isThere && !hasSide && this->GetSolution()->IsRegistered(counterpart.jaw))
      {
        this->AddMiddle(counterpart);
      }
    }
  }
}

void
LandmarkProjectionFilter::AddMiddle(const LandmarkCounterpartSet::CounterpartType & counterpart)
{
  const PoseSolution *    solution = this->GetSolution();
  const bool              isOneSided = counterpart.points.size() == 1;
  PoseSolution::PointType place;
  place.SetToMidPoint(counterpart.points.front(), counterpart.points.back());
  MiddleType middle;
  middle.name = counterpart.name;
  middle.jaw = counterpart.jaw;
  middle.source = counterpart.source + (isOneSided ? ", one side" : "");
  const auto right = solution->ProjectPoint(counterpart.jaw, counterpart.points.front());
  const auto left = solution->ProjectPoint(counterpart.jaw, counterpart.points.back());
  for (unsigned int d = 0; d < 2; ++d)
  {
    middle.point[d] = 0.5 * (right[d] + left[d]);
  }
  const CovarianceType ofPose = solution->ComputeCovariance(counterpart.jaw, place);
  const PoseGeometry & geometry = solution->GetResult().geometry;
  const double         magnification = geometry.sourceToDetector / geometry.sourceToMidsagittal;
  // Of a posterior tooth the counterpart's errors know already that its other side is not there; of an incisor the
  // foremost was looked for, which is one tooth anyway.
  const bool   isWider = isOneSided && counterpart.rule == LandmarkCounterpartSet::RuleEnum::Foremost;
  const double along =
    isWider ? std::hypot(counterpart.sigmaAlong, LandmarkCounterpartSet::OneSideSigmaAlong) : counterpart.sigmaAlong;
  const double across =
    isWider ? std::hypot(counterpart.sigmaAcross, LandmarkCounterpartSet::OneSideSigmaAcross) : counterpart.sigmaAcross;
  const double own[2] = { magnification * along / geometry.pixelSpacing[0],
                          magnification * across / geometry.pixelSpacing[1] };
  middle.covariance = ofPose;
  for (unsigned int d = 0; d < 2; ++d)
  {
    middle.covariance(d, d) += own[d] * own[d];
  }
  // Where this very point was marked, the mark tells of its place as well: of the residual r, with covariance R, the
  // place's error C takes the share A = C / R, and what is left of it is (1 - A) C, beside the share 1 - A of the
  // pose's. What the mark says that the place is off is in the second moment about it. A mark that the kernel has let
  // go by 1 - w tells nothing by as much.
  const auto & used = solution->GetJaw(counterpart.jaw).landmarks;
  const auto   mark = std::find_if(
    used.begin(), used.end(), [&](const PoseLandmarkFit & landmark) { return landmark.name == counterpart.name; });
  if (mark != used.end() && mark->sigma[0] > 0.0 && mark->sigma[1] > 0.0)
  {
    double share[2];
    for (unsigned int d = 0; d < 2; ++d)
    {
      share[d] = std::min(1.0, own[d] * own[d] / (mark->sigma[d] * mark->sigma[d]));
    }
    for (unsigned int d = 0; d < 2; ++d)
    {
      for (unsigned int k = 0; k < 2; ++k)
      {
        const double told = (1.0 - share[d]) * ofPose(d, k) * (1.0 - share[k]) +
                            (d == k ? (1.0 - share[d]) * own[d] * own[d] : 0.0) +
                            share[d] * mark->residual[d] * share[k] * mark->residual[k];
        middle.covariance(d, k) += mark->weight * (told - middle.covariance(d, k));
      }
    }
  }
  m_Middles.push_back(middle);
}

void
LandmarkProjectionFilter::ProjectLandmarks(const LandmarksType & landmarks)
{
  const PoseSolution * solution = this->GetSolution();
  OutputType *         output = this->GetOutput();
  for (const auto & landmark : landmarks.GetLandmarks())
  {
    const auto jaw = landmark.tooth.GetJaw();
    if (!solution->IsRegistered(jaw))
    {
      continue;
    }
    const auto            point = this->ToMillimetres(landmark.point);
    const auto            pixel = solution->ProjectPoint(jaw, point);
    OutputType::PointType place;
    place[0] = pixel[0];
    place[1] = pixel[1];
    if (!std::isfinite(place[0]) || !std::isfinite(place[1]))
    {
      itkExceptionMacro("The solution projects landmark " << landmark.name << " to " << place
                                                          << ": it is none of the scan that was registered, see "
                                                             "SetLandmarks() and SetMillimetresPerUnit().");
    }
    output->AddLandmark(landmark.name, place);
    m_Covariances[landmark.name] = solution->ComputeCovariance(jaw, point);
    if (const auto * other = FindOtherSide(landmarks, landmark))
    {
      // The middle of two projections is the projection of the middle but for the perspective between them.
      PoseSolution::PointType middle;
      middle.SetToMidPoint(point, this->ToMillimetres(other->point));
      m_MiddleCovariances[landmark.name] = solution->ComputeCovariance(jaw, middle);
    }
  }
  for (const auto & right : output->GetLandmarks())
  {
    const auto * left = right.tooth.IsRight() ? FindOtherSide(*output, right) : nullptr;
    if (left != nullptr)
    {
      MiddleType middle;
      middle.jaw = right.tooth.GetJaw();
      middle.name =
        (middle.jaw == JawEnum::Upper ? "U" : "L") + std::to_string(right.tooth.GetPosition()) + KindOf(right.name);
      middle.point.SetToMidPoint(right.point, left->point);
      middle.covariance = m_MiddleCovariances[right.name];
      middle.source = "landmarks_3d";
      m_Middles.push_back(middle);
    }
  }
}

LandmarkProjectionFilter::CovarianceType
LandmarkProjectionFilter::GetCovariance(const std::string & name) const
{
  const auto found = m_Covariances.find(name);
  if (found == m_Covariances.end())
  {
    itkExceptionMacro("There is no landmark \"" << name << "\" in the output: call Update(), and look at GetOutput().");
  }
  return found->second;
}

double
LandmarkProjectionFilter::GetSigma(const std::string & name) const
{
  return ToSigma(this->GetCovariance(name));
}

double
LandmarkProjectionFilter::ToSigma(const CovarianceType & covariance)
{
  return std::sqrt(0.5 * (covariance(0, 0) + covariance(1, 1)));
}

double
LandmarkProjectionFilter::ToMeanDistance(double sigma)
{
  return std::sqrt(0.5 * Math::pi) * sigma;
}

std::vector<double>
LandmarkProjectionFilter::CollectSigmas(JawEnum jaw) const
{
  std::vector<double> sigmas;
  if (m_Bisected)
  {
    for (const MiddleType & middle : m_Middles)
    {
      // How far off the jaw is, and not how far off the places of points are that were found on its scan.
      const std::string right = middle.name.substr(0, 1) + "R" + middle.name.substr(1);
      if (middle.jaw == jaw && m_MiddleCovariances.count(right) != 0)
      {
        sigmas.push_back(ToSigma(middle.covariance));
      }
    }
  }
  if (sigmas.empty())
  {
    const auto * output = itkDynamicCastInDebugMode<const OutputType *>(this->ProcessObject::GetOutput(0));
    for (const auto & landmark : output->GetLandmarks())
    {
      if (landmark.tooth.GetJaw() == jaw)
      {
        sigmas.push_back(this->GetSigma(landmark.name));
      }
    }
  }
  return sigmas;
}

bool
LandmarkProjectionFilter::HasExpectedError(JawEnum jaw) const
{
  return !this->CollectSigmas(jaw).empty();
}

double
LandmarkProjectionFilter::GetExpectedError(JawEnum jaw) const
{
  const std::vector<double> sigmas = this->CollectSigmas(jaw);
  if (sigmas.empty())
  {
    itkExceptionMacro("There is no landmark of the " << ToString(jaw)
                                                     << " jaw in the output: ask HasExpectedError() first.");
  }
  return ToMeanDistance(std::accumulate(sigmas.begin(), sigmas.end(), 0.0) / static_cast<double>(sigmas.size()));
}

bool
LandmarkProjectionFilter::HasMiddleCovariance(const std::string & name) const
{
  return m_MiddleCovariances.count(name) != 0;
}

LandmarkProjectionFilter::CovarianceType
LandmarkProjectionFilter::GetMiddleCovariance(const std::string & name) const
{
  const auto found = m_MiddleCovariances.find(name);
  if (found == m_MiddleCovariances.end())
  {
    itkExceptionMacro("The landmark \"" << name
                                        << "\" has no counterpart on the other side: ask "
                                           "HasMiddleCovariance() first.");
  }
  return found->second;
}

void
LandmarkProjectionFilter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "MillimetresPerUnit: " << m_MillimetresPerUnit << std::endl;
  os << indent << "Bisected: " << (m_Bisected ? "On" : "Off") << std::endl;
  os << indent << "Covariances: " << m_Covariances.size() << std::endl;
  os << indent << "MiddleCovariances: " << m_MiddleCovariances.size() << std::endl;
  os << indent << "Middles: " << m_Middles.size() << std::endl;
}
} // namespace itk

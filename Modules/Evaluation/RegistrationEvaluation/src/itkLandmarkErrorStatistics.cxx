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
#include "itkLandmarkErrorStatistics.h"

#include "itkMacro.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace itk
{
constexpr std::array<double, 4> LandmarkErrorStatistics::SuccessThresholds;

namespace
{
template <typename TMoments>
const TMoments &
NotEmpty(const TMoments & moments, const char * what)
{
  if (moments.count == 0)
  {
    itkGenericExceptionMacro("There are no landmark errors" << what
                                                            << ", hence no figure of them. Ask for the count first.");
  }
  return moments;
}

template <typename TMoments>
double
RootMeanSquare(const TMoments & moments)
{
  return std::sqrt(moments.mean * moments.mean + moments.squares / static_cast<double>(moments.count));
}

template <typename TMoments>
double
Deviation(const TMoments & moments)
{
  return std::sqrt(moments.squares / static_cast<double>(moments.count));
}

void
CheckError(double error)
{
  if (!(error >= 0.0) || !std::isfinite(error))
  {
    itkGenericExceptionMacro("A landmark error is a finite distance, not " << error << '.');
  }
}

constexpr const char * InGroup = " in this tooth group";
constexpr const char * InMillimetres = " in mm (no pixel spacing was given)";
} // namespace

void
LandmarkErrorStatistics::Moments::Add(const Moments & other)
{
  if (other.count == 0)
  {
    return;
  }
  const auto   n = static_cast<double>(count);
  const auto   m = static_cast<double>(other.count);
  const double difference = other.mean - mean;
  count += other.count;
  mean += difference * m / (n + m);
  squares += other.squares + difference * difference * n * m / (n + m);
  maximum = std::max(maximum, other.maximum);
}

const LandmarkErrorStatistics::Moments &
LandmarkErrorStatistics::GetMoments(GroupEnum group) const
{
  return m_Groups[static_cast<std::size_t>(group)];
}

void
LandmarkErrorStatistics::Add(GroupEnum group, double pixels)
{
  CheckError(pixels);
  const Moments one{ 1, pixels, 0.0, pixels };
  m_All.Add(one);
  m_Groups[static_cast<std::size_t>(group)].Add(one);
}

void
LandmarkErrorStatistics::Add(GroupEnum group, double pixels, double millimetres)
{
  CheckError(millimetres);
  this->Add(group, pixels);
  m_Millimetres.Add(Moments{ 1, millimetres, 0.0, millimetres });
  for (std::size_t t = 0; t < SuccessThresholds.size(); ++t)
  {
    m_Successes[t] += millimetres <= SuccessThresholds[t] ? 1 : 0;
  }
}

void
LandmarkErrorStatistics::Add(const LandmarkErrorStatistics & other)
{
  m_All.Add(other.m_All);
  for (std::size_t g = 0; g < m_Groups.size(); ++g)
  {
    m_Groups[g].Add(other.m_Groups[g]);
  }
  m_Millimetres.Add(other.m_Millimetres);
  for (std::size_t t = 0; t < SuccessThresholds.size(); ++t)
  {
    m_Successes[t] += other.m_Successes[t];
  }
}

std::size_t
LandmarkErrorStatistics::GetCount() const
{
  return m_All.count;
}

std::size_t
LandmarkErrorStatistics::GetCount(GroupEnum group) const
{
  return this->GetMoments(group).count;
}

double
LandmarkErrorStatistics::GetMean() const
{
  return NotEmpty(m_All, "").mean;
}

double
LandmarkErrorStatistics::GetMean(GroupEnum group) const
{
  return NotEmpty(this->GetMoments(group), InGroup).mean;
}

double
LandmarkErrorStatistics::GetRMSE() const
{
  return RootMeanSquare(NotEmpty(m_All, ""));
}

double
LandmarkErrorStatistics::GetRMSE(GroupEnum group) const
{
  return RootMeanSquare(NotEmpty(this->GetMoments(group), InGroup));
}

double
LandmarkErrorStatistics::GetStandardDeviation() const
{
  return Deviation(NotEmpty(m_All, ""));
}

double
LandmarkErrorStatistics::GetStandardDeviation(GroupEnum group) const
{
  return Deviation(NotEmpty(this->GetMoments(group), InGroup));
}

double
LandmarkErrorStatistics::GetMaximum() const
{
  return NotEmpty(m_All, "").maximum;
}

double
LandmarkErrorStatistics::GetMaximum(GroupEnum group) const
{
  return NotEmpty(this->GetMoments(group), InGroup).maximum;
}

std::size_t
LandmarkErrorStatistics::GetCountInMillimetres() const
{
  return m_Millimetres.count;
}

double
LandmarkErrorStatistics::GetMeanInMillimetres() const
{
  return NotEmpty(m_Millimetres, InMillimetres).mean;
}

double
LandmarkErrorStatistics::GetRMSEInMillimetres() const
{
  return RootMeanSquare(NotEmpty(m_Millimetres, InMillimetres));
}

double
LandmarkErrorStatistics::GetStandardDeviationInMillimetres() const
{
  return Deviation(NotEmpty(m_Millimetres, InMillimetres));
}

double
LandmarkErrorStatistics::GetSuccessDetectionRate(double thresholdInMillimetres) const
{
  const auto count = static_cast<double>(NotEmpty(m_Millimetres, InMillimetres).count);
  for (std::size_t t = 0; t < SuccessThresholds.size(); ++t)
  {
    if (SuccessThresholds[t] == thresholdInMillimetres)
    {
      return static_cast<double>(m_Successes[t]) / count;
    }
  }
  itkGenericExceptionMacro("The success detection rate is kept at 2, 2.5, 3 and 4 mm, not at " << thresholdInMillimetres
                                                                                               << " mm.");
}

bool
operator==(const LandmarkErrorStatistics & a, const LandmarkErrorStatistics & b)
{
  const auto equal = [](const LandmarkErrorStatistics::Moments & x, const LandmarkErrorStatistics::Moments & y) {
    return std::tie(x.count, x.mean, x.squares, x.maximum) == std::tie(y.count, y.mean, y.squares, y.maximum);
  };
  return equal(a.m_All, b.m_All) && equal(a.m_Millimetres, b.m_Millimetres) && a.m_Successes == b.m_Successes &&
         std::equal(a.m_Groups.begin(), a.m_Groups.end(), b.m_Groups.begin(), equal);
}

std::ostream &
operator<<(std::ostream & os, const LandmarkErrorStatistics & statistics)
{
  using GroupEnum = LandmarkErrorStatistics::GroupEnum;
  os << statistics.GetCount() << " landmarks";
  if (statistics.GetCount() == 0)
  {
    return os;
  }
  os << ", mean " << statistics.GetMean() << " px, RMSE " << statistics.GetRMSE() << " px, std "
     << statistics.GetStandardDeviation() << " px";
  for (const GroupEnum group : { GroupEnum::IncisorsAndCanines, GroupEnum::Premolars, GroupEnum::Molars })
  {
    if (statistics.GetCount(group) > 0)
    {
      os << "; " << group << ' ' << statistics.GetMean(group) << " px";
    }
  }
  return os;
}
} // namespace itk

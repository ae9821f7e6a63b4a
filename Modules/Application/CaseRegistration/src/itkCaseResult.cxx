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
#include "itkCaseResult.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace itk
{
namespace
{
double
SigmaOf(const std::optional<std::array<double, 4>> & covariance)
{
  return covariance ? std::sqrt(0.5 * ((*covariance)[0] + (*covariance)[3])) : 0.0;
}
} // namespace

double
LandmarkPrediction::GetSigma() const
{
  return SigmaOf(covariance);
}

double
LandmarkPrediction::GetMiddleSigma() const
{
  return SigmaOf(middleCovariance);
}

void
JawResult::AddReason(CaseStatusEnum atLeast, const std::string & reason)
{
  status = std::max(status, atLeast);
  if (std::find(reasons.begin(), reasons.end(), reason) == reasons.end())
  {
    reasons.push_back(reason);
  }
}

CaseStatusEnum
CaseResult::GetStatus() const
{
  CaseStatusEnum worst = jaws.empty() ? CaseStatusEnum::Failed : CaseStatusEnum::Ok;
  for (const auto & jaw : jaws)
  {
    worst = std::max(worst, jaw.second.status);
  }
  return worst;
}

const char *
ToString(CaseStatusEnum status)
{
  switch (status)
  {
    case CaseStatusEnum::Ok:
      return "ok";
    case CaseStatusEnum::Suspect:
      return "suspect";
    default:
      return "failed";
  }
}

const char *
ToString(CasePresetEnum preset)
{
  switch (preset)
  {
    case CasePresetEnum::Robust:
      return "robust";
    case CasePresetEnum::Paper:
      return "paper";
    case CasePresetEnum::BoundingBox:
      return "bounding-box";
    default:
      return "single-stage";
  }
}

CasePresetEnum
CasePresetFromString(const std::string & text)
{
  for (const CasePresetEnum preset :
       { CasePresetEnum::Robust, CasePresetEnum::Paper, CasePresetEnum::BoundingBox, CasePresetEnum::SingleStage })
  {
    if (text == ToString(preset))
    {
      return preset;
    }
  }
  throw std::invalid_argument("\"" + text + "\" is no preset (robust, paper, bounding-box or single-stage)");
}

const char *
ToString(ValueSourceEnum source)
{
  switch (source)
  {
    case ValueSourceEnum::Given:
      return "given";
    case ValueSourceEnum::DICOM:
      return "dicom";
    case ValueSourceEnum::Default:
      return "default";
    default:
      return "estimated";
  }
}
} // namespace itk

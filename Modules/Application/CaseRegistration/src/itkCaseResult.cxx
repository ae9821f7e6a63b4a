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

#include "itkCasePresetNames.h"

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
JawResult::AddFinding(const RegistrationFinding & finding)
{
  status = std::max(status, finding.severity);
  const auto isSame = [&](const RegistrationFinding & other) { return other.text == finding.text; };
  if (std::none_of(findings.begin(), findings.end(), isSame))
  {
    findings.push_back(finding);
  }
}

void
JawResult::AddFinding(RegistrationStatusEnum severity, const std::string & code, const std::string & text)
{
  this->AddFinding({ severity, code, text, std::nullopt, std::nullopt, "" });
}

void
JawResult::RaiseFinding(const std::string & code, RegistrationStatusEnum severity)
{
  for (RegistrationFinding & finding : findings)
  {
    if (finding.code == code)
    {
      finding.severity = std::max(finding.severity, severity);
      status = std::max(status, finding.severity);
    }
  }
}

void
JawResult::RemoveFinding(const std::string & code)
{
  findings.erase(std::remove_if(findings.begin(),
                                findings.end(),
                                [&](const RegistrationFinding & finding) { return finding.code == code; }),
                 findings.end());
  status = RegistrationStatusEnum::Ok;
  for (const RegistrationFinding & finding : findings)
  {
    status = std::max(status, finding.severity);
  }
}

bool
JawResult::HasFinding(const std::string & code) const
{
  return std::any_of(findings.begin(), findings.end(), [&](const auto & finding) { return finding.code == code; });
}

const ContourFigures *
JawResult::FindMetrics(const std::string & name) const
{
  for (const auto & metric : metrics)
  {
    if (metric.first == name)
    {
      return &metric.second;
    }
  }
  return nullptr;
}

std::vector<std::string>
JawResult::GetReasons() const
{
  std::vector<std::string> reasons;
  for (const RegistrationFinding & finding : findings)
  {
    reasons.push_back(finding.text);
  }
  return reasons;
}

RegistrationStatusEnum
CaseResult::GetStatus() const
{
  RegistrationStatusEnum worst = jaws.empty() ? RegistrationStatusEnum::Failed : RegistrationStatusEnum::Ok;
  for (const auto & jaw : jaws)
  {
    worst = std::max(worst, jaw.second.status);
  }
  return worst;
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

namespace
{
const CasePresetEnum AllPresets[] = {
  CasePresetEnum::Robust, CasePresetEnum::Paper, CasePresetEnum::BoundingBox, CasePresetEnum::SingleStage
};
} // namespace

const std::vector<std::string> &
GetCasePresetNames()
{
  static const std::vector<std::string> names = []() {
    std::vector<std::string> list;
    for (const CasePresetEnum preset : AllPresets)
    {
      list.emplace_back(ToString(preset));
    }
    return list;
  }();
  return names;
}

CasePresetEnum
CasePresetFromString(const std::string & text)
{
  std::string list;
  for (const CasePresetEnum preset : AllPresets)
  {
    if (text == ToString(preset))
    {
      return preset;
    }
    list += std::string(list.empty() ? "" : ", ") + ToString(preset);
  }
  throw std::invalid_argument("\"" + text + "\" is no preset; use one of " + list);
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

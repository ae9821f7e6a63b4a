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
#include "itkPoseRegistrationOptionTable.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>
#include <stdexcept>

namespace itk
{
namespace
{
using Options = PoseRegistrationOptions;
using FieldType = PoseRegistrationOptionTable::FieldType;

struct Row
{
  const char * name;
  const char * description;
  FieldType    field;
  double       low{ 0.0 };
  double       high{ 0.0 };
};

const std::vector<Row> &
Rows()
{
  constexpr double              Tiny = 1e-3;
  constexpr double              Large = 1e4;
  static const std::vector<Row> rows = {
    { "useSideSelection", "cut the scan at the midline plane", &Options::useSideSelection },
    { "midlineMargin", "how far beyond the midline plane the cut lies, mm", &Options::midlineMargin, -20.0, 20.0 },
    { "useFacingFilter", "keep the occlusal and anterior part of the outline alone", &Options::useFacingFilter },
    { "useOrientation", "match normals beside positions", &Options::useOrientation },
    { "orientationWeight", "weight of a unit normal, px", &Options::orientationWeight, 0.0, Large },
    { "gateByTooth", "match a tooth's points with it or its neighbours alone", &Options::gateByTooth },
    { "toothRange", "how many positions away a neighbour may be", &Options::toothRange, 0.0, 8.0 },
    { "reverseWeight", "weight of the direction from outline to tracing; 0: off", &Options::reverseWeight, 0.0, 100.0 },
    { "taperLength", "over which it fades in from the tracing's ends, px", &Options::taperLength, 0.0, Large },
    { "gapLength", "gaps of the tracing shorter than this have no ends, px", &Options::gapLength, 0.0, Large },
    { "useCorrelatedNoise", "noise correlated along the tracing", &Options::useCorrelatedNoise },
    { "correlationLength", "its correlation length, px", &Options::correlationLength, Tiny, Large },
    { "covarianceCorrelationLength",
      "correlation length for the covariance, px",
      &Options::covarianceCorrelationLength,
      Tiny,
      Large },
    { "covarianceInflation", "factor on the standard deviations", &Options::covarianceInflation, Tiny, Large },
    { "absorbedNoise",
      "noise that the nearest point absorbs, for the covariance; 0: none",
      &Options::absorbedNoise,
      0.0,
      10.0 },
    { "estimateNoise", "estimate the two noise levels", &Options::estimateNoise },
    { "initialSmoothSigma", "correlated noise at the start, px", &Options::initialSmoothSigma, Tiny, Large },
    { "initialWhiteSigma", "independent noise at the start, px", &Options::initialWhiteSigma, Tiny, Large },
    { "useRobustKernel", "Geman-McClure instead of least squares", &Options::useRobustKernel },
    { "useFullPose", "six degrees of freedom and scale instead of a similarity", &Options::useFullPose },
    { "useJointPose", "one pose for jaws in occlusion", &Options::useJointPose },
    { "yawStarts", "yaw of the global starts, rad", &Options::yawStarts, -0.8, 0.8 },
    { "startsPerYaw", "candidates kept a yaw", &Options::startsPerYaw, 1.0, 100.0 },
    { "codeWeight", "weight of the tooth codes' places; 0: off", &Options::codeWeight, 0.0, Large },
    { "codeSigma", "sd of the codes' places in the last choice, mm", &Options::codeSigma, 0.01, Large },
    { "regenerateOutline", "make the outline anew as the pose moves", &Options::regenerateOutline },
    { "maximumEvaluations", "evaluations of the refinement", &Options::maximumEvaluations, 1.0, 1000.0 },
    { "rollSigma", "prior, rad; 0: fixed", &Options::rollSigma, 0.0, Large },
    { "yawSigma", "prior, rad; 0: fixed", &Options::yawSigma, 0.0, Large },
    { "rotationPriorFreedom",
      "degrees of freedom of roll's and yaw's t prior; up to 2: Gaussian",
      &Options::rotationPriorFreedom,
      0.0,
      Large },
    { "tySigma", "prior of the lateral shift, mm; 0: fixed", &Options::tySigma, 0.0, Large },
    { "kappaSigma", "prior of the log scale; 0: fixed", &Options::kappaSigma, 0.0, Large },
    { "kappaSigmaWithoutSpacing",
      "the same where the pixel spacing is unknown",
      &Options::kappaSigmaWithoutSpacing,
      0.0,
      Large },
    { "unobservedRotationSigma",
      "of rotations that are not estimated, in the covariance, rad",
      &Options::unobservedRotationSigma,
      0.0,
      Large },
    { "heldPitchSigma", "of a held pitch, in the covariance, rad", &Options::heldPitchSigma, 0.0, 3.2 },
    { "heldTranslationSigma", "of a held shift, in the covariance, mm", &Options::heldTranslationSigma, 0.0, Large },
    { "checkHypotheses", "try the other side, exchanged jaws, the other facing", &Options::checkHypotheses },
    { "poorScore", "score above which the latter two are tried", &Options::poorScore, 0.0, 10.0 },
    { "maximumTracingPoints",
      "points a jaw above which a tracing is thinned",
      &Options::maximumTracingPoints,
      10.0,
      5000.0 },
    { "startKernelWidths", "kernel widths of the starts' refinement, px", &Options::startKernelWidths, Tiny, Large },
    { "startEvaluations", "evaluations of a start", &Options::startEvaluations, 1.0, 1000.0 },
    { "startTolerance", "step below which a start ends, px", &Options::startTolerance, 0.0, Large },
    { "startDistance", "starts nearer than this are the same, px", &Options::startDistance, 0.0, Large },
    { "coarseKernelWidths",
      "kernel widths of the candidates' refinement, px",
      &Options::coarseKernelWidths,
      Tiny,
      Large },
    { "coarseEvaluations", "evaluations of a candidate before the choice", &Options::coarseEvaluations, 1.0, 1000.0 },
    { "coarseTolerance", "step below which a candidate ends, px", &Options::coarseTolerance, 0.0, Large },
    { "maximumPlaces", "places whose best candidate goes on", &Options::maximumPlaces, 1.0, 100.0 },
    { "placeDistance", "candidates further apart lie in different places, px", &Options::placeDistance, 0.0, Large },
    { "secondWayDistance",
      "how far a second candidate of the best place must lie, px",
      &Options::secondWayDistance,
      0.0,
      Large },
    { "scoreMargin", "candidates further behind the best do not go on", &Options::scoreMargin, 0.0, Large },
    { "fineKernelWidth", "kernel width before the noise is known, px", &Options::fineKernelWidth, Tiny, Large },
    { "adaptiveKernelFactor",
      "kernel width in standard deviations of the noise",
      &Options::adaptiveKernelFactor,
      Tiny,
      Large },
    { "fineTolerance", "step below which the refinement ends, px", &Options::fineTolerance, 0.0, Large },
    { "modelSigma", "error of the outline itself, for the covariance, px", &Options::modelSigma, 0.0, Large },
    { "absorbedNoiseLimit",
      "the most that absorbedNoise multiplies levels by",
      &Options::absorbedNoiseLimit,
      1.0,
      10.0 },
  };
  return rows;
}

const Row &
Find(const std::string & name)
{
  const auto found = std::find_if(Rows().begin(), Rows().end(), [&](const Row & row) { return name == row.name; });
  if (found != Rows().end())
  {
    return *found;
  }
  std::string known;
  for (const Row & row : Rows())
  {
    known += (known.empty() ? "" : ", ") + std::string(row.name);
  }
  throw std::invalid_argument("there is no option \"" + name + "\"; there are " + known);
}

[[noreturn]] void
FailToParse(const std::string & name, const std::string & value, const std::string & expected)
{
  throw std::invalid_argument("option " + name + " can't be \"" + value + "\": " + expected);
}

double
ParseNumber(const Row & row, const std::string & value)
{
  std::istringstream text(value);
  text.imbue(std::locale::classic());
  double number = 0.0;
  if (!(text >> number) || !(text >> std::ws).eof() || !std::isfinite(number) || number < row.low || number > row.high)
  {
    std::ostringstream expected;
    expected.imbue(std::locale::classic());
    expected << "a number from " << row.low << " to " << row.high << " is expected";
    FailToParse(row.name, value, expected.str());
  }
  return number;
}

std::string
Print(double number)
{
  // The shortest text that reads back the same.
  for (int digits = 6; digits <= 17; ++digits)
  {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(digits);
    text << number;
    std::istringstream back(text.str());
    back.imbue(std::locale::classic());
    double read = 0.0;
    if ((back >> read && read == number) || digits == 17)
    {
      return text.str();
    }
  }
  return {};
}
} // namespace

auto
PoseRegistrationOptionTable::GetEntries() -> std::vector<EntryType>
{
  std::vector<EntryType> entries;
  for (const Row & row : Rows())
  {
    entries.push_back({ row.name, row.description, row.field });
  }
  return entries;
}

std::string
PoseRegistrationOptionTable::Get(const PoseRegistrationOptions & options, const std::string & name)
{
  return std::visit(
    [&](auto field) -> std::string {
      const auto & value = options.*field;
      using ValueType = std::decay_t<decltype(value)>;
      if constexpr (std::is_same_v<ValueType, bool>)
      {
        return value ? "on" : "off";
      }
      else if constexpr (std::is_same_v<ValueType, std::vector<double>>)
      {
        std::string text;
        for (const double number : value)
        {
          text += (text.empty() ? "" : ",") + Print(number);
        }
        return text;
      }
      else
      {
        return Print(static_cast<double>(value));
      }
    },
    Find(name).field);
}

bool
PoseRegistrationOptionTable::ParseSwitch(const std::string & name, const std::string & value)
{
  const bool on = value == "on" || value == "true" || value == "1";
  if (!on && value != "off" && value != "false" && value != "0")
  {
    FailToParse(name, value, "on or off is expected");
  }
  return on;
}

void
PoseRegistrationOptionTable::Set(PoseRegistrationOptions & options, const std::string & name, const std::string & value)
{
  const Row & row = Find(name);
  std::visit(
    [&](auto field) {
      auto & target = options.*field;
      using ValueType = std::decay_t<decltype(target)>;
      if constexpr (std::is_same_v<ValueType, bool>)
      {
        target = ParseSwitch(row.name, value);
      }
      else if constexpr (std::is_same_v<ValueType, std::vector<double>>)
      {
        std::vector<double> numbers;
        std::istringstream  text(value);
        std::string         part;
        while (std::getline(text, part, ','))
        {
          numbers.push_back(ParseNumber(row, part));
        }
        if (numbers.empty() || numbers.size() > 100)
        {
          FailToParse(row.name, value, "1 to 100 numbers, separated by commas, are expected");
        }
        target = numbers;
      }
      else if constexpr (std::is_same_v<ValueType, unsigned int>)
      {
        const double number = ParseNumber(row, value);
        if (number != std::floor(number))
        {
          FailToParse(row.name, value, "a whole number is expected");
        }
        target = static_cast<unsigned int>(number);
      }
      else
      {
        target = ParseNumber(row, value);
      }
    },
    row.field);
}

void
PoseRegistrationOptionTable::Set(PoseRegistrationOptions & options, const std::string & assignment)
{
  const std::size_t sign = assignment.find('=');
  if (sign == std::string::npos)
  {
    throw std::invalid_argument("\"" + assignment + "\" sets nothing: NAME=VALUE is expected");
  }
  Set(options, assignment.substr(0, sign), assignment.substr(sign + 1));
}

std::vector<std::string>
PoseRegistrationOptionTable::GetChanges(const PoseRegistrationOptions & options)
{
  std::vector<std::string>      changes;
  const PoseRegistrationOptions defaults;
  for (const Row & row : Rows())
  {
    const std::string value = Get(options, row.name);
    if (value != Get(defaults, row.name))
    {
      changes.push_back(std::string(row.name) + '=' + value);
    }
  }
  return changes;
}
} // namespace itk

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
#include "itkExperimentMethod.h"

#include "itkCoherentPointDriftContourRegistrationMethod.h"
#include "itkContourChamferMetricv4.h"
#include "itkIntensityRegistrationMethod.h"
#include "itkIterativeClosestPointContourRegistrationMethod.h"
#include "itkSilhouetteToContourRegistrationMethod.h"

#include <algorithm>
#include <stdexcept>

// The methods that experiments compare, as a table: what sets one apart from another stands in its row, and another
// method is another row.
namespace itk
{
namespace
{
using KindEnum = ExperimentMethod::KindEnum;
using ChainEnum = ExperimentMethod::ChainEnum;
using PresetEnum = CasePresetEnum;
using MeasureEnum = IntensityRegistrationMethod::MeasureEnum;
using RegistrationPointer = ContourRegistrationMethodBase::Pointer;

ContourBaselineEnums::Motion
MotionOf(const ExperimentMethod & method)
{
  return method.keepsScale ? ContourBaselineEnums::Motion::Rigid : ContourBaselineEnums::Motion::Similarity;
}

SilhouetteToContourRegistrationMethod::Pointer
MakeOurs(const ExperimentMethod & method, double pixelSpacing)
{
  auto registration = SilhouetteToContourRegistrationMethod::New();
  registration->SetPixelSpacing(pixelSpacing);
  if (method.preset == PresetEnum::BoundingBox)
  {
    registration->SetPresetToBoundingBox();
  }
  else if (method.preset == PresetEnum::SingleStage)
  {
    registration->SetPresetToSingleStage();
  }
  return registration;
}

RegistrationPointer
Levels(const ExperimentMethod & method, double pixelSpacing)
{
  return MakeOurs(method, pixelSpacing).GetPointer();
}

RegistrationPointer
OneSided(const ExperimentMethod & method, double pixelSpacing)
{
  auto registration = MakeOurs(method, pixelSpacing);
  auto metric = ContourChamferMetricv4::New();
  metric->SetDirection(ContourChamferMetricv4::DirectionEnum::FixedToMoving);
  registration->SetMetric(metric);
  return registration.GetPointer();
}

RegistrationPointer
ClosestPoints(const ExperimentMethod & method, double)
{
  auto registration = IterativeClosestPointContourRegistrationMethod::New();
  registration->SetMotion(MotionOf(method));
  registration->SetTrimmedFraction(method.outliers);
  return registration.GetPointer();
}

RegistrationPointer
PointDrift(const ExperimentMethod & method, double)
{
  auto registration = CoherentPointDriftContourRegistrationMethod::New();
  registration->SetMotion(MotionOf(method));
  registration->SetOutlierWeight(method.outliers);
  return registration.GetPointer();
}

template <MeasureEnum VMeasure>
RegistrationPointer
Intensities(const ExperimentMethod &, double)
{
  auto registration = IntensityRegistrationMethod::New();
  registration->SetMeasure(VMeasure);
  return registration.GetPointer();
}
} // namespace

const std::vector<ExperimentMethod> &
GetExperimentMethods()
{
  constexpr auto contour = KindEnum::Contour;
  constexpr auto intensity = KindEnum::Intensity;
  constexpr auto chain = ChainEnum::Paper;
  constexpr auto paper = PresetEnum::Paper;
  // name, title, kind, chain, registration; preset of ours, keeps the scale, share of outliers
  // clang-format off
  static const std::vector<ExperimentMethod> methods = {
    { "bounding-box", "Bounding box", contour, chain, Levels, PresetEnum::BoundingBox },
    { "single-stage", "Single stage", contour, chain, Levels, PresetEnum::SingleStage },
    { "paper", "DentalSCR as in the paper", contour, chain, Levels, paper },
    { "robust", "DentalSCR robust", KindEnum::Pose, chain, nullptr, PresetEnum::Robust },
    { "icp-rigid", "ICP, rigid", contour, chain, ClosestPoints, paper, true, 0.0 },
    { "icp", "ICP, similarity", contour, chain, ClosestPoints, paper, false, 0.0 },
    { "icp-trimmed-rigid", "ICP, trimmed, rigid", contour, chain, ClosestPoints, paper, true, 0.3 },
    { "icp-trimmed", "ICP, trimmed, similarity", contour, chain, ClosestPoints, paper, false, 0.3 },
    { "cpd-rigid", "CPD, rigid", contour, chain, PointDrift, paper, true, 0.0 },
    { "cpd", "CPD, similarity", contour, chain, PointDrift, paper, false, 0.0 },
    { "cpd-robust-rigid", "CPD, robust, rigid", contour, chain, PointDrift, paper, true, 0.3 },
    { "cpd-robust", "CPD, robust, similarity", contour, chain, PointDrift, paper, false, 0.3 },
    { "mutual-information", "Mutual information", intensity, chain, Intensities<MeasureEnum::MutualInformation> },
    { "normalized-correlation", "Normalised correlation", intensity, chain, Intensities<MeasureEnum::NormalizedCorrelation> },
    { "gradient-correlation", "Gradient correlation", intensity, chain, Intensities<MeasureEnum::GradientCorrelation> },
    { "no-umda", "w/o UMDA", contour, ChainEnum::FileAxes, Levels, paper },
    { "one-sided", "w/o Bi-Chamfer", contour, chain, OneSided, paper },
    { "parallel", "w/o perspective", contour, ChainEnum::ParallelProjection, Levels, paper },
  };
  // clang-format on
  return methods;
}

const ExperimentMethod *
FindExperimentMethod(const std::string & name)
{
  for (const ExperimentMethod & method : GetExperimentMethods())
  {
    if (method.name == name)
    {
      return &method;
    }
  }
  return nullptr;
}

std::vector<ExperimentMethod>
SelectExperimentMethods(const std::vector<std::string> & names)
{
  // The paper's ablation has a name of its own for it.
  const auto resolve = [](const std::string & name) {
    return name == "no-coarse-to-fine" ? std::string("single-stage") : name;
  };
  for (const std::string & name : names)
  {
    if (name != "all" && name != "default" && name != "intensity" && FindExperimentMethod(resolve(name)) == nullptr)
    {
      std::string known;
      for (const ExperimentMethod & method : GetExperimentMethods())
      {
        known += method.name + ", ";
      }
      throw std::invalid_argument("there is no method \"" + name + "\"; there are " + known +
                                  "no-coarse-to-fine (which is single-stage), and the groups default, intensity, all");
    }
  }
  std::vector<ExperimentMethod> selected;
  for (const ExperimentMethod & method : GetExperimentMethods())
  {
    const bool chosen = std::any_of(names.begin(), names.end(), [&](const std::string & name) {
      return resolve(name) == method.name || name == "all" ||
             name == (method.kind == KindEnum::Intensity ? "intensity" : "default");
    });
    if (chosen)
    {
      selected.push_back(method);
    }
  }
  return selected;
}
} // namespace itk

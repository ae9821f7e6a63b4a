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
#include "itkExperimentFigures.h"
#include "itkExperimentRecordPlan.h"
#include "itkExperimentTable.h"

#include "itkCorrelatedNoiseModel.h"
#include "itkPoseRegistrationMethodBase.h"
#include "itkSquaresKernel.h"

#include <cmath>
#include <sstream>

namespace itk
{
namespace
{
using CohortEnum = DentalPhantomCaseSource::CohortEnum;
constexpr CohortEnum AblationLevels[] = { CohortEnum::Typical, CohortEnum::Hard };

/** Preset robust, what remains of it when one ingredient is taken away, and what two more would bring: an object of the
 * method is exchanged where the ingredient is one, an option is set where it is a number or a way to go. */
std::vector<ExperimentMethod>
MakeVariants()
{
  std::vector<ExperimentMethod> variants;
  const auto add = [&](const char * name, const char * title, const std::vector<std::string> & options) {
    ExperimentMethod variant;
    variant.name = name;
    variant.title = title;
    variant.kind = ExperimentMethod::KindEnum::Pose;
    variant.options = options;
    variants.push_back(variant);
  };
  add("robust", "robust, all of it", {});
  const auto exchange = [&](const char *                                 name,
                            const char *                                 title,
                            const char *                                 exchanged,
                            const decltype(ExperimentMethod::exchange) & by) {
    add(name, title, {});
    variants.back().exchanged = exchanged;
    variants.back().exchange = by;
  };
  add("no-midline-refinement", "midline plane of the UMDA alone", { "refineMidline=off" });
  add("no-side-selection", "outline of the whole scan", { "useSideSelection=off" });
  add("no-facing-filter", "whole outline of the side, not the occlusal part", { "useFacingFilter=off" });
  add("no-orientation", "positions without normals", { "useOrientation=off" });
  exchange("independent-noise",
           "noise independent from point to point",
           "SetNoiseModel(), SetCovarianceNoiseModel(): CorrelatedNoiseModel of length 0",
           [](PoseRegistrationMethodBase & method) {
             auto independent = CorrelatedNoiseModel::New();
             independent->SetCorrelationLength(0.0);
             method.SetNoiseModel(independent);
             method.SetCovarianceNoiseModel(independent);
           });
  add("fixed-noise", "noise levels not estimated", { "estimateNoise=off" });
  exchange("least-squares",
           "no robust kernel",
           "SetRobustKernel(): SquaresKernel",
           [](PoseRegistrationMethodBase & method) { method.SetRobustKernel(SquaresKernel::New()); });
  add("similarity", "similarity instead of six degrees of freedom", { "useFullPose=off" });
  add("own-pose", "a pose for each jaw", { "useJointPose=off" });
  add("one-yaw-start", "global start from yaw 0 alone", { "yawStarts=0" });
  add("one-start", "one candidate a yaw", { "startsPerYaw=1" });
  add("no-codes", "tooth codes' places not used", { "codeWeight=0" });
  add("fixed-outline", "outline of the start kept", { "regenerateOutline=off" });
  add("gaussian-priors", "Gaussian priors of roll and yaw", { "rotationPriorFreedom=0" });
  add("no-priors", "priors 20 times as wide", { "rollSigma=1.4", "yawSigma=1.4", "tySigma=40", "kappaSigma=0.32" });
  // Two ingredients that preset robust does without.
  add("tooth-gate", "a tooth's points matched with it or its neighbours alone", { "gateByTooth=on" });
  add("both-directions", "from outline to tracing as well", { "reverseWeight=1" });
  return variants;
}

class AblationPlan : public ExperimentRecordPlan
{
public:
  using ExperimentRecordPlan::ExperimentRecordPlan;

  void
  FillRecord(std::size_t, ExperimentRecord & record, const ExperimentMonitor & monitor) const override
  {
    std::size_t done = 0;
    for (const CohortEnum level : AblationLevels)
    {
      const ExperimentCase experimentCase =
        MakePhantomExperimentCase(record.seed, level, false, {}, monitor.GetAbort());
      for (const ExperimentMethod & variant : this->GetMethods())
      {
        monitor.Advance(static_cast<double>(done++) / static_cast<double>(2 * this->GetMethods().size()));
        ExperimentRunner runner(experimentCase);
        runner.SetAbort(monitor.GetAbort());
        record.Add(KeyOf(variant, level), runner.Run(variant));
      }
    }
  }

  std::map<std::string, std::string>
  MakeFiles() const override
  {
    ExperimentTable csv({ "level",
                          "variant",
                          "options",
                          "jaw",
                          "cases",
                          "not_registered",
                          "mean_px",
                          "worst_case_px",
                          "above_2mm",
                          "verdict_failed" });
    ExperimentTable markdown({ "Without",
                               "typical, upper",
                               "typical, lower",
                               "hard, upper",
                               "hard, lower",
                               "jaws above 2 mm",
                               "not registered" });
    for (const ExperimentMethod & variant : this->GetMethods())
    {
      std::vector<std::string> cells = { variant.title };
      std::size_t              above = 0;
      std::size_t              lost = 0;
      for (const CohortEnum level : AblationLevels)
      {
        for (const char * jaw : { "upper", "lower" })
        {
          const ExperimentFigures f = PoolExperiment(this->GetRecords(), KeyOf(variant, level), jaw);
          std::string             options = variant.exchanged;
          for (const std::string & option : variant.options)
          {
            options += (options.empty() ? "" : " ") + option;
          }
          csv.AddRow({ NameOf(level),
                       variant.name,
                       options,
                       jaw,
                       std::to_string(f.cases),
                       std::to_string(f.notRegistered),
                       ExperimentTable::Number(f.mean, 6),
                       ExperimentTable::Number(f.worstCase, 6),
                       std::to_string(f.above2mm),
                       std::to_string(f.failed) });
          cells.push_back(ExperimentTable::Number(f.mean, 2) + " / " + ExperimentTable::Number(f.worstCase, 2));
          above += f.above2mm;
          lost += f.notRegistered;
        }
      }
      cells.push_back(std::to_string(above));
      cells.push_back(std::to_string(lost));
      markdown.AddRow(cells);
    }
    std::ostringstream text;
    text << "# Ablation of preset robust\n\n"
         << this->GetCohort().Describe()
         << ", each at the levels typical and hard. One ingredient at a time is taken away (in ablation.csv the part "
            "that is exchanged, or the options of `dentalscr register --option`). Landmark error in px: mean over the "
            "landmarks / worst case (mean over "
            "one jaw).\n"
         << DescribeFailures(this->GetRecords()) << '\n'
         << markdown.ToMarkdown();
    return { { "ablation.csv", csv.ToCSV() }, { "ablation.md", text.str() } };
  }

private:
  static std::string
  KeyOf(const ExperimentMethod & variant, CohortEnum level)
  {
    return variant.name + '@' + NameOf(level);
  }
};
} // namespace

std::unique_ptr<ExperimentPlan>
MakeAblationPlan(const ExperimentCohort & cohort)
{
  return std::make_unique<AblationPlan>(cohort, MakeVariants());
}
} // namespace itk

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
#include "itkExperimentRecordPlan.h"
#include "itkExperimentTable.h"
#include "itkLandmarkErrorFilter.h"
#include "itkLandmarkProjectionFilter.h"
#include "itkPoseRegistrationMethodBase.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace itk
{
namespace
{
using JawEnum = ToothCode::JawEnum;
using CohortEnum = DentalPhantomCaseSource::CohortEnum;

constexpr const char * PracticeMethod = "robust";
/** Radius of the 95 % region in sigmas. */
constexpr double RadiusOf95 = 2.448;
/** Mean errors of a jaw, pixels: up to the first the verdict should be ok, beyond the second it must not. */
constexpr double Usable = 4.0;
constexpr double Unusable = 8.0;

/** What a clinic has of a case. */
struct InputType
{
  const char * name;
  bool         outlines;
  bool         landmarks;
  bool         scanLandmarks;
  /** Two registrations a case. */
  bool oneJawAtATime;
  /** Mean and largest jaw of a plain least-squares fit with known correspondences and the noise of readers, px of 0.25
   * mm (288 jaws of the level "standard"); empty where nobody has fitted one. */
  const char * bound;
};
constexpr InputType Inputs[] = {
  { "landmarks", false, true, true, false, "1.83 / 4.2" },
  { "landmarks, scan without landmarks_3d", false, true, false, false, "" },
  { "one jaw by its two landmarks", false, true, true, true, "2.4 to 2.5" },
  { "outlines of whole teeth", true, false, true, false, "1.94 / 4.4" },
  { "outlines and landmarks", true, true, true, false, "1.38 / 3.1" },
};

constexpr CohortEnum PracticeLevels[] = { CohortEnum::Standard, CohortEnum::Practice };

/** The key of its results in a record. */
std::string
NameOfCohort(CohortEnum level, const InputType & input)
{
  return std::string(NameOf(level)) + ": " + input.name;
}

/** The errors of the middles of both sides, which is all that such drawings determine, with the sigma of each: by the
 * solution, which places the scans' landmarks whether or not the case was given them. */
std::vector<ExperimentRecord::LandmarkType>
MeasureMiddles(const PoseSolution * solution, JawEnum jaw, const ExperimentCase & experimentCase)
{
  auto projection = LandmarkProjectionFilter::New();
  projection->SetSolution(solution);
  projection->SetLandmarks(experimentCase.data->landmarks3D);
  projection->SetMillimetresPerUnit(experimentCase.data->description.millimetresPerUnit);
  auto errors = LandmarkErrorFilter::New();
  errors->SetPredictedLandmarks(projection->GetOutput());
  errors->SetReferenceLandmarks(experimentCase.marked);
  errors->SetJaw(jaw);
  errors->BisectSidesOn();
  errors->Update();
  const auto &                                spacing = solution->GetResult().geometry.pixelSpacing;
  std::vector<ExperimentRecord::LandmarkType> middles;
  for (const auto & error : errors->GetErrors())
  {
    // "UR1_tip+UL1_tip"; what has no other side is no middle.
    const std::string right = error.name.substr(0, error.name.find('+'));
    if (right == error.name || !projection->HasMiddleCovariance(right))
    {
      continue;
    }
    ExperimentRecord::LandmarkType middle;
    middle.name = error.name;
    middle.group = DentalLandmarkSet<2>::ParseName(right).GetGroup();
    middle.pixels = error.distance;
    middle.millimetres = error.distance * 0.5 * (spacing[0] + spacing[1]);
    const auto covariance = projection->GetMiddleCovariance(right);
    middle.sigma = std::sqrt(0.5 * (covariance(0, 0) + covariance(1, 1)));
    middles.push_back(middle);
  }
  return middles;
}

/** What a table tells of the jaws of one kind of input. */
struct PracticeFigures
{
  std::size_t jaws{ 0 };
  std::size_t registered{ 0 };
  std::size_t usable{ 0 };
  std::size_t usableAndOk{ 0 };
  std::size_t unusable{ 0 };
  std::size_t unusableAndOk{ 0 };
  std::size_t covered{ 0 };
  double      sum{ 0.0 };
  double      worst{ 0.0 };
  /** Error over the radius of the 95 % circle, a middle each. */
  std::vector<double> ratios;
  /** Of jaws with usable and with unusable results. */
  std::vector<double> sigmasOfUsable;
  std::vector<double> sigmasOfUnusable;

  void
  Add(const ExperimentRecord & record, const std::string & cohort)
  {
    for (const char * name : { "upper", "lower" })
    {
      const auto * jaw = record.Find(cohort, name);
      if (jaw == nullptr)
      {
        continue;
      }
      ++jaws;
      const auto mean = jaw->GetMean(false);
      if (!mean)
      {
        continue;
      }
      const bool ok = jaw->status == "ok";
      ++registered;
      sum += *mean;
      worst = std::max(worst, *mean);
      usable += *mean <= Usable ? 1 : 0;
      usableAndOk += *mean <= Usable && ok ? 1 : 0;
      unusable += *mean > Unusable ? 1 : 0;
      unusableAndOk += *mean > Unusable && ok ? 1 : 0;
      if (jaw->middleSigma && *mean <= Usable)
      {
        sigmasOfUsable.push_back(*jaw->middleSigma);
      }
      if (jaw->middleSigma && *mean > Unusable)
      {
        sigmasOfUnusable.push_back(*jaw->middleSigma);
      }
      for (const auto & middle : jaw->landmarks)
      {
        if (middle.sigma && *middle.sigma > 0.0)
        {
          ratios.push_back(middle.pixels / (RadiusOf95 * *middle.sigma));
          covered += ratios.back() <= 1.0 ? 1 : 0;
        }
      }
    }
  }

  double
  GetMean() const
  {
    return registered > 0 ? sum / static_cast<double>(registered) : std::nan("");
  }
  double
  GetWorst() const
  {
    return registered > 0 ? worst : std::nan("");
  }
  double
  GetCoverage() const
  {
    return ratios.empty() ? std::nan("") : static_cast<double>(covered) / static_cast<double>(ratios.size());
  }
};

/** The smallest value that a share of them does not exceed; not a number where there is none. */
double
RankedQuantile(std::vector<double> values, double share)
{
  if (values.empty())
  {
    return std::nan("");
  }
  std::sort(values.begin(), values.end());
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  return values[std::max<std::size_t>(rank, 1) - 1];
}

std::string
CountOf(std::size_t part, std::size_t all)
{
  return std::to_string(part) + " of " + std::to_string(all);
}

std::string
Percent(double share)
{
  return std::isfinite(share) ? ExperimentTable::Number(100.0 * share, 1) + " %" : std::string();
}

class PracticePlan : public ExperimentRecordPlan
{
public:
  using ExperimentRecordPlan::ExperimentRecordPlan;

  void
  FillRecord(std::size_t, ExperimentRecord & record, const ExperimentMonitor & monitor) const override
  {
    double part = 0.0;
    for (const CohortEnum level : PracticeLevels)
    {
      const ExperimentCase full = MakePhantomExperimentCase(record.seed, level, false, {}, monitor.GetAbort());
      for (const InputType & input : Inputs)
      {
        monitor.Advance(part);
        this->Run(full, NameOfCohort(level, input), input, record, monitor);
        part += 1.0 / static_cast<double>(std::size(PracticeLevels) * std::size(Inputs));
      }
    }
  }

  std::map<std::string, std::string>
  MakeFiles() const override
  {
    // The half that limits and sigmas may be set on, and the one that is reported: what is chosen on cases fits them.
    const std::size_t calibrating = this->GetRecords().size() / 2;
    ExperimentTable   report({ "Input",
                               "jaws",
                               "not registered",
                               "mean / worst px",
                               "bound",
                               "ok of those within 4 px",
                               "ok of those beyond 8 px",
                               "middles in their 95 % circle" });
    ExperimentTable   csv({ "level",
                            "input",
                            "part",
                            "jaws",
                            "registered",
                            "mean_px",
                            "worst_px",
                            "within_4_px",
                            "within_4_px_ok",
                            "beyond_8_px",
                            "beyond_8_px_ok",
                            "middles",
                            "coverage_95" });
    ExperimentTable   calibration({ "Input",
                                    "middles in their 95 % circle",
                                    "factor on sigma for 95 %",
                                    "predicted sigma that 90 % of the jaws within 4 px do not exceed",
                                    "smallest predicted sigma beyond 8 px" });
    for (const CohortEnum level : PracticeLevels)
    {
      for (const InputType & input : Inputs)
      {
        const std::string cohort = NameOfCohort(level, input);
        PracticeFigures   parts[2];
        for (std::size_t i = 0; i < this->GetRecords().size(); ++i)
        {
          parts[i < calibrating ? 0 : 1].Add(this->GetRecords()[i], cohort);
        }
        for (const PracticeFigures & f : parts)
        {
          csv.AddRow({ NameOf(level),
                       input.name,
                       &f == parts ? "calibration" : "report",
                       std::to_string(f.jaws),
                       std::to_string(f.registered),
                       ExperimentTable::Number(f.GetMean(), 6),
                       ExperimentTable::Number(f.GetWorst(), 6),
                       std::to_string(f.usable),
                       std::to_string(f.usableAndOk),
                       std::to_string(f.unusable),
                       std::to_string(f.unusableAndOk),
                       std::to_string(f.ratios.size()),
                       ExperimentTable::Number(f.GetCoverage(), 6) });
        }
        const PracticeFigures & f = parts[1];
        report.AddRow({ cohort,
                        std::to_string(f.jaws),
                        std::to_string(f.jaws - f.registered),
                        f.registered == 0
                          ? std::string()
                          : ExperimentTable::Number(f.GetMean(), 2) + " / " + ExperimentTable::Number(f.GetWorst(), 1),
                        level == CohortEnum::Standard ? input.bound : "",
                        CountOf(f.usableAndOk, f.usable),
                        CountOf(f.unusableAndOk, f.unusable),
                        Percent(f.GetCoverage()) });
        calibration.AddRow({ cohort,
                             Percent(parts[0].GetCoverage()),
                             ExperimentTable::Number(RankedQuantile(parts[0].ratios, 0.95), 2),
                             ExperimentTable::Number(RankedQuantile(parts[0].sigmasOfUsable, 0.9), 2),
                             ExperimentTable::Number(RankedQuantile(parts[0].sigmasOfUnusable, 0.0), 2) });
      }
    }
    std::ostringstream text;
    text << "# What every clinic has: preset robust on landmarks and standard tracings\n\n"
         << this->GetCohort().Describe()
         << ", each with every kind of input at the levels `standard` (regular arches, in occlusion) and `practice` "
            "(real arches' traits, some jaws apart). Drawn with a reader's errors, a bias of 0.15 mm and 1 % gross "
            "errors. Error of a jaw: mean over the middles of all its pairs of landmarks, pixels of the radiograph "
            "(0.24 to 0.26 mm). Bound: a plain least-squares fit with known correspondences, without bias and gross "
            "errors.\n"
         << DescribeFailures(this->GetRecords()) << "\n## On cases that nothing was set on\n\n"
         << (this->GetRecords().size() - calibrating) << " cases, from number " << calibrating + 1 << " on.\n\n"
         << report.ToMarkdown() << "\n## To set limits and sigmas by\n\n"
         << "The " << calibrating
         << " cases before. An exact sigma has the factor 1. The predicted sigma is that of the middle of both sides "
            "at incisors and first molars, which the verdict has limits for.\n\n"
         << calibration.ToMarkdown();
    return { { "practice.md", text.str() }, { "practice.csv", csv.ToCSV() } };
  }

private:
  /** Registers what a kind of input leaves of a case. */
  void
  Run(const ExperimentCase &    full,
      const std::string &       cohort,
      const InputType &         input,
      ExperimentRecord &        record,
      const ExperimentMonitor & monitor) const
  {
    const std::vector<JawEnum> none = { JawEnum::Unknown };
    for (const JawEnum leftOut : input.oneJawAtATime ? std::vector<JawEnum>{ JawEnum::Lower, JawEnum::Upper } : none)
    {
      auto data = std::make_shared<DentalCaseData>(*full.data);
      for (const JawEnum jaw : { JawEnum::Upper, JawEnum::Lower })
      {
        if (jaw == leftOut)
        {
          data->GetJaw(jaw) = DentalCaseData::JawType();
        }
        else if (!input.outlines)
        {
          data->GetJaw(jaw).contour = nullptr;
        }
      }
      if (!input.landmarks)
      {
        data->cephalometricLandmarks = nullptr;
      }
      if (!input.scanLandmarks)
      {
        data->landmarks3D = nullptr;
      }
      ExperimentCase own = full;
      own.data = data;
      // The method outlives the chain: its solution says what it would make of landmarks that the case was not given.
      PoseRegistrationMethodBase::Pointer registration;
      ExperimentMethod                    method = *FindExperimentMethod(PracticeMethod);
      method.exchange = [&](PoseRegistrationMethodBase & used) { registration = &used; };
      ExperimentRunner runner(own);
      runner.SetAbort(monitor.GetAbort());
      const CaseResult result = runner.Run(method);
      record.Add(cohort, result);
      for (const auto & entry : result.jaws)
      {
        auto & jaw = record.methods[cohort][ToString(entry.first)];
        jaw.landmarks.clear();
        if (entry.second.registered)
        {
          jaw.landmarks = MeasureMiddles(registration->GetOutput(), entry.first, full);
        }
      }
    }
  }
};
} // namespace

std::unique_ptr<ExperimentPlan>
MakePracticePlan(const ExperimentCohort & cohort)
{
  return std::make_unique<PracticePlan>(cohort, SelectExperimentMethods({ PracticeMethod }));
}
} // namespace itk

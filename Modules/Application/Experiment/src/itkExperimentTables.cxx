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
#include "itkExperimentTables.h"

#include "itkExperimentStatistics.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace itk
{
namespace
{
using Table = ExperimentTable;
using Records = std::vector<ExperimentRecord>;
using JawRecord = ExperimentRecord::JawType;

constexpr const char * Jaws[] = { "upper", "lower" };
constexpr const char * JawTitles[] = { "Upper jaw", "Lower jaw" };
constexpr double       SuccessLimits[] = { 2.0, 2.5, 3.0, 4.0 };
constexpr double       NotUsable = 2.0;
constexpr double       None = std::numeric_limits<double>::quiet_NaN();
constexpr unsigned int Resamples = 2000;
constexpr unsigned int Flips = 20000;
/** Radius of the 95 % region in sigmas. */
constexpr double             Radius95 = 2.448;
constexpr const char * const PaperNote = "Figures after a slash are those that the paper prints; they were obtained on "
                                         "other, private data (34 clinical cases) "
                                         "and are no target of a simulated cohort.";

/** What the paper prints of a method: mean, RMSE, std, incisors and canines, premolars, molars. */
struct PaperRow
{
  const char * method;
  double       upper[6];
  double       lower[6];
};
constexpr PaperRow PaperLandmarks[] = {
  { "bounding-box",
    { 43.508, 50.734, 26.094, 18.405, 40.618, 70.539 },
    { 44.887, 46.859, 13.451, 29.939, 54.100, 53.693 } },
  { "single-stage",
    { 54.567, 58.666, 21.546, 35.163, 51.224, 76.199 },
    { 49.625, 50.662, 10.199, 38.577, 58.672, 54.640 } },
  { "paper", { 17.546, 20.339, 10.288, 23.472, 13.205, 14.513 }, { 40.617, 42.853, 13.660, 49.644, 51.025, 24.652 } },
  { "no-umda", { 49.472, 52.328, 17.050, None, None, None }, { 80.423, 88.578, 37.125, None, None, None } },
  { "one-sided", { 42.089, 46.296, 19.285, None, None, None }, { 48.871, 50.004, 10.588, None, None, None } },
};
constexpr double PaperContours[2][4] = { { 8.397, 45.714, 6.082, 10.713 }, { 4.055, 22.045, 3.585, 4.526 } };

const double *
PaperFigures(const std::string & method, unsigned int jaw)
{
  for (const PaperRow & row : PaperLandmarks)
  {
    if (method == row.method)
    {
      return jaw == 0 ? row.upper : row.lower;
    }
  }
  return nullptr;
}

std::string
Beside(double ours, double papers, int digits)
{
  const std::string text = Table::Number(ours, digits);
  return std::isfinite(papers) ? (text.empty() ? "-" : text) + " / " + Table::Number(papers, digits) : text;
}

std::string
Probability(double p)
{
  return p < 0.0001 ? "< 0.0001" : Table::Number(p, 4);
}

std::string
Count(std::size_t value)
{
  return std::to_string(value);
}

const JawRecord *
Find(const ExperimentRecord & record, const std::string & method, const std::string & jaw)
{
  const auto found = record.methods.find(method);
  if (found == record.methods.end())
  {
    return nullptr;
  }
  const auto entry = found->second.find(jaw);
  return entry == found->second.end() ? nullptr : &entry->second;
}

bool
Has(const std::vector<ExperimentMethod> & methods, const std::string & name)
{
  return std::any_of(
    methods.begin(), methods.end(), [&](const ExperimentMethod & method) { return method.name == name; });
}

/** Errors of the landmarks, one vector a case. */
std::vector<std::vector<double>>
ErrorsOfCases(const Records & records, const std::string & method, const std::string & jaw)
{
  std::vector<std::vector<double>> errors;
  for (const ExperimentRecord & record : records)
  {
    const JawRecord * entry = Find(record, method, jaw);
    if (entry != nullptr && entry->registered)
    {
      errors.emplace_back();
      for (const auto & landmark : entry->landmarks)
      {
        errors.back().push_back(landmark.pixels);
      }
    }
  }
  return errors;
}

class TableMaker
{
public:
  TableMaker(const Records &                       records,
             const std::vector<ExperimentMethod> & methods,
             const ExperimentDescription &         description)
    : m_Records(records)
    , m_Methods(methods)
    , m_Description(description)
  {}

  std::map<std::string, std::string>
  Make()
  {
    m_Text
      << "# Experiment\n\n"
      << m_Description.cohort << ". Errors in pixels of the radiograph unless mm is said (on the detector plane). "
      << PaperNote << "\n\n"
      << "Means are over the landmarks of all jaws that a method registered; the column \"not registered\" says how "
         "many it did not, and they count as missed in the success rates. Nothing else is left out.\n";
    this->AddLandmarkTables();
    this->AddContourTable();
    this->AddAblation();
    this->AddSuccessRates();
    this->AddTests();
    this->AddFailures();
    this->AddCoverage();
    this->AddVerdict();
    this->AddCases();
    m_Files["tables.md"] = m_Text.str();
    return m_Files;
  }

private:
  void
  Heading(const std::string & title, const std::string & text = std::string())
  {
    m_Text << "\n## " << title << "\n\n";
    if (!text.empty())
    {
      m_Text << text << "\n\n";
    }
  }

  void
  AddLandmarkTables()
  {
    this->Heading("Landmark errors (the paper's table of baselines)",
                  "Ours / printed in the paper. The interval is the 95 % bootstrap interval of the mean, by cases.");
    Table csv({ "jaw",
                "method",
                "cases",
                "not_registered",
                "failed",
                "cases_above_2mm",
                "landmarks",
                "mean_px",
                "mean_low95_px",
                "mean_high95_px",
                "rmse_px",
                "std_px",
                "incisors_canines_px",
                "premolars_px",
                "molars_px",
                "worst_case_px",
                "paper_mean_px",
                "paper_rmse_px",
                "paper_std_px",
                "paper_incisors_canines_px",
                "paper_premolars_px",
                "paper_molars_px" });
    for (unsigned int jaw = 0; jaw < 2; ++jaw)
    {
      Table markdown({ std::string(JawTitles[jaw]),
                       "Mean",
                       "95 %",
                       "RMSE",
                       "Std",
                       "Inc.&Can.",
                       "PreM",
                       "Molars",
                       "worst case",
                       "> 2 mm",
                       "not registered" });
      for (const ExperimentMethod & method : m_Methods)
      {
        const ExperimentFigures f = PoolExperiment(m_Records, method.name, Jaws[jaw]);
        const double *          paper = PaperFigures(method.name, jaw);
        const auto              interval =
          BootstrapMeanInterval(ErrorsOfCases(m_Records, method.name, Jaws[jaw]), 0.95, Resamples, m_Description.seed);
        const double ours[6] = { f.mean, f.rmse, f.standardDeviation, f.groups[0], f.groups[1], f.groups[2] };
        std::vector<std::string> cells = { Jaws[jaw],
                                           method.name,
                                           Count(f.cases),
                                           Count(f.notRegistered),
                                           Count(f.failed),
                                           Count(f.above2mm),
                                           Count(f.landmarks),
                                           Table::Number(f.mean, 6),
                                           Table::Number(interval.first, 6),
                                           Table::Number(interval.second, 6) };
        for (unsigned int i = 1; i < 6; ++i)
        {
          cells.push_back(Table::Number(ours[i], 6));
        }
        cells.push_back(Table::Number(f.worstCase, 6));
        for (unsigned int i = 0; i < 6; ++i)
        {
          cells.push_back(paper != nullptr ? Table::Number(paper[i], 3) : "");
        }
        csv.AddRow(cells);
        cells = { method.title };
        for (unsigned int i = 0; i < 6; ++i)
        {
          cells.push_back(Beside(ours[i], paper != nullptr ? paper[i] : None, 3));
          if (i == 0)
          {
            cells.push_back(std::isfinite(interval.first)
                              ? Table::Number(interval.first, 2) + " to " + Table::Number(interval.second, 2)
                              : "");
          }
        }
        cells.push_back(Table::Number(f.worstCase, 2));
        cells.push_back(Count(f.above2mm) + " of " + Count(f.cases));
        cells.push_back(Count(f.notRegistered));
        markdown.AddRow(cells);
      }
      m_Text << markdown.ToMarkdown() << '\n';
    }
    m_Files["table1_landmarks.csv"] = csv.ToCSV();
  }

  void
  AddContourTable()
  {
    this->Heading("Contour distances (the paper's table of contour metrics)",
                  "Between tracing and the whole silhouette, point to point, means over the cases. The paper prints "
                  "them for its own method only.");
    Table csv({ "jaw",
                "method",
                "chamfer_px",
                "hausdorff_px",
                "ios_to_cr_px",
                "cr_to_ios_px",
                "paper_chamfer_px",
                "paper_hausdorff_px",
                "paper_ios_to_cr_px",
                "paper_cr_to_ios_px" });
    for (unsigned int jaw = 0; jaw < 2; ++jaw)
    {
      Table markdown({ std::string(JawTitles[jaw]), "Chamfer", "Hausdorff", "IOS -> CR mean", "CR -> IOS mean" });
      for (const ExperimentMethod & method : m_Methods)
      {
        const ExperimentFigures f = PoolExperiment(m_Records, method.name, Jaws[jaw]);
        const double            ours[4] = {
                     f.contour.chamfer, f.contour.hausdorff, f.contour.movingToFixed, f.contour.fixedToMoving
        };
        std::vector<std::string> cells = { Jaws[jaw], method.name };
        std::vector<std::string> papers;
        std::vector<std::string> beside = { method.title };
        for (unsigned int i = 0; i < 4; ++i)
        {
          const double paper = method.name == "paper" ? PaperContours[jaw][i] : None;
          cells.push_back(Table::Number(ours[i], 6));
          papers.push_back(Table::Number(paper, 3));
          beside.push_back(Beside(ours[i], paper, 3));
        }
        cells.insert(cells.end(), papers.begin(), papers.end());
        csv.AddRow(cells);
        markdown.AddRow(beside);
      }
      m_Text << markdown.ToMarkdown() << '\n';
    }
    m_Files["table2_contours.csv"] = csv.ToCSV();
  }

  void
  AddAblation()
  {
    const std::pair<const char *, const char *> rows[] = { { "paper", "DentalSCR as in the paper" },
                                                           { "no-umda", "w/o UMDA" },
                                                           { "one-sided", "w/o Bi-Chamfer (CR -> IOS only)" },
                                                           { "single-stage", "w/o Coarse-to-Fine (= single stage)" },
                                                           { "parallel", "w/o perspective (not in the paper)" },
                                                           { "robust", "DentalSCR robust (not in the paper)" } };
    Table                                       csv({ "method",
                                                      "upper_mean_px",
                                                      "upper_rmse_px",
                                                      "upper_std_px",
                                                      "lower_mean_px",
                                                      "lower_rmse_px",
                                                      "lower_std_px",
                                                      "paper_upper_mean_px",
                                                      "paper_upper_rmse_px",
                                                      "paper_upper_std_px",
                                                      "paper_lower_mean_px",
                                                      "paper_lower_rmse_px",
                                                      "paper_lower_std_px" });
    Table markdown({ "Config", "Upper mean", "Upper RMSE", "Upper std", "Lower mean", "Lower RMSE", "Lower std" });
    bool  any = false;
    for (const auto & row : rows)
    {
      if (!Has(m_Methods, row.first))
      {
        continue;
      }
      any = true;
      std::vector<std::string> cells = { row.first };
      std::vector<std::string> papers;
      std::vector<std::string> beside = { row.second };
      for (unsigned int jaw = 0; jaw < 2; ++jaw)
      {
        const ExperimentFigures f = PoolExperiment(m_Records, row.first, Jaws[jaw]);
        const double            ours[3] = { f.mean, f.rmse, f.standardDeviation };
        const double *          paper = PaperFigures(row.first, jaw);
        for (unsigned int i = 0; i < 3; ++i)
        {
          cells.push_back(Table::Number(ours[i], 6));
          papers.push_back(paper != nullptr ? Table::Number(paper[i], 3) : "");
          beside.push_back(Beside(ours[i], paper != nullptr ? paper[i] : None, 3));
        }
      }
      cells.insert(cells.end(), papers.begin(), papers.end());
      csv.AddRow(cells);
      markdown.AddRow(beside);
    }
    if (any)
    {
      this->Heading("Ablation (the paper's table of ablations)",
                    "Without UMDA a simulated file keeps axes tilted by at most 15 degrees.");
      m_Text << markdown.ToMarkdown();
      m_Files["table3_ablation.csv"] = csv.ToCSV();
    }
  }

  void
  AddSuccessRates()
  {
    this->Heading("Success detection rate", "Share of the landmarks within so many mm.");
    Table csv({ "jaw", "method", "sdr_2mm", "sdr_2_5mm", "sdr_3mm", "sdr_4mm" });
    Table markdown({ "Method", "Upper 2 mm", "2.5 mm", "3 mm", "4 mm", "Lower 2 mm", "2.5 mm", "3 mm", "4 mm" });
    for (const ExperimentMethod & method : m_Methods)
    {
      std::vector<std::string> beside = { method.title };
      for (const char * jaw : Jaws)
      {
        const ExperimentFigures  f = PoolExperiment(m_Records, method.name, jaw);
        std::vector<std::string> cells = { jaw, method.name };
        for (const double rate : f.successRates)
        {
          cells.push_back(Table::Number(rate, 6));
          beside.push_back(Table::Number(100.0 * rate, 1) + (std::isfinite(rate) ? " %" : ""));
        }
        csv.AddRow(cells);
      }
      markdown.AddRow(beside);
    }
    m_Text << markdown.ToMarkdown();
    m_Files["sdr.csv"] = csv.ToCSV();
  }

  void
  AddTests()
  {
    const std::string reference = Has(m_Methods, "robust") ? "robust" : Has(m_Methods, "paper") ? "paper" : "";
    if (reference.empty() || m_Methods.size() < 2)
    {
      return;
    }
    struct RowType
    {
      std::string               jaw;
      const ExperimentMethod *  method;
      std::size_t               pairs;
      double                    difference;
      std::pair<double, double> interval;
      double                    p;
    };
    std::vector<RowType> rows;
    std::vector<double>  pValues;
    for (const char * jaw : Jaws)
    {
      for (const ExperimentMethod & method : m_Methods)
      {
        if (method.name == reference)
        {
          continue;
        }
        std::vector<double>              differences;
        std::vector<std::vector<double>> clusters;
        for (const ExperimentRecord & record : m_Records)
        {
          const JawRecord * ours = Find(record, reference, jaw);
          const JawRecord * theirs = Find(record, method.name, jaw);
          if (ours != nullptr && theirs != nullptr && ours->GetMean(false) && theirs->GetMean(false))
          {
            differences.push_back(*ours->GetMean(false) - *theirs->GetMean(false));
            clusters.push_back({ differences.back() });
          }
        }
        if (differences.empty())
        {
          continue;
        }
        double sum = 0.0;
        for (const double difference : differences)
        {
          sum += difference;
        }
        rows.push_back({ jaw,
                         &method,
                         differences.size(),
                         sum / static_cast<double>(differences.size()),
                         BootstrapMeanInterval(clusters, 0.95, Resamples, m_Description.seed),
                         SignFlipTest(differences, Flips, m_Description.seed) });
        pValues.push_back(rows.back().p);
      }
    }
    const std::vector<double> adjusted = AdjustByHolm(pValues);
    this->Heading("Paired differences",
                  "Mean error of a case by \"" + reference +
                    "\" minus that by the other method; bootstrap interval; sign-flip permutation test, two-sided, "
                    "adjusted by Holm. Negative: \"" +
                    reference + "\" is better. Only cases that both registered have a difference.");
    Table csv({ "jaw", "reference", "method", "pairs", "mean_difference_px", "low95_px", "high95_px", "p", "p_holm" });
    Table markdown({ "Jaw", "Against", "pairs", "difference px", "95 %", "p", "p (Holm)" });
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
      const RowType & row = rows[i];
      csv.AddRow({ row.jaw,
                   reference,
                   row.method->name,
                   Count(row.pairs),
                   Table::Number(row.difference, 6),
                   Table::Number(row.interval.first, 6),
                   Table::Number(row.interval.second, 6),
                   Table::Number(row.p, 6),
                   Table::Number(adjusted[i], 6) });
      markdown.AddRow({ row.jaw,
                        row.method->title,
                        Count(row.pairs),
                        Table::Number(row.difference, 2),
                        Table::Number(row.interval.first, 2) + " to " + Table::Number(row.interval.second, 2),
                        Probability(row.p),
                        Probability(adjusted[i]) });
    }
    m_Text << markdown.ToMarkdown();
    m_Files["tests.csv"] = csv.ToCSV();
  }

  void
  AddFailures()
  {
    Table       csv({ "case", "jaw", "method", "what", "mean_mm", "reason" });
    Table       markdown({ "Case", "Jaw", "Method", "What", "Reason" });
    std::size_t listed = 0;
    std::size_t above = 0;
    for (const ExperimentRecord & record : m_Records)
    {
      if (!record.failure.empty())
      {
        csv.AddRow({ record.id, "", "", "unusable case", "", record.failure });
        markdown.AddRow({ record.id, "", "", "unusable case", record.failure });
        ++listed;
      }
      for (const ExperimentMethod & method : m_Methods)
      {
        for (const char * jaw : Jaws)
        {
          const JawRecord * entry = Find(record, method.name, jaw);
          if (entry == nullptr)
          {
            continue;
          }
          std::string reasons;
          for (const std::string & reason : entry->reasons)
          {
            reasons += (reasons.empty() ? "" : "; ") + reason;
          }
          const auto mean = entry->GetMean(true);
          if (!entry->registered || entry->status == "failed")
          {
            const std::string what = entry->registered ? "verdict failed" : "not registered";
            csv.AddRow({ record.id, jaw, method.name, what, mean ? Table::Number(*mean, 6) : "", reasons });
            markdown.AddRow({ record.id, jaw, method.title, what, reasons });
            ++listed;
          }
          else if (mean && *mean > NotUsable)
          {
            csv.AddRow({ record.id, jaw, method.name, "above 2 mm", Table::Number(*mean, 6), reasons });
            ++above;
          }
        }
      }
    }
    this->Heading("Failures",
                  "Listed here: cases that could not be read, jaws that a method did not register or called failed (" +
                    Count(listed) + "). Jaws with a mean error above 2 mm (" + Count(above) +
                    ") stand in failures.csv.");
    if (listed > 0)
    {
      m_Text << markdown.ToMarkdown();
    }
    m_Files["failures.csv"] = csv.ToCSV();
  }

  void
  AddCoverage()
  {
    struct Strata
    {
      std::string         name;
      std::vector<double> ratios;
      double              sumOfSigmas{ 0.0 };
      double              sumOfSquares{ 0.0 };
    };
    std::vector<Strata> strata = { { "all", {} },       { "upper", {} },
                                   { "lower", {} },     { "incisors and canines", {} },
                                   { "premolars", {} }, { "molars", {} } };
    for (const ExperimentRecord & record : m_Records)
    {
      for (unsigned int jaw = 0; jaw < 2; ++jaw)
      {
        const JawRecord * entry = Find(record, "robust", Jaws[jaw]);
        if (entry == nullptr || !entry->registered)
        {
          continue;
        }
        for (const auto & landmark : entry->landmarks)
        {
          if (!landmark.sigma || !(*landmark.sigma > 0.0) || landmark.group == ToothCode::GroupEnum::Unknown)
          {
            continue;
          }
          for (const unsigned int stratum : { 0u, 1u + jaw, 3u + static_cast<unsigned int>(landmark.group) })
          {
            strata[stratum].ratios.push_back(landmark.pixels / *landmark.sigma);
            strata[stratum].sumOfSigmas += *landmark.sigma;
            strata[stratum].sumOfSquares += landmark.pixels * landmark.pixels;
          }
        }
      }
    }
    if (strata[0].ratios.empty())
    {
      return;
    }
    this->Heading(
      "Coverage of the 95 % regions (robust)",
      "Share of the marked landmarks within 2.448 sigma of the predicted one, and mean sigma over the actual "
      "root mean square error an axis (1 is right, below 1 is too sure).");
    Table csv({ "stratum", "landmarks", "coverage_95", "mean_sigma_px", "rms_axis_px", "sigma_over_rms" });
    Table markdown({ "Landmarks", "number", "coverage", "sigma / rms" });
    Table calibration({ "stratum", "nominal", "observed" });
    for (const Strata & stratum : strata)
    {
      if (stratum.ratios.empty())
      {
        continue;
      }
      const auto count = static_cast<double>(stratum.ratios.size());
      const auto share = [&](double radius) {
        return static_cast<double>(std::count_if(
                 stratum.ratios.begin(), stratum.ratios.end(), [radius](double ratio) { return ratio <= radius; })) /
               count;
      };
      const double sigma = stratum.sumOfSigmas / count;
      const double rms = std::sqrt(0.5 * stratum.sumOfSquares / count);
      csv.AddRow({ stratum.name,
                   Count(stratum.ratios.size()),
                   Table::Number(share(Radius95), 6),
                   Table::Number(sigma, 6),
                   Table::Number(rms, 6),
                   Table::Number(sigma / rms, 6) });
      markdown.AddRow({ stratum.name,
                        Count(stratum.ratios.size()),
                        Table::Number(100.0 * share(Radius95), 1) + " %",
                        Table::Number(sigma / rms, 2) });
      for (int percent = 5; percent < 100; percent += 5)
      {
        const double nominal = 0.01 * percent;
        calibration.AddRow({ stratum.name,
                             Table::Number(nominal, 2),
                             Table::Number(share(std::sqrt(-2.0 * std::log(1.0 - nominal))), 6) });
      }
    }
    m_Text << markdown.ToMarkdown();
    m_Files["coverage.csv"] = csv.ToCSV();
    m_Files["calibration.csv"] = calibration.ToCSV();
  }

  void
  AddVerdict()
  {
    if (!Has(m_Methods, "robust"))
    {
      return;
    }
    const char * const verdicts[] = { "ok", "suspect", "failed" };
    std::size_t        counts[3][4] = {};
    for (const ExperimentRecord & record : m_Records)
    {
      for (const char * jaw : Jaws)
      {
        const JawRecord * entry = Find(record, "robust", jaw);
        if (entry == nullptr)
        {
          continue;
        }
        const auto         mean = entry->GetMean(true);
        const unsigned int actual = !mean ? 3 : *mean <= 0.5 ? 0 : *mean <= NotUsable ? 1 : 2;
        for (unsigned int verdict = 0; verdict < 3; ++verdict)
        {
          counts[verdict][actual] += entry->status == verdicts[verdict] ? 1 : 0;
        }
      }
    }
    this->Heading("Verdict (robust)",
                  "Jaws by verdict and by their actual mean error. An \"ok\" above 2 mm is the worst outcome.");
    Table csv({ "verdict", "up_to_0_5mm", "up_to_2mm", "above_2mm", "no_error_known" });
    Table markdown({ "Verdict", "up to 0.5 mm", "0.5 to 2 mm", "above 2 mm", "not registered" });
    for (unsigned int verdict = 0; verdict < 3; ++verdict)
    {
      std::vector<std::string> cells = { verdicts[verdict] };
      for (const std::size_t count : counts[verdict])
      {
        cells.push_back(Count(count));
      }
      csv.AddRow(cells);
      markdown.AddRow(cells);
    }
    m_Text << markdown.ToMarkdown();
    m_Files["verdict.csv"] = csv.ToCSV();
  }

  void
  AddCases()
  {
    Table cases({ "case", "seed", "jaw", "method", "status", "landmarks", "mean_px", "mean_mm", "chamfer_px" });
    Table landmarks({ "case", "jaw", "method", "landmark", "group", "error_px", "error_mm", "sigma_px" });
    for (const ExperimentRecord & record : m_Records)
    {
      for (const ExperimentMethod & method : m_Methods)
      {
        for (const char * jaw : Jaws)
        {
          const JawRecord * entry = Find(record, method.name, jaw);
          if (entry == nullptr)
          {
            continue;
          }
          const auto pixels = entry->GetMean(false);
          const auto millimetres = entry->GetMean(true);
          cases.AddRow({ record.id,
                         std::to_string(record.seed),
                         jaw,
                         method.name,
                         entry->status,
                         Count(entry->landmarks.size()),
                         pixels ? Table::Number(*pixels, 6) : "",
                         millimetres ? Table::Number(*millimetres, 6) : "",
                         entry->registered ? Table::Number(entry->whole.chamfer, 6) : "" });
          for (const auto & landmark : entry->landmarks)
          {
            std::ostringstream group;
            group << landmark.group;
            landmarks.AddRow({ record.id,
                               jaw,
                               method.name,
                               landmark.name,
                               group.str(),
                               Table::Number(landmark.pixels, 6),
                               Table::Number(landmark.millimetres, 6),
                               landmark.sigma ? Table::Number(*landmark.sigma, 6) : "" });
          }
        }
      }
    }
    m_Files["cases.csv"] = cases.ToCSV();
    m_Files["landmarks.csv"] = landmarks.ToCSV();
  }

  const Records &                       m_Records;
  const std::vector<ExperimentMethod> & m_Methods;
  const ExperimentDescription &         m_Description;
  std::map<std::string, std::string>    m_Files;
  std::ostringstream                    m_Text;
};
} // namespace

void
ExperimentTable::AddRow(const std::vector<std::string> & row)
{
  if (row.size() != m_Header.size())
  {
    throw std::logic_error("a row of " + std::to_string(row.size()) + " cells under " +
                           std::to_string(m_Header.size()) + " headings");
  }
  m_Rows.push_back(row);
}

std::string
ExperimentTable::ToCSV() const
{
  std::ostringstream text;
  const auto         write = [&](const std::vector<std::string> & cells) {
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      text << (i > 0 ? "," : "");
      if (cells[i].find_first_of(",\"\n\r") == std::string::npos)
      {
        text << cells[i];
        continue;
      }
      text << '"';
      for (const char character : cells[i])
      {
        text << (character == '"' ? "\"\"" : std::string(1, character));
      }
      text << '"';
    }
    text << '\n';
  };
  write(m_Header);
  for (const auto & row : m_Rows)
  {
    write(row);
  }
  return text.str();
}

std::string
ExperimentTable::ToMarkdown() const
{
  std::ostringstream text;
  const auto         write = [&](const std::vector<std::string> & cells) {
    for (const std::string & cell : cells)
    {
      text << "| ";
      for (const char character : cell)
      {
        text << (character == '|' ? "\\|" : character == '\n' ? " " : std::string(1, character));
      }
      text << ' ';
    }
    text << "|\n";
  };
  write(m_Header);
  for (std::size_t i = 0; i < m_Header.size(); ++i)
  {
    text << (i == 0 ? "|---" : "|---:");
  }
  text << "|\n";
  for (const auto & row : m_Rows)
  {
    write(row);
  }
  return text.str();
}

std::string
ExperimentTable::Number(double value, int digits)
{
  if (!std::isfinite(value))
  {
    return std::string();
  }
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

ExperimentFigures
PoolExperiment(const std::vector<ExperimentRecord> & records, const std::string & method, const std::string & jaw)
{
  ExperimentFigures figures;
  double            sum = 0.0;
  double            squares = 0.0;
  double            groupSums[3] = { 0.0, 0.0, 0.0 };
  std::size_t       groupCounts[3] = { 0, 0, 0 };
  std::size_t       missed = 0;
  std::size_t       successes[4] = { 0, 0, 0, 0 };
  std::size_t       registered = 0;
  for (const ExperimentRecord & record : records)
  {
    const JawRecord * entry = Find(record, method, jaw);
    if (entry == nullptr)
    {
      continue;
    }
    ++figures.cases;
    figures.failed += entry->status == "failed" ? 1 : 0;
    if (!entry->registered)
    {
      ++figures.notRegistered;
      const auto marked = record.marked.find(jaw);
      missed += marked == record.marked.end() ? 0 : marked->second;
      continue;
    }
    ++registered;
    figures.contour.chamfer += entry->whole.chamfer;
    figures.contour.hausdorff += entry->whole.hausdorff;
    figures.contour.movingToFixed += entry->whole.movingToFixed;
    figures.contour.fixedToMoving += entry->whole.fixedToMoving;
    if (const auto mean = entry->GetMean(true))
    {
      figures.above2mm += *mean > NotUsable ? 1 : 0;
      figures.worstCase = std::max(figures.worstCase, *entry->GetMean(false));
    }
    for (const auto & landmark : entry->landmarks)
    {
      ++figures.landmarks;
      sum += landmark.pixels;
      squares += landmark.pixels * landmark.pixels;
      if (landmark.group != ToothCode::GroupEnum::Unknown)
      {
        groupSums[static_cast<unsigned int>(landmark.group)] += landmark.pixels;
        ++groupCounts[static_cast<unsigned int>(landmark.group)];
      }
      for (unsigned int i = 0; i < 4; ++i)
      {
        successes[i] += landmark.millimetres <= SuccessLimits[i] ? 1 : 0;
      }
    }
  }
  const auto ratio = [](double numerator, std::size_t denominator) {
    return denominator > 0 ? numerator / static_cast<double>(denominator) : None;
  };
  figures.mean = ratio(sum, figures.landmarks);
  figures.rmse = std::sqrt(ratio(squares, figures.landmarks));
  // The population's: RMSE^2 = mean^2 + std^2.
  figures.standardDeviation =
    figures.landmarks > 0 ? std::sqrt(std::max(0.0, figures.rmse * figures.rmse - figures.mean * figures.mean)) : None;
  if (figures.landmarks == 0)
  {
    figures.worstCase = None;
  }
  for (unsigned int i = 0; i < 3; ++i)
  {
    figures.groups[i] = ratio(groupSums[i], groupCounts[i]);
  }
  for (unsigned int i = 0; i < 4; ++i)
  {
    figures.successRates[i] = ratio(static_cast<double>(successes[i]), figures.landmarks + missed);
  }
  figures.contour.chamfer = ratio(figures.contour.chamfer, registered);
  figures.contour.hausdorff = ratio(figures.contour.hausdorff, registered);
  figures.contour.movingToFixed = ratio(figures.contour.movingToFixed, registered);
  figures.contour.fixedToMoving = ratio(figures.contour.fixedToMoving, registered);
  return figures;
}

std::map<std::string, std::string>
MakeExperimentTables(const std::vector<ExperimentRecord> & records,
                     const std::vector<ExperimentMethod> & methods,
                     const ExperimentDescription &         description)
{
  return TableMaker(records, methods, description).Make();
}
} // namespace itk

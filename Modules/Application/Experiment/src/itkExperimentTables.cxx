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

#include "itkExperimentFigures.h"
#include "itkExperimentConfusionTable.h"
#include "itkExperimentCoverageTable.h"
#include "itkExperimentStatistics.h"
#include "itkExperimentTable.h"

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

constexpr const char *       Jaws[] = { "upper", "lower" };
constexpr const char *       JawTitles[] = { "Upper jaw", "Lower jaw" };
constexpr double             NotUsable = 2.0;
constexpr double             None = std::numeric_limits<double>::quiet_NaN();
constexpr unsigned int       Resamples = 2000;
constexpr unsigned int       Flips = 20000;
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
    const JawRecord * entry = record.Find(method, jaw);
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
          const JawRecord * ours = record.Find(reference, jaw);
          const JawRecord * theirs = record.Find(method.name, jaw);
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
      for (const char * jaw : Jaws)
      {
        // The same for every method: a jaw that is registered, but not marked.
        const bool unmeasured = std::any_of(m_Methods.begin(), m_Methods.end(), [&](const ExperimentMethod & method) {
          const JawRecord * entry = record.Find(method.name, jaw);
          return entry != nullptr && entry->registered && entry->landmarks.empty();
        });
        if (unmeasured)
        {
          const std::string reason = "no landmark of this jaw is marked both on the scan and in the radiograph";
          csv.AddRow({ record.id, jaw, "", "no error known", "", reason });
          markdown.AddRow({ record.id, jaw, "", "no error known", reason });
          ++listed;
        }
      }
      for (const ExperimentMethod & method : m_Methods)
      {
        for (const char * jaw : Jaws)
        {
          const JawRecord * entry = record.Find(method.name, jaw);
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
    this->Heading(
      "Failures",
      "Listed here: cases that could not be used, jaws without landmarks, jaws that a method did not register or "
      "called failed (" +
        Count(listed) + "). Jaws with a mean error above 2 mm (" + Count(above) + ") stand in failures.csv.");
    if (listed > 0)
    {
      m_Text << markdown.ToMarkdown();
    }
    m_Files["failures.csv"] = csv.ToCSV();
  }

  void
  AddCoverage()
  {
    ExperimentCoverageTable table;
    for (const ExperimentRecord & record : m_Records)
    {
      table.Add(record, "robust", {});
    }
    if (table.IsEmpty())
    {
      return;
    }
    this->Heading("Coverage of the 95 % regions (robust)", ExperimentCoverageTable::GetExplanation());
    m_Text << table.ToMarkdown();
    m_Files["coverage.csv"] = table.ToCSV();
    m_Files["calibration.csv"] = table.ToCalibrationCSV();
  }

  void
  AddVerdict()
  {
    if (!Has(m_Methods, "robust"))
    {
      return;
    }
    ExperimentConfusionTable table;
    for (const ExperimentRecord & record : m_Records)
    {
      table.Add("", record, "robust");
    }
    this->Heading("Verdict (robust)", ExperimentConfusionTable::GetExplanation());
    m_Text << table.ToMarkdown();
    m_Files["verdict.csv"] = table.ToCSV();
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
          const JawRecord * entry = record.Find(method.name, jaw);
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

std::map<std::string, std::string>
MakeExperimentTables(const std::vector<ExperimentRecord> & records,
                     const std::vector<ExperimentMethod> & methods,
                     const ExperimentDescription &         description)
{
  return TableMaker(records, methods, description).Make();
}
} // namespace itk

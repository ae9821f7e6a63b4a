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
#ifndef itkExperimentTables_h
#define itkExperimentTables_h

#include "ExperimentExport.h"
#include "itkExperimentMethod.h"
#include "itkExperimentRecord.h"

#include <map>
#include <string>
#include <vector>

namespace itk
{
/** \class ExperimentTable
 * \brief Rows of text under a header, as CSV and as Markdown.
 *
 * \ingroup Experiment
 */
class Experiment_EXPORT ExperimentTable
{
public:
  explicit ExperimentTable(std::vector<std::string> header)
    : m_Header(std::move(header))
  {}

  /** Throws std::logic_error for a row of another length than the header. */
  void
  AddRow(const std::vector<std::string> & row);

  std::string
  ToCSV() const;
  std::string
  ToMarkdown() const;

  /** Fixed digits; empty for what is not finite. */
  static std::string
  Number(double value, int digits);

private:
  std::vector<std::string>              m_Header;
  std::vector<std::vector<std::string>> m_Rows;
};

/** The figures of one method and jaw, pooled over all landmarks of all registered cases as the paper's are. */
struct Experiment_EXPORT ExperimentFigures
{
  std::size_t           cases{ 0 };
  std::size_t           notRegistered{ 0 };
  std::size_t           failed{ 0 };
  std::size_t           above2mm{ 0 };
  std::size_t           landmarks{ 0 };
  double                mean{ 0.0 };
  double                rmse{ 0.0 };
  double                standardDeviation{ 0.0 };
  double                worstCase{ 0.0 };
  std::array<double, 3> groups{ { 0.0, 0.0, 0.0 } };
  ContourFigures        contour;
  /** Share of the landmarks within 2, 2.5, 3, 4 mm; those of jaws that are not registered count as missed. */
  std::array<double, 4> successRates{ { 0.0, 0.0, 0.0, 0.0 } };
};

Experiment_EXPORT ExperimentFigures
PoolExperiment(const std::vector<ExperimentRecord> & records, const std::string & method, const std::string & jaw);

/** What the tables say of themselves. */
struct ExperimentDescription
{
  /** "34 simulated cases, level typical, seeds 1 to 34". */
  std::string   cohort;
  std::uint64_t seed{ 1 };
};

/** Every table of an experiment by file name: tables.md, and CSV files. The same text for the same records: no times.
 *
 * \ingroup Experiment */
Experiment_EXPORT std::map<std::string, std::string>
                  MakeExperimentTables(const std::vector<ExperimentRecord> & records,
                                       const std::vector<ExperimentMethod> & methods,
                                       const ExperimentDescription &         description);
} // namespace itk

#endif

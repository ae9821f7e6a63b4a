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
#ifndef itkExperimentCoverageTable_h
#define itkExperimentCoverageTable_h

#include "ExperimentExport.h"
#include "itkExperimentRecord.h"

#include <set>
#include <string>
#include <vector>

namespace itk
{
/** \class ExperimentCoverageTable
 * \brief How far the predicted uncertainty of landmarks can be trusted: overall, by jaw, tooth group and cohort.
 *
 * Coverage: share of the marked landmarks inside the region of a nominal probability around the predicted one, a
 * circle of radius sigma sqrt(-2 ln(1 - p)); 2.448 sigma for 95 %. Beside it the mean sigma over the root mean square
 * error an axis.
 *
 * \ingroup Experiment
 */
class Experiment_EXPORT ExperimentCoverageTable
{
public:
  ExperimentCoverageTable();

  /** Every landmark with a sigma that the method predicted in a case; the cohort has a stratum where it is named. */
  void
  Add(const ExperimentRecord & record, const std::string & method, const std::string & cohort = std::string());
  /** Whether no landmark with an uncertainty was added. */
  bool
  IsEmpty() const
  {
    return m_Strata.front().ratios.empty();
  }
  /** The table as Markdown and as CSV. */
  std::string
  ToMarkdown() const;
  std::string
  ToCSV() const;
  /** Observed against nominal probability in steps of 5 %. */
  std::string
  ToCalibrationCSV() const;

  /** A sentence to stand above it. */
  static const char *
  GetExplanation();

private:
  struct StratumType
  {
    std::string           by;
    std::string           name;
    std::set<std::string> cases;
    /** Error over sigma. */
    std::vector<double> ratios;
    double              sumOfSigmas{ 0.0 };
    double              sumOfSquares{ 0.0 };

    double
    GetShareWithin(double radius) const;
  };

  std::vector<StratumType> m_Strata;
};
} // namespace itk

#endif

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
#ifndef itkExperimentRecord_h
#define itkExperimentRecord_h

#include "ExperimentExport.h"
#include "itkCaseResult.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace itk
{
/** \struct ExperimentRecord
 * \brief What an experiment keeps of one case: enough for every table, a few kB.
 *
 * \ingroup Experiment
 */
struct Experiment_EXPORT ExperimentRecord
{
  /** The error of one landmark. */
  struct LandmarkType
  {
    std::string           name;                                   /**< Its name. */
    ToothCode::GroupEnum  group{ ToothCode::GroupEnum::Unknown }; /**< As the paper's. */
    double                pixels{ 0.0 };                          /**< Distance between predicted and marked. */
    double                millimetres{ 0.0 };                     /**< The same in the detector plane. */
    std::optional<double> sigma; /**< Predicted, px an axis; absent where the method has none. */
  };
  /** What one method made of one jaw. */
  struct JawType
  {
    bool                      registered{ false }; /**< Whether the method placed the jaw. */
    std::string               status;              /**< "ok", "suspect", "failed"; "" of a method without a verdict. */
    std::vector<std::string>  reasons;             /**< Codes of the findings. */
    std::array<double, 4>     similarity{ { 0.0, 0.0, 0.0, 0.0 } }; /**< Scale, angle (radians), shifts u and v (px). */
    ContourFigures            whole;                                /**< Of the whole contour. */
    std::vector<LandmarkType> landmarks; /**< One a landmark that was marked and predicted. */
    /** Predicted standard deviation an axis of the middle of both sides, pixels of 0.25 mm, over incisors and first
     * molars: what the verdict judges where landmarks alone placed the jaw. Absent elsewhere. */
    std::optional<double> middleSigma;
    double                seconds{ 0.0 };

    /** Mean error; absent without landmarks. */
    std::optional<double>
    GetMean(bool inMillimetres) const;
  };

  std::string   id;        /**< Names the case in files. */
  std::uint64_t seed{ 0 }; /**< What it was drawn from. */
  /** Why there is nothing else, where the case could not be read. */
  std::string failure;
  /** Marked landmarks a jaw ("upper", "lower"): what a jaw that is not registered misses. */
  std::map<std::string, std::size_t> marked;
  /** By method, then by jaw. */
  std::map<std::string, std::map<std::string, JawType>> methods;
  /** Adds what a method made of the case, measured against the marked landmarks of the result. */
  void
  Add(const std::string & method, const CaseResult & result);

  /** Null where the method did not see the jaw. */
  const JawType *
  Find(const std::string & method, const std::string & jaw) const;
  /** The record as one line of JSON; the key says what experiment it belongs to. */
  std::string
  ToJson(const std::string & key) const;

  /** Throws std::exception where the text is no record, or one with another key. */
  static ExperimentRecord
  FromJson(const std::string & text, const std::string & key);
};
} // namespace itk

#endif

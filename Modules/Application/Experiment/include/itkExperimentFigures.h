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
#ifndef itkExperimentFigures_h
#define itkExperimentFigures_h

#include "ExperimentExport.h"
#include "itkExperimentRecord.h"

#include <array>
#include <string>
#include <vector>

namespace itk
{
/** The figures of one method and jaw, pooled over all landmarks of all registered cases as the paper's are. */
struct Experiment_EXPORT ExperimentFigures
{
  std::size_t           cases{ 0 };                  /**< Cases that have the jaw. */
  std::size_t           notRegistered{ 0 };          /**< Of these without a registration. */
  std::size_t           failed{ 0 };                 /**< Of these with the verdict failed. */
  std::size_t           above2mm{ 0 };               /**< Of these with a mean error of more than 2 mm. */
  std::size_t           landmarks{ 0 };              /**< Landmarks measured. */
  double                mean{ 0.0 };                 /**< Mean error, px. */
  double                rmse{ 0.0 };                 /**< Root mean square of the errors, px. */
  double                standardDeviation{ 0.0 };    /**< Of the errors about their mean, px. */
  double                worstCase{ 0.0 };            /**< Largest mean error of one case, px. */
  std::array<double, 3> groups{ { 0.0, 0.0, 0.0 } }; /**< Mean error of incisors and canines, premolars, molars, px. */
  ContourFigures        contour;                     /**< Mean over the cases. */
  /** Share of the landmarks within 2, 2.5, 3, 4 mm; those of jaws that are not registered count as missed. */
  std::array<double, 4> successRates{ { 0.0, 0.0, 0.0, 0.0 } };
};

Experiment_EXPORT ExperimentFigures
PoolExperiment(const std::vector<ExperimentRecord> & records, const std::string & method, const std::string & jaw);
} // namespace itk

#endif

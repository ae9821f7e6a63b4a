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
#ifndef itkExperimentPictures_h
#define itkExperimentPictures_h

namespace itk
{
/** Not installed. A picture that is made of an experiment's tables and cases, in its folder. */
struct ExperimentPicture
{
  const char * fileName;
  const char * title;
};

/** All that there can be, in the order of the page: what the page shows, and what a run that makes other tables takes
 * away, since pictures of other cases would stand beside these. */
inline constexpr ExperimentPicture ExperimentPictures[] = {
  { "plots/landmark_errors.png", "Mean landmark error of each case, by method" },
  { "plots/success_rate.png", "Landmarks within each limit, by method" },
  { "plots/capture_accurate.png", "Starts that end within 2 mm of the truth" },
  { "plots/capture_converged.png", "Starts that end where the best one ends" },
  { "plots/sensitivity.png", "Mean landmark error by the level of each factor" },
  { "plots/ablation.png", "Mean and worst case of each variant" },
  { "plots/calibration.png", "How often landmarks lie in the regions they are given" },
  { "plots/verdict.png", "Verdicts by the error that there was" },
  { "figure_median_upper.png", "The median case, upper jaw" },
  { "figure_median_lower.png", "The median case, lower jaw" },
  { "figure_worst_upper.png", "The worst case, upper jaw" },
  { "figure_worst_lower.png", "The worst case, lower jaw" }
};
} // namespace itk

#endif

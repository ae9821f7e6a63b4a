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
#ifndef itkLandmarkErrorStatistics_h
#define itkLandmarkErrorStatistics_h

#include "RegistrationEvaluationExport.h"
#include "itkToothCode.h"

#include <array>
#include <cstddef>
#include <ostream>

namespace itk
{
/** \class LandmarkErrorStatistics
 * \brief Figures of landmark errors: of one jaw, one case or a cohort, of all teeth and of the three tooth groups.
 *
 * Errors are distances in pixels; millimetres may be given beside them and are kept apart. Adding the statistics of
 * other cases pools their landmarks, as the paper's tables do: a case with more landmarks weighs more. Only moments and
 * counts are kept, so that a cohort of any size takes the same memory.
 *
 * The standard deviation is the population's (divided by n), hence RMSE^2 = mean^2 + std^2. A figure of nothing does
 * not exist: asking for the mean of a group without landmarks throws; ask for the count first.
 *
 * \ingroup RegistrationEvaluation
 */
class RegistrationEvaluation_EXPORT LandmarkErrorStatistics
{
public:
  using GroupEnum = ToothCode::GroupEnum;

  /** Limits in mm of the success detection rate, as the cephalometric benchmarks have them. */
  static constexpr std::array<double, 4> SuccessThresholds{ { 2.0, 2.5, 3.0, 4.0 } };

  /** Adds one landmark's error in pixels. Throws for one that is negative or not finite. */
  void
  Add(GroupEnum group, double pixels);

  /** Adds one landmark's error in pixels and in mm. */
  void
  Add(GroupEnum group, double pixels, double millimetres);

  /** Pools the landmarks of both. */
  void
  Add(const LandmarkErrorStatistics & other);
  /** How many errors there are: all, or those of a tooth group. */
  std::size_t
  GetCount() const;
  std::size_t
  GetCount(GroupEnum group) const;

  /** In pixels. Each throws where the count is 0. */
  double
  GetMean() const;
  double
  GetMean(GroupEnum group) const;
  double
  GetRMSE() const;
  double
  GetRMSE(GroupEnum group) const;
  double
  GetStandardDeviation() const;
  double
  GetStandardDeviation(GroupEnum group) const;
  double
  GetMaximum() const;
  double
  GetMaximum(GroupEnum group) const;

  /** Landmarks whose error is known in mm. */
  std::size_t
  GetCountInMillimetres() const;
  /** In mm. Each throws where GetCountInMillimetres() is 0. */
  double
  GetMeanInMillimetres() const;
  double
  GetRMSEInMillimetres() const;
  double
  GetStandardDeviationInMillimetres() const;

  /** The fraction, 0 to 1, of the landmarks known in mm whose error is at most the threshold, which has to be one of
   * SuccessThresholds. Throws where GetCountInMillimetres() is 0. */
  double
  GetSuccessDetectionRate(double thresholdInMillimetres) const;

  friend RegistrationEvaluation_EXPORT bool
  operator==(const LandmarkErrorStatistics & a, const LandmarkErrorStatistics & b);
  friend bool
  operator!=(const LandmarkErrorStatistics & a, const LandmarkErrorStatistics & b)
  {
    return !(a == b);
  }
  friend RegistrationEvaluation_EXPORT std::ostream &
                                       operator<<(std::ostream & os, const LandmarkErrorStatistics & statistics);

private:
  /** Running moments (Welford 1962; merged after Chan, Golub, LeVeque 1979): no cancellation as in a sum of squares. */
  struct Moments
  {
    std::size_t count{ 0 };
    double      mean{ 0.0 };
    double      squares{ 0.0 };
    double      maximum{ 0.0 };

    void
    Add(const Moments & other);
  };

  const Moments &
  GetMoments(GroupEnum group) const;

  Moments                    m_All;
  std::array<Moments, 4>     m_Groups;
  Moments                    m_Millimetres;
  std::array<std::size_t, 4> m_Successes{ { 0, 0, 0, 0 } };
};
} // namespace itk

#endif

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
#include "itkLandmarkErrorStatistics.h"
#include "itkMessageOfCall.h"

#include "itkMacro.h"
#include "itkReproducibleRandom.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <vector>

namespace
{
using itk::LandmarkErrorStatistics;
using itk::MessageOfCall;
using GroupEnum = LandmarkErrorStatistics::GroupEnum;

} // namespace

TEST(LandmarkErrorStatistics, AgreesWithHandComputedFigures)
{
  // 1, 2, 3, 6: mean 3, mean square 50/4, variance 50/4 - 9.
  LandmarkErrorStatistics statistics;
  statistics.Add(GroupEnum::IncisorsAndCanines, 1.0);
  statistics.Add(GroupEnum::IncisorsAndCanines, 2.0);
  statistics.Add(GroupEnum::Premolars, 3.0);
  statistics.Add(GroupEnum::Molars, 6.0);
  EXPECT_EQ(statistics.GetCount(), 4u);
  EXPECT_DOUBLE_EQ(statistics.GetMean(), 3.0);
  EXPECT_DOUBLE_EQ(statistics.GetRMSE(), std::sqrt(12.5));
  EXPECT_DOUBLE_EQ(statistics.GetStandardDeviation(), std::sqrt(3.5));
  EXPECT_DOUBLE_EQ(statistics.GetMaximum(), 6.0);
  EXPECT_EQ(statistics.GetCount(GroupEnum::IncisorsAndCanines), 2u);
  EXPECT_DOUBLE_EQ(statistics.GetMean(GroupEnum::IncisorsAndCanines), 1.5);
  EXPECT_DOUBLE_EQ(statistics.GetStandardDeviation(GroupEnum::IncisorsAndCanines), 0.5);
  EXPECT_DOUBLE_EQ(statistics.GetRMSE(GroupEnum::IncisorsAndCanines), std::sqrt(2.5));
  EXPECT_DOUBLE_EQ(statistics.GetMaximum(GroupEnum::IncisorsAndCanines), 2.0);
  EXPECT_DOUBLE_EQ(statistics.GetMean(GroupEnum::Premolars), 3.0);
  EXPECT_DOUBLE_EQ(statistics.GetStandardDeviation(GroupEnum::Molars), 0.0);
}

TEST(LandmarkErrorStatistics, PoolsLandmarksNotCases)
{
  LandmarkErrorStatistics oneLandmark;
  oneLandmark.Add(GroupEnum::Molars, 8.0);
  LandmarkErrorStatistics threeLandmarks;
  for (int i = 0; i < 3; ++i)
  {
    threeLandmarks.Add(GroupEnum::Premolars, 4.0);
  }
  LandmarkErrorStatistics cohort;
  cohort.Add(oneLandmark);
  cohort.Add(threeLandmarks);
  cohort.Add(LandmarkErrorStatistics());
  // (8 + 3 * 4) / 4, not the mean of 8 and 4.
  EXPECT_DOUBLE_EQ(cohort.GetMean(), 5.0);
  EXPECT_DOUBLE_EQ(cohort.GetStandardDeviation(), std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(cohort.GetMaximum(), 8.0);
  EXPECT_EQ(cohort.GetCount(GroupEnum::Premolars), 3u);
}

TEST(LandmarkErrorStatistics, PoolingIsTheSameAsAddingOneByOne)
{
  itk::ReproducibleRandom random(7);
  LandmarkErrorStatistics all;
  LandmarkErrorStatistics pooled;
  std::vector<double>     errors;
  for (int part = 0; part < 34; ++part)
  {
    LandmarkErrorStatistics one;
    for (std::uint32_t i = random.Integer(16); i > 0; --i)
    {
      const double error = 20.0 * random.Uniform();
      const auto   group = static_cast<GroupEnum>(random.Integer(3));
      all.Add(group, error, 0.25 * error);
      one.Add(group, error, 0.25 * error);
      errors.push_back(error);
    }
    pooled.Add(one);
  }
  double mean = 0.0;
  for (const double error : errors)
  {
    mean += error / static_cast<double>(errors.size());
  }
  double variance = 0.0;
  for (const double error : errors)
  {
    variance += (error - mean) * (error - mean) / static_cast<double>(errors.size());
  }
  for (const LandmarkErrorStatistics & statistics : { all, pooled })
  {
    // Some hundred additions of numbers near 10.
    EXPECT_NEAR(statistics.GetMean(), mean, 1e-12);
    EXPECT_NEAR(statistics.GetStandardDeviation(), std::sqrt(variance), 1e-12);
    EXPECT_NEAR(statistics.GetMeanInMillimetres(), 0.25 * mean, 1e-12);
    EXPECT_NEAR(std::pow(statistics.GetRMSE(), 2),
                std::pow(statistics.GetMean(), 2) + std::pow(statistics.GetStandardDeviation(), 2),
                1e-12 * std::pow(statistics.GetRMSE(), 2));
  }
  EXPECT_EQ(all.GetSuccessDetectionRate(2.0), pooled.GetSuccessDetectionRate(2.0));
}

TEST(LandmarkErrorStatistics, StandardDeviationSurvivesALargeMean)
{
  // A sum of squares would lose all digits here.
  LandmarkErrorStatistics statistics;
  for (const double error : { 1e9, 1e9 + 1.0, 1e9 + 2.0 })
  {
    statistics.Add(GroupEnum::Molars, error);
  }
  EXPECT_NEAR(statistics.GetStandardDeviation(), std::sqrt(2.0 / 3.0), 1e-6);
}

TEST(LandmarkErrorStatistics, SuccessRateCountsTheThresholdItself)
{
  LandmarkErrorStatistics statistics;
  for (const double millimetres : { 1.0, 2.0, 2.1, 2.5, 3.0, 3.5, 4.0, 4.0001 })
  {
    statistics.Add(GroupEnum::Premolars, 4.0 * millimetres, millimetres);
  }
  EXPECT_DOUBLE_EQ(statistics.GetSuccessDetectionRate(2.0), 2.0 / 8.0);
  EXPECT_DOUBLE_EQ(statistics.GetSuccessDetectionRate(2.5), 4.0 / 8.0);
  EXPECT_DOUBLE_EQ(statistics.GetSuccessDetectionRate(3.0), 5.0 / 8.0);
  EXPECT_DOUBLE_EQ(statistics.GetSuccessDetectionRate(4.0), 7.0 / 8.0);
  EXPECT_NE(MessageOfCall([&]() { statistics.GetSuccessDetectionRate(1.0); }).find("not at 1 mm"), std::string::npos);
}

TEST(LandmarkErrorStatistics, MillimetresAreOnlyThoseGiven)
{
  LandmarkErrorStatistics statistics;
  statistics.Add(GroupEnum::Molars, 10.0);
  EXPECT_EQ(statistics.GetCountInMillimetres(), 0u);
  EXPECT_NE(MessageOfCall([&]() { statistics.GetSuccessDetectionRate(2.0); }).find("no pixel spacing"),
            std::string::npos);
  EXPECT_NE(MessageOfCall([&]() { statistics.GetMeanInMillimetres(); }).find("no pixel spacing"), std::string::npos);
  statistics.Add(GroupEnum::Molars, 8.0, 1.0);
  statistics.Add(GroupEnum::Molars, 8.0, 3.0);
  EXPECT_EQ(statistics.GetCount(), 3u);
  EXPECT_EQ(statistics.GetCountInMillimetres(), 2u);
  EXPECT_DOUBLE_EQ(statistics.GetMeanInMillimetres(), 2.0);
  EXPECT_DOUBLE_EQ(statistics.GetStandardDeviationInMillimetres(), 1.0);
  EXPECT_DOUBLE_EQ(statistics.GetRMSEInMillimetres(), std::sqrt(5.0));
  EXPECT_DOUBLE_EQ(statistics.GetSuccessDetectionRate(2.0), 0.5);
}

TEST(LandmarkErrorStatistics, WhatIsAbsentIsAnErrorNotZero)
{
  LandmarkErrorStatistics statistics;
  for (const auto & figure : std::vector<std::function<double()>>{ [&]() { return statistics.GetMean(); },
                                                                   [&]() { return statistics.GetRMSE(); },
                                                                   [&]() { return statistics.GetStandardDeviation(); },
                                                                   [&]() { return statistics.GetMaximum(); } })
  {
    EXPECT_THROW(figure(), itk::ExceptionObject);
  }
  statistics.Add(GroupEnum::Molars, 1.0);
  EXPECT_EQ(statistics.GetCount(GroupEnum::Premolars), 0u);
  EXPECT_NE(MessageOfCall([&]() { statistics.GetMean(GroupEnum::Premolars); }).find("Ask for the count first"),
            std::string::npos);
  EXPECT_THROW(statistics.GetRMSE(GroupEnum::Premolars), itk::ExceptionObject);
  EXPECT_THROW(statistics.GetStandardDeviation(GroupEnum::Premolars), itk::ExceptionObject);
  EXPECT_THROW(statistics.GetMaximum(GroupEnum::Premolars), itk::ExceptionObject);
}

TEST(LandmarkErrorStatistics, RefusesWhatIsNoDistanceAndStaysAsItWas)
{
  LandmarkErrorStatistics statistics;
  for (const double bad : { -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    EXPECT_THROW(statistics.Add(GroupEnum::Molars, bad), itk::ExceptionObject);
    EXPECT_THROW(statistics.Add(GroupEnum::Molars, bad, 1.0), itk::ExceptionObject);
    EXPECT_THROW(statistics.Add(GroupEnum::Molars, 1.0, bad), itk::ExceptionObject);
  }
  EXPECT_EQ(statistics, LandmarkErrorStatistics());
}

TEST(LandmarkErrorStatistics, PrintsWhatIsThere)
{
  LandmarkErrorStatistics statistics;
  std::ostringstream      empty;
  empty << statistics;
  EXPECT_EQ(empty.str(), "0 landmarks");
  statistics.Add(GroupEnum::Molars, 2.0);
  std::ostringstream text;
  text << statistics;
  EXPECT_EQ(text.str(), "1 landmarks, mean 2 px, RMSE 2 px, std 0 px; molars 2 px");
}

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
#include "itkCoherentPointDriftContourRegistrationMethod.h"

#include "itkMath.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace itk
{
namespace
{
using Complex = std::complex<double>;

std::vector<Complex>
ToComplex(const std::vector<double> & points)
{
  std::vector<Complex> result;
  for (std::size_t i = 0; i + 1 < points.size(); i += 2)
  {
    result.emplace_back(points[i], points[i + 1]);
  }
  return result;
}
} // namespace

ContourSimilarity
CoherentPointDriftContourRegistrationMethod::RegisterContours(const PointsType &        fixed,
                                                              const PointsType &        moving,
                                                              const ContourSimilarity & start)
{
  const std::vector<Complex> x = ToComplex(fixed.points);
  const std::vector<Complex> y = ToComplex(moving.points);
  const double               samples = fixed.sumOfWeights;
  const auto                 centroids = static_cast<double>(y.size());
  const bool                 rigid = this->GetMotion() == MotionEnum::Rigid;

  ContourSimilarity    similarity = start;
  std::vector<Complex> moved(y.size());
  const auto           move = [&]() {
    for (std::size_t m = 0; m < y.size(); ++m)
    {
      moved[m] = std::polar(similarity.scale, similarity.angle) * y[m] + Complex(similarity.tx, similarity.ty);
    }
  };
  move();
  double variance = 0.0;
  for (std::size_t n = 0; n < x.size(); ++n)
  {
    for (const Complex & point : moved)
    {
      variance += fixed.weights[n] * std::norm(x[n] - point);
    }
  }
  variance /= 2.0 * samples * centroids;
  // The uniform background has the density 1 / N in coordinates of unit spread (section 4 of the article).
  Complex xMean(0.0, 0.0);
  double  spread = 0.0;
  for (std::size_t n = 0; n < x.size(); ++n)
  {
    xMean += fixed.weights[n] / samples * x[n];
  }
  for (std::size_t n = 0; n < x.size(); ++n)
  {
    spread += fixed.weights[n] / samples * std::norm(x[n] - xMean);
  }
  // Components narrower than a thousandth of a pixel say nothing more, and divide by nothing.
  constexpr double    smallestVariance = 1e-6;
  std::vector<double> responsibilities(y.size());
  std::vector<double> perCentroid(y.size());
  std::vector<double> exponents(y.size());

  this->StartLevel(0, similarity);
  for (unsigned int iteration = 0;; ++iteration)
  {
    variance = std::max(variance, smallestVariance);
    const double background = m_OutlierWeight > 0.0 ? 2.0 * Math::pi * variance / spread * m_OutlierWeight /
                                                        (1.0 - m_OutlierWeight) * centroids / samples
                                                    : 0.0;
    std::fill(perCentroid.begin(), perCentroid.end(), 0.0);
    Complex xSum(0.0, 0.0);
    double  total = 0.0;
    double  xSquares = 0.0;
    Complex cross(0.0, 0.0);
    for (std::size_t n = 0; n < x.size(); ++n)
    {
      double smallest = NumericTraits<double>::max();
      for (std::size_t m = 0; m < y.size(); ++m)
      {
        exponents[m] = std::norm(x[n] - moved[m]) / (2.0 * variance);
        smallest = std::min(smallest, exponents[m]);
      }
      // Without a background the largest is taken as 1, so that a far sample keeps its vote.
      const double shift = background > 0.0 ? 0.0 : smallest;
      double       sum = background;
      for (std::size_t m = 0; m < y.size(); ++m)
      {
        // exp(-40) is below the last bit of a sum that holds 1.
        const double value = exponents[m] - shift;
        responsibilities[m] = value < 700.0 && exponents[m] - smallest < 40.0 ? std::exp(-value) : 0.0;
        sum += responsibilities[m];
      }
      if (!(sum > 0.0))
      {
        continue;
      }
      const double factor = fixed.weights[n] / sum;
      Complex      partners(0.0, 0.0);
      double       share = 0.0;
      for (std::size_t m = 0; m < y.size(); ++m)
      {
        if (responsibilities[m] > 0.0)
        {
          const double p = factor * responsibilities[m];
          perCentroid[m] += p;
          share += p;
          partners += p * y[m];
        }
      }
      total += share;
      xSum += share * x[n];
      xSquares += share * std::norm(x[n]);
      cross += std::conj(partners) * x[n];
    }
    if (!(total > 1e-9 * samples))
    {
      this->SetStopConditionDescription("Every point was taken for an outlier.");
      return similarity;
    }
    Complex ySum(0.0, 0.0);
    double  ySquares = 0.0;
    for (std::size_t m = 0; m < y.size(); ++m)
    {
      ySum += perCentroid[m] * y[m];
      ySquares += perCentroid[m] * std::norm(y[m]);
    }
    cross -= std::conj(ySum) * xSum / total;
    xSquares -= std::norm(xSum) / total;
    ySquares -= std::norm(ySum) / total;

    const ContourSimilarity before = similarity;
    if (std::abs(cross) > 0.0 && ySquares > 0.0)
    {
      similarity.angle = std::arg(cross);
      if (!rigid)
      {
        similarity.scale = std::abs(cross) / ySquares;
      }
    }
    if (!(similarity.scale > 1e-6))
    {
      this->SetStopConditionDescription("The scale collapsed.");
      return before;
    }
    const Complex translation = (xSum - std::polar(similarity.scale, similarity.angle) * ySum) / total;
    similarity.tx = translation.real();
    similarity.ty = translation.imag();
    variance = (xSquares + similarity.scale * similarity.scale * ySquares - 2.0 * similarity.scale * std::abs(cross)) /
               (2.0 * total);
    move();

    const double shiftOfPoints = LargestShift(moving, before, similarity);
    if (this->EndStep(iteration,
                      m_MaximumNumberOfIterations,
                      m_Tolerance,
                      std::sqrt(std::max(variance, 0.0)),
                      shiftOfPoints,
                      similarity))
    {
      return similarity;
    }
  }
}

void
CoherentPointDriftContourRegistrationMethod::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "OutlierWeight: " << m_OutlierWeight << std::endl;
  os << indent << "MaximumNumberOfIterations: " << m_MaximumNumberOfIterations << std::endl;
  os << indent << "Tolerance: " << m_Tolerance << std::endl;
}
} // namespace itk

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
#include "itkIterativeClosestPointContourRegistrationMethod.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

namespace itk
{
namespace
{
struct PairType
{
  std::uint32_t fixed;
  std::uint32_t moving;
  double        weight;
  double        squaredDistance;
};
} // namespace

ContourSimilarity
IterativeClosestPointContourRegistrationMethod::RegisterContours(const PointsType &        fixed,
                                                                 const PointsType &        moving,
                                                                 const ContourSimilarity & start)
{
  ContourDistanceIndex fixedIndex;
  ContourDistanceIndex movingIndex;
  fixedIndex.SetPoints(fixed.points.data(), fixed.size());
  movingIndex.SetPoints(moving.points.data(), moving.size());

  ContourSimilarity similarity = start;
  this->StartLevel(0, similarity);
  std::vector<PairType> pairs;
  std::vector<double>   from;
  std::vector<double>   to;
  std::vector<double>   weights;
  for (unsigned int iteration = 0;; ++iteration)
  {
    const auto                 linear = std::polar(similarity.scale, similarity.angle);
    const std::complex<double> shift(similarity.tx, similarity.ty);
    pairs.clear();
    if (m_Direction != DirectionEnum::MovingToFixed)
    {
      for (std::uint32_t i = 0; i < fixed.size(); ++i)
      {
        // A similarity keeps what is nearest: search where the index does not move.
        const auto q = (std::complex<double>(fixed.points[2 * i], fixed.points[2 * i + 1]) - shift) / linear;
        const auto nearest = movingIndex.FindNearest(q.real(), q.imag());
        pairs.push_back({ i,
                          nearest.target,
                          fixed.weights[i] / fixed.sumOfWeights,
                          nearest.squaredDistance * similarity.scale * similarity.scale });
      }
    }
    if (m_Direction != DirectionEnum::FixedToMoving)
    {
      for (std::uint32_t i = 0; i < moving.size(); ++i)
      {
        const auto p = linear * std::complex<double>(moving.points[2 * i], moving.points[2 * i + 1]) + shift;
        const auto nearest = fixedIndex.FindNearest(p.real(), p.imag());
        pairs.push_back({ nearest.target, i, moving.weights[i] / moving.sumOfWeights, nearest.squaredDistance });
      }
    }
    if (m_TrimmedFraction > 0.0)
    {
      const auto keep = std::max<std::size_t>(
        2, static_cast<std::size_t>(std::ceil((1.0 - m_TrimmedFraction) * static_cast<double>(pairs.size()))));
      if (keep < pairs.size())
      {
        std::stable_sort(pairs.begin(), pairs.end(), [](const PairType & a, const PairType & b) {
          return a.squaredDistance < b.squaredDistance;
        });
        pairs.resize(keep);
      }
    }
    from.clear();
    to.clear();
    weights.clear();
    double value = 0.0;
    double sum = 0.0;
    for (const PairType & pair : pairs)
    {
      for (unsigned int d = 0; d < 2; ++d)
      {
        from.push_back(moving.points[2 * pair.moving + d]);
        to.push_back(fixed.points[2 * pair.fixed + d]);
      }
      weights.push_back(pair.weight);
      value += pair.weight * pair.squaredDistance;
      sum += pair.weight;
    }
    const ContourSimilarity next = FitSimilarity(from, to, weights, this->GetMotion(), similarity.scale);
    if (!(next.scale > 1e-6))
    {
      this->SetStopConditionDescription("The scale collapsed: the pairs lie in one point.");
      return similarity;
    }
    const double moved = LargestShift(moving, similarity, next);
    similarity = next;
    if (this->EndStep(iteration, m_MaximumNumberOfIterations, m_Tolerance, value / sum, moved, similarity))
    {
      return similarity;
    }
  }
}

void
IterativeClosestPointContourRegistrationMethod::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Direction: " << m_Direction << std::endl;
  os << indent << "TrimmedFraction: " << m_TrimmedFraction << std::endl;
  os << indent << "MaximumNumberOfIterations: " << m_MaximumNumberOfIterations << std::endl;
  os << indent << "Tolerance: " << m_Tolerance << std::endl;
}
} // namespace itk

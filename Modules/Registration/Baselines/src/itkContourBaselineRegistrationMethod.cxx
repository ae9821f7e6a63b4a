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
#include "itkContourBaselineRegistrationMethod.h"

#include "itkMakeContourArrays.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <ostream>
#include <sstream>

namespace itk
{
std::ostream &
operator<<(std::ostream & os, ContourBaselineEnums::Motion motion)
{
  return os << (motion == ContourBaselineEnums::Motion::Rigid ? "Rigid" : "Similarity");
}

auto
ContourBaselineRegistrationMethod::MakePoints(const ContourType & contour) -> PointsType
{
  const ContourArrays arrays = MakeContourArrays(contour);
  PointsType          points;
  for (std::size_t i = 0; i < arrays.GetNumberOfPoints(); ++i)
  {
    const double weight = arrays.weights.empty() ? 1.0 : arrays.weights[i];
    if (weight > 0.0)
    {
      points.points.push_back(arrays.points[2 * i]);
      points.points.push_back(arrays.points[2 * i + 1]);
      points.weights.push_back(weight);
      points.sumOfWeights += weight;
    }
  }
  return points;
}

ContourSimilarity
ContourBaselineRegistrationMethod::FindStart() const
{
  // Checks both contours, whatever the motion.
  const ContourSimilarity start = Superclass::FindStart();
  if (m_Motion == MotionEnum::Similarity || this->GetInitialTransform() != nullptr)
  {
    return start;
  }
  const PointsType sides[2] = { MakePoints(*this->GetFixedContour()), MakePoints(*this->GetMovingContour()) };
  double           centroids[2][2] = { { 0.0, 0.0 }, { 0.0, 0.0 } };
  for (unsigned int side = 0; side < 2; ++side)
  {
    const PointsType & points = sides[side];
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      for (unsigned int d = 0; d < 2; ++d)
      {
        centroids[side][d] += points.weights[i] / points.sumOfWeights * points.points[2 * i + d];
      }
    }
  }
  return { 1.0, 0.0, centroids[0][0] - centroids[1][0], centroids[0][1] - centroids[1][1] };
}

void
ContourBaselineRegistrationMethod::GenerateData()
{
  const ContourSimilarity start = this->StartRun();
  this->SetResult(
    this->RegisterContours(MakePoints(*this->GetFixedContour()), MakePoints(*this->GetMovingContour()), start));
}

void
ContourBaselineRegistrationMethod::StartLevel(unsigned int level, const ContourSimilarity & similarity)
{
  this->SetIteration(level, 0, this->GetMetricValue(), similarity);
  this->InvokeEvent(MultiResolutionIterationEvent());
  this->CheckAbort();
}

void
ContourBaselineRegistrationMethod::ReportIteration(std::size_t               iteration,
                                                   double                    value,
                                                   const ContourSimilarity & similarity,
                                                   float                     progress)
{
  this->SetIteration(this->GetCurrentLevel(), iteration, value, similarity);
  this->InvokeEvent(IterationEvent());
  this->UpdateProgress(progress);
  this->CheckAbort();
}

bool
ContourBaselineRegistrationMethod::EndStep(unsigned int              iteration,
                                           unsigned int              maximum,
                                           double                    tolerance,
                                           double                    value,
                                           double                    moved,
                                           const ContourSimilarity & similarity)
{
  this->ReportIteration(
    iteration + 1, value, similarity, static_cast<float>(iteration + 1) / static_cast<float>(maximum));
  std::ostringstream text;
  if (moved <= tolerance)
  {
    text << "Converged after " << iteration + 1 << " iterations: no point moved by more than " << tolerance << " px.";
  }
  else if (iteration + 1 >= maximum)
  {
    text << "Maximum number of iterations (" << maximum << ") reached.";
  }
  else
  {
    return false;
  }
  this->SetStopConditionDescription(text.str());
  return true;
}

ContourSimilarity
ContourBaselineRegistrationMethod::FitSimilarity(const std::vector<double> & from,
                                                 const std::vector<double> & to,
                                                 const std::vector<double> & weights,
                                                 MotionEnum                  motion,
                                                 double                      scale)
{
  using Complex = std::complex<double>;
  Complex fromMean(0.0, 0.0);
  Complex toMean(0.0, 0.0);
  double  sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    fromMean += weights[i] * Complex(from[2 * i], from[2 * i + 1]);
    toMean += weights[i] * Complex(to[2 * i], to[2 * i + 1]);
    sum += weights[i];
  }
  fromMean /= sum;
  toMean /= sum;
  Complex cross(0.0, 0.0);
  double  spread = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    const Complex q = Complex(from[2 * i], from[2 * i + 1]) - fromMean;
    const Complex p = Complex(to[2 * i], to[2 * i + 1]) - toMean;
    cross += weights[i] * std::conj(q) * p;
    spread += weights[i] * std::norm(q);
  }
  ContourSimilarity fit;
  fit.scale = scale;
  // Points that all correspond to one leave rotation and scale undetermined: keep them.
  if (std::abs(cross) > 0.0 && spread > 0.0)
  {
    fit.angle = std::arg(cross);
    if (motion == MotionEnum::Similarity)
    {
      fit.scale = std::abs(cross) / spread;
    }
  }
  const Complex translation = toMean - std::polar(fit.scale, fit.angle) * fromMean;
  fit.tx = translation.real();
  fit.ty = translation.imag();
  return fit;
}

double
ContourBaselineRegistrationMethod::LargestShift(const PointsType &        points,
                                                const ContourSimilarity & a,
                                                const ContourSimilarity & b)
{
  double low[2] = { points.points[0], points.points[1] };
  double high[2] = { points.points[0], points.points[1] };
  for (std::size_t i = 0; i < points.points.size(); ++i)
  {
    low[i % 2] = std::min(low[i % 2], points.points[i]);
    high[i % 2] = std::max(high[i % 2], points.points[i]);
  }
  double largest = 0.0;
  for (unsigned int corner = 0; corner < 4; ++corner)
  {
    const std::complex<double> q((corner & 1u) != 0 ? high[0] : low[0], (corner & 2u) != 0 ? high[1] : low[1]);
    const auto                 difference = (std::polar(a.scale, a.angle) - std::polar(b.scale, b.angle)) * q +
                            std::complex<double>(a.tx - b.tx, a.ty - b.ty);
    largest = std::max(largest, std::abs(difference));
  }
  return largest;
}

void
ContourBaselineRegistrationMethod::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Motion: " << m_Motion << std::endl;
}
} // namespace itk

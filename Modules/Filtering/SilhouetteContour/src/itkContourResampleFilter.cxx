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
#include "itkContourResampleFilter.h"

#include "itkContourResampling.h"

#include <cmath>
#include <stdexcept>

namespace itk
{
void
ContourResampleFilter::VerifyPreconditions() ITKv5_CONST
{
  if (this->GetInput() == nullptr)
  {
    itkExceptionMacro("No contour to resample: call SetInput() with a DentalContour.");
  }
  if (m_NumberOfPoints == 0 && !(m_Spacing > 0.0 && std::isfinite(m_Spacing)))
  {
    itkExceptionMacro("The spacing " << m_Spacing
                                     << " px is not positive: call SetSpacing() with one, or SetNumberOfPoints().");
  }
  Superclass::VerifyPreconditions();
}

void
ContourResampleFilter::GenerateData()
{
  DentalContour * const output = this->GetOutput();
  output->Initialize();
  // Without it every Update() would execute again.
  output->SetBufferedRegion(0);
  const auto polylines = this->GetInput()->GetPolylines();

  std::vector<std::vector<std::array<double, 2>>> points;
  std::vector<double>                             lengths;
  std::vector<std::size_t>                        counts;
  for (const auto & polyline : polylines)
  {
    points.emplace_back();
    for (const auto & point : polyline.points)
    {
      points.back().push_back({ point[0], point[1] });
    }
    lengths.push_back(ComputePolylineLength(points.back(), polyline.closed));
    std::size_t count = 1;
    if (lengths.back() > 0.0)
    {
      count = polyline.closed ? 3 : 2;
      if (m_NumberOfPoints == 0)
      {
        const auto intervals = static_cast<std::size_t>(std::floor(lengths.back() / m_Spacing + 0.5));
        count = std::max(count, intervals + (polyline.closed ? 0 : 1));
      }
    }
    counts.push_back(count);
  }
  if (m_NumberOfPoints > 0)
  {
    try
    {
      counts = DistributeContourPoints(lengths, counts, m_NumberOfPoints);
    }
    catch (const std::invalid_argument & error)
    {
      itkExceptionMacro(<< error.what() << " Call SetNumberOfPoints() with more.");
    }
  }

  for (std::size_t l = 0; l < polylines.size(); ++l)
  {
    const auto &                polyline = polylines[l];
    DentalContour::PolylineType resampled;
    if (!(lengths[l] > 0.0))
    {
      AppendPoint(polyline, 0, resampled);
      output->AddPolyline(resampled);
      continue;
    }
    resampled.closed = polyline.closed;
    for (const ContourPosition & position : ResamplePolyline(points[l], polyline.closed, counts[l]))
    {
      const std::size_t from = position.segment;
      const std::size_t to = from + 1 < points[l].size() ? from + 1 : 0;
      // Between two neighbours a silhouette may leap from one tooth to another: a mean of both is on neither.
      AppendPoint(polyline, position.share < 0.5 ? from : to, resampled);
      for (unsigned int d = 0; d < 2; ++d)
      {
        resampled.points.back()[d] = points[l][from][d] + position.share * (points[l][to][d] - points[l][from][d]);
      }
      if (!polyline.weights.empty())
      {
        resampled.weights.back() =
          (1.0 - position.share) * polyline.weights[from] + position.share * polyline.weights[to];
      }
      if (!polyline.sigmas.empty())
      {
        // 0 is no number to be between: what is drawn from or to a point of unknown error is of unknown error.
        const bool known = polyline.sigmas[from] > 0.0 && polyline.sigmas[to] > 0.0;
        resampled.sigmas.back() =
          known ? (1.0 - position.share) * polyline.sigmas[from] + position.share * polyline.sigmas[to] : 0.0;
      }
    }
    output->AddPolyline(resampled);
  }
}

void
ContourResampleFilter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfPoints: " << m_NumberOfPoints << std::endl;
  os << indent << "Spacing: " << m_Spacing << std::endl;
}
} // namespace itk
